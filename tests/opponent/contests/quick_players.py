"""Players who take no time, as values and as files."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.stray import Hand

QUICK: Final = Judgement(
    ways=2, paces=1, heights=1, sides=1, few=1, runs=0, safeties=0, kicks=12, banks=0, combinations=0
)
STEADY: Final = Player("Steady", hand=Hand(0.0, 0.0, 0.0, 0.0), judgement=QUICK)
WILD: Final = Player("Wild", hand=Hand(20.0, 10.0, 2.0, 2.0), judgement=QUICK)
_FILE = """
[hand]
aim = {aim}
tip = 0
speed = 0
elevation = 0
[judgement]
ways = 2
paces = 1
heights = 1
sides = 1
few = 1
runs = 0
safeties = 0
kicks = 12
banks = 0
"""


def written(folder: Path, name: str, aim: float) -> str:
    """The path of a quick player's file."""
    path = folder / f"{name}.toml"
    path.write_text(_FILE.format(aim=aim))
    return str(path)
