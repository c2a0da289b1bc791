"""What `pool2d duel` takes: who plays whom at what, how often, and where the records go."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..config.folders import data_folder
from ..config.knobs import Knob
from ..errors import InputError
from .arguments import add, to_conditions, to_file, to_overrides, to_whole
from .players import SEED, to_jobs

if TYPE_CHECKING:
    from ..table.table import Table

_GAME, _TABLE = "eight-ball", "pool-9ft"
_MATCHES = Knob(20, 1, 10_000, "matches", "")


def register(commands: Any) -> None:
    """Add the command to the others."""
    text = "Let players play each other without a window, on all processors, and record every match."
    parser = add(commands, "duel", _run, text)
    parser.add_argument("names", nargs="*", metavar="PLAYER", help="two players, or .toml files")
    parser.add_argument("--all", action="store_true", help="everybody against everybody, with Elo ratings")
    parser.add_argument("--players", metavar="A,B,C", help="these, with --all (all that are shipped)")
    parser.add_argument("--game", default=_GAME, metavar="GAME", help=f"what they play ({_GAME})")
    parser.add_argument("--table", metavar="NAME", help=f"on what ({_TABLE}, or the first that the game fits)")
    parser.add_argument("--matches", metavar="N", help="so many, of each two (20)")
    parser.add_argument("--seed", metavar="N", help="the same seed plays the same matches (0)")
    parser.add_argument("--out", metavar="FOLDER", help="where the records go (duels in the data folder)")
    parser.add_argument("--jobs", metavar="N", help="so many processes (one for each processor)")
    parser.add_argument("--json", action="store_true", help="one line of JSON")


def _run(arguments: argparse.Namespace) -> int:
    from ..opponent.player_file import load_player
    from .duelling import DuelPlan, duel

    files = _files(arguments)
    plan = DuelPlan(
        _table(arguments),
        arguments.game,
        {file: load_player(file) for file in files},
        files,
        to_whole(_MATCHES, arguments.matches or "20", "--matches"),
        to_whole(SEED, arguments.seed or "0", "--seed"),
        _folder(arguments),
        to_jobs(arguments.jobs),
        arguments.json,
    )
    return duel(plan)


def _files(arguments: argparse.Namespace) -> tuple[str, ...]:
    """The names of the players' files."""
    if arguments.all:
        return _everybody(arguments)
    if arguments.players is not None:
        raise InputError("command line", "--players", arguments.players, "allowed is only with --all")
    if len(arguments.names) != 2:
        raise InputError("command line", "", None, "needed are two PLAYERs, or --all")
    return tuple(arguments.names)


def _everybody(arguments: argparse.Namespace) -> tuple[str, ...]:
    from ..config import catalogue
    from ..opponent.player_file import player_names

    if arguments.names:
        raise InputError("command line", "", None, "two PLAYERs and --all do not go together; allowed is one of them")
    shipped = [name for name in player_names() if name in catalogue.shipped(catalogue.PLAYERS)]
    names = shipped if arguments.players is None else [name.strip() for name in arguments.players.split(",")]
    if len(names) < 2 or len({Path(name).stem for name in names}) < len(names):
        raise InputError("command line", "--players", arguments.players, "allowed are two or more, each once")
    return tuple(names)


def _table(arguments: argparse.Namespace) -> Table:
    """The table that is said, or one that the game can be played on; raises InputError for a game for one."""
    from ..game.rules import GAMES, game
    from ..table.preset import load_table, presets

    said = [arguments.table] if arguments.table is not None else [_TABLE, *presets()]
    laid = to_overrides(arguments.set), to_conditions(arguments)
    tables = (load_table(name, *laid) for name in said)
    kind = GAMES.get(arguments.game)
    table = next((table for table in tables if kind is None or kind.fits(table)), None) or load_table(said[0], *laid)
    if game(arguments.game, table).players != 2:
        raise InputError("command line", "--game", arguments.game, "allowed is a game for two")
    return table


def _folder(arguments: argparse.Namespace) -> Path:
    if arguments.out is not None:
        return to_file(arguments.out, "--out")
    return data_folder() / "duels" / time.strftime(f"%Y-%m-%d %H.%M.%S {arguments.game}")
