"""What a knob may be, and what it is where a file leaves it out.

The ranges are written down here once more on purpose: presets, records and settings of any version hold values out of
them, which have to go on being read, and what lies outside has to go on being refused.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import pytest

from pool2d import InputError, load_table
from pool2d.config.knobs import Knob, walk
from pool2d.config.settings import Settings
from pool2d.physics.params import FacingKnobs, Physics
from pool2d.physics.strike import squirt
from pool2d.physics.values import SHOT_RANGES, Shot
from pool2d.table.placing import RANGES
from pool2d.table.table_knobs import Knobs

# By name: from, to.
ALLOWED: dict[str, tuple[float, float]] = {
    "gravity": (0.1, 30), "cloth.mu_slide": (0.01, 1), "cloth.mu_roll": (0.001, 0.2), "cloth.mu_spin": (0.001, 0.5),
    "cloth.bounce": (0, 1), "cloth.bounce_friction": (0, 1),
    "ball.radius": (0.01, 0.06), "ball.mass": (0.01, 2), "ball.restitution": (0, 1), "ball.friction": (0, 1),
    "ball.friction_a": (0, 1), "ball.friction_b": (0, 1), "ball.friction_c": (0, 20), "ball.cling": (0, 5),
    "cushion.restitution": (0, 1), "cushion.tangential": (0, 1), "cushion.friction": (0, 1),
    "cushion.nose_height": (0.01, 0.1),
    "facing.restitution": (0, 1), "facing.tangential": (0, 1), "facing.friction": (0, 5),
    "rail.width": (0.1, 0.5), "rail.height": (0, 0.05), "rail.restitution": (0, 0.95),
    "pocket.restitution": (0, 0.95), "pocket.friction": (0, 1),
    "cue.mass": (0.1, 2), "cue.end_mass": (0, 0.1), "cue.tip_restitution": (0, 1), "cue.tip_friction": (0.05, 10),
    "cue.follow_through": (0, 1),
    "jump_cue.mass": (0.1, 2), "jump_cue.tip_restitution": (0, 1),
    "table.length": (0.5, 30), "table.width": (0.3, 20), "table.nose_radius": (0, 0.5),
    "corner.mouth": (0.04, 0.3), "corner.angle": (95, 170), "corner.shelf": (0, 0.1), "corner.jaw_radius": (0, 0.2),
    "corner.drop_radius": (0.02, 0.2),
    "side.mouth": (0.04, 0.3), "side.angle": (90, 170), "side.shelf": (0, 0.06), "side.jaw_radius": (0, 0.2),
    "side.drop_radius": (0.02, 0.2),
    "sound.volume": (0, 1), "screen.width": (0, 16384), "screen.height": (0, 16384),
    "match.race": (1, 99), "match.breaker": (-2, 1),
    "x": (-100, 100), "y": (-100, 100), "z": (0, 10), "vx": (-50, 50), "vy": (-50, 50), "vz": (-50, 50),
    "wx": (-1000, 1000), "wy": (-1000, 1000), "wz": (-1000, 1000), "radius": (0.01, 0.06), "mass": (0.01, 2),
}  # fmt: skip
LONGEST = {
    "balls.palette": 40, "screen.language": 12, "players.first": 40, "players.second": 40,
    "players.first_by": 40, "players.second_by": 40,
    "match.game": 400, "match.table": 400, "match.breaks": 40,
}  # fmt: skip
SHOTS = {"angle": (-3600, 3600), "speed": (0, 50), "side": (-1, 1), "height": (-1, 1), "elevation": (0, 90)}


def every() -> Iterator[tuple[str, Knob]]:
    """All that has a range or a length: of a table, of the settings, of a ball."""
    for name, described, value in [*walk(Knobs()), *walk(Settings())]:
        if not described.choices and not isinstance(value, bool):
            yield name, described
    yield from RANGES.items()


@pytest.mark.parametrize(("name", "described"), [pytest.param(*each, id=each[0]) for each in every()])
def test_as_far_as_it_goes_and_no_further(name: str, described: Knob) -> None:
    assert name in (LONGEST if isinstance(described.default, str) else ALLOWED), "a new knob: write its range down here"
    if isinstance(described.default, str):
        allowed: list[float | str] = ["x" * LONGEST[name], ""]
        refused: list[float | str] = ["x" * (LONGEST[name] + 1)]
    else:
        lo, hi = ALLOWED[name]
        allowed, refused = [lo, hi], [math.nextafter(lo, -math.inf), math.nextafter(hi, math.inf)]
    for value in allowed:
        assert described.check(value, "", name) == value
    for value in refused:
        with pytest.raises(InputError, match=r"allowed is a (number|text)"):
            described.check(value, "", name)


@pytest.mark.parametrize("name", SHOT_RANGES)
def test_a_stroke_goes_as_far_and_no_further(name: str) -> None:
    for limit, beyond in zip(SHOTS[name], (-math.inf, math.inf), strict=True):
        Shot(**{name: limit}).check()  # type: ignore[arg-type]
        with pytest.raises(InputError, match=f"shot.{name} = .*: allowed is a number"):
            Shot(**{name: math.nextafter(limit, beyond)}).check()  # type: ignore[arg-type]


def test_what_a_preset_leaves_out_is_as_on_a_tournament_table_of_nine_feet() -> None:
    """But for the facings: left out, they are as the preset's own cushions."""
    assert replace(Knobs(), facing=load_table("pool-9ft").knobs.facing) == load_table("pool-9ft").knobs
    assert Knobs().facing == FacingKnobs(restitution=1.0, tangential=0.0, friction=1.0)


