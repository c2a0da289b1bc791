"""The command line: what `simulate` prints, and how it says no."""

from __future__ import annotations

import json
import math
import os
from functools import partial
from pathlib import Path

import pytest

from pool2d import __version__, load_scenario, simulate
from pool2d.cli import main

from .cli_runs import PLAY, ROOT, Capture, answer, refusal, run

STATE = {"x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "phase"}


def test_json_tells_the_whole_rollout(play: str, capsys: Capture) -> None:
    (told,) = answer(capsys, play)
    assert told.keys() == {"duration", "balls", "events"}
    roll = load_scenario(play).simulate()
    assert told["duration"] == roll.duration > 1.0
    assert told["balls"].keys() == {"cue", "1"}
    for name, state in told["balls"].items():
        assert state.keys() == STATE
        assert (state["x"], state["y"]) == (roll.layout()[name].x, roll.layout()[name].y)
        assert state["phase"] in ("resting", "pocketed")
    kinds = [event["kind"] for event in told["events"]]
    assert kinds[0] == "cue_ball"
    assert {"ball_ball", "ball_cushion", "sliding_rolling", "rolling_resting"} <= set(kinds)
    for event in told["events"]:
        assert event.keys() == {"t", "kind", "balls", "where", "before", "after"}
        assert event["before"].keys() == event["after"].keys() == set(event["balls"])
        for state in (*event["before"].values(), *event["after"].values()):
            assert state.keys() == STATE
            assert state["phase"] in ("resting", "spinning", "rolling", "sliding", "pocketed")
        assert (event["where"] is None) == (event["kind"] not in ("ball_cushion", "ball_pocket"))


def test_sample_adds_each_balls_path(play: str, capsys: Capture) -> None:
    (told,) = answer(capsys, play, "--sample", "0.1")
    assert told["path"].keys() == {"cue", "1"}
    for name, path in told["path"].items():
        assert len(path) == math.ceil(told["duration"] / 0.1) + 1
        assert [row[0] for row in path[:-1]] == pytest.approx([0.1 * i for i in range(len(path) - 1)])
        assert path[-1] == [told["duration"], told["balls"][name]["x"], told["balls"][name]["y"]]
    assert told["path"]["cue"][0] == [0.0, 0.635, 0.635]


def test_set_overrides_knobs(play: str, capsys: Capture) -> None:
    (plain,) = answer(capsys, play)
    (slow,) = answer(capsys, play, "--set", "cloth.mu_roll=0.05")
    (same,) = answer(capsys, play, "--set", "cloth.mu_roll=0.01", "--set", "gravity=9.81")
    assert slow["duration"] < plain["duration"]
    assert same["duration"] == plain["duration"]


def test_events_cuts_short(play: str, capsys: Capture) -> None:
    (whole,) = answer(capsys, play)
    (part,) = answer(capsys, play, "--events", "3")
    assert part["truncated"] is True
    assert part["events"] == whole["events"][:3]
    assert part["duration"] == part["events"][-1]["t"]
    (all_of_it,) = answer(capsys, play, "--events", str(len(whole["events"])))
    assert all_of_it == whole


def test_several_files_give_a_line_each_in_order(play: str, tmp_path: Path, capsys: Capture) -> None:
    other = tmp_path / "other.json"
    other.write_text('{"balls": [{"id": "9", "x": 1.0, "y": 0.6}]}')
    first, second, third = answer(capsys, str(other), play, str(other))
    assert first == third == {
        "duration": 0.0,
        "balls": {"9": dict.fromkeys(STATE, 0.0) | {"x": 1.0, "y": 0.6, "phase": "resting"}},
        "events": [],
    }  # fmt: skip
    assert second["balls"].keys() == {"cue", "1"}


def test_without_json_it_tells_people(play: str, capsys: Capture) -> None:
    assert main(["simulate", play, "--sample", "1"]) == 0
    told = capsys.readouterr().out
    assert told.startswith(f"{play}: ")
    for word in ("cue_ball", "ball_ball", "ball_cushion", "rolling_resting", "resting", " t "):
        assert word in told


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "cannot be read: No such file or directory"),
        ("x = = 1", "not a TOML file: "),
        ("balz = 1", "balz = 1: unknown; did you mean balls?"),
        (PLAY.replace("speed", "sped"), "shot.sped = 3.0: unknown; did you mean speed?"),
        (PLAY.replace("3.0", "300"), "shot.speed = 300: allowed is a number from 0 to 50 m/s"),
        (PLAY.replace("3.0", "nan"), "shot.speed = nan: allowed is a number from 0 to 50 m/s"),
        (PLAY.replace("0.635", "inf"), "balls[0].x = inf: allowed is a number from -100 to 100 m"),
        (PLAY.replace("0.2", "'left'"), "shot.side = 'left': allowed is a number"),
        (PLAY.replace("0.2", "1.5"), "shot.side = 1.5: allowed is a number from -1 to 1"),
        (PLAY.replace("0.2", "0.9\nheight = 0.9"), "shot.side, shot.height = (0.9, 0.9): the tip is off the ball"),
        (PLAY.replace("1.905", "0.64"), "balls.cue, balls.1 = (0.635, 0.635): the balls overlap by 0.05"),
        (PLAY.replace("1.905", "9.0"), "balls.1.x, y = (9.0, 0.635): the ball is off the table"),
        (PLAY.replace('"1"', '"cue"'), "balls[1].id = 'cue': another ball has this id"),
        (PLAY.replace("[shot]", '[shot]\nball = "7"'), "shot.ball = '7': unknown; known are 1, cue"),
        ('table = "pool-9"\n' + PLAY, "table = 'pool-9': unknown; did you mean pool-9ft?"),
        ('set = { "cloth.mu_slid" = 1 }\n' + PLAY, "cloth.mu_slid = 1: unknown; did you mean cloth.mu_slide?"),
    ],
)
def test_bad_files_are_one_line(tmp_path: Path, capsys: Capture, text: str | None, words: str) -> None:
    path = tmp_path / "bad.toml"
    if text is not None:
        path.write_text(text)
    assert refusal(capsys, "simulate", "--json", str(path)).startswith(f"pool2d: {path}: {words}")


