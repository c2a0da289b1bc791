"""What the player has set: kept in one file, checked by knobs, and never lost to a mistake in it."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..errors import InputError
from .files import to_toml, write_text
from .folders import config_folder
from .knobs import apply, choice, flag, knob, text, walk
from .reader import check_sound, line_of, read_toml

FILE = "settings.toml"
GUIDES = ("off", "line", "ghost ball", "whole shot")
# Speed units, and what one m/s is in them.
SPEEDS = {"m/s": 1.0, "km/h": 3.6, "mph": 2.236936}


@dataclass(frozen=True, slots=True)
class Sound:
    volume: float = knob(0.8, 0.0, 1.0, "", "how loud balls, cushions and pockets are")
    mute: bool = flag(False, "no sound at all")


@dataclass(frozen=True, slots=True)
class Balls:
    palette: str = text("standard", 40, "the balls' colours, by name")
    patterned: bool = flag(False, "tell balls by a pattern as well as by colour")
    trails: bool = flag(True, "show where the balls have been")


@dataclass(frozen=True, slots=True)
class Aiming:
    guide: str = choice("ghost ball", GUIDES, "how much of the shot is shown before it is played")
    speed_unit: str = choice("m/s", tuple(SPEEDS), "in what the speed of the cue is told")
    easy_stroke: bool = flag(False, "the cue goes through rails and balls, and its tip never hits a ball twice")


@dataclass(frozen=True, slots=True)
class ScreenSettings:
    """`width` and `height` of 0 leave the window's size to the screen it opens on."""

    language: str = text("auto", 12, "the language of the window; auto takes the system's")
    reduced_motion: bool = flag(False, "nothing slides or glides except the balls")
    full: bool = flag(False, "fill the screen")
    instant_players: bool = flag(False, "players who are no people are not seen to aim")
    width: float = knob(0.0, 0.0, 16384.0, "pixels", "the window's width")
    height: float = knob(0.0, 0.0, 16384.0, "pixels", "the window's height")


@dataclass(frozen=True, slots=True)
class Players:
    """Empty names are Player 1 and Player 2 in the language of the window."""

    first: str = text("", 40, "the name of the first player")
    second: str = text("", 40, "the name of the second player")
    first_by: str = text("", 40, "who plays the first side: a player's file, or a person")
    second_by: str = text("greta", 40, "who plays the second side: a player's file, or a person")

    @property
    def names(self) -> tuple[str, str]:
        return self.first, self.second

    @property
    def sides(self) -> tuple[str, str]:
        """Who plays each side, "" for a person."""
        return self.first_by, self.second_by


@dataclass(frozen=True, slots=True)
class MatchSettings:
    """What was agreed for the match before the next; names that stand for nothing any more are passed over."""

    game: str = text("", 400, "the game, and the options of its rules as name=value")
    table: str = text("", 400, "the table")
    race: float = knob(1.0, 1.0, 99.0, "frames", "how many frames win the match")
    breaker: float = knob(-1.0, -2.0, 1.0, "", "who breaks first: a player from 0, -1 a coin, -2 a lag")
    breaks: str = text("", 40, "who breaks then")


@dataclass(frozen=True, slots=True)
class Settings:
    aiming: Aiming = field(default_factory=Aiming)
    balls: Balls = field(default_factory=Balls)
    sound: Sound = field(default_factory=Sound)
    screen: ScreenSettings = field(default_factory=ScreenSettings)
    players: Players = field(default_factory=Players)
    match: MatchSettings = field(default_factory=MatchSettings)


