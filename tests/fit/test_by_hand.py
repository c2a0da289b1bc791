"""Knobs from five measurements: what is measured on a table with known knobs gives them back."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from typing import Any

import pytest

from pool2d import InputError, Table, load_table
from pool2d.fit.by_hand import HandFits, fit_by_hand, places
from pool2d.fit.measurements import MEASUREMENTS, QUANTITIES, bare
from pool2d.fit.readings import Reading

from . import at_the_table

KNOBS = {"cloth.mu_roll": 0.0085, "cushion.restitution": 0.9, "cloth.mu_spin": 0.011, "cushion.friction": 0.19}
TRIALS = 8


def measured(table: Table) -> dict[str, float]:
    """All five measurements of a table, exactly."""
    seen: dict[str, float] = {"lag.seconds": at_the_table.lag(table)}
    seen["hard.lengths"], seen["hard.first"] = at_the_table.hard(table, 3.0)
    seen["spin.turns"], seen["spin.seconds"] = at_the_table.spin(table, 40.0)
    seen["oblique.leaves"] = at_the_table.oblique(table, 45.0, 0.8)
    seen["rebound.kept"] = at_the_table.rebound(table, 0.8, 0.3)
    # What is not at its default has to be told, as it is measured.
    seen["rebound.line"], seen["rebound.speed"] = 0.3, at_cushion(table, 0.8, 0.3)
    return seen


def at_cushion(table: Table, speed: float, line: float) -> float:
    return math.sqrt(speed * speed - 2.0 * table.knobs.cloth.mu_roll * table.knobs.gravity * line)


def as_readings(seen: dict[str, float]) -> dict[str, Reading]:
    return {name: Reading(value, QUANTITIES[name].error) for name, value in seen.items()}


def fitted(table: Table, **seen: float) -> HandFits:
    return fit_by_hand(table, as_readings({name.replace("_", "."): value for name, value in seen.items()}), "mine.toml")


@pytest.mark.parametrize("name", ["pool-9ft", "carom-10ft", "snooker-12ft"])
def test_what_is_measured_on_a_table_gives_its_knobs(name: str) -> None:
    table = load_table(name)
    found = fit_by_hand(table, as_readings(measured(table.with_knobs(KNOBS))), "here")
    assert {each.knob for each in found.knobs} == set(KNOBS)
    for each in found.knobs:
        assert each.now == pytest.approx(KNOBS[each.knob], rel=2e-3), each
        assert 0.0 < each.error < 0.25 * each.now
    assert found.strain == 1.0


@pytest.mark.parametrize("made", MEASUREMENTS, ids=lambda each: each.name)
def test_each_measurement_alone_gives_its_knob(made: Any) -> None:
    table = load_table("pool-9ft")
    truth = table.with_knobs({made.turns: KNOBS[made.turns]})
    seen = {name: value for name, value in measured(truth).items() if name.startswith(made.name + ".")}
    (found,) = fit_by_hand(table, as_readings(seen), "here").knobs
    assert (found.knob, found.by) == (made.turns, (made.name,))
    assert found.was == pytest.approx(dict(KNOBS, **{"cloth.mu_roll": 0.01})[found.knob], abs=0.1)
    assert found.now == pytest.approx(KNOBS[made.turns], rel=2e-3)


def noisy(table: Table, rng: random.Random) -> dict[str, Reading]:
    """Measurements as hands make them: every reading and every term is off by its error."""
    readings = {}
    for each in MEASUREMENTS:
        terms = {"hard.first": 0.5, "spin.seconds": 4.0}
        said = {part.name: terms.get(part.name, part.usual.value) for part in each.terms}
        done = {part.name: rng.gauss(said[part.name], part.error) for part in each.terms}
        # No ball lies or is looked at beyond the cushion.
        done.update({name: abs(done[name]) for name in ("lag.gap", "rebound.line") if name in done})
        readings.update({part.name: Reading(said[part.name], part.error) for part in each.terms if not part.assumed})
        readings[each.seen.name] = Reading(rng.gauss(each.play(table, done), each.seen.error), each.seen.error)
    return readings


def test_the_knobs_are_within_their_errors() -> None:
    rng = random.Random(5)
    table = load_table("pool-9ft")
    off = []
    for _ in range(TRIALS):
        knobs = {name: value * rng.uniform(0.9, 1.1) for name, value in KNOBS.items()}
        # What is not measured is off, too.
        truth = bare(table).with_knobs({**knobs, "cloth.mu_slide": rng.gauss(0.2, 0.04)})
        found = fit_by_hand(table, noisy(truth, rng), "here")
        off += [(each.now - knobs[each.knob]) / each.error for each in found.knobs]
    assert max(map(abs, off)) < 3.5
    spread = (sum(value * value for value in off) / len(off)) ** 0.5
    assert 0.6 < spread < 1.3


def test_a_better_measurement_gives_a_surer_knob() -> None:
    table = load_table("pool-9ft")
    readings = as_readings({"lag.seconds": 8.4})
    rough = fit_by_hand(table, readings, "here").knobs[0]
    fine = fit_by_hand(table, {"lag.seconds": replace(readings["lag.seconds"], error=0.02)}, "here").knobs[0]
    assert fine.now == pytest.approx(rough.now)
    assert fine.error < 0.8 * rough.error


def test_the_error_holds_all_that_may_be_off() -> None:
    """The reading, the angle at which the ball comes in, and the knobs that are not measured, by squares."""
    table = load_table("pool-9ft")
    (found,) = fitted(table, oblique_leaves=54.0).knobs
    here = bare(table).with_knobs({"cushion.friction": found.now})
    play = next(each.play for each in MEASUREMENTS if each.name == "oblique")

    def shown(angle: float = 45.0, **knobs: float) -> float:
        return play(
            here.with_knobs({name.replace("_", ".", 1): value for name, value in knobs.items()}),
            {"oblique.angle": angle},
        )

    knobs = table.knobs
    off = [
        1.0,
        shown(45.7) - shown(),
        shown(cloth_mu_slide=knobs.cloth.mu_slide - 0.04) - shown(),
        shown(cloth_mu_roll=knobs.cloth.mu_roll - 0.002) - shown(),
        shown(cushion_restitution=knobs.cushion.restitution - 0.04) - shown(),
        shown(cushion_tangential=knobs.cushion.tangential + 0.1) - shown(),
        shown(cushion_nose_height=knobs.cushion.nose_height - 0.0004) - shown(),
    ]
    slope = (shown(cushion_friction=found.now + 0.001) - shown(cushion_friction=found.now - 0.001)) / 0.002
    error = math.hypot(*off) / abs(slope)
    # All of the knob's range, from 0 to 1, is what is known of it before.
    assert found.error == pytest.approx((error**-2 + 12.0) ** -0.5, rel=0.01)


def test_what_is_measured_too_makes_another_surer() -> None:
    """How far a ball bends off a cushion depends on the restitution: known, it leaves the friction surer."""
    table = load_table("pool-9ft")
    alone = fitted(table, oblique_leaves=54.0).knobs[0]
    readings = {"oblique.leaves": Reading(54.0, 1.0), "rebound.kept": Reading(0.56, 0.001)}
    friction = next(each for each in fit_by_hand(table, readings, "here").knobs if each.knob == alone.knob)
    assert friction.error < 0.97 * alone.error


def test_a_table_with_too_rough_a_nose_is_no_trap() -> None:
    """Where the ball stops slipping, more friction changes the angle little, and the other way."""
    rough = load_table("pool-9ft", {"cushion.friction": 0.6})
    (found,) = fitted(rough, oblique_leaves=55.0).knobs
    assert found.was == 0.6
    assert found.now == pytest.approx(fitted(load_table("pool-9ft"), oblique_leaves=55.0).knobs[0].now, abs=1e-4)


def test_two_measurements_of_one_knob_that_disagree_make_it_less_sure() -> None:
    table = load_table("pool-9ft")
    agreed = fit_by_hand(table, as_readings({"rebound.kept": 0.566, "hard.lengths": 3.11, "hard.first": 0.5}), "here")
    torn = fit_by_hand(table, as_readings({"rebound.kept": 0.46, "hard.lengths": 3.4, "hard.first": 0.5}), "here")
    assert agreed.strain == 1.0
    assert torn.strain > 2.0
    assert torn.knobs[0].error > 1.5 * agreed.knobs[0].error
    assert torn.knobs[0].by == ("hard", "rebound")


@pytest.mark.parametrize(
    ("seen", "key", "knob"),
    [
        ({"lag_seconds": 60.0}, "lag.seconds", "cloth.mu_roll"),
        ({"lag_seconds": 1.0}, "lag.seconds", "cloth.mu_roll"),
        ({"hard_lengths": 20.0, "hard_first": 0.4}, "hard.lengths", "cushion.restitution"),
        ({"spin_turns": 900.0, "spin_seconds": 2.0}, "spin.turns", "cloth.mu_spin"),
        ({"oblique_leaves": 75.0}, "oblique.leaves", "cushion.friction"),
        ({"oblique_leaves": 38.0}, "oblique.leaves", "cushion.friction"),
        ({"rebound_kept": 0.9}, "rebound.kept", "cushion.restitution"),
        ({"rebound_kept": 0.9, "oblique_leaves": 54.0}, "rebound.kept", "cushion.restitution"),
    ],
)
def test_what_no_knob_gives_is_told_with_what_is_possible(seen: dict[str, float], key: str, knob: str) -> None:
    with pytest.raises(InputError) as caught:
        fitted(load_table("pool-9ft"), **seen)
    error = caught.value
    assert (error.source, error.key, error.value) == ("mine.toml", key, seen[key.replace(".", "_")])
    assert error.allowed.startswith("allowed is ") and knob in error.allowed
    least, most = (float(word.rstrip(",")) for word in error.allowed.split()[2:5:2])
    assert not least <= seen[key.replace(".", "_")] <= most


def test_what_is_said_to_be_possible_is_possible() -> None:
    table = load_table("pool-9ft")
    with pytest.raises(InputError) as caught:
        fitted(table, rebound_kept=0.9)
    most = float(caught.value.allowed.split()[4].rstrip(","))
    assert fitted(table, rebound_kept=most - 0.005).knobs[0].now == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize(
    ("seen", "key"),
    [
        ({"hard_lengths": 3.0}, "hard.first"),
        ({"hard_first": 0.5}, "hard.lengths"),
        ({"spin_turns": 9.0}, "spin.seconds"),
        ({"rebound_speed": 1.0}, "rebound.kept"),
        ({"lag_gap": 0.1, "spin_turns": 9.0, "spin_seconds": 3.0}, "lag.seconds"),
    ],
)
def test_half_a_measurement_tells_what_is_missing(seen: dict[str, float], key: str) -> None:
    with pytest.raises(InputError, match="missing") as caught:
        fitted(load_table("pool-9ft"), **seen)
    assert caught.value.key == key


def test_nothing_measured_is_told() -> None:
    with pytest.raises(InputError, match=r"nothing was measured; any of lag\.seconds"):
        fitted(load_table("pool-9ft"))


@pytest.mark.parametrize(("error", "decimals"), [(0.00031, 5), (0.021, 3), (0.21, 2), (2.1, 1), (21.0, 0), (2100.0, 0)])
def test_a_value_has_the_digits_that_its_error_leaves_a_meaning(error: float, decimals: int) -> None:
    assert places(error) == decimals


def test_the_values_to_set_have_no_more_digits_than_that() -> None:
    found = fitted(load_table("pool-9ft"), rebound_kept=0.5667)
    (fit,) = found.knobs
    assert found.values == {"cushion.restitution": fit.now}
    assert fit.now == round(fit.now, places(fit.error))


def test_a_contradiction_is_that_of_its_own_knob() -> None:
    """However far apart two measurements are, the others are as sure as they were."""
    table = load_table("pool-9ft")
    spin = {"spin.turns": 1.2, "spin.seconds": 4.0}
    (alone,) = fit_by_hand(table, as_readings(spin), "here").knobs
    torn = {"rebound.kept": Reading(0.46, 1e-5), "hard.lengths": Reading(3.4, 1e-5), "hard.first": Reading(0.5, 1e-6)}
    found = fit_by_hand(table, {**as_readings(spin), **torn}, "here")
    assert found.strain > 2.0
    assert next(each for each in found.knobs if each.knob == "cloth.mu_spin").error == pytest.approx(alone.error)


def test_a_measurement_that_cannot_be_made_at_all_is_told() -> None:
    """From cushions of lead no ball comes back."""
    with pytest.raises(InputError, match=r"lag\.seconds = 8\.0: no ball gets so far on this table"):
        fitted(load_table("pool-9ft", {"cushion.restitution": 0.0}), lag_seconds=8.0)


def test_a_knob_that_nothing_shown_depends_on_stays_in_its_range() -> None:
    """A cloth like glue, cushions of lead: one measurement of two tells nothing there, and the other is found."""
    table = load_table("pool-9ft", {"cloth.mu_roll": 0.2, "cushion.restitution": 0.0})
    found = fitted(table, spin_turns=14.0, spin_seconds=4.0, rebound_kept=0.011)
    assert {each.knob: each.now for each in found.knobs}["cloth.mu_spin"] == pytest.approx(0.0124, abs=0.001)
