"""What `pool2d replay` does: show a record, list, explain or verify it, or export a shot of it as pictures."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError
from ..game.actions import Stroke
from ..game.explained import Voice, told
from ..game.records.record import CHANGED, GONE, Record, load
from ..game.records.replaying import BY_RECORD, RecordedShot, divergences, strokes
from ..game.rules import say
from . import terminal

# Pictures per second: a GIF counts in hundredths.
_RATE = 25


# What is said of the table of a record, by what has become of its preset.
_TABLES = {
    "": "",
    CHANGED: "; on the table as it was then: its preset has changed since",
    GONE: "; on the table as it was then: its preset is not there any more",
}


def check(path: Path) -> int:
    """Play a record through the engine; print that it is as recorded, or where it first is not and return 1.

    Where the record itself has been changed, that is told before all else.
    """
    record = load(path)
    found = list(divergences(record))
    if not found:
        count = sum(entry.do == "stroke" for entry in record.entries)
        table = _TABLES[record.outdated]
        terminal.tell(f"{path}: as recorded: {count} strokes, {len(record.entries)} lines{table}")
        return 0
    first = next((one for one in found if one.why == BY_RECORD), found[0])
    more = f" (and {len(found) - 1} lines more)" if len(found) > 1 else ""
    terminal.tell(f"{path}: line {first.line}: {first}{more}")
    return 1


def shot_of(record: Record, number: int | None) -> RecordedShot:
    """A stroke of a record by its number from 1; the last one without; raises InputError."""
    found = list(strokes(record))
    if not found:
        raise InputError(str(record.path), "", None, "no stroke was played")
    if number is not None and not 1 <= number <= len(found):
        raise InputError("command line", "--shot", number, f"allowed is 1 to {len(found)}")
    return found[-1 if number is None else number - 1]


def to_png(path: Path, folder: Path, number: int | None, size: tuple[int, int]) -> int:
    """Write a stroke as numbered pictures, 25 for each second."""
    from ..draw.export import animation

    shot = shot_of(load(path), number)
    count = animation.to_png(shot.match.table, shot.rollout, folder, f"shot-{shot.number:03d}", size, _RATE)
    terminal.tell(f"{folder}: {count} pictures of shot {shot.number}, {_RATE} a second{_otherwise(shot)}")
    return 0


def to_gif(path: Path, out: Path, number: int | None, size: tuple[int, int]) -> int:
    """Write a stroke as a moving picture."""
    from ..draw.export import animation, picture_file

    picture_file.check_path(out, moving=True)
    shot = shot_of(load(path), number)
    animation.to_gif(shot.match.table, shot.rollout, out, size, _RATE)
    terminal.tell(f"{out}: shot {shot.number}{_otherwise(shot)}")
    return 0


def show(path: Path, number: int | None) -> int:
    """Show a record in a window, from a stroke on."""
    from ..ui.start import replay

    return replay(path, number)


def tell(path: Path) -> int:
    """List the strokes of a record."""
    for shot in strokes(load(path)):
        notes = " ".join(say(note, shot.match.names) for note in shot.moment.ruling.notes)
        terminal.tell(f"{shot.number:4}  {notes}{_otherwise(shot)}")
    return 0


def explain(path: Path, number: int | None) -> int:
    """Say why a stroke was played, or without a number every one; of people's strokes nothing is known."""
    record = load(path)
    for shot in strokes(record) if number is None else [shot_of(record, number)]:
        terminal.tell(f"{shot.number:4}  {shot.match.names[shot.moment.shooter]}{_otherwise(shot)}")
        for line in _reasons(shot):
            terminal.tell(f"      {line}")
    return 0


def _reasons(shot: RecordedShot) -> list[str]:
    """A stroke's reasons in lines, the first under each heading beginning with that."""
    stroke, names = shot.moment.action, shot.match.names
    voice = Voice(note=lambda note: say(note, names))
    parts = told(shot.match, shot.before, stroke, voice) if isinstance(stroke, Stroke) else []
    headed = [zip((voice.say(key), *("",) * len(lines)), lines, strict=False) for key, lines in parts]
    return [f"{name:8}  {line}" for part in headed for name, line in part] or [voice.say("untold")]


def _otherwise(shot: RecordedShot) -> str:
    """What is said of a stroke that would come out otherwise now."""
    return "" if shot.found is None else f" ({shot.found})"
