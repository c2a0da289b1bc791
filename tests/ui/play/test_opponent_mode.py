"""A match against a player who is no person: seen to think, to settle and to strike, and taken back."""

from __future__ import annotations

from dataclasses import replace

import pygame
import pytest

from pool2d.game.actions import Stroke
from pool2d.game.records.recorder import resume
from pool2d.game.session import Session
from pool2d.opponent.playing import by_hand
from pool2d.ui.dialogs.dialog import Confirm
from pool2d.ui.play import play_view
from pool2d.ui.play.modes import opponent_mode
from pool2d.ui.play.modes.match_mode import MatchMode

from ..conftest import FRAME, Hand
from ..menus.at_menu import choose
from .at_opponent import Here, frames, mode, play_against, sit_down, until_played


@pytest.fixture(autouse=True)
def quick(data: None, monkeypatch: pytest.MonkeyPatch) -> None:
    sit_down(monkeypatch)


def stroke_of(session: Session, number: int = -1) -> Stroke:
    action = [moment.action for moment in session.match.history if moment.rollout is not None][number]
    assert isinstance(action, Stroke)
    return action


def persons_stroke(hand: Hand) -> None:
    """A stroke of the person's, to which the other side has to answer."""
    session = hand.play.state.session
    if session.ask.where:
        hand.play.state.in_hand.put_back()
        assert any(session.place(0.4, 0.1 * step) for step in range(2, 12))
        hand.app.step(0.0)
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=180.0, speed=0.3)
    hand.strike()
    assert not mode(hand).persons_turn


def test_a_player_is_seen_to_look_about_to_settle_and_to_strike(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Here, "ready", False)
    session = play_against(hand, "", "quick", breaker=0)
    persons_stroke(hand)
    while session.ask.kind == "choose":
        session.choose(session.ask.options[0])
    state = hand.play.state
    frames(hand, 0.2)
    assert state.messages.text.endswith("Quick thinks.")
    assert len(Here.made[0].asked) == 1 and session.match.now.shooter == 0
    Here.ready = True
    angles, swings, texts, places = set(), set(), set(), set()
    while state.playback is None:
        hand.app.step(FRAME)
        angles.add(state.hands.aim.angle)
        swings.add(state.hands.swing)
        texts.add(state.messages.text.rpartition(". ")[2])
        places.add(state.in_hand.at)
    assert len(places) > 30, "the cue ball is carried to its place"
    assert len(angles) > 30 and len(swings) > 30, "the cue turns, and swings"
    assert {"Quick puts the cue ball down.", "Quick aims."} <= texts
    meant = by_hand(session.match, stroke_of(session), mode(hand)._seats[1], "")  # type: ignore[arg-type]
    assert meant != stroke_of(session), "the hand strays"
    assert state.hands.aim.angle == pytest.approx(stroke_of(session).shot.angle % 360.0)
    assert state.playback.time < 0.0, "the stroke itself is seen"
    assert stroke_of(session).why is not None, "the record tells why"


def test_what_is_played_is_decided_by_the_match_alone(hand: Hand) -> None:
    """So a turn that is thought once more costs nothing, and so is one that was hurried."""
    session = play_against(hand, "", "quick")
    until_played(hand)
    first = stroke_of(session)
    session = play_against(hand, "", "quick")
    hand.key(pygame.K_SPACE)
    until_played(hand)
    assert stroke_of(session) == first


def test_space_hurries_the_turn_that_is_on(hand: Hand) -> None:
    session = play_against(hand, "", "quick")
    frames(hand, 0.5)
    assert hand.play.state.playback is None
    hand.key(pygame.K_SPACE)
    frames(hand, 3 * FRAME)
    assert hand.play.state.playback is not None and len(session.match.history) > 1


def test_an_option_makes_it_instant(hand: Hand) -> None:
    hand.app.store.turn("screen.instant_players", True)
    play_against(hand, "", "quick")
    frames(hand, 3 * FRAME)
    assert hand.play.state.playback is not None


