"""The words of a command line: what all commands take, and how texts become knobs, numbers and files."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..config.fields import number_in
from ..config.knobs import Knob, apply
from ..errors import InputError
from . import terminal


class Parser(argparse.ArgumentParser):
    """An ArgumentParser whose complaints are one line."""

    def error(self, message: str) -> Any:
        raise InputError("command line", "", None, message)

    def _print_message(self, message: str, file: Any = None) -> None:
        """What is not a complaint: help, and the version."""
        for line in message.splitlines():
            terminal.tell(line)


def add(commands: Any, name: str, run: Callable[[argparse.Namespace], int], text: str) -> argparse.ArgumentParser:
    """A command that plays on a table: `--set` and `--conditions` are laid over it."""
    parser: argparse.ArgumentParser = commands.add_parser(name, help=text, description=text)
    parser.set_defaults(run=run)
    parser.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="override a knob: cloth.mu_roll=0.012"
    )
    parser.add_argument("--conditions", metavar="NAMES", help="lay over the table: heated,dirty-balls")
    return parser


def to_overrides(settings: list[str]) -> dict[str, Any]:
    """`--set NAME=VALUE` as knobs and values; raises InputError."""
    from ..table.table_knobs import Knobs

    overrides: dict[str, Any] = {}
    for setting in settings:
        name, sign, text = setting.partition("=")
        if not sign:
            raise InputError("--set", "", None, f"{setting!r} is not NAME=VALUE, as in cloth.mu_roll=0.012")
        overrides[name.strip()] = number_in(text)
    apply(Knobs(), overrides, "--set")
    return overrides


def to_conditions(arguments: argparse.Namespace) -> list[str]:
    """`--conditions A,B` as names."""
    return [] if arguments.conditions is None else [name.strip() for name in arguments.conditions.split(",")]


def to_number(knob: Knob, text: str, name: str) -> float:
    """A number that a knob allows; `name` is the option that has it."""
    return float(knob.check(number_in(text), "command line", name))


def to_whole(knob: Knob, text: str, name: str) -> int:
    number = to_number(knob, text, name)
    if not number.is_integer():
        raise InputError("command line", name, text, f"allowed is a whole number; {knob.allowed()}")
    return int(number)


def to_size(text: str) -> tuple[int, int]:
    """`--size WxH` as two numbers."""
    width, x, height = text.partition("x")
    if not (x and width and height):
        raise InputError("command line", "--size", text, "allowed is WIDTHxHEIGHT, such as 1280x720")
    size = Knob(0, 64, 8192, "pixels", "")
    return int(to_number(size, width, "--size")), int(to_number(size, height, "--size"))


def to_file(text: str, name: str) -> Path:
    """A file that is to be written."""
    if not text:
        raise InputError("command line", name, text, "allowed is the name of a file")
    return Path(text)
