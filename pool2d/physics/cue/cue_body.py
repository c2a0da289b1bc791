"""The cue as a body, and at which elevations it would be in something behind the ball.

The body is a cone about the cue's line, as thick as a tip where it meets the ball and as a butt 58 inches behind that.
It is looked at in the frame of the aim, whose origin is the centre of the ball that is struck: x runs back toward the
player, y to the right, z up. Raising the butt turns the body as a whole about that centre, for the tip is set by its
place across the cue. So a point of the table goes round the cue's frame on a circle, on which its distance from the
cone first falls and then rises: it is in the cue between two elevations, each a root between known bounds.

Only what is behind the ball counts, as far as to the plane across the cue through the ball's centre: that far the tip
runs on at the least.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

# A playing cue: half the width of tip and butt, and the length, m (58 in; tips of 11 to 14 mm, butts of 29 to 32).
# Cues differ from it by a tenth of a degree of elevation, less than the hand that holds them: so these are no knobs.
TIP: Final = 0.0064
BUTT: Final = 0.015
LENGTH: Final = 1.4732
SLOPE: Final = (BUTT - TIP) / LENGTH
# By how much the side of the cue opens from its axis, radians: raised by more, its underside rises all the way back.
TAPER: Final = math.atan(SLOPE)
UPRIGHT: Final = 0.5 * math.pi
INF: Final = math.inf
_COS: Final = math.cos(TAPER)
_SIN: Final = math.sin(TAPER)
# How exactly the highest place of an edge is found, as a part of its length; what it is worth is known far better.
_ALONG: Final = 1e-5

# A place on a level edge, by how far along it is, 0 to 1: x, y, and how they change with that.
Way = Callable[[float], tuple[float, float, float, float]]


class CueBody:
    """The cue behind a ball of `radius`, m, with its tip at (side, height) in radii.

    `side` and `height` are kept in m. The cone would come to a point `apex` m ahead of the ball's centre, the tip meets
    the ball `depth` m behind it, and the butt ends `reach` m from it.
    """

    __slots__ = ("side", "height", "depth", "apex", "reach")

    def __init__(self, radius: float, side: float, height: float) -> None:
        self.side = side * radius
        self.height = height * radius
        self.depth = radius * math.sqrt(max(0.0, 1.0 - side * side - height * height))
        self.apex = TIP / SLOPE - self.depth
        self.reach = self.depth + LENGTH

    def gap(self, x: float, y: float, z: float, elevation: float) -> float:
        """How far a point is from the cue's side at an elevation, radians, m; negative within it."""
        cos, sin = math.cos(elevation), math.sin(elevation)
        across = math.hypot(z * cos - x * sin - self.height, y - self.side)
        return across * _COS - (x * cos + z * sin + self.apex) * _SIN

    def span(self, x: float, y: float, z: float, radius: float = 0.0) -> tuple[float, float] | None:
        """Between which elevations, radians, the cue is in a sphere; None where it is at none.

        It has no end where the cue is in it until the sphere's centre is no longer behind the ball.
        """
        # Beside the cue at every elevation: nowhere that it reaches is it thicker than this.
        beside = abs(y - self.side) > radius + BUTT + radius * SLOPE
        nearest = None if beside else self._nearest(x, y, z, radius)
        if nearest is None:
            return None
        low = math.atan2(z, x) - UPRIGHT
        outside = self.gap(x, y, z, low) > radius
        entry = root(lambda e: self.gap(x, y, z, e) - radius, low, nearest) if outside else -INF
        return entry, self._exit(x, y, z, radius, nearest)

    def over(self, way: Way, z: float) -> float:
        """From which elevation on, radians, the cue clears a level edge; -inf where the edge is nowhere near it.

        The edge may not turn back in y. At any elevation it is in the cue along one piece of it at the most, so the
        elevation that clears a place of it rises along it to the highest, and falls from there on.
        """
        before, after = way(0.0)[1] - self.side, way(1.0)[1] - self.side
        crossing = [root(lambda s: way(s)[1] - self.side, 0.0, 1.0)] if before * after < 0.0 else []
        within = next((s for s in (*crossing, 0.0, 1.0) if self.clears(*way(s)[:2], z) > -INF), None)
        if within is None:
            return -INF
        rises = self._rises(way, z, within, within)
        end = 1.0 if rises else 0.0
        if self._rises(way, z, end, within) == rises:
            return self.clears(*way(end)[:2], z)
        low, high = (within, 1.0) if rises else (0.0, within)
        while high - low > _ALONG:
            s = 0.5 * (low + high)
            low, high = (s, high) if self._rises(way, z, s, within) else (low, s)
        return max(self.clears(*way(s)[:2], z) for s in (low, high))

    def over_bed(self, depth: float) -> float:
        """From which elevation on, radians, tip and butt clear the bed, `depth` m below the ball's centre."""
        return max(_lifted(self.depth, self.height - TIP, depth), _lifted(self.reach, self.height - BUTT, depth))

    def _nearest(self, x: float, y: float, z: float, radius: float) -> float | None:
        """The elevation at which the cue is nearest to a sphere, or deepest in it; None where it never reaches it."""
        if math.hypot(x, y, z) > self.reach + radius:
            return None
        back = math.atan2(z, x)
        nearest = root(lambda e: self._parting(x, y, z, e), back - UPRIGHT, back + UPRIGHT)
        return nearest if self.gap(x, y, z, nearest) < radius else None

    def _exit(self, x: float, y: float, z: float, radius: float, nearest: float) -> float:
        high = math.atan2(z, x) + UPRIGHT
        outside = self.gap(x, y, z, high) > radius
        return root(lambda e: self.gap(x, y, z, e) - radius, nearest, high) if outside else INF

    def _parting(self, x: float, y: float, z: float, elevation: float) -> float:
        """Negative where the gap to a point falls as the butt is raised, positive where it grows."""
        cos, sin = math.cos(elevation), math.sin(elevation)
        t, n = x * cos + z * sin, z * cos - x * sin
        return (self.height - n) * t * _COS - n * _SIN * math.hypot(n - self.height, y - self.side)

    def clears(self, x: float, y: float, z: float) -> float:
        """From which elevation on, radians, the cue is above a point; -inf where it never comes to it."""
        nearest = self._nearest(x, y, z, 0.0) if x > 0.0 else None
        return -INF if nearest is None else self._exit(x, y, z, 0.0, nearest)

    def _rises(self, way: Way, z: float, s: float, within: float) -> bool:
        """Whether the elevation that clears an edge rises at a place along it, where it is finite `within`."""
        x, y, dx, dy = way(s)
        elevation = self.clears(x, y, z)
        if elevation == -INF:
            return s < within
        if elevation == INF:
            return within < s
        cos, sin = math.cos(elevation), math.sin(elevation)
        up, aside = z * cos - x * sin - self.height, y - self.side
        # How the gap changes along the edge: where it falls, more is needed.
        return (aside * dy - up * sin * dx) * _COS - cos * dx * _SIN * math.hypot(up, aside) < 0.0


def root(f: Callable[[float], float], a: float, b: float) -> float:
    """Where a function is zero that has other signs at `a` and at `b`, to the last bits.

    Halving, or inverse quadratic interpolation where three values bend little (Chandrupatla 1997).
    """
    fa, fb = f(a), f(b)
    part = 0.5
    while True:
        x = a + part * (b - a)
        fx = f(x)
        if (fx > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            c, fc = b, fb
            b, fb = a, fa
        a, fa = x, fx
        best, value = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        least = 4e-16 * max(abs(best), 1e-3) / abs(b - a) if b != a else 1.0
        if value == 0.0 or least > 0.5:
            return best
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        part = 0.5
        if phi * phi < xi and (1.0 - phi) * (1.0 - phi) < 1.0 - xi:
            part = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        part = min(max(part, least), 1.0 - least)


def _lifted(t: float, n: float, depth: float) -> float:
    """From which elevation on a point t along the cue and n across it is above a level `depth` below the origin."""
    far = math.hypot(t, n)
    return math.asin(-depth / far) - math.atan2(n, t) if far > depth else -INF
