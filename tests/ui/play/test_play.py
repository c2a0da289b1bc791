"""The game played by posted events, as a person would play it."""

from __future__ import annotations

import math

import pygame
import pytest

from pool2d import Ball
from pool2d.physics.values import POCKETED
from pool2d.ui.play import play_view
from pool2d.ui.play.play_view import hop_note
from pool2d.ui.stage import bars
from pool2d.ui.wording.words import Words

from ..conftest import Hand

CUE = Ball("cue", 0.635, 0.635)


def test_a_shot_with_the_mouse_and_then_another(hand: Hand) -> None:
    session = hand.play.state.session
    hand.point(1.905, 0.635)
    assert math.remainder(hand.play.state.hands.aim.angle, 360.0) == pytest.approx(0.0, abs=0.1)
    hand.press()
    hand.pull(200)
    hand.release()
    assert session.strokes == 1
    assert hand.play.state.rollout is not None
    hand.wait_for_rest()
    assert session.layout["1"] != session.table.rack("eight-ball", 3)["1"]
    if session.in_hand:
        hand.point(0.4, 0.4)
        hand.press()
        hand.release()
    hand.point(2.0, 0.9)
    hand.press()
    hand.pull(120)
    hand.release()
    assert session.strokes == 2


def test_what_is_shown_is_what_was_computed(hand: Hand) -> None:
    hand.point(1.905, 0.635)
    hand.key(pygame.K_SPACE)
    rollout = hand.play.state.rollout
    assert rollout is not None
    assert rollout is hand.play.state.session.rollout
    hand.wait_for_rest()
    assert hand.play.state.session.layout == rollout.layout()


