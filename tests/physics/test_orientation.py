"""How balls turn: closed forms, an independent integration, and that it is a value."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.physics.orientation import FACING, BallRotation, Quaternion, matrix, product, turn, unit

from ..scenes import random_shot

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
GRAVITY = TABLE.knobs.gravity
CLOTH = TABLE.knobs.cloth


def angle_between(a: Quaternion, b: Quaternion) -> float:
    """The angle of the turn from one orientation to the other, rad."""
    w, x, y, z = product(a, (b[0], -b[1], -b[2], -b[3]))
    return 2.0 * math.atan2(math.sqrt(x * x + y * y + z * z), abs(w))


def roll_of(vx: float = 0.0, vy: float = 0.0, wx: float = 0.0, wy: float = 0.0, wz: float = 0.0) -> Rollout:
    return simulate(TABLE, Layout([Ball("cue", 1.27, 0.635, vx, vy, wx, wy, wz)]))


def test_a_turn_of_any_length_is_told_by_one_of_length_one() -> None:
    rng = random.Random("units")
    for _ in range(50):
        axis = [rng.gauss(0.0, 1.0) for _ in range(3)]
        angle, size = rng.uniform(0.1, 3.0), rng.uniform(0.1, 20.0)
        long = math.hypot(*axis)
        x, y, z = (part / long for part in axis)
        half = math.sin(0.5 * angle)
        known = (math.cos(0.5 * angle), half * x, half * y, half * z)
        w, a, b, c = known
        scaled = (size * w, size * a, size * b, size * c)
        assert unit(scaled) == pytest.approx(known, abs=1e-14)
        assert turn(angle * x, angle * y, angle * z) == pytest.approx(known, abs=1e-14)
        # Rodrigues: v cos + (k x v) sin + k (k v) (1 - cos), for each axis.
        cos, sin = math.cos(angle), math.sin(angle)
        cross = ((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0))
        for i, row in enumerate(matrix(scaled)):
            for j, value in enumerate(row):
                k = (x, y, z)
                assert value == pytest.approx(
                    (cos if i == j else 0.0) + sin * cross[i][j] + (1.0 - cos) * k[i] * k[j], abs=1e-14
                )


@pytest.mark.parametrize("way", [0.0, 37.0, 90.0, 200.0, 311.0])
def test_a_rolling_ball_turns_by_its_way_over_its_radius(way: float) -> None:
    vx, vy = 0.3 * math.cos(math.radians(way)), 0.3 * math.sin(math.radians(way))
    rollout = roll_of(vx=vx, vy=vy, wx=-vy / RADIUS, wy=vx / RADIUS)
    turning = BallRotation(rollout, {})
    for t in (0.1, 0.7, rollout.duration):
        ball = rollout.ball_at("cue", t)
        angle = math.dist((ball.x, ball.y), (1.27, 0.635)) / RADIUS
        rolled = turn(-angle * vy / 0.3, angle * vx / 0.3, 0.0)
        assert angle_between(turning.at("cue", t), rolled) < 1e-9
    # What was on top has gone forward and down.
    quarter = next(t for t in range(1, 10000) if math.dist(rollout.path("cue", 1e-3)[t][1:], (1.27, 0.635)) > 0.02)
    top = [row[2] for row in matrix(turning.at("cue", quarter * 1e-3))]
    assert top[0] * vx + top[1] * vy > 0.0
    assert top[2] < 0.8


@pytest.mark.parametrize("spin", [30.0, -12.0])
def test_a_spinning_ball_turns_about_the_vertical(spin: float) -> None:
    rollout = roll_of(wz=spin)
    fall = 2.5 * CLOTH.mu_spin * GRAVITY / RADIUS
    for t in (0.2, 0.8 * rollout.duration, rollout.duration):
        angle = math.copysign(abs(spin) * t - 0.5 * fall * t * t, spin)
        assert angle_between(BallRotation(rollout, {}).at("cue", t), turn(0.0, 0.0, angle)) < 1e-9


def test_a_ball_pushed_without_spin_begins_to_turn_as_it_slides() -> None:
    rollout = roll_of(vx=1.0)
    t = 0.9 * rollout.tracks["cue"][0].t1
    angle = 0.5 * 2.5 * CLOTH.mu_slide * GRAVITY / RADIUS * t * t
    assert angle_between(BallRotation(rollout, {}).at("cue", t), turn(0.0, angle, 0.0)) < 1e-9


@pytest.mark.parametrize(
    "state",
    [
        {"vx": 0.8, "wx": 40.0, "wy": -60.0, "wz": 80.0},
        {"vx": 0.5, "wy": 0.5 / RADIUS, "wz": 60.0},
        {"vy": -0.4, "wx": 25.0, "wy": 70.0, "wz": -30.0},
        # Its spin about the vertical runs out on the way.
        {"vx": 0.5, "vy": 0.2, "wx": -0.2 / RADIUS, "wy": 0.5 / RADIUS, "wz": 6.0},
    ],
)
def test_where_the_axis_moves_small_steps_agree(state: dict[str, float]) -> None:
    rollout = roll_of(**state)
    turning = BallRotation(rollout, {})
    orientation, t, step = FACING, 0.0, 5e-5
    # Before any cushion, which would change the spin within a step.
    end = 1.3
    while t + step <= end:
        ball = rollout.ball_at("cue", t + 0.5 * step)
        orientation = product(turn(step * ball.wx, step * ball.wy, step * ball.wz), orientation)
        t += step
    assert angle_between(turning.at("cue", t), orientation) < 2e-5


@pytest.mark.parametrize("seed", [3, 8])
def test_any_order_of_asking_gives_the_same_orthonormal_orientations(seed: int) -> None:
    rollout = simulate(TABLE, *random_shot(TABLE, seed))
    start = {ball: turn(0.3, 0.1 * i, -0.2) for i, ball in enumerate(rollout.start)}
    rng = random.Random(seed)
    times = [rng.uniform(-0.1, rollout.duration + 0.1) for _ in range(40)] + [event.t for event in rollout.events]
    rng.shuffle(times)
    shuffled, forward = BallRotation(rollout, start), BallRotation(rollout, start)
    known = {t: forward.orientations(t) for t in sorted(times)}
    assert forward.orientations(0.0).keys() == rollout.start.keys()
    for t in times:
        lies = shuffled.orientations(t)
        assert lies == known[t] == BallRotation(rollout, start).orientations(t)
        for orientation in lies.values():
            rows = matrix(orientation)
            for i in range(3):
                for j in range(3):
                    dot = sum(a * b for a, b in zip(rows[i], rows[j], strict=True))
                    assert dot == pytest.approx(float(i == j), abs=1e-12)


def test_orientation_never_jumps() -> None:
    rollout = simulate(TABLE, *random_shot(TABLE, 3))
    turning = BallRotation(rollout, {})
    assert rollout.events
    for event in rollout.events:
        before, after = turning.orientations(event.t - 1e-7), turning.orientations(event.t + 1e-7)
        assert all(angle_between(before[ball], after[ball]) < 1e-4 for ball in before)


def test_it_starts_as_it_is_told_and_ends_where_the_shot_ends() -> None:
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.6), Ball("2", 2.0, 1.0)])
    rollout = simulate(TABLE, layout, Shot(speed=2.0, side=0.3))
    start = {"cue": turn(1.0, 2.0, 0.5), "2": (2.0, 0.0, 2.0, 0.0)}
    turning = BallRotation(rollout, start)
    assert turning.at("cue", -1.0) == turning.at("cue", 0.0)
    assert angle_between(turning.at("cue", 0.0), start["cue"]) < 1e-12
    assert turning.at("1", 0.0) == FACING
    assert turning.at("2", 1.0) == unit(start["2"])
    assert turning.orientations(math.inf) == turning.orientations(rollout.duration)
    assert turning.orientations(math.inf)["1"] != FACING
