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
from .keys import CTRL, Keymap, key_name

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


def languages() -> list[str]:
    """Every language there is a catalogue for."""
    return [path.stem for path in assets("words", ".toml")]


class Words:
    """What one window says: in a language, with speeds in a unit, and with the keys that the player has bound.

    The app has one, and whatever says anything has it from there.
    """

    def __init__(self) -> None:
        self.keys = Keymap()
        self.language = ENGLISH
        self.speed_unit = "m/s"

    def speak(self, language: str) -> Sequence[InputError]:
        """Say everything in this language from now on, and return what is wrong with its catalogue.

        `auto` is the system's language; one without a catalogue is English.
        """
        chosen = system_language() if language == AUTO else language
        self.language = chosen if chosen in languages() else ENGLISH
        return catalogue(self.language).complaints

    @property
    def manner(self) -> Hashable:
        """What every text depends on besides what it tells: another manner, other texts."""
        return self.language, self.speed_unit

    def say(self, key: str, /, **values: object) -> str:
        """A text with its places filled in; of `count`, where it is 1, the text `key.one` if there is one."""
        if values.get("count") == 1 and self.known(key + ".one"):
            key += ".one"
        said = self._text(key)
        # A text that is missing everywhere is still told apart by its key.
        return key if said is None else string.Formatter().vformat(said, (), _Blanks(values))

    def say_or(self, key: str, other: str) -> str:
        """A text as it stands, its places unfilled; `other` where there is none of that key."""
        return self._text(key) or other

    def known(self, key: str) -> bool:
        """Whether there is a text of that key."""
        return self._text(key) is not None

    def _text(self, key: str) -> str | None:
        return catalogue(self.language).texts.get(key) or catalogue(ENGLISH).texts.get(key)

    # Numbers.

    def number(self, value: float, form: str) -> str:
        """A number as the language writes it, and 0 without a sign: `form` is as for `format`, without signs."""
        return format(value, f"z{form}").replace(".", self.say("number.point"))

    def quantity(self, value: float, form: str, unit: str) -> str:
        """A number with its unit, as the language writes both."""
        return f"{self.number(value, form)} {self.say_or(f'unit.{unit}', unit)}".rstrip()

    def speed(self, value: float) -> str:
        """A speed, given in m/s, in the unit the player has chosen."""
        unit = self.speed_unit
        return f"{self.number(value * SPEEDS[unit], '.2f' if unit == 'm/s' else '.1f')} {unit}"

    # Keys.

    def key(self, *actions: str) -> str:
        """The keys of actions, as people call them."""
        if len(actions) > 1:
            firsts = (self.chords(*self.keys.chords[action][:1]) for action in actions)
            return (" / " if len(actions) == 2 else " ").join(firsts)
        return self.chords(*self.keys.chords[actions[0]])

    def chords(self, *chords: int) -> str:
        """Chords as people call them: "Space, Enter"."""
        return ", ".join(map(self._chord, chords)) or self.say("key.none")

    def _chord(self, chord: int) -> str:
        key = chord & ~CTRL
        given = self.keys.keyboard.given(key)
        name = chr(given) if given != key else key_name(key)
        text = name.replace(" ", "_")
        if self.known(f"key.{text}"):
            said = self.say(f"key.{text}")
        else:
            said = name.upper() if len(name) <= 3 else name.capitalize()
        return f"{self.say('key.ctrl')}+{said}" if chord & CTRL else said


class _Blanks(dict[str, object]):
    """Values for places; a place without one is left standing."""

    def __missing__(self, key: str) -> str:
        return "{" + key + "}"


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


def places(text: str) -> set[str]:
    """The names of the places in a text."""
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


def _fillable(text: str) -> bool:
    try:
        return all(re.fullmatch(r"[a-z_]+", name) for name in places(text))
    except ValueError:
        return False
