"""The words of the program are types, each in one place: what is made for each of them is made for all."""

from __future__ import annotations

from typing import get_args

from pool2d import load_table, simulate
from pool2d.game.actions import ActionKind, as_dict, from_dict
from pool2d.game.rules.notes import ENGLISH
from pool2d.game.rules.spotting import AREAS, Where
from pool2d.physics.values import EventKind, Phase, Shot
from pool2d.sound.impacts import SoundKind
from pool2d.sound.synth import KINDS
from pool2d.ui.stage.timeline import COLORS
from pool2d.ui.wording import words


def test_every_kind_of_event_has_its_words_and_contacts_their_colour() -> None:
    texts = words.catalogue("en").texts
    assert [kind for kind in get_args(EventKind) if f"event.{kind}" not in texts] == []
    assert set(COLORS) <= set(get_args(EventKind))


def test_every_sound_can_be_made() -> None:
    assert tuple(KINDS) == get_args(SoundKind)


def test_every_area_is_told() -> None:
    assert {"", *AREAS} == set(get_args(Where))
    assert all(f"in-hand.{area}" in ENGLISH for area in AREAS)


def test_a_rollout_speaks_in_these_words_alone() -> None:
    table = load_table("pool-9ft")
    rollout = simulate(table, table.rack("nine-ball", 1), Shot(0.0, 8.0, side=0.3))
    assert {event.kind for event in rollout.events} <= set(get_args(EventKind))
    assert {ball.phase for event in rollout.events for ball in event.after.values()} <= set(get_args(Phase))


def test_records_name_every_action_as_it_is_read() -> None:
    lines = (
        {"do": "stroke", "shot": "cue:0,1"}, {"do": "choose", "key": "play"}, {"do": "concede", "player": 1},
        {"do": "stalemate"}, {"do": "next"}, {"do": "arrange", "position": ""},
    )  # fmt: skip
    assert {line["do"] for line in lines} == set(get_args(ActionKind))
    assert [as_dict(from_dict(line, "test"))["do"] for line in lines] == [line["do"] for line in lines]
