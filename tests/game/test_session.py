"""A session: what the window may know of a match, or of practice, and do in it."""

from __future__ import annotations

import random

import pytest

from benchmarks.random_play import new_match, random_action
from pool2d import Ball, InputError, Layout, Rollout, Shot, Table, load_table
from pool2d.game.actions import Stroke
from pool2d.game.match import Match, Moment, lagged
from pool2d.game.records.record import load
from pool2d.game.rules import GAMES, Choice
from pool2d.game.session import Session, practice, recorded
from pool2d.game.setup import LAG, Setup


def about_to_shoot(game: str) -> Session:
    """A new match of a game, in which the first stroke is to be played."""
    session, rng = Session(new_match(game, 5)), random.Random(game)
    while session.ask.kind != "aim":
        session.match.play(random_action(session.match, rng))
    return session


def lasts(session: Session) -> tuple[Moment | None, Rollout | None, Shot | None]:
    """What can be seen again."""
    return session.last, session.rollout, session.shot


def test_a_frame_that_is_given_up_is_the_others_and_the_next_one_is_racked(table: Table) -> None:
    session = Session(Match(table, Setup("nine-ball", race=2, breaker=0)))
    session.play(Shot(0.0, 8.0))
    session.concede(0)
    assert (session.ask.kind, session.ask.player, session.match.frames) == ("over", 1, (0, 1))
    assert session.last == session.match.history[1]
    session.next_frame()
    assert (session.ask.kind, session.ask.player, session.match.now.frame) == ("aim", 1, 1)
    assert (session.strokes, session.left) == (0, 9)
    assert lasts(session) == (None, None, None)


@pytest.mark.parametrize("game", GAMES)
def test_a_stalemate_leaves_no_last_stroke(game: str) -> None:
    session = about_to_shoot(game)
    begun = len(session.layout.on_table())
    shot = Shot(0.0, 3.0, ball=session.cue.id)
    rollout = session.play(shot)
    assert lasts(session) == (session.match.now, rollout, shot)
    session.stalemate()
    assert lasts(session) == (None, None, None)
    assert session.strokes == 0
    assert len(session.layout.on_table()) == begun or lagged(session.match.state)


@pytest.mark.parametrize("game", GAMES)
def test_every_stroke_is_counted_until_the_balls_are_racked(game: str) -> None:
    """A rack that a stroke leads to begins anew, or, as at straight pool, goes on."""
    session, rng = Session(new_match(game, 8)), random.Random(f"{game} strokes")
    for _ in range(25):
        if session.match.over:
            break
        before, action = session.match.state, random_action(session.match, rng)
        session.match.play(action)
        after = session.match.state
        if isinstance(action, Stroke) and not (lagged(before) or after.over):
            assert after.shots == before.shots + 1 or (after.racks > before.racks and after.shots == 0)
        elif isinstance(action, Choice) and action.key == "place":
            assert after.shots == before.shots


def test_the_strokes_of_a_lag_are_counted_and_none_of_the_rack_after_it(table: Table) -> None:
    session = Session(Match(table, Setup("nine-ball", breaker=LAG, seed=3)))
    for strokes in (0, 1):
        assert (session.strokes, session.ask.kind) == (strokes, "aim")
        # The second lag is the shorter one, so that both are good and one of them is better.
        session.play(Shot(0.0, 1.5 - 0.05 * strokes, ball=session.cue.id))
    assert (session.strokes, session.ask.kind) == (2, "choose")
    session.choose("break")
    assert (session.strokes, session.left) == (0, 9)


def test_the_balls_left_are_those_on_the_table_but_for_the_one_to_be_struck(table: Table) -> None:
    session = practice(table)
    assert session.left == 15
    session.arrange(Layout([Ball("cue", 1.27, 0.9), Ball("1", 1.27, 0.3), Ball("2", 0.3, 1.0)]))
    assert (session.left, session.strokes, session.last) == (2, 0, None)
    session.play(Shot(-90.0, 2.0, height=-0.05))
    assert (session.left, session.strokes, session.layout["1"].phase) == (1, 1, "pocketed")


def test_the_first_rack_of_the_table_is_taken_or_the_one_that_is_named(table: Table) -> None:
    session = practice(table)
    first = next(iter(table.furniture.racks))
    session.rack(4)
    assert session.layout == table.rack(first, 4)
    session.rack(4, "nine-ball")
    assert session.layout == table.rack("nine-ball", 4)
    assert len(session.layout) == 10
    with pytest.raises(InputError, match="practice only"):
        Session(Match(table, Setup("nine-ball"))).rack(4)


def test_another_ball_is_struck_once_where_the_rules_leave_the_choice() -> None:
    session = about_to_shoot("free-pyramid")
    with pytest.raises(InputError, match="ball to be struck = '3': allowed is cue"):
        session.take_cue("3")
    session.play(Shot(0.5, 9.0))
    while session.ask.kind == "choose":
        session.choose("accept")
    usual = session.cue.id
    other = next(ball for ball in session.ask.cues if ball != usual)
    session.take_cue(other)
    assert session.cue == session.layout[other]
    assert session.left == len(session.layout.on_table()) - 1
    with pytest.raises(InputError, match=r"allowed is .*cue.*, "):
        session.take_cue("nine")
    # What was taken is of the moment: gone after the stroke, and when it is undone.
    session.play(Shot(40.0, 2.0, ball=other))
    assert session.match.now.report is not None and session.match.now.report.cue == other
    assert session.cue.id == session.ask.ball
    session.undo()
    assert session.cue.id == usual


