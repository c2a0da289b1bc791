"""The command line: play | simulate | study | fit | render | replay | tables | players | duel."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import __version__
from .commands import duel, fit, players, terminal
from .commands.arguments import Parser, add, to_conditions, to_file, to_number, to_overrides, to_size, to_whole
from .compiled import engine
from .config import catalogue
from .config.knobs import Knob
from .errors import BudgetError, InputError, WorkerError

# Tables and physics are read by the commands themselves: the window opens first.
if TYPE_CHECKING:
    from .table.scenario import Scenario
    from .table.table import Table

_EVENTS = Knob(0, 1, 1e9, "events", "")
# Points of all paths together that `--sample` writes.
_MOST = 2_000_000
_WORKERS = Knob(0, 1, 60, "processes", "")
_SHOTS = Knob(0, 1, 1e6, "", "")
_TABLE = "pool-9ft"
_STEP = Knob(0.0, 1e-6, 1e6, "s", "")


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit status: 0 done, 2 bad input, told in one line on standard error."""
    words = list(sys.argv[1:] if argv is None else argv)
    # Without a command, play; `--help` and `--version` speak for the whole.
    if not words or (words[0].startswith("-") and words[0] not in ("-h", "--help", "--version")):
        words.insert(0, "play")
    terminal.prepare()
    try:
        arguments = _parser().parse_args(words)
        status: int = arguments.run(arguments)
        terminal.flush()
        return status
    except (InputError, WorkerError) as error:
        terminal.complain(f"pool2d: {error}")
    except BudgetError as error:
        terminal.complain(f"pool2d: {error}; the scenario is {json.dumps(error.scenario)}")
    except BrokenPipeError:
        # The reader has what it wanted (`| head`).
        terminal.leave()
        return 0
    except OSError as error:
        terminal.complain(f"pool2d: {error.filename or 'the system'}: {error.strerror}")
    # What was printed before is still to be seen, unless it is the output that fails.
    try:
        terminal.flush()
    except (InputError, BrokenPipeError):
        terminal.leave()
    return 2


def _play(arguments: argparse.Namespace) -> int:
    from .ui.start import play

    def table() -> Table:
        from .table.preset import load_table

        name = _TABLE if arguments.table is None else arguments.table
        return load_table(name, to_overrides(arguments.set), to_conditions(arguments))

    # Who says what to play on wants to play.
    said = arguments.set or any(given is not None for given in (arguments.table, arguments.conditions, arguments.seed))
    return play(table, seed=arguments.seed, frames=arguments.frames, menu=not said)


def _simulate(arguments: argparse.Namespace) -> int:
    from .commands import outcome

    overrides = to_overrides(arguments.set)
    limit = None if arguments.events is None else to_whole(_EVENTS, arguments.events, "--events")
    step = None if arguments.sample is None else to_number(_STEP, arguments.sample, "--sample")
    for path, scenario in _scenarios(arguments, overrides):
        if not scenario.layout.on_table():
            raise InputError(path, "balls", [], "there is no ball on the table; nothing can be simulated")
        rollout = scenario.simulate(limit)
        if step is not None and rollout.duration / step * len(rollout.start) > _MOST:
            allowed = f"the paths would have more than {_MOST} points; take a longer step"
            raise InputError("command line", "--sample", step, allowed)
        if arguments.json:
            terminal.write(json.dumps(outcome.as_dict(rollout, step)))
            terminal.flush()
        else:
            outcome.tell(path, rollout, step)
    return 0


def _scenarios(arguments: argparse.Namespace, overrides: dict[str, Any]) -> Iterator[tuple[str, Scenario]]:
    """What is to be simulated: the files, or what `--position` and `--shot` say; each with its name."""
    from .table.position_text import read, read_shot
    from .table.scenario import load_scenario, scenario_of

    conditions = to_conditions(arguments)
    shot = None if arguments.shot is None else read_shot(arguments.shot, "--shot")
    if arguments.position is None:
        if shot is not None or not arguments.files:
            raise InputError("command line", "", None, "allowed are scenario files, or --position and --shot")
        yield from ((path, load_scenario(path, overrides, conditions)) for path in arguments.files)
        return
    if arguments.files:
        raise InputError("command line", "", None, "allowed are scenario files or --position, not both")
    position = read(arguments.position, "--position")
    if shot is not None:
        position = replace(position, shot=shot)
    yield "position", scenario_of(position, overrides, conditions)


