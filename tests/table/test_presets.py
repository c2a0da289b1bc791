"""Every shipped preset: its sizes, its racks, and its pockets as built."""

from __future__ import annotations

import math
import tomllib

import pytest

from pool2d import Ball, Layout, Table, load_table, simulate
from pool2d.config.catalogue import CONDITIONS, TABLES, find, shipped
from pool2d.config.knobs import walk
from pool2d.physics.detect import Jaw, Pocket, Rail
from pool2d.table.preset import conditions

from ..checks import misplaced

NAMES = shipped(TABLES)
TABLE = {name: load_table(name) for name in NAMES}
RACKS = [(name, rack) for name in NAMES for rack in TABLE[name].furniture.racks]
POCKETS = [(name, pocket.name) for name in NAMES for pocket in TABLE[name].geometry.pockets]
INCH = 0.0254
LARGEST = 0.06

# Length, width, radius and mass of a ball, corner and side mouth in m and kg, each as (least, most); sources
# are in the files. None is what no source was read for.
SIZES = {
    "pool-9ft": (
        (100 * INCH,) * 2,
        (50 * INCH,) * 2,
        (0.028575,) * 2,
        (0.156, 0.17),
        (0.1143, 0.1175),
        (0.127, 0.1302),
    ),
    "pool-8ft": ((92 * INCH,) * 2, (46 * INCH,) * 2, (0.028575,) * 2, (0.156, 0.17), (0.1143, 0.1175), (0.127, 0.1302)),
    "pool-7ft": ((78 * INCH,) * 2, (39 * INCH,) * 2, (0.028575,) * 2, (0.156, 0.17), (0.118,) * 2, (0.137,) * 2),
    "snooker-12ft": ((3.569,) * 2, (1.778,) * 2, (0.02625,) * 2, (0.1406,) * 2, (0.083, 0.086), (0.087, 0.095)),
    "carom-10ft": ((2.84,) * 2, (1.42,) * 2, (0.0305, 0.03075), (0.205, 0.22), None, None),
    "english-7ft": (
        (1.8288, 2.1336),
        (0.9144, 1.0668),
        (0.0254,) * 2,
        (0.114, 0.118),
        (0.0781, 0.085),
        (0.0781, 0.095),
    ),
    "pyramid-12ft": ((3.55,) * 2, (1.775,) * 2, (0.034, 0.03425), (0.285,) * 2, (0.072, 0.073), (0.082, 0.083)),
    "chinese-8ball-9ft": ((2.54,) * 2, (1.27,) * 2, (0.028575,) * 2, (0.156, 0.17), (0.084, 0.086), (0.086, 0.09)),
}


@pytest.mark.parametrize("name", SIZES)
def test_sizes_are_those_of_the_rules(name: str) -> None:
    knobs = TABLE[name].knobs
    have = (
        knobs.table.length, knobs.table.width, knobs.ball.radius, knobs.ball.mass, knobs.corner.mouth, knobs.side.mouth,
    )  # fmt: skip
    for value, allowed in zip(have, SIZES[name], strict=True):
        assert allowed is None or allowed[0] - 1e-9 <= value <= allowed[1] + 1e-9


def test_every_regulation_table_is_there() -> None:
    assert {*SIZES, "l-shape"} <= set(NAMES)


@pytest.mark.parametrize(
    ("name", "spot", "place"),
    [
        ("pool-8ft", "foot", (0.75 * 92 * INCH, 23 * INCH)),
        ("pool-7ft", "foot", (0.75 * 78 * INCH, 19.5 * INCH)),
        ("snooker-12ft", "black", (3.569 - 0.324, 0.889)),
        ("snooker-12ft", "blue", (3.569 / 2, 0.889)),
        ("snooker-12ft", "pink", (3.569 * 0.75, 0.889)),
        ("snooker-12ft", "yellow", (0.737, 0.889 - 0.292)),
        ("snooker-12ft", "green", (0.737, 0.889 + 0.292)),
        ("carom-10ft", "foot", (2.13, 0.71)),
        ("carom-10ft", "left", (0.71, 0.71 + 0.1825)),
        ("english-7ft", "black", (0.75 * 1.83, 0.4575)),
        ("pyramid-12ft", "foot", (0.75 * 3.55, 0.8875)),
    ],
)
def test_spots_are_where_the_rules_have_them(name: str, spot: str, place: tuple[float, float]) -> None:
    assert TABLE[name].furniture.spots[spot] == pytest.approx(place, abs=1e-4)


def test_cushions_of_snooker_and_carom_are_as_fitted() -> None:
    snooker, carom = TABLE["snooker-12ft"].knobs, TABLE["carom-10ft"].knobs
    assert snooker.cushion.nose_height == pytest.approx(1.4 * snooker.ball.radius)
    assert (snooker.cushion.restitution, snooker.cushion.friction) == (0.98, 0.14)
    assert (snooker.cloth.mu_slide, snooker.cloth.mu_roll) == (0.212, 0.0127)
    assert (carom.cushion.restitution, carom.cushion.friction, carom.cushion.nose_height) == (0.877, 0.2, 0.037)
    # The two halves of the tracked shots, fitted alone.
    assert 0.13 <= carom.cushion.tangential <= 0.17
    assert 0.945 <= carom.ball.restitution <= 0.951
    assert 0.043 <= carom.ball.friction_a <= 0.05
    assert 0.16 <= carom.ball.friction_b <= 0.18
    assert 0.62 <= carom.ball.friction_c <= 0.67
    assert 0.0044 <= carom.cloth.mu_spin <= 0.0046
    assert snooker.ball.restitution == 0.89


