"""What the guide works out, and when: not at all when it is off, and anew only for another shot."""

from __future__ import annotations

from typing import Any

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.draw import guide
from pool2d.ui.play.foresight import Foresight
from pool2d.ui.stage.stage import Stage

from ..conftest import Hand

TABLE = load_table("pool-9ft")
SHOT = Shot(angle=4.0, speed=4.0)


def layout(x: float = 1.4) -> Layout:
    return Layout([Ball("cue", 0.6, 0.6), Ball("1", x, 0.65)])


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many shots have been simulated to be foreseen, one entry for each."""
    real, count = simulate, list[int]()

    def counting(*given: Any, **more: Any) -> object:
        count.append(1)
        return real(*given, **more)

    monkeypatch.setattr("pool2d.ui.play.foresight.simulate", counting)
    return count


def test_a_guide_that_is_off_is_not_worked_out(two: Hand, counted: list[int]) -> None:
    two.play.state.show.level = guide.NONE
    for pixel in range(5):
        two.move((700 + 10 * pixel, 300))
    assert not counted
    two.play.state.show.level = guide.LINE
    two.move((600, 300))
    assert counted


def test_the_softest_stroke_has_its_guide_and_a_cue_that_is_not_drawn_back_none(
    two: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[float] = []
    monkeypatch.setattr(two.play.stage, "guide", lambda surface, level, rollout, struck: drawn.append(level))
    for _ in range(40):
        two.key(pygame.K_DOWN)
    drawn.clear()
    two.key(pygame.K_LEFT)
    assert two.play.state.hands.speed < 0.5 and drawn
    two.press()
    drawn.clear()
    two.app.redraw()
    two.app.step(0.0)
    assert two.play.state.hands.speed == 0.0 and not drawn


def test_the_same_shot_is_worked_out_once(counted: list[int]) -> None:
    foresight = Foresight()
    first = foresight.rollout(TABLE, guide.GHOST, layout(), SHOT)
    # Balls that lie alike are the same balls, whatever holds them.
    assert foresight.rollout(TABLE, guide.GHOST, layout(), SHOT) is first and len(counted) == 1
    assert foresight.rollout(TABLE, guide.LINE, layout(), SHOT) is first


def test_no_more_of_a_shot_is_worked_out_than_is_shown(counted: list[int]) -> None:
    foresight = Foresight()
    seen = [
        len(roll.events)
        for level in (guide.NONE, guide.LINE, guide.GHOST, guide.WHOLE)
        if (roll := foresight.rollout(TABLE, level, layout(), SHOT))
    ]
    # The stroke and the contact; what both balls meet next; all of it.
    assert seen[0] == seen[1] == 2 < seen[2] < seen[3]
    # What sees farther serves for less.
    assert len(counted) == 3
    assert foresight.first_hit(TABLE, guide.NONE, layout(), SHOT) == "1" and len(counted) == 3


def test_the_cue_drawn_back_with_a_pocket_called_takes_one_shot_a_frame(two: Hand, counted: list[int]) -> None:
    two.play.state.calls.pocket = two.play.state.session.table.geometry.pockets[0].name
    two.point(1.2, 0.6)
    two.press()
    two.pull(60.0)
    counted.clear()
    for frame in range(1, 4):
        two.pull(20.0)
        assert two.play.state.hands.speed > 0.0
        assert len(counted) == frame


def test_other_balls_in_the_place_of_those_that_are_gone_are_foreseen_anew() -> None:
    foresight = Foresight()
    for x in (1.4, 1.5, 1.6, 1.7, 1.8) * 20:
        # Each of these goes as soon as it has been used, and the next may take its place in memory.
        rollout = foresight.rollout(TABLE, guide.GHOST, layout(x), SHOT)
        assert rollout is not None and rollout.start["1"].x == x


def test_another_table_is_foreseen_anew() -> None:
    foresight = Foresight()
    first = foresight.rollout(TABLE, guide.GHOST, layout(), SHOT)
    other = TABLE.with_knobs({"cloth.mu_roll": 0.02})
    assert foresight.rollout(other, guide.GHOST, layout(), SHOT) is not first


def test_the_whole_guide_sees_farther_than_the_short_one() -> None:
    foresight = Foresight()
    balls = TABLE.rack("eight-ball", seed=3)
    shot = Shot(angle=0.0, speed=8.0)
    short = foresight.rollout(TABLE, guide.GHOST, balls, shot)
    whole = foresight.rollout(TABLE, guide.WHOLE, balls, shot)
    assert short is not None and whole is not None
    assert len(short.events) == guide.EVENTS < len(whole.events)
    surface = pygame.Surface((1280, 720))
    Stage(TABLE).guide(surface, guide.WHOLE, whole, shot.ball)
    assert foresight.rollout(TABLE, guide.WHOLE, balls, shot) is whole
