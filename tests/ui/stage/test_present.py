"""What is presented of a frame: all that has changed, and while a shot runs little more."""

from __future__ import annotations

import pygame
import pytest

from pool2d.ui.replay.replay_scene import Replay

from ..conftest import FRAME, Hand


class Monitor:
    """What a screen shows of the window: only what is presented to it. `share` is how much was, frame by frame."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, window: pygame.Surface) -> None:
        self.window, self.shown = window, window.copy()
        self.share: list[float] = []
        monkeypatch.setattr(pygame.display, "flip", lambda: self.show([window.get_rect()]))
        monkeypatch.setattr(pygame.display, "update", self.show)

    def show(self, boxes: list[pygame.Rect]) -> None:
        within = [box.clip(self.window.get_rect()) for box in boxes]
        self.shown.blits([(self.window, box.topleft, box) for box in within])
        self.share.append(sum(box.width * box.height for box in within) / self.window.width / self.window.height)

    @property
    def true(self) -> bool:
        return pygame.image.tobytes(self.shown, "RGB") == pygame.image.tobytes(self.window, "RGB")


@pytest.fixture
def monitor(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> Monitor:
    while not hand.play.stage.still:
        hand.app.step(FRAME)
    return Monitor(monkeypatch, hand.app.window.surface)


def test_a_running_shot_presents_little_and_all_that_has_changed(hand: Hand, monitor: Monitor) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(4.0)
    hand.key(pygame.K_SPACE)
    for number in range(150):
        # The bars tell of a note, the camera of a larger picture, a click of nothing.
        if number == 60:
            hand.key(pygame.K_m)
        if number == 90:
            hand.key(pygame.K_p)
            hand.key(pygame.K_p)
        hand.app.step(FRAME)
        assert monitor.true, number
    # The cue takes the whole window, and so does a note.
    assert min(monitor.share) < 0.15 and max(monitor.share) == 1.0
    assert sum(share < 0.3 for share in monitor.share) > 30


def test_no_more_is_presented_than_the_boxes_drawn(hand: Hand, monitor: Monitor) -> None:
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(6.0)
    hand.key(pygame.K_SPACE)
    for _ in range(40):
        hand.app.step(FRAME)
    for _ in range(20):
        hand.app.step(FRAME)
        frame = hand.app.window.frame
        assert frame.before and frame.over
        drawn = [box.clip(monitor.window.get_rect()) for box in [*frame.before, *frame.over]]
        area = sum(box.width * box.height for box in drawn) / monitor.window.width / monitor.window.height
        assert 0.0 < monitor.share[-1] <= area + 1e-9


@pytest.mark.parametrize("key", [pygame.K_v, pygame.K_b, pygame.K_t, pygame.K_PLUS])
def test_what_is_drawn_over_all_of_it_is_presented(hand: Hand, monitor: Monitor, key: int) -> None:
    hand.key(pygame.K_SPACE)
    for number in range(40):
        if number in (10, 25):
            hand.key(key)
        hand.app.step(FRAME)
        assert monitor.true, number


def test_a_replayed_record_presents_what_has_changed(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    from pool2d.game.records.record import load
    from pool2d.game.records.recorded_shots import RecordedShots
    from pool2d.game.records.recorder import records

    from ..at_match import begin

    begin(hand, "nine-ball")
    hand.strike()
    hand.play.state.session.leave()
    (path,) = records()
    viewer = Replay(RecordedShots(load(path, torn=True)), hand.app.words, hand.play)
    hand.app.scene = viewer
    monitor = Monitor(monkeypatch, hand.app.window.surface)
    for number in range(60):
        hand.app.step(FRAME)
        hand.app.redraw()
        assert monitor.true, number
    assert min(monitor.share) < 0.4
