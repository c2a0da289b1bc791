"""GIF files: read again by a decoder written from the specification, they show what was put in."""

from __future__ import annotations

import math
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.random_play import new_match
from pool2d import InputError
from pool2d.cli import main
from pool2d.commands.replay import shot_of
from pool2d.draw.export.animation import frames
from pool2d.draw.export.gif import encode, lzw, median_cut
from pool2d.game.actions import Stroke
from pool2d.game.records.record import load
from pool2d.game.records.recorder import record
from pool2d.game.records.replaying import strokes
from pool2d.physics.values import Shot


def unlzw(data: bytes, root: int = 8) -> bytes:
    """What GIF's LZW holds (89a, appendix F)."""
    clear, end = 1 << root, (1 << root) + 1
    table: list[bytes] = []
    size, out, before = root + 1, bytearray(), b""
    bits = int.from_bytes(data, "little")
    while True:
        code = bits & (1 << size) - 1
        bits >>= size
        if code == clear:
            table = [bytes([i]) for i in range(1 << root)] + [b"", b""]
            size, before = root + 1, b""
            continue
        if code == end:
            assert bits == 0
            return bytes(out)
        assert code <= len(table)
        word = table[code] if code < len(table) else before + before[:1]
        if before and len(table) < 4096:
            table.append(before + word[:1])
        if len(table) == 1 << size and size < 12:
            size += 1
        out += word
        before = word


def pictures(content: bytes) -> tuple[list[np.ndarray[Any, Any]], list[int]]:
    """The pictures of a GIF as its reader shows them, and their delays."""
    assert content[:6] == b"GIF89a"
    width, height, flags = struct.unpack("<HHB", content[6:11])
    assert flags == 0xF7
    palette = np.frombuffer(content[13 : 13 + 768], np.uint8).reshape(256, 3)
    at, clear, found, delays = 13 + 768, -1, [], []
    canvas = np.zeros((height, width, 3), np.uint8)
    while content[at] != 0x3B:
        if content[at] == 0x21:
            if content[at + 1] == 0xF9:
                packed, delay, index = struct.unpack("<BHB", content[at + 3 : at + 7])
                clear = index if packed & 1 else -1
                delays.append(delay)
            at += 2
            part = b""
        else:
            assert content[at] == 0x2C
            left, top, wide, high, _ = struct.unpack("<HHHHB", content[at + 1 : at + 10])
            assert content[at + 10] == 8
            at += 11
            part = b"image"
        coded = b""
        while size := content[at]:
            coded += content[at + 1 : at + 1 + size]
            at += 1 + size
        at += 1
        if part:
            indices = np.frombuffer(unlzw(coded), np.uint8).reshape(high, wide)
            box = canvas[top : top + high, left : left + wide]
            box[indices != clear] = palette[indices[indices != clear]]
            found.append(canvas.copy())
    assert at == len(content) - 1
    return found, delays


@given(st.binary(min_size=1, max_size=400), st.integers(1, 60))
def test_lzw_comes_back(data: bytes, times: int) -> None:
    assert unlzw(lzw(data * times)) == data * times


def test_lzw_comes_back_where_codes_grow_and_run_out() -> None:
    noise = np.random.default_rng(1).integers(0, 256, 30_000).astype(np.uint8).tobytes()
    for size in (*range(250, 262), *range(760, 772), *range(3830, 3850), 30_000):
        assert unlzw(lzw(noise[:size])) == noise[:size]


def test_few_colours_come_back_as_they_are() -> None:
    rng = np.random.default_rng(2)
    colors = rng.integers(0, 64, (200, 3)).astype(np.uint8) * 4
    shown = [colors[rng.integers(0, 200, (20, 30))] for _ in range(3)]
    shown[1][:] = shown[0]
    found, delays = pictures(encode(shown, median_cut(shown), 4, 100))
    assert delays == [4, 4, 4, 100]
    for there, was in zip(found, [*shown, shown[-1]], strict=True):
        assert np.abs(there.astype(int) - was).max() <= 3