def _render(arguments: argparse.Namespace) -> int:
    from .draw.export import picture_file, render
    from .table.scenario import load_scenario

    out = to_file(arguments.out, "OUT.png")
    picture_file.check_path(out)
    scenario = load_scenario(arguments.file, to_overrides(arguments.set), to_conditions(arguments))
    render.render(scenario, out, to_size(arguments.size))
    return 0


def _study(arguments: argparse.Namespace) -> int:
    from .commands import study

    file = Path(arguments.file)
    out = file.with_suffix(".csv") if arguments.out is None else to_file(arguments.out, "--out")
    workers = None if arguments.workers is None else to_whole(_WORKERS, arguments.workers, "--workers")
    plan = study.Plan(out, to_size(arguments.size), workers, arguments.cluster)
    return study.study(file, plan, to_overrides(arguments.set), to_conditions(arguments))


def _replay(arguments: argparse.Namespace) -> int:
    from .commands import replay

    path = Path(arguments.file)
    number = None if arguments.shot is None else to_whole(_SHOTS, arguments.shot, "--shot")
    exports = arguments.png is not None or arguments.gif is not None
    if arguments.size is not None and not exports:
        raise InputError("command line", "--size", arguments.size, "allowed is only with --png or --gif")
    if number is not None and (arguments.verify or arguments.list):
        raise InputError("command line", "--shot", number, "allowed is not with --list or --verify, which take all")
    if arguments.verify:
        return replay.check(path)
    if arguments.png is not None:
        return replay.to_png(path, to_file(arguments.png, "--png"), number, to_size(arguments.size or "960x540"))
    if arguments.gif is not None:
        return replay.to_gif(path, to_file(arguments.gif, "--gif"), number, to_size(arguments.size or "640x360"))
    if arguments.list:
        return replay.tell(path)
    if arguments.why:
        return replay.explain(path, number)
    return replay.show(path, number)


def _tables(arguments: argparse.Namespace) -> int:
    from .commands import tables

    _check_one_task(arguments)
    if arguments.knobs:
        return tables.tell_knobs()
    if arguments.check is not None:
        return tables.check(arguments.check)
    if arguments.new is not None:
        return tables.new(to_file(arguments.new, "--new"), arguments.base or _TABLE)
    if arguments.name is not None:
        return tables.tell(arguments.name, to_overrides(arguments.set), to_conditions(arguments))
    return tables.tell_all()


