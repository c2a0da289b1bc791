"""A recorded match on the screen: shot after shot, by mouse and by keyboard."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pygame
import pytest

from benchmarks.random_play import new_match
from pool2d import InputError, load_table
from pool2d.cli import main
from pool2d.config.folders import data_folder
from pool2d.draw import text
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.records.record import load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import record
from pool2d.game.rules.report import Call
from pool2d.game.setup import Setup
from pool2d.physics.values import Shot
from pool2d.ui import start
from pool2d.ui.app import App
from pool2d.ui.dialogs.pick import Pick
from pool2d.ui.frame import Frame
from pool2d.ui.replay import replay_view
from pool2d.ui.replay.record_list import RecordList, open_replays
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.replay.replay_state import PAUSE
from pool2d.ui.scene import Scene
from pool2d.ui.widgets.list_row import ListRow
from pool2d.ui.widgets.widget import Heading
from pool2d.ui.wording.words import Words

from .conftest import FRAME, Hand


def write(path: Path) -> Path:
    """A match of four strokes, of which the second was taken back."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with record(new_match("nine-ball", 3), path) as recorder:
        for speed in (0.2, 0.3):
            recorder.play(Stroke(Shot(180.0, speed)))
            if recorder.match.ask.kind == "place":
                recorder.undo()
        recorder.undo()
        recorder.play(Stroke(Shot(0.0, 4.0)))
        recorder.play(Stroke(Shot(90.0, 0.4)))
    return path


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    return write(tmp_path / "a.jsonl")


class Viewer(Hand):
    """A person who looks at a record."""

    def __init__(self, path: Path) -> None:
        shots = RecordedShots(load(path))
        app = App(shots[0].match.table, seed=1)
        pygame.event.clear()
        self.replay = Replay(shots, app.words, None, app.store, app.sounds)
        app.scene = self.replay
        super().__init__(app)

    @property
    def scene(self) -> object:
        return self.app.scene

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds / FRAME)):
            self.app.step(FRAME)


@pytest.fixture
def viewer(recorded: Path) -> Iterator[Viewer]:
    viewer = Viewer(recorded)
    yield viewer
    viewer.app.close()


def test_a_match_plays_by_itself_to_its_end_and_stays(viewer: Viewer) -> None:
    replay, seen = viewer.replay, []
    for _ in range(4000):
        seen.append(replay.state.at)
        viewer.app.step(FRAME)
        if replay.still:
            break
    assert list(dict.fromkeys(seen)) == [0, 1, 2, 3]
    assert replay.state.playback.ended
    assert viewer.scene is replay


@pytest.mark.parametrize("later", [pygame.K_PAGEDOWN, pygame.K_DOWN, pygame.K_n])
@pytest.mark.parametrize("earlier", [pygame.K_PAGEUP, pygame.K_UP])
def test_keys_go_from_shot_to_shot_and_no_further(viewer: Viewer, later: int, earlier: int) -> None:
    for expected in (1, 2, 3, 3):
        viewer.key(later)
        assert viewer.replay.state.at == expected
        assert viewer.replay.state.playback.time < 0.1
    for expected in (2, 1, 0, 0):
        viewer.key(earlier)
        assert viewer.replay.state.at == expected


def test_buttons_do_what_keys_do(viewer: Viewer) -> None:
    screen = viewer.replay.stage.screen
    for action, expected in (("later", 1), ("later", 2), ("earlier", 1)):
        viewer.move(replay_view.button(action, screen).center)
        viewer.press()
        viewer.release()
        assert viewer.replay.state.at == expected


def test_a_shot_that_is_held_or_brought_to_its_end_stays(viewer: Viewer) -> None:
    viewer.key(pygame.K_SPACE)
    viewer.wait(2.0 * PAUSE)
    assert (viewer.replay.state.at, viewer.replay.state.playback.paused) == (0, True)
    viewer.key(pygame.K_END)
    viewer.wait(2.0 * PAUSE)
    assert viewer.replay.state.at == 0
    viewer.key(pygame.K_SPACE)
    viewer.wait(viewer.replay.state.playback.end + PAUSE + 0.2)
    assert viewer.replay.state.at == 1


