"""The default table: its numbers, its geometry as built, and what it answers."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given, reject
from hypothesis import strategies as st

from pool2d import Ball, BudgetError, InputError, Layout, Table, WorkerError, load_table, simulate
from pool2d.physics.detect import Jaw, Rail
from pool2d.physics.values import POCKETED
from pool2d.table.outline import Corner, distance_to_edge
from pool2d.table.preset import presets

TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
POCKETS = {pocket.name: pocket for pocket in TABLE.geometry.pockets}


def test_regulation_sizes() -> None:
    knobs = TABLE.knobs
    assert knobs.table.length == pytest.approx(100 * 0.0254)
    assert knobs.table.width == pytest.approx(50 * 0.0254)
    assert knobs.ball.radius == pytest.approx(2.25 * 0.0254 / 2)
    assert 5.5 <= knobs.ball.mass / 0.0283495 <= 6.0
    assert knobs.cushion.nose_height / (2 * knobs.ball.radius) == pytest.approx(0.635, rel=1e-5)
    assert 4.5 <= knobs.corner.mouth / 0.0254 <= 4.625
    assert 5.0 <= knobs.side.mouth / 0.0254 <= 5.125
    assert TABLE.furniture.spots == {"head": (0.635, 0.635), "center": (1.27, 0.635), "foot": (1.905, 0.635)}
    assert TABLE.furniture.head_string == TABLE.furniture.spots["head"][0]


def test_cushions_carry_the_names_of_where_they_are() -> None:
    middles = {name: (rail.ax + rail.dx * rail.length / 2, rail.ay + rail.dy * rail.length / 2)
               for rail in TABLE.elements if isinstance(rail, Rail) and "jaw" not in (name := rail.name)}  # fmt: skip
    assert middles.keys() == TABLE.geometry.cushions.keys()
    for name, (x, y) in middles.items():
        if "left" in name:
            assert x < 1.27
        if "right" in name:
            assert x > 1.27
        if "bottom" in name:
            assert y == pytest.approx(0.0)
        if "top" in name:
            assert y == pytest.approx(1.27)
    assert len(middles) == 6
    assert len(POCKETS) == 6


SHARP = TABLE.with_knobs({"corner.jaw_radius": 0.0, "side.jaw_radius": 0.0})


def tips(table: Table, pocket: str) -> list[Jaw]:
    return [jaw for jaw in table.elements if isinstance(jaw, Jaw) and jaw.name == f"{pocket} jaw"]


def facings(table: Table, pocket: str) -> list[Rail]:
    return [rail for rail in table.elements if isinstance(rail, Rail) and rail.name == f"{pocket} jaw"]


def noses(table: Table) -> list[Rail]:
    return [rail for rail in table.elements if isinstance(rail, Rail) and "jaw" not in rail.name]


@pytest.mark.parametrize("name", POCKETS)
def test_pocket_is_built_as_its_numbers_say(name: str) -> None:
    """Mouth between the tips of unrounded jaws, shelf from there to the hole, facings at their angle."""
    knobs = SHARP.knobs.side if "side" in name else SHARP.knobs.corner
    hole = next(pocket for pocket in SHARP.geometry.pockets if pocket.name == name)
    a, b = tips(SHARP, name)
    assert math.hypot(a.x - b.x, a.y - b.y) == pytest.approx(knobs.mouth)
    assert hole.radius == knobs.drop_radius
    shelf = math.hypot(hole.x - (a.x + b.x) / 2, hole.y - (a.y + b.y) / 2) - hole.radius
    assert shelf == pytest.approx(knobs.shelf)
    assert math.hypot(hole.x - a.x, hole.y - a.y) == pytest.approx(math.hypot(hole.x - b.x, hole.y - b.y))
    for facing in facings(SHARP, name):
        (tip,) = (jaw for jaw in (a, b) if abs(facing.gap(jaw.x, jaw.y, 0.0)) < 1e-9)
        (nose,) = (nose for nose in noses(SHARP) if abs(nose.gap(tip.x, tip.y, 0.0)) < 1e-9)
        # From the tip, along the nose and along the facing.
        angles = []
        for rail in (nose, facing):
            sign = 1.0 if math.hypot(rail.ax - tip.x, rail.ay - tip.y) < 1e-9 else -1.0
            angles.append(math.atan2(sign * rail.dy, sign * rail.dx))
        between = abs(math.degrees(math.remainder(angles[0] - angles[1], math.tau)))
        assert between == pytest.approx(knobs.angle)


@pytest.mark.parametrize("name", POCKETS)
def test_rounding_is_tangent_to_nose_and_facing(name: str) -> None:
    jaws = tips(TABLE, name)
    assert len(jaws) == 2
    for jaw in jaws:
        assert jaw.radius == (TABLE.knobs.side if "side" in name else TABLE.knobs.corner).jaw_radius
        for rails in (noses(TABLE), facings(TABLE, name)):
            # The line's end is where the circle touches it, and the circle lies behind it.
            rail = min(rails, key=lambda rail: min(map(math.hypot, *zip(*ends(rail, jaw), strict=True))))
            (x, y) = min(ends(rail, jaw), key=lambda end: math.hypot(*end))
            assert math.hypot(x, y) == pytest.approx(jaw.radius)
            assert (x, y) == pytest.approx((-rail.dy * jaw.radius, rail.dx * jaw.radius))


def ends(rail: Rail, jaw: Jaw) -> list[tuple[float, float]]:
    """The ends of a nose as seen from a jaw's centre."""
    return [(rail.ax - jaw.x, rail.ay - jaw.y), (rail.bx - jaw.x, rail.by - jaw.y)]


