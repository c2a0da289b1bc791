"""The window: sizes, help, pictures, quitting."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pygame
import pytest

from pool2d import Shot, __version__, load_table
from pool2d.compiled import engine
from pool2d.config.settings import Store
from pool2d.draw import text, theme
from pool2d.game.aim import Aim
from pool2d.game.records.record import load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import unfinished
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.ui.app import App
from pool2d.ui.dialogs.help import Help, hands, keys
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.screen import Screen
from pool2d.ui.stage import bars
from pool2d.ui.wording.keys import CTRL, DEFAULTS, Keymap
from pool2d.ui.wording.words import Words

from .conftest import FRAME, Hand

ROOT = Path(__file__).parents[2]


def test_the_command_runs_its_frames_and_ends() -> None:
    environment = {**os.environ, "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
    done = subprocess.run(
        [sys.executable, "main.py", "--frames", "5"], cwd=ROOT, env=environment, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("driver", ["x11", "bogus"])
def test_without_a_display_it_says_so_in_one_line(driver: str) -> None:
    environment = {**os.environ, "SDL_VIDEODRIVER": driver, "DISPLAY": ":999"}
    done = subprocess.run([sys.executable, "main.py"], cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 2
    assert "display: no window can be opened" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080), (800, 1000), (320, 200)])
def test_the_table_is_to_scale_and_inside_the_window(hand: Hand, size: tuple[int, int]) -> None:
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.step(0.0)
    view = hand.play.stage.view
    left, bottom = view.to_screen(0.0, 0.0)
    right, top = view.to_screen(2.54, 1.27)
    assert (right - left) == pytest.approx(2.0 * (bottom - top))
    screen = hand.play.stage.screen
    assert 0 <= left < right <= size[0]
    assert screen.top.bottom <= top < bottom <= screen.bottom.top


@pytest.mark.parametrize(
    "size", [(960, 540), (1280, 720), (1920, 1080), (3840, 2160), (640, 360), (320, 200), (200, 800), (90, 60)]
)
def test_every_control_is_inside_the_window_and_apart(size: tuple[int, int]) -> None:
    screen = Screen(*size)
    window = pygame.Rect(0, 0, *size)
    boxes = [screen.ball_diagram, screen.cue_diagram, screen.power, screen.message]
    assert all(window.contains(box) for box in boxes)
    assert all(not a.colliderect(b) for i, a in enumerate(boxes) for b in boxes[:i])
    assert screen.message.width >= 30 * screen.unit


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
def test_a_long_message_is_wrapped_into_its_room(hand: Hand, size: tuple[int, int]) -> None:
    screen = Screen(*size)
    message = "assets/tables/pool-9ft.toml: cloth.mu_slide = 'fast': allowed is a number from 0.01 to 1; this is long"
    lines = text.wrap(message, screen.small, screen.message.width)
    assert " ".join(lines) == message
    assert all(text.font(screen.small).size(line)[0] <= screen.message.width for line in lines)
    assert len(lines) * text.font(screen.small).get_linesize() <= screen.message.height


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
def test_the_butt_in_the_cue_diagram_leaves_its_figure_free(size: tuple[int, int]) -> None:
    """Raised by some 30 degrees, as over a rail, it lay upon it."""
    screen, words = Screen(*size), Words()
    surface = pygame.Surface(size)
    for elevation in range(2, 81):
        surface.fill((0, 0, 0))
        bars.draw_controls(surface, words, screen, Aim(elevation=float(elevation)), 3.0, 0.6)
        figure = pygame.Rect(screen.cue_diagram.topleft, text.font(screen.small).size(f"{elevation}\N{DEGREE SIGN}"))
        shaft = (pygame.surfarray.array3d(surface.subsurface(figure)) == theme.CUE_SHAFT[:3]).all(axis=2)
        assert not shaft.any(), elevation


def test_a_word_wider_than_the_room_is_broken() -> None:
    pygame.font.init()
    lines = text.wrap("x" * 200, 14, 300)
    assert "".join(lines) == "x" * 200
    assert all(text.font(14).size(line)[0] <= 300 for line in lines)


def test_a_window_at_rest_waits_and_takes_what_it_waited_for(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    while hand.app.sounds.prepare():
        pass
    angle = hand.play.state.hands.aim.angle
    waits = iter([
        pygame.event.Event(pygame.NOEVENT),
        pygame.event.Event(pygame.KEYDOWN, key=pygame.K_LEFT, mod=0, unicode=""),
        pygame.event.Event(pygame.QUIT),
    ])  # fmt: skip
    hand.app.step(0.0)
    frames: list[pygame.Surface] = []
    monkeypatch.setattr(hand.play, "draw", frames.append)
    monkeypatch.setattr(pygame.event, "wait", lambda timeout: next(waits))
    hand.app.run()
    assert hand.play.state.hands.aim.angle == pytest.approx((angle + 0.05) % 360.0)
    assert len(frames) == 1, "one for the key: the first was drawn before, and nothing else has happened"


def test_a_window_where_balls_run_does_not_wait(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    hand.key(pygame.K_SPACE)

    def fail(timeout: int) -> None:
        raise AssertionError("waited")

    monkeypatch.setattr(pygame.event, "wait", fail)
    steps = iter([True] * 5 + [False])
    step = hand.app.step
    monkeypatch.setattr(hand.app, "step", lambda dt: step(dt) and next(steps))
    hand.app.run()
    assert hand.play.state.playback is not None


def test_full_screen_and_back(hand: Hand) -> None:
    hand.key(pygame.K_F11)
    assert hand.app.window.surface.get_flags() & pygame.FULLSCREEN
    hand.key(pygame.K_F11)
    assert not hand.app.window.surface.get_flags() & pygame.FULLSCREEN
    assert hand.app.window.surface.get_size() == (1280, 720)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
def test_help_lists_every_binding_and_closes(
    hand: Hand, size: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: dict[str, pygame.Rect] = {}
    real = text.draw

    def spy(surface: pygame.Surface, words: str, *rest: object) -> pygame.Rect:
        drawn[words] = real(surface, words, *rest)  # type: ignore[arg-type]
        return drawn[words]

    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.key(pygame.K_F1)
    assert isinstance(hand.app.scene, Help)
    monkeypatch.setattr(text, "draw", spy)
    hand.app.redraw()
    hand.app.step(0.0)
    assert len(keys(hand.app.words)) >= 15
    for name, does in hands(hand.app.words) + keys(hand.app.words):
        assert name in drawn and does in drawn
    runs = hand.app.words.say(f"help.{engine()}", version=__version__)
    assert any(line.startswith("pool2d") and runs.startswith(line.rstrip("…")) for line in drawn)
    window = pygame.Rect(0, 0, *size)
    assert all(window.contains(place) for place in drawn.values())
    hand.key(pygame.K_ESCAPE)
    assert not isinstance(hand.app.scene, Help)


def test_every_action_that_a_key_is_bound_to_does_something(hand: Hand) -> None:
    window = {"fullscreen", "screenshot", "mute", "options", "drills", "help", "quit"}
    drills = {"next_drill", "solution"}
    turns = {"turn_left", "turn_right"}
    assert set(DEFAULTS) == window | turns | drills | {"call", "call_ball"} | set(hand.play.controller._keys)


def test_no_two_actions_share_a_key() -> None:
    chords = [chord for chords in DEFAULTS.values() for chord in chords]
    assert len(chords) == len(set(chords))
    assert CTRL + pygame.K_q in chords
    action_of = Keymap().action_of
    assert action_of(pygame.K_q, pygame.KMOD_CTRL) == "quit"
    assert action_of(pygame.K_q, 0) == "lower"
    assert action_of(pygame.K_LEFT, pygame.KMOD_CTRL) == "turn_left"


def test_quitting(hand: Hand) -> None:
    hand.key(pygame.K_q, pygame.KMOD_CTRL)
    assert not hand.open


def toasted(hand: Hand) -> str:
    return " / ".join(note.words for note in hand.app.toasts.notes)


def test_a_screenshot_is_a_picture_of_the_window(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_PICTURES", str(tmp_path / "pictures"))
    hand.key(pygame.K_F12)
    hand.key(pygame.K_F12)
    saved = sorted((tmp_path / "pictures").glob("pool2d-*.png"))
    assert len(saved) == 2
    for picture in saved:
        assert pygame.image.load(picture).get_size() == (1280, 720)
        assert str(picture) in toasted(hand)


def test_a_key_that_is_held_does_once_what_is_done_once(
    hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("POOL2D_PICTURES", str(tmp_path))
    for _ in range(5):
        hand.post(pygame.KEYDOWN, key=pygame.K_F12, mod=0, unicode="")
    assert len(list(tmp_path.glob("*.png"))) == 1
    hand.post(pygame.KEYUP, key=pygame.K_F12, mod=0)
    hand.post(pygame.KEYDOWN, key=pygame.K_F12, mod=0, unicode="")
    assert len(list(tmp_path.glob("*.png"))) == 2


def test_a_key_that_is_held_goes_on_turning_the_aim(hand: Hand) -> None:
    angle = hand.play.state.hands.aim.angle
    for _ in range(5):
        hand.post(pygame.KEYDOWN, key=pygame.K_LEFT, mod=0, unicode="")
    assert hand.play.state.hands.aim.angle == pytest.approx(angle + 0.25)


def test_a_screenshot_that_a_full_disk_takes_in_part_is_told(
    hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("POOL2D_PICTURES", str(tmp_path / "pictures"))

    def full(file: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("pool2d.config.files.os.fsync", full)
    hand.key(pygame.K_F12)
    assert "No space left on device" in toasted(hand)
    assert list((tmp_path / "pictures").iterdir()) == []


def test_a_screenshot_that_cannot_be_saved_is_told(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("POOL2D_PICTURES", str(tmp_path / "file"))
    hand.key(pygame.K_F12)
    assert "could not be saved" in toasted(hand)
    assert hand.app.toasts.notes[0].wrong


def test_a_missing_font_is_replaced(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    pygame.font.init()
    text.font.cache_clear()
    # What cannot be read is told by every window from then on.
    monkeypatch.setattr(text, "unreadable", set())
    monkeypatch.setattr(text, "asset", lambda *_: tmp_path / "none.ttf")
    assert text.font(17).size("pool")[0] > 0
    text.font.cache_clear()


def test_the_window_is_named_after_the_table_that_is_played_on(hand: Hand) -> None:
    assert pygame.display.get_caption()[0] == "pool2d \N{EN DASH} " + hand.play.state.session.table.title
    hand.play.state.open_table("snooker-12ft")
    hand.app.step(FRAME)
    assert pygame.display.get_caption()[0] == "pool2d \N{EN DASH} " + load_table("snooker-12ft").title


def test_the_window_is_named_after_the_table_of_a_replay(hand: Hand) -> None:
    session = recorded(load_table("snooker-12ft"), Setup("snooker", breaker=0))
    session.play(Shot(speed=2.0))
    session.leave()
    hand.app.scene = Replay(RecordedShots(load(unfinished()[0])), hand.app.words, hand.play)
    hand.app.step(FRAME)
    assert "Snooker" in pygame.display.get_caption()[0]
    hand.key(pygame.K_ESCAPE)
    assert "Snooker" not in pygame.display.get_caption()[0]


def test_names_among_the_settings_that_stand_for_nothing_are_told_and_dropped(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text('[balls]\npalette = "neon"\n[screen]\nlanguage = "xx"\n')
    app = App(load_table("pool-9ft"), seed=1, store=Store(path))
    try:
        told = " ".join(note.words for note in app.toasts.notes)
        assert "balls.palette = 'neon'" in told and "screen.language = 'xx'" in told
        assert (app.store.values.balls.palette, app.store.values.screen.language) == ("standard", "auto")
        assert "neon" in path.with_name("settings.toml.bad").read_text()
    finally:
        app.close()
