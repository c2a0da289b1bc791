"""Presets that are wrong, each with the words it is told in; and a fuzzer beside them."""

from __future__ import annotations

import random
import time
from pathlib import Path

import pytest

from pool2d import InputError, load_table
from pool2d.cli import main
from pool2d.config.catalogue import TABLES, find, shipped

SQUARE = "[[outline]]\nx = 0\ny = 0\n[[outline]]\nx = 1\ny = 0\n[[outline]]\nx = 1\ny = 1\n"


def outline(*corners: str) -> str:
    """An outline whose corners are given as "x y" and perhaps more keys."""
    lines = []
    for corner in corners:
        x, y, *rest = corner.split(" ", 2)
        lines += ["[[outline]]", f"x = {x}", f"y = {y}", *rest]
    return "\n".join(lines)


BALLS = '[balls]\nred = ["r1", "r2"]\n'
RACK = BALLS + "[racks.mine]\n"
OPEN = ("0 0", "1 0", "1 1", "0 1")

# What the file says, and what is said of it.
BAD = [
    # Keys and sections.
    ("colour = 1", "colour = 1: unknown"),
    ("[clooth]", "unknown; did you mean cloth?"),
    ("[cloth]\nmu_slid = 0.2", "cloth.mu_slid = 0.2: unknown; did you mean cloth.mu_slide?"),
    ("[corner]\nmouht = 0.1", "did you mean corner.mouth?"),
    ("[table]\nlenght = 2", "did you mean table.length?"),
    ("[marks]\nspot = {}", "marks.spot = {}: unknown; did you mean spots?"),
    ("cloth = 5", "cloth = 5: allowed is a section of keys and values"),
    ("racks = [1]", "racks = [1]: allowed is a section of keys and values"),
    ("marks = true", "marks = True: allowed is a section of keys and values"),
    ("[[cloth]]\nmu_slide = 0.2", "allowed is a section of keys and values"),
    ("name = 5", "name = 5: allowed is a text"),
    ("[name]\na = 1", "name = {'a': 1}: allowed is a text"),
    ("[gravity]\nmu = 1", "gravity = {'mu': 1}: allowed is a number"),
    ("x = = 1", "not a TOML file: "),
    ("name = 'open", "not a TOML file: "),
    ("[table]\n[table]", "not a TOML file: "),
    # Numbers.
    ("gravity = -1", "gravity = -1: allowed is a number from 0.1 to 30 m/s2"),
    ("gravity = true", "gravity = True: allowed is a number from"),
    ("gravity = 1979-05-27", "gravity = datetime.date(1979, 5, 27): allowed is a number"),
    ("[cloth]\nmu_roll = nan", "cloth.mu_roll = nan: allowed is a number from 0.001 to 0.2"),
    ("[cloth]\nmu_roll = inf", "cloth.mu_roll = inf: allowed is a number from 0.001 to 0.2"),
    ("[cloth]\nmu_roll = '0.01'", "cloth.mu_roll = '0.01': allowed is a number"),
    ("[cloth]\nmu_roll = [0.01]", "cloth.mu_roll = [0.01]: allowed is a number"),
    ("[table]\nlength = -2.54", "table.length = -2.54: allowed is a number from 0.5 to 30 m"),
    ("[ball]\nradius = 0", "ball.radius = 0: allowed is a number from 0.01 to 0.06 m"),
    ("[ball]\nlaw = 'soft'", "ball.law = 'soft': allowed is one of "),
    ("[ball]\nlaw = 1", "ball.law = 1: allowed is one of "),
    # Sizes that go against each other.
    ("[corner]\nmouth = 0.3\ndrop_radius = 0.2\n[table]\nwidth = 0.4", "no right cushion between them"),
    ("[side]\nmouth = 0.28\ndrop_radius = 0.2\n[corner]\nmouth = 0.2\ndrop_radius = 0.1\n[table]\nlength = 0.5",
     "no bottom-left cushion between them"),
    ("[corner]\ndrop_radius = 0.02", "corner.drop_radius = 0.02: a ball could pass beside the hole; allowed is 0.0"),
    ("[side]\nangle = 160", "side.angle = 160.0: the facings do not lead into the pocket"),
    ("[corner]\nangle = 170\nshelf = 0.1", "corner.angle = 170.0: the facings meet before the pocket's drop"),
    ("[side]\njaw_radius = 0.15", "side.jaw_radius = 0.15: the jaws are rounder than the pocket is deep"),
    ("[cushion]\nnose_height = 0.06", "cushion.nose_height = 0.06: the nose must be lower than a ball is high"),
    ("[sizes]\ncue = { radius = 0.015, mass = 0.1 }", "the nose must be lower than a ball is high, 0.03 m"),
    # The outline.
    ("outline = 5", "outline = 5: allowed is a list of up to 60 corners"),
    ("outline = [1]", "outline[0] = 1: allowed is a section of keys and values"),
    ("outline = []", "outline = 0: allowed are three corners or more"),
    (outline("0 0", "1 0"), "outline = 2: allowed are three corners or more"),
    (outline(*["0 0"] * 61), "outline = 61: allowed is a list of up to 60 corners"),
    ("[[outline]]\nx = 0", "outline[0].y = None: missing; needed is a number from 0 to 1"),
    (outline("0 2", "1 0", "1 1"), "outline[0].y = 2: allowed is a number from 0 to 1"),
    (outline("nan 0", "1 0", "1 1"), "outline[0].x = nan: allowed is a number from 0 to 1"),
    (outline("'0' 0", "1 0", "1 1"), "outline[0].x = '0': allowed is a number from 0 to 1"),
    (outline("0 0 z = 1", "1 0", "1 1"), "outline[0].z = 1: unknown"),
    (outline("0 0 pocket = 'middle'", "1 0", "1 1"), "outline[0].pocket = 'middle': allowed is corner or side"),
    (outline("0 0 pocket = true", "1 0", "1 1"), "outline[0].pocket = True: allowed is corner or side"),
    (outline("0 0 name = 'a'", "1 0", "1 1"), "outline[0].name = 'a': a name is the pocket's"),
    (outline("0 0 cushion = 5", "1 0", "1 1"), "outline[0].cushion = 5: allowed is a text"),
    (outline("0 0 cushion = ''", "1 0", "1 1"), "outline[0].cushion = '': allowed is a text"),
    (outline("0 0 cushion = 'a'", "1 0 cushion = 'a'", "1 1"), "outline = 'a': this name is used twice"),
    (outline("0 0 pocket = 'corner'\nname = 'p'", "1 0 pocket = 'corner'\nname = 'p'", "1 1", "0 1"), "used twice"),
    (outline("0 0", "1 1", "1 0", "0 1"), "the outline crosses itself at these edges"),
    (outline("0 0", "1 0", "1 1", "0.5 0.01", "0 1"), "come within"),
    (outline("0 0", "1 0", "1 0.01", "1 1", "0 1"), "the edge from here is 0.0127 m long; allowed is 0.12 m or more"),
    (outline("0 0", "0 0", "1 0", "1 1"), "the edge from here is 0 m long"),
    (outline("0 0", "1 0", "1 0.3"), "the angle is too sharp, 8.5; allowed is 30 to 270 degrees"),
    (outline("0 0", "1 0", "0.5 0", "1 1"), "within 0 m of each other"),
    (outline(*OPEN[:3], "0.7 0.6", "0.5 0.15", "0.3 0.6", "0 1"), "allowed is 30 to 270 degrees"),
    (outline("0 0", "1 0", "1 0.5", "0.5 0.5 pocket = 'corner'", "0.5 1", "0 1"), "no pocket where the outline turns"),
    (outline("0 0 pocket = 'side'", *OPEN[1:]), "side.drop_radius = 0.06: a ball could pass beside the hole"),
    (outline("0 0", "0.5 0 pocket = 'corner'", *OPEN[1:]), "corner.angle = 142.0: the facings meet before"),
    (outline("0 0", "1 0", "1 0.5", "0.5 0.5", "0.5 1", "0 1") + "\n[table]\nnose_radius = 0.5\nwidth = 0.6",
     "leave no cushion-"),
    # Marks and balls.
    ("[marks]\nhead_string = 'x'", "marks.head_string = 'x': allowed is a number"),
    ("[marks]\nspots = []", "marks.spots = []: allowed is a section of keys and values"),
    ("[marks.spots]\na = 1", "marks.spots.a = 1: allowed is [x, y] in m"),
    ("[marks.spots]\na = [1, 2, 3]", "marks.spots.a = [1, 2, 3]: allowed is [x, y] in m"),
    ("[marks.spots]\na = [1, nan]", "marks.spots.a = nan: allowed is a number"),
    ("[marks]\nsights = 1e9", "marks.sights = 1000000000.0: allowed is a number from 0 to 100"),
    ("[balls]\ncue = ''", "balls.cue = '': allowed is a ball's id"),
    ("[balls]\nred = 5", "balls.red = 5: allowed is a list of texts"),
    ("[balls]\nred = ['']", "balls = '': allowed is a text of printable characters, not empty"),
    ('[balls]\nred = ["a\\u0007"]', "balls.red[0] = 'a\\x07': allowed is a text of printable characters"),
    ("[balls]\nred = ['cue']", "balls = 'cue': more than one ball has this id"),
    (f"[balls]\nred = {[str(i) for i in range(200)]}", "balls = 201: allowed are 120 balls"),
    ("[sizes]\ncue = 5", "sizes.cue = 5: allowed is a section of keys and values"),
    ("[sizes]\ncue = { radius = 0.02 }", "sizes.cue.mass = None: missing"),
    ("[sizes]\ncue = { radius = nan, mass = 0.1 }", "sizes.cue.radius = nan: allowed is a number"),
    ("[sizes]\nblue = { radius = 0.02, mass = 0.1 }", "sizes.blue = "),
    ("[finish]\ncloth = 'blue'", "finish.cloth = 'blue': allowed is a colour such as"),
    ("[finish]\nwood = 7", "finish.wood = 7: allowed is a colour such as"),
    ("[finish]\nclot = '#102030'", "finish.clot = '#102030': unknown; did you mean cloth?"),
    ("finish = 1", "finish = 1: allowed is a section of keys and values"),
    ("[looks]\ncue = 'red'", "looks.cue = 'red': allowed is a section of keys and values"),
    ("[looks]\ncue = { color = 'red' }", "looks.cue.color = 'red': allowed is a colour such as"),
    ("[looks]\ncue = { color = '#ffffff', stripe = 1 }", "looks.cue.stripe = 1: allowed is true or false"),
    ("[looks]\ncue = { color = '#ffffff', number = 12 }", "looks.cue.number = 12: allowed is true, false or a text"),
    ("[looks]\ncue = { colour = '#ffffff' }", "looks.cue.colour = '#ffffff': unknown; did you mean color?"),
    # Racks.
    ("[racks]\nmine = 5", "racks.mine = 5: allowed is a section of keys and values"),
    (RACK + "rows = [['red']]", "racks.mine.spot = None: not a spot under marks.spots"),
    (RACK + "spot = 'foot'", "racks.mine.spot = 'foot': not a spot under marks.spots"),
    (RACK + "spot = ['foot']", "racks.mine.spot = ['foot']: allowed is [x, y] in m"),
    (RACK + "cue = {}", "racks.mine.cue = {}: not a spot under marks.spots"),
    (RACK + "rows = 'red'", "racks.mine.rows = 'red': allowed is a list of rows"),
    (RACK + "spot = 'head'\nrows = [['red', 'red', 'red']]", "more slots than the 2 balls left in the group"),
    (RACK + "spot = 'head'\nrows = [['blue']]", "racks.mine.rows = 'blue': unknown"),
    (RACK + "spot = 'head'\nrows = [['red']]\non = 2", "racks.mine.on = 2: allowed is a number from 1 to 1"),
    (RACK + "balls = ['r1', 'r1']", "racks.mine.balls = 'r1': this ball is named twice"),
    (RACK + "balls = ['r9']", "racks.mine.balls = 'r9': unknown; known are r1, r2"),
    (RACK + "placed = { r1 = 'black' }", "racks.mine.placed.r1 = 'black': not a spot under marks.spots"),
    (RACK + "placed = { blue = 'head' }", "racks.mine.balls = 'blue': unknown"),
    (RACK + "placed = { r1 = [0.5, 0.5] }\nspot = 'head'\nrows = [['r1']]", "racks.mine.rows = 'r1': unknown"),
    (RACK + "placed = { r1 = 'head' }", "the balls overlap by"),
    (RACK + "placed = { r1 = [5, 0.5] }", "the ball is off the table"),
    # Bases.
    ("base = 5", "base = 5: allowed is a preset's name or a path to a .toml file"),
    ("base = 'pool-9f'", "base = 'pool-9f': unknown; did you mean pool-9ft?"),
    ("base = 'bad.toml'", "base = 'bad.toml': allowed is none that builds on this file itself"),
    ("base = './/bad.toml'", "allowed is none that builds on this file itself"),
    ("base = 'none.toml'", "none.toml: cannot be read: No such file or directory"),
    ('base = "a\\u0000.toml"', "\\x00"),
    ("base = 'snooker-12ft'\n[balls]\nred = []", "racks.snooker.rows = 'red': more slots than the 0 balls left"),
]  # fmt: skip