@pytest.mark.parametrize("name", POCKETS)
def test_ball_sent_at_a_pocket_drops_at_its_rim(name: str) -> None:
    hole = POCKETS[name]
    x, y = 1.27 + 0.3 * (hole.x - 1.27), 0.635
    dx, dy = hole.x - x, hole.y - y
    size = math.hypot(dx, dy)
    roll = simulate(TABLE, Layout([Ball("cue", x, y, 3.0 * dx / size, 3.0 * dy / size)]))
    assert [(e.kind, e.where) for e in roll.events if e.kind.startswith("ball")] == [("ball_pocket", name)]
    end = roll.layout()["cue"]
    assert end.phase == POCKETED
    assert math.hypot(end.x - hole.x, end.y - hole.y) == pytest.approx(hole.radius)


@pytest.mark.parametrize(
    ("knobs", "key"),
    [
        ({"corner.mouth": 0.3, "corner.drop_radius": 0.2, "side.mouth": 0.3, "side.drop_radius": 0.2,
          "table.width": 0.3}, "corner.mouth, side.mouth"),
        ({"corner.angle": 170.0, "corner.shelf": 0.1}, "corner.angle"),
        ({"side.angle": 165.0}, "side.angle"),
        ({"corner.drop_radius": 0.03}, "corner.drop_radius"),
        ({"side.mouth": 0.2}, "side.drop_radius"),
        ({"side.jaw_radius": 0.2}, "side.jaw_radius"),
        ({"cushion.nose_height": 0.06}, "cushion.nose_height"),
        ({"ball.radius": 0.018}, "cushion.nose_height"),
    ],
)  # fmt: skip
def test_sizes_that_contradict_each_other_are_refused(knobs: dict[str, float], key: str) -> None:
    with pytest.raises(InputError) as caught:
        TABLE.with_knobs(knobs)
    assert caught.value.key == key


@given(
    mouth=st.floats(0.08, 0.2), angle=st.floats(120.0, 150.0), shelf=st.floats(0.0, 0.1), drop=st.floats(0.02, 0.1),
    off=st.floats(-0.04, 0.04), way=st.floats(-10.0, 10.0),
)  # fmt: skip
def test_nothing_gets_past_a_hole(
    mouth: float, angle: float, shelf: float, drop: float, off: float, way: float
) -> None:
    """Any corner that can be built keeps a ball sent into it, or drops it."""
    sizes = {"corner.mouth": mouth, "corner.angle": angle, "corner.shelf": shelf, "corner.drop_radius": drop}
    try:
        table = TABLE.with_knobs(sizes)
    except InputError:
        reject()
    turn = math.radians(45.0 + way)
    # Toward the corner, from half a metre before it and beside its axis.
    x, y = 2.54 - 0.5 * math.cos(turn) - off, 1.27 - 0.5 * math.sin(turn) + off
    roll = simulate(table, Layout([Ball("cue", x, y, 3.0 * math.cos(turn), 3.0 * math.sin(turn))]))
    for event in roll.events:
        assert all(table.on_cloth(state.x, state.y) for state in event.after.values()), event


