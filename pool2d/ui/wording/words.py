"""What the window says, in the player's language: one catalogue for each, found by key.

A catalogue is a TOML file of sections of texts; the text of `[help]` `strike` is asked for as `help.strike`.
Texts may have places to fill in, as in "{count} balls left". What a language lacks is said in English.
"""

from __future__ import annotations

import locale
import os
import re
import string
import sys
from collections.abc import Hashable, Sequence
from functools import lru_cache
from typing import Any

from ...config.assets import asset, assets
from ...config.reader import read_toml
from ...config.settings import SPEEDS
from ...errors import InputError

AUTO, ENGLISH = "auto", "en"


class Catalogue:
    """The texts of one language by dotted key; `complaints` are what is wrong with its file."""

    def __init__(self, language: str) -> None:
        self.language = language
        self.texts: dict[str, str] = {}
        self.complaints: list[InputError] = []
        path = asset("words", language + ".toml")
        try:
            self._take(read_toml(path), "", str(path))
        except InputError as error:
            self.complaints.append(error)

    def _take(self, data: dict[str, Any], prefix: str, source: str) -> None:
        for key, value in data.items():
            if isinstance(value, dict):
                self._take(value, f"{prefix}{key}.", source)
            elif isinstance(value, str) and _fillable(value):
                self.texts[prefix + key] = value
            else:
                self.complaints.append(InputError(source, prefix + key, value, "allowed is a text, with places {name}"))


@lru_cache
def catalogue(language: str) -> Catalogue:
    """A language's texts; read once."""
    return Catalogue(language)


class _Present:
    """The language spoken, and the unit that speeds are told in."""

    language = ENGLISH
    unit = "m/s"


def languages() -> list[str]:
    """Every language there is a catalogue for."""
    return [path.stem for path in assets("words", ".toml")]


def speak(language: str) -> Sequence[InputError]:
    """Say everything in this language from now on, and return what is wrong with its catalogue.

    `auto` is the system's language; one without a catalogue is English.
    """
    chosen = system_language() if language == AUTO else language
    _Present.language = chosen if chosen in languages() else ENGLISH
    return catalogue(_Present.language).complaints


def language() -> str:
    """The language spoken, by its two letters."""
    return _Present.language


def manner() -> Hashable:
    """What every text depends on besides what it tells: another manner, other texts."""
    return _Present.language, _Present.unit


def tell_speeds_in(unit: str) -> None:
    """Tell speeds in this unit from now on."""
    _Present.unit = unit


def say(key: str, /, **values: object) -> str:
    """A text with its places filled in; of `count`, where it is 1, the text `key.one` if there is one."""
    if values.get("count") == 1 and _text(key + ".one") is not None:
        key += ".one"
    said = _text(key)
    # A text that is missing everywhere is still told apart by its key.
    return key if said is None else string.Formatter().vformat(said, (), _Blanks(values))


def known(key: str) -> bool:
    """Whether there is a text of that key."""
    return _text(key) is not None


def say_or(key: str, other: str) -> str:
    """A text as it stands, its places unfilled; `other` where there is none of that key."""
    return _text(key) or other


def number(value: float, form: str) -> str:
    """A number as the language writes it: `form` is as for `format`."""
    return format(value, form).replace(".", say("number.point"))


def speed(value: float) -> str:
    """A speed, given in m/s, in the unit the player has chosen."""
    unit = _Present.unit
    return f"{number(value * SPEEDS[unit], '.2f' if unit == 'm/s' else '.1f')} {unit}"


def unit(name: str) -> str:
    """A unit as the language writes it."""
    return say_or(f"unit.{name}", name)


def system_language() -> str:
    """The two letters of the system's language; empty where it does not say."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if given := os.environ.get(variable):
            return given[:2].lower()
    if sys.platform == "win32":
        import ctypes

        number_ = ctypes.windll.kernel32.GetUserDefaultUILanguage()
        return locale.windows_locale.get(number_, "")[:2].lower()
    return (locale.getlocale()[0] or "")[:2].lower()


class _Blanks(dict[str, object]):
    """Values for places; a place without one is left standing."""

    def __missing__(self, key: str) -> str:
        return "{" + key + "}"


def places(text: str) -> set[str]:
    """The names of the places in a text."""
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


def _fillable(text: str) -> bool:
    try:
        return all(re.fullmatch(r"[a-z_]+", name) for name in places(text))
    except ValueError:
        return False


def _text(key: str) -> str | None:
    return catalogue(_Present.language).texts.get(key) or catalogue(ENGLISH).texts.get(key)
