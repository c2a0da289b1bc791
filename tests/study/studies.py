"""Studies for tests: two balls, a few shots."""

from __future__ import annotations

from pathlib import Path

from pool2d.cli import main

SCENARIO = """
[[balls]]
id = "cue"
x = 0.635
y = 0.635
[[balls]]
id = "1"
x = 2.0
y = 1.0
[shot]
angle = 15.0
speed = 2.0
"""
# Of 60 shots, some pot the ball; those with side 0.9 have the tip off the ball.
SWEEP = """
[grid]
side = [0.0, 0.9]
height = [-0.5, 0.0]
angle = { from = 14.0, to = 15.0, count = 5 }
[noise]
angle = 0.1
speed = 0.2
[study]
shots = 3
seed = 5
outcome = "potted.1"
"""
SHOTS = 60


def written(folder: Path, text: str = SCENARIO + SWEEP, name: str = "study.toml") -> Path:
    """A study's file."""
    file = folder / name
    file.write_text(text)
    return file


def played(file: Path, *words: str) -> int:
    """Run the command, in one process; its exit status."""
    return main(["study", str(file), "--workers", "1", "--size", "320x180", *words])