def test_english_cue_ball_is_smaller() -> None:
    table = TABLE["english-7ft"]
    assert table.body_of(Ball("cue", 0.0, 0.0)) == (0.0238, 0.094)
    assert table.body_of(Ball("red1", 0.0, 0.0)) == (0.0254, 0.116)
    assert table.body_of(Ball("cue", 0.0, 0.0, radius=0.03)) == (0.03, 0.094)


@pytest.mark.parametrize(("name", "rack"), RACKS)
def test_racks_fit(name: str, rack: str) -> None:
    table = TABLE[name]
    for seed in range(6):
        layout = table.rack(rack, seed)
        assert not misplaced(table, layout)
        assert table.furniture.cue in layout
        assert table.settle(layout) == layout


@pytest.mark.parametrize(
    ("name", "rack", "count", "middle"),
    [
        ("pool-9ft", "nine-ball", 9, "9"),
        ("pool-9ft", "ten-ball", 10, "10"),
        ("pool-9ft", "straight-pool", 15, None),
        ("english-7ft", "eight-ball", 15, "black"),
        ("snooker-12ft", "snooker", 21, None),
        ("carom-10ft", "carom", 2, None),
        ("pyramid-12ft", "pyramid", 15, None),
    ],
)
def test_racks_hold_what_the_game_wants(name: str, rack: str, count: int, middle: str | None) -> None:
    table = TABLE[name]
    for seed in range(6):
        layout = table.rack(rack, seed)
        assert len(layout) == count + 1
        if middle is not None:
            third = sorted((ball for ball in layout.values() if ball.id != "cue"), key=lambda ball: ball.x)[3:6]
            assert sorted(third, key=lambda ball: ball.y)[1].id == middle
    if rack in ("nine-ball", "ten-ball"):
        assert {ball for ball in layout if ball != "cue"} == {str(number + 1) for number in range(count)}


@pytest.mark.parametrize(
    ("name", "rack", "ball", "spot"),
    [
        ("english-7ft", "eight-ball", "black", "black"),
        ("pool-9ft", "nine-ball", "9", "foot"),
        ("pool-9ft", "ten-ball", "1", "foot"),
    ],
)
def test_a_ball_stands_on_its_spot(name: str, rack: str, ball: str, spot: str) -> None:
    table = TABLE[name]
    placed = table.rack(rack)[ball]
    assert (placed.x, placed.y) == pytest.approx(table.furniture.spots[spot], abs=1e-4)


@pytest.mark.parametrize("name", NAMES)
def test_spots_have_room(name: str) -> None:
    table = TABLE[name]
    assert table.furniture.spots
    for x, y in table.furniture.spots.values():
        assert table.has_room(x, y, table.knobs.ball.radius, Layout())


def ends_of(table: Table, name: str) -> list[tuple[Rail, Rail]]:
    """The two noses that lead to a pocket, each with its facing."""
    facings = [one for one in table.elements if isinstance(one, Rail) and one.name == f"{name} jaw"]
    jaws = [one for one in table.elements if isinstance(one, Jaw) and one.name == f"{name} jaw"]
    noses = [one for one in table.elements if isinstance(one, Rail) and "jaw" not in one.name]
    assert (len(facings), len(jaws)) == (2, 2)
    found = []
    for jaw in jaws:
        nose, facing = (min(rails, key=lambda rail: off_tangent(rail, jaw)) for rails in (noses, facings))
        found.append((nose, facing))
    return found


def off_tangent(rail: Rail, jaw: Jaw) -> float:
    """How far the nearest end of a rail is from touching a jaw, m."""
    return min(abs(math.hypot(x - jaw.x, y - jaw.y) - jaw.radius) for x, y in ((rail.ax, rail.ay), (rail.bx, rail.by)))


def crossing(a: Rail, b: Rail) -> tuple[float, float]:
    """Where the lines of two rails cross."""
    part = ((b.ax - a.ax) * b.dy - (b.ay - a.ay) * b.dx) / (a.dx * b.dy - a.dy * b.dx)
    return a.ax + part * a.dx, a.ay + part * a.dy


def hole(table: Table, name: str) -> Pocket:
    return next(pocket for pocket in table.geometry.pockets if pocket.name == name)


def axis(table: Table, name: str) -> tuple[tuple[float, float], tuple[float, float]]:
    """The middle of a pocket's mouth, and the unit vector from there into the pocket."""
    (ax, ay), (bx, by) = (crossing(*end) for end in ends_of(table, name))
    x, y = (ax + bx) / 2, (ay + by) / 2
    pocket = hole(table, name)
    size = math.hypot(pocket.x - x, pocket.y - y)
    return (x, y), ((pocket.x - x) / size, (pocket.y - y) / size)


