"""A shot seen again: held, slowed, gone through by its time line, by mouse and by keyboard."""

from __future__ import annotations

import math

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.draw import text
from pool2d.ui.stage.playback import RATES, Playback
from pool2d.ui.wording import shot_text
from pool2d.ui.wording.words import Words

from ..conftest import FRAME, Hand

TABLE = load_table("pool-9ft")
CUT = Layout([Ball("cue", 0.635, 0.5), Ball("1", 1.5, 0.53)])
WORDS = Words()
ROLL = simulate(TABLE, CUT, Shot(angle=1.0, speed=3.0))


def played(hand: Hand) -> Playback:
    """A cut shot that has come to rest, seen again and held at its beginning."""
    hand.set_balls(*CUT.values())
    hand.point(1.5, 0.515)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.playback is None
    hand.key(pygame.K_p)
    return shown(hand)


def shown(hand: Hand) -> Playback:
    playback = hand.play.state.playback
    assert playback is not None
    return playback


def test_a_shot_that_runs_can_be_held_and_goes_on(hand: Hand) -> None:
    hand.point(1.7, 0.3)
    hand.key(pygame.K_SPACE)
    for _ in range(30):
        hand.app.step(FRAME)
    hand.key(pygame.K_p)
    at = hand.time
    assert at > 0.0
    for _ in range(10):
        hand.app.step(FRAME)
    assert hand.time == at
    hand.key(pygame.K_SPACE)
    assert hand.time == pytest.approx(at + 2 * FRAME)
    hand.key(pygame.K_ESCAPE)
    assert hand.play.state.playback is None
    assert hand.play.state.session.strokes == 1


def test_a_replay_left_alone_ends_by_itself_and_one_taken_hold_of_stays(hand: Hand) -> None:
    playback = played(hand)
    hand.key(pygame.K_SPACE)
    for _ in range(round(playback.rollout.duration / FRAME) + 30):
        hand.app.step(FRAME)
    assert hand.play.state.playback is playback
    assert playback.ended
    hand.key(pygame.K_SPACE)
    assert playback.time < 0.1, "from its end it runs again from the beginning"
    hand.key(pygame.K_RETURN)
    assert hand.play.state.playback is None
    hand.key(pygame.K_r)
    hand.wait_for_rest()


@pytest.mark.parametrize(
    ("slower", "faster"),
    [(pygame.K_COMMA, pygame.K_PERIOD), (pygame.K_LEFTBRACKET, pygame.K_RIGHTBRACKET)],
)
def test_the_rate_goes_from_an_eighth_to_eight_times(hand: Hand, slower: int, faster: int) -> None:
    playback = played(hand)
    for _ in range(10):
        hand.key(slower)
    assert playback.rate == RATES[0] == 1 / 8
    hand.key(pygame.K_HOME)
    playback.toggle()
    start = playback.time
    hand.app.step(0.08)
    assert playback.time - start == pytest.approx(0.01)
    for _ in range(10):
        hand.key(faster)
    assert playback.rate == RATES[-1] == 8.0


def test_steps_stop_at_every_event_and_no_further(hand: Hand) -> None:
    playback = played(hand)
    events = playback.rollout.events
    hand.key(pygame.K_HOME)
    assert playback.event is events[0]
    for event in events[1:]:
        hand.key(pygame.K_RIGHT)
        assert playback.event is event
        assert playback.time == event.t
    hand.key(pygame.K_RIGHT)
    assert playback.event is events[-1]
    hand.key(pygame.K_LEFT)
    assert playback.event is events[-2]
    hand.key(pygame.K_HOME)
    hand.key(pygame.K_LEFT)
    assert playback.event is events[0]
    hand.key(pygame.K_END)
    assert playback.time == playback.rollout.duration


def test_a_step_back_from_between_two_events_goes_to_the_earlier() -> None:
    playback = Playback(ROLL, None)
    playback.seek((ROLL.events[2].t + ROLL.events[3].t) / 2)
    playback.step(-1)
    assert playback.event is ROLL.events[2]
    playback.step(-1)
    assert playback.event is ROLL.events[1]


def test_events_at_the_same_moment_are_stepped_through_one_by_one() -> None:
    two = Layout([Ball("cue", 0.5, 0.3, vx=1.0), Ball("1", 0.5, 0.9, vx=1.0)])
    roll = simulate(TABLE, two)
    playback = Playback(roll, None)
    playback.seek(0.0)
    assert roll.events[0].t == roll.events[1].t
    seen = []
    for _ in roll.events:
        playback.step(1)
        seen.append(playback.event)
    assert seen == roll.events


