"""Drills: every one can be done, and what is judged is what the file says."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from pool2d import Ball, InputError, Layout, Shot, simulate
from pool2d.config.folders import data_folder
from pool2d.game.drills.best_results import best, keep
from pool2d.game.drills.drill import MISSES, Drill, RestArea, Run, Standing, begin, faults, judge, start
from pool2d.game.drills.drill_file import drills, load
from pool2d.game.rules.report import Report
from pool2d.physics.values import POCKETED

from .rules.notation import report


def played(drill: Drill, shots: tuple[Shot, ...]) -> Standing:
    standing = start(drill)
    for shot in shots:
        assert not standing.over, standing.missed
        standing = judge(drill, standing, simulate(drill.table, standing.layout, shot))
    return standing


def test_the_shelf_is_well_filled() -> None:
    assert len(drills()) >= 20
    assert len({load(name).name for name in drills()}) == len(drills())


@pytest.mark.parametrize("name", drills())
def test_a_drill_can_be_done(name: str) -> None:
    drill = load(name)
    assert drill.text.endswith(".")
    assert 1 <= drill.goal <= len(drill.steps)
    standing = played(drill, drill.solution)
    assert (standing.done, standing.missed) == (drill.goal, "")
    assert standing.over == (drill.goal == len(drill.steps))


@pytest.mark.parametrize("name", drills())
def test_a_drill_is_not_done_by_doing_nothing(name: str) -> None:
    drill = load(name)
    standing = played(drill, (Shot(0.0, 0.0, ball=drill.table.furniture.cue),))
    assert (standing.done, standing.over) == (0, True)
    assert standing.missed in MISSES


DRILL = """
position = "pool-9ft cue@0.5,0.5 1@1.5,0.5 9@2,0.5"
[[steps]]
{step}
"""


def drill_of(folder: Path, step: str, top: str = "") -> Drill:
    path = folder / "d.toml"
    path.write_text(top + DRILL.format(step=step))
    return load(str(path))


@pytest.mark.parametrize(
    ("step", "good", "bad", "miss"),
    [
        ('pot = "1"', "cue-1 1>", "cue-1 1|", "not_potted"),
        ('pot = "1"', "cue-1 1>", "cue-1 1> cue>", "cue_fell"),
        ('pot = "1"\npocket = "top-left"', "cue-1 1>top-left", "cue-1 1>top-right", "not_potted"),
        ('pot = "solid"', "cue-1 1>", "cue-9 9>", "not_potted"),
        ('pot = "any"\nleast = 2', "cue-1 1> 9>", "cue-1 1>", "not_potted"),
        ('first = "1"', "cue-1 cue-9", "cue-9 cue-1", "wrong_first"),
        ('first = "stripe"', "cue-9", "cue-1", "wrong_first"),
        ('first = "1"', "cue-9+1", "cue-9 cue-1", "wrong_first"),
        ('hits = ["1", "9"]', "cue-1 cue-9", "cue-1 1-9", "not_all_hit"),
        ('hits = ["1", "9"]\nrails = 3', "cue| cue-1 cue| cue| cue-9", "cue| cue| cue-1 cue-9 cue|", "few_rails"),
        ('hits = ["stripe"]\nrails = 1', "cue-1 cue| cue-9", "cue-1 cue-9 cue|", "few_rails"),
        ("rails = 2", "cue| cue| cue-1", "cue| cue-1 cue|", "few_rails"),
        ("rails = 1", "cue|", "", "few_rails"),
        ('pot = "1"\nbanks = 1', "cue-1 1|right 1>", "cue-1 1|top-left_jaw 1>", "few_banks"),
        ("clear = true", "cue-1 1|", "cue-1 cue|", "cushion_met"),
        ('via = ["right", "top-left"]', "cue|top-left cue|right", "cue|right cue|left", "wrong_way"),
        ("driven = 3", "cue-1 1| 9> cue|", "cue-1 1| 1| cue|", "few_driven"),
    ],
)  # fmt: skip
def test_steps_are_judged(tmp_path: Path, step: str, good: str, bad: str, miss: str) -> None:
    drill = drill_of(tmp_path, step)
    assert faults(drill.table, drill.steps[0], report(good), drill.layout) == ""
    assert faults(drill.table, drill.steps[0], report(bad), drill.layout) == miss


@pytest.mark.parametrize(
    ("rest", "places"),
    [
        ("x = [0.4, 0.6]", {(0.5, 1.0): True, (0.7, 0.5): False}),
        ("x = [0.4, 0.6], y = [0.0, 0.6]", {(0.5, 0.5): True, (0.5, 1.0): False}),
        ("at = [0.5, 0.5], within = 0.1", {(0.55, 0.55): True, (0.58, 0.58): False}),
    ],
)
def test_balls_have_to_rest_somewhere(tmp_path: Path, rest: str, places: dict[tuple[float, float], bool]) -> None:
    (step,) = drill_of(tmp_path, f"rest = [{{ {rest} }}]").steps
    for place, good in places.items():
        assert step.rest[0].holds(Layout([Ball("cue", *place)])) is good
    assert not step.rest[0].holds(Layout([Ball("cue", 0.5, 0.5, phase=POCKETED)]))
    assert not RestArea("1").holds(Layout([Ball("cue", 0.5, 0.5)]))


def test_every_ball_has_to_rest_where_it_is_wanted(tmp_path: Path) -> None:
    drill = drill_of(tmp_path, 'rest = [{ x = [0.4, 0.6] }, { ball = "9", at = [2.0, 0.5], within = 0.1 }]')
    there, away = drill.layout, drill.layout.put(drill.layout["9"]._replace(x=1.5))
    assert faults(drill.table, drill.steps[0], report(""), there) == ""
    assert faults(drill.table, drill.steps[0], report(""), away) == "wrong_rest"


def test_a_drill_is_told_in_the_languages_it_has(tmp_path: Path) -> None:
    drill = drill_of(tmp_path, "", 'name = "Stop"\ntext = "Stop it."\nde.text = "Bleibt liegen."\n')
    assert drill.wording_in("de") == ("Stop", "Bleibt liegen.")
    assert drill.wording_in("en") == drill.wording_in("fr") == ("Stop", "Stop it.")
    assert drill_of(tmp_path, "").wording_in("de") == ("d", "")


def test_a_drill_goes_from_step_to_step(tmp_path: Path) -> None:
    text = 'first = "1"\n[[steps]]\nposition = "cue@0.3,0.3 9@0.6,0.3"\nfirst = "9"\n[[steps]]\nfirst = "9"'
    drill = drill_of(tmp_path, text, "tries = 3\npass = 2\n")
    assert (drill.goal, drill.tries, drill.most) == (2, 3, 9)
    first = played(drill, (Shot(0.0, 1.0),))
    assert (first.done, first.over, set(first.layout)) == (1, False, {"cue", "9"})
    second = judge(drill, first, simulate(drill.table, first.layout, Shot(0.0, 0.4)))
    assert (second.done, second.over) == (2, False)
    assert second.layout["9"].x > 0.6
    third = judge(drill, second, simulate(drill.table, second.layout, Shot(180.0, 0.4)))
    assert (third.done, third.over, third.missed) == (2, True, "wrong_first")


def test_colours_are_spotted_where_a_step_says_so(tmp_path: Path) -> None:
    path = tmp_path / "d.toml"
    path.write_text(
        'position = "snooker-12ft cue@3.0,1.2 black@3.3,1.5"\n'
        '[[steps]]\npot = "color"\nrespot = true\n[[steps]]\npot = "black"\n'
    )
    drill = load(str(path))
    standing = played(drill, (Shot(45.45, 1.785, height=0.04),))
    assert (standing.done, standing.missed) == (1, "")
    black = standing.layout["black"]
    spot = drill.table.furniture.spots["black"]
    assert (black.x, black.y, black.phase) == (*spot, "resting")
    # Beside a ball that lies there; one that no rack has a place for stays off.
    path.write_text(path.read_text().replace("black@", f"red1@{spot[0]},{spot[1]} extra@0.5,0.5 black@"))
    drill = load(str(path))
    rollout = simulate(drill.table, drill.layout, Shot(45.45, 1.785, height=0.04))
    black = judge(drill, start(drill), rollout).layout["black"]
    assert black.x == pytest.approx(spot[0] + 2.0 * drill.table.knobs.ball.radius, abs=1e-6)


@pytest.mark.parametrize(
    ("step", "top", "words"),
    [
        ("pott = 3", "", "steps[0].pott = 3: unknown; did you mean pot?"),
        ("pot = 3", "", "steps[0].pot = 3: allowed is a str"),
        ("least = true", "", "steps[0].least = True: allowed is a int"),
        ("rest = [3]", "", "steps[0].rest = 3: allowed is a section with ball, x, y, at, within"),
        ("rest = [{ z = 3 }]", "", "steps[0].rest.z = 3: unknown"),
        ("rest = [{ x = 3 }]", "", "steps[0].rest.x = 3: allowed are two numbers, m"),
        ("rest = [{ within = '3' }]", "", "steps[0].rest.within = '3': allowed is a number"),
        ("position = 'cue@'", "", "word = 'cue@'"),
        ("rest = [{ within = -0.1 }]", "", "steps[0].rest.within = -0.1: allowed is a number above 0, m"),
        (
            "rest = [{ x = [2.0, 1.0] }]",
            "",
            "steps[0].rest.x = [2.0, 1.0]: allowed are a number",
        ),
        ("rest = [{ ball = '7' }]", "", "steps[0].rest = '7': unknown"),
        ("pot = '7'", "", "steps[0].pot = '7': unknown"),
        ("hits = ['1', 'rad']", "", "steps[0].hits = 'rad': unknown"),
        ("pocket = 'top'", "", "steps[0].pocket = 'top': unknown"),
        ("via = ['rihgt']", "", "steps[0].via = 'rihgt': unknown; did you mean right?"),
        ("rails = -1", "", "steps[0].rails = -1: allowed is 0 or more"),
        ("least = 0", "", "steps[0].least = 0: allowed is 1 or more"),
        ("position = 'cue@0.5,9'", "", "the ball is off the table"),
        ("position = '1@0.5,0.5'", "", "there has to be the cue ball"),
        ("position = 'snooker-12ft cue@0.5,0.5'", "", "allowed is the table of the drill, pool-9ft"),
        ("", "name = 3\n", "name = 3: allowed is a str"),
        ("", "de = 3\n", "de = 3: allowed is a section with name, text"),
        ("", "de.nam = 'x'\n", "de.nam = 'x': unknown; did you mean name?"),
        ("", "de.text = 3\n", "de.text = 3: allowed is a str"),
        ("", "pass = 2\n", "pass = 2: allowed is 1 to 1"),
        ("", "tries = 0\n", "tries = 0: allowed is 1 to 100"),
        ("", "solution = ['cue']\n", "shot = 'cue': allowed is ball:angle"),
        ("", "name = 3\n", "name = 3: allowed is a str"),
        ("", "steps = 3\n", "not a TOML file"),
    ],
)
def test_bad_drills_are_refused(tmp_path: Path, step: str, top: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        drill_of(tmp_path, step, top)
    assert str(caught.value).startswith(f"{tmp_path / 'd.toml'}")
    assert words in str(caught.value)


def test_a_drill_wants_a_position_and_steps(tmp_path: Path) -> None:
    path = tmp_path / "d.toml"
    for text, words in (
        ('position = "cue@0.5,0.5"', "steps = None: allowed is a list"),
        ('position = "cue@0.5,0.5"\nsteps = []', "allowed is one step or more"),
        ("steps = [{}]", "position = None: allowed is a str"),
        ('position = "cue@9,9"\nsteps = [{}]', "the ball is off the table"),
    ):
        path.write_text(text)
        with pytest.raises(InputError, match=r"allowed|off the table") as caught:
            load(str(path))
        assert words in str(caught.value)
    with pytest.raises(InputError, match="did you mean stop-shot"):
        load("stop-shat")


def test_the_best_result_is_kept() -> None:
    assert best("draw") is None
    assert keep("draw", 3)
    assert keep("follow", 1)
    assert not keep("draw", 3)
    assert not keep("draw", 2)
    assert keep("draw", 5)
    assert (best("draw"), best("follow")) == (5, 1)
    # By name, however they were made.
    assert keep("bank", 1)
    assert list(json.loads((data_folder() / "drills" / "best.json").read_text())) == ["bank", "draw", "follow"]


def test_results_that_cannot_be_read_are_left_alone() -> None:
    path = data_folder() / "drills" / "best.json"
    path.parent.mkdir(parents=True)
    for text in ("noise", "[1]", "[" * 100_000):
        path.write_text(text)
        assert best("draw") is None
        with pytest.raises(InputError, match="left as it is"):
            keep("draw", 1)
        assert path.read_text() == text
    path.write_text('{"draw": "x", "follow": 2}')
    assert keep("draw", 1)
    assert (best("draw"), best("follow")) == (1, 2)


def test_a_run_adds_its_attempts_up(tmp_path: Path) -> None:
    drill = drill_of(tmp_path, 'first = "1"\n[[steps]]\nfirst = "1"', "tries = 2\n")
    hit, miss = Shot(0.0, 0.6), Shot(90.0, 0.6)

    def after(run: Run, *shots: Shot) -> Run:
        for shot in shots:
            run = run.after(simulate(drill.table, run.standing.layout, shot))
        return run

    run = after(begin(drill), hit)
    assert (run.result, run.over, run.results) == (1, False, ())
    # Set up anew in the middle of an attempt, nothing of it counts.
    assert (run.again().result, run.again().standing) == (0, start(drill))
    run = after(run, hit)
    assert (run.result, run.over, run.results, run.standing.over) == (2, False, (2,), True)
    run = after(run.again(), hit)
    assert (run.result, run.over) == (3, False)
    run = after(run, miss)
    assert (run.result, run.over, run.results) == (3, True, (2, 1))


def test_a_report_of_nothing_meets_no_goal(tmp_path: Path) -> None:
    drill = drill_of(tmp_path, 'first = "any"')
    assert faults(drill.table, replace(drill.steps[0], driven=1), Report(), drill.layout)


@pytest.mark.parametrize(
    ("steps", "top", "key"),
    [
        (100, "", "steps"),
        (1, 'name = "{}"\n', "name"),
        (1, 'text = "{}"\n', "text"),
        (1, 'de.name = "{}"\n', "de.name"),
        (1, "tries = {}\n", "tries"),
        (3, "pass = {}\n", "pass"),
    ],
)
def test_what_a_drill_may_have_most_of_is_had_and_no_more(tmp_path: Path, steps: int, top: str, key: str) -> None:
    most = {"name": "x" * 80, "text": "x" * 1000, "de.name": "x" * 80, "tries": "100", "pass": "3"}.get(key, "")
    more = most + "x" if most.startswith("x") else str(int(most or 0) + 1)
    drill = drill_of(tmp_path, "\n[[steps]]" * (steps - 1), top.format(most))
    assert len(drill.steps) == steps
    had = {"name": drill.name, "text": drill.text, "de.name": drill.wording_in("de").name, "tries": str(drill.tries)}
    assert had.get(key, most) == most
    with pytest.raises(InputError, match=rf"{key} = .*allowed is "):
        drill_of(tmp_path, "\n[[steps]]" * (steps if key == "steps" else steps - 1), top.format(more))


@pytest.mark.parametrize("banks", [1, 2])
def test_a_ball_that_does_not_fall_was_not_banked(tmp_path: Path, banks: int) -> None:
    drill = drill_of(tmp_path, f"banks = {banks}")
    for shot in ("cue-1 1|right 1|top 1|left", "cue-1 1|", ""):
        assert faults(drill.table, drill.steps[0], report(shot), drill.layout) == "few_banks"
