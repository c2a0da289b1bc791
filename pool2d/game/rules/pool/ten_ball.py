"""Ten-ball by the WPA's Rules of Play of 15 September 2025, section 6."""

from __future__ import annotations

from dataclasses import dataclass

from ....config.knobs import choice
from ....physics.values import Layout
from ..report import Report
from ..ruling import State
from .rotation import Rotation, RotationOptions


@dataclass(frozen=True, slots=True)
class TenBallOptions(RotationOptions):
    early_ten: str = choice("spotted", ("spotted", "wins"), "what a ten does that is called and pocketed early")


class TenBall(Rotation):
    """The lowest ball is hit first and every shot but the break is called; there is no safety to call (6.5)."""

    name = "ten-ball"
    title = "Ten-ball"
    rank = 3
    racks = ("ten-ball",)
    last = "10"
    options_type = TenBallOptions
    call = "pocket"

    def won(self, state: State, report: Report, breaks: bool) -> bool:
        """6.7: the ten, called, wins when it was the only ball on the table, and so the lowest; earlier by option."""
        if breaks or report.called() != self.last:
            return False
        return self.last in state.ask.on or self.options.early_ten == "wins"

    def after(self, state: State, layout: Layout, report: Report, breaks: bool) -> State:
        player, opponent = state.ask.player, self.other(state.ask.player)
        if breaks:
            return self.goes_on(state, layout, player if report.potted else opponent, breaks)
        if report.called():
            return self.goes_on(state, layout, player, breaks)
        if report.potted:
            # 6.6: balls wrongfully pocketed stay down, and the opponent says who goes on.
            return self.to_choose(state, opponent, "play", "pass")
        return self.goes_on(state, layout, opponent, breaks)
