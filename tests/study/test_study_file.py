"""What a study's file says, and how a wrong one is told."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from pool2d import InputError
from pool2d.study.study_file import load_study

from ..commands.cli_runs import ROOT
from .studies import SCENARIO, SHOTS, SWEEP, written


def test_a_study_lies_on_a_scenario(tmp_path: Path) -> None:
    study = load_study(written(tmp_path), {"cloth.mu_roll": 0.02}, ["heated"])
    assert list(study.layout) == ["cue", "1"]
    assert (study.table.knobs.cloth.mu_roll, study.table.conditions) == (0.02, ("heated",))
    assert len(study.sweep) == SHOTS
    assert study.sweep.grid["angle"] == (14.0, 14.25, 14.5, 14.75, 15.0)
    assert study.sweep.noise == {"angle": 0.1, "speed": 0.2}
    assert (study.sweep.repeat, study.sweep.seed, study.sweep.base.speed) == (3, 5, 2.0)
    assert (study.axes, study.outcome.name) == (("side", "height"), "potted.1")


def test_the_scenario_may_be_a_file_beside_it(tmp_path: Path) -> None:
    written(tmp_path, SCENARIO, "shot.toml")
    (tmp_path / "deep").mkdir()
    own = load_study(written(tmp_path), {}, [])
    for name in ("../shot.toml", str(tmp_path / "shot.toml")):
        other = load_study(written(tmp_path / "deep", f'scenario = "{name}"\n{SWEEP}'), {}, [])
        assert (other.layout, other.sweep) == (own.layout, own.sweep)
        assert other.stamp(["engine"]) == own.stamp(["engine"])


def test_a_break_is_studied_from_its_rack(tmp_path: Path) -> None:
    text = 'rack = "eight-ball"\nseed = 4\n[shot]\nspeed = 8.0\n[noise]\nangle = 0.2\n[study]\nshots = 100\n'
    study = load_study(written(tmp_path, text), {}, [])
    assert study.layout == study.table.rack("eight-ball", 4)
    assert (len(study.sweep), study.axes, study.outcome.name) == (100, None, "potted")


def test_the_map_lies_over_what_is_wanted(tmp_path: Path) -> None:
    text = SCENARIO + SWEEP + 'map = ["speed", "angle"]\n'
    assert load_study(written(tmp_path, text), {}, []).axes == ("speed", "angle")


def test_on_a_table_without_pockets_cushions_are_counted(tmp_path: Path) -> None:
    text = 'table = "carom-10ft"\n' + SCENARIO + "[grid]\nspeed = [1.0, 2.0]\n"
    assert load_study(written(tmp_path, text), {}, []).outcome.name == "cushions.cue"


def test_a_study_is_another_when_anything_that_is_played_is(tmp_path: Path) -> None:
    text = SCENARIO + SWEEP
    changed = [
        text,
        text.replace("x = 2.0", "x = 2.0000001"),
        text.replace("seed = 5", "seed = 6"),
        text.replace("shots = 3", "shots = 4"),
        text.replace("angle = 0.1", "angle = 0.11"),
        text.replace("count = 5", "count = 6"),
        text.replace("speed = 2.0", "speed = 2.1"),
        'set = { "cloth.mu_slide" = 0.21 }\n' + text,
    ]
    stamps = [load_study(written(tmp_path, each), {}, []).stamp(["engine"]) for each in changed]
    assert len(set(stamps)) == len(changed)
    assert load_study(written(tmp_path, text), {}, []).stamp(["another engine"]) not in stamps
    # What is looked at changes nothing that is played.
    looked = text.replace('"potted.1"', '"first.1"') + 'map = ["angle", "side"]\n'
    assert load_study(written(tmp_path, looked), {}, []).stamp(["engine"]) == stamps[0]


def test_the_studies_of_the_documentation_are_studies(tmp_path: Path) -> None:
    blocks = re.findall(r"```toml\n(.*?)```", (ROOT / "docs" / "studies.md").read_text(encoding="utf-8"), re.DOTALL)
    sizes = [len(load_study(written(tmp_path, block), {}, []).sweep) for block in blocks]
    assert sizes == [41 * 6 * 20, 100_000]


GRID = "[grid]\nspeed = [1.0, 2.0]\n"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (SCENARIO, "nothing is swept; needed is a section [grid] or [noise]"),
        (SCENARIO + "[gird]\nspeed = [1.0]", "gird = {'speed': [1.0]}: unknown; did you mean grid?"),
        ("grid = 3\n" + SCENARIO, "grid = 3: allowed is a section [grid]"),
        (SCENARIO + "[grid]\nspede = [1.0]", "grid.spede = [1.0]: unknown; did you mean speed?"),
        (SCENARIO + "[grid]\nspeed = 2.0", "grid.speed = 2.0: allowed is a list of values, or { from = 1.0, to"),
        (SCENARIO + "[grid]\nspeed = []", "grid.speed = []: allowed are 1 to 10000 values"),
        (SCENARIO + "[grid]\nspeed = [1.0, 60.0]", "grid.speed[1] = 60.0: allowed is a number from 0 to 50 m/s"),
        (SCENARIO + "[grid]\nspeed = [1.0, 'x']", "grid.speed[1] = 'x': allowed is a number from 0 to 50 m/s"),
        (SCENARIO + "[grid]\nspeed = [1.0, 1]", "grid.speed = [1.0, 1]: a value is there twice"),
        (SCENARIO + "[grid]\nspeed = {from = 1, to = 2}", "grid.speed.count = None: missing; needed are from, to and"),
        (SCENARIO + "[grid]\nspeed = {from = 1, to = 2, count = 1}", "grid.speed.count = 1: allowed is a whole number"),
        (SCENARIO + "[grid]\nspeed = {from = 1, to = 2, count = 2.5}", "grid.speed.count = 2.5: allowed is a whole"),
        (SCENARIO + "[grid]\nspeed = {from = 1, to = 1, count = 3}", "grid.speed.to = 1.0: allowed is another number"),
        (SCENARIO + "[grid]\nspeed = {from = -1, to = 1, count = 3}", "grid.speed.from = -1: allowed is a number from"),
        (SCENARIO + "[grid]\nspeed = {from = 1, till = 2}", "grid.speed.till = 2: unknown; known are count, from, to"),
        (SCENARIO + "[noise]\nspeed = -0.1", "noise.speed = -0.1: allowed is a number from 0 to 50 m/s"),
        (SCENARIO + "[noise]\nspeed = nan", "noise.speed = nan: allowed is a number from 0 to 50 m/s"),
        (
            SCENARIO + "[noise]\nball = 0.1",
            "noise.ball = 0.1: unknown; known are angle, elevation, height, side, speed",
        ),
        (
            SCENARIO + "[noise]\nspeed = 0.1",
            "study.shots = None: missing; needed is a whole number from 1 to 100000000",
        ),
        (SCENARIO + "[noise]\nspeed = 0.1\n[study]\nshots = 0", "study.shots = 0: allowed is a whole number from 1"),
        (SCENARIO + GRID + "[study]\nshots = 2", "study.shots = 2: without [noise] all would be alike; allowed is 1"),
        (SCENARIO + GRID + "[study]\nseed = -1", "study.seed = -1: allowed is a whole number from 0"),
        (SCENARIO + GRID + "[study]\nsede = 1", "study.sede = 1: unknown; did you mean seed?"),
        (SCENARIO + GRID + "[study]\noutcome = 3", "study.outcome = 3: allowed is a text such as 'potted' or"),
        (
            SCENARIO + GRID + "[study]\noutcome = 'poted.1'",
            "study.outcome = 'poted.1': unknown; did you mean potted.1?",
        ),
        (SCENARIO + GRID + "[study]\noutcome = 'first.8'", "study.outcome = 'first.8': unknown; did you mean first.1?"),
        (SCENARIO + GRID + "[study]\nmap = ['speed', 'angle']", "allowed are two of speed"),
        (SCENARIO + SWEEP + "map = ['side', 'side']", "study.map = ['side', 'side']: allowed are two of side, height"),
        (SCENARIO.split("[shot]")[0] + GRID, "shot = None: missing; needed is the shot that the study varies"),
        ("scenario = 3\n" + GRID, "scenario = 3: allowed is a path to a scenario, .toml or .json"),
        ("scenario = 'shot.toml'\ntable = 'pool-7ft'\n" + GRID, "table = 'pool-7ft': allowed is in shot.toml, which"),
        (
            SCENARIO + "[grid]\nspeed = {from = 1, to = 2, count = 10000}\nside = {from = 0, to = 0.5, count = 10000}\n"
            "height = [0.0, 0.1]",
            "the study has 200000000 shots; allowed are 100000000",
        ),
        ("rack = 'eightball'\n[shot]\nspeed = 8.0\n" + GRID, "rack = 'eightball': unknown; did you mean eight-ball?"),
        ("[grid", "not a TOML file"),
    ],
)
def test_a_wrong_study_is_told(text: str, told: str, tmp_path: Path) -> None:
    file = written(tmp_path, text)
    with pytest.raises(InputError) as error:
        load_study(file, {}, [])
    assert str(error.value).startswith(f"{file}: ")
    assert told in str(error.value)


def test_what_is_wrong_with_the_scenario_is_told_of_its_own_file(tmp_path: Path) -> None:
    other = written(tmp_path, SCENARIO.replace("speed = 2.0", "speed = 200.0"), "shot.toml")
    with pytest.raises(InputError, match=r"shot\.speed = 200\.0: allowed is a number from 0 to 50 m/s") as told:
        load_study(written(tmp_path, f"scenario = 'shot.toml'\n{SWEEP}"), {}, [])
    assert told.value.source == str(other)
    with pytest.raises(InputError, match="cannot be read") as told:
        load_study(written(tmp_path, f"scenario = 'gone.toml'\n{SWEEP}"), {}, [])
    assert told.value.source == "gone.toml"


def test_a_study_is_toml(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a study's name ends in \.toml"):
        load_study(written(tmp_path, "{}", "study.json"), {}, [])
