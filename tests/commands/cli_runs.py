"""The command line run in a test, and what it answers."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from pool2d.cli import main

PLAY = """
[[balls]]
id = "cue"
x = 0.635
y = 0.635
[[balls]]
id = "1"
x = 1.905
y = 0.635
[shot]
angle = -1.0
speed = 3.0
side = 0.2
"""

ROOT = Path(__file__).resolve().parents[2]

Capture = pytest.CaptureFixture[str]


def answer(capsys: Capture, *words: str) -> list[dict[str, Any]]:
    """The objects that `simulate --json` prints."""
    assert main(["simulate", "--json", *words]) == 0
    told = capsys.readouterr()
    assert told.err == ""
    return [json.loads(line, parse_constant=pytest.fail) for line in told.out.splitlines()]


def refusal(capsys: Capture, *words: str) -> str:
    """The one line that bad input gets."""
    assert main(list(words)) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.endswith("\n")
    line = told.err[:-1]
    assert line.isprintable()
    return line


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, *words], capture_output=True, text=True, cwd=ROOT, check=False, timeout=60)
