"""What is printed: lines that any terminal, pipe or file can take, whatever names and files hold."""

from __future__ import annotations

import contextlib
import io
import sys
from typing import Final

from ..errors import InputError
from ..printable import printable

# As a shell tells that Ctrl-C ended a command.
INTERRUPTED: Final = 130


def prepare() -> None:
    """What the encoding of standard output or error lacks is escaped from now on instead of raised as an error."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def tell(line: str) -> None:
    """Print a line for people; raises InputError where standard output is closed or full, BrokenPipeError."""
    write(printable(line, len(line)))


def write(line: str) -> None:
    """Print a line as it is: made by pool2d alone, such as JSON. Raises as `tell`."""
    _to_output(line + "\n")


def ask(question: str) -> None:
    """Print a question, after which the line goes on; raises as `tell`."""
    _to_output(printable(question, len(question)))
    flush()


def flush() -> None:
    """Wait until all that was printed is where it goes; raises as `tell`."""
    if sys.stdout is not None:
        _to_output("")


def complain(line: str) -> None:
    """Print a line on standard error, if anybody listens there."""
    # Without anybody who listens the exit status still says it. Python prints to standard output instead of nowhere.
    if sys.stderr is None:
        return
    with contextlib.suppress(OSError, ValueError):
        print(printable(line, len(line)), file=sys.stderr, flush=True)


def leave() -> None:
    """Drop what standard output has not taken, lest Python complain of it once more at its end."""
    sys.stdout = None


def _to_output(text: str) -> None:
    try:
        if sys.stdout is None:
            raise InputError("standard output", "", None, "cannot be written: it is closed")
        sys.stdout.write(text)
        if not text:
            sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise InputError("standard output", "", None, f"cannot be written: {error.strerror}") from error
    except InputError:
        raise
    except ValueError as error:
        raise InputError("standard output", "", None, f"cannot be written: {error}") from error
