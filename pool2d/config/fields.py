"""The keys of what a file holds, asked for by name and type: every reader complains of a wrong one alike."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any

from ..errors import InputError, suggest


def check_keys(data: Mapping[str, Any], known: Sequence[str], source: str, prefix: str = "") -> None:
    """Raises InputError for a key that is not among the known ones; `prefix` is where the keys stand in the file."""
    for key, value in data.items():
        if key not in known:
            raise InputError(source, prefix + key, value, suggest(key, known))


def value_of(data: Mapping[str, Any], key: str, kind: type, source: str, default: Any = None, prefix: str = "") -> Any:
    """The value of a key, or the default where it is not there; raises InputError where it is of another type.

    A whole number is no float here, and true no whole number: files that pool2d writes tell them apart.
    """
    value = data.get(key, default)
    if type(value) is not kind:
        raise InputError(source, prefix + key, value, f"allowed is a {kind.__name__}")
    return value


def number_in(text: str) -> float | str:
    """The number that a text is; the text itself, without blanks around it, where it is none."""
    with suppress(ValueError):
        return float(text)
    return text.strip()
