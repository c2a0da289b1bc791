"""Drills by posted events: the shelf, strokes judged, results kept, the solution."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d.game.aim import Aim
from pool2d.game.drills.drill_file import best, keep, load
from pool2d.ui.menus.drill_list import DrillList
from pool2d.ui.play.drill_scene import DrillPlay
from pool2d.ui.widgets.list_row import ListRow
from pool2d.ui.wording import words

from ..conftest import FRAME, Hand


@pytest.fixture(autouse=True)
def own_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    yield
    words.speak("en")


def begin(hand: Hand, name: str) -> DrillPlay:
    """Open the shelf and choose a drill there, by clicking on it."""
    hand.key(pygame.K_F2)
    shelf = hand.app.scene
    assert isinstance(shelf, DrillList)
    entry = next(one for one in shelf.form.widgets if isinstance(one, ListRow) and one.label == load(name).name)
    shelf.form.focus = entry
    hand.key(pygame.K_RETURN)
    play = hand.app.scene
    assert isinstance(play, DrillPlay)
    hand.play = play
    return play


def solve(hand: Hand, play: DrillPlay) -> None:
    """Play the strokes of the solution that are left."""
    for shot in play.drilling.drill.solution[play.drilling.run.standing.done :]:
        play.hands.aim = Aim.of(shot)
        hand.strike()


def miss(hand: Hand, play: DrillPlay) -> None:
    play.hands.aim = Aim(angle=180.0, speed=0.3)
    hand.strike()


def test_the_shelf_lists_every_drill_with_its_goal_and_the_best(hand: Hand) -> None:
    keep("stop-shot", 7)
    hand.key(pygame.K_F2)
    shelf = hand.app.scene
    assert isinstance(shelf, DrillList)
    entries = [one for one in shelf.form.widgets if isinstance(one, ListRow)]
    assert len(entries) >= 20
    assert all(entry.below for entry in entries)
    assert [entry.note for entry in entries if entry.note] == ["best 7 of 10"]
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play


def test_a_drill_done_counts_and_is_kept_at_once(hand: Hand) -> None:
    before = hand.play.session.layout
    table = hand.play
    play = begin(hand, "stop-shot")
    assert play.session.layout == play.drilling.drill.layout
    assert "Pot the 1" in play.message_text
    solve(hand, play)
    assert play.drilling.run.results == (1,)
    assert "Done" in play.message_text
    assert best("stop-shot") == 1
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is table
    assert table.session.layout == before


@pytest.mark.parametrize("way", ["key", "click", "same shot"])
def test_a_miss_is_told_and_the_balls_are_set_up_again(hand: Hand, way: str) -> None:
    play = begin(hand, "stop-shot")
    miss(hand, play)
    assert "not" in play.message_text
    assert play.drilling.run.results == (0,)
    assert best("stop-shot") is None
    if way == "key":
        hand.key(pygame.K_SPACE)
    elif way == "same shot":
        hand.key(pygame.K_F5)
    else:
        hand.point(1.0, 0.3)
        hand.press()
        hand.release()
    assert play.session.layout == play.drilling.drill.layout
    assert play.drilling.run.results == (0,)
    assert play.rollout is None, "setting up is no stroke"


def test_a_whole_run_is_added_up_and_the_next_begins(hand: Hand) -> None:
    play = begin(hand, "lag")
    for number in range(10):
        if number:
            hand.key(pygame.K_SPACE)
        if number % 2:
            miss(hand, play)
        else:
            solve(hand, play)
    assert play.drilling.run.over
    assert "5 of 10" in play.message_text and "best" in play.message_text
    assert best("lag") == 5
    hand.key(pygame.K_SPACE)
    assert play.drilling.run.results == ()
    assert "best 5 of 10" in play.titles[1]


def test_a_drill_of_several_steps_goes_on_after_a_good_stroke(hand: Hand) -> None:
    play = begin(hand, "three-in-order")
    play.hands.aim = Aim.of(play.drilling.drill.solution[0])
    hand.strike()
    assert "1 of 3" in play.message_text
    solve(hand, play)
    assert play.drilling.run.results == (3,)
    assert "goal" in play.message_text


def test_the_solution_is_shown_and_changes_nothing(hand: Hand) -> None:
    play = begin(hand, "three-in-order")
    layout, aim = play.session.layout, play.hands.aim
    hand.key(pygame.K_F4)
    assert play.rollout is not None
    assert play.hands.aim == Aim.of(play.drilling.drill.solution[0])
    for number in (1, 2, 3):
        assert f"stroke {number} of 3" in play.message_text
        hand.key(pygame.K_SPACE)
        hand.app.step(FRAME)
    assert play.rollout is None
    assert play.session.layout == layout and play.hands.aim == aim
    assert play.drilling.run.results == () and play.session.strokes == 0


def test_escape_ends_the_solution_and_then_the_drill(hand: Hand) -> None:
    table = hand.play
    play = begin(hand, "three-in-order")
    aim = play.hands.aim
    hand.key(pygame.K_F4)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is play and play.rollout is None and play.hands.aim == aim
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is table


def test_the_next_drill_and_the_shelf_go_back_to_the_same_table(hand: Hand) -> None:
    table = hand.play
    play = begin(hand, "stop-shot")
    hand.key(pygame.K_F3)
    following = hand.app.scene
    assert isinstance(following, DrillPlay)
    assert following.drilling.drill.id == "stun-far"
    hand.key(pygame.K_F2)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is following
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is table
    assert play.drilling.run.results == ()


def test_in_a_drill_the_balls_are_not_moved_and_strokes_count(hand: Hand) -> None:
    play = begin(hand, "stop-shot")
    layout = play.session.layout
    cue = play.session.cue
    hand.point(cue.x, cue.y)
    hand.press(3)
    hand.point(0.4, 0.4)
    hand.release(3)
    for key in (pygame.K_x, pygame.K_c, pygame.K_F6, pygame.K_t, pygame.K_u):
        hand.key(key)
        assert play.session.layout == layout
        assert play.message_text
    assert play.tuning is None
    miss(hand, play)
    hand.key(pygame.K_u)
    assert play.drilling.run.results == (0,)


def test_a_result_that_cannot_be_kept_is_told(hand: Hand, tmp_path: Path) -> None:
    play = begin(hand, "stop-shot")
    (tmp_path / "drills").mkdir()
    (tmp_path / "drills" / "best.json").write_text("no json")
    solve(hand, play)
    assert "best.json" in play.warning
    assert play.drilling.run.results == (1,)


def test_a_damaged_drill_of_ones_own_is_told_on_the_shelf(hand: Hand, tmp_path: Path) -> None:
    (tmp_path / "drills").mkdir()
    (tmp_path / "drills" / "broken.toml").write_text("name = 3")
    hand.key(pygame.K_F2)
    shelf = hand.app.scene
    assert isinstance(shelf, DrillList)
    assert len([one for one in shelf.form.widgets if isinstance(one, ListRow)]) >= 20


def test_settings_reach_the_table_of_the_drill(hand: Hand) -> None:
    play = begin(hand, "stop-shot")
    hand.app.store.turn("balls.trails", False)
    assert not play.effects.trail
    hand.app.store.turn("screen.language", "de")
    assert play.titles[0] == "Stoppball"
    assert "Versuch 1 von 10" in play.titles[1]


def test_what_is_asked_for_is_marked_on_the_cloth(hand: Hand) -> None:
    play = begin(hand, "position-centre")
    marked = hand.app.window.surface.get_at(tuple(map(round, play.stage.view.to_screen(1.2, 0.75))))
    play.drilling.run = type(play.drilling.run)(load("stop-shot"), play.drilling.run.standing)
    hand.app.redraw()
    hand.app.step(FRAME)
    bare = hand.app.window.surface.get_at(tuple(map(round, play.stage.view.to_screen(1.2, 0.75))))
    assert sum(marked[:3]) > sum(bare[:3]) + 20


def test_a_stroke_is_seen_again_though_the_balls_were_set_up_for_the_next_step(hand: Hand) -> None:
    play = begin(hand, "cut-ladder-left")
    play.hands.aim = Aim.of(play.drilling.drill.solution[0])
    hand.strike()
    assert play.drilling.run.standing.done == 1 and not play.drilling.run.standing.over
    hand.key(pygame.K_r)
    assert play.playback is not None
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_F5)
    hand.key(pygame.K_r)
    assert play.playback is None


def test_the_goal_is_told_again_once_anything_else_has_been_read(hand: Hand) -> None:
    play = begin(hand, "stop-shot")
    goal = play.message_text
    assert goal
    hand.key(pygame.K_u)
    assert play.message_text != goal
    for _ in range(20):
        hand.app.step(0.5)
    assert play.message_text == goal


def test_a_stroke_counts_once_its_balls_have_been_seen_to_rest(hand: Hand) -> None:
    play = begin(hand, "stop-shot")
    before = play.titles
    play.hands.aim = Aim.of(play.drilling.drill.solution[0])
    # The key that opened the drill does not strike; the first press arms the stroke.
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    assert play.playback is not None and play.titles == before
    hand.app.step(0.3)
    hand.key(pygame.K_p)
    assert play.playback is not None and play.titles == before
    hand.key(pygame.K_RETURN)
    hand.app.step(0.5)
    after = play.titles
    assert play.playback is None and after != before
    hand.key(pygame.K_r)
    assert play.playback is not None and play.titles == after
