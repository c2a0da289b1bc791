"""The ends of frames and matches: shown once the balls rest, with the numbers of both players."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table
from pool2d.draw import text
from pool2d.game.records.record import load
from pool2d.game.records.recorder import unfinished
from pool2d.game.session import Session, recorded
from pool2d.game.setup import Setup
from pool2d.ui.menus.ended import FrameOver, Grid, MatchOver, potting, statistics
from pool2d.ui.menus.menu import Menu
from pool2d.ui.play.play import Play
from pool2d.ui.widgets.widget import Button

from ..conftest import Hand


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))


def playing(hand: Hand, race: int, game: str = "nine-ball", table: str = "pool-9ft") -> Session:
    setup = Setup(game, names=("Ann", "Bo"), race=race, breaker=0, seed=5)
    hand.app.scene = hand.app.lobby.begin(recorded(load_table(table), setup))
    hand.app.step(0.0)
    return hand.play.state.session


def click(hand: Hand, label: str) -> None:
    scene = hand.app.scene
    assert isinstance(scene, FrameOver | MatchOver)
    button = next(w for w in scene.form.widgets if isinstance(w, Button) and w.label == label)
    hand.move(button.rect.center)
    hand.press()
    hand.release()


def shown(hand: Hand) -> object:
    return type(hand.app.scene)


def concede(hand: Hand, player: int) -> None:
    """Give a frame up, and come to what follows."""
    hand.play.state.session.concede(player)
    hand.app.scene = hand.app.lobby.ended()
    hand.app.step(0.0)


def test_between_frames_the_score_is_told_and_the_next_begins(hand: Hand) -> None:
    session = playing(hand, race=2)
    concede(hand, 1)
    assert isinstance(hand.app.scene, FrameOver)
    click(hand, "Next frame")
    assert shown(hand) is Play
    assert session.match.now.frame == 1 and session.match.frames == (1, 0)


def test_esc_shows_the_table_and_esc_again_the_end(hand: Hand) -> None:
    playing(hand, race=2)
    concede(hand, 1)
    # A key that was meant for the shot before leads nowhere.
    for key in (pygame.K_ESCAPE, pygame.K_SPACE):
        hand.key(key)
        assert isinstance(hand.app.scene, FrameOver)
    hand.app.step(0.5)
    hand.key(pygame.K_ESCAPE)
    assert hand.app.scene is hand.play
    hand.key(pygame.K_ESCAPE)
    assert isinstance(hand.app.scene, FrameOver)


def test_a_match_that_is_won_is_not_offered_again(hand: Hand) -> None:
    session = playing(hand, race=1)
    concede(hand, 0)
    assert isinstance(hand.app.scene, MatchOver)
    assert session.match.winner == 1
    assert unfinished() == []
    click(hand, "Menu")
    menu = hand.app.scene
    assert isinstance(menu, Menu)
    assert menu.items[0].entry.label() == "New match"


def test_again_is_the_same_with_another_rack(hand: Hand) -> None:
    before = playing(hand, race=1).match
    concede(hand, 0)
    click(hand, "Again")
    match = hand.play.state.session.match
    assert hand.app.scene is hand.play and match is not before and not match.over
    assert (match.setup.game, match.names, match.setup.race) == ("nine-ball", ("Ann", "Bo"), 1)
    assert match.setup.seed != before.setup.seed
    recorder = hand.play.state.session.recorder
    assert recorder is not None and load(recorder.path).setup.seed == match.setup.seed


def lay(session: Session, *balls: Ball) -> None:
    """Put the balls of a match somewhere, past the break."""
    match = session.match
    layout = Layout(balls)
    state = match.rules.start(0, 0).state
    ask = replace(state.ask, where="", on=("9",))
    ruling = match.now.ruling._replace(layout=layout, state=replace(state, shots=3, ask=ask))
    match._past[-1] = replace(match.now, ruling=ruling)


def test_the_shot_that_wins_is_seen_to_its_end_first(hand: Hand) -> None:
    session = playing(hand, race=1)
    lay(session, Ball("cue", 2.2, 0.3), Ball("9", 2.4, 0.1))
    hand.play.state.hands.aim = replace(hand.play.state.hands.aim, angle=-45.0)
    hand.key(pygame.K_SPACE)
    assert hand.app.scene is hand.play and session.match.over
    hand.wait_for_rest()
    assert isinstance(hand.app.scene, MatchOver)
    assert session.match.winner == 0
    assert potting(session.match) == [(1, 1), (0, 0)]


def test_statistics_are_those_of_the_match(hand: Hand) -> None:
    session = playing(hand, race=2)
    session.play(Shot(speed=8.0))
    tallies = session.match.now.tallies
    lines = {label: (mine, theirs) for label, mine, theirs in statistics(hand.app.words, session.match)}
    assert lines["Innings"] == ("1", "0")
    assert lines["Balls pocketed"] == (str(tallies[0].pots), "0")
    assert lines["Strokes that pocketed"][1] == "\N{EN DASH}"
    assert "Average" not in lines


@pytest.mark.parametrize(
    ("game", "table", "said"),
    [("snooker", "snooker-12ft", "Highest break"), ("three-cushion", "carom-10ft", "Highest run")],
)
def test_points_in_a_row_are_called_as_the_game_calls_them(hand: Hand, game: str, table: str, said: str) -> None:
    session = playing(hand, race=1, game=game, table=table)
    assert said in {label for label, _, _ in statistics(hand.app.words, session.match)}


def test_without_pockets_the_average_is_told(hand: Hand) -> None:
    session = playing(hand, race=1, game="straight-rail", table="carom-10ft")
    lines = {label for label, _, _ in statistics(hand.app.words, session.match)}
    assert "Average" in lines and "Balls pocketed" not in lines


def test_each_number_stands_on_the_side_of_its_player(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: dict[str, tuple[tuple[float, float], tuple[float, float]]] = {}
    real = text.draw

    def note(surface: pygame.Surface, words: str, size: int, color: object, at: Any, anchor: Any) -> pygame.Rect:
        drawn[words] = at, anchor
        return real(surface, words, size, color, at, anchor)  # type: ignore[arg-type]

    monkeypatch.setattr(text, "draw", note)
    grid = Grid([("Fouls", "3", "5"), ("Innings", "7", "8")])
    grid.rect = pygame.Rect(100, 50, 400, 80)
    grid.draw(pygame.Surface((600, 200)), 10, False, False)
    assert drawn["Fouls"] == ((300, 70.0), (0.5, 0.5))
    (mine, _), (theirs, _) = drawn["3"], drawn["5"]
    # As far from the edge on either side, on the line of what they are.
    assert mine[1] == theirs[1] == 70.0 and drawn["7"][0][1] == 110.0
    assert 100 < mine[0] < 200 and 400 < theirs[0] < 500
    assert mine[0] - 100 == 500 - theirs[0]
    assert drawn["3"][1] == drawn["5"][1] == (0.5, 0.5)
