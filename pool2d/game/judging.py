"""A stroke played and judged: what it turned into, what the referee saw of it, and what follows."""

from __future__ import annotations

from typing import Any, NamedTuple

from ..physics.rollout import Rollout
from ..physics.simulate import simulate
from ..physics.values import OFF, Layout
from .actions import Stroke
from .referee import observe
from .rules import Rules, Ruling, State
from .rules.report import Report


class Judged(NamedTuple):
    """A stroke's rollout, the referee's report of it, and the ruling."""

    rollout: Rollout
    report: Report
    ruling: Ruling


def judged(rules: Rules[Any], state: State, layout: Layout, stroke: Stroke) -> Judged:
    """Play a stroke on the rules' table and judge it; raises what `simulate` does."""
    return seen(rules, state, simulate(rules.table, layout, stroke.shot), stroke)


def seen(rules: Rules[Any], state: State, rollout: Rollout, stroke: Stroke) -> Judged:
    """Judge a stroke that was played."""
    report = observe(rules.table, rollout, stroke.call, stroke.shot.ball, stroke.shot.easy)
    return Judged(rollout, report, rules.judge(state, _after(rollout), report))


def _after(rollout: Rollout) -> Layout:
    """The layout after a stroke. How high a ball was when it left the table is no part of where a match stands."""
    layout = rollout.layout()
    return layout.put(*(ball.still()._replace(phase=OFF) for ball in layout.values() if ball.phase == OFF))
