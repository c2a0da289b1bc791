"""The mixer: how loud, on which side, how many at once; and silence where there is no device."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pygame
import pytest

from pool2d import Shot, load_table, simulate
from pool2d.sound import synth
from pool2d.sound.impacts import Impact, SoundKind
from pool2d.sound.mixer import Sounds, loudness, pan

from ..ui.conftest import FRAME, Hand

ROOT = Path(__file__).parents[2]
# Sounds that were started, in their order.
Started = list[pygame.mixer.Sound]
LOUD, SOFT = Impact("ball", 8.0, 0.5), Impact("cushion", 0.3, 0.5)


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


def ready(clock: Clock) -> Sounds:
    sounds = Sounds(clock)
    while sounds.prepare():
        pass
    return sounds


def playing() -> list[pygame.mixer.Sound]:
    channels = (pygame.mixer.Channel(i) for i in range(pygame.mixer.get_num_channels()))
    return [sound for channel in channels if channel.get_busy() and (sound := channel.get_sound()) is not None]


class Watched:
    """A channel that writes down what is started on it."""

    def __init__(self, channel: pygame.mixer.Channel, started: Started) -> None:
        self.channel, self.started = channel, started

    def set_volume(self, *sides: float) -> None:
        self.channel.set_volume(*sides)

    def play(self, sound: pygame.mixer.Sound) -> None:
        self.started.append(sound)
        self.channel.play(sound)


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> Started:
    """What the device was given: most sounds last for less than 0.1 s, and may be over before a test asks for them."""
    given: Started = []
    find = pygame.mixer.find_channel

    def watched() -> Watched | None:
        channel: pygame.mixer.Channel | None = find()
        return None if channel is None else Watched(channel, given)

    monkeypatch.setattr(pygame.mixer, "find_channel", watched)
    return given


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def sounds(clock: Clock) -> Iterator[Sounds]:
    made = ready(clock)
    yield made
    made.close()


def test_panning_keeps_the_power() -> None:
    for part in (-1.0, 0.0, 0.2, 0.5, 0.9, 1.0, 2.0):
        left, right = pan(part)
        assert math.hypot(left, right) == pytest.approx(1.0)
    assert pan(0.5) == pytest.approx((math.sqrt(0.5), math.sqrt(0.5)))
    assert pan(0.0) == pytest.approx(tuple(reversed(pan(1.0))))
    assert pan(0.0)[0] > pan(0.3)[0] > pan(0.5)[0] > pan(1.0)[0] > 0.0


@pytest.mark.parametrize("kind", synth.KINDS)
def test_a_harder_contact_is_louder_up_to_a_limit(kind: SoundKind) -> None:
    steps = [loudness(Impact(kind, speed, 0.0)) for speed in (0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)]
    assert steps == sorted(steps)
    assert steps[0] == 0.0
    assert 0.0 < steps[-2] == steps[-1] < 1.0


@pytest.mark.parametrize("x", [0.0, 0.5, 1.0])
def test_what_comes_out_is_on_its_side_and_has_the_same_power(
    x: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, clock: Clock
) -> None:
    out = tmp_path / "out.raw"
    monkeypatch.setenv("SDL_AUDIODRIVER", "disk")
    monkeypatch.setenv("SDL_DISKAUDIOFILE", str(out))
    monkeypatch.setenv("SDL_DISKAUDIODELAY", "1")
    sounds = ready(clock)
    sounds.play([LOUD._replace(x=x)])
    while playing():
        time.sleep(0.01)
    sounds.close()
    left, right = (np.fromfile(out, np.int16).reshape(-1, 2) / 32768.0).T
    ratio = np.abs(left).max() / np.abs(right).max()
    assert ratio == pytest.approx(pan(x)[0] / pan(x)[1], rel=0.02)
    assert math.hypot(np.abs(left).max(), np.abs(right).max()) == pytest.approx(loudness(LOUD), rel=0.02)


def test_a_few_may_start_at_once_and_the_loudest_win(sounds: Sounds, clock: Clock, started: Started) -> None:
    sounds.play([SOFT, LOUD] * 10)
    assert len(started) == 6
    assert all(sound.get_length() < 0.1 for sound in started)
    clock.now = 0.02
    sounds.play([LOUD])
    assert len(started) == 6
    clock.now = 0.04
    sounds.play([LOUD] * 2)
    assert len(started) == 8


def test_a_break_played_fast_stays_within_the_limit(sounds: Sounds, clock: Clock, started: Started) -> None:
    table = load_table("pool-9ft")
    rollout = simulate(table, table.rack("eight-ball", 3), Shot(speed=9.0))
    sounds.play_events(table, rollout, -1.0, 0.0)
    assert len(started) == 1
    clock.now = 1.0
    sounds.play_events(table, rollout, 0.0, 0.9)
    assert 2 <= len(started) <= 7


def test_time_that_runs_backward_is_silent(sounds: Sounds, started: Started) -> None:
    table = load_table("pool-9ft")
    rollout = simulate(table, table.rack("eight-ball", 3), Shot(speed=9.0))
    sounds.play_events(table, rollout, 0.9, 0.0)
    assert not started


def test_the_same_knock_is_not_always_the_same_sound(sounds: Sounds, clock: Clock, started: Started) -> None:
    for _ in range(40):
        clock.now += 1.0
        sounds.play([LOUD])
        pygame.mixer.stop()
    assert len(started) == 40
    assert len(set(map(id, started))) == synth.KINDS["ball"].variants


def test_mute_silences_at_once_and_until_it_is_taken_back(sounds: Sounds, started: Started) -> None:
    sounds.play([LOUD])
    assert len(started) == 1
    sounds.mute(True)
    assert not playing()
    sounds.play([LOUD])
    sounds.chalk()
    assert len(started) == 1
    sounds.mute(False)
    sounds.chalk()
    assert len(started) == 2


def test_no_volume_is_silence(sounds: Sounds, started: Started) -> None:
    sounds.volume = 0.0
    sounds.play([LOUD])
    sounds.click()
    assert not started


def test_what_cannot_be_heard_is_not_played(sounds: Sounds, started: Started) -> None:
    sounds.play([Impact("ball", 0.0, 0.5), Impact("ball", 0.005, 0.5)])
    assert not started


def test_before_it_is_prepared_all_is_silent() -> None:
    sounds = Sounds()
    sounds.play([LOUD])
    sounds.click()
    sounds.chalk()
    sounds.mute(True)
    sounds.close()
    assert pygame.mixer.get_init() is None


def test_a_device_that_does_not_open_is_silence(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "bogus")
    sounds = Sounds()
    assert not sounds.prepare()
    assert not sounds.prepare()
    sounds.play([LOUD])
    sounds.close()
    os.write(2, b"still there")
    assert capfd.readouterr() == ("", "still there")


def test_a_pygame_without_a_mixer_is_silence(monkeypatch: pytest.MonkeyPatch) -> None:
    class Missing:
        def __getattr__(self, name: str) -> None:
            raise NotImplementedError(name)

    monkeypatch.setattr(pygame, "mixer", Missing())
    sounds = Sounds()
    assert not sounds.prepare()
    sounds.play([LOUD])
    sounds.mute(True)
    sounds.close()


@pytest.mark.parametrize("driver", [None, "alsa", "pulseaudio", "bogus"])
def test_without_a_device_the_game_says_nothing(driver: str | None) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "SDL_AUDIODRIVER"}
    environment |= {"SDL_VIDEODRIVER": "dummy", **({"SDL_AUDIODRIVER": driver} if driver else {})}
    done = subprocess.run(
        [sys.executable, "main.py", "--frames", "5"], cwd=ROOT, env=environment, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_the_window_opens_the_device_after_its_first_frame_and_closes_it(hand: Hand) -> None:
    hand.app.run(frames=1)
    assert pygame.mixer.get_init() is None
    hand.app.run(frames=2)
    assert pygame.mixer.get_init() == (synth.RATE, -16, 2)
    hand.app.close()
    assert pygame.mixer.get_init() is None


def test_a_stroke_is_heard_at_once_and_m_mutes(hand: Hand, monkeypatch: pytest.MonkeyPatch, started: Started) -> None:
    played: list[Impact] = []
    play = hand.app.sounds.play

    def spy(sounds: list[Impact], length: float = 1.0) -> None:
        played.extend(sounds)
        play(sounds, length)

    monkeypatch.setattr(hand.app.sounds, "play", spy)
    while hand.app.sounds.prepare():
        pass
    hand.point(1.905, 0.635)
    hand.key(pygame.K_SPACE)
    for _ in range(16):
        # The cue comes forward first.
        hand.app.step(FRAME)
    # The butt is over the rail, so the ball hops a little.
    assert [sound.kind for sound in played] == ["cue", *["slate"] * (len(played) - 1)]
    heard = len(started)
    assert heard == len(played)
    hand.key(pygame.K_m)
    assert hand.app.toasts.notes[-1].words.startswith("Sound is off")
    assert not playing()
    hand.wait_for_rest()
    assert len(played) > heard == len(started)
    hand.key(pygame.K_m)
    assert hand.app.toasts.notes[-1].words == "Sound is on."
    assert len(started) == heard + 1


def test_after_a_miscue_the_tip_is_chalked(hand: Hand, started: Started) -> None:
    while hand.app.sounds.prepare():
        pass
    hand.play.state.hands.nudge_tip(0.9, 0.0)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.messages.text.startswith("Miscue")
    started.clear()
    hand.key(pygame.K_SPACE)
    assert len(started) == 1


def test_skipping_to_the_end_is_silent(hand: Hand, started: Started) -> None:
    while hand.app.sounds.prepare():
        pass
    hand.key(pygame.K_SPACE)
    started.clear()
    hand.key(pygame.K_SPACE)
    assert hand.play.state.rollout is None
    assert not started