def test_the_line_is_dragged_with_the_mouse(hand: Hand) -> None:
    playback = played(hand)
    line = hand.play.controller.timeline.track
    hand.move((line.left + line.width / 4, line.centery))
    hand.press()
    assert playback.time == pytest.approx(playback.rollout.duration / 4, rel=0.01)
    hand.move((line.left + line.width / 2, line.centery - 200))
    assert playback.time == pytest.approx(playback.rollout.duration / 2, rel=0.01)
    hand.release()
    hand.move((line.left, line.centery))
    assert playback.time == pytest.approx(playback.rollout.duration / 2, rel=0.01)
    hand.wheel(-1)
    assert playback.time == pytest.approx(playback.rollout.duration / 2 - 0.02, rel=0.01)


@pytest.mark.parametrize("way", ["the window is lost", "the time line is left"])
def test_a_drag_ends_with_what_it_was_on(hand: Hand, way: str) -> None:
    playback = played(hand)
    line = hand.play.controller.timeline.track
    hand.move(line.center)
    hand.press()
    if way == "the window is lost":
        hand.post(pygame.WINDOWFOCUSLOST)
    else:
        hand.key(pygame.K_ESCAPE)
        hand.key(pygame.K_p)
        playback = shown(hand)
    before = playback.time
    hand.move((line.left + 50, line.centery))
    assert playback.time == before


