"""Random matches of every game: see `benchmarks.matches`, which plays many more."""

from __future__ import annotations

import pytest

from benchmarks.matches import play
from pool2d.game.rules import GAMES


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", GAMES)
def test_a_match_ends_or_stands_legally(name: str, seed: int) -> None:
    result = play(name, seed, strokes=40)
    assert result.faults == []
    assert result.strokes > 0


def test_matches_can_be_won() -> None:
    assert play("nine-ball", 1).winner in (0, 1)