def one_line(path: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """What `tables --check` says of a bad file."""
    before = sorted(path.parent.rglob("*"))
    start = time.monotonic()
    assert main(["tables", "--check", str(path)]) == 2
    assert time.monotonic() - start < 10.0
    out, err = capsys.readouterr()
    assert out == ""
    assert err.endswith("\n")
    assert err[:-1].isprintable()
    assert "Traceback" not in err
    assert len(err) < 1500 + 3 * len(str(path))
    assert sorted(path.parent.rglob("*")) == before
    return err[:-1]


@pytest.mark.parametrize(("text", "words"), BAD)
def test_a_bad_preset_is_told_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, words: str
) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(text)
    said = one_line(path, capsys)
    assert words in said
    assert "bad.toml" in said or "none.toml" in said


def test_there_are_enough_of_them() -> None:
    assert len(BAD) >= 60


def test_a_ring_of_bases(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, base in (("a", "b"), ("b", "c"), ("c", "a")):
        (tmp_path / f"{name}.toml").write_text(f"base = '{base}.toml'")
    assert "c.toml: base = 'a.toml': allowed is none that builds on this file itself" in one_line(
        tmp_path / "a.toml", capsys
    )


def test_a_long_chain_of_bases_ends(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number in range(400):
        (tmp_path / f"{number}.toml").write_text(f"base = '{number + 1}.toml'")
    said = one_line(tmp_path / "0.toml", capsys)
    assert "20.toml: base = '21.toml': allowed are up to 20 bases below each other" in said
    (tmp_path / "20.toml").write_text("")
    load_table(tmp_path / "0.toml")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("\n".join(f"[racks.r{i}]" for i in range(30_000)), "too large; allowed are 256 KiB"),
        ("[racks]\n" + "\n".join(f"r{i}={{}}" for i in range(20_000)), "racks = 20000: allowed are up to 250 names"),
        ("[balls]\n" + "\n".join(f"g{i}=[]" for i in range(16_000)), "balls = 16000: allowed are up to 250 names"),
        ("[marks.spots]\n" + "\n".join(f"s{i}=[0,0]" for i in range(251)), "marks.spots = 251: allowed are up to 250"),
        (f"name = '{'x' * 50_000}'", "allowed is a text of up to 80 characters on one line"),
        ('name = "two\\nlines"', "name = 'two\\nlines': allowed is a text of up to 80 characters on one line"),
        (f"[balls]\nred = ['{'x' * 41}']", "allowed is a text of printable characters, not empty, up to 40"),
        (f"[balls]\n{'x' * 41} = []", "allowed is a name of up to 40 printable characters"),
        ("[balls]\nred = [' ']", "balls = ' ': allowed is a text of printable characters"),
        (RACK + f"rows = {[[]] * 130}", "allowed is a list of rows of slots, up to 120"),
    ],
)
def test_more_than_any_table_has_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], content: str, words: str
) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(content)
    assert words in one_line(path, capsys)


