"""Writing records: a match whose every action is on the disk before the game goes on."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from pathlib import Path

from ...errors import InputError
from ..actions import Action
from ..match import Match, Moment
from . import engine
from .engine import Identity
from .record import ENDING, PLAYED_BY, REDO, UNDO, body_of, header, load, matches_folder, seal
from .replaying import restored


class Recorder:
    """A match and the file it is written to.

    Where the disk refuses a line, `fault` says so, the file is left with the lines it has, and the match
    goes on without. `changes` are the reasons (`replaying.REASONS`) for which it would have come out otherwise now,
    and `outdated` is what has become of its table's preset (`Record.outdated`).
    """

    def __init__(
        self, match: Match, path: Path, file: int, lines: int = 0, total: str = "", played_by: Identity | None = None
    ) -> None:
        self.match = match
        self.path = path
        self.fault: InputError | None = None
        self.changes: tuple[str, ...] = ()
        self.outdated = ""
        self._file = file
        self._lines = lines
        self._sum = total
        # What played the lines so far, as the record tells it.
        self._played_by = played_by

    @property
    def begun(self) -> bool:
        """Whether any action is on the record."""
        return self._lines > 1

    def play(self, action: Action) -> Moment:
        """Carry out an action and write it; raises as `Match.play`, nothing being written then."""
        moment = self.match.play(action)
        self._write(body_of(self.match))
        return moment

    def undo(self) -> bool:
        """`Match.undo`, written."""
        return self._did(UNDO, self.match.undo())

    def redo(self) -> bool:
        """`Match.redo`, written."""
        return self._did(REDO, self.match.redo())

    def close(self) -> None:
        """Let go of the file. The record is whole at any time; nothing is left to be written."""
        if self._file >= 0:
            file, self._file = self._file, -1
            with contextlib.suppress(OSError):
                os.close(file)

    def __enter__(self) -> Recorder:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def _did(self, do: str, done: bool) -> bool:
        if done:
            self._write(body_of(self.match, do))
        return done

    def _write(self, body: dict[str, object]) -> None:
        """Append a line and wait until it is on the disk."""
        if self._file < 0:
            return
        if self._played_by != engine.identity():
            body[PLAYED_BY] = list(engine.identity())
        line, total = seal({"n": self._lines, **body}, self._sum)
        # Until it is known there is nothing to go back to, and a negative size is refused.
        size = -1
        try:
            size = os.fstat(self._file).st_size
            rest = memoryview(line)
            while rest:
                rest = rest[os.write(self._file, rest) :]
            os.fsync(self._file)
        except OSError as error:
            with contextlib.suppress(OSError):
                os.ftruncate(self._file, size)
            self.fault = InputError(str(self.path), "", None, f"cannot be written: {error.strerror}")
            self.close()
            return
        self._lines += 1
        self._sum = total
        self._played_by = engine.identity()


def record(match: Match, path: Path | None = None) -> Recorder:
    """Start the record of a match that has just begun, in the player's folder or at `path`.

    Raises InputError where it cannot be written, or is there already; nothing is left behind then.
    """
    file, given = _created(match, path)
    recorder = Recorder(match, given, file)
    try:
        _lock(file, given)
        recorder._write(header(match))
        if recorder.fault is not None:
            raise recorder.fault
    except InputError:
        recorder.close()
        # Without its first line a file is no record.
        with contextlib.suppress(OSError):
            given.unlink()
        raise
    _flush_folder(given.parent)
    return recorder


def resume(path: Path) -> Recorder:
    """Go on with a match where its record ends; a line that a kill has cut off is dropped.

    It stands as it was recorded, on the table that it had, though it may come out otherwise now. Raises InputError,
    the file being left as it is, where it is not a good record or is being played elsewhere, and where it is of an
    earlier version and does not play as recorded.
    """
    load(path, torn=True)
    try:
        file = os.open(path, _APPEND)
        try:
            _lock(file, path)
            kept = load(path, torn=True)
            match, changes = restored(kept)
            os.ftruncate(file, kept.size)
        except BaseException:
            os.close(file)
            raise
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be written: {error.strerror}") from error
    recorder = Recorder(match, path, file, len(kept.entries) + 1, kept.sum, kept.played_by)
    recorder.changes, recorder.outdated = changes, kept.outdated
    return recorder


def records() -> list[Path]:
    """The player's records, those played last first, damaged or not."""
    return sorted(matches_folder().glob("*" + ENDING), key=_age)


def unfinished(most: int = 50) -> list[Path]:
    """Which of the player's latest records can be continued, the latest first; none that is damaged."""
    return [path for path in records()[:most] if _can_go_on(path)]


def remove(path: Path) -> None:
    """Throw a record away; raises InputError where that cannot be."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise InputError(str(path), "", None, f"cannot be removed: {error.strerror}") from error


def _age(path: Path) -> int:
    try:
        return -path.stat().st_mtime_ns
    except OSError:
        return 0


def _can_go_on(path: Path) -> bool:
    try:
        kept = load(path, torn=True)
    except InputError:
        return False
    return bool(kept.entries) and not kept.over


_APPEND = os.O_APPEND | os.O_WRONLY | getattr(os, "O_BINARY", 0)


def _created(match: Match, path: Path | None) -> tuple[int, Path]:
    """A new file, open to be written; without a path one named after the time and the game."""
    stamp = time.strftime("%Y-%m-%d %H.%M.%S ") + match.setup.game
    tries = [path] if path else [matches_folder() / f"{stamp}{again}{ENDING}" for again in ("", *range(2, 100))]
    for given in tries:
        try:
            given.parent.mkdir(parents=True, exist_ok=True)
            if not given.exists():
                return os.open(given, _APPEND | os.O_CREAT | os.O_EXCL, 0o644), given
        except OSError as error:
            raise InputError(str(given), "", None, f"cannot be written: {error.strerror}") from error
    raise InputError(str(tries[-1]), "", None, "is there already; nothing was written")


def _lock(file: int, path: Path) -> None:
    """Keep others from writing the file, where the system can; raises InputError where they do."""
    if sys.platform == "win32":
        return
    import fcntl

    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(str(path), "", None, "is being played in another window") from None
    except OSError:
        return  # A disk that knows no locks.


def _flush_folder(folder: Path) -> None:
    """Wait until a new file's name is on the disk too, where the system can."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
