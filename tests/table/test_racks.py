"""Racks: what the rules fix, what the seed draws, and that the balls fit."""

from __future__ import annotations

import itertools
import math

import pytest

from pool2d import InputError, load_table

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
SOLIDS, STRIPES = ({str(n) for n in numbers} for numbers in (range(1, 8), range(9, 16)))


def rows(seed: int) -> list[list[str]]:
    """The rack as rows from the apex, each from low y to high."""
    balls = sorted((ball for ball in TABLE.rack("eight-ball", seed).values() if ball.id != "cue"), key=lambda b: b.x)
    filled = []
    for count in range(1, 6):
        row, balls = balls[:count], balls[count:]
        filled.append([ball.id for ball in sorted(row, key=lambda b: b.y)])
    return filled


@pytest.mark.parametrize("seed", range(20))
def test_eight_ball_rack_keeps_the_rules(seed: int) -> None:
    rack = rows(seed)
    assert sorted(itertools.chain(*rack), key=int) == [str(n) for n in range(1, 16)]
    assert rack[0] == ["1"]
    assert rack[2][1] == "8"
    corners = {rack[4][0], rack[4][-1]}
    assert len(corners & SOLIDS) == len(corners & STRIPES) == 1


def test_seed_draws_the_rest() -> None:
    assert rows(1) == rows(1)
    assert TABLE.rack("eight-ball", 1) == TABLE.rack("eight-ball", 1)
    assert len({str(rows(seed)) for seed in range(20)}) == 20
    # The corners are mirrored as often as not.
    assert {rows(seed)[4][0] in SOLIDS for seed in range(20)} == {True, False}


@pytest.mark.parametrize("seed", range(5))
def test_rack_stands_in_its_lattice(seed: int) -> None:
    layout = TABLE.rack("eight-ball", seed)
    gap, pitch = 0.0001, 2.0 * RADIUS + 0.0001
    x0, y0 = TABLE.furniture.spots["foot"]
    for i, row in enumerate(rows(seed)):
        for j, name in enumerate(row):
            x, y = x0 + i * pitch * math.sqrt(0.75), y0 + (j - i / 2.0) * pitch
            assert math.hypot(layout[name].x - x, layout[name].y - y) <= gap / 2.0 + 1e-9
    distances = [math.hypot(a.x - b.x, a.y - b.y) for a, b in itertools.combinations(layout.values(), 2)]
    assert min(distances) >= 2.0 * RADIUS - 1e-9
    # Thirty pairs in a triangle of fifteen stand side by side, no further apart than their play.
    assert sum(distance < pitch + gap + 1e-9 for distance in distances) == 30


def test_cue_ball_stands_on_the_head_spot() -> None:
    cue = TABLE.rack("eight-ball")["cue"]
    assert (cue.x, cue.y) == TABLE.furniture.spots["head"]


def test_unknown_rack_is_refused_with_the_nearest() -> None:
    with pytest.raises(InputError, match=r"pool-9ft: racks = 'eight_ball': unknown; did you mean eight-ball\?"):
        TABLE.rack("eight_ball")
