"""Snookered from hand: whether there is any place in the D, or in baulk, from which a ball on is seen at both edges."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest

from pool2d import Ball, Layout, Table, load_table
from pool2d.game.rules import game
from pool2d.game.rules.sight import Disc, snookered
from pool2d.game.rules.spotting import Where, may_place, put
from pool2d.game.rules.vantage import Area, Curve, StraightLine, _common, _meet, _on_the_way, vantage
from pool2d.physics.values import POCKETED
from pool2d.table.outline import Point

SNOOKER, ENGLISH = load_table("snooker-12ft"), load_table("english-7ft")
LINE, MIDDLE = SNOOKER.furniture.spots["head"]
TOUCH = 2.0 * SNOOKER.knobs.ball.radius


def alone(table: Table, rules: str, **places: Point) -> Layout:
    """Some balls at places; the others, and the cue ball, are off the table."""
    layout = Layout(ball._replace(phase=POCKETED) for ball in game(rules, table).start().layout.values())
    for ball, place in places.items():
        layout = put(layout, ball, place)
    return layout


def at_a_slit(half: float, from_y: float) -> Layout:
    """A red 2 m from a place on the baulk line, behind two balls that leave a slit on that way."""
    far, red = 2.0, (LINE + math.sqrt(4.0 - (from_y - MIDDLE) ** 2), MIDDLE)
    ux, uy = (LINE - red[0]) / far, (from_y - red[1]) / far
    x, y = red[0] + 0.06 * ux, red[1] + 0.06 * uy
    return alone(
        SNOOKER, "snooker", red1=red, pink=(x - half * uy, y + half * ux), black=(x + half * uy, y - half * ux)
    )


def least(far: float = 2.0, behind: float = 0.06) -> float:
    """How far from a way two balls must be, that stand so far before a ball at its end, to leave both edges in sight.

    The lines to the edges lean by asin(touch / far) towards the way, and pass each ball at a touch's distance.
    """
    return TOUCH * (2.0 - behind / far) / math.sqrt(1.0 - (TOUCH / far) ** 2)


@pytest.mark.parametrize("from_y", [MIDDLE, MIDDLE + 0.2, MIDDLE - 0.27])
def test_a_slit_of_two_micrometres_is_found(from_y: float) -> None:
    layout = at_a_slit(least() + 1e-6, from_y)
    place = vantage(SNOOKER, layout, layout["cue"], ("red1",), "d")
    assert place == pytest.approx((LINE, from_y), abs=2e-3)


def test_there_is_none_where_the_slit_is_too_narrow() -> None:
    """By symmetry the place on the way itself is the best, and the nearest on it."""
    layout = at_a_slit(least() - 1e-6, MIDDLE)
    assert vantage(SNOOKER, layout, layout["cue"], ("red1",), "d") is None


@pytest.mark.parametrize(("gap", "seen"), [(-1e-4, False), (1e-6, True)])
def test_the_only_place_is_beside_another_ball(gap: float, seen: bool) -> None:
    """The slit leads to the end of the baulk line, where the yellow leaves just room for a ball, or not quite."""
    end = SNOOKER.furniture.spots["yellow"][1]
    away = math.sqrt(0.5) * (TOUCH + gap)
    layout = put(at_a_slit(least() + 1e-6, end), "yellow", (LINE - away, end - away))
    found = vantage(SNOOKER, layout, layout["cue"], ("red1",), "d")
    assert (found is not None) is seen


@pytest.mark.parametrize(
    ("table", "rules", "where", "red"),
    [(SNOOKER, "snooker", "d", "red1"), (ENGLISH, "english-eight-ball", "kitchen", "red1")],
)
@pytest.mark.parametrize("place", [(1.5, 0.45), (1.2, 0.1), (0.9, 0.8)])
def test_a_ball_alone_on_the_table_is_seen(table: Table, rules: str, where: Where, red: str, place: Point) -> None:
    layout = alone(table, rules, **{red: place})
    found = vantage(table, layout, layout["cue"], (red,), where)
    assert found is not None and may_place(table, layout, "cue", where, *found)


def test_all_of_a_d_is_seen_from_where_no_pocket_is_near(tmp_path: Path) -> None:
    """Then only the baulk line and the bow bound where the cue ball may stand."""
    file = tmp_path / "plain.toml"
    file.write_text('base = "carom-10ft"\n[marks]\nhead_string = 0.7\nd_radius = 0.2\n')
    table = load_table(file)
    layout = Layout([Ball("cue", 1.5, 0.3), Ball("red", 2.0, 0.5)])
    found = vantage(table, layout, layout["cue"], ("red",), "d")
    assert found is not None and may_place(table, layout, "cue", "d", *found)


def drawn(table: Table, rules: str, rng: random.Random, on: int, others: int) -> tuple[Layout, tuple[str, ...]]:
    """Balls on all over the table, the others crowded round them, and which are on."""
    names = [ball for ball in game(rules, table).start().layout if ball != "cue"]
    ids = rng.sample(names, on + others)
    layout, radius = alone(table, rules), table.knobs.ball.radius
    size = table.knobs.table
    for i, ball in enumerate(ids):
        for _ in range(100):
            x, y = rng.uniform(0.0, size.length), rng.uniform(0.0, size.width)
            if i >= on:
                near, way = layout[ids[i % on]], rng.gauss(math.pi, 0.8)
                gap = rng.uniform(2.0, 3.3) * radius
                x, y = near.x + gap * math.cos(way), near.y + gap * math.sin(way)
            if table.on_surface(x, y) and table.has_room(x, y, radius, layout):
                layout = put(layout, ball, (x, y))
                break
    return layout, tuple(ball for ball in ids[:on] if layout[ball].phase != POCKETED)


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize(
    ("table", "rules", "where", "between"),
    [(SNOOKER, "snooker", "d", False), (ENGLISH, "english-eight-ball", "kitchen", True)],
)
def test_no_sample_finds_what_is_not_there(table: Table, rules: str, where: Where, between: bool, seed: int) -> None:
    """A place that is named is one; where none is named, none of many is."""
    rng = random.Random(f"{rules} {seed}")
    layout, on = drawn(table, rules, rng, 1 + seed % 2, 2 + seed % 5)
    cue, line = layout["cue"], table.furniture.spots["head"][0]
    place = vantage(table, layout, cue, on, where, between)
    if place is not None:
        assert not snookered(table, layout, cue._replace(x=place[0], y=place[1]), on, between=between)
        return
    for _ in range(300):
        x, y = rng.uniform(line - 0.4, line), rng.uniform(0.0, table.knobs.table.width)
        if may_place(table, layout, "cue", where, x, y):
            assert snookered(table, layout, cue._replace(x=x, y=y), on, between=between)


def off(curve: Curve, place: Point) -> float:
    """How far a place is from a curve, m."""
    if isinstance(curve, StraightLine):
        return abs(curve.nx * place[0] + curve.ny * place[1] - curve.far)
    return abs(math.dist((curve.x, curve.y), place) - curve.touch)


def test_where_two_curves_meet_lies_on_both() -> None:
    """Two lines that are not parallel meet once; a circle is met twice by what leads through it."""
    rng = random.Random("curves")

    def line(through: Point) -> StraightLine:
        nx, ny = math.cos(way := rng.uniform(0.0, math.tau)), math.sin(way)
        return StraightLine(nx, ny, nx * through[0] + ny * through[1])

    for _ in range(40):
        middle = rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)
        a, b, disc = line(middle), line((0.3, 0.2)), Disc(*middle, rng.uniform(0.1, 0.5))
        other = Disc(middle[0] + 0.8 * disc.touch, middle[1], 0.7 * disc.touch)
        for one, two, times in ((a, b, 1), (a, disc, 2), (disc, a, 2), (disc, other, 2), (other, disc, 2)):
            found = list(_meet(one, two))
            assert len(found) == times
            assert max(off(curve, place) for curve in (one, two) for place in found) < 1e-9
    assert not list(_meet(Disc(0.0, 0.0, 0.1), Disc(1.0, 0.0, 0.2)))
    assert not list(_meet(StraightLine(1.0, 0.0, 0.2), StraightLine(1.0, 0.0, 0.3)))


def test_a_disc_is_on_the_way_where_it_lies_between_the_ball_on_and_the_area() -> None:
    """By how far it is from each stretch of the line, from where that grazes the ball on to a corner round the area."""
    rng, layout = random.Random("ways"), alone(ENGLISH, "english-eight-ball")
    area, told = Area(ENGLISH, layout, layout["cue"], "kitchen"), set()
    left, low, right, high = area.box
    for _ in range(150):
        target, other = (Disc(rng.uniform(0.0, 1.8), rng.uniform(0.0, 0.9), TOUCH) for _ in range(2))
        for line in _common(target, other):
            far = line.nx * target.x + line.ny * target.y - line.far
            grazes = target.x - far * line.nx, target.y - far * line.ny
            gaps = [
                gap(other, grazes, (x - line.nx * off_line, y - line.ny * off_line))
                for x in (left, right)
                for y in (low, high)
                for off_line in [line.nx * x + line.ny * y - line.far]
            ]
            if min(gaps) <= other.touch + 1e-9 or min(gaps) > 2.0 * other.touch:
                told.add(min(gaps) <= 2.0 * other.touch)
                assert _on_the_way(area, target, other, line) is (min(gaps) <= 2.0 * other.touch)
    assert told == {True, False}


def gap(disc: Disc, a: Point, b: Point) -> float:
    """How far the middle of a disc is from a stretch of a line."""
    wx, wy = b[0] - a[0], b[1] - a[1]
    part = ((disc.x - a[0]) * wx + (disc.y - a[1]) * wy) / (wx * wx + wy * wy or 1.0)
    part = min(max(part, 0.0), 1.0)
    return math.dist((disc.x, disc.y), (a[0] + part * wx, a[1] + part * wy))
