"""The quick look at a whole layout: it passes what stands free, and nothing else."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, load_table
from pool2d.physics.body import Body
from pool2d.physics.standing import Limits, in_range, inside, stand_apart

TABLE = load_table("pool-9ft")
RADIUS, SLACK = TABLE.knobs.ball.radius, 1e-10
REACH = TABLE.reach(RADIUS)


def stands(*places: tuple[float, float], radius: float = RADIUS) -> bool:
    bodies = [
        Body(Ball(str(i), x, y), i, size, 0.17, TABLE.reach(size))
        for i, (x, y, size) in enumerate((x, y, RADIUS if i else radius) for i, (x, y) in enumerate(places))
    ]
    return stand_apart(bodies, list(TABLE.elements), TABLE.surface, SLACK)


LIMITS = Limits(
    place=100.0, speed=50.0, spin=1000.0, least_radius=0.01, most_radius=0.06, least_mass=0.02, most_mass=2.0
)
WITHIN = {
    "x": (-100.0, 100.0), "y": (-100.0, 100.0), "vx": (-50.0, 50.0), "vy": (-50.0, 50.0),
    "wx": (-1000.0, 1000.0), "wy": (-1000.0, 1000.0), "wz": (-1000.0, 1000.0),
    "radius": (0.01, 0.06), "mass": (0.02, 2.0),
}  # fmt: skip


@pytest.mark.parametrize("name", WITHIN)
def test_every_number_may_go_to_its_limit_and_no_further(name: str) -> None:
    def fits(value: float, reach: float = 0.01) -> bool:
        state = {"x": 1.0, "y": 0.5, "radius": 0.03, "mass": 0.17, name: value}
        own = {key: number for key, number in state.items() if key not in ("radius", "mass")}
        good, ball = Ball("2", 0.3, 0.3), Ball("1", **own)  # type: ignore[arg-type]
        bodies = [Body(good, 0, 0.03, 0.17, 0.03), Body(ball, 1, state["radius"], state["mass"], reach)]
        return in_range(bodies, LIMITS) and in_range(bodies[::-1], LIMITS)

    least, most = WITHIN[name]
    assert fits(least) and fits(most)
    assert not fits(math.nextafter(least, -math.inf)) and not fits(math.nextafter(most, math.inf))
    assert not fits(math.nan)
    # A ball that is lower than the cushion's nose has no reach.
    assert not fits(most, 0.0)


@pytest.mark.parametrize("gap", [0.01, 1e-9, 0.0, -0.9e-10, -1.1e-10, -1e-6])
@pytest.mark.parametrize("turn", [0.0, 0.7, 1.57, 3.0, 4.4])
@pytest.mark.parametrize("other", [RADIUS, 0.035])
def test_balls_may_touch_but_not_overlap(gap: float, turn: float, other: float) -> None:
    away = 2.0 * math.sqrt(RADIUS * other) + gap
    pair = (1.2, 0.6), (1.2 + away * math.cos(turn), 0.6 + away * math.sin(turn))
    assert stands(*pair, (0.3, 0.3), radius=other) is (gap > -SLACK)
    assert stands(*pair, (2.3, 0.3), radius=other) is (gap > -SLACK)


@pytest.mark.parametrize("gap", [0.01, 0.0, -0.9e-10, -1.1e-10, -1e-6])
def test_a_ball_may_touch_a_cushion_but_not_lie_in_it(gap: float) -> None:
    assert stands((1.0, REACH + gap)) is (gap > -SLACK)


@pytest.mark.parametrize("place", [(-0.01, 0.6), (1.0, -0.2), (3.0, 3.0), (0.0, 0.0)])
def test_a_ball_off_the_cloth_or_in_a_pocket_does_not_stand(place: tuple[float, float]) -> None:
    assert not stands(place)


def test_none_of_many_is_overlooked() -> None:
    """One that is drawn into another, somewhere in a full table."""
    rng = random.Random(5)
    places: list[tuple[float, float]] = []
    while len(places) < 120:
        place = rng.uniform(0.1, 2.4), rng.uniform(0.1, 1.1)
        if all(math.dist(place, other) > 2.0 * RADIUS for other in places):
            places.append(place)
    assert stands(*places)
    for x, y in places:
        turn = rng.uniform(0.0, math.tau)
        into = x + 1.9 * RADIUS * math.cos(turn), y + 1.9 * RADIUS * math.sin(turn)
        assert not stands(*places, into)


def test_inside_counts_the_edges_that_a_ray_crosses() -> None:
    horseshoe = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (2.0, 2.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
    found = {(x, y) for x in (-0.5, 0.5, 1.5, 2.5, 3.5) for y in (-0.5, 0.5, 1.5, 2.5) if inside(x, y, horseshoe)}
    assert found == {(0.5, 0.5), (1.5, 0.5), (2.5, 0.5), (0.5, 1.5), (2.5, 1.5)}
