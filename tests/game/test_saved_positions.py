"""Positions that are kept and mirrored."""

from __future__ import annotations

import pytest

from pool2d import Ball, InputError, Layout, Shot, load_table
from pool2d.game.saved_positions import load, positions, save
from pool2d.physics.values import POCKETED
from pool2d.table.placing import mirrored


def test_a_position_is_kept_to_the_bit() -> None:
    table = load_table("pool-8ft", {"cloth.mu_roll": 0.0125})
    layout = table.rack("eight-ball", 3)
    layout = layout.put(layout["8"]._replace(phase=POCKETED))
    assert positions() == []
    save("after the break", table, layout, Shot(3.0, 4.0, side=0.1))
    save("b", table, layout)
    assert positions() == ["after the break", "b"]
    kept = load("after the break")
    assert (dict(kept.layout), kept.shot, kept.table.knobs) == (dict(layout), Shot(3.0, 4.0, side=0.1), table.knobs)
    save("b", table, Layout([Ball("cue", 1.0, 0.5)]))
    assert list(load("b").layout) == ["cue"]


def test_bad_names_are_refused() -> None:
    table = load_table("pool-9ft")
    with pytest.raises(InputError, match="allowed is a plain file name"):
        save("../x", table, Layout())
    with pytest.raises(InputError, match="position = 'none'"):
        load("none")


def test_a_layout_is_mirrored_and_back() -> None:
    table = load_table("pool-9ft")
    layout = Layout([Ball("cue", 0.5, 0.25), Ball("1", 2.0, 1.0), Ball("2", -0.03, -0.03, phase=POCKETED)])
    other = mirrored(table, layout)
    assert [(ball.x, ball.y) for ball in other.on_table()] == [(0.5, 1.02), (2.0, pytest.approx(0.27))]
    assert [(ball.x, ball.y) for ball in mirrored(table, layout, ends=True).on_table()] == [(2.04, 0.25), (0.54, 1.0)]
    back = mirrored(table, other)
    for name, ball in layout.items():
        assert (back[name].x, back[name].y) == pytest.approx((ball.x, ball.y))
        assert back[name].phase == ball.phase


def test_what_does_not_fit_in_the_mirror_is_refused() -> None:
    table = load_table("l-shape")
    size = table.knobs.table
    places = [(x * size.length, y * size.width) for x in (0.1, 0.9) for y in (0.1, 0.9)]
    x, y = next((x, y) for x, y in places if table.on_surface(x, y) and not table.on_surface(x, size.width - y))
    with pytest.raises(InputError, match="off the table"):
        mirrored(table, Layout([Ball("cue", x, y)]))
