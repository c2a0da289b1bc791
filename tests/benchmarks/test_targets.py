"""How large pockets play, against Alciatore's technical proofs TP 3.5 and TP 3.6."""

from __future__ import annotations

import pytest

from benchmarks.targets import CORNER, INCH, MIRROR, SIDE, target
from pool2d import load_table

MIRRORS = load_table("pool-9ft", {**MIRROR, **CORNER, **SIDE})


@pytest.mark.parametrize(
    ("kind", "angle", "width"),
    [
        ("corner", 0.0, 2.668),
        ("corner", 20.0, 2.425),
        ("side", 0.0, 3.229),
        ("side", 20.0, 2.958),
        ("side", 35.0, 2.420),
    ],
)
def test_mirrors_give_what_the_equations_give(kind: str, angle: float, width: float) -> None:
    """His equations solved to three digits, a ball that may meet a point and up to two facings, or one at the side.

    They and the engine have pocket, hole and ball in common, and nothing else.
    """
    assert target(MIRRORS, kind, angle, 2.0) / INCH == pytest.approx(width, abs=0.012)
