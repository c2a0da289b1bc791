"""The drill by which people say how good they are (Joe Tucker's, in Alciatore's FAQ on ratings), and its scale.

A rack of ten balls is broken; what that makes counts, but for what fell with a foul, or is spotted as the ten is. Then,
with the cue ball in hand, the balls are run in rotation until one is missed. What counts is how many are made in ten
racks.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import replace
from typing import Final

from ...game.judging import Judged
from ...game.rules import Ruling, State
from ...game.rules.pool.ten_ball import TenBall
from ...game.rules.report import Report
from ...game.rules.scores import added, points
from ...game.rules.spotting import ANYWHERE, spot_balls
from ...physics.values import Layout
from ...table.table import Table
from ..player import Player
from .visits import potted, visit

RACKS: Final = 10
# From how many balls on a grade is reached.
SCALE: Final = (
    (0, "D"), (30, "D+"), (36, "C"), (41, "C+"), (46, "B"), (51, "B+"), (56, "A"), (61, "A+"), (66, "A++"),
    (71, "professional"),
)  # fmt: skip


class BallsCounted(TenBall):
    """Ten-ball alone: each ball is a point, and the first miss after the break ends it."""

    players = 1
    scored = True

    def judge(self, state: State, layout: Layout, report: Report) -> Ruling:
        ruling = super().judge(state, layout, report)
        if not state.shots:
            return ruling
        balls = len(self.pots(0, report, ruling))
        after = added(ruling.state, points(0, balls))
        return ruling._replace(state=after if balls else self.ended(after, -1))


def grade(balls: float) -> str:
    """The grade of who makes so many balls in ten racks: D below the published scale, then D+ up to professional."""
    return SCALE[bisect_right(SCALE, round(balls), key=lambda step: step[0]) - 1][1]


def one_rack(table: Table, player: Player, seed: int, number: int) -> int:
    """The balls that a player makes in one rack of the drill."""
    rules, name, eager = BallsCounted(table), f"ten racks {seed} {number}", attacking(player)
    broken = next(visit(rules, rules.start(0, _rack(seed, number)), eager, f"{name} break"), None)
    if broken is None:
        return 0
    return made(broken) + potted(rules, visit(rules, in_hand(rules, broken), eager, name))[0]


def made(broken: Judged) -> int:
    """How many balls a break makes that stay down."""
    spotted = dict(broken.ruling.spotted)
    return 0 if broken.ruling.foul else sum(ball not in spotted for ball in broken.report.potted)


def in_hand(rules: TenBall, broken: Judged) -> Ruling:
    """After the break: the cue ball anywhere, and of a foul the balls back on the table."""
    layout, state = broken.ruling.layout, broken.ruling.state
    if broken.ruling.foul:
        fell = {*broken.report.potted, *broken.report.off} - set(rules.on_table(layout))
        layout, _ = spot_balls(rules.table, layout, sorted(fell, key=int, reverse=True))
    return rules.ruled(rules.next(replace(state, shots=1, fouls=(0, 0)), layout, 0, ANYWHERE), layout)


def attacking(player: Player) -> Player:
    """The player where nothing but a pot counts: no safety is looked for."""
    return replace(player, judgement=replace(player.judgement, safeties=0.0))


def _rack(seed: int, number: int) -> int:
    return 1000 * seed + number
