"""The players of a match in the upper bar: names, frames, points, groups, and whose turn it is."""

from __future__ import annotations

import pygame

from ..game.match import Match, Moment
from . import text, theme
from .hud import Screen
from .telling import place_name
from .words import say, say_or


def draw(surface: pygame.Surface, screen: Screen, match: Match, moment: Moment) -> None:
    """Draw the first player on the left and the second on the right, as they stood at a moment."""
    unit, y = screen.unit, screen.top.centery
    for player in range(len(match.names)):
        turn = moment.ruling.ask.who == player and not moment.state.over
        side = -1 if player else 1
        edge = screen.width - 2 * unit if player else 2 * unit
        anchor = (1.0 if player else 0.0, 0.5)
        if turn:
            pygame.draw.rect(surface, theme.ACCENT, (screen.width - unit if player else 0, 0, unit, screen.top.height))
        x = edge
        for words, size, color in _parts(match, moment, player, turn, screen):
            shown = text.fitted(words, size, screen.tray.left - 2 * unit - abs(x - edge))
            text.draw(surface, shown, size, color, (x, y), anchor)
            x += side * (text.font(size).size(shown)[0] + 2 * unit)


def _parts(match: Match, moment: Moment, player: int, turn: bool, screen: Screen) -> list[tuple[str, int, theme.Color]]:
    """What is told of a player, from the edge inward: points, name, the rest."""
    state = moment.state
    parts: list[tuple[str, int, theme.Color]] = []
    if match.rules.scored:
        parts.append((str(state.scores[player]), screen.large, theme.TEXT))
    parts.append((match.names[player], screen.small, theme.ACCENT if turn else theme.TEXT))
    parts.append(("   ".join(_details(match, moment, player, turn)), screen.small, theme.QUIET))
    return parts


def _details(match: Match, moment: Moment, player: int, turn: bool) -> list[str]:
    """What else stands for a player: of the fields that games add to their states those that are there."""
    state, tally = moment.state, moment.tallies[player]
    told = []
    if group := getattr(state, "groups", ("", ""))[player]:
        told.append(say_or(f"group.{group}", group))
    if pocket := getattr(state, "pockets", ("", ""))[player]:
        told.append(place_name(pocket))
    if match.setup.race > 1:
        told.append(say("scoreboard.frames", won=tally.frames, race=match.setup.race))
    if innings := getattr(state, "innings", (0, 0))[player]:
        told.append(say("scoreboard.innings", count=innings))
    if match.rules.scored and tally.run > 1:
        told.append(say("scoreboard.run", run=tally.run))
    if turn and (left := getattr(state, "left", 0)):
        told.append(say("scoreboard.left", points=left))
    if state.fouls[player] > 1:
        told.append(say("scoreboard.fouls", count=state.fouls[player]))
    return told
