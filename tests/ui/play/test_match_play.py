"""A match in the window: the scoreboard, undo, the ball in hand, and what the referee says."""

from __future__ import annotations

import pygame
import pytest

from pool2d import Layout, Shot, simulate
from pool2d.draw import guide
from pool2d.game.aim import Aim
from pool2d.game.rules import AIM, PLACE
from pool2d.game.session import Session
from pool2d.ui.menus.ended import FrameOver
from pool2d.ui.play import play_view
from pool2d.ui.play.call_words import off_target, verdict
from pool2d.ui.stage import scoreboard
from pool2d.ui.wording.words import Words

from ..at_match import begin
from ..conftest import Hand


def test_a_break_is_judged_and_the_referee_says_what_is_next(hand: Hand) -> None:
    session = begin(hand)
    assert "Ann breaks" in hand.play.state.messages.text
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.005)
    hand.strike()
    assert session.match.now.report is not None
    assert hand.play.state.messages.text == verdict(hand.app.words, hand.play.state.calls, session)
    assert any(name in hand.play.state.messages.text for name in ("Ann", "Bob"))


def test_an_aim_at_a_ball_that_is_not_on_is_told(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    one = session.layout["1"]
    hand.point(one.x, one.y)
    hand.app.step(0.0)
    assert off_target(hand.app.words, hand.play.state.calls, session, "1") == ""
    assert off_target(hand.app.words, hand.play.state.calls, session, "9") == "The 9 is not on."
    assert hand.play.state.first_hit(hand.play.state.hands.aim.shot("cue")) == "1"


def test_in_a_match_the_table_stays_and_nothing_is_racked(hand: Hand) -> None:
    session = begin(hand)
    before = session.match.now
    hand.key(pygame.K_n)
    hand.key(pygame.K_t)
    assert hand.play.controller.tuning is None
    assert session.match.now is before
    assert hand.play.state.messages.text.startswith("Only in practice")


def test_undo_and_redo(hand: Hand) -> None:
    session = begin(hand)
    start = session.match.now
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.005)
    hand.strike()
    after = session.match.now
    hand.key(pygame.K_u)
    assert session.match.now is start
    hand.key(pygame.K_y, pygame.KMOD_CTRL)
    assert session.match.now is after
    hand.key(pygame.K_y, pygame.KMOD_CTRL)
    assert "nothing to do again" in hand.play.state.messages.text


def test_a_ball_in_hand_goes_only_where_the_ruling_allows(hand: Hand) -> None:
    session = begin(hand, "snooker", "snooker-12ft")
    assert session.ask.where == "d"
    if session.ask.kind == PLACE:
        hand.point(2.0, 0.9)
        hand.press()
        hand.release()
        assert session.in_hand
        hand.point(session.table.furniture.spots["head"][0] - 0.1, session.table.furniture.spots["head"][1])
        hand.press()
        hand.release()
    assert session.ask.kind == AIM


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("size", [(960, 540), (1280, 720)])
def test_names_and_scores_stay_beside_the_tray(hand: Hand, size: tuple[int, int], language: str) -> None:
    hand.app.window.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    hand.app.words.speak(language)
    session = begin(hand, "straight", race=3)
    assert session.match.setup.race == 3
    tray = hand.play.stage.screen.tray
    bar = pygame.surfarray.array3d(hand.app.window.surface.subsurface(tray)).max(axis=2)
    assert (bar < 120).all(), "nothing is written where fallen balls lie"
    left = pygame.surfarray.array3d(hand.app.window.surface.subsurface((0, 0, tray.left, tray.height))).max(axis=2)
    assert (left > 150).any()


def details(session: Session, player: int) -> list[str]:
    now = session.match.now
    return scoreboard._details(Words(), session.match, now, player, now.ruling.ask.player == player)


def test_what_a_game_adds_is_told_of_each_player(hand: Hand) -> None:
    session = begin(hand, "snooker", "snooker-12ft", race=3)
    assert details(session, 0) == ["0 of 3 frames", "147 points left"]
    assert details(session, 1) == ["0 of 3 frames"]
    session = begin(hand, "one-pocket")
    key = session.ask.options[0]
    session.choose(key)
    own = [details(session, player)[0] for player in (0, 1)]
    assert sorted(own) == ["bottom right", "top right"]


def test_the_layout_of_a_match_is_not_arranged(hand: Hand) -> None:
    session = begin(hand)
    layout = session.layout
    with pytest.raises(Exception, match="practice only"):
        session.arrange(Layout())
    assert session.layout is layout


def test_going_back_and_forth_over_the_end_of_a_frame_shows_it(hand: Hand) -> None:
    session = begin(hand, race=2)
    session.concede(0)
    session.next_frame()
    hand.app.step(0.0)
    hand.key(pygame.K_u)
    assert isinstance(hand.app.scene, FrameOver)
    # Esc leaves it, and a stroke comes back to it rather than say what it cannot do.
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_SPACE)
    assert isinstance(hand.app.scene, FrameOver)
    assert "Stroke(" not in hand.play.state.messages.text


