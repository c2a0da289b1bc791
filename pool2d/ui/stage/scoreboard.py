"""The players in the upper bar: names, frames, points, groups, and whose turn it is."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from ...draw import text, theme
from ...game.match import Match, Moment
from ..screen import Screen
from ..wording.shot_text import place_name
from ..wording.words import Words

# Words, their size and colour.
Part = tuple[str, int, theme.Color]


def draw(surface: pygame.Surface, words: Words, screen: Screen, match: Match, moment: Moment) -> None:
    """Draw the first player on the left and the second on the right, as they stood at a moment."""
    unit = screen.unit
    room = screen.tray.left - 4 * unit
    for player in range(len(match.names)):
        turn = _has_turn(moment, player)
        if turn:
            mark = (screen.width - unit if player else 0, 0, unit, screen.top.height)
            pygame.draw.rect(surface, theme.ACCENT, mark)
        edge = screen.width - 2 * unit if player else 2 * unit
        _line(surface, screen, _parts(words, match, moment, player, turn, screen), (edge, -1 if player else 1), room)


def draw_beside(
    surface: pygame.Surface, words: Words, screen: Screen, match: Match, moment: Moment, shooter: int
) -> None:  # fmt: skip
    """Draw all players side by side to the right of the tray; who played the shot stands out."""
    unit, players = screen.unit, len(match.names)
    room = (screen.width - screen.tray.right - 3 * unit) // players
    for player in range(players):
        edge = screen.width - 2 * unit - (players - 1 - player) * room
        parts = _parts(words, match, moment, player, player == shooter, screen)
        _line(surface, screen, parts, (edge, -1), room - 2 * unit)


def _has_turn(moment: Moment, player: int) -> bool:
    return moment.ruling.ask.player == player and not moment.state.over


def _line(
    surface: pygame.Surface, screen: Screen, parts: Sequence[Part], start: tuple[int, int], room: int
) -> None:  # fmt: skip
    """Draw a player's parts from an x (to the right for side 1, to the left for -1), `room` pixels wide at most."""
    edge, side = start
    x = edge
    for words, size, color in parts:
        shown = text.fitted(words, size, room - abs(x - edge))
        text.draw(surface, shown, size, color, (x, screen.top.centery), (0.0 if side > 0 else 1.0, 0.5))
        x += side * (text.font(size).size(shown)[0] + 2 * screen.unit)


def _parts(words: Words, match: Match, moment: Moment, player: int, turn: bool, screen: Screen) -> list[Part]:
    """A player's texts, from the edge inward: points, name, details; the name is lit while it is their turn."""
    state = moment.state
    parts: list[Part] = []
    if match.rules.scored:
        parts.append((str(state.scores[player]), screen.large, theme.TEXT))
    parts.append((match.names[player], screen.small, theme.ACCENT if turn else theme.TEXT))
    parts.append(("   ".join(_details(words, match, moment, player, turn)), screen.small, theme.QUIET))
    return parts


def _details(words: Words, match: Match, moment: Moment, player: int, turn: bool) -> list[str]:
    """A player's details: group, frames, innings, run and so on, as far as the game's state has them."""
    state, tally = moment.state, moment.tallies[player]
    details = []
    if group := getattr(state, "groups", ("", ""))[player]:
        details.append(words.say_or(f"group.{group}", group))
    if pocket := getattr(state, "pockets", ("", ""))[player]:
        details.append(place_name(words, pocket))
    if match.setup.race > 1:
        details.append(words.say("scoreboard.frames", won=tally.frames, race=match.setup.race))
    if innings := getattr(state, "innings", (0, 0))[player]:
        details.append(words.say("scoreboard.innings", count=innings))
    if match.rules.scored and tally.run > 1:
        details.append(words.say(f"scoreboard.{match.rules.series}", points=tally.run))
    if turn and (left := getattr(state, "left", 0)):
        details.append(words.say("scoreboard.left", points=left))
    if state.fouls[player] > 1:
        details.append(words.say("scoreboard.fouls", count=state.fouls[player]))
    return details