def test_a_cue_ball_given_by_a_foul_is_so_until_it_is_placed(table: Table) -> None:
    session = Session(Match(table, Setup("nine-ball", breaker=0)))
    # In hand for the break, but by no foul; so it is in practice.
    assert session.movable and not session.in_hand and not session.in_hand_by_foul
    assert not practice(table).in_hand_by_foul
    session.play(Shot(180.0, 1.0))
    assert session.ruling.foul and session.ask.kind == "aim" and session.in_hand_by_foul
    assert session.may_place(0.5, 0.5) and not session.may_place(9.0, 0.5)
    assert not session.place(9.0, 0.5)
    assert session.in_hand_by_foul
    assert session.place(0.5, 0.5)
    assert session.movable and not session.in_hand_by_foul
    session.play(Shot(90.0, 1.0))
    session.place(0.4, 0.4)
    session.undo()
    # Undone with the place is the stroke before it; the stroke is the other player's.
    assert session.ask.player == 1


def test_only_practice_goes_on_on_another_table(table: Table) -> None:
    slow = table.with_knobs({"cloth.mu_roll": 0.02})
    session = practice(table)
    session.change_table(slow)
    assert session.table is slow and session.is_practice
    small = practice(load_table("pool-7ft"))
    assert not small.place(2.3, 0.3)
    small.change_table(table)
    assert small.place(2.3, 0.3) and small.layout["cue"].x == 2.3
    match = Session(Match(table, Setup("nine-ball")))
    with pytest.raises(InputError, match="the table stays as it is"):
        match.change_table(slow)
    assert match.table is table and not match.is_practice


def test_a_match_that_was_left_at_once_leaves_no_record_and_another_stays(table: Table) -> None:
    session = recorded(table, Setup("nine-ball", breaker=0))
    assert session.recorder is not None
    path = session.recorder.path
    assert path.exists()
    session.leave()
    assert not path.exists()
    session = recorded(table, Setup("nine-ball", breaker=0))
    assert session.recorder is not None
    session.play(Shot(180.0, 1.0))
    assert session.undo() and session.redo()
    session.leave()
    done = [line.data["do"] for line in load(session.recorder.path).entries]
    assert done == ["stroke", "undo", "redo"]


def test_a_ball_in_hand_off_the_table_has_to_be_placed_first(table: Table) -> None:
    session = Session(Match(table, Setup("nine-ball", breaker=0)))
    session.place(0.3, 0.3)
    # Into the corner at the head, behind which the cue ball lies.
    session.play(Shot(225.0, 1.5))
    assert session.layout["cue"].phase == "pocketed"
    assert session.in_hand and session.movable and not session.in_hand_by_foul
    assert session.left == 9
    with pytest.raises(InputError, match="allowed is what is asked for: place"):
        session.play(Shot(0.0, 1.0))
    assert session.place(1.0, 0.3)
    assert not session.in_hand and session.layout["cue"].x == 1.0


def test_undo_and_redo_pass_over_placements(table: Table) -> None:
    session = Session(Match(table, Setup("nine-ball", breaker=0)))
    begun = session.match.now
    # A cue ball that comes back without a hit is a foul, after which it may be placed.
    session.play(Shot(180.0, 0.3))
    fouled = session.match.now
    assert session.ask.where == "anywhere"
    assert session.place(0.5, 0.4) and session.place(0.5, 0.5)
    placed = session.match.now
    session.play(Shot(90.0, 0.3))
    last = session.match.now
    # Back to where the cue ball was put for the stroke, and from there past both places to before the one before.
    assert session.undo() and session.match.now is placed
    assert session.undo() and session.match.now is begun
    assert not session.undo()
    assert session.redo() and session.match.now is fouled
    assert session.redo() and session.match.now is last
    assert not session.redo()


def against(table: Table, *players: str, breaker: int = 0, race: int = 1) -> Session:
    """Nine-ball between people and players."""
    return Session(Match(table, Setup("nine-ball", race=race, breaker=breaker, players=players)))


# A stroke that touches nothing: a foul, after which the other has the cue ball in hand.
_AIR = Shot(180.0, 0.3)


def test_undo_goes_back_to_the_last_decision_of_a_persons_and_redo_forth_to_the_next(table: Table) -> None:
    session = against(table, "", "club")
    session.play(_AIR)
    before = session.match.now
    assert not session.persons_turn
    session.place(0.4, 0.4)
    session.play(_AIR)
    after = session.match.now
    assert session.persons_turn
    assert session.undo()
    assert len(session.match.history) == 1
    assert session.redo()
    assert session.match.now is after
    # In the middle of the other's turn: only the person's own stroke is taken back.
    session = against(table, "", "club")
    session.play(_AIR)
    assert session.undo()
    assert len(session.match.history) == 1 and before.shooter == 0
    assert not session.undo()


def test_what_a_player_did_before_any_person_is_not_taken_back(table: Table) -> None:
    session = against(table, "club", "")
    session.play(_AIR)
    assert session.persons_turn
    assert not session.undo()
    session.play(_AIR)
    assert session.undo()
    assert len(session.match.history) == 2 and session.persons_turn


def test_between_players_each_stroke_is_taken_back(table: Table) -> None:
    session = against(table, "club", "club", race=2)
    session.play(_AIR)
    session.play(_AIR)
    assert session.undo()
    assert len(session.match.history) == 2
    assert session.redo()
    session.concede(0)
    assert not session.persons_turn


def test_a_person_gives_up_for_themselves_and_goes_on_between_frames(table: Table) -> None:
    session = against(table, "", "club", race=2)
    session.play(_AIR)
    assert (session.ask.player, session.gives_up) == (1, 0)
    session.concede(session.gives_up)
    assert session.match.frames == (0, 1)
    assert session.persons_turn
    assert against(table, "club", "club").gives_up == 0
    assert Session(Match(table, Setup("nine-ball", breaker=1))).gives_up == 1