def test_other_things_than_files_are_one_line(tmp_path: Path, capsys: Capture) -> None:
    folder = tmp_path / "folder.json"
    folder.mkdir()
    assert refusal(capsys, "simulate", str(folder)) == f"pool2d: {folder}: cannot be read: Is a directory"
    broken = tmp_path / "broken.json"
    broken.write_text("{")
    assert refusal(capsys, "simulate", str(broken)).startswith(f"pool2d: {broken}: not a JSON file: ")
    nothing = tmp_path / "nothing.json"
    nothing.symlink_to(nothing)
    assert refusal(capsys, "simulate", str(nothing)).startswith(f"pool2d: {nothing}: cannot be read: ")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["--set", "cloth.mu_rol=1"], "--set: cloth.mu_rol = 1.0: unknown; did you mean cloth.mu_roll?"),
        (["--set", "cloth.mu_roll=9"], "--set: cloth.mu_roll = 9.0: allowed is a number from 0.001 to 0.2"),
        (["--set", "cloth.mu_roll=nan"], "--set: cloth.mu_roll = nan: allowed is a number"),
        (["--set", "cloth.mu_roll=x"], "--set: cloth.mu_roll = 'x': allowed is a number"),
        (["--set", "cloth.mu_roll"], "--set: 'cloth.mu_roll' is not NAME=VALUE"),
        (["--set", "ball.law=hard"], "--set: ball.law = 'hard': allowed is one of "),
        (["--set", "ball.law=1"], "--set: ball.law = 1.0: allowed is one of "),
        (["--events", "0"], "command line: --events = 0.0: allowed is a number from 1"),
        (["--events", "2.5"], "command line: --events = '2.5': allowed is a whole number"),
        (["--events", "many"], "command line: --events = 'many': allowed is a number"),
        (["--sample", "0"], "command line: --sample = 0.0: allowed is a number"),
        (["--sample", "inf"], "command line: --sample = inf: allowed is a number"),
        (["--sample"], "command line: argument --sample: expected one argument"),
        (["--wat\nnot"], "command line: unrecognized arguments: --wat"),
    ],
)
def test_bad_options_are_one_line(play: str, capsys: Capture, words: list[str], line: str) -> None:
    assert refusal(capsys, "simulate", play, *words).startswith(f"pool2d: {line}")


@pytest.mark.parametrize("words", [["simulate"], ["wat"], ["render", "only-one"]])
def test_bad_commands_are_one_line(capsys: Capture, words: list[str]) -> None:
    assert refusal(capsys, *words).startswith("pool2d: command line: ")


def test_good_files_before_a_bad_one_are_told(play: str, tmp_path: Path, capsys: Capture) -> None:
    assert main(["simulate", "--json", play, str(tmp_path / "none.toml"), play]) == 2
    told = capsys.readouterr()
    assert len(told.out.splitlines()) == len(told.err.splitlines()) == 1


