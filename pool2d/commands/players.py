"""What `pool2d players` takes; without more, it lists them."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from ..config import catalogue
from ..config.folders import data_folder
from ..config.knobs import Knob
from ..errors import InputError
from . import terminal
from .arguments import to_whole

if TYPE_CHECKING:
    from ..opponent.player import Player

SEED = Knob(0, 0, 1e9, "", "")
JOBS = Knob(0, 1, 60, "processes", "")
_COLUMNS = ("ten racks", "grade", "pots", "run", "break-and-runs", "three-cushion", "snooker")


def register(commands: Any) -> None:
    """Add the command to the others."""
    text = "List the players to play against, the weakest first, with their measured rates; or measure one."
    parser = commands.add_parser("players", help=text, description=text)
    parser.set_defaults(run=_run)
    parser.add_argument("--json", action="store_true", help="one line of JSON")
    parser.add_argument("--measure", metavar="NAME", help="measure a player, or a .toml file, and say the grade")
    parser.add_argument("--seed", metavar="N", help="of the racks and of the hand, with --measure (0)")
    parser.add_argument("--jobs", metavar="N", help="so many processes, with --measure (one for each processor)")
    parser.add_argument("--save", action="store_true", help="write what was measured into the player's file")


def _run(arguments: argparse.Namespace) -> int:
    if arguments.measure is not None:
        return _measure(arguments)
    for name in ("seed", "jobs", "save"):
        if getattr(arguments, name):
            raise InputError("command line", f"--{name}", getattr(arguments, name), "allowed is only with --measure")
    return _tell_json() if arguments.json else _tell_all()


def _measure(arguments: argparse.Namespace) -> int:
    from .measure_player import measure

    seed = to_whole(SEED, arguments.seed or "0", "--seed")
    return measure(arguments.measure, seed, to_jobs(arguments.jobs), arguments.save, arguments.json)


def to_jobs(text: str | None) -> int:
    """`--jobs N`: so many processes, by default one for each processor."""
    from ..study.workers import processors

    return processors() if text is None else to_whole(JOBS, text, "--jobs")


def _tell_all() -> int:
    """Print a line for each player; of one whose file is broken what is wrong."""
    terminal.tell(_line("", "", _COLUMNS))
    for name, found in _players():
        terminal.tell(f"{name:<10} {found}" if isinstance(found, InputError) else _told(name, found))
    terminal.tell(f"Your own are kept in {data_folder() / catalogue.PLAYERS}")
    return 0


def _tell_json() -> int:
    terminal.write(json.dumps([_as_dict(name, found) for name, found in _players()]))
    return 0


def _players() -> Iterator[tuple[str, Player | InputError]]:
    """Each player's file, the weakest first, and who plays by it or what is wrong with it."""
    from ..opponent.player_file import load_player, player_names

    for name in player_names():
        try:
            yield name, load_player(name)
        except InputError as error:
            yield name, error


def _told(name: str, player: Player) -> str:
    from .rates_told import told_rates

    mark = " (yours)" if name in catalogue.own(catalogue.PLAYERS) else ""
    who = f"{player.name}, {player.title}{mark}" if player.title else f"{player.name}{mark}"
    return _line(name, who, told_rates(player.measured) if player.measured.when else ("not measured",))


def _line(name: str, who: str, columns: tuple[str, ...]) -> str:
    widths = map(len, _COLUMNS)
    told = "  ".join(f"{column:>{max(width, 6)}}" for column, width in zip(columns, widths, strict=False))
    return f"{name:<10} {who:<24} {told}"


def _as_dict(name: str, found: Player | InputError) -> dict[str, Any]:
    from .rates_told import rates_dict

    if isinstance(found, InputError):
        return {"file": name, "error": str(found)}
    about = {key: getattr(found, key) for key in ("name", "title", "rank")}
    return {"file": name, **about, "words": asdict(found.words), "measured": rates_dict(found.measured)}
