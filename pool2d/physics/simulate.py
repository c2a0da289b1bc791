"""The event loop: find the next contact before it happens, move to it exactly, solve it."""

from __future__ import annotations

import math
from heapq import heappop, heappush
from typing import Any, Protocol

from ..errors import BudgetError, InputError
from .body import Body
from .contact import Contacts, Met, Surroundings
from .detect import time_ball_ball
from .motion import Motion, finish, pocketed, start
from .rollout import Event, Rollout
from .strike import strike
from .values import MISCUE, POCKETED, ROLLING, SLIDING, SPINNING, Ball, EventKind, Layout, Phase, Shot

# Far above what any shot takes (a break takes some hundreds).
BUDGET = 50_000
# The event with which a phase ends by itself.
_ENDS: dict[Phase, EventKind] = {SLIDING: "sliding_rolling", ROLLING: "rolling_resting", SPINNING: "spin_end"}


class Field(Surroundings, Protocol):
    """What the loop needs of a table."""

    def body_of(self, ball: Ball) -> tuple[float, float]:
        """Radius and mass of a ball, its own or the table's."""
        ...

    def settle(self, layout: Layout) -> Layout:
        """The layout with its balls exactly where they may stand; raises InputError where they may not."""
        ...

    def scenario(self, layout: Layout, shot: Shot | None) -> dict[str, Any]:
        """Table, balls and shot in the form of a scenario file."""
        ...


def simulate(
    table: Field, layout: Layout, shot: Shot | None = None, *, events: int | None = None, budget: int = BUDGET
) -> Rollout:
    """Play `layout` from its velocities and, where given, a shot, until every ball is at rest.

    `events` stops after that many events. Raises InputError where the shot's ball is not on the table
    or the shot is out of range, BudgetError where the shot takes more than `budget` events.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table, simulate
        >>> layout = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
        >>> roll = simulate(load_table("pool-9ft"), layout, Shot(angle=90.0, speed=1.5))
        >>> [(event.kind, *event.balls) for event in roll.events if event.where]
        [('ball_pocket', '1'), ('ball_pocket', 'cue')]
        >>> simulate(load_table("pool-9ft"), layout, Shot(angle=90.0, speed=1.5), events=2).truncated
        True
    """
    layout = table.settle(layout)
    world = _World(table, layout)
    if shot is not None:
        world.strike(shot)
    limit = budget if events is None else min(events, budget)
    while len(world.events) < limit and world.advance():
        pass
    truncated = world.advance(look=True)
    if truncated and limit != events:
        raise BudgetError(budget, world.now, table.scenario(layout, shot))
    return Rollout(layout, {track[0].id: track for track in world.tracks}, world.events, truncated)


