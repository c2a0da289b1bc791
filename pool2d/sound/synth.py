"""The sounds of the table, worked out from what makes them: short waves, in numpy.

Each is made once, for a few speeds and in a few variants that differ as one real knock differs from the
next. A contact is a pulse of force; the faster the bodies meet, the shorter it is and the brighter what
it sets ringing. Balls hardly ring themselves, since their lowest mode lies about where hearing ends: their
click is the air that the sudden start and stop of a sphere pushes (Koss and Alfredson 1973), and the table's
answer.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt

from ..physics.body import Body
from ..physics.springs import RADIUS, duration
from ..physics.values import Ball
from .impacts import SoundKind

if TYPE_CHECKING:
    # numpy loads its random numbers when they are first asked for, which is after the first frame.
    from numpy.random import Generator as Noise

Wave = npt.NDArray[np.float64]

# Samples per second.
RATE = 48_000
# Of sound in air, m/s.
_AIR = 343.0
_BALL = Body(Ball("", 0.0, 0.0), 0, RADIUS, 0.17)

# Partials: frequency in Hz, time in which it fades to 1/e in s, level.
_SLATE = (
    (1150.0, 0.006, 0.05), (2350.0, 0.005, 0.15), (3900.0, 0.004, 0.25), (6100.0, 0.003, 0.32), (8300.0, 0.002, 0.30),
)  # fmt: skip
_SHAFT = (
    (310.0, 0.018, 0.18), (720.0, 0.014, 0.50), (1240.0, 0.011, 1.0),
    (2080.0, 0.007, 0.90), (3350.0, 0.004, 0.70), (5200.0, 0.002, 0.50),
)  # fmt: skip
_RUBBER = ((128.0, 0.040, 0.8), (196.0, 0.030, 0.9), (305.0, 0.018, 0.7))
_RAIL = ((470.0, 0.013, 0.60), (760.0, 0.009, 0.50), (1300.0, 0.005, 0.40))
_BED = ((240.0, 0.020, 0.9), (420.0, 0.015, 0.8), (760.0, 0.008, 0.45), (1500.0, 0.005, 0.25), (2900.0, 0.003, 0.12))
_WOOD = ((390.0, 0.014, 0.5), (820.0, 0.012, 0.9), (1450.0, 0.008, 0.8), (2600.0, 0.004, 0.5))
_BOARDS = ((82.0, 0.060, 1.0), (131.0, 0.045, 0.9), (247.0, 0.025, 0.5), (520.0, 0.012, 0.3))
_LEATHER = ((152.0, 0.030, 0.8), (240.0, 0.022, 0.9), (390.0, 0.014, 0.6))
_BOX = ((174.0, 0.040, 0.5), (292.0, 0.030, 0.9), (455.0, 0.022, 1.0), (810.0, 0.012, 0.8), (1480.0, 0.006, 0.6))
_TICK = ((1850.0, 0.004, 1.0), (3100.0, 0.003, 0.6))


class Kind(NamedTuple):
    """A kind of sound: the function that makes it, the speeds, m/s, that it is made for, how many variants of each."""

    make: Callable[[float, float, Noise], Wave]
    speeds: tuple[float, ...]
    variants: int


def waves() -> Iterator[tuple[SoundKind, float, Wave]]:
    """Every sound: its kind, the speed it was made for, and its wave within -1 to 1. Always the same."""
    for name, kind in KINDS.items():
        for speed in kind.speeds:
            noise = np.random.default_rng(round(1000.0 * speed))
            for _ in range(kind.variants):
                pitch = 1.0 + 0.03 * float(noise.uniform(-1.0, 1.0))
                yield name, speed, _finish(kind.make(speed, pitch, noise))


def ball(speed: float, pitch: float, noise: Noise) -> Wave:
    """Two balls that meet at `speed`, the pulse being as long as Hertz's contact."""
    pulse = _pulse(duration(_BALL, _BALL, speed) / pitch)
    room = _dying_noise(0.07, 0.012, noise, 900.0, 9000.0)
    return _struck(pulse, _sum(_sphere(pitch), _ring(0.07, _SLATE, pitch, noise), 0.05 * room))


