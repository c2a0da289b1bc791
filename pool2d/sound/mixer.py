"""Playing sounds through the system's device; without a device, silence.

Nothing here delays the first frame: the device is opened after it, and the sounds are made one at a time between
the frames that follow, all within about a second.
"""

from __future__ import annotations

import math
import os
import random
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import pygame

from ..physics.rollout import Rollout
from ..table.table import Table
from . import synth
from .impacts import Impact, SoundKind, impacts

# How loud a kind is at the most, and the speed at which it is, m/s.
_LOUDNESS: dict[SoundKind, tuple[float, float]] = {
    "ball": (0.80, 8.0), "cue": (0.32, 6.0), "cushion": (0.45, 4.0), "drop": (0.30, 3.0), "back": (0.08, 1.0),
    "slate": (0.40, 2.5), "rail": (0.45, 2.5), "floor": (0.55, 4.0),
    "miscue": (0.22, 2.0), "chalk": (0.08, 1.0), "click": (0.06, 1.0),
}  # fmt: skip
# The pressure of a click goes about with the speed; an ear that shall hear the soft ones too needs less.
_POWER = 0.7
# What is softer is not played.
_FAINT = 0.01
# The most sounds that may start within a time, s, and that may sound together.
_STARTS, _WITHIN, _CHANNELS = 6, 0.03, 32
# Samples that the device takes at once: 11 ms.
_BUFFER = 512
# How far to a side the ends of the table are heard, 0 to 1.
_WIDTH = 0.7


class Sounds:
    """Plays what happens on a table.

    `volume` is from 0 to 1; `muted` silences all. Until `prepare` has opened a device, and where there is
    none, every call does nothing.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.volume = 1.0
        self.muted = False
        self._clock = clock
        self._random = random.Random()
        self._starts: deque[float] = deque(maxlen=_STARTS)
        self._made: dict[SoundKind, dict[float, list[pygame.mixer.Sound]]] = {}
        self._waves: Iterator[tuple[SoundKind, float, synth.Wave]] | None = None
        self._open: bool | None = None

    def prepare(self) -> bool:
        """Do the next piece of preparation: open the device, then make one sound a call. False when all is done."""
        if self._open is None:
            self._open = _open()
            self._waves = synth.waves() if self._open else None
        wave = next(self._waves, None) if self._waves is not None else None
        if wave is None:
            return False
        kind, speed, samples = wave
        self._made.setdefault(kind, {}).setdefault(speed, []).append(_sound(samples))
        return True

    def play_events(self, table: Table, rollout: Rollout, t0: float, t1: float) -> None:
        """Play the sounds of a rollout's events in (t0, t1], s; none where time runs backward or jumps."""
        if self._made:
            self.play(impacts(rollout, t0, t1, table.physics.gravity), table.knobs.table.length)

    def play(self, sounds: list[Impact], length: float = 1.0) -> None:
        """Start the loudest of these, as many as may sound at once; `length` is the table's, m, for left and right."""
        if self.muted:
            return
        now = self._clock()
        while self._starts and self._starts[0] <= now - _WITHIN:
            self._starts.popleft()
        gains = [(gain * self.volume, sound) for sound in sounds if (gain := loudness(sound)) * self.volume >= _FAINT]
        gains.sort(key=lambda pair: -pair[0])
        del gains[_STARTS - len(self._starts) :]
        # What starts together must not add up to more than the device can give.
        room = 1.0 / max(1.0, sum(gain for gain, _ in gains))
        for gain, sound in gains:
            if self._start(sound, [gain * room * side for side in pan(sound.x / length)]):
                self._starts.append(now)

    def chalk(self) -> None:
        """The tip is chalked."""
        self.play([Impact("chalk", 1.0, 0.5)])

    def click(self) -> None:
        """A control of the window was used."""
        self.play([Impact("click", 1.0, 0.5)])

    def mute(self, muted: bool) -> None:
        """Silence everything at once, or let it sound again."""
        self.muted = muted
        if self.muted and self._open:
            pygame.mixer.stop()

    def close(self) -> None:
        """Close the device; `prepare` opens it again."""
        self._made.clear()
        self._waves = None
        if self._open:
            pygame.mixer.quit()
        self._open = None

    def _start(self, sound: Impact, sides: list[float]) -> bool:
        """Play a variant of the nearest speed; False where it is not made yet, or no channel is free."""
        speeds = self._made.get(sound.kind)
        if not speeds:
            return False
        nearest = min(speeds, key=lambda speed: abs(math.log(speed / sound.speed)))
        channel = pygame.mixer.find_channel()
        if channel is None:
            return False
        # First how loud, then the sound: the device takes samples at any moment.
        channel.set_volume(*sides)
        channel.play(self._random.choice(speeds[nearest]))
        return True


def loudness(sound: Impact) -> float:
    """How loud a sound is played, from 0 to 1, by its kind and the speed of its contact."""
    most, speed = _LOUDNESS[sound.kind]
    return most * math.pow(min(sound.speed / speed, 1.0), _POWER)


def pan(part: float) -> tuple[float, float]:
    """The levels left and right for a place, 0 to 1 along the table; their squares add up to one."""
    side = _WIDTH * (2.0 * min(max(part, 0.0), 1.0) - 1.0)
    angle = 0.25 * math.pi * (1.0 + side)
    return math.cos(angle), math.sin(angle)


def _open() -> bool:
    """Open the device; False where that cannot be done."""
    try:
        with _quiet():
            pygame.mixer.init(synth.RATE, -16, 2, _BUFFER, allowedchanges=0)
        pygame.mixer.set_num_channels(_CHANNELS)
    except (pygame.error, NotImplementedError, OSError):
        # The second is a pygame that was built without a mixer.
        return False
    return True


@contextmanager
def _quiet() -> Iterator[None]:
    """Silence what the system's sound libraries print to standard error, which Python cannot catch."""
    try:
        kept = os.dup(2)
    except OSError:
        # There is no standard error to keep clean.
        yield
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(nowhere)
        os.close(kept)


def _sound(wave: synth.Wave) -> pygame.mixer.Sound:
    """A wave as the device takes it: 16 bits, the same left and right."""
    samples = np.round(32767.0 * wave).astype(np.int16)
    return pygame.mixer.Sound(buffer=np.repeat(samples, 2).tobytes())
