"""What is printed and written: whole, or told in one line, wherever it goes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pool2d.cli import main

from .cli_runs import ROOT, Capture


def test_a_full_disk_is_told_in_one_line(tmp_path: Path) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("no device that is always full")
    path = tmp_path / "s.toml"
    path.write_text('[[balls]]\nid = "cue"\nx = 1.0\ny = 0.5\n')
    with full.open("w") as out:
        done = subprocess.run(
            [sys.executable, "-m", "pool2d", "simulate", str(path)],
            stdout=out, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_link_is_written_through(tmp_path: Path, play: str) -> None:
    link, file = tmp_path / "link.png", tmp_path / "file.png"
    link.symlink_to(file)
    assert main(["render", play, str(link), "--size", "64x64"]) == 0
    assert link.is_symlink()
    assert file.read_bytes().startswith(b"\x89PNG")


def test_where_there_is_no_room_no_stump_is_left(play: str, tmp_path: Path) -> None:
    """A limit on the size of a file is a full disk to who writes: a part is taken, the rest refused."""
    code = (
        "import resource, signal, sys; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "from pool2d.cli import main\nresource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\nsys.exit(main())"
    )
    folder = tmp_path / "out"
    folder.mkdir()
    for out in (folder / "a.png", folder / "a.bmp"):
        environment = {**os.environ, "POOL2D_CACHE": str(tmp_path / "cache")}
        done = subprocess.run(
            [sys.executable, "-c", code, "render", play, str(out), "--size", "320x180"],
            capture_output=True, text=True, check=False, env=environment, cwd=ROOT,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (2, f"pool2d: {out}: cannot be written: File too large\n")
        assert list(folder.iterdir()) == []


def test_names_that_no_terminal_can_take_are_escaped(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    (tmp_path / "tables").mkdir()
    for name in (b"\xff.toml", b"\x1b[2J.toml", b"50%s.toml", b"a\nb.toml"):
        Path(os.fsdecode(os.path.join(os.fsencode(tmp_path), b"tables", name))).write_text("name = 'Mine'")
    (tmp_path / "tables" / "bad.toml").write_text('name = "a\\u0000"')
    assert main(["tables"]) == 0
    out = capsys.readouterr().out
    assert all(line.isprintable() for line in out.splitlines())
    for told in ("\\udcff", "\\x1b[2J", "50%s", "a\\nb", "name = 'a\\x00': allowed is a text"):
        assert told in out
    with pytest.raises(SystemExit):
        main(["play", "--help"])
    assert "50%s" in capsys.readouterr().out.replace("\n", "")


@pytest.mark.parametrize("command", [["tables"], ["simulate", "--json", "PLAY"], ["play", "--help"], ["--version"]])
def test_a_closed_output_is_told_in_one_line(play: str, command: list[str]) -> None:
    words = [play if word == "PLAY" else word for word in command]
    shell = 'exec "$@" >&-'
    done = subprocess.run(
        ["sh", "-c", shell, "sh", sys.executable, "-m", "pool2d", *words],
        stderr=subprocess.PIPE, text=True, check=False, cwd=ROOT,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (2, "pool2d: standard output: cannot be written: it is closed\n")


def test_an_output_of_ascii_alone_takes_every_text(play: str, tmp_path: Path) -> None:
    data = tmp_path / "data"
    (data / "tables").mkdir(parents=True)
    (data / "tables" / "mine.toml").write_text('name = "Größe 球"', encoding="utf-8")
    environment = {**os.environ, "POOL2D_DATA": str(data), "PYTHONIOENCODING": "ascii"}
    done = subprocess.run(
        [sys.executable, "-m", "pool2d", "tables"], capture_output=True, check=False, cwd=ROOT, env=environment
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"Gr\\xf6\\xdfe \\u7403" in done.stdout


def test_errors_that_nobody_can_read_are_still_a_status(play: str) -> None:
    done = subprocess.run(
        ["sh", "-c", 'exec "$@" 2>&-', "sh", sys.executable, "-m", "pool2d", "simulate", play + "x"],
        stdout=subprocess.PIPE, check=False, cwd=ROOT,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (2, b"")
