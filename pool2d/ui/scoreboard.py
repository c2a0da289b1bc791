"""The players of a match in the upper bar: names, frames, points, groups, and whose turn it is."""

from __future__ import annotations

import pygame

from ..game.match import Match, Moment
from . import text, theme
from .hud import Screen
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
    rest = []
    groups = getattr(state, "groups", ())
    if groups and groups[player]:
        rest.append(say_or(f"group.{groups[player]}", groups[player]))
    if match.setup.race > 1:
        rest.append(say("scoreboard.frames", won=moment.tallies[player].frames, race=match.setup.race))
    if moment.tallies[player].run > 1 and match.rules.scored:
        rest.append(say("scoreboard.run", run=moment.tallies[player].run))
    if state.fouls[player] > 1:
        rest.append(say("scoreboard.fouls", count=state.fouls[player]))
    parts.append(("   ".join(rest), screen.small, theme.QUIET))
    return parts