def test_a_palette_keeps_a_rare_colour() -> None:
    cloth = np.stack([np.zeros(50_000), 90 + np.arange(50_000) % 80, 70 + np.arange(50_000) % 61], axis=1)
    colors = np.concatenate([cloth, [[220, 30, 30]] * 40]).astype(np.uint8)
    palette = median_cut([colors]).astype(int)
    assert len(palette) <= 255
    assert np.abs(palette - (220, 30, 30)).sum(axis=1).min() <= 6


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    path = tmp_path / "a.jsonl"
    with record(new_match("nine-ball", 3), path) as recorder:
        recorder.play(Stroke(Shot(180.0, 0.3)))
        recorder.undo()
        recorder.play(Stroke(Shot(180.0, 0.2)))
        recorder.play(Stroke(Shot(180.0, 0.1)))
    return path


def test_a_shot_becomes_a_gif(recorded: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "a.gif"
    assert main(["replay", str(recorded), "--gif", str(out), "--shot", "1", "--size", "160x90"]) == 0
    assert capsys.readouterr().out == f"{out}: shot 1\n"
    found, delays = pictures(out.read_bytes())
    # Every 25th of a second up to the balls' rest, and the last once more, to be held.
    assert len(found) == math.ceil(25 * next(strokes(load(recorded))).rollout.duration) + 2
    assert set(delays[:-1]) == {4}
    assert delays[-1] == 100
    assert (found[0] != found[-1]).any()
    whole = pygame.image.load(out)
    assert whole.get_size() == (160, 90)


def test_a_shot_becomes_pictures(recorded: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "shots"
    assert main(["replay", str(recorded), "--png", str(folder), "--size", "160x90"]) == 0
    names = sorted(path.name for path in folder.iterdir())
    assert names[0] == "shot-003-0001.png"
    assert f"{len(names)} pictures of shot 3" in capsys.readouterr().out
    assert pygame.image.load(folder / names[-1]).get_size() == (160, 90)
    # A picture every 25th of a second, the last no earlier than the balls' rest.
    shot = list(strokes(load(recorded)))[-1]
    assert shot.rollout.duration <= (len(names) - 1) / 25 < shot.rollout.duration + 1 / 25
    (fourth,) = frames(shot.match.table, shot.rollout, (160, 90), [3 / 25])
    written = pygame.image.load(folder / "shot-003-0004.png")
    assert pygame.image.tobytes(written, "RGB") == pygame.image.tobytes(fourth, "RGB")


def test_a_stroke_is_found_by_its_number_and_without_one_it_is_the_last(recorded: Path) -> None:
    whole = load(recorded)
    digests = [stroke.rollout.digest() for stroke in strokes(whole)]
    assert len(set(digests)) == 3
    assert [shot_of(whole, number).rollout.digest() for number in (1, 2, 3, None)] == [*digests, digests[-1]]
    for number in (-1, 0, 4):
        with pytest.raises(InputError, match=f"--shot = {number}: allowed is 1 to 3"):
            shot_of(whole, number)


def test_a_record_is_listed(recorded: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", str(recorded), "--list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3
    assert "The cue ball hit no ball." in lines[0]


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["--gif", "a.png"], "a.png: a moving picture's name ends in .gif"),
        (["--gif", "a.gif", "--shot", "4"], "--shot = 4: allowed is 1 to 3"),
        (["--gif", "a.gif", "--shot", "x"], "--shot = 'x': allowed is a number"),
        (["--gif", "a.gif", "--size", "x"], "--size = 'x'"),
        (["--gif", "/dev/null/a.gif"], "/dev/null/a.gif: cannot be written"),
        (["--png", "/dev/null/a"], "/dev/null/a: cannot be written"),
        (["--verify", "--list"], "not allowed with"),
    ],
)
def test_bad_exports_are_one_line(
    recorded: Path, words: list[str], line: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(recorded.parent)
    assert main(["replay", str(recorded), *words]) == 2
    told = capsys.readouterr()
    assert (told.out, told.err.count("\n")) == ("", 1)
    assert line in told.err