def test_every_button_does_what_its_key_does(hand: Hand) -> None:
    playback = played(hand)
    line = hand.play.controller.timeline

    def click(action: str) -> None:
        hand.move(line.button(action).center)
        hand.press()
        hand.release()

    click("end")
    assert playback.ended
    click("back")
    assert playback.event is playback.rollout.events[-2]
    click("begin")
    assert playback.time == 0.0
    click("forth")
    assert playback.event is playback.rollout.events[1]
    click("slower")
    assert playback.rate == 0.5
    click("faster")
    assert playback.rate == 1.0
    click("toggle")
    assert not playback.paused
    click("leave")
    assert hand.play.state.playback is None


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080), (640, 360)])
def test_the_time_line_stays_in_the_lower_bar(
    hand: Hand, size: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    playback = played(hand)
    line, bar = hand.play.controller.timeline, hand.play.stage.screen.bottom
    actions = ["begin", "back", "toggle", "forth", "end", "slower", "faster", "leave"]
    boxes = [line.track, *(line.button(action) for action in actions)]
    assert all(bar.contains(box) for box in boxes)
    assert all(not a.colliderect(b) for i, a in enumerate(boxes) for b in boxes[:i])
    drawn: list[pygame.Rect] = []
    real = text.draw

    def spy(surface: pygame.Surface, words: str, *rest: object) -> pygame.Rect:
        drawn.append(real(surface, words, *rest))  # type: ignore[arg-type]
        return drawn[-1]

    monkeypatch.setattr(text, "draw", spy)
    hand.move(line.button("forth").center)
    for _ in playback.rollout.events:
        hand.press()
        hand.release()
        drawn.clear()
        line.draw(hand.app.window.surface, playback, hand.play.state.session.table)
        assert len(drawn) == 6, "the rate, the clock, what the button does, the event with its numbers and balls"
        assert all(bar.contains(box) for box in drawn)
        assert all(not a.colliderect(b) for i, a in enumerate(drawn) for b in drawn[:i])


def test_the_mark_under_the_pointer_is_told_and_not_the_playhead(hand: Hand) -> None:
    playback = played(hand)
    line = hand.play.controller.timeline
    contact = next(event for event in playback.rollout.events if event.kind == "ball_ball")
    assert line.pointed(playback) is None
    hand.move((line.x_of(contact.t, playback), line.track.centery))
    assert line.pointed(playback) is contact


def test_looking_again_leaves_the_aim_and_the_game_alone(hand: Hand) -> None:
    playback = played(hand)
    aim, position = hand.play.state.hands.aim, hand.play.state.session.match.now
    hand.move((300, 300))
    hand.move(hand.play.controller.timeline.button("end").center)
    hand.wheel(1)
    hand.key(pygame.K_LEFT)
    hand.key(pygame.K_ESCAPE)
    assert hand.play.state.playback is None
    assert playback.rollout is position.rollout
    assert (hand.play.state.hands.aim, hand.play.state.session.match.now) == (aim, position)


def test_an_event_is_told_with_its_numbers() -> None:
    contact = next(event for event in ROLL.events if event.kind == "ball_ball")
    assert shot_text.title(WORDS, contact, "cue") == "Cue ball meets 1"
    throw = shot_text.throw(contact)
    assert throw is not None
    before, after = contact.before, contact.after
    line = math.degrees(math.atan2(0.53 - before["cue"].y, 1.5 - before["cue"].x))
    sent = math.degrees(math.atan2(after["1"].vy, after["1"].vx))
    assert throw == pytest.approx(sent - line)
    assert 0.2 < abs(throw) < 6.0
    kept = shot_text.energy_kept(contact, TABLE, CUT)
    assert kept is not None
    assert 0.8 < kept < 1.0
    told = shot_text.measures(WORDS, contact, TABLE, CUT)
    assert f"{contact.t:.3f} s" in told
    assert f"throw {abs(throw):.1f}" in told
    assert f"keeps {100 * kept:.0f} %" in told
    assert "0.00 to " in shot_text.change(WORDS, contact, "1", "cue")
    assert shot_text.throw(ROLL.events[0]) is None


def test_where_it_is_to_be_brief_nothing_is_told_of_side_that_there_is_none_of_and_zero_has_no_sign() -> None:
    """At 960 pixels a line has no room for two balls that fly, each with "side 0 to -0"."""
    plain = simulate(TABLE, CUT, Shot(0.0, 3.0), events=1).events[0]
    assert shot_text.change(WORDS, plain, "cue", "cue").endswith("roll 0 to 0, side 0 to 0 rad/s")
    assert shot_text.change(WORDS, plain, "cue", "cue", brief=True).endswith("roll 0 to 0 rad/s")
    spun = simulate(TABLE, CUT, Shot(0.0, 3.0, side=0.3), events=1).events[0]
    told = shot_text.change(WORDS, spun, "cue", "cue")
    assert told == shot_text.change(WORDS, spun, "cue", "cue", brief=True)
    assert f"side 0 to {spun.after['cue'].wz:.0f} rad/s" in told
    assert [WORDS.number(value, ".1f") for value in (-0.0, -0.04, -0.06, 0.0)] == ["0.0", "0.0", "-0.1", "0.0"]


def test_the_cue_ball_is_the_one_struck_whatever_its_name() -> None:
    contact = next(event for event in ROLL.events if event.kind == "ball_ball")
    assert shot_text.title(WORDS, contact, "1") == "Other cue ball meets cue ball"
    assert shot_text.change(WORDS, contact, "1", "1").startswith("Cue ball")


def test_balls_and_places_are_told_in_words_and_unknown_ones_as_they_are() -> None:
    assert shot_text.ball_name(WORDS, "red12", "cue") == "red 12"
    assert shot_text.ball_name(WORDS, "black", "cue") == "black"
    assert shot_text.ball_name(WORDS, "7", "cue") == "7"
    assert shot_text.ball_name(WORDS, "left2", "cue") == "left2"
    assert shot_text.place_name(WORDS, "bottom-left jaw") == "bottom left jaw"
    assert shot_text.place_name(WORDS, "nook-left") == "nook left"


def test_without_friction_nothing_is_thrown_and_the_energy_is_kept() -> None:
    smooth = TABLE.with_knobs({"ball.law": "frictionless", "ball.restitution": 1.0})
    contact = next(e for e in simulate(smooth, CUT, Shot(angle=1.0, speed=3.0)).events if e.kind == "ball_ball")
    assert shot_text.throw(contact) == pytest.approx(0.0, abs=1e-6)
    assert shot_text.energy_kept(contact, smooth, CUT) == pytest.approx(1.0)


def test_every_kind_of_event_has_a_title() -> None:
    rack = TABLE.rack("eight-ball", 3)
    events = simulate(TABLE, rack, Shot(angle=0.3, speed=9.0, side=0.3)).events
    titles = {event.kind: shot_text.title(WORDS, event, "cue") for event in events}
    assert {"cue_ball", "ball_ball", "ball_cushion", "ball_pocket", "cluster", "sliding_rolling"} <= set(titles)
    assert all("_" not in title for title in titles.values())


def test_a_short_shot_seen_again_stays_on_its_last_moment(two: Hand) -> None:
    two.play.state.hands.aim = two.play.state.hands.aim.with_speed(0.3)
    two.strike()
    two.key(pygame.K_r)
    for _ in range(400):
        two.app.step(FRAME)
    shown = two.play.state.playback
    assert shown is not None and shown.ended
    two.key(pygame.K_RETURN)
    two.app.step(FRAME)
    assert two.play.state.playback is None