def cue(speed: float, pitch: float, noise: Noise) -> Wave:
    """A leather tip meets a ball for about a millisecond, so the shaft is heard more than the ball."""
    pulse = _pulse(0.9e-3 / pitch * math.pow(speed, -0.2))
    room = _dying_noise(0.10, 0.010, noise, 300.0, 4000.0)
    return _struck(pulse, _sum(_ring(0.12, _SHAFT, pitch, noise), 2.0 * _sphere(pitch), 0.15 * room))


def cushion(speed: float, pitch: float, noise: Noise) -> Wave:
    """Rubber gives way for milliseconds: a soft thump of the rail with a brush of cloth on it."""
    pulse = _pulse(2.4e-3 / pitch * math.pow(speed, -0.25))
    thump = _struck(pulse, _sum(_ring(0.30, _RUBBER, pitch, noise), _ring(0.10, _RAIL, pitch, noise)))
    brush = _dying_noise(0.06, 0.007, noise, 500.0, 2600.0)
    return _sum(_unit(thump), 0.10 * math.pow(speed, 0.3) * _unit(brush))


def slate(speed: float, pitch: float, noise: Noise) -> Wave:
    """A ball comes down on cloth over slate: a short dull knock of stone, the cloth taking its edge off."""
    pulse = _pulse(0.7e-3 / pitch * math.pow(speed, -0.2))
    bed = _dying_noise(0.06, 0.008, noise, 200.0, 2400.0)
    return _struck(pulse, _sum(_ring(0.12, _BED, pitch, noise), 0.8 * _sphere(pitch), 0.10 * bed))


def rail(speed: float, pitch: float, noise: Noise) -> Wave:
    """A ball comes down on the wood of a rail: harder and higher than on the bed."""
    pulse = _pulse(0.5e-3 / pitch * math.pow(speed, -0.2))
    wood = _dying_noise(0.05, 0.006, noise, 600.0, 4500.0)
    return _struck(pulse, _sum(_ring(0.12, _WOOD, pitch, noise), _sphere(pitch), 0.10 * wood))


def floor(speed: float, pitch: float, noise: Noise) -> Wave:
    """A ball falls on boards: a deep blow of the floor, and bounces that come closer and closer."""
    knocks, at, level = [], 0.0, 1.0
    # It keeps about half of its speed, so each bounce lasts half as long as the one before.
    after = 0.26 * float(noise.uniform(0.9, 1.1))
    for _ in range(4):
        pulse = _pulse(1.6e-3 / pitch * math.pow(speed * level, -0.2))
        boards = _struck(pulse, _ring(0.22, _BOARDS, pitch * float(noise.uniform(0.97, 1.03)), noise))
        knocks.append(_later(level * _unit(boards), at))
        at, after, level = at + after, 0.5 * after, 0.45 * level
    return _sum(*knocks)


def drop(speed: float, pitch: float, noise: Noise) -> Wave:
    """A ball meets the leather at a pocket's back, falls into the box below, and bounces once."""
    leather = _struck(_pulse(2.5e-3 / pitch * math.pow(speed, -0.2)), _ring(0.20, _LEATHER, pitch, noise))
    parts = [_unit(leather)]
    # It falls a hand's breadth, and bounces to a small part of that.
    fall = 0.085 * float(noise.uniform(0.9, 1.15))
    for at, level in ((fall, 0.8), (fall + 0.075 * float(noise.uniform(0.9, 1.2)), 0.28)):
        knock = _struck(_pulse(0.6e-3 / pitch), _ring(0.25, _BOX, pitch * float(noise.uniform(0.96, 1.04)), noise))
        parts.append(_later(level * _unit(knock), at))
    return _sum(*parts)


