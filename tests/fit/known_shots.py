"""Shots whose tracks are known: made by the engine on the carom table, without a camera's noise or with it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pool2d import Ball, Layout, Shot, Table, load_table, simulate
from pool2d.fit.evidence import Evidence, evidence
from pool2d.fit.made_tracks import watched
from pool2d.fit.miss import Stretch
from pool2d.fit.tracks import Floats

TABLE = load_table("carom-10ft")
NOISE = 0.0004
CUE, RED = Ball("cue", 0.6, 0.5), Ball("red", 1.5, 0.7)
# How long shots are watched, s: short, so that tests are.
LONGEST = 1.6


def stretch(shot: Shot, balls: tuple[Ball, ...], seed: int = 0, noise: float = NOISE, table: Table = TABLE) -> Stretch:
    """A shot as it was seen on a table, as a fit looks at it; what it then tells by itself is `evidence`."""
    tracked = watched(str(seed), simulate(table, Layout(balls), shot), seed, noise, LONGEST)
    return Stretch(seen(evidence(tracked, TABLE, max(noise, 1e-5))), tracked.end)


def seen(found: Evidence | None) -> Evidence:
    assert found is not None
    return found


def alone(table: Table, count: int, noise: float = NOISE) -> list[Stretch]:
    """Shots with the cue ball alone, round the table."""
    shots = (Shot(20.0 + 47.0 * i, 2.6 + 0.3 * i, 0.15 * (-1) ** i, 0.2 - 0.1 * i) for i in range(count))
    return [stretch(shot, (CUE,), i, noise, table) for i, shot in enumerate(shots)]


def numbers(shot: Shot, moment: float, balls: Mapping[str, Ball]) -> Floats:
    """A launch as a row of numbers."""
    return np.array(
        [shot.angle, shot.speed, shot.side, shot.height, moment, *(n for b in balls.values() for n in (b.x, b.y))]
    )
