"""Which lines of a folder are executed while a name stands for what is being done.

From Python 3.12 on the interpreter tells of each line once for each name, so that watching costs little; before, the
package coverage counts them all.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from types import CodeType
from typing import Any

if sys.version_info >= (3, 12):
    from sys import monitoring

    class Lines:
        """Gathers (name, path, line)."""

        def __init__(self) -> None:
            self._folder = ""
            self._seen: dict[str, set[tuple[str, int]]] = {}
            self._now: set[tuple[str, int]] = set()

        def start(self, folder: Path) -> None:
            self._folder = f"{folder}/"
            monitoring.use_tool_id(monitoring.COVERAGE_ID, "lines")
            monitoring.register_callback(monitoring.COVERAGE_ID, monitoring.events.LINE, self._line)
            monitoring.set_events(monitoring.COVERAGE_ID, monitoring.events.LINE)

        def _line(self, code: CodeType, line: int) -> Any:
            if code.co_filename.startswith(self._folder):
                self._now.add((code.co_filename, line))
            return monitoring.DISABLE

        def switch(self, name: str) -> None:
            """What is executed from now on counts for this name; for none where it is empty."""
            self._now = self._seen.setdefault(name, set()) if name else set()
            if name:
                monitoring.restart_events()

        def stop(self) -> Iterator[tuple[str, str, int]]:
            monitoring.free_tool_id(monitoring.COVERAGE_ID)
            return ((name, *place) for name, places in self._seen.items() for place in sorted(places))

else:
    import coverage

    class Lines:
        """Gathers (name, path, line)."""

        def start(self, folder: Path) -> None:
            self._coverage = coverage.Coverage(
                data_file=None, config_file=False, include=[f"{folder}/*"], messages=False
            )
            self._coverage.start()

        def switch(self, name: str) -> None:
            """What is executed from now on counts for this name; for none where it is empty."""
            self._coverage.switch_context(name)

        def stop(self) -> Iterator[tuple[str, str, int]]:
            self._coverage.stop()
            data = self._coverage.get_data()
            for path in data.measured_files():
                for line, names in data.contexts_by_lineno(path).items():
                    yield from ((name, path, line) for name in names if name)
