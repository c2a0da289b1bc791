"""A preset with the knobs that were fitted, which names its evidence."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ..config.files import to_text
from ..printable import printable
from ..table.preset import differences
from ..table.table import Table

# A comment takes no more than this of a line.
_LINE = 300


@dataclass(frozen=True, slots=True)
class FittedKnob:
    """A knob before and after a fit; `uncertain` is how far off it may be, 95 times of 100, None where that is open."""

    name: str
    was: float
    value: float
    uncertain: float | None = None

    def __str__(self) -> str:
        return f"{self.value:.6g}" if self.uncertain is None else f"{self.value:.6g} +- {self.uncertain:.2g}"


def preset_text(title: str, table: Table, fitted: Mapping[str, FittedKnob], evidence: list[str]) -> str:
    """The preset's file: built on the table's own, with what was set on top of it, and what was fitted.

    `evidence` says in lines what it was fitted to and how well.
    """
    base = Path(table.source).absolute().as_posix() if table.source.endswith(".toml") else table.source
    lines = [f"# {printable(line, _LINE)}" for line in evidence]
    lines += ["", f"name = {to_text(title)}", f"base = {to_text(base)}"]
    values = {**differences(table), **{name: knob.value for name, knob in fitted.items()}}
    # Knobs without a section come first, as TOML wants.
    for section in sorted({name.rpartition(".")[0] for name in values}):
        lines += ["", f"[{section}]"] if section else []
        for name, value in values.items():
            if name.rpartition(".")[0] == section:
                lines.append(_line(name.rpartition(".")[2], value, fitted.get(name)))
    return "\n".join(lines) + "\n"


def _line(key: str, value: float | str, knob: FittedKnob | None) -> str:
    if knob is None:
        return f"{key} = {to_text(value) if isinstance(value, str) else repr(value)}"
    sure = "" if knob.uncertain is None else f"+- {knob.uncertain:.2g} (95 of 100), "
    return f"{f'{key} = {knob.value:.7g}':<32}# {sure}was {knob.was:.6g}"