def test_with_reduced_motion_the_cue_does_not_glide(hand: Hand) -> None:
    hand.app.store.turn("screen.reduced_motion", True)
    play_against(hand, "", "quick")
    angles = set()
    while hand.play.state.playback is None:
        hand.app.step(FRAME)
        angles.add(hand.play.state.hands.aim.angle)
        assert hand.play.state.hands.swing in (0.0, pytest.approx(hand.play.state.hands.swing))
    assert 1 < len(angles) < 12


def test_hands_do_nothing_to_the_table_meanwhile(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Here, "ready", False)
    session = play_against(hand, "", "quick", game="eight-ball", breaker=0)
    persons_stroke(hand)
    now, state = session.match.now, hand.play.state
    frames(hand, 3.0)
    calls, show = vars(state.calls).copy(), state.show.level
    for x, y in ((0.5, 0.5), (1.9, 0.6)):
        hand.point(x, y)
        for button in (1, 3):
            hand.press(button)
            hand.pull(200.0)
            hand.release(button)
    hand.wheel(3)
    held, before = state.in_hand.at, state.hands.aim
    for key in (pygame.K_LEFT, pygame.K_UP, pygame.K_w, pygame.K_F9, pygame.K_y, pygame.K_x, pygame.K_1, pygame.K_F8):
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, mod=0, unicode=""))
        pygame.event.post(pygame.event.Event(pygame.KEYUP, key=key, mod=0))
        hand.app.step(0.0)
    assert (state.hands.aim, state.in_hand.at, vars(state.calls)) == (before, held, calls)
    assert session.match.now is now and not state.hands.busy
    assert hand.play.controller.call_strip.form.widgets == []
    assert play_view.notes(state, 3.0) == ""
    # What does nothing to the table works.
    hand.key(pygame.K_g)
    assert state.show.level != show
    hand.key(pygame.K_r)
    assert state.playback is not None and state.playback.again
    state.playback.leave()
    hand.app.step(FRAME)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is not hand.play
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play


def test_undo_takes_back_the_players_stroke_and_ones_own(hand: Hand) -> None:
    session = play_against(hand, "", "quick", breaker=0)
    persons_stroke(hand)
    start = session.match.history[-2]
    until_played(hand)
    while not mode(hand).persons_turn:
        until_played(hand)
    after = session.match.now
    hand.key(pygame.K_u)
    assert session.match.now is start and hand.play.state.messages.text.startswith("Taken back")
    hand.key(pygame.K_y, pygame.KMOD_CTRL)
    assert session.match.now is after


def test_undo_while_it_thinks_forgets_what_it_thought_of(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Here, "ready", False)
    session = play_against(hand, "", "quick", breaker=0)
    persons_stroke(hand)
    start = session.match.history[-2]
    frames(hand, 0.2)
    hand.key(pygame.K_u)
    assert session.match.now is start and mode(hand).persons_turn
    Here.ready = True
    frames(hand, 2.0)
    assert session.match.now is start and hand.play.state.held is None
    persons_stroke(hand)
    until_played(hand)


def test_a_thinker_that_fails_is_told_asked_again_and_costs_nothing(hand: Hand) -> None:
    session = play_against(hand, "", "quick")
    until_played(hand)
    unharmed = stroke_of(session)
    Here.fails = 2
    session = play_against(hand, "", "quick")
    frames(hand, 3 * FRAME)
    assert hand.play.state.messages.text == "Quick was interrupted, and thinks again. (it has ended)"
    until_played(hand)
    assert stroke_of(session) == unharmed
    seeds = [seed for _, _, seed in Here.made[-1].asked]
    assert len(seeds) >= 3 and len(set(seeds[:3])) == 1


