"""A table's state alone: no window, no event, nothing drawn."""

from __future__ import annotations

import pytest

from pool2d import Ball, Layout, load_table
from pool2d.game.session import practice, recorded
from pool2d.game.setup import Setup
from pool2d.sound.mixer import Sounds
from pool2d.ui.play.messages import Message, Messages
from pool2d.ui.play.modes.match_mode import MatchMode
from pool2d.ui.play.modes.mode_choice import mode_of
from pool2d.ui.play.modes.practice_mode import PracticeMode
from pool2d.ui.play.state import PlayState
from pool2d.ui.scene import Wish
from pool2d.ui.wording.words import Words

TABLE = load_table("pool-9ft")


@pytest.fixture
def state() -> PlayState:
    made = PlayState(practice(TABLE, seed=3), Words(), Sounds(), mode_of)
    made.arrange(Layout([Ball("cue", 0.6, 0.6), Ball("1", 0.3, 0.3)]))
    return made


def test_a_stroke_runs_to_its_rest_and_is_told(state: PlayState) -> None:
    state.hands.aim = state.hands.aim.toward(-1.0, -1.0)
    assert state.titles[1].endswith("1 ball left")
    state.strike(3.0)
    assert state.playback is not None and state.messages.text == ""
    before = state.titles[1]
    seen = {before}
    while state.update(0.05) is None:
        seen.add(state.titles[1])
    assert state.gone == ("1",) and before.endswith("1 ball left")
    assert {title.endswith("0 balls left") for title in seen} == {True, False}, (
        "the ball is gone once it was seen to be"
    )
    assert state.playback is None and state.wish is Wish.ENDED and state.messages.text


def test_the_mode_goes_with_the_session(state: PlayState) -> None:
    assert isinstance(state.mode, PracticeMode) and state.may_arrange()
    state.begin(recorded(TABLE, Setup("nine-ball", names=("Ann", "Bob"), race=3, breaker=0, seed=11)))
    assert isinstance(state.mode, MatchMode)
    told = state.messages.text
    assert "Ann breaks" in told
    state.rack()
    assert state.messages.text != told
    for _ in range(10):
        state.update(0.5)
    assert state.messages.text == told
    state.session.leave()


def test_what_stands_comes_back_once_another_message_has_been_read() -> None:
    standing: list[Message] = []
    messages = Messages(lambda: standing[-1] if standing else None)
    messages.say("no more room")
    messages.update(60.0)
    assert messages.text == "no more room" and messages.settled
    standing.append(lambda: "Bob is next")
    assert not messages.settled
    messages.update(60.0)
    assert messages.text == "Bob is next" and messages.settled
    messages.say("a word")
    messages.update(1.0)
    assert messages.text == "a word" and not messages.settled
    messages.clear()
    assert messages.text == "Bob is next"
