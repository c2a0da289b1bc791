"""Preset files: what is good is taken, and what is not is told in one line."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

from pool2d import InputError, load_table
from pool2d.config.assets import asset, assets
from pool2d.config.knobs import walk
from pool2d.table.preset import presets

GOOD = """
name = "Small"
[table]
length = 2.0
width = 1.0
[cloth]
mu_slide = 0.25
[marks]
head_string = 0.5
spots = { head = [0.5, 0.5], foot = [1.5, 0.5] }
sights = 8
sight_inset = 0.09
[balls]
cue = "white"
red = ["r1", "r2", "r3"]
other = ["black"]
[racks.tiny]
spot = "foot"
rows = [["black"], ["red", "any"]]
"""


def write(path: Path, text: str) -> str:
    path.write_text(text)
    return str(path)


def complaint(name: str, overrides: dict[str, Any] | None = None) -> str:
    with pytest.raises(InputError) as caught:
        load_table(name, overrides)
    text = str(caught.value)
    assert text.isprintable()
    # Which line it is about is test_lines.py's to say.
    return re.sub(r", line \d+:", ":", text)


@pytest.mark.parametrize("name", presets())
def test_shipped_presets_load_and_rack(name: str) -> None:
    table = load_table(name)
    assert table.source == name
    assert table.title
    for rack in table.furniture.racks:
        found = table.furniture.racks[rack]
        assert len(table.rack(rack)) == 1 + sum(len(row) for row in found.rows) + len(found.placed)
    # What the file says is what the table has, whatever its base says.
    for key, value in tomllib.loads(asset("tables", name + ".toml").read_text()).items():
        if key in ("table", "corner", "side", "ball", "cushion", "cloth", "cue"):
            have = {full: present for full, _, present in walk(table.knobs)}
            assert all(have[f"{key}.{inner}"] == one for inner, one in value.items())


def test_presets_are_the_files_in_assets() -> None:
    assert "pool-9ft" in presets()
    assert presets() == [path.stem for path in assets("tables", ".toml")]


def test_preset_of_your_own(tmp_path: Path) -> None:
    table = load_table(write(tmp_path / "mine.toml", GOOD), {"cloth.mu_roll": 0.02})
    assert (table.title, table.knobs.table.length, table.knobs.table.width) == ("Small", 2.0, 1.0)
    assert (table.knobs.cloth.mu_slide, table.knobs.cloth.mu_roll) == (0.25, 0.02)
    assert (table.furniture.cue, table.furniture.sights) == ("white", 8)
    assert table.furniture.balls == ["r1", "r2", "r3", "black"]
    rack = table.rack("tiny")
    assert rack["black"].x == min(ball.x for ball in rack.values() if ball.id != "white")
    assert len(rack) == 4
    # No gap: they touch.
    red = [ball for ball in rack.values() if ball.id.startswith("r")]
    assert math.hypot(red[0].x - red[1].x, red[0].y - red[1].y) == pytest.approx(2.0 * table.knobs.ball.radius)


def test_an_outline_may_go_round_either_way(tmp_path: Path) -> None:
    """A cushion is named with the corner that it leaves: clockwise that is its other end."""
    corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.6), (0.5, 1.0), (0.0, 1.0)]
    tables = []
    for order, leaves in ((range(5), 0), (range(4, -1, -1), -1)):
        lines = ["base = 'carom-10ft'"]
        for i in order:
            x, y = corners[i]
            lines.append(f"[[outline]]\nx = {x}\ny = {y}\ncushion = 'side {(i + leaves) % 5}'")
        tables.append(load_table(write(tmp_path / f"{leaves}.toml", "\n".join(lines))))
    names = {(one.cushion, round(one.x, 9), round(one.y, 9)) for one in tables[0].geometry.corners}
    assert len(names) == 5
    assert names == {(one.cushion, round(one.x, 9), round(one.y, 9)) for one in tables[1].geometry.corners}


@pytest.mark.parametrize(("length", "allowed"), [(80, True), (81, False)])
def test_a_name_has_up_to_eighty_characters(tmp_path: Path, length: int, allowed: bool) -> None:
    path, title = write(tmp_path / "mine.toml", f"name = '{'x' * length}'"), "x" * length
    if allowed:
        assert load_table(path).title == title
    else:
        with pytest.raises(InputError, match="up to 80 characters"):
            load_table(path)


def test_preset_without_a_name_has_its_files(tmp_path: Path) -> None:
    assert load_table(write(tmp_path / "bare.toml", "")).title == "bare"


def test_a_table_without_marks_has_a_head_spot_at_a_quarter_of_its_length(tmp_path: Path) -> None:
    table = load_table(write(tmp_path / "bare.toml", "[table]\nlength = 2.4\nwidth = 1.2"))
    assert table.furniture.spots == {"head": pytest.approx((0.6, 0.6))}


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("mu_slide = 0.25", "mu_slid = 0.25", "cloth.mu_slid = 0.25: unknown; did you mean cloth.mu_slide?"),
        ("mu_slide = 0.25", "mu_slide = 9", "cloth.mu_slide = 9: allowed is a number from 0.01 to 1"),
        ("mu_slide = 0.25", "mu_slide = nan", "cloth.mu_slide = nan: allowed is a number from 0.01 to 1"),
        ("mu_slide = 0.25", "mu_slide = 'x'", "cloth.mu_slide = 'x': allowed is a number"),
        ("mu_slide = 0.25", "mu_slide = { a = 1 }", "cloth.mu_slide = {'a': 1}: allowed is a number"),
        ("[cloth]", "[clothes]", "clothes = {'mu_slide': 0.25}: unknown; did you mean cloth?"),
        ("[cloth]\nmu_slide = 0.25", "[ball]\nlaw = 'hard'", "ball.law = 'hard': allowed is one of "),
        ('name = "Small"', "name = 3", "name = 3: allowed is a text"),
        ("[table]", "[tables]\n[table]", "tables = {}: unknown; did you mean table?"),
        ("[table]", "[table.length]\n[cue]", "table.length = {}: allowed is a number from 0.5 to 30 m"),
        ("sights = 8", "sights = -1", "marks.sights = -1: allowed is a number from 0 to 100"),
        ("sights = 8", "sigths = 8", "marks.sigths = 8: unknown; did you mean sights?"),
        ("head_string = 0.5", "head_string = 'x'", "marks.head_string = 'x': allowed is a number"),
        ("foot = [1.5, 0.5]", "foot = [1.5]", "marks.spots.foot = [1.5]: allowed is [x, y] in m"),
        ("foot = [1.5, 0.5]", "foot = [1.5, inf]", "marks.spots.foot = inf: allowed is a number"),
        ('spot = "foot"', 'spot = "foot"\ncue = "start"', "racks.tiny.cue = 'start': not a spot under marks.spots"),
        ('cue = "white"', "cue = 1", "balls.cue = 1: allowed is a ball's id"),
        ('other = ["black"]', 'other = "black"', "balls.other = 'black': allowed is a list of texts"),
        ('other = ["black"]', 'other = ["white"]', "balls = 'white': more than one ball has this id"),
        ('other = ["black"]', 'other = ["black", "r1"]', "balls = 'r1': more than one ball has this id"),
        ('other = ["black"]', "other = [1]", "balls.other = [1]: allowed is a list of texts"),
        ('spot = "foot"', 'spot = "feet"', "racks.tiny.spot = 'feet': not a spot under marks.spots"),
        ('spot = "foot"', 'spot = "foot"\ngap = 1', "racks.tiny.gap = 1: allowed is a number from 0 to 0.01 m"),
        ('spot = "foot"', 'spot = "foot"\ngab = 1', "racks.tiny.gab = 1: unknown; did you mean gap?"),
        ('"red", "any"', '"red", "blu"', "racks.tiny.rows = 'blu': unknown; known are any, black, other, r1"),
        ('"red", "any"', '"black", "any"', "racks.tiny.rows = 'black': more than one slot names this ball"),
        ('"red", "any"', '"red", "red"], ["red", "red"', "racks.tiny.rows = 'red': more slots than the 3 balls left"),
        ('"red", "any"', '"any", "any"], ["any", "any"', "racks.tiny.rows = 5: more slots than the 4 balls"),
        ('[["black"], ["red", "any"]]', "3", "racks.tiny.rows = 3: allowed is a list of rows"),
        ('[["black"], ["red", "any"]]', "[3]", "racks.tiny.rows = 3: allowed is a list of texts"),
        ("[racks.tiny]", "[racks]\nbig = 3\n[racks.tiny]", "racks.big = 3: allowed is a section"),
        ("width = 1.0", "width = 0.31\n[side]\nmouth = 0.1\n[corner]\nmouth = 0.3\ndrop_radius = 0.2", "corner.mouth"),
    ],
)
def test_bad_presets_are_told_in_one_line(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in GOOD
    path = write(tmp_path / "bad.toml", GOOD.replace(old, new))
    text = complaint(path)
    assert text.startswith(f"{path}: {words}")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"a = = 1", "not a TOML file: "),
        (b"\xff\xfe", "not a TOML file: "),
        (b"a = 1\na = 2", "not a TOML file: "),
        (b"a = " + b"[" * 100_000, "not a TOML file: "),
        (b"gravity = " + b"9" * 5000, "not a TOML file: "),
        (b"gravity = " + b"9" * 400, "gravity = 999"),
    ],
)
def test_files_that_are_not_toml(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    assert complaint(str(path)).startswith(f"{path}: {words}")


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    missing = tmp_path / "none.toml"
    assert complaint(str(missing)) == f"{missing}: cannot be read: No such file or directory"
    folder = tmp_path / "folder.toml"
    folder.mkdir()
    assert complaint(str(folder)) == f"{folder}: cannot be read: Is a directory"
    assert "cannot be read: File name too long" in complaint("x" * 5000 + ".toml")
    assert "\\x00" in complaint("a\0b.toml")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("pool9ft", "table = 'pool9ft': unknown; did you mean pool-9ft?; or a path to a .toml file"),
        ("", "table = '': unknown; known are "),
        ("../tables/pool-9ft", "unknown"),
        ("x" * 5000, "unknown"),
        ("a\0b", "unknown"),
    ],
)
def test_unknown_presets(name: str, words: str) -> None:
    assert words in complaint(name)


def test_overrides_are_checked_like_the_file() -> None:
    assert "did you mean cloth.mu_slide?" in complaint("pool-9ft", {"cloth.mu_slid": 1.0})
    assert "cloth.mu_slide = 9.0: allowed is a number from 0.01 to 1" in complaint("pool-9ft", {"cloth.mu_slide": 9.0})