def test_where_it_fails_again_and_again_a_person_plays_the_turn(hand: Hand) -> None:
    Here.fails = 3
    session = play_against(hand, "", "quick", game="eight-ball", table="pool-7ft")
    frames(hand, 6 * FRAME)
    assert mode(hand).persons_turn and "play this one for Quick" in hand.play.state.messages.text
    hand.app.step(1.0)
    hand.play.state.in_hand.put_back()
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(9.0).toward(1.0, 0.005)
    hand.strike()
    assert session.match.history[-1].shooter == 1
    # Its next turn is its own.
    while mode(hand).persons_turn:
        if session.ask.kind == "choose":
            hand.key(pygame.K_1)
        else:
            persons_stroke(hand)
    until_played(hand)


def test_what_is_called_is_said_aloud_and_marked(hand: Hand) -> None:
    session = play_against(hand, "quick", "quick", game="eight-ball", breaker=0)
    until_played(hand, 1)
    said = set()
    for _ in range(4000):
        hand.app.step(FRAME)
        state = hand.play.state
        if state.playback is None and state.hands.swing > 0.0 and (state.calls.pocket or state.calls.safety):
            said.add(state.messages.text)
            break
        if state.playback is not None:
            state.playback.leave()
    assert any("calls" in text for text in said), session.ask
    while state.playback is None:
        hand.app.step(FRAME)
    called = stroke_of(session).call
    assert called.safety or (called.ball and called.pocket)
    assert "calls" in state.messages.text, "it stands there while the balls run"


def test_a_choice_is_said_before_it_is_made(hand: Hand) -> None:
    session = play_against(hand, "", "quick", game="one-pocket")
    assert session.ask.kind == "choose"
    frames(hand, 3 * FRAME)
    assert "Quick chooses: " in hand.play.state.messages.text
    frames(hand, 2.0)
    assert session.ask.kind != "choose"


def test_who_misses_chalks_up(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[int] = []
    monkeypatch.setattr(hand.play.sounds, "chalk", lambda: heard.append(1))
    play_against(hand, "", "quick")
    until_played(hand)
    while not mode(hand).persons_turn:
        until_played(hand)
    assert hand.play.state.messages.text.endswith("Quick chalks up.") and heard == [1]
    frames(hand, 5.0)
    assert not hand.play.state.messages.text.endswith("Quick chalks up.")


@pytest.mark.parametrize("agreed", [True, False])
def test_who_is_ahead_does_not_agree_to_begin_the_frame_again(
    agreed: bool, hand: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = play_against(hand, "", "quick", breaker=0)
    asked: list[int] = []

    def agrees(rules: object, ruling: object, player: object, side: int) -> bool:
        asked.append(side)
        return agreed

    monkeypatch.setattr(opponent_mode, "agrees", agrees)
    hand.app.scene = hand.app.lobby.pause()
    hand.app.step(0.0)
    choose(hand, "Start the frame again")
    assert asked == [1]
    assert isinstance(hand.app.scene, Confirm) == agreed
    assert [note.words for note in hand.app.toasts.notes] == (
        [] if agreed else ["Quick likes how things stand, and would rather play on."]
    )
    assert len(session.match.history) == 1


def test_a_match_that_is_left_has_its_opponent_again(hand: Hand) -> None:
    session = play_against(hand, "", "quick")
    until_played(hand)
    recorder = session.recorder
    assert recorder is not None
    hand.app.lobby.leave()
    assert Here.made[0].closed
    again = Session((kept := resume(recorder.path)).match, kept)
    hand.app.scene = hand.app.lobby.begin(again)
    assert mode(hand)._seats[1] is not None and again.match.setup.players == ("", "quick")


def test_a_player_whose_file_is_gone_is_a_persons_and_that_is_told(hand: Hand) -> None:
    play_against(hand, "", "nobody")
    assert mode(hand).persons_turn
    assert "nobody" in hand.play.state.messages.text


def test_people_alone_need_no_thinker(hand: Hand) -> None:
    play_against(hand, "", "")
    assert type(hand.play.state.mode) is MatchMode and Here.made == []


def test_the_window_is_closed_in_the_middle_of_a_thought(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Here, "ready", False)
    play_against(hand, "", "quick")
    frames(hand, 0.2)
    hand.play.close()
    assert Here.made[0].closed
