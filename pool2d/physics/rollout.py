"""What a shot turned into: for each ball a sequence of motions, and the list of events."""

from __future__ import annotations

import hashlib
import struct
from bisect import bisect_right
from functools import cached_property
from typing import Any

from .motion import Motion
from .values import MOTION_FIELDS, Ball, EventKind, Layout


class Event:
    """Something that happened: a contact, or a change of phase.

    Attributes:
        t: When, s after the shot.
        kind: What, as in `simulate --json`.
        balls: The ids of the balls that it concerns.
        where: The cushion, jaw or pocket, or all of them for a cluster; "miscue" for a tip that slipped.
        pairs: The balls that touched each other, the pair that set it off first.
        rails: Pairs of a ball and the cushion that it touched.
    """

    __slots__ = ("t", "kind", "balls", "where", "pairs", "rails", "_old", "_new")

    def __init__(
        self,
        t: float,
        kind: EventKind,
        where: str | None,
        old: list[Motion],
        new: list[Motion],
        pairs: tuple[tuple[str, str], ...] = (),
        rails: tuple[tuple[str, str], ...] = (),
    ) -> None:
        self.t = t
        self.kind = kind
        self.balls = tuple(motion.id for motion in new)
        self.where = where
        self.pairs = pairs
        self.rails = rails
        self._old = old
        self._new = new

    @property
    def before(self) -> dict[str, Ball]:
        """The balls' states just before it, by id."""
        return {motion.id: motion.at(self.t) for motion in self._old}

    @property
    def after(self) -> dict[str, Ball]:
        """The balls' states just after it, by id."""
        return {motion.id: motion.at(self.t) for motion in self._new}

    def __repr__(self) -> str:
        where = f" {self.where}" if self.where else ""
        return f"<{self.t:.6f} {self.kind} {' '.join(self.balls)}{where}>"

    def as_dict(self) -> dict[str, Any]:
        """What `simulate --json` prints of an event."""
        return {
            "t": self.t,
            "kind": self.kind,
            "balls": list(self.balls),
            "where": self.where,
            "before": {ball_id: ball.state() for ball_id, ball in self.before.items()},
            "after": {ball_id: ball.state() for ball_id, ball in self.after.items()},
        }


class Rollout:
    """A whole shot as a value: ask it for any moment.

    `events` in order of time; `duration` in s, when the last ball came to rest; `truncated` where the
    shot was cut short on request, `duration` then being the last event's time.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table, simulate
        >>> roll = simulate(load_table("pool-9ft"), Layout([Ball("cue", 0.635, 0.635)]), Shot(speed=1.0))
        >>> roll.at(0.0)["cue"].phase, roll.at(1.0)["cue"].phase, roll.layout()["cue"].phase
        ('sliding', 'rolling', 'resting')
        >>> [event.kind for event in roll.events]
        ['cue_ball', 'sliding_rolling', 'ball_cushion', 'sliding_rolling', 'rolling_resting']
        >>> len(roll.path("cue", step=0.5)) == int(roll.duration / 0.5) + 2
        True
    """

    def __init__(self, start: Layout, tracks: dict[str, list[Motion]], events: list[Event], truncated: bool) -> None:
        self.start = start
        self.tracks = tracks
        self.events = events
        self.truncated = truncated
        self.duration = events[-1].t if events else 0.0
        self._times = {ball_id: [motion.t0 for motion in track] for ball_id, track in tracks.items()}

    def at(self, t: float) -> Layout:
        """The layout `t` seconds into the shot, clamped to its beginning and end."""
        t = min(max(t, 0.0), self.duration)
        return Layout(self.ball_at(ball_id, t) for ball_id in self.start)

    def ball_at(self, ball_id: str, t: float) -> Ball:
        """One ball at time `t`, within the shot."""
        given = self.start[ball_id]
        if ball_id not in self.tracks:
            return given
        motion = self.tracks[ball_id][bisect_right(self._times[ball_id], t) - 1]
        ball = motion.at(t)
        if given.radius is None and given.mass is None:
            return ball
        return ball._replace(radius=given.radius, mass=given.mass)

    def layout(self) -> Layout:
        """The layout when the shot is over."""
        return self.at(self.duration)

    def path(self, ball_id: str, step: float) -> list[tuple[float, float, float]]:
        """(t, x, y) of one ball, sampled every `step` s from 0 to the shot's end, which is included."""
        count = int(self.duration / step * (1.0 + 1e-12))
        times = [i * step for i in range(count + 1)]
        if times[-1] < self.duration:
            times.append(self.duration)
        balls = (self.ball_at(ball_id, t) for t in times)
        return [(t, ball.x, ball.y) for t, ball in zip(times, balls, strict=True)]

    @cached_property
    def _digest(self) -> str:
        sha = hashlib.sha256()
        for event in self.events:
            sha.update(f"{event.kind} {event.balls} {event.where}".encode())
            for ball in event.after.values():
                sha.update(struct.pack("<8d", event.t, *(getattr(ball, name) for name in MOTION_FIELDS)))
        for ball in sorted(self.layout().values()):
            sha.update(f"{ball.id} {ball.phase}".encode() + struct.pack("<2d", ball.x, ball.y))
        return sha.hexdigest()

    def digest(self) -> str:
        """A fingerprint of every bit of the rollout: equal for equal input on one machine."""
        return self._digest