class Store:
    """The present settings, and the file behind them.

    `values` are the settings and `keys` the keys that the player has bound, by action. `listeners` are
    called after each change. `complaints` are what was wrong with the file: a value that is not allowed
    is the default instead, and the file as it was is kept beside with the ending `.bad`. What the file
    holds besides is kept when it is written. Without a path nothing is read or written.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self.values = Settings()
        self.keys: dict[str, tuple[str, ...]] = {}
        self.listeners: list[Callable[[], None]] = []
        self.complaints: list[InputError] = []
        self.changed = False
        self._rest: dict[str, Any] = {}
        if path is not None and path.exists():
            self._read(path)

    @classmethod
    def open(cls) -> Store:
        """The settings of this user."""
        return cls(config_folder() / FILE)

    def turn(self, name: str, value: object) -> None:
        """Change one setting; raises InputError for what is not allowed."""
        values = apply(self.values, {name: value}, "settings")
        if values != self.values:
            self.values = values
            self._tell()

    def bind(self, keys: Mapping[str, Sequence[str]]) -> None:
        """Keep these keys, by action, in place of those kept so far."""
        self.keys = {action: tuple(names) for action, names in keys.items()}
        self._tell()

    def complain(self, error: InputError) -> None:
        """Take note of a value that only its user could judge, and keep the file as it was."""
        if not self.complaints and self.path is not None:
            self._put_aside(self.path)
        self.complaints.append(error)

    def save(self) -> None:
        """Write what has changed; raises InputError where that fails."""
        if self.changed and self.path is not None:
            # Tried once for each change, lest a full disk be complained of at every frame.
            self.changed = False
            write_text(self.path, to_toml(self._data()).lstrip("\n"))

    def _tell(self) -> None:
        self.changed = True
        for listener in self.listeners:
            listener()

    def _data(self) -> dict[str, Any]:
        """What the file is to hold: what was not understood, and what differs from the defaults."""
        data = {key: dict(value) if isinstance(value, dict) else value for key, value in self._rest.items()}
        for name, described, value in walk(self.values):
            group, _, key = name.partition(".")
            if value != described.default:
                data.setdefault(group, {})[key] = value
        if self.keys:
            data["keys"] = {action: list(names) for action, names in self.keys.items()}
        return data

    def _read(self, path: Path) -> None:
        try:
            self._take(read_toml(path, sound=False), path)
        except InputError as error:
            self.complaints.append(error)
        if self.complaints:
            self._put_aside(path)

    def _take(self, data: dict[str, Any], path: Path) -> None:
        known = {name.partition(".")[0] for name, _, _ in walk(self.values)}
        for group, content in data.items():
            if group not in known and group != "keys":
                self._keep(self._rest, group, content, path)
            elif not isinstance(content, dict):
                self.complaints.append(_wrong(path, group, content, "allowed is a section"))
            elif group == "keys":
                self._take_keys(content, path)
            else:
                for key, value in content.items():
                    self._take_one(group, key, value, path)

    def _take_one(self, group: str, key: str, value: object, path: Path) -> None:
        name = f"{group}.{key}"
        if name not in {known for known, _, _ in walk(self.values)}:
            self._keep(self._rest.setdefault(group, {}), key, value, path)
            return
        try:
            self.values = apply(self.values, {name: value}, str(path))
        except InputError as error:
            self.complaints.append(_wrong(path, name, value, error.allowed))

    def _keep(self, rest: dict[str, Any], key: str, value: object, path: Path) -> None:
        """Keep what is not understood, perhaps of a later version, where it is sound."""
        try:
            check_sound({key: value}, str(path))
        except InputError as error:
            self.complaints.append(error)
        else:
            rest[key] = value

    def _take_keys(self, content: dict[str, Any], path: Path) -> None:
        for action, names in content.items():
            if isinstance(names, list) and all(isinstance(name, str) and name.isprintable() for name in names):
                self.keys[action] = tuple(names)
            else:
                self.complaints.append(_wrong(path, f"keys.{action}", names, "allowed is a list of keys' names"))

    def _put_aside(self, path: Path) -> None:
        """Keep a file with a mistake under another name; if that cannot be, leave it alone from now on."""
        self.changed = True
        aside = path.with_name(path.name + ".bad")
        for number in range(2, 1000):
            if not aside.exists():
                break
            aside = path.with_name(f"{path.name}.bad{number}")
        try:
            os.rename(path, aside)
        except OSError:
            self.path = None


def _wrong(path: Path, key: str, value: object, allowed: str) -> InputError:
    line = 0
    with contextlib.suppress(OSError):
        line = line_of(path, key)
    return InputError(str(path), key, value, allowed, line)
