"""What a stroke at snooker was worth: the balls it was on, its fouls and its points.

Clauses are those of the WPBSA's rules, section 3. What the engine cannot show is in `report`: a stroke out of
turn, feet, balls touched or used to measure (most of 3.10 a, b and d).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Final, Literal, NamedTuple, TypeAlias

from ....physics.values import Layout
from ....table.table import Table
from ..lost import ball_off, cue_ball_off
from ..notes import Note
from ..report import Report
from ..sight import snookering
from .snooker_spots import COLORS, value

# What is on: a red; after a red any colour; the colour of the lowest value.
SnookerPhase: TypeAlias = Literal["red", "color", "order"]
RED: Final = "red"
COLOR: Final = "color"
ORDER: Final = "order"
# 3.10: the least and the greatest penalty.
LEAST, MOST = 4, 7


class Target(NamedTuple):
    """What the striker was on: the balls on, what they are worth, and the free ball nominated, if any.

    No ball is on where a colour had to be nominated and was not.
    """

    on: tuple[str, ...]
    worth: int
    free: str = ""

    @property
    def first(self) -> tuple[str, ...]:
        """The balls that had to be hit first (3.12 b)."""
        return (self.free,) if self.free else self.on


class Foul(NamedTuple):
    """What was wrong, and the value it is punished by."""

    note: Note
    worth: int


def balls_on(phase: SnookerPhase, layout: Layout) -> tuple[str, ...]:
    """3.3 (f), (g): the reds; after a red the colours; when the reds are gone the colour of the lowest value."""
    standing = [ball.id for ball in layout.on_table()]
    if phase == RED:
        return tuple(ball for ball in standing if ball.startswith(RED))
    colors = tuple(ball for ball in COLORS if ball in standing)
    return colors if phase == COLOR else colors[:1]


def aimed(phase: SnookerPhase, free: bool, report: Report) -> Target:
    """What the striker was on.

    Where nothing was said, the ball hit first is taken to be meant, as where it is plain to the referee, or where none
    was hit the one that the cue ball touched. Of two hit at once it is the one that can be nominated.
    """
    on, choice = balls_on(phase, report.start), nominable(phase, free, report.start)
    meant = report.first or report.touching
    said = report.call.ball or next((ball for ball in meant if ball in choice), "")
    named = said if said in choice else ""
    if phase == COLOR:
        return Target((named,), value(named)) if named else Target((), MOST)
    return Target(on, value(on[0]), named)


def nominable(phase: SnookerPhase, free: bool, layout: Layout) -> tuple[str, ...]:
    """The balls that may be nominated: after a red any colour (3.3 g), as the free ball any but one on (2.13)."""
    if phase == COLOR:
        return balls_on(COLOR, layout)
    on = balls_on(phase, layout)
    return tuple(ball for ball in (*balls_on(RED, layout), *balls_on(COLOR, layout)) if free and ball not in on)


def all_fouls(table: Table, layout: Layout, report: Report, aim: Target) -> tuple[Foul, ...]:
    """Every foul of a stroke, the dearest first; `layout` is as the balls came to rest (3.10)."""
    found = [*_hit(report, aim), *_lost(report, aim), *_jumped(report, aim), *_pushed(report, aim)]
    # 3.8 (c): to play away from the free ball, touching it, has no penalty, wherever the cue ball ends.
    if not found and aim.free and aim.free not in report.touching and not scored(report, aim):
        found += _hidden(table, layout, report, aim)
    if not aim.on:
        # (d): a foul after a red, before a colour was nominated.
        found = [Foul(foul.note, MOST) for foul in found]
    return tuple(sorted(found, key=lambda foul: -foul.worth))


def penalty(found: tuple[Foul, ...]) -> int:
    """3.10, 3.11 (g): of several fouls the dearest counts, and it is four at least."""
    return max((LEAST, *(foul.worth for foul in found)))


def missed(found: tuple[Foul, ...]) -> bool:
    """Whether the stroke failed to hit a ball on first."""
    return any(foul.note.key in ("foul.no-hit", "foul.wrong-ball") for foul in found)


def scored(report: Report, aim: Target) -> int:
    """The points of a stroke without foul.

    3.3 (f): every red, and a free ball as a red. 3.3 (g): a colour. 3.12 (c)-(e): a free ball counts as the ball
    on, and not at all where that, no red, falls too.
    """
    down = [ball for ball in report.potted if ball in aim.on]
    freed = aim.free in report.potted
    if aim.worth == 1:
        return len(down) + freed
    return aim.worth if down or freed else 0


def _hit(report: Report, aim: Target) -> Iterator[Foul]:
    """What was hit first.

    3.8 (c): to play away from a touching ball that is on, or the free ball, is to have hit it. 3.12 (b): a free ball
    must be hit first, or with a ball on. 3.10 (c): of two balls at once both must be on.
    """
    first = set(report.first)
    if set(report.touching) & set(aim.first):
        return
    if not first:
        yield Foul(Note("foul.no-hit"), aim.worth)
    elif not first & set(aim.first):
        dearest = max(report.first, key=value)
        yield Foul(Note("foul.wrong-ball", ball=dearest), max(aim.worth, value(dearest)))
    elif not first <= {*aim.on, aim.free} or (aim.free and len(first & set(aim.on)) > 1):
        # A free ball is worth what the ball on is.
        yield Foul(Note("foul.two-at-once"), max(aim.worth, *map(value, first - {aim.free})))


def _lost(report: Report, aim: Target) -> Iterator[Foul]:
    """3.10 (a): the cue ball falls. (b): a ball not on falls, or any ball is forced off the table."""
    if report.scratch:
        yield Foul(Note("foul.scratch"), aim.worth)
    for note in cue_ball_off(report):
        yield Foul(note, aim.worth)
    for ball in report.potted:
        if ball not in aim.on and ball != aim.free:
            yield Foul(Note("foul.potted", ball=ball), max(aim.worth, value(ball)))
    for ball in report.off:
        yield Foul(ball_off(report, ball, ball), max(aim.worth, value(ball)))


def _jumped(report: Report, aim: Target) -> Iterator[Foul]:
    """3.10 (a): a jump shot. 2.20: the cue ball passes over any part of a ball, whether it touches it or not.

    It is none where it has struck another ball first (a); where it jumps and strikes a ball, but does not come down
    beyond it (b); where it goes over the ball it has struck off a cushion or another ball (c).
    """
    for ball in (*report.over, *report.vaulted)[:1]:
        yield Foul(Note("foul.jump", ball=ball), aim.worth)


def _pushed(report: Report, aim: Target) -> Iterator[Foul]:
    """3.10 (b): a push stroke, at a touching ball too (3.8 b). The tip still on the cue ball is one (2.19).

    (a): the cue ball is struck more than once.
    """
    pushed: Collection[str] = report.pressed
    if not pushed and any(fault in ("push", "double-hit") for fault in report.stroke):
        pushed = report.first or ("",)
    for ball in pushed:
        yield Foul(Note("foul.push"), max(aim.worth, value(ball)))
    if "second-hit" in report.stroke and not pushed:
        yield Foul(Note("foul.second-hit"), aim.worth)


def _hidden(table: Table, layout: Layout, report: Report, aim: Target) -> Iterator[Foul]:
    """3.10 (a), 3.12 (b): the free ball snookers, unless only the pink and the black are left."""
    left = {ball.id for ball in layout.on_table()} - {report.cue}
    on = [ball for ball in aim.on if ball in left]
    if on and left != {"pink", "black"} and snookering(table, layout, layout[report.cue], on) == aim.free:
        yield Foul(Note("foul.free-snooker", ball=aim.free), aim.worth)