def test_the_time_line_is_dragged_and_the_rate_is_kept_for_the_next_shot(viewer: Viewer) -> None:
    viewer.key(pygame.K_COMMA)
    line = viewer.replay.timeline.track
    viewer.move((line.left + line.width / 2, line.centery))
    viewer.press()
    viewer.release()
    shown = viewer.replay.state.playback
    assert shown.time == pytest.approx(shown.end / 2, rel=0.01)
    viewer.key(pygame.K_PAGEDOWN)
    assert viewer.replay.state.playback.rate == 0.5
    assert not viewer.replay.state.playback.paused


def test_the_list_leads_to_a_shot_by_keys_and_by_mouse(viewer: Viewer) -> None:
    viewer.key(pygame.K_g)
    pick = viewer.scene
    assert isinstance(pick, Pick)
    assert [name[0] for name in pick.names] == ["1", "2", "3", "4"]
    viewer.key(pygame.K_DOWN)
    viewer.key(pygame.K_DOWN)
    viewer.key(pygame.K_RETURN)
    assert viewer.scene is viewer.replay
    assert viewer.replay.state.at == 2
    viewer.move(replay_view.button("list", viewer.replay.stage.screen).center)
    viewer.press()
    viewer.release()
    again = viewer.scene
    assert isinstance(again, Pick)
    viewer.key(pygame.K_ESCAPE)
    assert viewer.scene is viewer.replay
    assert viewer.replay.state.at == 2


def test_what_came_of_a_shot_is_told_at_its_end(viewer: Viewer) -> None:
    assert replay_view.caption(viewer.app.words, viewer.replay.state) == ("", False)
    viewer.key(pygame.K_END)
    assert "hit no ball" in replay_view.caption(viewer.app.words, viewer.replay.state)[0]
    viewer.key(pygame.K_PAGEDOWN)
    viewer.key(pygame.K_END)
    assert "taken back" in replay_view.caption(viewer.app.words, viewer.replay.state)[0]


def test_a_call_is_told_in_words(tmp_path: Path) -> None:
    with record(Match(load_table("snooker-12ft"), Setup("snooker", breaker=0)), tmp_path / "s.jsonl") as recorder:
        recorder.play(Stroke(Shot(0.0, 2.0), Call(ball="red7")))
        recorder.play(Stroke(Shot(0.0, 2.0)))
    first, second = RecordedShots(load(recorder.path)).played[0], RecordedShots(load(recorder.path))[1]
    assert replay_view.called(Words(), first) == ["Player 1 calls red 7."]
    assert replay_view.called(Words(), second) == []


def test_the_score_is_the_one_of_the_moment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "s.jsonl"
    with record(Match(load_table("snooker-12ft"), Setup("snooker", breaker=0)), path) as recorder:
        recorder.play(Stroke(Shot(180.0, 0.5)))
    told: list[str] = []
    real = text.draw

    def note(surface: pygame.Surface, words: str, *more: object) -> pygame.Rect:
        told.append(words)
        return real(surface, words, *more)  # type: ignore[arg-type]

    monkeypatch.setattr(text, "draw", note)
    viewer = Viewer(path)
    assert "4" not in told and told.count("0") >= 2
    told.clear()
    viewer.key(pygame.K_END)
    # The cue ball hit nothing: four points for the other, once the shot has come to its end.
    assert "4" in told and "0" in told
    viewer.app.close()


def test_other_keys_open_help_and_options_and_come_back_to_the_same_moment(viewer: Viewer) -> None:
    viewer.wait(0.5)
    for key in (pygame.K_F1, pygame.K_o):
        at = viewer.replay.state.playback.time
        viewer.key(key)
        assert viewer.scene is not viewer.replay
        viewer.wait(0.5)
        viewer.key(pygame.K_ESCAPE)
        assert viewer.scene is viewer.replay
        assert viewer.replay.state.playback.time == at
    viewer.key(pygame.K_v)
    assert viewer.replay.state.show.vectors


