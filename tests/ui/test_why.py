"""Why a stroke was played, asked of a replay by key and by button."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table
from pool2d.game import Fear, Match, Reasons, Setup, Stroke, Thought
from pool2d.game.records.recorder import record
from pool2d.game.rules import Note
from pool2d.ui.frame import Frame
from pool2d.ui.play.play import Play
from pool2d.ui.replay import replay_view
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.screen import Screen
from pool2d.ui.stage import why_panel
from pool2d.ui.wording.words import Words

from .test_replay_scene import Viewer

WHY = Reasons(
    Thought("break", Shot(0.0, 8.2), "1", chance=0.9, value=0.53, runs=20, fouls=0.1, lost=0.6),
    (Thought("safety", Shot(3.0, 2.0), "1", chance=1.0, value=0.4),),
    (Fear(Note("fear.left", 1), 0.1),),
)


@pytest.fixture
def viewer(tmp_path: Path) -> Iterator[Viewer]:
    """A person who looks at a match of two strokes, of which the first says why."""
    match = Match(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bob"), breaker=0, seed=3))
    with record(match, tmp_path / "a.jsonl") as recorder:
        recorder.play(Stroke(Shot(0.25, 8.0), why=WHY))
        recorder.play(Stroke(Shot(180.0, 0.5)))
    viewer = Viewer(tmp_path / "a.jsonl")
    yield viewer
    viewer.app.close()


def said(viewer: Viewer) -> list[tuple[str, str]]:
    shot, replay = viewer.replay.state.shot, viewer.replay
    assert shot.moment.action is not None
    words, screen = viewer.app.words, replay.stage.screen
    lines = why_panel.lines(words, screen, shot.match, shot.before, shot.moment.action)
    return [(heading, line) for heading, _, line in lines]


def picture(viewer: Viewer) -> bytes:
    viewer.replay.draw(Frame(viewer.app.window.surface))
    return pygame.image.tobytes(viewer.app.window.surface, "RGB")


def test_the_key_holds_the_shot_at_its_beginning_and_says_why(viewer: Viewer) -> None:
    viewer.wait(1.5)
    assert not viewer.replay.state.playback.paused
    viewer.key(pygame.K_h)
    state = viewer.replay.state
    assert (state.why, state.playback.paused, state.playback.time) == (True, True, 0.0)
    lines = said(viewer)
    assert lines[0] == ("Meant", "Break, the 1, 8.20 m/s without spin")
    assert [heading for heading, _ in lines if heading] == ["Meant", "Or else", "Feared", "The hand"]
    assert ("Feared", "10 %: Bob was left a good shot.") in lines
    viewer.key(pygame.K_h)
    assert (state.why, state.playback.paused) == (False, False)


def test_a_shot_that_was_held_later_stays_held(viewer: Viewer) -> None:
    state = viewer.replay.state
    viewer.key(pygame.K_h)
    viewer.key(pygame.K_SPACE)
    viewer.wait(1.0)
    viewer.key(pygame.K_SPACE)
    viewer.key(pygame.K_h)
    assert state.playback.paused and state.playback.time > 0.5


def test_the_panel_and_the_lines_are_seen_and_gone_again(viewer: Viewer) -> None:
    viewer.key(pygame.K_SPACE)
    viewer.key(pygame.K_HOME)
    viewer.move((2, 300))
    plain = picture(viewer)
    assert picture(viewer) == plain
    viewer.key(pygame.K_h)
    assert picture(viewer) != plain
    viewer.key(pygame.K_h)
    viewer.key(pygame.K_SPACE)
    viewer.key(pygame.K_HOME)
    assert picture(viewer) == plain


def test_esc_closes_the_panel_and_only_then_the_replay(viewer: Viewer) -> None:
    viewer.replay.below = viewer.play
    viewer.key(pygame.K_h)
    viewer.key(pygame.K_ESCAPE)
    assert isinstance(viewer.scene, Replay) and not viewer.replay.state.why
    viewer.key(pygame.K_ESCAPE)
    assert isinstance(viewer.scene, Play)


def test_the_button_is_there_where_it_is_known_why(viewer: Viewer) -> None:
    screen, state = viewer.replay.stage.screen, viewer.replay.state
    place = replay_view.button("why", screen).center
    assert replay_view.under(place, screen, state) == "why"
    viewer.move(place)
    viewer.press()
    viewer.release()
    assert state.why
    viewer.key(pygame.K_PAGEDOWN)
    assert replay_view.under(place, screen, state) == ""
    # It goes on being told of the strokes that come.
    assert said(viewer) == [("", "Nobody has told why.")]
    picture(viewer)


def test_that_it_can_be_asked_is_said_before_the_stroke_and_after_it(viewer: Viewer) -> None:
    words, state = viewer.app.words, viewer.replay.state
    viewer.key(pygame.K_SPACE)
    for key in (pygame.K_HOME, pygame.K_END):
        viewer.key(key)
        assert "H: why this shot?" in replay_view.caption(words, state)[0]
    viewer.key(pygame.K_PAGEDOWN)
    assert "why" not in replay_view.caption(words, state)[0]


def test_another_key_may_be_bound(viewer: Viewer) -> None:
    viewer.app.words.keys.bind("why", pygame.K_F10)
    viewer.key(pygame.K_h)
    assert not viewer.replay.state.why
    viewer.key(pygame.K_F10)
    assert viewer.replay.state.why


def test_it_is_told_in_german(viewer: Viewer) -> None:
    viewer.key(pygame.K_h)
    viewer.app.words.speak("de")
    told = said(viewer)
    assert told[0] == ("Gemeint", "Anstoß, Kugel 1, 8,20 m/s ohne Effet")
    assert ("Gefürchtet", "10 %: Bob hatte danach einen guten Stoß.") in told
    picture(viewer)


@pytest.mark.parametrize("size", [(320, 240), (960, 540), (1920, 1080), (500, 900)])
def test_the_panel_lies_within_the_table_and_clear_of_most_of_what_it_is_about(size: tuple[int, int]) -> None:
    screen = Screen(*size)
    room = pygame.Rect(screen.table)
    for corner in (room.topright, room.topleft, room.bottomright):
        near = [(corner[0] + (-20 if corner[0] else 20), corner[1] + (20 if corner[1] < 100 else -20))]
        box = why_panel.place(screen, 9, near * 5)
        assert room.contains(box)
        if size[0] > 900:
            assert not box.collidepoint(near[0])


def test_a_record_that_tells_of_strokes_that_cannot_be_played_is_shown_nonetheless(tmp_path: Path) -> None:
    wrong = Thought("pot", Shot(0.0, 2.0, ball="99"), "98", "nowhere", place=(50.0, 50.0))
    match = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0, seed=3))
    with record(match, tmp_path / "a.jsonl") as recorder:
        recorder.play(Stroke(Shot(0.25, 8.0), why=Reasons(wrong, (wrong,))))
    viewer = Viewer(tmp_path / "a.jsonl")
    viewer.key(pygame.K_h)
    picture(viewer)
    assert said(viewer)[0][1].startswith("Pot, the 98, nowhere pocket")
    viewer.app.close()


def test_a_stroke_by_a_person_has_no_reasons() -> None:
    words, match = Words(), Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    lines = why_panel.lines(words, Screen(960, 540), match, match.now, Stroke(Shot(0.0, 2.0)))
    assert [line for _, _, line in lines] == ["Nobody has told why."]
    assert isinstance(match.layout, Layout) and isinstance(match.layout["cue"], Ball)
