"""What `pool2d fit` takes, and which of its tasks that asks for."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..config.files import write_text
from ..config.knobs import Knob
from ..errors import InputError
from . import terminal
from .arguments import add, to_conditions, to_file, to_number, to_overrides, to_size, to_whole

if TYPE_CHECKING:
    from ..table.table import Table

_TABLE = "carom-10ft"
_SHOTS = Knob(24, 1, 1000, "shots", "")
_SEED = Knob(0, 0, 1e9, "", "")
_NOISE = Knob(0.4, 0.01, 100.0, "mm", "")
_ELEVATION = Knob(0.0, 0.0, 30.0, "degrees", "")
_WORKERS = Knob(0, 1, 60, "processes", "")

# What tells nothing of measurements.
_NOT_BY_HAND = ("make", "noise", "count", "seed", "knobs", "elevation", "workers")


def register(commands: Any) -> None:
    """Add the command to the others."""
    text = "Find a table's knobs: from tracked shots, half of which are held back to judge by."
    parser = add(commands, "fit", _run, text)
    parser.add_argument("shots", nargs="?", metavar="SHOTS", help="tracked shots, .csv or .json")
    parser.add_argument("--table", metavar="NAME", help=f"the preset to start from ({_TABLE}, or what SHOTS names)")
    parser.add_argument(
        "--knobs",
        metavar="A,B",
        help="fit these (those of cloth, cushions and balls that shots tell): cloth.mu_roll,ball.restitution",
    )
    parser.add_argument("--elevation", metavar="DEG", help="of the butt in every shot, degrees (0)")
    parser.add_argument("--out", metavar="NAME", help="a preset of your own, or FILE.toml (SHOTS-fitted.toml)")
    parser.add_argument("--workers", metavar="N", help="so many processes (one for each processor)")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="of the pictures, in pixels (1280x720)")
    parser.add_argument("--noise", metavar="MM", help="how far off a ball is seen, mm (0.4)")
    parser.add_argument(
        "--by-hand", action="store_true", help="from measurements: SHOTS is their .toml, or asks for them"
    )
    parser.add_argument("--make", metavar="FILE.csv", help="write shots made by the engine, to try a fit on")
    parser.add_argument("--count", metavar="N", help="so many, with --make (24)")
    parser.add_argument("--seed", metavar="N", help="drawn from this, with --make (0)")


def _run(arguments: argparse.Namespace) -> int:
    if arguments.by_hand:
        return _by_hand(arguments)
    if arguments.make is not None:
        return _make(arguments)
    if arguments.shots is None:
        raise InputError("command line", "", None, "needed are SHOTS, a file of tracked shots, or --make FILE.csv")
    return _fit(arguments)


def _fit(arguments: argparse.Namespace) -> int:
    """Fit knobs to tracked shots."""
    from ..fit.usual_knobs import usual_knobs
    from ..study.workers import processors
    from .fit_shots import FitPlan, fit_shots

    path = Path(arguments.shots)
    table = _table(arguments, path)
    workers = processors() if arguments.workers is None else to_whole(_WORKERS, arguments.workers, "--workers")
    plan = FitPlan(
        path,
        table,
        usual_knobs(table) if arguments.knobs is None else tuple(map(str.strip, arguments.knobs.split(","))),
        to_number(_NOISE, arguments.noise or "0.4", "--noise") / 1000.0,
        to_number(_ELEVATION, arguments.elevation or "0", "--elevation"),
        str(to_file(arguments.out or str(path.with_name(f"{path.stem}-fitted.toml")), "--out")),
        workers,
        to_size(arguments.size),
    )
    return fit_shots(plan)


def _table(arguments: argparse.Namespace, path: Path) -> Table:
    """The table that is started from: as it is said, or as the file of the shots says."""
    from ..fit.track_file import read_tracks
    from ..table.preset import load_table

    tracks = read_tracks(path)
    radius = {} if tracks.radius is None else {"ball.radius": tracks.radius}
    name = arguments.table or tracks.table or _TABLE
    return load_table(name, {**radius, **to_overrides(arguments.set)}, to_conditions(arguments))


def _by_hand(arguments: argparse.Namespace) -> int:
    """Find knobs from measurements, out of a file or of answers."""
    from .fit_by_hand import HandPlan, by_hand

    for name in _NOT_BY_HAND:
        if getattr(arguments, name, None) is not None:
            raise InputError("command line", f"--{name}", getattr(arguments, name), "allowed is without --by-hand")
    out = None if arguments.out is None else str(to_file(arguments.out, "--out"))
    file = None if arguments.shots is None else Path(arguments.shots)
    return by_hand(HandPlan(file, arguments.table, to_overrides(arguments.set), to_conditions(arguments), out))


def _make(arguments: argparse.Namespace) -> int:
    """Write made shots to a new file."""
    from ..fit.made_tracks import make_shots, to_csv
    from ..table.preset import load_table

    path = to_file(arguments.make, "--make")
    if arguments.shots is not None:
        raise InputError("command line", "", None, "SHOTS and --make do not go together; allowed is one of them")
    if path.suffix != ".csv":
        raise InputError(str(path), "", None, "the name of made shots ends in .csv")
    table = load_table(arguments.table or _TABLE, to_overrides(arguments.set), to_conditions(arguments))
    count = to_whole(_SHOTS, arguments.count or "24", "--count")
    seed = to_whole(_SEED, arguments.seed or "0", "--seed")
    noise = to_number(_NOISE, arguments.noise or "0.4", "--noise") / 1000.0
    write_text(path, to_csv(make_shots(table, count, seed, noise)), new=True)
    terminal.tell(f"{path}: {count} shots made on {table.source}")
    return 0