def test_the_pull_freezes_the_aim_and_its_length_is_the_speed(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    aim = hand.play.state.hands.aim
    hand.press()
    hand.pull(60)
    weak = hand.play.state.hands.pulled
    hand.pull(60)
    assert hand.play.state.hands.aim == aim
    assert hand.play.state.hands.pulled > 1.9 * weak
    hand.release()
    rollout = hand.play.state.rollout
    assert rollout is not None
    struck = rollout.events[0].after["cue"]
    assert math.degrees(math.atan2(struck.vy, struck.vx)) == pytest.approx(aim.angle, abs=1e-6)


@pytest.mark.parametrize("way", ["ease", "right click", "escape"])
def test_a_stroke_can_be_put_down(hand: Hand, way: str) -> None:
    hand.point(1.905, 0.635)
    hand.press()
    start = hand.at
    hand.pull(150)
    if way == "ease":
        hand.move(start)
    elif way == "right click":
        hand.press(3)
    else:
        hand.key(pygame.K_ESCAPE)
    hand.release()
    assert hand.play.state.rollout is None
    assert hand.play.state.session.strokes == 0


def test_a_click_is_not_a_shot(hand: Hand) -> None:
    hand.point(1.905, 0.635)
    hand.press()
    hand.release()
    assert hand.play.state.session.strokes == 0


@pytest.mark.parametrize(("mod", "step"), [(0, 0.05), (pygame.KMOD_SHIFT, 0.01), (pygame.KMOD_CTRL, 1.0)])
def test_fine_aim_by_keys(hand: Hand, mod: int, step: float) -> None:
    hand.point(1.7, 0.9)
    angle = hand.play.state.hands.aim.angle
    hand.key(pygame.K_LEFT, mod)
    assert hand.play.state.hands.aim.angle == pytest.approx(angle + step)
    hand.key(pygame.K_RIGHT, mod)
    hand.key(pygame.K_RIGHT, mod)
    assert hand.play.state.hands.aim.angle == pytest.approx(angle - step)


def test_fine_aim_by_wheel_outlasts_a_trembling_hand(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    angle = hand.play.state.hands.aim.angle
    hand.wheel(2)
    assert hand.play.state.hands.aim.angle == pytest.approx(angle + 0.1)
    hand.move((hand.at[0] + 3, hand.at[1] - 2))
    assert hand.play.state.hands.aim.angle == pytest.approx(angle + 0.1)
    hand.move((hand.at[0] + 30, hand.at[1]))
    x, y = hand.play.stage.view.to_table(*hand.at)
    through = math.degrees(math.atan2(y - CUE.y, x - CUE.x))
    assert hand.play.state.hands.aim.angle == pytest.approx(through)


def test_the_aim_does_not_run_away_on_the_ball_itself(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    angle = hand.play.state.hands.aim.angle
    hand.point(CUE.x - 0.01, CUE.y - 0.01)
    assert hand.play.state.hands.aim.angle == angle


def test_power_and_strike_by_key(hand: Hand) -> None:
    hand.point(1.7, 0.3)
    for _ in range(4):
        hand.key(pygame.K_UP)
    hand.key(pygame.K_DOWN)
    assert hand.play.state.hands.aim.speed == pytest.approx(3.75)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.session.strokes == 1
    hand.key(pygame.K_SPACE)
    assert hand.play.state.rollout is None, "Space skips to rest"


def test_spin_by_keys_and_by_the_ball_diagram(hand: Hand) -> None:
    for key in (pygame.K_w, pygame.K_w, pygame.K_d):
        hand.key(key)
    assert (hand.play.state.hands.aim.side, hand.play.state.hands.aim.height) == pytest.approx((0.05, 0.1))
    box = hand.play.stage.screen.ball_diagram
    hand.move((box.centerx - box.width // 8, box.centery + box.height // 4))
    hand.press()
    hand.release()
    assert (hand.play.state.hands.aim.side, hand.play.state.hands.aim.height) == pytest.approx((-0.25, -0.5), abs=0.02)
    hand.key(pygame.K_BACKSPACE)
    assert (hand.play.state.hands.aim.side, hand.play.state.hands.aim.height) == (0.0, 0.0)


def test_elevation_by_keys_and_by_the_cue_diagram(hand: Hand) -> None:
    for _ in range(5):
        hand.key(pygame.K_e)
    hand.key(pygame.K_q)
    assert hand.play.state.hands.aim.elevation == 4.0
    ball = hand.play.stage.screen.cue_ball_centre
    hand.move((ball[0] - 40, ball[1] - 40))
    hand.press()
    hand.release()
    assert hand.play.state.hands.aim.elevation == pytest.approx(45.0, abs=2.0)
    assert hand.play.state.session.strokes == 0


def test_dragging_a_diagram_leaves_the_aim_alone(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    hand.move(hand.play.stage.screen.ball_diagram.center)
    angle = hand.play.state.hands.aim.angle
    hand.press()
    hand.move((hand.at[0] + 10, hand.at[1] - 300))
    assert hand.play.state.hands.aim.angle == angle
    hand.release()


def test_a_miscue_is_told(hand: Hand) -> None:
    for _ in range(13):
        hand.key(pygame.K_d)
    hand.point(1.7, 0.3)
    hand.key(pygame.K_SPACE)
    assert "Miscue" in hand.play.state.messages.text


def test_a_scratch_puts_the_cue_ball_in_hand(hand: Hand) -> None:
    hand.set_balls(Ball("cue", 0.2, 0.2), Ball("1", 1.0, 1.0))
    hand.point(0.0, 0.0)
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    session = hand.play.state.session
    assert session.in_hand
    assert session.cue.phase == POCKETED
    assert "Scratch" in hand.play.state.messages.text
    one = session.layout["1"]
    for place in ((one.x + 0.01, one.y), (0.005, 0.6), (3.0, 0.5)):
        hand.point(*place)
        hand.press()
        hand.release()
        assert session.in_hand
        assert "no room" in hand.play.state.messages.text
    hand.point(0.5, 0.4)
    hand.press()
    hand.release()
    assert not session.in_hand
    assert (session.cue.x, session.cue.y) == pytest.approx((0.5, 0.4), abs=0.002)
    assert session.strokes == 1, "placing is not striking"


def test_a_ball_in_hand_by_keyboard_alone(hand: Hand) -> None:
    hand.set_balls(CUE._replace(phase=POCKETED), in_hand=True)
    hand.key(pygame.K_RIGHT)
    hand.key(pygame.K_UP, pygame.KMOD_CTRL)
    hand.key(pygame.K_SPACE)
    assert not hand.play.state.session.in_hand
    cue = hand.play.state.session.cue
    assert (cue.x, cue.y) == pytest.approx((0.645, 0.835))


def test_undo_goes_back_to_before_the_shot(hand: Hand) -> None:
    before = hand.play.state.session.layout
    hand.point(1.905, 0.635)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_z, pygame.KMOD_CTRL)
    assert hand.play.state.rollout is None
    assert hand.play.state.session.layout == before
    hand.key(pygame.K_u)
    assert "nothing" in hand.play.state.messages.text


def test_a_new_rack_can_be_taken_back(hand: Hand) -> None:
    before = hand.play.state.session.layout
    hand.key(pygame.K_n)
    assert hand.play.state.session.layout != before
    hand.key(pygame.K_u)
    assert hand.play.state.session.layout == before


def test_fast_forward_while_tab_is_held(hand: Hand) -> None:
    hand.point(1.7, 0.3)
    hand.key(pygame.K_SPACE)
    start = hand.time
    hand.post(pygame.KEYDOWN, key=pygame.K_TAB, mod=0, unicode="")
    fast = hand.time - start
    hand.post(pygame.KEYUP, key=pygame.K_TAB, mod=0)
    slow = hand.time - start - fast
    assert fast == pytest.approx(8.0 * slow)


def test_replay_shows_the_last_shot_and_changes_nothing(hand: Hand) -> None:
    hand.key(pygame.K_r)
    assert hand.play.state.rollout is None
    hand.point(1.905, 0.635)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    after = hand.play.state.session.layout
    hand.key(pygame.K_r)
    assert hand.play.state.rollout is hand.play.state.session.rollout
    hand.wait_for_rest()
    assert hand.play.state.session.layout == after


def test_a_steep_hard_stroke_tells_of_the_hop(hand: Hand) -> None:
    hand.point(1.905, 0.635)
    for _ in range(30):
        hand.key(pygame.K_e)
    assert "hop" in hop_note(hand.play.state, 8.0)
    assert hop_note(hand.play.state, 0.5) == ""


def test_losing_the_window_puts_the_cue_down(hand: Hand) -> None:
    hand.point(1.905, 0.635)
    hand.press()
    hand.pull(150)
    hand.post(pygame.WINDOWFOCUSLOST)
    hand.release()
    assert hand.play.state.session.strokes == 0


def test_a_direction_just_below_a_full_turn_is_told_as_none() -> None:
    assert [bars.bearing(Words(), angle) for angle in (0.0, 359.994, 359.996)] == ["0.00°", "359.99°", "0.00°"]


def test_the_bars_tell_the_present_while_a_shot_runs(hand: Hand) -> None:
    hand.set_balls(Ball("cue", 2.0, 0.73), Ball("1", 2.3, 1.03), Ball("2", 2.0, 0.3))
    one = hand.play.state.session.layout["1"]
    hand.point(one.x, one.y)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(4.0)
    hand.key(pygame.K_SPACE)
    screen, trays = hand.play.stage.screen, set()
    while hand.play.state.playback is not None and hand.play.state.playback.running:
        fresh = hand.app.window.surface.copy()
        play_view._bars(fresh, hand.play.state, hand.play.controller)
        for bar in (screen.top, screen.bottom):
            shown, drawn = (picture.subsurface(bar) for picture in (hand.app.window.surface, fresh))
            assert pygame.image.tobytes(shown, "RGB") == pygame.image.tobytes(drawn, "RGB")
        trays.add(hand.play.state.gone)
        hand.app.step(0.1)
    assert len(trays) == 2, "a ball falls on the way"
