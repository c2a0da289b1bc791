"""Drills by posted events: the shelf, strokes judged, results kept, the solution."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from pool2d.game.aim import Aim
from pool2d.game.drills.best_results import best, keep
from pool2d.game.drills.drill_file import load
from pool2d.ui.menus.drill_list import DrillList
from pool2d.ui.play.modes.drill_mode import DrillMode
from pool2d.ui.widgets.list_row import ListRow

from ..conftest import FRAME, Hand


@pytest.fixture(autouse=True)
def own_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))


def begin(hand: Hand, name: str) -> DrillMode:
    """Open the shelf and choose a drill there, by clicking on it."""
    hand.key(pygame.K_F2)
    shelf = hand.app.scene
    assert isinstance(shelf, DrillList)
    entry = next(one for one in shelf.form.widgets if isinstance(one, ListRow) and one.label == load(name).name)
    shelf.form.focus = entry
    hand.key(pygame.K_RETURN)
    assert hand.app.scene is hand.play
    return playing(hand)


def playing(hand: Hand) -> DrillMode:
    """The drill that is on the table."""
    mode = hand.play.state.mode
    assert isinstance(mode, DrillMode)
    return mode


def solve(hand: Hand, drill: DrillMode) -> None:
    """Play the strokes of the solution that are left."""
    for shot in drill.session.drill.solution[drill.session.run.standing.done :]:
        hand.play.state.hands.aim = Aim.of(shot)
        hand.strike()


def miss(hand: Hand, drill: DrillMode) -> None:
    hand.play.state.hands.aim = Aim(angle=180.0, speed=0.3)
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
    before = hand.play.state.session.layout
    drill = begin(hand, "stop-shot")
    assert hand.play.state.session.layout == drill.session.drill.layout
    assert "Pot the 1" in hand.play.state.messages.text
    solve(hand, drill)
    assert drill.session.run.results == (1,)
    assert "Done" in hand.play.state.messages.text
    assert best("stop-shot") == 1
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play
    assert hand.play.state.session.layout == before


@pytest.mark.parametrize("way", ["key", "click", "same shot"])
def test_a_miss_is_told_and_the_balls_are_set_up_again(hand: Hand, way: str) -> None:
    drill = begin(hand, "stop-shot")
    miss(hand, drill)
    assert "not" in hand.play.state.messages.text
    assert drill.session.run.results == (0,)
    assert best("stop-shot") is None
    if way == "key":
        hand.key(pygame.K_SPACE)
    elif way == "same shot":
        hand.key(pygame.K_F5)
    else:
        hand.point(1.0, 0.3)
        hand.press()
        hand.release()
    assert hand.play.state.session.layout == drill.session.drill.layout
    assert drill.session.run.results == (0,)
    assert hand.play.state.rollout is None, "setting up is no stroke"


def test_a_whole_run_is_added_up_and_the_next_begins(hand: Hand) -> None:
    drill = begin(hand, "lag")
    for number in range(10):
        if number:
            hand.key(pygame.K_SPACE)
        if number % 2:
            miss(hand, drill)
        else:
            solve(hand, drill)
    assert drill.session.run.over
    assert "5 of 10" in hand.play.state.messages.text and "best" in hand.play.state.messages.text
    assert best("lag") == 5
    hand.key(pygame.K_SPACE)
    assert drill.session.run.results == ()
    assert "best 5 of 10" in hand.play.state.titles[1]


def test_a_drill_of_several_steps_goes_on_after_a_good_stroke(hand: Hand) -> None:
    drill = begin(hand, "three-in-order")
    # Its solution is of level strokes.
    hand.play.state.easy_stroke = True
    hand.play.state.hands.aim = Aim.of(drill.session.drill.solution[0])
    hand.strike()
    assert "1 of 3" in hand.play.state.messages.text
    solve(hand, drill)
    assert drill.session.run.results == (3,)
    assert "goal" in hand.play.state.messages.text


def test_the_solution_is_shown_and_changes_nothing(hand: Hand) -> None:
    drill = begin(hand, "three-in-order")
    layout, aim = hand.play.state.session.layout, hand.play.state.hands.aim
    hand.key(pygame.K_F4)
    assert hand.play.state.rollout is not None
    assert hand.play.state.hands.aim == Aim.of(drill.session.drill.solution[0])
    for number in (1, 2, 3):
        assert f"stroke {number} of 3" in hand.play.state.messages.text
        hand.key(pygame.K_SPACE)
        hand.app.step(FRAME)
    assert hand.play.state.rollout is None
    assert hand.play.state.session.layout == layout and hand.play.state.hands.aim == aim
    assert drill.session.run.results == () and hand.play.state.session.strokes == 0


def test_escape_ends_the_solution_and_then_the_drill(hand: Hand) -> None:
    state = hand.play.state
    begin(hand, "three-in-order")
    aim = hand.play.state.hands.aim
    hand.key(pygame.K_F4)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.state is not state
    assert hand.play.state.rollout is None and hand.play.state.hands.aim == aim
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.state is state


def test_the_next_drill_and_the_shelf_go_back_to_the_same_table(hand: Hand) -> None:
    state = hand.play.state
    drill = begin(hand, "stop-shot")
    hand.key(pygame.K_F3)
    following = playing(hand)
    assert following.session.drill.id == "stun-far"
    hand.key(pygame.K_F2)
    assert hand.app.scene is not hand.play
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and playing(hand) is following
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play and hand.play.state is state
    assert drill.session.run.results == ()


def test_in_a_drill_the_balls_are_not_moved_and_strokes_count(hand: Hand) -> None:
    drill = begin(hand, "stop-shot")
    layout = hand.play.state.session.layout
    cue = hand.play.state.session.cue
    hand.point(cue.x, cue.y)
    hand.press(3)
    hand.point(0.4, 0.4)
    hand.release(3)
    for key in (pygame.K_x, pygame.K_c, pygame.K_F6, pygame.K_t, pygame.K_u):
        hand.key(key)
        assert hand.play.state.session.layout == layout
        assert hand.play.state.messages.text
    assert hand.play.controller.tuning is None
    miss(hand, drill)
    hand.key(pygame.K_u)
    assert drill.session.run.results == (0,)


def test_a_result_that_cannot_be_kept_is_told(hand: Hand, tmp_path: Path) -> None:
    drill = begin(hand, "stop-shot")
    (tmp_path / "drills").mkdir()
    (tmp_path / "drills" / "best.json").write_text("no json")
    solve(hand, drill)
    assert "best.json" in hand.play.state.messages.warning
    assert drill.session.run.results == (1,)


def test_a_damaged_drill_of_ones_own_is_told_on_the_shelf(hand: Hand, tmp_path: Path) -> None:
    (tmp_path / "drills").mkdir()
    (tmp_path / "drills" / "broken.toml").write_text("name = 3")
    hand.key(pygame.K_F2)
    shelf = hand.app.scene
    assert isinstance(shelf, DrillList)
    assert len([one for one in shelf.form.widgets if isinstance(one, ListRow)]) >= 20


def test_settings_reach_the_table_of_the_drill(hand: Hand) -> None:
    begin(hand, "stop-shot")
    hand.app.store.turn("balls.trails", False)
    assert not hand.play.state.show.effects.trail
    hand.app.store.turn("screen.language", "de")
    assert hand.play.state.titles[0] == "Stoppball"
    assert "Versuch 1 von 10" in hand.play.state.titles[1]


def test_what_is_asked_for_is_marked_on_the_cloth(hand: Hand) -> None:
    drill = begin(hand, "position-centre")
    marked = hand.app.window.surface.get_at(tuple(map(round, hand.play.stage.view.to_screen(1.2, 0.75))))
    drill.session.run = type(drill.session.run)(load("stop-shot"), drill.session.run.standing)
    hand.app.redraw()
    hand.app.step(FRAME)
    bare = hand.app.window.surface.get_at(tuple(map(round, hand.play.stage.view.to_screen(1.2, 0.75))))
    assert sum(marked[:3]) > sum(bare[:3]) + 20


def test_a_stroke_is_seen_again_though_the_balls_were_set_up_for_the_next_step(hand: Hand) -> None:
    drill = begin(hand, "cut-ladder-left")
    hand.play.state.hands.aim = Aim.of(drill.session.drill.solution[0])
    hand.strike()
    assert drill.session.run.standing.done == 1 and not drill.session.run.standing.over
    hand.key(pygame.K_r)
    assert hand.play.state.playback is not None
    hand.key(pygame.K_ESCAPE)
    hand.key(pygame.K_F5)
    hand.key(pygame.K_r)
    assert hand.play.state.playback is None


def test_the_goal_is_told_again_once_anything_else_has_been_read(hand: Hand) -> None:
    begin(hand, "stop-shot")
    goal = hand.play.state.messages.text
    assert goal
    hand.key(pygame.K_u)
    assert hand.play.state.messages.text != goal
    for _ in range(20):
        hand.app.step(0.5)
    assert hand.play.state.messages.text == goal


def test_a_stroke_counts_once_its_balls_have_been_seen_to_rest(hand: Hand) -> None:
    drill = begin(hand, "stop-shot")
    before = hand.play.state.titles
    hand.play.state.hands.aim = Aim.of(drill.session.drill.solution[0])
    # The key that opened the drill does not strike; the first press arms the stroke.
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    assert hand.play.state.playback is not None and hand.play.state.titles == before
    hand.app.step(0.3)
    hand.key(pygame.K_p)
    assert hand.play.state.playback is not None and hand.play.state.titles == before
    hand.key(pygame.K_RETURN)
    hand.app.step(0.5)
    after = hand.play.state.titles
    assert hand.play.state.playback is None and after != before
    hand.key(pygame.K_r)
    assert hand.play.state.playback is not None and hand.play.state.titles == after