def test_least_hole_is_told() -> None:
    for angle in (110.0, 142.0):
        with pytest.raises(InputError, match=r"allowed is 0\.\d+ m or more") as caught:
            TABLE.with_knobs({"corner.angle": angle, "corner.drop_radius": 0.03})
        least = float(caught.value.allowed.split()[-4])
        with pytest.raises(InputError):
            TABLE.with_knobs({"corner.angle": angle, "corner.drop_radius": least - 1e-4})
        TABLE.with_knobs({"corner.angle": angle, "corner.drop_radius": least + 1e-4})


def test_changed_copy_leaves_the_table_as_it_was() -> None:
    copy = TABLE.with_knobs({"cloth.mu_roll": 0.02}).with_knobs({"table.length": 2.0})
    assert (TABLE.knobs.cloth.mu_roll, TABLE.knobs.table.length) == (0.01, 2.54)
    assert (copy.knobs.cloth.mu_roll, copy.knobs.table.length) == (0.02, 2.0)
    assert copy.set == {"cloth.mu_roll": 0.02, "table.length": 2.0}
    assert max(pocket.x for pocket in copy.geometry.pockets) < 2.1


@pytest.mark.parametrize("quarters", range(4))
def test_the_outline_goes_round_an_inner_corner_from_nose_to_nose(tmp_path: Path, quarters: int) -> None:
    corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.0), (0.0, 0.0), (0.0, 0.5), (-0.5, 0.5)]
    for _ in range(quarters):
        corners = [(-y, x) for x, y in corners]
    lines = [f"[[outline]]\nx = {x + 0.5}\ny = {y + 0.5}\ncushion = 'side {i}'" for i, (x, y) in enumerate(corners)]
    (tmp_path / "l.toml").write_text("\n".join(["base = 'carom-10ft'", *lines]), encoding="utf-8")
    table = load_table(str(tmp_path / "l.toml"))
    inner = next(one for one in table.elements if isinstance(one, Jaw) and not one.name.endswith("jaw"))
    arc = [point for point in table.geometry.outline if math.dist(point, (inner.x, inner.y)) < 1.5 * inner.radius]
    assert len(arc) > 2
    assert [math.dist(point, (inner.x, inner.y)) for point in arc] == pytest.approx([inner.radius] * len(arc))
    # In small steps all the way, which is a quarter of a circle.
    assert max(math.dist(one, other) for one, other in pairwise(arc)) < inner.radius / 3.0
    for end in (arc[0], arc[-1]):
        assert any(
            math.dist(end, tip) < 1e-9
            for one in table.elements
            if isinstance(one, Rail)
            for tip in ((one.ax, one.ay), (one.bx, one.by))
        )


@pytest.mark.parametrize(
    ("x", "y", "distance"), [(1.5, 2.0, 0.0), (-3.0, -4.0, 5.0), (6.0, 8.0, 5.0), (0.7, 2.4, 0.88), (2.3, 1.6, 0.88)]
)
def test_distance_to_a_slanting_edge(x: float, y: float, distance: float) -> None:
    edge = (Corner(0.0, 0.0, "a"), Corner(3.0, 4.0, "b"))
    assert distance_to_edge(x, y, edge) == pytest.approx(distance, abs=1e-12)
    assert distance_to_edge(x, y, edge[::-1]) == pytest.approx(distance, abs=1e-12)


@pytest.mark.parametrize("name", presets())
def test_a_table_goes_to_another_process_as_what_it_was_made_of(name: str) -> None:
    table = load_table(name, {"cloth.mu_roll": 0.0123}, ["worn-cloth"])
    packed = pickle.dumps(table)
    back = pickle.loads(packed)
    assert (back.source, back.title, back.set, back.conditions) == (
        table.source, table.title, table.set, table.conditions,
    )  # fmt: skip
    assert (back.base, back.knobs, back.furniture) == (table.base, table.knobs, table.furniture)
    assert back.near(0.0, 0.0, 0.1, 0.1) == table.near(0.0, 0.0, 0.1, 0.1) != []
    assert len(packed) < 8_000


def test_errors_come_from_another_process_whole() -> None:
    for error in (
        InputError("a.toml", "x", 3, "allowed is 2", 7),
        BudgetError(5, 1.5, {"table": "x"}),
        WorkerError(3, "no"),
    ):
        back = pickle.loads(pickle.dumps(error))
        assert (type(back), str(back), vars(back)) == (type(error), str(error), vars(error))
