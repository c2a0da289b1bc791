"""Korean four-ball, sagu, as it is played by custom: no federation has written rules of it.

Each player strikes a cue ball of their own, at two reds, and may not meet the opponent's.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from ....config.knobs import choice, knob
from ....physics.values import Layout
from ....table.outline import Point
from ..base import YES_NO
from ..notes import Note
from ..report import Report
from ..ruling import Ruling
from ..scores import added, points
from ..spotting import Spotted, has_room, put
from .carom import RED, Carom, CaromOptions, CaromState, balls_met, cushions_before_last

FAR = "red2"
REDS = (RED, FAR)


@dataclass(frozen=True, slots=True)
class FourBallOptions(CaromOptions):
    """What may be set about Korean four-ball; a point here is ten of those that Koreans count in."""

    points: float = knob(15.0, 1.0, 1000.0, "", "points that end the match, or after which its finish is due")
    finish: str = choice("yes", YES_NO, "whether a cannon by three cushions has to follow the last point")


class FourBall(Carom):
    """A cannon on both reds is a point, a foul costs one; who has all points finishes by three cushions."""

    name = "four-ball"
    title = "Korean four-ball"
    rank = 12
    scored = True
    racks = ("four-ball",)
    options_type = FourBallOptions

    @property
    def goal(self) -> float:
        """The finish counts as a point more."""
        return super().goal + (1.0 if self.options.finish == "yes" else 0.0)

    def aim(self, state: CaromState, player: int, *options: str) -> CaromState:
        state = super().aim(state, player, *options)
        return replace(state, ask=replace(state.ask, on=REDS))

    def opened(self, state: CaromState, player: int, spot: str = "right") -> CaromState:
        """The opening stroke goes to the far red."""
        state = replace(self.aim(state, player), opening=True)
        return replace(state, ask=replace(state.ask, on=(FAR,)))

    def set_up(self, state: CaromState, layout: Layout, player: int, spot: str = "right") -> Layout:
        """The reds on the head and the foot spot, the player's ball beside the one, the opponent's behind the other."""
        for ball, place in self._homes(state, player).items():
            layout = put(layout, ball, self.table.furniture.spots[place])
        return layout

    def judge(self, state: CaromState, layout: Layout, report: Report) -> Ruling:
        player = state.ask.player
        found = tuple(self.fouls(state, report))
        if found:
            change = points(player, -1)
            state = replace(added(state, change), shots=state.shots + 1, opening=False)
            return self._inning_over(state, layout, found, change)
        if self.due(state, player) and self.cannon(report) and cushions_before_last(report) < 3:
            state = replace(state, shots=state.shots + 1, opening=False)
            ruling = self._inning_over(state, layout, ())
            return ruling._replace(notes=(Note("no-finish", player), *ruling.notes))
        return super().judge(state, layout, report)

    def due(self, state: CaromState, player: int) -> bool:
        """Whether a player has all points but the finish."""
        return self.options.finish == "yes" and state.scores[player] == self.goal - 1

    def counts(self, report: Report) -> bool:
        return True

    def cannon(self, report: Report) -> bool:
        """Whether the cue ball met both reds."""
        return set(REDS) <= set(balls_met(report))

    def fouls(self, state: CaromState, report: Report) -> Iterator[Note]:
        """What costs a point: to meet the opponent's ball, or no red; to push a ball that touches; balls that leave."""
        yield from self.fouls_off(report)
        met = balls_met(report)
        other = self.ball_of(state, self.other(state.ask.player))
        if other in met:
            yield Note("foul.other-ball", ball=other)
        if not set(REDS) & set(met):
            yield Note("foul.no-red")
        yield from self.fouls_pushed(report)
        if state.opening and self.cannon(report) and met[0] != FAR:
            yield Note("foul.not-far")

    def frozen(
        self, state: CaromState, layout: Layout, player: int, touching: tuple[str, ...], notes: tuple[Note, ...]
    ) -> Ruling:
        """The player has to play away from a ball that touches."""
        return self.ruled(self.aim(state, player), layout, *notes)

    def spot(self, state: CaromState, layout: Layout, player: int, balls: Collection[str]) -> tuple[Layout, Spotted]:
        """Balls that left the table go where they began, or on the next spot that is free."""
        spots, homes = self.table.furniture.spots, self._homes(state, player)
        spotted: list[tuple[str, Point]] = []
        for ball in (ball for ball in homes if ball in balls):
            names = (homes[ball], *homes.values(), "center")
            place = next(spots[name] for name in names if has_room(self.table, layout, ball, spots[name]))
            layout = put(layout, ball, place)
            spotted.append((ball, place))
        return layout, tuple(spotted)

    def _homes(self, state: CaromState, player: int) -> dict[str, str]:
        """The spots on which the balls begin."""
        mine, other = self.ball_of(state, player), self.ball_of(state, self.other(player))
        return {RED: "head", FAR: "foot", mine: "right", other: "far"}
