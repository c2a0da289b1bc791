"""Eight-ball by the WPA's Rules of Play of 15 September 2025, section 4."""

from __future__ import annotations

from dataclasses import replace

from ....physics.values import Layout
from ..notes import Note
from ..report import Report
from ..ruling import Ruling
from ..spotting import ANYWHERE, KITCHEN, Where, spot_balls
from .fouls import shared_fouls
from .pool import DRIVEN, GroupsRules, GroupsState, driven, gone

EIGHT = "8"
SOLID, STRIPE = "solid", "stripe"


class EightBall(GroupsRules[GroupsState]):
    """Clear your group, then pocket the eight. Every shot but the break is called; a safety may be (4.5, 4.6)."""

    name = "eight-ball"
    title = "Eight-ball"
    rank = 1
    racks = ("eight-ball",)
    groups = (SOLID, STRIPE)
    state_type = GroupsState
    call = "pocket"
    may = ("safety",)

    def on(self, state: GroupsState, layout: Layout, player: int) -> tuple[str, ...]:
        """4.4: on an open table any ball but the eight, and that too once a group is gone. 4.5: else one's own.

        On the break any ball may be hit first (4.3).
        """
        balls = self.on_table(layout)
        if not state.shots:
            return balls
        left = {name: tuple(ball for ball in balls if ball in self._balls(name)) for name in self.groups}
        eight = (EIGHT,) if EIGHT in balls else ()
        if not state.open:
            return left[state.groups[player]] or eight
        return left[SOLID] + left[STRIPE] + (() if all(left.values()) else eight)

    def judge(self, state: GroupsState, layout: Layout, report: Report) -> Ruling:
        player, ask = state.ask.player, state.ask
        fouls = shared_fouls(report, ask.on, kitchen=ask.where == KITCHEN)
        state = replace(state, shots=state.shots + 1)
        if state.shots == 1:
            return self._break(state, layout, report, fouls)
        called = report.called()
        if EIGHT in (*report.potted, *report.off):
            return self._eight(state, layout, report, fouls)
        if fouls:
            # 4.9: the incoming player has the cue ball in hand anywhere.
            return self.ruled(self.next(state, layout, self.other(player), ANYWHERE), layout, fouls=fouls)
        if called not in ask.on:
            lost = () if report.call.safety else tuple(Note("not-called", ball=ball) for ball in report.potted)
            return self.ruled(self.next(state, layout, self.other(player)), layout, *lost)
        notes: tuple[Note, ...] = ()
        if state.open:
            # 4.4: the ball called gives its group.
            mine, other = (SOLID, STRIPE) if called in self._balls(SOLID) else (STRIPE, SOLID)
            state = replace(state, groups=(mine, other) if player == 0 else (other, mine))
            notes = (Note(f"group.{mine}", player),)
        return self.ruled(self.next(state, layout, player), layout, *notes)

    def picked(self, state: GroupsState, layout: Layout, key: str) -> Ruling:
        if key != "spot-eight":
            return super().picked(state, layout, key)
        # 4.3 (e), (f): the breaker goes on where the balls lie; the opponent from behind the head string.
        player = state.ask.player
        layout, spotted = spot_balls(self.table, layout, (EIGHT,))
        where: Where = "" if player == state.breaker else KITCHEN
        return self.ruled(self.next(state, layout, player, where), layout, spotted=spotted)

    def _break(self, state: GroupsState, layout: Layout, report: Report, fouls: tuple[Note, ...]) -> Ruling:
        """4.3: the break. It never gives groups."""
        player = state.ask.player
        opponent = self.other(player)
        if EIGHT in report.potted:
            # (e), (f)
            chooser = opponent if fouls else player
            return self.ruled(self.to_choose(state, chooser, "spot-eight", "re-rack"), layout, fouls=fouls)
        layout, spotted = spot_balls(self.table, layout, tuple(ball for ball in report.off if ball == EIGHT))
        keep = () if gone(layout, report.cue) else ("accept",)
        if not report.potted and driven(report) < DRIVEN:
            # (d), which is no foul in itself.
            options = (*keep, *(("kitchen",) if fouls else ()), "re-rack", "opponent-breaks")
            state = self.to_choose(state, opponent, *options)
            return self.ruled(state, layout, Note("illegal-break"), fouls=fouls, spotted=spotted)
        if fouls:
            # (g), (h): balls off the table stay out, but for the eight.
            if keep:
                return self.ruled(
                    self.to_choose(state, opponent, "accept", "kitchen"), layout, fouls=fouls, spotted=spotted
                )
            return self.ruled(self.next(state, layout, opponent, KITCHEN), layout, fouls=fouls, spotted=spotted)
        # (c)
        return self.ruled(self.next(state, layout, player if report.potted else opponent), layout)

    def _eight(self, state: GroupsState, layout: Layout, report: Report, fouls: tuple[Note, ...]) -> Ruling:
        """4.8: the eight decides the rack, one way or the other."""
        player = state.ask.player
        if EIGHT in report.off:
            reason = "loss.eight-off"
        elif fouls:
            reason = "loss.eight-foul"
        elif EIGHT not in state.ask.on:
            reason = "loss.eight-early"
        elif report.called() != EIGHT:
            reason = "loss.eight-pocket"
        else:
            return self.ruled(self.ended(state, player), layout)
        return self.ruled(self.ended(state, self.other(player)), layout, Note(reason, player), fouls=fouls)

    def _balls(self, group: str) -> tuple[str, ...]:
        return self.table.furniture.groups[group]
