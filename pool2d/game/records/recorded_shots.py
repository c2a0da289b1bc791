"""The strokes of a record, for looking at them: worked out one by one, ahead of whoever looks."""

from __future__ import annotations

from ...errors import InputError
from .record import REDO, UNDO, Record, RecordLine
from .replaying import RecordedShot, strokes


class RecordedShots:
    """The strokes of a record, counted from 0.

    `play_next` works out one more, so that a long match opens at once. Where the record no longer plays as it says,
    `fault` tells so, and the strokes before are all there are. `undone` are the lines of strokes that were taken
    back for good; `outdated` is what has become of the table's preset since (`Record.outdated`).
    """

    def __init__(self, record: Record) -> None:
        """Raises InputError where the record holds no stroke, or not even its first can be played."""
        self.record = record
        self.fault: InputError | None = None
        self.undone = undone(record.entries)
        self.outdated = record.outdated
        self.played: list[RecordedShot] = []
        self._count: int = sum(entry.do == "stroke" for entry in record.entries)
        self._coming = strokes(record)
        if not self._count:
            raise InputError(str(record.path), "", None, "no stroke was played")
        self.play_next()
        if self.fault is not None and not self.played:
            raise self.fault

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, at: int) -> RecordedShot:
        """A stroke, or the last that there is before it."""
        while len(self.played) <= at and not self.complete:
            self.play_next()
        return self.played[min(at, len(self) - 1)]

    @property
    def complete(self) -> bool:
        """Whether every stroke has been worked out."""
        return len(self.played) == self._count

    def play_next(self) -> RecordedShot | None:
        """Work out the next stroke; None where there is no more."""
        try:
            shot = next(self._coming, None)
        except InputError as error:
            self.fault, shot = error, None
        if shot is None:
            self._count = len(self.played)
        else:
            self.played.append(shot)
        return shot


def undone(entries: tuple[RecordLine, ...]) -> frozenset[int]:
    """The lines of the strokes that were taken back, and not done again."""
    done: list[RecordLine] = []
    back: list[RecordLine] = []
    gone: set[int] = set()
    for entry in entries:
        do = entry.do
        if do == UNDO and done:
            back.append(done.pop())
            gone.add(back[-1].line)
        elif do == REDO and back:
            done.append(back.pop())
            gone.discard(done[-1].line)
        elif do not in (UNDO, REDO):
            done.append(entry)
            back.clear()
    return frozenset(entry.line for entry in entries if entry.line in gone and entry.do == "stroke")
