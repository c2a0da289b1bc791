"""The referee: makes a `Report` of a rollout, of what somebody who watches the shot would notice.

What the engine cannot show, no report tells: a ball moved by hand, cloth or sleeve, feet, turns and time. That the tip
is still on the cue ball when that meets a ball is told by how soon it does; a stroke is one moment to the engine.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import lru_cache

from ..physics.event import Event
from ..physics.motion import span
from ..physics.rollout import Rollout
from ..physics.values import MISCUE, PUSH, Ball, Layout
from ..table.arrivals import FROZEN, Arrivals
from ..table.table import Table
from .jumps import jumps, scooped
from .rules.corners import corner_of, lines
from .rules.report import BALL, OFF, POCKET, RAIL, TOP, Call, Contact, Report, StrokeFault

# How long a tip stays on the cue ball, s: high-speed films show about a millisecond.
TIP_TIME = 1e-3
# What rests moves slower than this, m/s.
_RESTS = 1e-6
# A ball hit thinner than half full is grazed: the cosine between the cue ball's way and the line of centres.
GRAZED = math.cos(math.radians(30.0))


def observe(table: Table, rollout: Rollout, call: Call | None = None, cue: str = "", easy: bool = False) -> Report:
    """The report of a whole shot; `cue` is the ball that was struck, the table's cue ball where not given.

    Of an `easy` stroke the tip is gone once it has struck (`Shot.easy`), so that no ball is met too soon.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table, simulate
        >>> from pool2d.game import Call, observe
        >>> table = load_table("pool-9ft")
        >>> layout = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
        >>> roll = simulate(table, layout, Shot(angle=90.0, speed=1.5))
        >>> report = observe(table, roll, Call("1", "top-side"))
        >>> report.first, report.potted, report.scratch
        (('1',), ('1',), True)
    """
    return _Reader(table, rollout, cue or table.furniture.cue, easy).report(call or Call())


class _Reader:
    """Goes through the events of a rollout once."""

    def __init__(self, table: Table, rollout: Rollout, cue: str, easy: bool) -> None:
        self.table = table
        self.rollout = rollout
        self.cue = cue
        self.easy = easy
        self.start = rollout.start
        self.line = table.furniture.head_string
        # How far down and up the table each ball gets.
        self.spans = {ball: span(track, rollout.duration) for ball, track in rollout.tracks.items()}
        self.arrivals = Arrivals(table, rollout)
        self.frozen_at_start = _frozen(table, rollout.start)

    def report(self, call: Call) -> Report:
        contacts: list[Contact] = []
        first: tuple[str, ...] = ()
        meeting: Event | None = None
        for event in self.rollout.events:
            met = list(self.contacts(event))
            hit = [c.other for c in met if c.kind == BALL and c.ball == self.cue]
            if hit and not first:
                first, meeting = tuple(ball for ball in hit if ball == hit[0] or self.meets(event, ball)), event
            contacts += met
        when = math.inf if meeting is None else meeting.t
        jumped = jumps(self.table, self.rollout, self.cue, meeting, first)
        touching = tuple(
            ball.id for ball in self.start.on_table() if ball.id != self.cue and self.gap(ball) <= FROZEN
        )  # fmt: skip
        return Report(
            contacts=tuple(contacts),
            call=call,
            cue=self.cue,
            first=first,
            touching=touching,
            pressed=tuple(ball for ball in touching if ball in first and when <= TIP_TIME),
            frozen=self.frozen_at_start,
            stroke=tuple(self.stroke(first, touching, when)),
            **jumped._asdict(),
            on_rail=tuple(self.on_rail()),
            kitchen=self.kitchen(first, when),
            stayed=self.stayed(),
            crossed=self.over(self.line),
            passed=self.over(0.5 * self.table.knobs.table.length),
            cleared=tuple(self.cleared()),
            astray=self.astray(),
            jammed=tuple(self.jammed()),
            strayed=() if self.table.geometry.pockets else tuple(self.strayed()),
            start=self.start,
        )

    def contacts(self, event: Event) -> Iterator[Contact]:
        """What an event says of who met what."""
        for a, b in event.pairs:
            yield Contact(BALL, b, a) if b == self.cue else Contact(BALL, a, b)
        if event.kind == "ball_slate":
            if event.where:
                yield Contact(TOP, event.balls[0], event.where)
            return
        for ball, cushion in event.rails:
            if self.arrivals.arrives(ball, cushion, event.t):
                yield Contact(RAIL, ball, cushion)
        if event.kind == "ball_pocket":
            yield Contact(POCKET, event.balls[0], event.where or "")
        elif event.kind == "ball_off":
            yield Contact(OFF, event.balls[0], event.where or "")

    def on_rail(self) -> Iterator[str]:
        """The balls that came to rest on a rail's top: the others were on their way when they left the table."""
        for event in self.rollout.events:
            if event.kind == "ball_off":
                ball = event.before[event.balls[0]]
                if math.hypot(ball.vx, ball.vy, ball.vz) < _RESTS:
                    yield ball.id

    def gap(self, ball: Ball) -> float:
        """How far a ball is from the cue ball before the shot, m."""
        cue = self.start[self.cue]
        return math.hypot(ball.x - cue.x, ball.y - cue.y) - self.table.touch(ball, cue)

    def meets(self, event: Event, ball: str) -> bool:
        """Whether the cue ball touches a ball at the very moment of an event."""
        a, b = event.before[self.cue], event.before[ball]
        radius, its_own = (self.table.body_of(self.start[one])[0] for one in (self.cue, ball))
        return math.hypot(a.x - b.x, a.y - b.y, a.z + radius - b.z - its_own) - radius - its_own <= FROZEN

    def stroke(self, first: Iterable[str], touching: tuple[str, ...], when: float) -> Iterator[StrokeFault]:
        """What was wrong with the stroke, as far as it can be seen."""
        hits = [event for event in self.rollout.events if event.kind == "cue_ball"]
        if any(event.where == MISCUE for event in hits):
            yield "miscue"
        if scooped(self.rollout, self.cue):
            yield "scoop"
        stays = any(hit.where == PUSH for hit in hits)
        if stays or any(last.t - hit.t <= TIP_TIME for hit, last in zip(hits, hits[2:], strict=False)):
            # Three in such a time: the tip has stayed with the ball.
            yield "push"
        elif len(hits) > 1:
            yield "second-hit"
        elif (
            not self.easy and when <= TIP_TIME and any(ball not in touching and self.full(ball, when) for ball in first)
        ):
            yield "double-hit"

    def full(self, ball: str, when: float) -> bool:
        """Whether the cue ball's first way leads to more than half of a ball."""
        cue = self.rollout.ball_at(self.cue, 0.5 * when)
        other = self.start[ball]
        dx, dy = other.x - cue.x, other.y - cue.y
        along = cue.vx * dx + cue.vy * dy
        return along > GRAZED * math.hypot(dx, dy) * math.hypot(cue.vx, cue.vy)

    def kitchen(self, first: tuple[str, ...], when: float) -> bool:
        """Whether the first ball met stood behind the head string and the cue ball had not crossed it."""
        if self.line is None or not first or any(self.start[ball].x >= self.line for ball in first):
            return False
        return span(self.rollout.tracks[self.cue], when)[1] < self.line

    def stayed(self) -> bool:
        """Whether the cue ball never crossed the head string nor met a ball beyond it."""
        if self.line is None or self.spans[self.cue][1] >= self.line:
            return False
        met = [(event, pair) for event in self.rollout.events for pair in event.pairs if self.cue in pair]
        return all(event.before[ball].x < self.line for event, pair in met for ball in pair)

    def astray(self) -> bool:
        """Whether the cue ball went over the long string."""
        middle = 0.5 * self.table.knobs.table.width
        low, high = span(self.rollout.tracks[self.cue], self.rollout.duration, 0.0, 1.0)
        return low < middle < high

    def jammed(self) -> Iterator[str]:
        """The cushions that the cue ball lay on and was shot into."""
        met = [pair for event in self.rollout.events if event.t <= TIP_TIME for pair in event.rails]
        # A tip that is still on the ball drives it into its cushion more than once.
        for ball, rail in dict.fromkeys(met):
            if (ball, rail) in self.frozen_at_start and ball == self.cue:
                yield rail

    def strayed(self) -> Iterator[str]:
        """The object balls that stood in a corner and left it."""
        for ball in self.start.on_table():
            corner = corner_of(self.table, ball.x, ball.y)
            if ball.id != self.cue and corner:
                u, v, limit = lines(self.table)[corner]
                if span(self.rollout.tracks[ball.id], self.rollout.duration, u, v)[1] > limit:
                    yield ball.id

    def cleared(self) -> Iterator[str]:
        """The object balls that came over the middle of the table's length with their whole width."""
        middle = 0.5 * self.table.knobs.table.length
        for ball, (low, high) in self.spans.items():
            if ball != self.cue:
                x, radius = self.start[ball].x, self.table.body_of(self.start[ball])[0]
                if (low + radius < middle) if x > middle else (high - radius > middle):
                    yield ball

    def over(self, line: float | None) -> tuple[str, ...]:
        """The object balls whose centre goes over a line across the table."""
        if line is None:
            return ()
        return tuple(ball for ball, (low, high) in self.spans.items() if ball != self.cue and low < line < high)


@lru_cache(maxsize=2)
def _frozen(table: Table, layout: Layout) -> tuple[tuple[str, str], ...]:
    """The balls that lie on a cushion, and which; kept, as whoever weighs strokes has many seen from one layout."""
    # Each once, also where a ball lies on a cushion's nose and its end.
    return tuple(dict.fromkeys(pair for ball in layout.on_table() for pair in _lies_on(table, ball)))


def _lies_on(table: Table, ball: Ball) -> Iterator[tuple[str, str]]:
    radius = table.body_of(ball)[0]
    reach, room = table.reach(radius), radius + FROZEN
    for index in table.near(ball.x - room, ball.y - room, ball.x + room, ball.y + room):
        element = table.elements[index]
        if element.kind == "ball_cushion" and element.gap(ball.x, ball.y, reach) <= FROZEN:
            yield ball.id, element.name