def _check_one_task(arguments: argparse.Namespace) -> None:
    """Raises InputError where `tables` is asked for two things, or for what its task does not use."""
    named = arguments.name is not None
    asked = {
        "NAME": named, "--knobs": arguments.knobs, "--check": arguments.check is not None,
        "--new": arguments.new is not None,
    }  # fmt: skip
    given = [task for task, wanted in asked.items() if wanted]
    if len(given) > 1:
        raise InputError("command line", "", None, f"{' and '.join(given)} do not go together; allowed is one of them")
    if arguments.base is not None and not asked["--new"]:
        raise InputError("command line", "--base", arguments.base, "allowed is only with --new")
    if (arguments.set or arguments.conditions is not None) and not named:
        raise InputError("command line", "", None, "--set and --conditions are allowed only with a table's NAME")


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="pool2d", description="A 2D pool table whose physics can be trusted.")
    parser.add_argument("--version", action="version", version=f"pool2d {__version__} {engine()}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    _add_play(commands)
    _add_simulate(commands)
    _add_render(commands)
    _add_study(commands)
    fit.register(commands)
    _add_replay(commands)
    _add_tables(commands)
    players.register(commands)
    duel.register(commands)
    return parser


def _add_play(commands: Any) -> None:
    parser = add(commands, "play", _play, "Open a window and play (also without a command).")
    # A percent sign would start one of argparse's own places.
    known = ", ".join([*catalogue.shipped(catalogue.TABLES), *catalogue.own(catalogue.TABLES)]).replace("%", "%%")
    parser.add_argument("--table", help=f"practise on a preset ({known}) or a .toml file")
    parser.add_argument("--seed", type=int, default=None, help="the first rack's seed; without it, a new one each time")
    parser.add_argument("--frames", type=int, default=None, help="stop after this many frames")


def _add_simulate(commands: Any) -> None:
    parser = add(commands, "simulate", _simulate, "Play scenario files without a screen and tell what happened.")
    parser.add_argument("files", nargs="*", metavar="FILE", help="a scenario, .toml or .json")
    parser.add_argument("--position", metavar="TEXT", help="instead of a file: 'pool-9ft cue@0.6,0.6 1@1.9,0.65'")
    parser.add_argument("--shot", metavar="TEXT", help="the shot to play there: 'cue:angle,speed,side,height'")
    parser.add_argument("--json", action="store_true", help="one line of JSON for each file")
    parser.add_argument("--sample", metavar="DT", help="add each ball's path, sampled every DT seconds")
    parser.add_argument("--events", metavar="N", help="stop after N events")


def _add_render(commands: Any) -> None:
    parser = add(commands, "render", _render, "Draw a scenario's table, balls and the shot's paths to a picture.")
    parser.add_argument("file", metavar="FILE", help="a scenario, .toml or .json")
    parser.add_argument("out", metavar="OUT.png", help="the picture to write")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="its size in pixels (1280x720)")


def _add_study(commands: Any) -> None:
    parser = add(
        commands, "study", _study, "Play every shot of a study, on all processors, to a CSV file and pictures."
    )
    parser.add_argument("file", metavar="FILE", help="a study, .toml: a scenario with [grid] or [noise]")
    parser.add_argument("--out", metavar="OUT", help="results, .csv or .parquet, with their pictures beside (FILE.csv)")
    parser.add_argument("--workers", metavar="N", help="so many processes (one for each processor)")
    parser.add_argument("--cluster", metavar="ADDRESS", help="instead of processes: a Dask scheduler, tcp://host:8786")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="of the pictures, in pixels (1280x720)")


def _add_replay(commands: Any) -> None:
    parser = commands.add_parser("replay", help="Look at a recorded match in a window, verify it, or export a shot.")
    parser.set_defaults(run=_replay)
    parser.add_argument("file", metavar="FILE", help="a record")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--list", action="store_true", help="list the shots and what came of them")
    what.add_argument("--why", action="store_true", help="say why a shot was played, or with no --shot each")
    what.add_argument("--verify", action="store_true", help="play it again, and name where it first differs")
    what.add_argument("--png", metavar="DIR", help="write a shot as pictures, 25 a second")
    what.add_argument("--gif", metavar="FILE", help="write a shot as a moving picture")
    parser.add_argument("--shot", metavar="N", help="which shot, from 1; without it the first, or to export the last")
    parser.add_argument("--size", metavar="WxH", help="of the pictures, in pixels (960x540; of a GIF 640x360)")


def _add_tables(commands: Any) -> None:
    parser = add(commands, "tables", _tables, "List the tables, show one, check files, or start a table of your own.")
    parser.add_argument("name", nargs="?", metavar="NAME", help="show this one: every knob, and where it comes from")
    parser.add_argument("--knobs", action="store_true", help="print every knob: name, default, range, unit, text")
    parser.add_argument("--check", nargs="+", metavar="FILE", help="say what is wrong with preset files")
    parser.add_argument("--new", metavar="FILE.toml", help="write a preset to start from; replaces nothing")
    parser.add_argument("--base", metavar="NAME", help="what it starts from (pool-9ft)")
