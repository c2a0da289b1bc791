"""What `pool2d tables` does: list the presets, show one, check files, start a new one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..config import catalogue
from ..config.files import to_text, write_text
from ..config.folders import data_folder
from ..config.knobs import Knob, walk
from ..errors import InputError
from ..table.preset import condition_title, conditions, load_table, preset_path, presets, read_preset
from ..table.table import Table
from ..table.table_knobs import Knobs
from . import terminal


def tell_all() -> int:
    """Print the presets and the conditions with their titles; a broken one with what is wrong."""
    yours = set(catalogue.own(catalogue.TABLES)) | set(catalogue.own(catalogue.CONDITIONS))
    for names, title in ((presets(), _title), (conditions(), condition_title)):
        terminal.tell("Tables:" if title is _title else "Conditions, for --conditions:")
        for name in names:
            mark = "  (yours)" if name in yours else ""
            try:
                terminal.tell(f"  {name:<20} {title(name)}{mark}")
            except InputError as error:
                terminal.tell(f"  {name:<20} {error}{mark}")
    terminal.tell(f"Your own are kept in {data_folder()}")
    return 0


def tell(name: str, overrides: Mapping[str, Any], conditions: Sequence[str]) -> int:
    """Print every knob of a preset as name = value unit, and where the value comes from."""
    preset = read_preset(name, conditions)
    table = load_table(name, overrides, conditions)
    terminal.tell(f"{name}: {table.title}, {preset_path(name)}")
    terminal.tell("  racks: " + ", ".join(table.furniture.racks))
    terminal.tell(f"  balls: {table.furniture.cue}, " + ", ".join(table.furniture.balls))
    for knob_name, knob, value in walk(table.knobs):
        origin = "set" if knob_name in overrides else preset.origins.get(knob_name, "default")
        if origin not in ("set", "default", name) and not origin.startswith("conditions "):
            origin = f"base {origin}"
        said = f"{knob_name} = {_plain(value)} {knob.unit}"
        terminal.tell(f"{said.rstrip():<40} # {origin}")
    return 0


def tell_knobs() -> int:
    """Print every knob: name, default, range, unit, text."""
    for name, knob, default in walk(Knobs()):
        terminal.tell(f"{name:<24} {_plain(default):<14} {_range(knob):<32} {knob.doc}")
    return 0


def check(files: Sequence[str]) -> int:
    """Print a line for each file: that it is good, or, on standard error, what is wrong; 2 if any is."""
    status = 0
    for file in files:
        try:
            table = load_table(file)
            for rack in table.furniture.racks:
                table.rack(rack)
            terminal.tell(f"{file}: good, {table.title}")
        except InputError as error:
            told = error if error.source == file else error.at(f"{file}: {error.source}")
            terminal.complain(f"pool2d: {told}")
            status = 2
    return status


def new(path: Path, base: str) -> int:
    """Write a preset to start from: all of its base's knobs, commented out."""
    if path.suffix != ".toml":
        raise InputError(str(path), "", None, "a preset's name ends in .toml")
    table = load_table(base)
    write_text(path, _start(path.stem, base, table), new=True)
    terminal.tell(f"{path}: written; uncomment what you want to change, then play it: pool2d play --table {path}")
    return 0


def _start(title: str, base: str, table: Table) -> str:
    """The text of a new preset."""
    if base.endswith(".toml"):
        base = Path(base).absolute().as_posix()
    lines = [
        "# A table of your own. What is not said here is as in its base: uncomment a line to change it.",
        "# Outline, marks, finish, balls and racks may be given too; the shipped presets show how.",
        "",
        f"name = {to_text(title)}",
        f"base = {to_text(base)}",
    ]
    group = ""
    for name, knob, value in walk(table.knobs):
        section, _, key = name.rpartition(".")
        if section != group:
            lines += ["", f"[{section}]"]
            group = section
        value = f'"{value}"' if isinstance(value, str) else _plain(value)
        said = f"# {key} = {value}"
        lines.append(f"{said:<32}# {_range(knob)}: {knob.doc}")
    return "\n".join(lines) + "\n"


def _title(name: str) -> str:
    return read_preset(name).title


def _plain(value: float | str) -> str:
    return value if isinstance(value, str) else f"{value:.10g}"


def _range(knob: Knob) -> str:
    """What a knob allows, short."""
    if knob.choices:
        return ", ".join(knob.choices)
    return f"{knob.lo:g} to {knob.hi:g} {knob.unit}".rstrip()
