"""What tests of players in the window have in common: one who decides quickly, and within the test's own process."""

from __future__ import annotations

from typing import ClassVar

import pytest

from pool2d import Table, load_table
from pool2d.config.folders import data_folder
from pool2d.game.match import Match, lagged
from pool2d.game.rules import Ruling
from pool2d.game.session import Session, recorded
from pool2d.game.setup import Setup
from pool2d.opponent.deciding import Decision, decide
from pool2d.opponent.player import Player
from pool2d.opponent.thinker import ThinkerError
from pool2d.ui.play.modes import opponent_mode
from pool2d.ui.play.modes.opponent_mode import OpponentMode

from ..conftest import FRAME, Hand

_QUICK = """
name = "Quick"
title = "C"
rank = 1
words.en = "Plays what is nearest."

[judgement]
ways = 1
paces = 1
heights = 1
sides = 1
few = 2
runs = 0
safeties = 2
kicks = 8
banks = 0
"""


class Here:
    """Thinks as a `Thinker` does, but in this process.

    `ready` is whether there is an answer, `fails` how often asking comes to nothing.
    """

    made: ClassVar[list[Here]] = []
    ready: ClassVar[bool] = True
    fails: ClassVar[int] = 0

    def __init__(self, table: Table, setup: Setup) -> None:
        self.match = Match(table, setup)
        self.asked: list[tuple[Ruling, Player, str]] = []
        self.closed = False
        self.made.append(self)

    def ask(self, ruling: Ruling, player: Player, seed: str) -> None:
        assert not self.closed
        self.asked.append((ruling, player, seed))

    def answer(self) -> Decision | None:
        if Here.fails:
            Here.fails -= 1
            raise ThinkerError("it has ended")
        ruling, player, seed = self.asked[-1]
        return decide(self.match.rules_of(lagged(ruling.state)), ruling, player, seed) if Here.ready else None

    def close(self) -> None:
        self.closed = True


def sit_down(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have a player called quick, who thinks in this process."""
    folder = data_folder() / "players"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "quick.toml").write_text(_QUICK, encoding="utf-8")
    monkeypatch.setattr(opponent_mode, "Thinker", Here)
    monkeypatch.setattr(Here, "made", [])
    monkeypatch.setattr(Here, "ready", True)
    monkeypatch.setattr(Here, "fails", 0)


def play_against(
    hand: Hand, *players: str, game: str = "nine-ball", table: str = "pool-9ft", breaker: int = 1, **more: object
) -> Session:  # fmt: skip
    """Begin a match in the window, by default of Ann against the player that is named second, who breaks."""
    setup = Setup(game, names=("Ann", "Quick"), breaker=breaker, seed=4, players=players, **more)  # type: ignore[arg-type]
    session = recorded(load_table(table), setup)
    hand.app.scene = hand.app.lobby.begin(session)
    hand.app.redraw()
    hand.app.step(0.0)
    return session


def mode(hand: Hand) -> OpponentMode:
    found = hand.play.state.mode
    assert isinstance(found, OpponentMode)
    return found


def frames(hand: Hand, seconds: float) -> None:
    """Let so much time pass."""
    for _ in range(round(seconds / FRAME)):
        hand.app.step(FRAME)


def until_played(hand: Hand, strokes: int = 1) -> None:
    """Let time pass until so many more strokes have been played, and their balls rest."""
    match = hand.play.state.session.match
    count = sum(moment.rollout is not None for moment in match.history) + strokes
    for _ in range(20_000):
        hand.app.step(FRAME)
        if hand.play.state.playback is None and count <= sum(moment.rollout is not None for moment in match.history):
            return
        if hand.play.state.playback is not None:
            hand.play.state.playback.leave()
    raise AssertionError("nothing is played")
