"""What `pool2d fit --by-hand` does: take what was measured from a file or from answers, tell the knobs, keep them."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..config import catalogue
from ..config.files import check_target, write_text
from ..errors import InputError
from ..fit.by_hand import HandFit, HandFits, fit_by_hand, places
from ..fit.fitted_preset import FittedKnob, preset_text
from ..fit.measured_file import located, read_measured
from ..fit.measurements import MEASUREMENTS, QUANTITIES, Measurement
from ..fit.readings import Quantity, Reading, read
from ..table.preset import load_table
from ..table.table import Table
from . import terminal

_TABLE = "pool-9ft"
# As a shell tells that Ctrl-C ended a command.
_INTERRUPTED = 130
_ANSWERS = "answers"
# Letters in a line of what is explained.
_WIDE = 90
# A standard error times this holds 95 of 100.
_MOSTLY = 1.96
# From here on it is told that measurements contradict each other.
_STRAINED = 2.0


@dataclass(frozen=True, slots=True)
class HandPlan:
    """What is measured and kept: the file, None to ask; the table, None for the file's or the usual; and `out`."""

    file: Path | None
    table: str | None
    overrides: Mapping[str, Any]
    conditions: list[str]
    out: str | None

    @property
    def preset(self) -> Path | None:
        """The file of the preset that is to be written."""
        if self.out is None or self.out.endswith(".toml"):
            return None if self.out is None else Path(self.out)
        return catalogue.own_path(catalogue.TABLES, self.out)

    def load(self, named: str | None) -> Table:
        """The table that was measured; `named` is the file's."""
        return load_table(self.table or named or _TABLE, self.overrides, self.conditions)


def by_hand(plan: HandPlan) -> int:
    """Find the knobs that were measured, print them, and write them as a preset where that is asked for.

    Returns the exit status. Raises InputError for what was not understood, and for what the knobs cannot give.
    """
    if plan.preset is not None:
        check_target(plan.preset)
    try:
        return _from_answers(plan) if plan.file is None else _from_file(plan, plan.file)
    except KeyboardInterrupt:
        terminal.complain("")
        return _INTERRUPTED


def _from_file(plan: HandPlan, file: Path) -> int:
    measured = read_measured(file)
    table = plan.load(measured.table)
    try:
        found = fit_by_hand(table, measured.readings, str(file))
    except InputError as error:
        raise located(error, file) from None
    return _tell(plan, table, measured.readings, found)


def _from_answers(plan: HandPlan) -> int:
    table = plan.load(None)
    terminal.tell(
        f"What does {table.source} do? Enter leaves out what was not measured. Several readings: 8.4 8.6 8.5;"
    )
    terminal.tell("their error, where it is another than the usual one: 8.4 8.6 +-0.2.")
    readings = {name: reading for each in MEASUREMENTS for name, reading in _ask(each).items()}
    return _tell(plan, table, readings, fit_by_hand(table, readings, _ANSWERS))


# The questions.


def _ask(each: Measurement) -> dict[str, Reading]:
    """What was read off of one measurement."""
    for line in ("", *textwrap.wrap(each.how, _WIDE)):
        terminal.tell(line)
    readings: dict[str, Reading] = {}
    for part in (part for part in each.quantities if part.asked):
        reading = _answer(part)
        if reading is None and part is each.seen:
            break
        if reading is not None:
            readings[part.name] = reading
    return readings


def _answer(part: Quantity) -> Reading | None:
    """An answer, asked for again where it is not understood and somebody sits there; None for an empty one."""
    usual = f"+-{part.error:g} {part.knob.unit}".rstrip()
    while True:
        line = _line(f"  {part.name}, {part.knob.doc} ({usual}): ")
        try:
            return read(line, part, _ANSWERS) if line else None
        except InputError as error:
            if not sys.stdin.isatty():
                raise
            terminal.complain(f"pool2d: {error}")


def _line(question: str) -> str:
    """The answer to a question, without blanks around it; empty where there are no more."""
    if sys.stdin is None:
        return ""
    terminal.ask(question)
    line = sys.stdin.readline()
    if not line.endswith("\n") or not sys.stdin.isatty():
        # What was typed ends the line on a terminal; elsewhere nothing has.
        terminal.tell("")
    return line.strip()


# What is told and kept.


def _tell(plan: HandPlan, table: Table, readings: Mapping[str, Reading], found: HandFits) -> int:
    """Print the knobs, and write the preset."""
    terminal.tell(f"{'knob':<22}{'was':>10}{'now':>10}{'+-':>10}  told by")
    for each in found.knobs:
        form = f".{places(each.error)}f"
        told = f"{each.knob:<22}{each.was:>10.4g}{each.now:>10{form}}{each.error:>10{form}}"
        terminal.tell(f"{told}  {', '.join(each.by)}")
    terminal.tell(f"+- is a standard error; all else is taken to be as on {table.source}.")
    if found.strain > _STRAINED:
        terminal.tell(
            f"Measurements of one knob are {found.strain:.1f} times as far apart as their errors: repeat them."
        )
    if plan.preset is not None:
        fitted = {each.knob: _fitted(each) for each in found.knobs}
        write_text(plan.preset, preset_text(plan.preset.stem, table, fitted, list(_evidence(table, readings))))
        terminal.tell(f"{plan.preset}: written; play it: pool2d play --table {plan.out}")
    return 0


def _fitted(each: HandFit) -> FittedKnob:
    return FittedKnob(each.knob, each.was, each.now, _MOSTLY * each.error)


def _evidence(table: Table, readings: Mapping[str, Reading]) -> Iterable[str]:
    """What the preset rests on, in lines."""
    yield f"Measured by hand; what was not measured is as on {table.source}."
    for name, reading in readings.items():
        knob = QUANTITIES[name].knob
        said = f"{reading.value:.4g} +- {reading.error:.2g} {knob.unit}".rstrip()
        yield f"{name} = {said}: {knob.doc}"
