"""No ball on the cloth gets off any table; `python -m benchmarks.escape` plays many more."""

from __future__ import annotations

import math
import random

import pytest

from benchmarks.escape import escapes
from pool2d import InputError, Table, load_table
from pool2d.config.catalogue import TABLES, shipped
from pool2d.table.furniture import Furniture
from pool2d.table.outline import Corner

from ..scenes import random_shot

SHOTS = 60


@pytest.mark.parametrize("name", shipped(TABLES))
def test_balls_stay_on_the_table(name: str) -> None:
    table = load_table(name)
    for seed in range(SHOTS):
        assert not escapes(table, *random_shot(table, 100_000 + seed, 2 + seed % 15)), seed


def any_outline(rng: random.Random) -> tuple[Corner, ...]:
    """Corners round a middle, some of them with pockets."""
    corners = []
    for i, angle in enumerate(sorted(rng.uniform(0.0, math.tau) for _ in range(rng.randrange(3, 9)))):
        far = rng.uniform(0.15, 0.5)
        pocket = f"pocket-{i}" if rng.random() < 0.4 else ""
        corners.append(Corner(0.5 + far * math.cos(angle), 0.5 + far * math.sin(angle), f"cushion-{i}", pocket))
    return tuple(corners)


def test_balls_stay_on_any_table_that_can_be_built() -> None:
    knobs = load_table("pool-9ft").base
    built = 0
    for seed in range(300):
        rng = random.Random(seed)
        sizes = {
            "table.length": rng.uniform(1.0, 4.0),
            "table.width": rng.uniform(1.0, 3.0),
            "table.nose_radius": rng.choice([0.0, 0.01, 0.05]),
            "corner.angle": rng.uniform(100.0, 165.0),
            "corner.mouth": rng.uniform(0.07, 0.15),
            "corner.shelf": rng.uniform(0.0, 0.06),
            "corner.drop_radius": rng.uniform(0.05, 0.1),
        }
        try:
            table = Table("any", "any", knobs, Furniture(outline=any_outline(rng)), sizes)
        except InputError:
            continue
        built += 1
        for number in range(6):
            assert not escapes(table, *random_shot(table, number, 1 + number)), (seed, number)
    assert built > 20