@pytest.mark.parametrize(("name", "pocket"), POCKETS)
def test_mouths_are_as_wide_as_the_file_says(name: str, pocket: str) -> None:
    table = TABLE[name]
    side = next(corner.kind == "side" for corner in table.geometry.corners if corner.pocket == pocket)
    mouth = table.knobs.side.mouth if side else table.knobs.corner.mouth
    assert math.dist(*(crossing(*end) for end in ends_of(table, pocket))) == pytest.approx(mouth, abs=1e-9)


@pytest.mark.parametrize(("name", "pocket"), POCKETS)
def test_a_ball_sent_in_along_the_axis_drops(name: str, pocket: str) -> None:
    table = TABLE[name]
    (x, y), (dx, dy) = axis(table, pocket)
    for speed in (1.0, 6.0):
        ball = Ball("cue", x - 0.2 * dx, y - 0.2 * dy, speed * dx, speed * dy)
        events = simulate(table, Layout([ball])).events
        assert [(e.kind, e.where) for e in events if e.kind.startswith("ball")] == [("ball_pocket", pocket)]


@pytest.mark.parametrize(("name", "pocket"), POCKETS)
def test_a_ball_wider_than_the_throat_does_not_get_in(name: str, pocket: str) -> None:
    """One that just passes is a millimetre smaller than one that does not, if there are balls that large."""
    table = TABLE[name]
    (x, y), (dx, dy) = axis(table, pocket)
    drop = hole(table, pocket)
    deep = math.hypot(drop.x - x, drop.y - y) - drop.radius
    # How far the noses and facings leave room on the axis, from before the mouth to the rim.
    steps = [(x + dx * at, y + dy * at) for at in (-0.05 + (deep + 0.05) * i / 200 for i in range(201))]
    width = min(
        rail.gap(px, py, 0.0) for px, py in steps for rail in table.elements if rail.name == f"{pocket} jaw"
    )  # fmt: skip
    for reach in (width - 0.0005, width + 0.0005):
        radius = min(LARGEST, radius_of(table, reach))
        roll = simulate(table, Layout([Ball("cue", x - 0.2 * dx, y - 0.2 * dy, dx, dy, radius=radius)]))
        first = next(event for event in roll.events if event.where)
        passes = table.reach(radius) < width
        # It is on the axis: what holds it up are both jaws at once.
        assert (first.kind, len(first.rails)) == (("ball_pocket", 0) if passes else ("cluster", 2))


def radius_of(table: Table, reach: float) -> float:
    """The ball that touches a nose at that distance in plan."""
    nose = table.knobs.cushion.nose_height
    return (reach * reach / nose + nose) / 2.0


@pytest.mark.parametrize("name", NAMES)
def test_cushions_close_the_outline(name: str) -> None:
    """Cast from a spot all round, a ball always meets something."""
    table = TABLE[name]
    x, y = table.furniture.spots["head"]
    for degrees in range(360):
        way = math.radians(degrees + 0.5)
        distance, what = table.cast(x, y, math.cos(way), math.sin(way), Layout())
        assert what is not None
        assert distance < math.hypot(table.knobs.table.length, table.knobs.table.width)


def test_inner_corner_of_the_l_is_rounded() -> None:
    table = TABLE["l-shape"]
    (jaw,) = (one for one in table.elements if isinstance(one, Jaw) and "jaw" not in one.name)
    radius = table.knobs.table.nose_radius
    assert jaw.radius == radius
    assert (jaw.x, jaw.y) == pytest.approx((1.27 + radius, 0.9525 + radius))
    assert not table.on_surface(1.9, 1.4)
    assert not table.has_room(1.9, 1.4, 0.028, Layout())
    # A ball on the diagonal meets the rounding, square.
    roll = simulate(table, Layout([Ball("cue", 1.0, 0.6825, 0.7, 0.7)]))
    hit = next(event for event in roll.events if event.kind == "ball_cushion")
    after = hit.after["cue"]
    assert after.vx == pytest.approx(after.vy)
    assert after.vx < 0.0


@pytest.mark.parametrize("name", conditions())
def test_conditions_go_with_every_table(name: str) -> None:
    data = tomllib.loads(find(CONDITIONS, name).read_text())
    for preset in NAMES:
        table = load_table(preset, conditions=[name])
        have = {full: value for full, _, value in walk(table.knobs)}
        for group, values in data.items():
            assert group == "name" or all(have[f"{group}.{key}"] == value for key, value in values.items())
        assert table.scenario(Layout(), None)["conditions"] == [name]
        assert table.furniture == TABLE[preset].furniture


def test_conditions_lie_over_the_preset_and_below_what_is_set() -> None:
    table = load_table("snooker-12ft", {"cloth.mu_slide": 0.4}, ["worn-cloth", "heated"])
    assert (table.knobs.cloth.mu_slide, table.knobs.cloth.mu_roll) == (0.4, 0.0044)
    assert table.knobs.cushion.friction == 0.14
    assert table.with_knobs({"ball.mass": 0.2}).conditions == ("worn-cloth", "heated")
