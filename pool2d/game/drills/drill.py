"""Drills: positions with goals, how strokes at them are judged, and what comes next."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from ...physics.rollout import Rollout
from ...physics.values import GONE, Layout, Shot
from ...table.table import Table
from ..referee import observe
from ..rules.report import BALL, POCKET, RAIL, TOP, Report
from ..rules.spotting import near_spot, put

ANY = "any"
# What a stroke may fail to do; the words for each are the window's.
MISSES = (
    "cue_fell", "wrong_first", "not_potted", "few_banks", "not_all_hit", "few_rails", "cushion_met", "wrong_way",
    "few_driven", "not_jumped", "wrong_rest",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class RestArea:
    """Where a ball has to come to rest: a box, or a circle of radius `within` round `at`, m."""

    ball: str
    x: tuple[float, float] = (-math.inf, math.inf)
    y: tuple[float, float] = (-math.inf, math.inf)
    at: tuple[float, float] | None = None
    within: float = math.inf

    def holds(self, layout: Layout) -> bool:
        """Whether the ball lies there."""
        ball = layout.get(self.ball)
        if ball is None or ball.phase in GONE:
            return False
        near = self.at is None or math.dist((ball.x, ball.y), self.at) <= self.within
        return near and self.x[0] <= ball.x <= self.x[1] and self.y[0] <= ball.y <= self.y[1]


@dataclass(frozen=True, slots=True)
class Step:
    """What one stroke has to do, from a `layout` of its own or as the balls lie; `drill_file` tells each entry.

    It has more attributes than most classes, as each is a key of the file.
    """

    layout: Layout | None = None
    pot: str = ""
    least: int = 1
    pocket: str = ""
    first: str = ""
    hits: tuple[str, ...] = ()
    rails: int = 0
    banks: int = 0
    driven: int = 0
    clear: bool = False
    over: tuple[str, ...] = ()
    via: tuple[str, ...] = ()
    rest: tuple[RestArea, ...] = ()
    respot: bool = False


class Wording(NamedTuple):
    """What a drill is called, and what is to be done."""

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Drill:
    """A drill as read: `goal` is how many steps reach it, `most` the highest result.

    `others` are its name and text in other languages, by their two letters.
    """

    id: str
    name: str
    text: str
    table: Table
    layout: Layout
    steps: tuple[Step, ...]
    goal: int
    tries: int
    solution: tuple[Shot, ...]
    others: Mapping[str, Wording] = field(default_factory=dict)

    @property
    def most(self) -> int:
        return self.tries * len(self.steps)

    def wording_in(self, language: str) -> Wording:
        """Its name and text in a language, as they are where it has none of it."""
        return self.others.get(language, Wording(self.name, self.text))


class Standing(NamedTuple):
    """Where an attempt stands: the balls, steps done, what the last stroke missed, and whether it is over."""

    layout: Layout
    done: int = 0
    missed: str = ""
    over: bool = False


@dataclass(frozen=True, slots=True)
class Run:
    """A drill attempted as often as it says: a value; each stroke leads to the next.

    `results` are the steps done in the attempts that are over.
    """

    drill: Drill
    standing: Standing
    results: tuple[int, ...] = ()

    @property
    def result(self) -> int:
        """All steps done so far: what is compared with the best."""
        return sum(self.results) + (0 if self.standing.over else self.standing.done)

    @property
    def over(self) -> bool:
        return len(self.results) == self.drill.tries

    def after(self, rollout: Rollout) -> Run:
        """The run after a stroke; one that ends an attempt leaves the balls as they came to rest."""
        standing = judge(self.drill, self.standing, rollout)
        results = (*self.results, standing.done) if standing.over else self.results
        return Run(self.drill, standing, results)

    def again(self) -> Run:
        """The run with the balls set up for the next attempt; one that was not over counts for nothing."""
        return Run(self.drill, start(self.drill), self.results)


def begin(drill: Drill) -> Run:
    """A run of which nothing is played."""
    return Run(drill, start(drill))


def start(drill: Drill) -> Standing:
    """The beginning of an attempt."""
    return Standing(drill.layout)


def judge(drill: Drill, standing: Standing, rollout: Rollout) -> Standing:
    """What a stroke makes of an attempt: one step further, or over."""
    step = drill.steps[standing.done]
    report, layout = observe(drill.table, rollout), rollout.layout()
    missed = faults(drill.table, step, report, layout)
    if missed:
        return Standing(layout, standing.done, missed, over=True)
    done = standing.done + 1
    if done == len(drill.steps):
        return Standing(layout, done, over=True)
    if step.respot:
        layout = _spotted(drill.table, layout, report.potted)
    after = drill.steps[done].layout
    return Standing(layout if after is None else after, done)


def faults(table: Table, step: Step, report: Report, layout: Layout) -> str:
    """What a stroke failed to do of a step: one of MISSES; "" where it did all."""
    fell = [pot.ball for pot in report.pots if _fits(table, pot.ball, step.pot) and step.pocket in ("", pot.pocket)]
    struck = [c.other for c in report.of(report.cue) if c.kind == BALL]
    checks = {
        "cue_fell": not report.cue_gone,
        "wrong_first": not step.first or any(_fits(table, b, step.first) for b in report.first),
        "not_potted": not step.pot or len(fell) >= step.least,
        "few_banks": not step.banks or _banks(report, fell[:1]) >= step.banks,
        "not_all_hit": all(any(_fits(table, b, wanted) for b in struck) for wanted in step.hits),
        "few_rails": _rails(table, report, step.hits) >= step.rails,
        "cushion_met": not step.clear or all(c.kind not in (RAIL, TOP) for c in report.of(report.cue)),
        "wrong_way": set(step.via) <= {c.other for c in report.of(report.cue)},
        "few_driven": len(report.driven) >= step.driven,
        "not_jumped": set(step.over) <= set(report.over),
        "wrong_rest": all(rest.holds(layout) for rest in step.rest),
    }
    return next((miss for miss, good in checks.items() if not good), "")


def _fits(table: Table, ball: str, wanted: str) -> bool:
    """Whether a ball is the one, or of the group, that is wanted."""
    return wanted in (ANY, ball) or ball in table.furniture.groups.get(wanted, ())


def _rails(table: Table, report: Report, hits: tuple[str, ...]) -> int:
    """The cushions that the cue ball met before the last of `hits` was first hit, or before any ball."""
    count, left = 0, list(hits)
    for contact in report.of(report.cue):
        if contact.kind == RAIL:
            count += 1
        elif contact.kind == BALL:
            left = [wanted for wanted in left if not _fits(table, contact.other, wanted)]
            if not left:
                return count
    return count if not hits else 0


def _banks(report: Report, fell: list[str]) -> int:
    """The cushions, jaws apart, that a ball met before it fell."""
    if not fell:
        return 0
    contacts = report.of(fell[0])
    end = next(i for i, contact in enumerate(contacts) if contact.kind == POCKET)
    return sum(c.kind == RAIL and not c.other.endswith((" jaw", " back")) for c in contacts[:end])


def _spotted(table: Table, layout: Layout, balls: tuple[str, ...]) -> Layout:
    """The layout with balls back where their rack has them, as near as there is room; others stay off."""
    for ball in balls:
        place = next((rack.placed[ball] for rack in table.furniture.racks.values() if ball in rack.placed), None)
        spot = place and near_spot(table, layout, ball, place)
        layout = put(layout, ball, spot) if spot else layout
    return layout