def back(speed: float, pitch: float, noise: Noise) -> Wave:
    """A ball rolls through the table to the tray: a rumble that comes nearer, and a click against the others."""
    wait, seconds = 0.30, 1.3 / speed * float(noise.uniform(0.9, 1.15))
    time = _time(seconds)
    # A trough is rough: many small knocks, stronger once per turn of the ball.
    turn = speed / (math.tau * RADIUS)
    swell = 0.35 + 0.65 * time / seconds
    knocks = noise.standard_normal(time.size) * (noise.random(time.size) < 0.06)
    rough = knocks * swell * (1.0 + 0.45 * np.sin(math.tau * turn * time + float(noise.uniform(0.0, 6.0))))
    rumble = _faded(_band(_struck(rough, _ring(0.10, _BOX, pitch, noise)), 70.0, 900.0), 0.15, 0.03)
    click = ball(0.7, pitch, noise)
    stop = _struck(_pulse(0.8e-3), _ring(0.20, _BOX, pitch, noise))
    end = wait + seconds - 0.01
    return _sum(_later(0.45 * _unit(rumble), wait), _later(0.7 * _unit(stop), end), _later(0.5 * _unit(click), end))


def miscue(speed: float, pitch: float, noise: Noise) -> Wave:
    """A tip that slips: leather that sticks and slips across the ball, and a dull knock of the shaft."""
    time = _time(0.075 / math.pow(speed, 0.2))
    # The squeak rises as the tip comes free, with jitter.
    rise = 1500.0 * pitch * (1.0 + 0.6 * time / time[-1]) + 90.0 * _smooth(noise.standard_normal(time.size), 120)
    phase = math.tau * np.cumsum(rise) / RATE
    squeak = np.sin(phase) + 0.5 * np.sin(2.0 * phase) + 0.3 * np.sin(3.0 * phase)
    scrape = _unit(_band(noise.standard_normal(time.size), 1800.0, 6500.0))
    slip = _faded(_unit(squeak) * 0.5 + scrape, 0.004, 0.055)
    return _sum(0.8 * _unit(cue(speed, 0.85 * pitch, noise)), _later(0.6 * _unit(slip), 0.002))


def chalk(speed: float, pitch: float, noise: Noise) -> Wave:
    """Chalk turned on the tip: three short rubs, each made of many grains."""
    parts = []
    at = 0.0
    for level in (0.8, 1.0, 0.7):
        seconds = 0.13 / speed * float(noise.uniform(0.85, 1.15))
        time = _time(seconds)
        grains = noise.standard_normal(time.size) * (noise.random(time.size) < 0.25)
        rub = _band(grains, 1500.0 * pitch, 5200.0 * pitch) * np.sin(math.pi * time / seconds) ** 1.5
        parts.append(_later(level * _unit(rub), at))
        at += seconds * float(noise.uniform(1.05, 1.25))
    return _sum(*parts)


def click(speed: float, pitch: float, noise: Noise) -> Wave:
    """A small tick, for a control of the window."""
    return _struck(_pulse(0.35e-3), _ring(0.03, _TICK, pitch, noise))


KINDS: dict[SoundKind, Kind] = {
    "ball": Kind(ball, (0.1, 0.3, 1.0, 3.0, 9.0), 4),
    "cue": Kind(cue, (0.5, 2.0, 7.0), 3),
    "cushion": Kind(cushion, (0.3, 1.2, 5.0), 3),
    "slate": Kind(slate, (0.4, 1.5, 4.0), 3),
    "rail": Kind(rail, (0.5, 2.5), 3),
    "floor": Kind(floor, (4.0,), 3),
    "drop": Kind(drop, (1.5, 4.0), 3),
    "back": Kind(back, (1.0,), 3),
    "miscue": Kind(miscue, (1.0, 4.0), 2),
    "chalk": Kind(chalk, (1.0,), 2),
    "click": Kind(click, (1.0,), 1),
}


# What sounds are made of.


def _time(seconds: float) -> Wave:
    return np.arange(max(2, round(seconds * RATE))) / RATE


def _pulse(seconds: float) -> Wave:
    """The force of a contact that lasts so long: after Hertz about sin^1.5, with a sum of one."""
    count = max(3, math.ceil(seconds * RATE))
    force = np.sin(math.pi * np.minimum((np.arange(count) + 0.5) / (seconds * RATE), 1.0)) ** 1.5
    return np.asarray(force / force.sum())


