"""What the pool games share: the break, the turn with the cue ball in hand, three fouls, a new rack."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar, TypeVar, Unpack

from ....physics.values import GONE, Layout
from ..base import Rules
from ..notes import Note
from ..report import Report
from ..ruling import Asked, CallKind, Declared, Ruling, State
from ..scores import changed
from ..spotting import KITCHEN, Where, spot_balls

S = TypeVar("S", bound=State)

# How many balls an opening break has to drive to a rail where none is pocketed.
DRIVEN = 4


@dataclass(frozen=True, slots=True)
class GroupsState(State):
    """A frame in which each player has a group of balls: `groups` are the players', "" while the table is open."""

    groups: tuple[str, ...] = ("", "")

    @property
    def open(self) -> bool:
        """Whether no player has a group yet."""
        return not self.groups[0]


class PoolRules(Rules[S]):
    """Rules in which one cue ball is played and broken from behind the head string.

    `call` is what has to be called after the break, `may` what else may be said.
    """

    call: ClassVar[CallKind] = ""
    may: ClassVar[tuple[Declared, ...]] = ()

    def on(self, state: S, layout: Layout, player: int) -> tuple[str, ...]:
        """The balls that a player may hit first."""
        return self.on_table(layout)

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        state: S = self.state_type(seed=seed)  # type: ignore[assignment]
        return self.broken_by(breaker, state)

    def broken_by(self, player: int, state: S) -> Ruling:
        """A new rack, which a player breaks."""
        new: S = self.state_type(seed=state.seed, racks=state.racks, breaker=player)  # type: ignore[assignment]
        new, layout = self.racked(new)
        return self.ruled(self.to_play(new, layout, player, KITCHEN, on=self.on(new, layout, player)), layout)

    def stalemate(self, state: S) -> Ruling:
        """What follows when both players see no progress (1.13): who broke the rack breaks again."""
        return self.broken_by(state.breaker, state)

    def next(self, state: S, layout: Layout, player: int, where: Where = "", **more: Unpack[Asked]) -> S:
        """The state in which a player shoots after the break.

        With the cue ball in hand behind the head string and every ball on behind it too, the one nearest to
        the line may be had spotted (1.6).
        """
        on, line = self.on(state, layout, player), self.table.furniture.head_string
        behind = where == KITCHEN and line is not None and all(layout[ball].x < line for ball in on)
        options = ("spot",) if behind and on else ()
        asked: Asked = {"on": on, "call": self.call, "may": self.may, "options": options}
        asked.update(more)
        return self.to_play(state, layout, player, where, **asked)

    def picked(self, state: S, layout: Layout, key: str) -> Ruling:
        chooser = state.ask.player
        if key == "re-rack":
            return self.broken_by(chooser, state)
        if key == "opponent-breaks":
            return self.broken_by(self.other(chooser), state)
        if key == "spot":
            nearest = max(state.ask.on, key=lambda ball: (layout[ball].x, ball))
            layout, spotted = spot_balls(self.table, layout, (nearest,))
            return self.ruled(self.next(state, layout, chooser, state.ask.where), layout, spotted=spotted)
        player = self.other(chooser) if key == "pass" else chooser
        return self.ruled(self.next(state, layout, player, KITCHEN if key == "kitchen" else ""), layout)

    def counted(self, state: S, player: int, foul: bool) -> S:
        """The state with a player's fouls in a row counted: a legal shot ends the row (3.13)."""
        return replace(state, fouls=changed(state.fouls, player, state.fouls[player] + 1 if foul else 0))

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """Where a ball has to be called, only that one, but for the break; none where the balls may be racked again."""
        found = super().pots(player, report, ruling)
        again = not ruling.state.shots or "re-rack" in ruling.ask.options
        if again or not self.call or ruling.state.shots == 1:
            return () if again else found
        return tuple(ball for ball in found if ball == report.called())

    def second(self, state: S, player: int) -> tuple[Note, ...]:
        """3.13: who has made two fouls in a row is told, where a third is punished."""
        told = state.fouls[player] == 2 and getattr(self.options, "three_foul", "no") == "yes"
        return (Note("second-foul", player),) if told else ()


G = TypeVar("G", bound=GroupsState)


class GroupsRules(PoolRules[G]):
    """Rules in which each player clears a group and then pots one ball more."""

    def to_pot(self, state: G, layout: Layout, player: int) -> tuple[str, ...]:
        """The player's group, or that of which fewer are left while the table is open, and the ball of no group."""
        standing, members = self.on_table(layout), self.table.furniture.groups
        left = {name: tuple(ball for ball in standing if ball in members[name]) for name in self.groups}
        mine = min(left.values(), key=len) if state.open else left[state.groups[player]]
        return (*mine, *(ball for ball in standing if not any(ball in group for group in left.values())))


def driven(report: Report) -> int:
    """How many object balls were driven to a rail; falling or leaving counts (2.7)."""
    return sum(ball != report.cue for ball in report.driven)


def gone(layout: Layout, ball: str) -> bool:
    """Whether a ball is no longer on the table: it fell, or left it."""
    return layout[ball].phase in GONE