def test_what_is_wrong_in_a_base_is_said_of_the_base(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text("base = 'sub/b.toml'\n[cloth]\nmu_roll = 0.02")
    (tmp_path / "sub").mkdir()
    for text, key in (("[cloth]\nmu_slide = 9", "cloth.mu_slide"), ("[marks]\nsights = -1", "marks.sights")):
        (tmp_path / "sub" / "b.toml").write_text(text)
        with pytest.raises(InputError) as caught:
            load_table(tmp_path / "a.toml")
        assert caught.value.source == str(tmp_path / "sub" / "b.toml")
        assert caught.value.key == key


@pytest.mark.parametrize(
    "content",
    [
        b"", b"\xff\xfe\x00", b"a = '" + b"x" * 900_000, b"[" * 900_000, b"=\n" * 400_000, b"x" * 900_000,
        b"a" + b".a" * 400_000 + b" = 1", b"a = { b" + b" . b" * 100_000 + b" = 1 }", b"a = 1." * 100_000,
    ],
    ids=["empty", "bytes", "open", "brackets", "lines", "word", "dots", "inner dots", "more dots"],
)  # fmt: skip
def test_large_nonsense_ends_soon(tmp_path: Path, capsys: pytest.CaptureFixture[str], content: bytes) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    if content:
        one_line(path, capsys)
    else:
        load_table(path)


def test_ten_megabytes_of_noise(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(random.Random(1).randbytes(10_000_000))
    assert "too large; allowed are 256 KiB" in one_line(path, capsys)


VALUES = [
    "nan", "inf", "-1", "0", "1e300", "true", "'x'", "''", "[]", "{}", "[[]]", "[1, 2]", "[nan, 1]", "[['any']]",
    "{ a = 1 }", "1979-05-27", '"\\u0000"', "99999999999999999999999999", "[{ x = 0, y = 0 }, 1]",
]  # fmt: skip


def spoiled(text: str, rng: random.Random) -> bytes:
    """A preset with some of it cut, overwritten, repeated or given another value."""
    way = rng.randrange(5)
    data = text.encode()
    at = rng.randrange(len(data))
    if way == 0:
        return data[:at]
    if way == 1:
        return data[:at] + rng.randbytes(rng.randrange(1, 8)) + data[at + rng.randrange(8) :]
    lines = text.splitlines()
    row = rng.randrange(len(lines))
    if way == 2:
        return "\n".join(lines[:row] + lines[row + rng.randrange(1, 4) :]).encode()
    if way == 3:
        return "\n".join([*lines, *lines[row : row + rng.randrange(1, 9)]]).encode()
    keyed = [i for i, line in enumerate(lines) if "=" in line and not line.startswith("#")]
    for row in rng.sample(keyed, min(len(keyed), rng.randrange(1, 4))):
        lines[row] = f"{lines[row].partition('=')[0]}= {rng.choice(VALUES)}"
    return "\n".join(lines).encode()


@pytest.mark.parametrize("name", shipped(TABLES))
def test_spoiled_presets_load_or_are_told_in_one_line(name: str, tmp_path: Path) -> None:
    rng, text = random.Random(name), find(TABLES, name).read_text()
    path = tmp_path / "spoiled.toml"
    told = 0
    for _ in range(150):
        path.write_bytes(spoiled(text, rng))
        try:
            table = load_table(path)
            for rack in table.furniture.racks:
                table.rack(rack)
        except InputError as error:
            told += 1
            assert str(error).isprintable()
            assert len(str(error)) < 1500
    assert told > 20