# Alciatore's list of physical properties; the WPA's specifications of equipment (1991, 2001); grams of an ounce.
OUNCE = 0.0283495
PUBLISHED = {
    "gravity": (9.78, 9.83),
    "cloth.mu_slide": (0.15, 0.4),
    "cloth.mu_roll": (0.005, 0.015),
    "ball.radius": (0.5 * 2.245 * 0.0254, 0.5 * 2.255 * 0.0254),
    "ball.mass": (5.5 * OUNCE, 6.0 * OUNCE),
    "ball.restitution": (0.92, 0.98),
    "ball.friction": (0.03, 0.08),
    # TP A.14, fitted to Marlow's measurements.
    "ball.friction_a": (9.951e-3, 9.951e-3),
    "ball.friction_b": (0.108, 0.108),
    "ball.friction_c": (1.088, 1.088),
    "ball.cling": (1.0, 1.0),
    "cushion.friction": (0.14, 0.2),
    "cushion.nose_height": (0.625 * 0.05715, 0.645 * 0.05715),
    "cue.mass": (18.0 * OUNCE, 21.0 * OUNCE),
    "cue.tip_restitution": (0.71, 0.75),
    "jump_cue.tip_restitution": (0.81, 0.87),
    "cue.tip_friction": (0.6, 0.7),
}


@pytest.mark.parametrize("name", PUBLISHED)
def test_the_defaults_are_those_of_real_equipment(name: str) -> None:
    value = {name: value for name, _, value in walk(Physics())}[name]
    lo, hi = PUBLISHED[name]
    assert isinstance(value, float) and lo <= value <= hi


def test_spin_about_the_vertical_slows_as_measured() -> None:
    # Alciatore: by 5 to 15 rad/s in a second.
    physics = Physics()
    assert 5.0 <= 2.5 * physics.cloth.mu_spin * physics.gravity / physics.ball.radius <= 15.0


def test_a_cue_squirts_as_cues_do() -> None:
    # 2 to 4 degrees at the miscue limit, by the make of the cue (Alciatore, TP A.31).
    physics = Physics()
    assert 2.0 <= math.degrees(squirt(0.5, 0.0, physics.ball.mass, physics.cue.end_mass)) <= 4.0
