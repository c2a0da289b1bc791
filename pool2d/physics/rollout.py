"""What a shot turned into: for each ball a sequence of motions, and the list of events."""

from __future__ import annotations

import hashlib
import struct
from bisect import bisect_right
from functools import cached_property

from .event import Event
from .motion import Motion
from .values import Ball, Layout

# What a fingerprint is taken of: the heights only of balls that leave the cloth, which were not always there.
_PRINTED = ("x", "y", "vx", "vy", "wx", "wy", "wz")


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

    @cached_property
    def _times(self) -> dict[str, list[float]]:
        """When each ball's motions begin: worked out for who asks for a moment."""
        return {ball_id: [motion.t0 for motion in track] for ball_id, track in self.tracks.items()}

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
                sha.update(struct.pack("<8d", event.t, *(getattr(ball, name) for name in _PRINTED)))
                if ball.z != 0.0 or ball.vz != 0.0:
                    sha.update(struct.pack("<2d", ball.z, ball.vz))
        for ball in sorted(self.layout().values()):
            sha.update(f"{ball.id} {ball.phase}".encode() + struct.pack("<2d", ball.x, ball.y))
        return sha.hexdigest()

    def digest(self) -> str:
        """A fingerprint of every bit of the rollout: equal for equal input on one machine."""
        return self._digest
