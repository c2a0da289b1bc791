"""The files behind a table, watched while the window is open."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError
from .preset import preset_files
from .table import Table

# How often they are looked at, s.
WATCH = 0.5


class PresetWatcher:
    """The files behind a table, and whether one has changed since they were last looked at."""

    def __init__(self, table: Table) -> None:
        self.behind = (table.source, table.conditions)
        try:
            self._paths = preset_files(table)
        except InputError:
            # The preset has been damaged or thrown away since: the table is played on as it was.
            self._paths = []
        self._stamps = self._read()
        self._wait = WATCH

    def changed(self, dt: float) -> bool:
        """Whether a file has changed; asks the disk only now and then."""
        self._wait -= dt
        if self._wait > 0.0:
            return False
        self._wait = WATCH
        before, self._stamps = self._stamps, self._read()
        return self._stamps != before

    def _read(self) -> list[tuple[int, int] | None]:
        return [_stamp(path) for path in self._paths]


def _stamp(path: Path) -> tuple[int, int] | None:
    """What changes about a file when it is saved; None where it is not there."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size