def test_the_ways_of_a_shot_tell_the_struck_ball_whichever_it_is(hand: Hand) -> None:
    session = begin(hand, "three-cushion", "carom-10ft")
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(0.0, 1.0)
    hand.strike()
    assert session.ask.ball == "yellow"
    view, yellow = hand.play.stage.view, session.cue
    rollout = simulate(session.table, session.layout, Shot(90.0, 0.4, ball="yellow"))
    surface = pygame.Surface((1280, 720))
    guide.draw_whole(surface, rollout, session.table, view, (255, 0, 0, 255), (0, 0, 255, 255))
    end = rollout.layout()["yellow"]
    x, y = view.to_screen(0.5 * (yellow.x + end.x), 0.5 * (yellow.y + end.y))
    assert surface.get_at((round(x), round(y)))[0] > 100 > surface.get_at((round(x), round(y)))[2]


def test_the_word_of_the_referee_comes_back_after_a_notice(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    verdict = hand.play.state.messages.text
    assert "Ann breaks" in verdict and "The 1 is on." in verdict and "dragged behind the line" in verdict
    hand.key(pygame.K_g)
    assert "Guide" in hand.play.state.messages.text
    # A window that is still would never tell it.
    assert not hand.play.still
    hand.app.step(3.0)
    assert "Guide" in hand.play.state.messages.text
    hand.app.step(1.5)
    assert hand.play.state.messages.text == verdict
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.005)
    hand.strike()
    said = hand.play.state.messages.text
    fell = session.match.now.report.potted if session.match.now.report else ()
    assert ("Pocketed:" in said) == bool(fell)
    hand.key(pygame.K_r)
    hand.key(pygame.K_ESCAPE)
    assert hand.play.state.playback is None and hand.play.state.messages.text == said


def test_each_player_takes_the_cue_as_it_was_at_first(hand: Hand) -> None:
    session = begin(hand, "nine-ball")
    struck = Aim(angle=12.0, speed=0.5, side=0.3, height=-0.4, elevation=20.0)
    hand.play.state.hands.aim = struck
    hand.key(pygame.K_SPACE)
    # While the shot is seen, so is how it was struck.
    assert session.ask.player == 1 and hand.play.state.hands.aim == struck
    hand.key(pygame.K_SPACE)
    hand.app.step(0.5)
    assert session.ask.player == 1
    aim = hand.play.state.hands.aim
    assert (aim.angle, aim.speed, aim.side, aim.height, aim.elevation) == (12.0, Aim().speed, 0.0, 0.0, 0.0)


def test_why_the_cue_ball_may_not_stand_somewhere_is_told(hand: Hand) -> None:
    begin(hand, "snooker", "snooker-12ft")
    session = hand.play.state.session
    cue, yellow = session.cue, session.layout["yellow"]
    for place, why in (((2.0, 0.9), "in the D"), ((yellow.x - 0.02, yellow.y + 0.02), "no room")):
        hand.point(cue.x, cue.y)
        hand.press()
        hand.point(*place)
        hand.release()
        assert why in hand.play.state.messages.text and "back where it was" in hand.play.state.messages.text
        assert session.cue == cue


def test_a_click_leads_on_from_a_frame_that_is_over(hand: Hand) -> None:
    session = begin(hand, race=2)
    session.concede(0)
    hand.app.step(0.0)
    hand.point(1.0, 0.3)
    hand.press()
    assert isinstance(hand.app.scene, FrameOver)


def test_a_tip_that_will_slip_is_told_before_the_stroke(hand: Hand) -> None:
    play = hand.play
    play.state.hands.aim = play.state.hands.aim.with_spin(0.0, 0.3)
    shot = play.state.hands.aim.shot("cue", 2.0)
    assert "slip" not in play_view.notes(play.state, shot.speed)
    play.state.hands.aim = play.state.hands.aim.with_spin(0.9, 0.0)
    assert "slip" in play_view.notes(play.state, shot.speed)


def test_a_shot_seen_again_stands_below_the_score_that_it_has_made(hand: Hand) -> None:
    session = begin(hand, "snooker", "snooker-12ft")
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(0.5).turned(180.0)

    def bar() -> bytes:
        surface = hand.app.window.surface
        return pygame.image.tobytes(surface.subsurface(hand.play.stage.screen.top), "RGB")

    hand.key(pygame.K_SPACE)
    aim, first = hand.play.state.hands.aim, bar()
    hand.app.step(0.1)
    assert bar() == first
    hand.key(pygame.K_SPACE)
    hand.app.step(0.5)
    assert session.match.state.scores == (0, 4)
    hand.play.state.hands.aim = aim
    hand.key(pygame.K_r)
    assert hand.play.state.playback is not None and hand.play.state.playback.running
    assert bar() != first