def test_shot_that_does_not_end_is_one_line(play: str, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pool2d.table.scenario.simulate", partial(simulate, budget=4))
    line = refusal(capsys, "simulate", play)
    assert line.startswith("pool2d: the shot is not over after 4 events")
    assert json.loads(line.partition("the scenario is ")[2])["shot"]["speed"] == 3.0


@pytest.mark.parametrize("word", ["--version", "--help"])
def test_version_and_help(capsys: Capture, word: str) -> None:
    with pytest.raises(SystemExit) as left:
        main([word])
    assert left.value.code == 0
    assert (__version__ if word == "--version" else "simulate") in capsys.readouterr().out


def test_it_is_a_program(play: str) -> None:
    """Through a fresh process, both ways in."""
    for way in (["-m", "pool2d"], ["main.py"]):
        good = run(*way, "simulate", play, "--json")
        assert (good.returncode, good.stderr) == (0, "")
        assert json.loads(good.stdout)["duration"] > 1.0
    bad = run("-m", "pool2d", "simulate", play + "x")
    assert (bad.returncode, bad.stdout, len(bad.stderr.splitlines())) == (2, "", 1)


def test_it_is_a_program_beside_a_folder_of_the_same_name() -> None:
    """An installed clone, started from the folder that holds it: Python finds the clone before the package."""
    code = (
        "import runpy, sys; from importlib.machinery import ModuleSpec; from importlib.util import module_from_spec\n"
        "spec = ModuleSpec('pool2d', None, is_package=True)\n"
        f"spec.submodule_search_locations[:] = [{str(ROOT)!r}, {str(ROOT / 'pool2d')!r}]\n"
        "sys.path.remove(''); sys.modules['pool2d'] = module_from_spec(spec)\n"
        "sys.argv = ['pool2d', 'tables', 'pool-7ft']; runpy.run_module('pool2d', run_name='__main__')"
    )
    done = run("-c", code)
    assert (done.returncode, done.stderr) == (0, "")
    assert "pool-7ft" in done.stdout


def test_a_sample_too_fine_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "s.toml"
    path.write_text('[[balls]]\nid = "cue"\nx = 1.0\ny = 0.5\nvx = 2.0\n')
    assert main(["simulate", str(path), "--json", "--sample", "1e-6"]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert "--sample" in err
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["tables", "--knobs", "x"], "command line: NAME and --knobs do not go together; allowed is one of them"),
        (["tables", "--knobs", "--check", "x"], "command line: --knobs and --check do not go together"),
        (["tables", "--base", "snooker-12ft"], "command line: --base = 'snooker-12ft': allowed is only with --new"),
        (["tables", "--conditions", "heated"], "command line: --set and --conditions are allowed only with"),
        (["tables", ""], "table: table = '': unknown"),
        (["tables", "--new", ""], "command line: --new = '': allowed is the name of a file"),
        (["replay", "a.jsonl", "--gif", ""], "command line: --gif = '': allowed is the name of a file"),
        (["replay", "a.jsonl", "--png", ""], "command line: --png = '': allowed is the name of a file"),
        (["replay", "a.jsonl", "--verify", "--shot", "1"], "command line: --shot = 1: allowed is not with --list or"),
        (["replay", "a.jsonl", "--size", "640x360"], "command line: --size = '640x360': allowed is only with --png"),
        (["simulate", "a.toml", "--conditions", ""], "a.toml: conditions = ''"),
        (["render", "a.toml", ""], "command line: OUT.png = '': allowed is the name of a file"),
        (["simulate", "--position", "pool-9ft"], "position: balls = []: there is no ball on the table"),
    ],
)
def test_what_would_be_passed_over_is_refused(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch, words: list[str], line: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.toml").write_text(PLAY)
    assert refusal(capsys, *words).startswith(f"pool2d: {line}")


def test_a_picture_that_cannot_be_is_refused_before_it_is_drawn(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch, play: str
) -> None:
    monkeypatch.setattr("pool2d.table.scenario.simulate", pytest.fail)
    os.mkfifo(tmp_path / "pipe.png")
    (tmp_path / "folder.png").mkdir()
    for name, words in (
        ("pipe.png", "cannot be written: it is not a regular file"),
        ("folder.png", "cannot be written: it is a folder"),
        ("a.txt", "a picture's name ends in .png, .jpg, .bmp or .tga"),
        ("none/a.png", "cannot be written: there is no such folder"),
    ):
        assert refusal(capsys, "render", play, str(tmp_path / name)) == f"pool2d: {tmp_path / name}: {words}"
    assert refusal(capsys, "render", play, "/dev/null").startswith("pool2d: /dev/null: a picture's name ends in")


def test_a_picture_has_any_name_that_a_file_can_have(tmp_path: Path, capsys: Capture, play: str) -> None:
    for name in (b"\xff\xfe.png", b"a\nb\x1b[31m.png", "球.jpg".encode()):
        out = os.path.join(os.fsencode(tmp_path), name)
        assert main(["render", play, os.fsdecode(out), "--size", "64x64"]) == 0
        assert os.path.getsize(out) > 100
    assert capsys.readouterr() == ("", "")
