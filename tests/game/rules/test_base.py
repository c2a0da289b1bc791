"""What holds of every game: states are values, choices are checked, a table is asked what it has."""

from __future__ import annotations

import json
from pathlib import Path
from typing import ClassVar

import pytest

from pool2d import InputError, load_table, opponent
from pool2d.game import rules
from pool2d.game.rules import GAMES, PLACE, Choice, game, games_for
from pool2d.game.rules.notes import ENGLISH, Note, label, say
from pool2d.game.rules.pool.nine_ball import NineBall

from .notation import after, only, report

TABLE = load_table("pool-9ft")


def test_every_file_of_a_family_with_a_title_is_a_game() -> None:
    families = Path(rules.__file__).parent
    titled = [path for path in families.glob("*/*.py") if "\n    title = " in path.read_text(encoding="utf-8")]
    assert {path.stem.replace("_", "-") for path in titled} | {"practice"} == set(GAMES)
    assert [one.name for one in GAMES.values()] == list(GAMES)


def test_games_are_listed_by_rank() -> None:
    assert list(GAMES)[:3] == ["eight-ball", "nine-ball", "ten-ball"]
    assert list(GAMES)[-1] == "practice"


@pytest.mark.parametrize("name", GAMES)
def test_a_state_comes_back_from_json(name: str) -> None:
    tables = [load_table(table) for table in ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft")]
    rules = game(name, next(table for table in tables if name in games_for(table)))
    state = rules.start(breaker=rules.players - 1, seed=3).state
    assert rules.state(json.loads(json.dumps(state.as_dict()))) == state


def test_a_state_with_a_strange_key_is_refused() -> None:
    with pytest.raises(InputError, match="did you mean turn"):
        game("practice", TABLE).state({"tunr": 1})


def test_an_unknown_game_is_refused() -> None:
    with pytest.raises(InputError, match="unknown; did you mean practice"):
        game("practise", TABLE)


def test_an_unknown_option_is_refused() -> None:
    with pytest.raises(InputError, match="speed"):
        game("practice", TABLE, {"speed": 1})


def test_a_table_has_games_that_its_balls_allow() -> None:
    assert {"eight-ball", "nine-ball", "straight", "practice"} <= set(games_for(TABLE))
    assert "eight-ball" not in games_for(load_table("english-7ft"))
    with pytest.raises(InputError, match=r"nine-ball.*this table has not the balls or the rack for it"):
        game("nine-ball", load_table("snooker-12ft"))


class OwnRack(NineBall):
    """Nine-ball with three balls, from a rack that no table has."""

    name = "own-rack"
    racks = ("three balls",)
    rack: ClassVar = {"spot": "foot", "balls": ["1", "2", "9"], "rows": [["1"], ["any", "any"]]}


def test_a_game_may_bring_a_rack_of_its_own() -> None:
    layout = OwnRack(TABLE).start(seed=3).layout
    assert set(layout) == {"cue", "1", "2", "9"}
    assert (layout["1"].x, layout["1"].y) == pytest.approx(TABLE.furniture.spots["foot"])
    assert {OwnRack(TABLE).start(seed=seed).layout["9"].y > layout["1"].y for seed in range(20)} == {True, False}
    assert OwnRack(TABLE).start(seed=3).layout == layout


def test_a_rack_of_its_own_needs_its_balls_and_its_spot() -> None:
    assert not OwnRack.fits(load_table("snooker-12ft"))
    with pytest.raises(InputError, match=r"own-rack.*this table has not the balls or the rack for it"):
        OwnRack(load_table("carom-10ft"))


def test_a_choice_that_is_not_asked_for_is_refused() -> None:
    ruling = game("practice", TABLE).start()
    with pytest.raises(InputError, match="allowed is place"):
        game("practice", TABLE).choose(ruling.state, ruling.layout, Choice("re-rack"))


def test_practice_places_and_counts() -> None:
    rules = game("practice", TABLE)
    ruling = rules.start()
    shot = report("cue-1 1> cue>")
    ruling = rules.judge(ruling.state, after(ruling.layout, shot), shot)
    assert (ruling.ask.kind, ruling.points, ruling.state.scores) == (PLACE, (1,), (1,))
    with pytest.raises(InputError, match="allowed is anywhere on the table, clear of other balls"):
        rules.choose(ruling.state, ruling.layout, Choice("place", 1.905 + 0.0577 * 3, 0.635))
    ruling = rules.choose(ruling.state, ruling.layout, Choice("place", 0.4, 0.4))
    assert (ruling.layout["cue"].x, ruling.layout["cue"].y) == (0.4, 0.4)
    assert ruling.ask.kind == "aim"
    shot = report("cue-2 2>")
    ruling = rules.judge(ruling.state, after(only(ruling.layout, "2"), shot), shot)
    # A table that is cleared stays so: whoever practises one shot does not want fifteen balls.
    assert [ball.id for ball in ruling.layout.on_table()] == ["cue"]
    assert (ruling.ask.kind, ruling.ask.on) == ("aim", ())


def test_a_note_is_a_sentence() -> None:
    assert say(Note("foul.wrong-ball", ball="red7")) == "The red was hit first, and it was not on."
    assert say(Note("in-hand.kitchen", 1), ("Ann", "Bob")) == "Bob has the cue ball in hand, behind the head string."


@pytest.mark.parametrize("key", ENGLISH)
def test_every_word_is_used_and_has_no_gap_left(key: str) -> None:
    rooms = (Path(room.__path__[0]) for room in (rules, opponent))
    sources = "".join(path.read_text(encoding="utf-8") for room in rooms for path in room.rglob("*.py"))
    name = key.removeprefix("choice.")
    stem = name.rpartition(".")[0]
    assert f'"{name}' in sources.replace(f'"{key}":', "") or f'f"{stem}.{{' in sources
    text = label(f"{name}:x") if key.startswith("choice.") else say(Note(key, 0, "1", 2))
    assert "{" not in text


@pytest.mark.parametrize("name", GAMES)
def test_nobody_begins_with_a_foul_or_a_point(name: str) -> None:
    tables = [load_table(table) for table in ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft")]
    rules = game(name, next(table for table in tables if name in games_for(table)))
    state = rules.start().state
    assert (set(state.fouls), set(state.scores), state.shots) == ({0}, {0}, 0)
    assert rules.state_type().fouls == (0, 0)


def test_a_state_that_lacks_something_is_refused_in_one_line() -> None:
    with pytest.raises(InputError, match=r"^state of practice: .*missing.*'who'") as refused:
        game("practice", TABLE).state({"ask": {"kind": "aim"}})
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("name", GAMES)
def test_what_a_state_does_not_tell_is_as_it_is_at_first(name: str) -> None:
    """As in a record of before a game told it."""
    tables = [load_table(table) for table in ("pool-9ft", "snooker-12ft", "carom-10ft", "english-7ft", "pyramid-12ft")]
    rules = game(name, next(table for table in tables if name in games_for(table)))
    assert rules.state({}) == rules.state_type()
    told = rules.state({"turn": 1, "seed": 7, "ask": {"kind": "choose", "who": 1, "options": ["pass"]}})
    assert (told.turn, told.seed, told.shots, told.ask.kind, told.ask.player) == (1, 7, 0, "choose", 1)
    assert (told.ask.ball, told.ask.where, told.ask.on, told.ask.options) == ("", "", (), ("pass",))
