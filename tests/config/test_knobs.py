"""Knobs: one description that validates, documents and names a parameter."""

from __future__ import annotations

import math
from dataclasses import FrozenInstanceError, dataclass, field

import pytest

from pool2d import InputError, load_table
from pool2d.config.knobs import Knob, apply, choice, knob, walk
from pool2d.errors import suggest
from pool2d.table.table_knobs import Knobs

POCKET = ("mouth", "angle", "shelf", "jaw_radius", "drop_radius")
CONTRACT = {
    "cloth": ("mu_slide", "mu_roll", "mu_spin"),
    "ball": ("radius", "mass", "restitution", "friction", "friction_a", "friction_b", "friction_c", "law"),
    "cushion": ("restitution", "tangential", "friction", "nose_height", "law"),
    "facing": ("restitution", "tangential", "friction"),
    "cue": ("mass", "end_mass", "tip_restitution", "tip_friction"),
    "table": ("length", "width"),
    "corner": POCKET,
    "side": POCKET,
}


@dataclass(frozen=True, slots=True)
class Inner:
    size: float = knob(1.0, 0.0, 2.0, "m", "how large")
    law: str = choice("one", ("one", "two"), "which law")


@dataclass(frozen=True, slots=True)
class Outer:
    speed: float = knob(5.0, 1.0, 10.0, "m/s", "how fast")
    inner: Inner = field(default_factory=Inner)


def test_contract_names_are_all_there() -> None:
    names = {f"{group}.{name}" for group, members in CONTRACT.items() for name in members}
    assert names | {"gravity"} <= {name for name, _, _ in walk(Knobs())}


@pytest.mark.parametrize(
    ("name", "described", "value"), list(walk(Knobs())), ids=[name for name, _, _ in walk(Knobs())]
)
def test_every_knob_describes_itself(name: str, described: Knob, value: float | str) -> None:
    assert described.doc
    assert described.default == value
    assert described.check(value, "", name) == value
    if not described.choices:
        assert described.lo < described.hi
        assert described.check(described.lo, "", name) == described.lo
        assert described.check(described.hi, "", name) == described.hi


def test_walk_gives_dotted_names_in_order() -> None:
    assert [(name, value) for name, _, value in walk(Outer())] == [
        ("speed", 5.0), ("inner.size", 1.0), ("inner.law", "one"),
    ]  # fmt: skip


def test_apply_sets_dotted_names_on_a_copy() -> None:
    old = Outer()
    new = apply(old, {"inner.size": 2, "speed": 1.5, "inner.law": "two"}, "here")
    assert new == Outer(1.5, Inner(2.0, "two"))
    assert isinstance(new.inner.size, float)
    assert old == Outer()
    with pytest.raises(FrozenInstanceError):
        new.speed = 3.0  # type: ignore[misc]


@pytest.mark.parametrize(
    "value", [2.1, -0.1, math.nan, math.inf, -math.inf, True, None, "1", [1.0], 10**400, -(10**400)]
)
def test_wrong_values_are_refused_with_what_is_allowed(value: object) -> None:
    with pytest.raises(InputError) as caught:
        apply(Outer(), {"inner.size": value}, "a.toml")
    error = caught.value
    assert (error.source, error.key, error.value) == ("a.toml", "inner.size", value)
    assert error.allowed == "allowed is a number from 0 to 2 m"
    assert str(error).startswith("a.toml: inner.size = ")
    assert len(str(error)) < 200


@pytest.mark.parametrize("value", ["three", 1.0, None, ["one"]])
def test_wrong_choices_are_refused_with_the_choices(value: object) -> None:
    with pytest.raises(InputError, match="allowed is one of one, two"):
        apply(Outer(), {"inner.law": value}, "a.toml")


@pytest.mark.parametrize("name", ["inner", "inner.", "", "speed.size", "inner.size.x"])
def test_names_of_nothing_are_refused(name: str) -> None:
    with pytest.raises(InputError) as caught:
        apply(Outer(), {name: 1.0}, "a.toml")
    assert caught.value.key == name


def test_unknown_name_suggests_the_nearest() -> None:
    with pytest.raises(InputError, match=r"inner\.sise = 1\.0: unknown; did you mean inner\.size\?"):
        apply(Outer(), {"inner.sise": 1.0}, "a.toml")
    assert suggest("zzz", ["b", "a"]) == "unknown; known are a, b"


def test_message_is_one_line_whatever_it_quotes() -> None:
    error = InputError("a\nb.toml", "x\ty", "one\ntwo" * 50, "allowed is less")
    assert str(error).isprintable()
    assert str(error.at("other")).startswith("other: x")


def test_table_takes_its_knobs_so() -> None:
    with pytest.raises(InputError, match=r"cloth\.mu_rol = 1: unknown; did you mean cloth\.mu_roll\?"):
        load_table("pool-9ft").with_knobs({"cloth.mu_rol": 1})


def test_nothing_can_be_set_to_give_back_more_than_it_takes() -> None:
    """Restitutions, and what rubber gives back along itself, go from nothing to all of it: energy only falls."""
    giving = [
        (name, described)
        for name, described, _ in walk(Knobs())
        if name.rpartition(".")[2] in ("restitution", "tip_restitution", "tangential", "bounce")
    ]
    assert len(giving) >= 8
    for name, described in giving:
        assert described.lo == 0.0 and 0.9 < described.hi <= 1.0, name


def test_what_nothing_is_said_of_is_a_pool_table() -> None:
    """By WPA's specifications and what Alciatore gathered: each within the range that is published for it."""
    published = {
        "gravity": (9.78, 9.84),
        "cloth.mu_slide": (0.15, 0.4),
        "cloth.mu_roll": (0.005, 0.015),
        "ball.radius": (0.02851, 0.0286375),
        "ball.mass": (0.156, 0.17),
        "ball.restitution": (0.92, 0.98),
        "ball.friction": (0.03, 0.08),
        "ball.friction_a": (9.951e-3, 9.951e-3),
        "ball.friction_b": (0.108, 0.108),
        "ball.friction_c": (1.088, 1.088),
        "cushion.restitution": (0.6, 0.95),
        "cue.mass": (0.4, 0.7087),
        "cue.tip_restitution": (0.71, 0.75),
        "jump_cue.tip_restitution": (0.81, 0.87),
    }
    values = {name: value for name, _, value in walk(Knobs())}
    for name, (least, most) in published.items():
        value = values[name]
        assert isinstance(value, float) and least <= value <= most + 1e-12, name
    # The nose stands at 63.5 % of a ball's height, give or take one.
    nose, diameter = values["cushion.nose_height"], 2.0 * 0.028575
    assert isinstance(nose, float) and 0.625 <= nose / diameter <= 0.645
