"""A jump in the window: aimed with the jump cue, told before, played, seen again, and taken back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pygame
import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game.actions import Stroke
from pool2d.game.drills.drill_file import load as load_drill
from pool2d.game.match import Match
from pool2d.game.records.record import load
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import verify
from pool2d.game.setup import Setup
from pool2d.physics.values import AIRBORNE, OFF, Shot
from pool2d.table.position_text import read, write
from pool2d.ui.play.play_view import hop_note, notes
from pool2d.ui.stage.bars import message_lines
from pool2d.ui.wording import shot_text

from ..conftest import Hand

CUE, SEVEN, ONE = Ball("cue", 0.8, 0.635), Ball("7", 1.02, 0.635), Ball("1", 1.9, 0.66)


def aim(hand: Hand, speed: float, elevation: float, angle: float = 0.9) -> None:
    hands = hand.play.state.hands
    hands.aim = replace(hands.aim, angle=angle, speed=speed, elevation=elevation)
    hands.armed = True


@pytest.fixture
def blocked(hand: Hand) -> Hand:
    """The 7 between the cue ball and the 1."""
    hand.set_balls(CUE, SEVEN, ONE)
    aim(hand, 3.2, 42.0)
    return hand


def test_a_key_takes_the_jump_cue_and_puts_it_away(blocked: Hand) -> None:
    state, say = blocked.play.state, blocked.app.words.say
    blocked.key(pygame.K_F8)
    assert state.aimed().jump
    assert state.messages.text == say("play.jump_cue", key="F8")
    blocked.key(pygame.K_F8)
    assert not state.aimed().jump and state.messages.text == say("play.playing_cue")


def test_the_next_player_takes_the_playing_cue(blocked: Hand) -> None:
    blocked.key(pygame.K_F8)
    blocked.play.state.hands.take_over()
    assert not blocked.play.state.aimed().jump


def test_it_is_seen_which_cue_is_taken(blocked: Hand) -> None:
    surface = blocked.app.window.surface
    box = blocked.play.stage.screen.cue_diagram

    def diagram() -> np.ndarray:
        blocked.app.redraw()
        blocked.app.step(0.0)
        return pygame.surfarray.array3d(surface.subsurface(box))

    before = diagram()
    blocked.key(pygame.K_F8)
    assert (diagram() != before).any()
    blocked.key(pygame.K_F8)
    assert (diagram() == before).all()


def test_the_jump_cue_goes_with_the_stroke_when_it_is_set_up_again_or_copied(blocked: Hand) -> None:
    state = blocked.play.state
    blocked.key(pygame.K_F8)
    blocked.strike()
    assert state.session.shot is not None and state.session.shot.jump
    blocked.key(pygame.K_F8)
    blocked.key(pygame.K_F5)
    assert state.aimed().jump and state.session.layout["7"] == SEVEN
    told = write(state.session.layout, state.aimed(), state.session.table)
    assert read(told).shot == state.aimed()


def test_a_jump_that_clears_is_told_and_what_it_meets_in_the_air_if_it_does_not(blocked: Hand) -> None:
    state, words = blocked.play.state, blocked.app.words
    said = hop_note(state, 3.2)
    assert words.say("flight.over", ball="7", gap="X").split("X")[0] in said
    aim(blocked, 2.4, 25.0)
    low = hop_note(state, 2.4)
    assert "in the air" in low and words.say("flight.over", ball="7", gap="X").split(",")[0] not in low
    # The guide that is off works nothing out: how high it goes is told all the same.
    state.show.level = 0
    assert hop_note(state, 2.4) in low and hop_note(state, 2.4)
    aim(blocked, 2.4, 0.0)
    assert hop_note(state, 2.4) == "" == notes(state, 2.4)


def test_the_time_line_names_hop_height_and_landing(blocked: Hand) -> None:
    blocked.strike()
    words, table = blocked.app.words, blocked.play.state.session.table
    rollout = blocked.play.state.session.rollout
    assert rollout is not None
    struck, slate = rollout.events[0], next(event for event in rollout.events if event.kind == "ball_slate")
    apex = max(rollout.ball_at("cue", slate.t * i / 1000).z for i in range(1000))
    told = shot_text.measures(words, struck, table, rollout.start)
    assert words.say("telling.hop", height=shot_text.millimetres(words, apex)) in told
    assert shot_text.title(words, slate, "cue") == "Cue ball lands"
    assert ", up -" in shot_text.change(words, slate, "cue", "cue")


def test_while_it_flies_the_ball_is_drawn_larger_over_the_ball_below(blocked: Hand) -> None:
    blocked.key(pygame.K_SPACE)
    state, view = blocked.play.state, blocked.play.stage.view
    over = False
    while state.playback is not None and state.playback.time < 0.3:
        blocked.app.step(1 / 240)
        ball = state.shown_balls.layout["cue"]
        if ball.phase == AIRBORNE and abs(ball.x - 1.035) < 0.005:
            over = True
            x, y = view.to_screen(ball.x, ball.y)
            # Right of its middle there would be cloth, and left of it the 7, were it not on top.
            left = blocked.app.window.surface.get_at((round(x - 9), round(y)))
            assert min(left[:3]) > 100
    assert over


def test_a_ball_that_leaves_the_table_is_seen_to_go_and_is_kept_among_the_gone(hand: Hand) -> None:
    hand.set_balls(CUE, SEVEN)
    aim(hand, 10.0, 60.0, 0.0)
    hand.key(pygame.K_SPACE)
    state = hand.play.state
    assert state.rollout is not None
    off = next(event for event in state.rollout.events if event.kind == "ball_off")
    assert state.playback is not None and state.playback.end >= off.t + 0.3
    while state.playback is not None and state.playback.time < off.t + 0.05:
        hand.app.step(1 / 120)
    assert state.shown_balls.layout["cue"].phase == OFF and state.shown_balls.states.gone == []
    hand.wait_for_rest()
    assert state.messages.text == hand.app.words.say("outcome.cue_off")
    # It comes back into the hand.
    assert state.session.in_hand


def test_a_match_with_both_cues_replays_to_the_bit(tmp_path: Path) -> None:
    path = tmp_path / "match.jsonl"
    table = load_table("pool-9ft")
    with record(Match(table, Setup("straight", seed=3, breaker=0)), path) as recorder:
        for jump in (False, True):
            recorder.play(Stroke(Shot(1.0, 2.0, elevation=40.0, jump=jump)))
            if recorder.match.ask.kind != "aim":
                break
    kept = load(path)
    assert verify(kept) is None
    with resume(path) as again:
        assert again.changes == () and again.match.now.layout == recorder.match.now.layout


def test_the_drills_for_jumping_need_their_jump() -> None:
    for name in ("jump", "jump-close", "jump-half", "jump-two"):
        drill = load_drill(name)
        assert drill.steps[0].over and drill.solution[0].elevation > 20.0
        assert set(drill.steps[0].over) < set(Layout(drill.layout.values()))


def test_of_many_balls_that_are_jumped_the_nearest_is_told(hand: Hand) -> None:
    """A rack's worth of them once filled three lines, and their figures lay upon each other."""
    row = [Ball(str(i), 1.0 + 0.058 * i, 0.635) for i in range(1, 6)]
    hand.set_balls(CUE, *row)
    aim(hand, 6.0, 35.0, angle=0.0)
    said = hop_note(hand.play.state, 6.0)
    assert said.count("Over") == 1 and "Over 5 balls, the " in said


def test_what_is_aimed_is_read_where_the_bar_has_not_room_for_all() -> None:
    """Of a long verdict and a jump the end was cut off: by how much a ball is cleared, or that it is met."""
    verdict, aimed = "The referee has much to say of this. " * 6, "Over the 7, by 9 mm."
    full = " ".join(message_lines(verdict, aimed, 13, 360, 3))
    assert full.startswith(aimed) and full.endswith("\N{HORIZONTAL ELLIPSIS}")
    assert " ".join(message_lines("Ann to play.", aimed, 13, 360, 3)) == f"Ann to play. {aimed}"
    assert message_lines("", aimed, 13, 360, 3) == (aimed,)
    assert message_lines("Opened: rail", aimed, 13, 360, 3) == (f"Opened: rail. {aimed}",)
    assert message_lines("Opened: rail", "", 13, 360, 3) == ("Opened: rail",)
