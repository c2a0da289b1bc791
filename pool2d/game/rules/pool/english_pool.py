"""What the two games of English pool share, English eight-ball and blackball: reds, yellows and the black."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import TypeVar

from ....physics.values import POCKETED, Layout
from ..lost import balls_off, cue_ball_off
from ..notes import Note
from ..report import BALL, Report
from ..ruling import Ruling
from ..scores import changed
from .pool import GroupsRules, GroupsState

BLACK = "black"
RED, YELLOW = "red", "yellow"
COLORS = (RED, YELLOW)

S = TypeVar("S", bound=GroupsState)


class EnglishPool(GroupsRules[S]):
    """Rules in which each player clears a colour and then pots the black; the kitchen is called baulk."""

    racks = ("eight-ball",)
    groups = COLORS

    def balls_of(self, color: str) -> tuple[str, ...]:
        """The balls of a colour, on the table or not."""
        return self.table.furniture.groups[color]

    def colors_potted(self, report: Report) -> set[str]:
        """The colours of which a ball fell."""
        return {color for color in COLORS if set(report.potted) & set(self.balls_of(color))}

    def to_clear(self, layout: Layout, colors: Collection[str]) -> tuple[str, ...]:
        """The balls of these colours that are on the table, and the black where there are none."""
        standing = self.on_table(layout)
        left = tuple(ball for color in colors for ball in self.balls_of(color) if ball in standing)
        return left or tuple(ball for ball in standing if ball == BLACK)

    def decided(self, state: S, player: int, color: str) -> tuple[S, Note]:
        """A player gets a colour, and the opponent the other, for the rest of the frame."""
        other = YELLOW if color == RED else RED
        return replace(state, groups=changed((other, other), player, color)), Note(f"group.{color}", player)

    def to_baulk(self, layout: Layout) -> Layout:
        """The layout with the cue ball taken off the table, to be played from baulk."""
        return layout.put(layout[self.table.furniture.cue].still()._replace(phase=POCKETED))

    def fouls_lost(self, report: Report) -> Iterator[Note]:
        """The fouls by balls that are gone: the cue ball from the table, others off it."""
        if report.scratch:
            yield Note("foul.scratch")
        yield from cue_ball_off(report)
        yield from balls_off(report)

    def fouls_hit(self, report: Report, on: Collection[str]) -> Iterator[Note]:
        """The fouls by what was hit: a ball on first, and then a ball potted or any driven to a cushion.

        The latter is not asked of who could hit no ball on (`snookered`). To play away from a touching ball that is on
        is to have hit it.
        """
        touched = bool(set(report.touching) & set(on))
        if not report.first and not touched:
            yield Note("foul.no-hit")
        elif not touched and not set(report.first) & set(on):
            yield Note("foul.wrong-ball", ball=report.first[0])
        elif not self._driven(report, touched) and not self.snookered(report, on):
            yield Note("foul.no-rail")

    def fouls_pushed(self, report: Report) -> Iterator[Note]:
        """The foul of a tip that stays on the cue ball, or strikes it twice."""
        if report.pressed or any(fault in ("push", "double-hit") for fault in report.stroke):
            yield Note("foul.push")
        elif "second-hit" in report.stroke:
            yield Note("foul.second-hit")

    def fouls_jumped(self, report: Report) -> Iterator[Note]:
        """The foul of a cue ball that jumps over any part of a ball before it has met one."""
        if report.over:
            yield Note("foul.jump", ball=report.over[0])

    def _driven(self, report: Report, touched: bool) -> bool:
        """Whether a ball fell, left the table or met a cushion once a ball had been played."""
        after = report.contacts if touched else report.after
        return any(contact.kind != BALL for contact in after)

    def snookered(self, report: Report, on: Collection[str]) -> bool:
        """Whether no part of a ball on could be hit in a straight line before the shot."""
        raise NotImplementedError

    def black_potted(self, state: S, layout: Layout, fouls: tuple[Note, ...], due: bool) -> Ruling:
        """The black has fallen: it wins where it was `due` and there was no foul, and loses else."""
        player = state.ask.player
        if due and not fouls:
            return self.ruled(self.ended(state, player), layout)
        reason = "loss.black-foul" if due else "loss.black-early"
        return self.ruled(self.ended(state, self.other(player)), layout, Note(reason, player), fouls=fouls)

    def next_note(self, state: S) -> Note:
        note = super().next_note(state)
        return replace(note, key="in-hand.baulk") if note.key == "in-hand.kitchen" else note