def _sphere(pitch: float) -> Wave:
    """The pressure far from a ball that gets a sudden push.

    A sphere that swings sends out s T / (2 + 2 s T + s^2 T^2) of its acceleration, T = R / c; this is that
    in time.
    """
    age = _time(0.004) * _AIR * pitch / RADIUS
    wave = np.exp(-age) * (np.cos(age) - np.sin(age))
    # The jump at the start lies half before it. So the whole sums to nothing, as it does in the air.
    wave[0] *= 0.5
    return np.asarray(wave)


def _ring(seconds: float, partials: Sequence[tuple[float, float, float]], pitch: float, noise: Noise) -> Wave:
    """Damped partials; no two knocks hit the same spot, so each partial's pitch and level differ by a little."""
    time = _time(seconds)
    wave = np.zeros(time.size)
    for frequency, fade, level in partials:
        turn = math.tau * frequency * pitch * float(noise.uniform(0.97, 1.03))
        wave += level * float(noise.uniform(0.8, 1.2)) * np.exp(-time / fade) * np.sin(turn * time)
    return wave


def _dying_noise(seconds: float, fade: float, noise: Noise, low: float, high: float) -> Wave:
    """Noise between two frequencies, Hz, that dies away within about `fade` s: what a room or cloth adds."""
    time = _time(seconds)
    hiss = _unit(_band(noise.standard_normal(time.size), low, high))
    return hiss * np.exp(-time / fade) * np.minimum(time / 0.002, 1.0)


def _struck(pulse: Wave, answer: Wave) -> Wave:
    """The sound of a pulse of force on something that answers a sudden push by `answer`: their convolution."""
    size = pulse.size + answer.size - 1
    room = _room(size)
    return np.asarray(np.fft.irfft(np.fft.rfft(pulse, room) * np.fft.rfft(answer, room), room)[:size])


def _band(wave: Wave, low: float, high: float) -> Wave:
    """The part of a wave between two frequencies, Hz, with soft edges."""
    room = _room(wave.size)
    frequency = np.maximum(np.fft.rfftfreq(room, 1.0 / RATE), 1e-3)
    keep = 1.0 / np.sqrt((1.0 + (low / frequency) ** 4) * (1.0 + (frequency / high) ** 4))
    return np.asarray(np.fft.irfft(np.fft.rfft(wave, room) * keep, room)[: wave.size])


def _room(size: int) -> int:
    """A length of a little more than `size` with small factors, for which a Fourier transform is fast."""
    step = 1 << max(0, size.bit_length() - 4)
    return -(-size // step) * step


def _smooth(wave: Wave, width: int) -> Wave:
    """A slow wave of about unit size out of a rough one."""
    return np.convolve(wave, np.full(width, 1.0 / math.sqrt(width)), "same")


def _unit(wave: Wave) -> Wave:
    """The wave scaled to a peak of one."""
    return np.asarray(wave / np.abs(wave).max())


def _later(wave: Wave, seconds: float) -> Wave:
    return np.concatenate([np.zeros(round(seconds * RATE)), wave])


def _sum(*parts: Wave) -> Wave:
    """The sum of waves that begin together; the longest gives the length."""
    whole = np.zeros(max(part.size for part in parts))
    for part in parts:
        whole[: part.size] += part
    return whole


def _faded(wave: Wave, start: float, end: float) -> Wave:
    """The wave with a fade-in and a fade-out, each in s."""
    time = _time(wave.size / RATE)
    edge = np.minimum(np.minimum(time / start, time[::-1] / end), 1.0)
    return np.asarray(wave * np.sin(0.5 * math.pi * edge) ** 2)


def _finish(wave: Wave) -> Wave:
    """Ready to be played: from silence to silence, about zero, with a peak of one."""
    wave = _faded(wave, 0.0002, min(0.005, 0.2 * wave.size / RATE))
    hill = np.hanning(wave.size)
    return _unit(wave - hill * (wave.sum() / hill.sum()))
