"""No ball gets off any table; `python -m benchmarks.escape` plays many more."""

from __future__ import annotations

import pytest

from benchmarks.escape import escapes
from pool2d import load_table
from pool2d.library import TABLES, shipped

from .scenes import random_shot

SHOTS = 60


@pytest.mark.parametrize("name", shipped(TABLES))
def test_balls_stay_on_the_table(name: str) -> None:
    table = load_table(name)
    for seed in range(SHOTS):
        assert not escapes(table, *random_shot(table, 100_000 + seed, 2 + seed % 15)), seed
