"""The event loop: find the next contact before it happens, move to it exactly, solve it."""

from __future__ import annotations

import math
from collections.abc import Callable
from heapq import heappop, heappush
from typing import Final, final

from ..errors import InputError
from .body import Body
from .contact import Contacts, Met
from .crowd import Crowd
from .cue.tip import Tip
from .detect import Element, Pocket, time_ball_ball, time_in_the_air
from .event import Event
from .flight.bed import PATIENCE, Bed
from .flight.solids import Solid
from .motion import Motion, finish, off, pocketed, start
from .params import Physics
from .roots import INF
from .strike import strike
from .values import AIRBORNE, MISCUE, OFF, POCKETED, PUSH, ROLLING, SLIDING, SPINNING, EventKind, Phase, Shot

# The event with which a phase ends by itself.
_ENDS: Final[dict[Phase, EventKind]] = {SLIDING: "sliding_rolling", ROLLING: "rolling_resting", SPINNING: "spin_end"}


@final
class World:
    """The balls in motion and the queue of what may happen to them.

    A queue entry is (time, ball, other, version of ball, version of other), where `other` is a ball,
    -1 for the ball's own change of phase, -2 - e for table element e or, after those, for what stands about the bed off
    the cloth, `again` where the ball has to look for others once more, `tip_again` for the tip that has struck it. An
    entry whose versions are not the present ones is stale: the ball has moved otherwise since.
    """

    __slots__ = (
        "physics", "elements", "bed", "again", "tip", "tip_again", "cloth", "now", "events", "queue", "crowd",
        "contacts", "version", "tracks",
    )  # fmt: skip

    def __init__(self, bodies: list[Body], physics: Physics, elements: list[Element], bed: Bed) -> None:
        self.physics = physics
        self.elements = elements
        self.bed = bed
        self.again = -2 - len(self.elements) - len(self.bed.solids)
        self.tip: Tip | None = None
        self.tip_again = self.again - 1
        self.cloth = bed.materials.cloth
        self.now = 0.0
        self.events: list[Event] = []
        self.queue: list[tuple[float, int, int, int, int]] = []
        motions = [self.go_on(body) for body in bodies]
        self.crowd = Crowd(bodies, motions)
        self.contacts = Contacts(self.crowd, self.elements, bed)
        self.version = [0] * len(bodies)
        self.tracks = [[motion] for motion in motions]
        for body in bodies:
            self.predict(body.index)

    def strike(self, shot: Shot) -> None:
        shot.check()
        body = next((body for body in self.crowd.bodies if body.id == shot.ball), None)
        if body is None:
            raise InputError("shot", "shot.ball", shot.ball, "not a ball on the table")
        if shot.speed > 0.0:
            lay = self.bed.lies(body)
            stroke = strike(body, shot, self.physics.cue)
            met = self.contacts.struck(body, stroke) if lay else Met([], [], [])
            if stroke.onward > 0.0 and self.physics.cue.follow_through > 0.0 and not shot.easy:
                self.tip = Tip(body, shot, stroke, self.physics.cue)
            if lay:
                self.bed.answer(body)
            others = [other for other in met.bodies() if other.index != body.index]
            pairs, rails, where = _names(met)
            self.record("cue_ball", where if stroke.clean else MISCUE, [body, *others], None, pairs, rails)

    def strike_again(self, body: Body, tip: Tip) -> None:
        """The tip that runs on meets its ball again; where the two stay together that is a push, and its end."""
        lay = self.bed.lies(body)
        parted = tip.strike(body, self.now)
        if lay:
            self.bed.answer(body)
        if not parted:
            self.tip = None
        self.record("cue_ball", None if parted else PUSH, [body])

    def run(self, limit: int, until: Callable[[Event], bool] | None) -> bool:
        """Go on to rest, for `limit` events, or to the first that `until` says True of; whether that was the end."""
        while len(self.events) < limit:
            seen = len(self.events)
            if not self.advance():
                break
            if until is not None and len(self.events) > seen and until(self.events[-1]):
                return True
        return False

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
        if other == -1:
            self.change_phase(i)
            return
        if other == self.again:
            self.crowd.lift(self.crowd.motion[i])
            self.look(i)
            return
        body = self.crowd.bring(i, self.now)
        if other == self.tip_again and self.tip is not None:
            self.strike_again(body, self.tip)
            return
        if other >= 0:
            self.touched(self.contacts.balls(body, self.crowd.bring(other, self.now), self.now))
            return
        place = -2 - other
        if place >= len(self.elements):
            self.meet_aloft(body, self.bed.solids[place - len(self.elements)])
            return
        element = self.elements[place]
        if isinstance(element, Pocket):
            if self.bed.keeps(body, element):
                self.record(element.kind, element.name, [body], [pocketed(body, self.now)])
            else:
                self.fall(body)
        else:
            self.touched(self.contacts.cushion(body, element, self.now))

    def change_phase(self, i: int) -> None:
        """Let ball i go on where its motion has run out."""
        body, old = self.crowd.bodies[i], self.crowd.motion[i]
        if old.phase == AIRBORNE:
            self.come_down(body, old)
            return
        motion = old if old.aloft() and old.stays() else finish(old, body, self.cloth)
        if body.z != 0.0 and motion.stays():
            # At rest on a rail's top it is off the table.
            self.record("ball_off", self.bed.ground.beside(body.x, body.y), [body], [off(body, self.now)])
            return
        if old.coasts():
            self.follow(motion)
            self.predict(i)
        else:
            self.record(_ENDS[old.phase], None, [body], [motion])

    def go_on(self, body: Body) -> Motion:
        """How a ball goes on from its present state: on what it lies on, or in the air."""
        if body.aloft() and not self.bed.lies(body):
            return self.bed.fall(body, self.now)
        return start(body, self.now, self.cloth)

    def fall(self, body: Body) -> None:
        """Let a ball go on in the air that nothing is under any more."""
        self.follow(self.bed.fall(body, self.now))
        self.predict(body.index)

    def come_down(self, body: Body, motion: Motion) -> None:
        """A flying ball comes down on the bed, on a rail's top, or in a pocket."""
        motion.move(body, self.now)
        if motion.floor < 0.0:
            self.record("ball_pocket", self.bed.pocket(body).name, [body], [pocketed(body, self.now)])
            return
        where = self.bed.ground.beside(body.x, body.y) if motion.floor > 0.0 else None
        self.bed.land(body, motion.floor)
        self.record("ball_slate", where, [body])

    def meet_aloft(self, body: Body, solid: Solid) -> None:
        """A ball off the cloth comes to something about the bed."""
        if solid.kind is None:
            self.fall(body)
        elif solid.kind == "ball_off":
            self.record(solid.kind, solid.name, [body], [off(body, self.now)])
        else:
            self.contacts.solid(body, solid)
            self.record(solid.kind, solid.name, [body], None, (), ((body.id, solid.name),))
            self.give_up([body])

    def give_up(self, bodies: list[Body]) -> None:
        """A ball that others, or an edge, have held up for long is at rest there: off the table."""
        for body in bodies:
            if body.held > PATIENCE:
                self.record("ball_off", None, [body], [off(body, self.now)])

    def touched(self, met: Met) -> None:
        """Note a contact, or several that were one."""
        for motion in met.pressed:
            self.follow(motion)
        pairs, rails, where = _names(met)
        kind: EventKind = "cluster" if len(pairs) + len(rails) > 1 else "ball_ball" if pairs else "ball_cushion"
        self.record(kind, where, met.bodies(), None, pairs, rails)
        if met.aloft:
            self.give_up(met.bodies())

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
            new = [self.go_on(body) for body in bodies]
        old = [self.crowd.motion[body.index] for body in bodies]
        if self.tip is not None and kind != "cue_ball":
            for body, before in zip(bodies, old, strict=True):
                if body.index == self.tip.index:
                    self.tip.feel(body, before, self.now)
        self.events.append(Event(self.now, kind, where, old, new, pairs, rails))
        for motion in new:
            self.follow(motion)
        for motion in new:
            self.predict(motion.index)

    def follow(self, motion: Motion) -> None:
        """Let a ball go on as `motion` has it; what was predicted for it is void."""
        self.crowd.lift(motion)
        self.tracks[motion.index].append(motion)
        self.version[motion.index] += 1

    def predict(self, i: int) -> None:
        """Queue what may come of ball i's new motion: its own next event, and each ball that it may meet.

        A motion holds until it ends or its ball meets the table, so nothing later is looked for. That
        also bounds what is found for a pair: where the other ball's motion ends, it is asked again.
        """
        motion = self.crowd.motion[i]
        if motion.phase == POCKETED or motion.phase == OFF:
            return
        if motion.aloft() and motion.stays():
            heappush(self.queue, (self.now, i, -1, self.version[i], 0))
        elif motion.aloft():
            self.meet_solids(motion, self.crowd.bodies[i].radius)
        elif not motion.stays():
            self.meet_table(motion, self.crowd.bodies[i].reach)
        elif motion.end < INF:
            heappush(self.queue, (motion.end, i, -1, self.version[i], 0))
        if self.tip is not None and self.tip.index == i and self.now < self.tip.gone:
            t = self.tip.time(motion, self.crowd.bodies[i].radius, self.now)
            if t < INF:
                heappush(self.queue, (t, i, self.tip_again, self.version[i], 0))
        self.look(i)

    def look(self, i: int) -> None:
        """Queue each ball that ball i may meet until its motion ends, or it has gone so far that it looks again."""
        motion, body, now = self.crowd.motion[i], self.crowd.bodies[i], self.now
        stays, until = motion.stays(), motion.end
        if not stays:
            until = min(until, now + self.crowd.horizon(motion, now))
            motion.bound(now - motion.t0, until - motion.t0)
            if until < motion.end:
                heappush(self.queue, (until, i, self.again, self.version[i], 0))
        far = body.radius + self.crowd.largest
        for other in self.crowd.near(motion.left - far, motion.bottom - far, motion.right + far, motion.top + far):
            if stays and other.stays():
                continue
            radius = self.crowd.bodies[other.index].radius
            last = min(until, other.t1)
            if motion.aloft() or other.aloft():
                t = time_in_the_air(motion, other, now, last, body.radius, radius)
            else:
                t = time_ball_ball(motion, other, now, last, 2.0 * math.sqrt(body.radius * radius))
            if t < INF:
                a, b = min(i, other.index), max(i, other.index)
                heappush(self.queue, (t, a, b, self.version[a], self.version[b]))
        self.crowd.put(motion)

    def meet_table(self, motion: Motion, reach: float) -> None:
        """Queue where a motion ends, by itself or at the table."""
        now, own = self.now, -1
        s = motion.t1 - now
        motion.bound(0.0, s)
        left, bottom = motion.left - reach, motion.bottom - reach
        right, top = motion.right + reach, motion.top + reach
        for index, element in enumerate(self.elements):
            if element.left <= right and left <= element.right and element.bottom <= top and bottom <= element.top:
                t = now + element.time(motion, reach, s)
                if t < motion.end:
                    motion.end, own = t, -2 - index
        heappush(self.queue, (motion.end, motion.index, own, self.version[motion.index], 0))

    def meet_solids(self, motion: Motion, radius: float) -> None:
        """Queue where a motion off the cloth ends, by itself or at what stands about the bed."""
        own, first = -1, -2 - len(self.elements)
        s = motion.t1 - motion.t0
        motion.bound(0.0, s)
        left, bottom = motion.left - radius, motion.bottom - radius
        right, top = motion.right + radius, motion.top + radius
        for index, solid in enumerate(self.bed.solids):
            if solid.left <= right and left <= solid.right and solid.bottom <= top and bottom <= solid.top:
                t = motion.t0 + solid.time(motion, radius, motion.end - motion.t0)
                if t < motion.end:
                    motion.end, own = t, first - index
        heappush(self.queue, (motion.end, motion.index, own, self.version[motion.index], 0))


def _names(met: Met) -> tuple[tuple[tuple[str, str], ...], tuple[tuple[str, str], ...], str | None]:
    """Which balls touched each other, which touched which cushions, and where, as an event has it."""
    pairs = tuple([(a.id, b.id) for a, b in met.pairs])
    rails = tuple([(body.id, name) for body, name in met.rails])
    return pairs, rails, ", ".join(dict.fromkeys([name for _, name in rails])) or None
