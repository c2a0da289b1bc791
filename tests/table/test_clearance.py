"""The least elevation: the reference tables, closed forms, and nothing gone through on any table."""

from __future__ import annotations

import math
import random

import pytest

from pool2d import Ball, Clearance, InputError, Layout, Shot, Table, least_elevation, load_table
from pool2d.physics.cue.cue_body import BUTT, LENGTH, TIP, CueBody, root

from ..scenes import random_shot
from .cue_points import goes_through

POOL = load_table("pool-9ft")
R, NOSE = POOL.knobs.ball.radius, POOL.knobs.cushion.nose_height
CUSHION = POOL.reach(R)
OUTLINES = ("pool-9ft", "l-shape", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft")


def least(table: Table, balls: list[Ball], shot: Shot) -> Clearance:
    return least_elevation(table, Layout(balls), shot)


def tells(found: Clearance, degrees: float, within: float, over: str) -> bool:
    return found.elevation == pytest.approx(degrees, abs=within) and found.over == over


def at(d: float) -> list[Ball]:
    """A cue ball so far, m, from the left cushion's nose."""
    return [Ball("cue", d, 0.5)]


@pytest.mark.parametrize(
    ("d", "degrees"),
    [
        (CUSHION, (5.5, 29, 54)),
        (0.05, (3.2, 16, 30)),
        (0.1, (1.8, 8.3, 15)),
        (0.2, (1.1, 4.3, 7.6)),
        (0.3, (0.8, 3.0, 5.2)),
        (0.5, (0.6, 1.9, 3.2)),
        (1.0, (0.5, 1.1, 1.8)),
    ],
)
def test_over_a_cushion_as_the_reference_has_it(d: float, degrees: tuple[float, ...]) -> None:
    for height, expected in zip((0.4, 0.0, -0.4), degrees, strict=True):
        found = least(POOL, at(d), Shot(height=height))
        assert tells(found, expected, 0.06 if expected < 10.0 else 0.5, "left")


@pytest.mark.parametrize(
    ("gap", "centre", "follow"),
    [(0.0, 38, 25), (0.02, 27, 18), (0.05, 19, 13), (0.1, 13, 9), (0.2, 8, 6), (0.5, 4, 3)],
)
def test_over_a_ball_as_the_reference_has_it(gap: float, centre: float, follow: float) -> None:
    """It tells whole degrees, and takes the cue as thick as it is one distance of the balls behind the tip.

    That is more than where it touches, nearer to the tip: by up to 0.3 degrees.
    """
    d = 2.0 * R + gap
    balls = [Ball("cue", 1.4, 0.5), Ball("7", 1.4 - d, 0.5)]
    for height, told in ((0.0, centre), (0.4, follow)):
        thick = TIP + (BUTT - TIP) / LENGTH * d
        reference = math.degrees(math.asin((R + thick - height * R) / d))
        assert round(reference) == told
        found = least(POOL, balls, Shot(height=height))
        assert tells(found, reference - 0.2, 0.2, "7")


@pytest.mark.parametrize("height", [-0.7, -0.3, 0.0, 0.2])
@pytest.mark.parametrize("d", [CUSHION, 0.04, 0.3, 0.9])
def test_square_to_a_cushion_it_is_the_tangent_from_the_nose(d: float, height: float) -> None:
    """sin(e - phi) rho + b R = r: the nose is as far from the cue's line as the cue is thick there."""
    rho, phi = math.hypot(d, NOSE - R), math.atan2(NOSE - R, d)
    taper = (BUTT - TIP) / LENGTH
    e = math.radians(least(POOL, at(d), Shot(height=height)).elevation or 0.0)
    along = rho * math.cos(e - phi) - R * math.sqrt(1.0 - height * height)
    assert rho * math.sin(e - phi) + height * R == pytest.approx(TIP + taper * along, abs=1e-12)


@pytest.mark.parametrize("gap", [0.0, 0.03, 0.4])
def test_straight_over_a_ball_it_is_the_tangent_to_it(gap: float) -> None:
    """The ball's centre is R from the cone's side, which is r cos k from the cue's line."""
    d, k = 2.0 * R + gap, math.atan((BUTT - TIP) / LENGTH)
    found = least(POOL, [Ball("cue", 1.4, 0.5), Ball("7", 1.4 - d, 0.5)], Shot(height=0.1))
    e = math.radians(found.elevation or 0.0)
    along = d * math.cos(e) - R * math.sqrt(0.99)
    thick = TIP + (BUTT - TIP) / LENGTH * along
    assert d * math.sin(e) + 0.1 * R == pytest.approx(R / math.cos(k) + thick, abs=1e-12)


def test_with_nothing_behind_the_ball_the_cue_is_level() -> None:
    far = least(POOL, [Ball("cue", 1.8, 0.635), Ball("1", 2.0, 0.635)], Shot(height=0.3))
    assert far == (0.0, "")
    assert least(POOL, at(CUSHION), Shot(angle=180.0)) == (0.0, ""), "the cushion is ahead, the butt over the cloth"
    assert least(POOL, at(CUSHION), Shot(angle=0.0, easy=True)) == (0.0, ""), "an easy stroke's cue is in nobody's way"


def test_what_is_raised_enough_stays_as_it_is() -> None:
    assert least(POOL, at(CUSHION), Shot(elevation=40.0)) == (40.0, "")
    forced = least(POOL, at(CUSHION), Shot(elevation=3.0))
    assert forced.over == "left" and forced.elevation == least(POOL, at(CUSHION), Shot()).elevation
    again = least(POOL, at(CUSHION), Shot(elevation=forced.elevation or 0.0))
    assert again == (forced.elevation, ""), "what it says is enough"


def test_a_pockets_mouth_has_no_nose() -> None:
    """Behind it the rail goes on: at the back of the hole."""
    corner = [Ball("cue", 0.06, 0.06)]
    through = least(POOL, corner, Shot(angle=45.0))
    assert through.over == "bottom-left back"
    back = 0.06 * math.sqrt(2.0) + POOL.knobs.corner.shelf - POOL.knobs.corner.mouth / 2.0
    back += 2.0 * POOL.knobs.corner.drop_radius
    square = least(POOL, at(back), Shot()).elevation
    # The hole's edge bends away from its middle, which is what is met.
    assert through.elevation == pytest.approx(square, abs=0.01)
    assert (through.elevation or 0.0) < 0.6 * (least(POOL, corner, Shot(angle=0.0)).elevation or 0.0)
    side = [Ball("cue", 1.27, 0.05)]
    assert least(POOL, side, Shot(angle=90.0)).over == "bottom-side back"
    assert least(POOL, [Ball("cue", 1.0, 0.05)], Shot(angle=90.0)).over == "bottom-left"


def test_it_may_pass_below_where_a_ball_leans_out() -> None:
    """Beside a ball's middle the cue is clear level, is stopped by it when raised, and is clear again above."""
    beside = [Ball("cue", 1.8, 0.6), Ball("7", 1.6, 0.6 - 0.0345)]
    assert tells(least(POOL, beside, Shot(height=-0.5)), 0.0, 0.05, "cloth")
    raised = least(POOL, beside, Shot(height=-0.5, elevation=4.0))
    assert raised.over == "7" and (raised.elevation or 0.0) > 4.5


def test_what_has_gone_is_not_in_the_way() -> None:
    balls = [Ball("cue", 1.8, 0.5), Ball("7", 1.7, 0.5, phase="pocketed"), Ball("8", 1.6, 0.5, phase="off")]
    assert least(POOL, balls, Shot()) == (0.0, "")


def test_a_tip_that_cannot_be_reached_has_no_elevation() -> None:
    assert tells(least(POOL, at(CUSHION), Shot(height=-0.7)), 82.9, 0.5, "left")
    assert least(POOL, at(CUSHION), Shot(height=-0.8)) == (None, "left")
    giant = [Ball("cue", 1.4, 0.6), Ball("7", 1.4 - 2.0 * math.sqrt(R * 0.06), 0.6, radius=0.06)]
    assert least(POOL, giant, Shot(height=-0.6)) == (None, "7")


def test_the_butt_clears_the_cloth_too() -> None:
    """A level tip so low has its butt in the bed: that is 15 mm thick, and hangs lower than the tip."""
    found = least(POOL, [Ball("cue", 1.9, 0.635)], Shot(height=-0.7))
    e = math.radians(found.elevation or 0.0)
    butt = R * math.sqrt(1.0 - 0.49) + LENGTH
    assert found.over == "cloth"
    assert R + butt * math.sin(e) - (0.7 * R + BUTT) * math.cos(e) == pytest.approx(0.0, abs=1e-12)


def test_what_is_wrong_is_told() -> None:
    with pytest.raises(InputError, match=r"shot\.ball = '7': unknown; known are cue"):
        least(POOL, at(0.5), Shot(ball="7"))
    with pytest.raises(InputError, match=r"shot\.elevation = 91"):
        least(POOL, at(0.5), Shot(elevation=91.0))
    with pytest.raises(InputError, match="off the table"):
        least(POOL, at(-0.5), Shot())


@pytest.mark.parametrize("name", OUTLINES)
def test_the_least_goes_through_nothing_and_less_does(name: str) -> None:
    table = load_table(name)
    radius = table.knobs.ball.radius
    forced = 0
    for seed in range(8):
        rng = random.Random(f"{name} {seed}")
        layout, _ = random_shot(table, seed, 16)
        while seed % 2 and table.element_gap(layout["cue"].x, layout["cue"].y, radius)[0] > 0.04:
            x, y = (rng.uniform(0.0, size) for size in (table.knobs.table.length, table.knobs.table.width))
            if table.has_room(x, y, radius, layout, "cue"):
                layout = layout.put(Ball("cue", x, y))
        far, way = 0.7 * math.sqrt(rng.random()), rng.uniform(0.0, math.tau)
        shot = Shot(rng.uniform(0.0, 360.0), 2.0, far * math.cos(way), far * math.sin(way))
        found = least_elevation(table, layout, shot)
        assert found.elevation is not None
        # A point of the cloud may be some tenths of a millimetre inside what the cue touches.
        assert not goes_through(table, layout, shot, found.elevation, slack=5e-4), (seed, found)
        if found.elevation > 0.3:
            forced += 1
            assert goes_through(table, layout, shot, max(0.0, found.elevation - 1.5)), (seed, found)
    assert forced >= 3


@pytest.mark.parametrize("angle", [0.0, 37.0, 90.0, 200.0])
def test_a_mirrored_table_needs_the_same(angle: float) -> None:
    layout = [Ball("cue", 0.1, 0.1), Ball("1", 0.2, 0.16)]
    mirrored = [ball._replace(y=POOL.knobs.table.width - ball.y) for ball in layout]
    one = least(POOL, layout, Shot(angle, side=0.3, height=-0.2))
    other = least(POOL, mirrored, Shot(-angle, side=-0.3, height=-0.2))
    assert one.elevation == pytest.approx(other.elevation, abs=1e-9)


def test_raising_the_butt_turns_the_cue_about_the_ball() -> None:
    """A point turned with it stays as far from its side."""
    cue = CueBody(R, 0.2, -0.3)
    for turn in (0.0, 0.4, 1.2):
        x, z = 0.3 * math.cos(turn) - 0.02 * math.sin(turn), 0.3 * math.sin(turn) + 0.02 * math.cos(turn)
        assert cue.gap(x, 0.01, z, turn) == pytest.approx(cue.gap(0.3, 0.01, 0.02, 0.0), abs=1e-15)


def test_a_root_is_found_to_the_last_bits() -> None:
    assert root(math.cos, 0.0, 3.0) == pytest.approx(math.pi / 2.0, abs=1e-15)
    assert root(lambda x: x**9, -1.0, 2.0) == pytest.approx(0.0, abs=1e-15)
    assert root(lambda x: x - 0.25, 0.25, 1.0) == 0.25
