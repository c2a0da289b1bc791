"""All that is read from outside: regular files of a limited size, with values that are sound."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest

from pool2d import InputError
from pool2d.config.reader import check_sound, parse_json, read_bytes, read_json, read_toml
from pool2d.printable import printable


def complaint(path: Path, content: bytes) -> str:
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        (read_toml if path.suffix == ".toml" else read_json)(path)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 400
    return str(caught.value).removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (
            b"a = 0x" + b"f" * 5000,
            "a = (a number of more than 4300 digits): allowed is a whole number of up",
        ),
        (b"a = 9223372036854775808", "a = 9223372036854775808: allowed is a whole number"),
        (b"a = -9223372036854775809", "a = -9223372036854775809: allowed is a whole number"),
        (b"b.c = [1, 0b" + b"1" * 70 + b"]", "b.c[1] = 1180591620717411303423"),
        (b'a = "x\\u0000"', "a = 'x\\x00': allowed is a text of printable characters"),
        (b'a = "\\u202eevil"', "a = '\\u202eevil': allowed is a text"),
        (b'a = "\\u200b"', "a = '\\u200b': allowed is a text"),
        (b'a = "\\u001b[31m"', "a = '\\x1b[31m': allowed is a text"),
        (b'"k\\u0007" = 1', "k\\x07 = 'k\\x07': allowed is a text"),
        (b"a = " + b"[" * 25 + b"]" * 25, "nested too deep; allowed are 20 levels"),
        (b"a = [" + b"1," * 110_000 + b"]", "too many values; allowed are 100000"),
        (b"a = 1\na = 2", "not a TOML file: "),
        (b"#" * (1 << 18) + b"#", "too large; allowed are 256 KiB"),
    ],
)
def test_toml_that_is_not_sound(tmp_path: Path, content: bytes, words: str) -> None:
    assert complaint(tmp_path / "a.toml", content).startswith(words)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b'{"a": 1, "b": {"c": 1, "c": 2}}', "not a JSON file: the key 'c' is there twice"),
        (b'{"a": 1' + b"0" * 400 + b"}", "a = 1000"),
        (b'{"a": "\\ud800"}', "a = '\\ud800': allowed is a text of printable characters"),
        (b'{"\\ud800": 1}', "\\ud800 = '\\ud800': allowed is a text"),
        (b'["\\u0000"]', "[0] = '\\x00': allowed is a text"),
        (b"[" * 30 + b"]" * 30, "nested too deep"),
        (b" " * (1 << 20) + b"{}", "too large; allowed are 1 MiB"),
    ],
)
def test_json_that_is_not_sound(tmp_path: Path, content: bytes, words: str) -> None:
    assert complaint(tmp_path / "a.json", content).startswith(words)


@pytest.mark.parametrize(
    ("name", "enough", "more", "words"),
    [
        ("a.toml", b"#" * (1 << 18), b"#", "too large; allowed are 256 KiB"),
        ("a.json", b" " * ((1 << 20) - 2) + b"{}", b" ", "too large; allowed are 1 MiB"),
        # A value in 19 lists lies in the table too.
        ("a.toml", b"a = " + b"[" * 20 + b"]" * 20, b"\nb = " + b"[" * 21 + b"]" * 21, "nested too deep"),
        ("a.toml", b"a = 9223372036854775807", b"\nb = 9223372036854775808", "b = 9223372036854775808"),
    ],
)
def test_as_much_as_is_allowed_is_read_and_no_more(
    tmp_path: Path, name: str, enough: bytes, more: bytes, words: str
) -> None:
    path = tmp_path / name
    path.write_bytes(enough)
    (read_toml if path.suffix == ".toml" else read_json)(path)
    assert complaint(path, enough + more).startswith(words)


def test_a_hundred_thousand_values_are_read_and_one_more_is_not() -> None:
    # A list of n values has n + 1 with itself, and the file's own.
    check_sound([0] * 100_000, "a.json")
    with pytest.raises(InputError, match="too many values; allowed are 100000"):
        check_sound([0] * 100_001, "a.json")


def test_what_is_sound_comes_back_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_text('a = [1, -9223372036854775808, 0.5, true, "Ä 球 \\n x\\t"]\nb.c = 1979-05-27\n', encoding="utf-8")
    data = read_toml(path)
    assert data["a"] == [1, -(2**63), 0.5, True, "Ä 球 \n x\t"]
    assert str(data["b"]["c"]) == "1979-05-27"


def test_the_mark_that_some_editors_put_in_front_is_passed_over(tmp_path: Path) -> None:
    for name, content in (("a.toml", b"\xef\xbb\xbfa = 1"), ("a.json", b'\xef\xbb\xbf{"a": 1}')):
        (tmp_path / name).write_bytes(content)
    assert read_toml(tmp_path / "a.toml") == read_json(tmp_path / "a.json") == {"a": 1}


def test_only_regular_files_are_read(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, Path("/dev/zero")):
        with pytest.raises(InputError, match="cannot be read: not a regular file"):
            read_bytes(path)
    with pytest.raises(InputError, match="Is a directory"):
        read_bytes(tmp_path)


def test_a_file_that_becomes_a_pipe_is_not_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pipe, file = tmp_path / "pipe", tmp_path / "file"
    os.mkfifo(pipe)
    file.write_text("")
    looked = os.stat(file)
    monkeypatch.setattr("pool2d.config.reader.os.stat", lambda path: looked)
    done = threading.Event()

    def read() -> None:
        read_bytes(pipe)
        done.set()

    threading.Thread(target=read, daemon=True).start()
    assert done.wait(20.0)


def test_a_line_of_json_is_told_with_its_number() -> None:
    with pytest.raises(InputError, match=r"f, line 7: do = '\\ud800': allowed is a text"):
        parse_json(b'{"do": "\\ud800"}', "f", 7)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain Ä 球", "plain Ä 球"),
        ("a\x00b\x1b[2Jc\nd", "a\\x00b\\x1b[2Jc\\nd"),
        ("\u202eabc\u200b\u2028", "\\u202eabc\\u200b\\u2028"),
        ("\udcff.toml", "\\udcff.toml"),
        ("5\u00a0m", "5\u00a0m"),
        ("x" * 50_000, "x" * 1997 + "..."),
    ],
)
def test_text_that_is_shown(text: str, shown: str) -> None:
    assert printable(text) == shown
