"""A study's results as a CSV file that grows row by row, and goes on where it was."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

from ..config.files import check_target
from ..errors import InputError
from .summaries import Summaries

# What a row begins with: the study's name, and the shot's number.
_LEAD = ("study", "shot")


def header(like: Summaries) -> tuple[str, ...]:
    """The names of the columns that summaries come out as."""
    return (*_LEAD, *like.columns(), "scenario")


class Results:
    """The file, open at its end; `count` rows are there. With each part that is added it is whole again.

    Raises InputError where the file cannot be read or written, or holds anything but the beginning of this study.
    """

    def __init__(self, path: Path, columns: Sequence[str], stamp: str) -> None:
        self.path = path
        self.stamp = stamp
        self.count = 0
        check_target(path)
        first = _line(columns)
        try:
            self._file = open(path, "r+b" if path.exists() else "xb")  # noqa: SIM115
        except OSError as error:
            raise InputError(str(path), "", None, f"cannot be written: {error.strerror}") from error
        try:
            if path.stat().st_size:
                self._go_on(first)
            if not self._file.tell():
                self._write(first)
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> Results:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._file.close()

    def add(self, part: Summaries) -> None:
        """Write rows that come after those that are there."""
        columns = [_texts(column) for column in part.columns().values()]
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        for row, values in enumerate(zip(*columns, strict=True)):
            scenario = json.dumps(part.scenarios[row]) if row in part.scenarios else ""
            writer.writerow((self.stamp, self.count + row, *values, scenario))
        self._write(text.getvalue().encode())
        self.count += len(part)

    def _write(self, content: bytes) -> None:
        try:
            self._file.write(content)
            self._file.flush()
        except OSError as error:
            raise InputError(str(self.path), "", None, f"cannot be written: {error.strerror}") from error

    def _go_on(self, first: bytes) -> None:
        """Find the end of the last whole row, and cut off what a kill has left of another."""
        found = self._file.readline()
        if not found.endswith(b"\n") and first.startswith(found):
            self._cut(0)
            return
        if found != first:
            raise self._foreign(1)
        end = len(first)
        for line in self._file:
            if not line.endswith(b"\n"):
                break
            if not line.startswith(f"{self.stamp},{self.count},".encode()):
                raise self._foreign(self.count + 2)
            end += len(line)
            self.count += 1
        self._cut(end)

    def _cut(self, end: int) -> None:
        self._file.seek(end)
        self._file.truncate()

    def _foreign(self, line: int) -> InputError:
        allowed = "belongs to another study, or to what this one was before a change; allowed is a new file, or its own"
        return InputError(str(self.path), "", None, allowed, line)


def rows(path: Path, columns: Sequence[str]) -> Iterator[dict[str, str]]:
    """Some columns of every row of results, as texts."""
    with open(path, encoding="utf-8", newline="") as file:
        reader = csv.reader(file)
        names = next(reader)
        places = [names.index(column) for column in columns]
        for row in reader:
            yield {column: row[place] for column, place in zip(columns, places, strict=True)}


def _line(texts: Sequence[str]) -> bytes:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(texts)
    return text.getvalue().encode()


def _texts(column: np.ndarray[Any, Any]) -> list[Any]:
    """A column as CSV has it: true and false as 1 and 0, what is not known as nothing, numbers to the last bit."""
    if column.dtype == np.bool_:
        return list(column.astype(int).tolist())
    if column.dtype == np.float64:
        return ["" if value != value else repr(value) for value in column.tolist()]
    return list(column.tolist())