def test_esc_closes_the_window_or_goes_to_the_scene_below(viewer: Viewer) -> None:
    viewer.replay.below = viewer.play
    viewer.key(pygame.K_ESCAPE)
    assert viewer.scene is viewer.play
    viewer.app.scene = viewer.replay
    viewer.replay.below = None
    viewer.replay.state.go(0)
    viewer.post(pygame.KEYDOWN, key=pygame.K_ESCAPE, mod=0, unicode="")
    assert not viewer.open


def test_records_are_offered_the_latest_first_and_damage_is_told(hand: Hand) -> None:
    folder = data_folder() / "matches"
    write(folder / "2001-02-03 nine-ball.jsonl")
    (folder / "2002-02-03 nine-ball.jsonl").write_text("no record\n")
    os.utime(folder / "2001-02-03 nine-ball.jsonl", (1, 1))
    hand.app.scene = shelf = open_replays(hand.play, hand.app.store, hand.app.sounds)
    assert isinstance(shelf, RecordList)
    lines = [line for line in shelf.form.widgets if isinstance(line, ListRow)]
    assert "2002-02-03 nine-ball" in lines[0].label and "not a record" in lines[0].below
    assert "Player 1" in lines[1].label and lines[1].note == "Nine-ball"
    hand.key(pygame.K_RETURN)
    assert "not a record" in shelf.wrong
    hand.key(pygame.K_DOWN)
    hand.key(pygame.K_RETURN)
    shown = hand.app.scene
    assert isinstance(shown, Replay)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is shown.below is hand.play


def test_a_record_that_no_longer_plays_is_shown_as_far_as_it_does(recorded: Path) -> None:
    kept = load(recorded)
    broken = [entry._replace(data={**entry.data, "shot": "1:0.0,1.0"}) if entry.line == 6 else entry
              for entry in kept.entries]  # fmt: skip
    shots = RecordedShots(replace(kept, entries=tuple(broken)))
    assert len(shots) == 4
    assert shots[3].number == len(shots) == 3
    assert shots.fault is not None
    assert shots.fault.line == 6


def test_a_shot_that_rolls_otherwise_than_recorded_is_told(recorded: Path) -> None:
    kept = load(recorded)
    kept.entries[0].data["digest"] = "0"
    assert [take.same for take in map(RecordedShots(kept).__getitem__, range(4))] == [False, True, True, True]


def test_the_command_shows_a_record(recorded: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[Scene] = []
    real = App._draw

    def draw(app: App, scene: Scene) -> None:
        drawn.append(scene)
        real(app, scene)

    monkeypatch.setattr(App, "_draw", draw)
    assert start.replay(recorded, 3, frames=3) == 0
    assert len(drawn) == 3
    for scene in drawn:
        assert isinstance(scene, Replay) and scene.state.at == 2
    with pytest.raises(InputError, match="allowed is 1 to 4"):
        start.replay(recorded, 5, frames=3)


def test_without_a_screen_the_command_says_so(
    recorded: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("SDL_VIDEODRIVER")
    monkeypatch.setattr(pygame.display, "get_driver", lambda: "offscreen")
    monkeypatch.setattr(start, "open_window", lambda size, full: pygame.Surface(size))
    assert main(["replay", str(recorded)]) == 2
    assert "display: no screen was found" in capsys.readouterr().err


def test_the_list_of_records_says_so_where_there_are_none(hand: Hand) -> None:
    def heading() -> str:
        shelf = open_replays(hand.play, hand.app.store, hand.app.sounds)
        assert isinstance(shelf, RecordList)
        told = next(widget for widget in shelf.form.widgets if isinstance(widget, Heading))
        return told.words()

    assert heading() == "No match has been recorded yet"
    write(data_folder() / "matches" / "2001-02-03 nine-ball.jsonl")
    assert heading() == "Matches that were recorded"


def test_b_shows_the_geometry_of_the_table_over_a_replay(viewer: Viewer) -> None:
    viewer.key(pygame.K_SPACE)

    def picture() -> bytes:
        viewer.replay.draw(Frame(viewer.app.window.surface))
        return pygame.image.tobytes(viewer.app.window.surface, "RGB")

    viewer.move((2, 300))
    plain = picture()
    assert picture() == plain
    viewer.key(pygame.K_b)
    assert picture() != plain
    viewer.key(pygame.K_b)
    assert picture() == plain
