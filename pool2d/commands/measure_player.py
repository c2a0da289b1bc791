"""What `pool2d players --measure` does: what a player makes in drills, runs and matches, and the grade."""

from __future__ import annotations

import json
from pathlib import Path

from .._version import __version__
from ..config import catalogue
from ..opponent.contests import rates
from ..opponent.contests.ten_racks import grade
from ..opponent.player import Player, Rates
from ..opponent.player_file import load_player, save_measured
from ..study.crew import crew
from . import terminal
from .progress import Progress
from .rates_told import rates_dict


def measure(name: str, seed: int, jobs: int, save: bool, as_json: bool) -> int:
    """Measure a player and say what was found; the exit status."""
    player = load_player(name)
    try:
        found = _measured(player, seed, jobs, f"pool2d players --measure {_word(name)} --seed {seed} ({__version__})")
    except KeyboardInterrupt:
        terminal.complain("pool2d: interrupted; nothing was saved")
        return terminal.INTERRUPTED
    if save:
        save_measured(name, found)
    _tell(player, found, as_json)
    if save and not as_json:
        terminal.tell(f"{catalogue.find(catalogue.PLAYERS, name)}: written")
    return 0


def _measured(player: Player, seed: int, jobs: int, how: str) -> Rates:
    progress = Progress(rates.TOTAL, 0)
    try:
        with crew(jobs, progress.went) as team:
            return rates.measured(player, seed, team, how)
    finally:
        progress.end()


def _word(name: str) -> str:
    """A player's name as a file keeps it, whatever path it was given by."""
    return Path(name).stem[:40] if name.isprintable() else "FILE"


def _tell(player: Player, found: Rates, as_json: bool) -> None:
    if as_json:
        terminal.write(json.dumps(rates_dict(found)))
        return
    terminal.tell(f"{player.name}: {found.balls:g} balls in ten racks, grade {grade(found.balls)}")
    terminal.tell(f"  pots: {found.pots:g} of 100")
    terminal.tell(f"  nine-ball: {found.run:g} balls a visit, {found.break_and_runs:g} % of racks broken and run out")
    terminal.tell(f"  three-cushion: {found.three_cushion:g} points an inning")
    terminal.tell(f"  snooker: a highest break of {found.snooker_break:g}")
