"""The ways of balls as lines: close to the parabolas that they are, on the cloth and through the air."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

from ..physics.motion import Motion
from ..physics.rollout import Rollout
from ..physics.values import AIRBORNE, GONE

# How far a way may be from where the ball goes, m: less than is seen.
WITHIN = 0.0003

Line = list[tuple[float, float]]


class Way(NamedTuple):
    """A part of a ball's way as points, m: on the cloth, or `aloft`: a single flight, which `lands` or not."""

    points: Line
    aloft: bool = False
    lands: bool = False


def ways(
    rollout: Rollout,
    ball: str,
    start: float = 0.0,
    end: float = math.inf,
    length: float = math.inf,
    within: float = WITHIN,
) -> list[Way]:
    """The way of a ball between two times, s, in its parts; cut off after `length` m.

    The straight lines between the points are nowhere farther than `within` m from where the ball goes.
    """
    found: list[Way] = []
    track = rollout.tracks[ball]
    for i, motion in enumerate(track):
        last = track[i + 1].t0 if i + 1 < len(track) else rollout.duration
        t0, t1 = max(start, motion.t0), min(end, last)
        if t0 >= t1 or motion.stays():
            continue
        aloft = motion.phase == AIRBORNE
        steps = _steps(motion, t0, t1, within)
        points = [motion.place(t0 + (t1 - t0) * step / steps) for step in range(steps + 1)]
        if found and not aloft and not found[-1].aloft:
            # It begins where the last has ended.
            found[-1].points.extend(points[1:])
        else:
            lands = aloft and t1 == motion.t1 and i + 1 < len(track) and track[i + 1].phase not in GONE
            found.append(Way(points, aloft, lands))
    return found if length == math.inf else _cut(found, length)


def trace(
    rollout: Rollout,
    ball: str,
    start: float = 0.0,
    end: float = math.inf,
    length: float = math.inf,
    within: float = WITHIN,
) -> Line:
    """What `ways` says as one line."""
    return joined(ways(rollout, ball, start, end, length, within))


def joined(parts: list[Way]) -> Line:
    """The parts of a way as one line."""
    points: Line = []
    for part in parts:
        points += part.points[1 if points else 0 :]
    return points


def dashes(points: Line, dash: float, gap: float) -> list[Line]:
    """A line as pieces of the length `dash`, `gap` apart; it begins with one, and what is left is one too."""
    pieces: list[Line] = [[points[0]]] if points else []
    drawn, left = True, dash
    for (ax, ay), (bx, by) in pairwise(points):
        length, done = math.hypot(bx - ax, by - ay), 0.0
        while length - done > left:
            done += left
            place = (ax + done / length * (bx - ax), ay + done / length * (by - ay))
            if drawn:
                pieces[-1].append(place)
            else:
                pieces.append([place])
            drawn, left = not drawn, gap if drawn else dash
        left -= length - done
        if drawn:
            pieces[-1].append((bx, by))
    return [piece for piece in pieces if len(piece) > 1]


def _steps(motion: Motion, start: float, end: float, within: float) -> int:
    """How many chords of equal time keep `within` m of a motion's path, a parabola.

    The chord of a step of s seconds leaves it by h_n (s/2)^2, where h_n is the part of half the acceleration across
    the chord: |h x v| over the speed in the middle of the step. Where the ball turns back, the chord misses the turn by
    what h has along it too.
    """
    hx, hy, time = motion.hx, motion.hy, end - start
    since = 2.0 * (start - motion.t0)
    vx, vy = motion.vx + hx * since, motion.vy + hy * since
    wx, wy = vx + 2.0 * hx * time, vy + 2.0 * hy * time
    across = abs(hx * vy - hy * vx)
    turns = hx * vx + hy * vy < 0.0 < hx * wx + hy * wy
    if not turns and across * time**2 <= 4.0 * within * math.hypot(vx + hx * time, vy + hy * time):
        return 1
    most, slowest = math.hypot(hx, hy), min(math.hypot(vx, vy), math.hypot(wx, wy))
    bend = most if turns or across >= most * slowest else across / slowest
    return max(1, math.ceil(0.5 * time * math.sqrt(bend / within)))


def _cut(parts: list[Way], length: float) -> list[Way]:
    """The first `length` m of a way."""
    kept: list[Way] = []
    for part in parts:
        points = part.points
        for i in range(1, len(points)):
            (ax, ay), (bx, by) = points[i - 1], points[i]
            step = math.hypot(bx - ax, by - ay)
            if step > length:
                share = length / step
                end = (ax + share * (bx - ax), ay + share * (by - ay))
                return [*kept, part._replace(points=[*points[:i], end], lands=False)]
            length -= step
        kept.append(part)
    return kept
