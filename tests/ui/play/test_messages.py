"""What the bars tell of a shot while it is seen: nothing that is yet to come."""

from __future__ import annotations

import pygame
import pytest

from pool2d import Ball
from pool2d.game.aim import Aim
from pool2d.ui.screen import Screen
from pool2d.ui.stage import bars
from pool2d.ui.wording.words import Words

from ..conftest import Hand


def test_what_a_shot_will_leave_is_not_told_before_it_is_seen(hand: Hand) -> None:
    hand.set_balls(Ball("cue", 0.6, 0.6), Ball("1", 0.3, 0.3), Ball("2", 2.0, 1.0))
    hand.point(0.3, 0.3)
    before = hand.play.state.titles[1]
    assert before.startswith("Shot 1") and before.endswith("2 balls left")
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.left == 1
    assert hand.play.state.titles[1] == before
    while not hand.play.state.gone:
        hand.app.step(1.0 / 60.0)
    assert hand.play.state.titles[1] == before.replace("2 balls", "1 ball")
    hand.wait_for_rest()
    assert hand.play.state.titles[1] == hand.play.state.titles[1].replace("Shot 1", "Shot 2")


def test_the_direction_stays_as_it_was_struck_while_the_shot_runs(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    hand.point(1.905, 0.635)
    told: list[tuple[float, float]] = []
    real = bars.draw_controls

    def draw(
        surface: pygame.Surface, words: Words, screen: Screen, aim: Aim, speed: float, tip_friction: float
    ) -> None:  # fmt: skip
        told.append((aim.angle, speed))
        real(surface, words, screen, aim, speed, tip_friction)

    monkeypatch.setattr(bars, "draw_controls", draw)
    hand.key(pygame.K_SPACE)
    del told[:]
    hand.point(0.3, 1.0)
    hand.app.redraw()
    hand.app.step(1.0 / 60.0)
    struck = hand.play.state.session.shot
    assert struck is not None and told
    assert {angle for angle, _ in told} == {struck.angle}
    assert hand.play.state.hands.aim.angle != struck.angle
