"""The sounds as waves: clean, short, brighter where the contact is harder, and never quite the same."""

from __future__ import annotations

from collections import defaultdict
from functools import cache

import numpy as np
import pytest

from pool2d.sound.impacts import SoundKind
from pool2d.sound.synth import KINDS, RATE, Wave, waves


@cache
def made() -> dict[str, dict[float, list[Wave]]]:
    every: dict[str, dict[float, list[Wave]]] = defaultdict(lambda: defaultdict(list))
    for kind, speed, wave in waves():
        every[kind][speed].append(wave)
    return every


def centroid(wave: Wave) -> float:
    """The middle of the spectrum's power, Hz."""
    power = np.abs(np.fft.rfft(wave)) ** 2
    return float(np.sum(power * np.fft.rfftfreq(wave.size, 1.0 / RATE)) / np.sum(power))


@pytest.mark.parametrize("kind", KINDS)
def test_every_speed_and_variant_is_made(kind: SoundKind) -> None:
    assert {speed: len(each) for speed, each in made()[kind].items()} == dict.fromkeys(
        KINDS[kind].speeds, KINDS[kind].variants
    )


@pytest.mark.parametrize("kind", KINDS)
def test_a_wave_goes_from_silence_to_silence_within_range(kind: str) -> None:
    for wave in (wave for each in made()[kind].values() for wave in each):
        assert np.isfinite(wave).all()
        assert np.abs(wave).max() == pytest.approx(1.0)
        assert abs(wave[0]) < 1e-3
        assert abs(wave[-1]) < 1e-3
        assert np.abs(wave[-wave.size // 50 :]).max() < 0.05
        assert abs(wave.mean()) < 1e-9


@pytest.mark.parametrize("kind", ["ball", "cue", "cushion"])
def test_a_harder_contact_is_brighter(kind: str) -> None:
    middles = [np.mean([centroid(wave) for wave in each]) for _, each in sorted(made()[kind].items())]
    assert middles == sorted(middles)
    assert middles[-1] > 1.2 * middles[0]


def test_a_click_a_tock_and_a_thump_differ_in_pitch() -> None:
    ball, cue, cushion = (centroid(made()[kind][KINDS[kind].speeds[-1]][0]) for kind in ("ball", "cue", "cushion"))
    assert ball > 2.0 * cue > 4.0 * cushion


def test_a_click_is_over_in_some_milliseconds() -> None:
    for each in made()["ball"].values():
        for wave in each:
            energy = np.cumsum(wave**2)
            assert np.searchsorted(energy, 0.9 * energy[-1]) < 0.01 * RATE


# As with the golden pictures: the middle of the spectrum at the greatest speed, Hz, and how long nine tenths of the
# energy take, ms, as they are with the sounds that the game was given.
HEARD = {
    "ball": (2990, 5.0), "cue": (970, 14.0), "cushion": (174, 39.0), "drop": (268, 114.0), "back": (374, 1710.0),
    "slate": (310, 20.9), "rail": (807, 13.9), "floor": (104, 306.0),
    "miscue": (2340, 26.0), "chalk": (4600, 363.0), "click": (1833, 4.6),
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_a_sound_keeps_its_pitch_and_length(kind: str) -> None:
    last = made()[kind][max(made()[kind])]
    energies = [np.cumsum(wave**2) for wave in last]
    lengths = [np.searchsorted(energy, 0.9 * energy[-1]) / RATE * 1e3 for energy in energies]
    heard = float(np.mean([centroid(wave) for wave in last])), float(np.mean(lengths))
    assert heard == pytest.approx(HEARD[kind], rel=0.1)


def test_no_two_variants_are_alike() -> None:
    for kind in KINDS:
        for each in made()[kind].values():
            assert len({wave.tobytes() for wave in each}) == len(each)


def test_they_are_the_same_every_time() -> None:
    kind, speed, wave = next(waves())
    assert np.array_equal(wave, made()[kind][speed][0])


def test_all_together_are_small() -> None:
    # Two channels of 16 bits.
    size = sum(4 * wave.size for kind in made().values() for each in kind.values() for wave in each)
    assert size < 4_000_000
