"""English eight-ball by the World Rules of the WEPF (edition of 2020), whose sections are named by letters.

These are the rules of two visits after a foul, not those of blackball, nor the International Rules of 2023.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from ....physics.values import GONE, POCKETED, Layout
from ..notes import Note
from ..report import Report
from ..ruling import AIM, Ruling
from ..sight import sees, snookered
from ..spotting import KITCHEN, Spotted, Where, spot_balls
from ..vantage import vantage
from .english_pool import BLACK, COLORS, RED, YELLOW, EnglishPool
from .pool import DRIVEN, GroupsState, driven


@dataclass(frozen=True, slots=True)
class EnglishState(GroupsState):
    """A frame.

    `visits` are those the player at the table still has, the present one with them. `free`: the player is
    foul-snookered and may nominate a ball. `trial` is a colour nominated after the break of which no ball had fallen.
    """

    visits: int = 1
    free: bool = False
    trial: str = ""


class EnglishEightBall(EnglishPool[EnglishState]):
    """D: clear your colour, then pot the black. After a foul the opponent has two visits."""

    name = "english-eight-ball"
    title = "English eight-ball"
    rank = 6
    state_type = EnglishState

    def on(self, state: EnglishState, layout: Layout, player: int) -> tuple[str, ...]:
        """C (3): one's colour, and the black when it is gone; on an open table both colours (H)."""
        if not state.shots:
            return self.on_table(layout)
        own = state.trial or state.groups[player]
        return self.to_clear(layout, (own,) if own else COLORS)

    def judge(self, state: EnglishState, layout: Layout, report: Report) -> Ruling:
        player, broken = state.ask.player, not state.shots
        on = self.on(state, report.start, player)
        state = replace(state, shots=state.shots + 1)
        if broken:
            return self._break(state, layout, report)
        nominated = report.call.ball if state.free and report.call.ball in state.ask.on else ""
        fouls = tuple(self.fouls(state, report, on, nominated))
        if BLACK in report.potted:
            # D (1), M
            return self.black_potted(state, layout, fouls, due=BLACK in on)
        layout, spotted = self.spot(layout, report.off)
        if fouls:
            return self._fouled(state, layout, fouls, spotted)
        fallen = self.colors_potted(report)
        potted = any(ball in on or ball == nominated for ball in report.potted)
        notes: tuple[Note, ...] = ()
        if state.open and potted:
            if not state.trial and len(fallen) == 2:
                # H (3) (b)
                return self.ruled(self._nominating(state, player), layout)
            state, note = self.decided(state, player, state.trial or fallen.pop())
            notes = (note,)
        state = replace(state, trial="")
        return self._goes_on(state, layout, potted, notes)

    def picked(self, state: EnglishState, layout: Layout, key: str) -> Ruling:
        player = state.ask.player
        name, _, color = key.partition(":")
        if name == "baulk":
            # P (3) (b), (4) (b): a player who takes the cue ball to baulk may be foul-snookered there too.
            return self._to_play(state, self.to_baulk(layout), player)
        # H (2) (c), (3) (b): a colour of which a ball has fallen is one's own, another has to be potted first.
        if any(layout[ball].phase == POCKETED for ball in self.balls_of(color)):
            state, note = self.decided(state, player, color)
            state = replace(state, trial="")
            return self.ruled(self.next(state, layout, player), layout, note)
        state = replace(state, trial=color)
        return self.ruled(self.next(state, layout, player), layout)

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """Not a ball that left the colours undecided, since it was not the one that had been chosen (H 2 c)."""
        state: EnglishState = ruling.state  # type: ignore[assignment]
        return () if state.open and ruling.ask.kind == AIM else super().pots(player, report, ruling)

    def fouls(self, state: EnglishState, report: Report, on: tuple[str, ...], nominated: str) -> Iterator[Note]:
        """K, N, R and S: the standard fouls, a jump shot among them, and G: a shot that is not legal."""
        legal = (*on, nominated) if nominated else on
        yield from self.fouls_lost(report)
        theirs = () if state.open else self.balls_of(state.groups[self.other(state.ask.player)])
        for ball in report.potted:
            if ball in theirs and ball != nominated:
                yield Note("foul.potted", ball=ball)
        # G (1), R
        yield from self.fouls_hit(report, legal)
        yield from self.fouls_jumped(report)
        yield from self.fouls_pushed(report)

    def snookered(self, report: Report, on: Collection[str]) -> bool:
        """G (3), Q: whether this was a total snooker; a jaw makes one as a ball does."""
        start = report.start
        return not sees(self.table, start, start[report.cue], [ball for ball in on if ball in start], between=True)

    def _break(self, state: EnglishState, layout: Layout, report: Report) -> Ruling:
        """F (4): the break is fair where a colour is potted or four balls are driven to a cushion."""
        player = state.ask.player
        opponent = self.other(player)
        if BLACK in report.potted:
            # The same player breaks again, whatever else happened.
            return self._racked_again(state, player, state.visits)
        if not report.potted and driven(report) < DRIVEN:
            # (b)
            return self._racked_again(state, opponent, 2, Note("foul.break"))
        layout, spotted = self.spot(layout, report.off)
        fouls = tuple(
            note for note in self.fouls(state, report, self.on_table(report.start), "") if note.key != "foul.no-rail"
        )
        if tuple(note.key for note in fouls) == ("foul.scratch",):
            # K (1), L: the turn passes, and that is all.
            return self._to_play(replace(state, visits=1), layout, opponent, fouls, spotted)
        if fouls:
            return self._fouled(state, layout, fouls, spotted)
        if report.potted:
            # H (2) (b)
            return self.ruled(self._nominating(state, player), layout)
        return self._goes_on(state, layout, False)

    def _racked_again(self, state: EnglishState, player: int, visits: int, *fouls: Note) -> Ruling:
        """A new rack, which a player breaks with one visit or two."""
        ruling = self.broken_by(player, state)
        again: EnglishState = ruling.state  # type: ignore[assignment]
        notes = (
            *fouls,
            Note("re-racked"),
            *((Note("two-visits", player),) if visits > 1 else ()),
            Note("break", player),
        )
        return ruling._replace(state=replace(again, visits=visits), fouls=fouls, notes=notes)

    def _fouled(self, state: EnglishState, layout: Layout, fouls: tuple[Note, ...], spotted: Spotted) -> Ruling:
        """K: the opponent has two visits."""
        opponent = self.other(state.ask.player)
        state = replace(state, visits=2, trial="")
        return self._to_play(state, layout, opponent, fouls, spotted, (Note("two-visits", opponent),))

    def _to_play(
        self,
        state: EnglishState,
        layout: Layout,
        player: int,
        fouls: tuple[Note, ...] = (),
        spotted: Spotted = (),
        notes: tuple[Note, ...] = (),
    ) -> Ruling:
        """The turn after a foul: from baulk (E) where the cue ball is off the table, and P.

        Who is foul-snookered, by balls or by a jaw (Q), may play from where the cue ball lies or from baulk, and
        nominate a ball that is not on.
        """
        on, cue = self.on(state, layout, player), layout[self.table.furniture.cue]
        where: Where = KITCHEN if cue.phase in GONE else ""
        # Q: a jaw snookers the cue ball that lies between it and its like.
        hidden = (
            vantage(self.table, layout, cue, on, where, between=True) is None
            if where
            else snookered(self.table, layout, cue, on, between=True)
        )
        state = replace(state, free=hidden)
        if hidden:
            options = () if where else ("baulk",)
            state = self.next(state, layout, player, where, on=self.on_table(layout), call="ball", options=options)
            notes = (*notes, Note("free-ball"))
        else:
            state = self.next(state, layout, player, where, options=())
        return self.ruled(state, layout, *notes, fouls=fouls, spotted=spotted)

    def _goes_on(self, state: EnglishState, layout: Layout, potted: bool, notes: tuple[Note, ...] = ()) -> Ruling:
        """C (5), (6): a visit lasts while balls on are potted; then comes the next, or the opponent."""
        player, state = state.ask.player, replace(state, free=False)
        if not potted:
            mine = state.visits > 1
            player = player if mine else self.other(player)
            state = replace(state, visits=state.visits - 1 if mine else 1)
        return self.ruled(self.next(state, layout, player), layout, *notes)

    def _nominating(self, state: EnglishState, player: int) -> EnglishState:
        return self.to_choose(replace(state, free=False, trial=""), player, f"group:{RED}", f"group:{YELLOW}")

    def spot(self, layout: Layout, balls: tuple[str, ...]) -> tuple[Layout, Spotted]:
        """S: balls off the table go on the spot, or behind it without touching another: the black, reds, yellows."""
        order = [BLACK, *(ball for color in COLORS for ball in self.balls_of(color))]
        spot = self.table.furniture.spots[BLACK]
        return spot_balls(self.table, layout, sorted(balls, key=order.index), spot, clear=frozenset(layout))
