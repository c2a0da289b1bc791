"""How large pockets play, beside what is published: `python -m benchmarks.targets`.

A target is the width of the band of parallel ways whose balls fall: as far as a ball may pass beside the middle of
the mouth on either side, at an angle off the pocket's axis and a speed. Alciatore works it out for slow balls that
leave points, facings and rails as light leaves a mirror, without friction or loss (technical proofs TP 3.5, side
pockets, and TP 3.6, corner pockets). Printed are his pockets, of mirrors and of what pool-9ft is of, then those of
the tables named. Balls come rolling, without side spin.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from pool2d import Ball, Event, Layout, Table, load_table, simulate

INCH = 0.0254
# His pockets. The jaws of both are sharp.
CORNER = {
    "corner.mouth": 4.5875 * INCH, "corner.angle": 142.0, "corner.shelf": 1.125 * INCH,
    "corner.drop_radius": 2.75 * INCH, "corner.jaw_radius": 0.0,
}  # fmt: skip
SIDE = {
    "side.mouth": 5.0625 * INCH, "side.angle": 104.0, "side.shelf": 0.1875 * INCH,
    "side.drop_radius": 3.0 * INCH, "side.jaw_radius": 0.0,
}  # fmt: skip
# What he finds, inches by degrees off the axis. In the corner at 0 and 20 degrees these have a ball that meets a point
# and falls; with facings met after the point, as here too, his equations give 2.67 and 2.42.
TP_3_6 = {0.0: 2.57, 20.0: 2.34, 30.0: 2.17, 40.0: 2.81}
TP_3_5 = {0.0: 3.21, 20.0: 2.94, 35.0: 2.41, 50.0: 1.63}
# Balls and cushions as his: nothing is lost, nothing rubs, and a ball is met at its own height.
MIRROR: dict[str, float | str] = {
    "cushion.law": "impulse", "cushion.restitution": 1.0, "cushion.friction": 0.0, "cushion.nose_height": 0.028575,
    "facing.restitution": 1.0, "facing.tangential": 0.0, "facing.friction": 1.0,
    "cloth.mu_roll": 0.001, "cloth.mu_slide": 0.01,
}  # fmt: skip
SPEEDS = (0.7, 1.5, 3.0, 5.0, 7.0)
# How far the ways are apart that are tried, and how closely the edges between them are found, m.
_STEP, _CLOSE = 1e-3, 1e-5
# No ball falls that would pass further beside the middle of a mouth, m.
_WIDE = 0.13
# From how far off balls come, m: to a corner from so far that they may meet the rail on the way.
_AWAY = {"corner": 1.1, "side": 0.8}


@dataclass(frozen=True)
class Mouth:
    """A pocket of a rectangular table: the middle of its mouth, its axis as an angle, and what belongs to it.

    `sides` are the names of its jaws and of the two cushions that lead to it.
    """

    name: str
    x: float
    y: float
    axis: float
    away: float
    sides: frozenset[str]


def mouth(table: Table, kind: str) -> Mouth:
    """The corner pocket at the origin, or the side pocket on the cushion along x."""
    corners = table.geometry.corners
    at = 0 if kind == "corner" else 1
    name, knobs = corners[at].pocket, table.knobs
    sides = frozenset((f"{name} jaw", corners[at].cushion, corners[at - 1].cushion))
    if kind == "corner":
        deep = knobs.corner.mouth / math.sqrt(8.0)
        return Mouth(name, deep, deep, 225.0, _AWAY[kind], sides)
    return Mouth(name, 0.5 * knobs.table.length, 0.0, 270.0, _AWAY[kind], sides)


def falls(table: Table, to: Mouth, angle: float, beside: float, speed: float) -> bool:
    """Whether a ball falls that rolls towards a pocket `angle` degrees off its axis, to pass `beside` its middle.

    With a positive angle it comes to a corner pocket along the cushion along x. It has `speed` at the mouth, m/s. One
    that has met another cushion, or comes back further than it began, has not fallen; nor has one that would begin in
    a cushion.
    """
    way = math.radians(to.axis - angle)
    ux, uy = math.cos(way), math.sin(way)
    x, y = to.x - ux * to.away - uy * beside, to.y - uy * to.away + ux * beside
    knobs, radius = table.knobs, table.knobs.ball.radius
    if not table.has_room(x, y, radius, Layout()):
        return False
    first = math.sqrt(speed * speed + 2.0 * knobs.cloth.mu_roll * knobs.gravity * to.away)
    ball = Ball("1", x, y, first * ux, first * uy, -first * uy / radius, first * ux / radius)

    def over(event: Event) -> bool:
        if event.kind == "ball_pocket" or any(name not in to.sides for _, name in event.rails):
            return True
        after = event.after["1"]
        return math.hypot(after.x - to.x, after.y - to.y) > to.away + radius

    last = simulate(table, Layout([ball]), until=over).events[-1]
    return last.kind == "ball_pocket" and last.where == to.name


def ways(table: Table, kind: str, angle: float, speed: float, step: float = _STEP) -> list[tuple[float, float]]:
    """The bands of ways that fall, m beside the middle of a pocket's mouth, but those that are narrower than `step`."""
    to = mouth(table, kind)
    count = round(2.0 * _WIDE / step)
    places = [-_WIDE + (i + 0.5) * step for i in range(count)]
    hits = [falls(table, to, angle, place, speed) for place in places]
    edges = [
        _edge(table, to, angle, speed, (places[i], hits[i]), places[i + 1])
        for i in range(count - 1)
        if hits[i] != hits[i + 1]
    ]
    return list(zip(edges[::2], edges[1::2], strict=True))


