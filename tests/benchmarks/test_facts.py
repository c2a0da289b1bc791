"""What the documents say that the presets amount to at the table."""

from __future__ import annotations

import pytest

from benchmarks.facts import lengths, rebound
from pool2d import load_table


@pytest.mark.parametrize("name", ["pool-7ft", "pool-8ft", "pool-9ft", "chinese-8ball-9ft", "pyramid-12ft", "l-shape"])
def test_pool_cushions(name: str) -> None:
    """docs/physics.md; measured on real tables: 0.55 to 0.60 square, 54 degrees from 45."""
    square, oblique = rebound(load_table(name), 0.0), rebound(load_table(name), 45.0)
    assert (square.off, square.settled) == pytest.approx((0.89, 0.57), abs=5e-3)
    assert (oblique.way_off, oblique.way_settled) == pytest.approx((38.7, 53.5), abs=5e-2)


@pytest.mark.parametrize("name", ["carom-10ft", "english-7ft", "snooker-12ft"])
def test_other_cushions(name: str) -> None:
    assert 0.55 <= rebound(load_table(name), 0.0).settled <= 0.6
    assert rebound(load_table(name), 45.0).way_settled == pytest.approx(54.0, abs=4.0)


def test_a_ball_runs_the_lengths_that_its_cloth_lets_it() -> None:
    """Rolling resistance takes v^2 = 2 mu g s along the way, a cushion its part of the speed."""
    table = load_table("pool-9ft")
    kept, knobs = rebound(table, 0.0, 2.0).settled, table.knobs
    speed, way, count = 3.5, knobs.table.length - 2.0 * table.reach(knobs.ball.radius), 0.0
    drag = 2.0 * knobs.cloth.mu_roll * knobs.gravity
    while speed * speed > drag * way:
        speed = kept * (speed * speed - drag * way) ** 0.5
        count += 1.0
    # The ball starts a little way up the table, and slides on a way after each cushion.
    assert lengths(table) == pytest.approx(count + speed * speed / drag / way, abs=0.25)
