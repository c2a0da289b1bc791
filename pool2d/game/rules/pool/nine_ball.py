"""Nine-ball by the WPA's Rules of Play of 15 September 2025, section 5."""

from __future__ import annotations

from dataclasses import dataclass

from ....config.knobs import choice
from ....physics.values import Layout
from ..base import YES_NO
from ..report import Report
from ..ruling import Ruling, State
from .rotation import Rotation, RotationOptions

# How many balls the three-ball rule wants pocketed or over the head string (Regulation 16).
OVER = 3


@dataclass(frozen=True, slots=True)
class NineBallOptions(RotationOptions):
    nine_on_break: str = choice("wins", ("wins", "spotted"), "what the nine does that is pocketed on a legal break")
    three_ball: str = choice("no", YES_NO, "three balls must fall or cross the head string on the break")


class NineBall(Rotation):
    """The lowest ball is hit first; whoever legally pocketed any goes on; the nine wins. Nothing is called (5)."""

    name = "nine-ball"
    title = "Nine-ball"
    rank = 2
    racks = ("nine-ball",)
    last = "9"
    options_type = NineBallOptions

    def won(self, state: State, report: Report, breaks: bool) -> bool:
        """5: the nine wins on any legal shot, a push out excepted; on the break by option."""
        if self.last not in report.potted:
            return False
        return not breaks or (self.options.nine_on_break == "wins" and self._spread(report))

    def after(self, state: State, layout: Layout, report: Report, breaks: bool) -> State:
        player = state.ask.player
        if breaks and not self._spread(report):
            # Regulation 16: no foul; the opponent plays, without a push out, or hands it back.
            return self.to_choose(state, self.other(player), "play", "hand-back")
        # 5.5
        return self.goes_on(state, layout, player if report.potted else self.other(player), breaks)

    def picked(self, state: State, layout: Layout, key: str) -> Ruling:
        if key != "hand-back":
            return super().picked(state, layout, key)
        return self.ruled(self.goes_on(state, layout, self.other(state.ask.player), breaks=True), layout)

    def _spread(self, report: Report) -> bool:
        """Whether a break opened the rack enough."""
        return self.options.three_ball == "no" or len({*report.potted, *report.crossed}) >= OVER
