"""What the carom games share: the opening, innings, fouls, the spots and the end of a match.

Articles are those of the UMB's World Rules of Carom Billiard. Each player strikes a ball of their own.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

from ....config.knobs import choice, knob
from ....physics.values import GONE, Layout
from ....table.arrivals import FROZEN
from ..base import YES_NO, Options, Rules
from ..lost import balls_off, cue_ball_off
from ..notes import Note
from ..report import BALL, RAIL, Report
from ..ruling import Ruling, State
from ..scores import added, changed, points, score_notes
from ..spotting import Spotted, put

RED = "red"
# Which of a player's starting spots is offered instead of the other.
_OTHER = {"left": "right", "right": "left"}


@dataclass(frozen=True, slots=True)
class CaromOptions(Options):
    """What may be set about a carom game."""

    points: float = knob(40.0, 1.0, 1000.0, "", "points that end the match")
    innings: float = knob(0.0, 0.0, 500.0, "", "innings that end the match; 0 for no limit")
    equal: str = choice("yes", YES_NO, "whether the second player has as many innings as the first")


@dataclass(frozen=True, slots=True)
class CaromState(State):
    """A match.

    `innings` are those each player has ended, `run` the points of the present one and `best` each player's most
    in one inning. `opening`: the balls lie in the starting position. `last`: the second player has the inning
    that makes them equal. Of straight rail `zone` says how often in a row the player may still score without
    driving a ball out of the corner both are in; -1 where they are in none.
    """

    innings: tuple[int, ...] = (0, 0)
    run: int = 0
    best: tuple[int, ...] = (0, 0)
    opening: bool = True
    last: bool = False
    zone: int = -1


class Carom(Rules[CaromState]):
    """Rules in which a cannon, the cue ball's touch of both other balls, is a point (art. 24)."""

    racks = ("carom",)
    groups = ("other", RED)
    options_type: ClassVar[type[Options]] = CaromOptions
    state_type = CaromState

    @property
    def goal(self) -> float:
        """The score that ends the match."""
        return float(self.options.points)

    def counts(self, report: Report) -> bool:
        """Whether a cannon is one by the rules of this game."""
        raise NotImplementedError

    def frozen(
        self, state: CaromState, layout: Layout, player: int, touching: tuple[str, ...], notes: tuple[Note, ...]
    ) -> Ruling:
        """Art. 27 (1): the player may have touching balls spotted, or play away from them."""
        return self.ruled(self.aim(state, player, "respot"), layout, *notes)

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        """Who wins the lag says who breaks (art. 22)."""
        state, layout = self.racked(CaromState(seed=seed, breaker=breaker))
        layout = self.set_up(state, layout, breaker)
        return self.ruled(self.opened(state, breaker), layout)

    def ball_of(self, state: CaromState, player: int) -> str:
        """Art. 23: who begins strikes the white, the table's cue ball; the opponent the yellow."""
        return self.table.furniture.cue if player == state.breaker else self.table.furniture.groups["other"][0]

    def opened(self, state: CaromState, player: int, spot: str = "right") -> CaromState:
        """The state in which a player has the opening stroke, at the red, from one of two spots (art. 23)."""
        state = replace(state, opening=True, zone=-1)
        return replace(
            state,
            turn=player,
            ask=replace(self.aim(state, player).ask, on=(RED,), options=(f"start-spot:{_OTHER[spot]}",)),
        )

    def aim(self, state: CaromState, player: int, *options: str) -> CaromState:
        """The state in which a player strikes at the other two balls."""
        on = (self.ball_of(state, self.other(player)), RED)
        ask = replace(
            state.ask, kind="aim", player=player, ball=self.ball_of(state, player), where="", on=on, options=options
        )
        return replace(state, turn=player, ask=ask)

    def set_up(self, state: CaromState, layout: Layout, player: int, spot: str = "right") -> Layout:
        """Art. 23: the red on the foot spot, the opponent's ball on the head spot, the player's beside it."""
        spots = self.table.furniture.spots
        layout = put(layout, RED, spots["foot"])
        layout = put(layout, self.ball_of(state, self.other(player)), spots["head"])
        return put(layout, self.ball_of(state, player), spots[spot])

    def judge(self, state: CaromState, layout: Layout, report: Report) -> Ruling:
        player = state.ask.player
        found = tuple(self.fouls(state, report))
        state = replace(state, shots=state.shots + 1, opening=False)
        if found:
            return self._inning_over(state, layout, found)
        if not self.cannon(report) or not self.counts(report):
            ruling = self._inning_over(state, layout, ())
            return ruling._replace(notes=(self.missed(report), *ruling.notes))
        change = points(player, 1)
        state = replace(added(state, change), run=state.run + 1)
        state = replace(state, best=changed(state.best, player, max(state.best[player], state.run)))
        if state.scores[player] >= self.goal:
            return self._inning_over(state, layout, (), change)
        return self.goes_on(state, layout, player)._replace(points=change)

    def goes_on(self, state: CaromState, layout: Layout, player: int) -> Ruling:
        """The ruling by which a player strikes next, after a point of theirs where there is a run."""
        notes = score_notes(points(player, 1)) if state.run else ()
        lost = tuple(ball for ball in layout if layout[ball].phase in GONE)
        if lost:
            layout, spotted = self.spot(state, layout, player, lost)
            return self.ruled(self.aim(state, player), layout, *notes, spotted=spotted)
        touching = self.touching(state, layout, player)
        if touching:
            return self.frozen(state, layout, player, touching, notes)
        return self.ruled(self.aim(state, player), layout, *notes)

    def picked(self, state: CaromState, layout: Layout, key: str) -> Ruling:
        player = state.ask.player
        name, _, spot = key.partition(":")
        if name == "start-spot":
            layout = put(layout, self.ball_of(state, player), self.table.furniture.spots[spot])
            return self.ruled(self.opened(state, player, spot), layout)
        layout, spotted = self.spot(
            state, layout, player, (self.ball_of(state, player), *self.touching(state, layout, player))
        )
        return self.ruled(self.aim(state, player), layout, spotted=spotted)

    def fouls(self, state: CaromState, report: Report) -> Iterator[Note]:
        """Art. 41: what ends an inning, as far as it can be seen. 23: the opening goes straight to the red."""
        yield from self.fouls_off(report)
        yield from self.fouls_pushed(report)
        if report.jammed:
            yield Note("foul.into-rail")
        if state.opening and self.cannon(report) and self._before_red(report):
            yield Note("foul.not-red")

    def fouls_off(self, report: Report) -> Iterator[Note]:
        """The fouls by balls that left the table."""
        yield from cue_ball_off(report)
        yield from balls_off(report)

    def fouls_pushed(self, report: Report) -> Iterator[Note]:
        """The fouls of a tip that stays on the cue ball, or strikes it twice: a touching ball is pushed."""
        for ball in report.pressed:
            yield Note("foul.push", ball=ball)
        for fault in report.stroke:
            if fault in ("double-hit", "second-hit", "push") and not report.pressed:
                yield Note(f"foul.{fault}", ball=report.first[0] if report.first else "")

    def missed(self, report: Report) -> Note:
        """Why a stroke without foul was no point."""
        met = balls_met(report)
        return Note("missed.one", ball=self.spoken(met[0])) if met else Note("missed.none")

    def _before_red(self, report: Report) -> bool:
        """Whether the opening stroke met the other ball before the red, or a cushion."""
        return report.of(report.cue)[0][::2] != (BALL, RED)

    def cannon(self, report: Report) -> bool:
        """Art. 24: whether the cue ball touched both other balls."""
        return len(set(balls_met(report))) == 2

    def touching(self, state: CaromState, layout: Layout, player: int) -> tuple[str, ...]:
        """The balls that touch a player's cue ball."""
        cue = layout[self.ball_of(state, player)]
        return tuple(
            ball.id
            for ball in layout.on_table()
            if ball.id != cue.id
            and (ball.x - cue.x) ** 2 + (ball.y - cue.y) ** 2 <= (self.table.touch(cue, ball) + FROZEN) ** 2
        )

    def spot(self, state: CaromState, layout: Layout, player: int, balls: Collection[str]) -> tuple[Layout, Spotted]:
        """Art. 27 (4): balls on their spots before a player's stroke."""
        raise NotImplementedError

    def _inning_over(
        self,
        state: CaromState,
        layout: Layout,
        found: tuple[Note, ...],
        change: tuple[int, ...] = (0, 0),
    ) -> Ruling:
        """The inning is over, and with it perhaps the match.

        Who reaches the points first wins, but where innings are to be equal the second player has one more, from the
        starting position. After the last inning of a limit the higher score wins; a tie is a draw.
        """
        player = state.ask.player
        opponent, notes = self.other(player), score_notes(change)
        state = replace(state, innings=changed(state.innings, player, state.innings[player] + 1), run=0, zone=-1)
        done = state.scores[player] >= self.goal
        if done and player == state.breaker and self.options.equal == "yes":
            state = replace(self.opened(state, opponent), last=True)
            layout = self.set_up(state, layout, opponent)
            return self.ruled(state, layout, *notes, Note("last-inning", opponent), points=change)
        limited = player != state.breaker and 0 < self.options.innings <= state.innings[player]
        if done or state.last or limited:
            first, second = state.scores
            winner = -1 if first == second else int(second > first)
            return self.ruled(self.ended(state, winner), layout, *notes, fouls=found, points=change)
        ruling = self.goes_on(state, layout, opponent)
        return ruling._replace(fouls=found, notes=(*found, *notes, *ruling.notes), points=change)


def cushions_before_last(report: Report) -> int:
    """How many cushions the cue ball met before the second of the other balls; each meeting counts."""
    met: set[str] = set()
    cushions = 0
    for contact in report.of(report.cue):
        if contact.kind == RAIL:
            cushions += 1
        elif contact.kind == BALL:
            met.add(contact.other)
            if len(met) == 2:
                return cushions
    return cushions


def balls_met(report: Report) -> tuple[str, ...]:
    """The balls that the cue ball met, in their order; one as often as it was met."""
    return tuple(contact.other for contact in report.of(report.cue) if contact.kind == BALL)
