"""What `pool2d replay` does: show a record, list or verify it, or export a shot of it as pictures."""

from __future__ import annotations

from pathlib import Path

from . import terminal
from .errors import InputError
from .game.record import Record, Take, load, takes, verify

# Pictures of a film per second: a GIF counts in hundredths.
_RATE = 25


def check(path: Path) -> int:
    """Play a record through the engine; print that it is as recorded, or where it first is not and return 1."""
    record = load(path)
    found = verify(record)
    if found is not None:
        terminal.tell(f"{path}: line {found.line}: {found.what}")
        return 1
    strokes = sum(entry.data["do"] == "stroke" for entry in record.entries)
    terminal.tell(f"{path}: as recorded: {strokes} strokes, {len(record.entries)} lines")
    return 0


def take_of(record: Record, number: int | None) -> Take:
    """A stroke of a record by its number from 1; the last one without; raises InputError."""
    found = takes(record)
    if not found:
        raise InputError(str(record.path), "", None, "no stroke was played")
    if number is not None and not 1 <= number <= len(found):
        raise InputError("command line", "--shot", number, f"allowed is 1 to {len(found)}")
    return found[-1 if number is None else number - 1]


def to_png(path: Path, folder: Path, number: int | None, size: tuple[int, int]) -> int:
    """Write a stroke as numbered pictures, 25 for each second."""
    from .ui import film

    take = take_of(load(path), number)
    count = film.to_png(take.match.table, take.rollout, folder, f"shot-{take.number:03d}", size, _RATE)
    terminal.tell(f"{folder}: {count} pictures of shot {take.number}, {_RATE} a second")
    return 0


def to_gif(path: Path, out: Path, number: int | None, size: tuple[int, int]) -> int:
    """Write a stroke as a moving picture."""
    from .ui import film, pictures

    pictures.check_path(out, moving=True)
    take = take_of(load(path), number)
    film.to_gif(take.match.table, take.rollout, out, size, _RATE)
    terminal.tell(f"{out}: shot {take.number}")
    return 0


def show(path: Path, number: int | None) -> int:
    """Show a record in a window, from a stroke on."""
    from .ui.start import replay

    return replay(path, number)


def tell(path: Path) -> int:
    """List the strokes of a record."""
    from .game.rules import say

    for take in takes(load(path)):
        notes = " ".join(say(note, take.match.names) for note in take.moment.ruling.notes)
        terminal.tell(f"{take.number:4}  {notes}")
    return 0