class _World:
    """The balls in motion and the queue of what may happen to them.

    A queue entry is (time, ball, other, version of ball, version of other), where `other` is a ball,
    -1 for the ball's own change of phase, or -2 - e for table element e. An entry whose versions are
    not the present ones is stale: the ball has moved otherwise since.
    """

    def __init__(self, table: Field, layout: Layout) -> None:
        self.table = table
        self.physics = table.physics
        self.elements = table.elements
        self.now = 0.0
        self.events: list[Event] = []
        self.queue: list[tuple[float, int, int, int, int]] = []
        # Sorted, so that the order in which balls are given is of no consequence.
        balls = sorted(layout.on_table())
        self.bodies = [Body(ball, index, *table.body_of(ball)) for index, ball in enumerate(balls)]
        self.index = {body.id: body.index for body in self.bodies}
        self.reach = [_reach(body.radius, table.physics.cushion.nose_height) for body in self.bodies]
        self.contacts = Contacts(table, self.reach)
        self.touch = [[2.0 * math.sqrt(a.radius * b.radius) for b in self.bodies] for a in self.bodies]
        self.version = [0] * len(balls)
        self.motion = [start(body, 0.0, self.physics.cloth, self.physics.gravity) for body in self.bodies]
        self.tracks = [[motion] for motion in self.motion]
        for body in self.bodies:
            self.predict(body.index)

    def strike(self, shot: Shot) -> None:
        shot.check()
        if shot.ball not in self.index:
            raise InputError("shot", "shot.ball", shot.ball, "not a ball on the table")
        body = self.bodies[self.index[shot.ball]]
        if shot.speed > 0.0:
            clean = strike(body, shot, self.physics.cue)
            self.record("cue_ball", None if clean else MISCUE, [body])

    def advance(self, look: bool = False) -> bool:
        """Carry out the next event; False where there is none. `look` only tells whether there is."""
        while self.queue:
            t, i, other, version, other_version = self.queue[0]
            if version == self.version[i] and (other < 0 or other_version == self.version[other]):
                if not look:
                    heappop(self.queue)
                    self.now = t
                    self.happen(i, other)
                return True
            heappop(self.queue)
        return False

    def happen(self, i: int, other: int) -> None:
        """Solve the event that has come: a change of phase, a contact of two balls, or with the table."""
        body = self.bodies[i]
        if other == -1:
            phase = self.motion[i].phase
            coasted = self.motion[i].coasts()
            motion = finish(self.motion[i], body, self.physics.cloth, self.physics.gravity)
            if coasted:
                self.follow(i, motion)
                self.predict(i)
                return
            self.record(_ENDS[phase], None, [body], [motion])
            return
        self.motion[i].move(body, self.now)
        element = self.elements[-2 - other] if other < 0 else None
        if element is not None and element.kind == "ball_pocket":
            self.record(element.kind, element.name, [body], [pocketed(body, self.now)])
            return
        present = [body for body in self.bodies if self.motion[body.index].phase != POCKETED]
        for one in present:
            if self.motion[one.index].t1 < math.inf:
                self.motion[one.index].move(one, self.now)
        if element is None:
            self.touched(self.contacts.balls(body, self.bodies[other], present, self.now))
        else:
            self.touched(self.contacts.cushion(body, element, present, self.now))

    def touched(self, met: Met) -> None:
        """Note a contact, or several that were one."""
        for motion in met.pressed:
            self.follow(self.index[motion.id], motion)
        bodies = {body.index: body for pair in met.pairs for body in pair} | {body.index: body for body, _ in met.rails}
        one: EventKind = "ball_ball" if met.pairs else "ball_cushion"
        kind = "cluster" if len(met.pairs) + len(met.rails) > 1 else one
        where = ", ".join(dict.fromkeys(name for _, name in met.rails)) or None
        pairs = tuple((a.id, b.id) for a, b in met.pairs)
        rails = tuple((body.id, name) for body, name in met.rails)
        self.record(kind, where, [bodies[index] for index in sorted(bodies)], None, pairs, rails)

    def record(
        self,
        kind: EventKind,
        where: str | None,
        bodies: list[Body],
        new: list[Motion] | None = None,
        pairs: tuple[tuple[str, str], ...] = (),
        rails: tuple[tuple[str, str], ...] = (),
    ) -> None:
        """Note an event, and let its bodies go on from their present state."""
        if new is None:
            new = [start(body, self.now, self.physics.cloth, self.physics.gravity) for body in bodies]
        self.events.append(
            Event(self.now, kind, where, [self.motion[body.index] for body in bodies], new, pairs, rails)
        )
        for body, motion in zip(bodies, new, strict=True):
            self.follow(body.index, motion)
        for body in bodies:
            self.predict(body.index)

    def follow(self, i: int, motion: Motion) -> None:
        """Let ball i go on as `motion` has it; what was predicted for it is void."""
        self.motion[i] = motion
        self.tracks[i].append(motion)
        self.version[i] += 1

    def predict(self, i: int) -> None:
        """Queue what may come of ball i's new motion: its own next event, and each ball that it may meet.

        A motion holds until it ends or its ball meets the table, so nothing later is looked for. That
        also bounds what is found for a pair: where the other ball's motion ends, it is asked again.
        """
        motion, now = self.motion[i], self.now
        if motion.phase == POCKETED:
            return
        end, own = motion.t1, -1
        moves = motion.phase == SLIDING or motion.phase == ROLLING
        if moves:
            reach, s = self.reach[i], end - now
            (left, right), (bottom, top) = _span(motion, s)
            for index in self.table.near(left - reach, bottom - reach, right + reach, top + reach):
                t = now + self.elements[index].time(motion, reach, s)
                if t < end:
                    end, own = t, -2 - index
        if end < math.inf:
            heappush(self.queue, (end, i, own, self.version[i], 0))
        (left, right), (bottom, top) = _span(motion, end - now)
        touch = self.touch[i]
        for j, other in enumerate(self.motion):
            if j == i or other.phase == POCKETED:
                continue
            if other.vx == 0.0 == other.vy and other.hx == 0.0 == other.hy:
                # At rest. A look at the box that the motion stays in spares most of the work.
                room = touch[j]
                if not (moves and left - room < other.x < right + room and bottom - room < other.y < top + room):
                    continue
            t = time_ball_ball(motion, other, now, min(end, other.t1), touch[j])
            if t < math.inf:
                a, b = (i, j) if i < j else (j, i)
                heappush(self.queue, (t, a, b, self.version[a], self.version[b]))


def _reach(radius: float, nose: float) -> float:
    """How far from a nose line, in plan, a ball's centre is when it touches: R cos th, sin th = h/R - 1."""
    return math.sqrt(nose * (2.0 * radius - nose))


def _span(motion: Motion, s: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """A box that holds the first s seconds of a motion, as (left, right), (bottom, top).

    It goes round the three control points of the path, which is a Bezier curve. A ball at rest has no end.
    """
    if s == math.inf:
        return (motion.x, motion.x), (motion.y, motion.y)
    x1, x2 = motion.x + 0.5 * motion.vx * s, motion.x + (motion.vx + motion.hx * s) * s
    y1, y2 = motion.y + 0.5 * motion.vy * s, motion.y + (motion.vy + motion.hy * s) * s
    return (min(motion.x, x1, x2), max(motion.x, x1, x2)), (min(motion.y, y1, y2), max(motion.y, y1, y2))
