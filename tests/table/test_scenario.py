"""Scenario files: TOML and JSON say the same, and what is wrong is told in one line."""

from __future__ import annotations

import json
import re
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from pool2d import Ball, InputError, Layout, Shot, least_elevation, load_scenario, load_table, simulate

from ..scenes import random_shot

GOOD = """
table = "pool-9ft"
set = { "cloth.mu_slide" = 0.25 }
[[balls]]
id = "cue"
x = 0.635
y = 0.635
vx = 1
[[balls]]
id = "big"
x = 1.9
y = 0.6
radius = 0.03
mass = 0.2
wz = -3.0
[shot]
ball = "big"
angle = 30
speed = 3.0
side = 0.1
height = -0.2
elevation = 5.0
"""


def write(folder: Path, text: str, name: str = "play.toml") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def complaint(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        load_scenario(path)
    text = str(caught.value)
    assert text.isprintable()
    # Which line it is about is test_lines.py's to say.
    return re.sub(r", line \d+:", ":", text)


def test_toml_and_json_say_the_same(tmp_path: Path) -> None:
    toml = load_scenario(write(tmp_path, GOOD))
    other = load_scenario(str(write(tmp_path, json.dumps(tomllib.loads(GOOD)), "play.json")))
    assert toml.layout == other.layout == Layout(
        [Ball("cue", 0.635, 0.635, 1.0), Ball("big", 1.9, 0.6, wz=-3.0, radius=0.03, mass=0.2)]
    )  # fmt: skip
    assert toml.shot == other.shot == Shot(30.0, 3.0, 0.1, -0.2, 5.0, "big")
    assert toml.table.knobs == other.table.knobs
    assert toml.table.knobs.cloth.mu_slide == 0.25
    assert toml.simulate().digest() == other.simulate().digest()
    assert len(toml.simulate(events=3).events) == 3


def test_everything_but_balls_and_speed_has_a_default(tmp_path: Path) -> None:
    bare = load_scenario(write(tmp_path, 'table = "pool-8ft"'))
    assert (bare.table.source, len(bare.layout), bare.shot) == ("pool-8ft", 0, None)
    shot = load_scenario(write(tmp_path, '[[balls]]\nid = "cue"\nx = 0.6\ny = 0.6\n[shot]\nspeed = 2')).shot
    assert shot == Shot(speed=2)


def test_overrides_go_on_top_of_the_files_own(tmp_path: Path) -> None:
    path = write(tmp_path, GOOD)
    table = load_scenario(path, {"cloth.mu_slide": 0.3, "cloth.mu_roll": 0.02}).table
    assert (table.knobs.cloth.mu_slide, table.knobs.cloth.mu_roll) == (0.3, 0.02)


def test_table_may_be_a_file_beside_the_scenario(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "deep").mkdir()
    write(tmp_path, "[table]\nlength = 3.0", "mine.toml")
    write(tmp_path / "deep", "[table]\nlength = 2.0", "mine.toml")
    path = write(tmp_path / "deep", 'table = "mine.toml"')
    monkeypatch.chdir(tmp_path)
    assert load_scenario(path).table.knobs.table.length == 2.0
    (tmp_path / "deep" / "mine.toml").unlink()
    assert load_scenario(path).table.knobs.table.length == 3.0
    absolute = write(tmp_path, f'table = "{tmp_path}/mine.toml"')
    assert load_scenario(absolute).table.knobs.table.length == 3.0


def test_table_writes_what_a_scenario_reads(tmp_path: Path) -> None:
    table = load_table("pool-9ft", {"cloth.mu_roll": 0.02, "ball.law": "impulse"})
    layout, shot = random_shot(table, 2)
    layout = layout.put(layout["3"]._replace(vx=0.5, wy=2.0, radius=0.03))
    path = write(tmp_path, json.dumps(table.scenario(layout, shot)), "play.json")
    again = load_scenario(path)
    assert (again.layout, again.shot, again.table.knobs) == (layout, shot, table.knobs)
    assert again.simulate().digest() == simulate(table, layout, shot).digest()
    assert "shot" not in table.scenario(layout, None)


def test_a_cue_that_is_to_be_clear_is_raised(tmp_path: Path) -> None:
    text = 'position = "pool-9ft cue@0.05,0.5 cue:0,2.0"\n'
    given = load_scenario(write(tmp_path, text)).shot
    cleared = load_scenario(write(tmp_path, text + "cue.clear = true\n"))
    assert given is not None and given.elevation == 0.0
    needed = least_elevation(cleared.table, cleared.layout, given)
    assert cleared.shot == replace(given, elevation=needed.elevation or 0.0) and needed.over == "left"
    assert cleared.shot is not None and cleared.shot.elevation == pytest.approx(16.18, abs=0.01)
    assert load_scenario(write(tmp_path, text + "cue.clear = false\n")).shot == given
    buried = 'position = "pool-9ft cue@0.028,0.5 cue:0,2.0,0,-0.85"\ncue.clear = true\n'
    with pytest.raises(InputError, match=r"cue\.clear = True: no elevation takes the cue to this tip over left"):
        load_scenario(write(tmp_path, buried))


def test_an_easy_stroke_is_told_where_it_is_one(tmp_path: Path) -> None:
    table = load_table("pool-9ft")
    layout, shot = random_shot(table, 2)
    for easy in (True, False):
        told = table.scenario(layout, replace(shot, easy=easy))
        assert load_scenario(write(tmp_path, json.dumps(told), "play.json")).shot == replace(shot, easy=easy)
        assert ("easy" in told["shot"]) is easy


HUGE = "9" * 400


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("speed = 3.0\n", "", "shot.speed = None: missing; needed is a number from 0 to 50 m/s"),
        (
            'id = "cue"',
            'id = "  "',
            "balls[0].id = '  ': allowed is a text of printable characters, not empty, up to 40",
        ),
        ('id = "cue"', 'id = " a"', "balls[0].id = ' a': allowed is a text"),
        ('id = "cue"', f'id = "{"x" * 41}"', "balls[0].id = 'xxx"),
        ('table = "pool-9ft"', "tabel = 1", "tabel = 1: unknown; did you mean table?"),
        ('table = "pool-9ft"', "table = 1", "table = 1: allowed is a preset's name or a path"),
        ('table = "pool-9ft"', 'table = "pool-9"', "table = 'pool-9': unknown; did you mean pool-9ft?"),
        ('"cloth.mu_slide" = 0.25', '"cloth.slide" = 1', "cloth.slide = 1: unknown; did you mean cloth.mu_slide?"),
        ('"cloth.mu_slide" = 0.25', '"cloth.mu_slide" = -1', "cloth.mu_slide = -1: allowed is a number from 0.01 to 1"),
        ('{ "cloth.mu_slide" = 0.25 }', "3", "set = 3: allowed is a section"),
        ("vx = 1", "vxx = 1", "balls[0].vxx = 1: unknown; did you mean vx?"),
        ("vx = 1", "vx = 60", "balls[0].vx = 60: allowed is a number from -50 to 50 m/s"),
        ("vx = 1", "vx = nan", "balls[0].vx = nan: allowed is a number from -50 to 50 m/s"),
        ("vx = 1", "vx = -inf", "balls[0].vx = -inf: allowed is a number from -50 to 50 m/s"),
        ("vx = 1", "vx = true", "balls[0].vx = True: allowed is a number from -50 to 50 m/s"),
        ("vx = 1", "vx = '1'", "balls[0].vx = '1': allowed is a number from -50 to 50 m/s"),
        ("vx = 1", f"vx = {HUGE}", "balls[0].vx = 999"),
        ("x = 0.635\n", "", "balls[0].x = None: missing; needed is a number from -100 to 100 m"),
        ("x = 0.635", "x = 5.0", "balls.cue.x, y = (5.0, 0.635): the ball is off the table; allowed is x from 0.02"),
        ("x = 1.9\ny = 0.6", "x = 0.65\ny = 0.635", "balls.cue, balls.big = (0.635, 0.635): the balls overlap by 0.04"),
        ('id = "cue"', "", "balls[0].id = None: allowed is a text of printable characters, not empty"),
        ('id = "cue"', 'id = ""', "balls[0].id = '': allowed is a text"),
        ('id = "cue"', "id = 1", "balls[0].id = 1: allowed is a text"),
        ('id = "cue"', 'id = "a\\nb"', "balls[0].id = 'a\\nb': allowed is a text"),
        ('id = "cue"', 'id = "big"', "balls[1].id = 'big': another ball has this id"),
        ("radius = 0.03", "radius = 0.017", "balls.big.radius = 0.017: a ball must be higher than the cushion's nose"),
        ("radius = 0.03", "radius = 0.5", "balls[1].radius = 0.5: allowed is a number from 0.01 to 0.06 m"),
        ("mass = 0.2", "mass = 0", "balls[1].mass = 0: allowed is a number from 0.01 to 2 kg"),
        ("angle = 30", "angel = 30", "shot.angel = 30: unknown; did you mean angle?"),
        ("angle = 30", "angle = '30'", "shot.angle = '30': allowed is a number"),
        ("angle = 30", "angle = true", "shot.angle = True: allowed is a number"),
        ("angle = 30", "angle = nan", "shot.angle = nan: allowed is a number from -3600 to 3600 degrees"),
        ("angle = 30", f"angle = {HUGE}", "shot.angle = 999"),
        ("speed = 3.0", "speed = -1.0", "shot.speed = -1.0: allowed is a number from 0 to 50 m/s"),
        ("elevation = 5.0", "elevation = 91.0", "shot.elevation = 91.0: allowed is a number from 0 to 90 degrees"),
        ("side = 0.1", "side = 0.99", "shot.side, shot.height = (0.99, -0.2): the tip is off the ball"),
        ('ball = "big"', 'ball = "bag"', "shot.ball = 'bag': unknown; did you mean big?"),
        ('ball = "big"', "ball = 3", "shot.ball = 3: allowed is a ball"),
        ("[shot]", "[cue]\nclear = 1\n[shot]", "cue.clear = 1: allowed is true or false"),
        ("[shot]", "[cue]\nclaer = true\n[shot]", "cue.claer = True: unknown; did you mean clear?"),
        ('table = "pool-9ft"', 'table = "pool-9ft"\ncue = 3', "cue = 3: allowed is a section with clear"),
        ('ball = "big"', "easy = 1", "shot.easy = 1: allowed is true or false"),
        ("[shot]", "[shot.x]", "shot.x = {"),
        ("[shot]", "[[shot]]", "shot = [{"),
        ("[[balls]]", "[[ball]]", "ball = [{"),
    ],
)
def test_bad_scenarios_are_told_in_one_line(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in GOOD
    path = write(tmp_path, GOOD.replace(old, new, 1 if "balls" not in old else 9))
    assert complaint(path).startswith(f"{path}: {words}")


def test_a_rack_sets_up_what_is_not_placed(tmp_path: Path) -> None:
    racked = load_scenario(write(tmp_path, 'rack = "nine-ball"\nseed = 3\n')).layout
    assert racked == load_table("pool-9ft").rack("nine-ball", 3)
    assert load_scenario(write(tmp_path, 'rack = "nine-ball"\n')).layout == load_table("pool-9ft").rack("nine-ball")
    moved = load_scenario(write(tmp_path, 'rack = "nine-ball"\nseed = 3\nballs = [{id = "cue", x = 0.5, y = 0.3}]\n'))
    assert moved.layout == racked.put(Ball("cue", 0.5, 0.3))


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.toml", b"rack = 'nineball'", "rack = 'nineball': unknown; did you mean nine-ball?"),
        ("a.toml", b"rack = 3", "rack = 3: unknown; known are"),
        ("a.toml", b"rack = 'nine-ball'\nseed = -1", "seed = -1: allowed is a whole number from 0"),
        ("a.toml", b"rack = 'nine-ball'\nseed = 1.5", "seed = 1.5: allowed is a whole number from 0"),
        ("a.toml", b"seed = 1\ntable = 'pool-9ft'", "seed = 1: allowed is only with a rack"),
        (
            "a.toml",
            b"rack = 'nine-ball'\nposition = 'cue@1,0.5'",
            "rack = 'nine-ball': allowed is a rack or a position's",
        ),
        ("a.toml", b"", "an empty scenario; needed are balls, a position or a rack"),
        ("a.json", b"{}", "an empty scenario; needed are balls, a position or a rack"),
        ("a.toml", b"set = {}", "an empty scenario; needed are balls, a position or a rack"),
        ("a.toml", b"balls = []", "balls = []: allowed is a list of balls, one or more"),
        ("a.toml", b"table = 'pool-9ft'\nposition = 'nosuch cue@1,0.5'", "table = 'nosuch': unknown; known are"),
        ("a.toml", b"position = 'a%20@1,1'", "ball in a%20@1,1 = 'a ': allowed is a text"),
        (
            "a.toml",
            b"position = 'cloth.mu_roll=0.02 cloth.mu_roll=0.02 cue@1,1'",
            "word = 'cloth.mu_roll=0.02': this",
        ),
        (
            "a.json",
            b'{"balls": [{"id": "a", "id": "b", "x": 1, "y": 1}]}',
            "not a JSON file: the key 'id' is there twice",
        ),
        ("a.json", b'{"balls": [' + b",".join([b"0"] * 8000) + b"]}", "balls = 8000: allowed are up to 2000 balls"),
        ("a.toml", b"x = = 1", "not a TOML file: "),
        ("a.toml", b"\xff", "not a TOML file: "),
        ("a.toml", b"x = " + b"9" * 5000, "not a TOML file: "),
        ("a.json", b"{", "not a JSON file: "),
        ("a.json", b"", "not a JSON file: "),
        ("a.json", b"\xff", "not a JSON file: "),
        ("a.json", b"[" * 100_000, "not a JSON file: "),
        ("a.json", b'{"balls": [{"id": "a", "x": ' + b"9" * 5000 + b"}]}", "not a JSON file: "),
        ("a.json", b"[1]", "allowed is a JSON object with table, conditions, set, position, rack, seed, balls, shot"),
        ("a.json", b'{"balls": 3}', "balls = 3: allowed is a list of balls"),
        ("a.json", b'{"balls": [3]}', "balls[0] = 3: allowed is a ball: id, x, y"),
        ("a.json", b'{"balls": [{"id": "a", "x": NaN, "y": 0.6}]}', "balls[0].x = nan: allowed is a number"),
        ("a.json", b'{"balls": [{"id": "\\ud800", "x": 1, "y": 0.6}]}', "balls[0].id = '\\ud800': allowed is a text"),
        ("a.json", b'{"balls": [{"id": "a", "x": null, "y": 0.6}]}', "balls[0].x = None: allowed is a number"),
        (
            "a.json",
            b'{"two\\nlines": 1}',
            "two\\nlines = 1: unknown; known are balls, conditions, cue, position, rack, seed, set",
        ),
        ("a.json", b'{"table": "' + b"x" * 5000 + b'"}', "table = 'xxx"),
        ("a.json", b'{"table": "a\\u0000"}', "table = 'a\\x00': allowed is a text of printable characters"),
        ("a.txt", b"", "a scenario's name ends in .toml or .json"),
    ],
)
def test_files_that_are_no_scenario(tmp_path: Path, name: str, content: bytes, words: str) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    assert complaint(path).startswith(f"{path}: {words}")


def test_bad_table_file_speaks_for_itself(tmp_path: Path) -> None:
    write(tmp_path, "[cloth]\nmu_slid = 1", "mine.toml")
    path = write(tmp_path, 'table = "mine.toml"')
    assert complaint(path) == f"{tmp_path}/mine.toml: cloth.mu_slid = 1: unknown; did you mean cloth.mu_slide?"
    for name in ("none.toml", "x" * 5000 + ".toml"):
        assert f"{name}: cannot be read: " in complaint(write(tmp_path, f'table = "{name}"'))
    assert "table = 'a\\x00.toml': allowed is a text" in complaint(
        write(tmp_path, '{"table": "a\\u0000.toml"}', "a.json")
    )