def target(table: Table, kind: str, angle: float, speed: float, step: float = _STEP) -> float:
    """The width of the bands of ways that fall, together, m."""
    return math.fsum(b - a for a, b in ways(table, kind, angle, speed, step))


def _edge(table: Table, to: Mouth, angle: float, speed: float, known: tuple[float, bool], end: float) -> float:
    """Where, between a way that falls and one that does not, the one goes over into the other."""
    start, hit = known
    while abs(end - start) > _CLOSE:
        middle = 0.5 * (start + end)
        if falls(table, to, angle, middle, speed) == hit:
            start = middle
        else:
            end = middle
    return 0.5 * (start + end)


def _row(table: Table, kind: str, angle: float, speeds: Sequence[float], published: float | None) -> str:
    sizes = "".join(f"{target(table, kind, angle, speed) / INCH:8.2f}" for speed in speeds)
    return f"{angle:8.0f}{sizes}" + ("" if published is None else f"{published:12.2f}")


def _block(
    table: Table, kind: str, title: str, speeds: Sequence[float], published: Mapping[float, float]
) -> Iterator[str]:
    yield f"{title}: inches of target by degrees off the axis and m/s at the mouth"
    yield f"{'':8}" + "".join(f"{speed:8g}" for speed in speeds) + (f"{'published':>12}" if published else "")
    for angle in published or (TP_3_6 if kind == "corner" else TP_3_5):
        yield _row(table, kind, angle, speeds, published.get(angle))
    yield ""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", default=["pool-9ft"], help="presets whose own pockets are measured too")
    parser.add_argument("--speeds", type=float, nargs="+", default=SPEEDS, metavar="V", help="at the mouth, m/s")
    parser.add_argument("--set", action="append", default=[], metavar="KNOB=VALUE", help="a knob of all the tables")
    arguments = parser.parse_args()
    knobs = {name: float(value) for name, _, value in (entry.partition("=") for entry in arguments.set)}
    mirror = load_table("pool-9ft", {**MIRROR, **CORNER, **SIDE})
    his = load_table("pool-9ft", {**knobs, **CORNER, **SIDE})
    blocks = [
        (mirror, "corner", "TP 3.6, as mirrors", (2.0,), TP_3_6),
        (mirror, "side", "TP 3.5, as mirrors", (2.0,), TP_3_5),
        (his, "corner", "TP 3.6, with the cushions of pool-9ft", arguments.speeds, TP_3_6),
        (his, "side", "TP 3.5, with the cushions of pool-9ft", arguments.speeds, TP_3_5),
    ]
    for name in arguments.tables:
        table = load_table(name, knobs)
        blocks += [(table, kind, f"{name}, {kind} pocket", arguments.speeds, {}) for kind in _AWAY]
    for table, kind, title, speeds, published in blocks:
        for line in _block(table, kind, title, speeds, published):
            print(line, flush=True)


if __name__ == "__main__":
    main()
