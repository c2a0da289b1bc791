"""Keys: what is bound, by whom, and how it is told and kept."""

from __future__ import annotations

import pygame
import pytest

from pool2d.ui.wording.keys import CTRL, DEFAULTS, Keymap, may_be_bound
from pool2d.ui.wording.words import Words

from ..conftest import Hand


@pytest.fixture
def keymap(hand: Hand) -> Keymap:
    """Keys have names only while there is a window."""
    return Keymap()


def test_ctrl_means_another_action_only_where_one_is_bound(keymap: Keymap) -> None:
    assert keymap.action_of(pygame.K_z, pygame.KMOD_CTRL) == "undo"
    assert keymap.action_of(pygame.K_z, 0) is None
    assert keymap.action_of(pygame.K_LEFT, pygame.KMOD_LCTRL) == "turn_left"
    assert keymap.action_of(pygame.K_q, pygame.KMOD_META) == "quit"


def test_a_key_has_one_action(keymap: Keymap) -> None:
    keymap.bind("guide", pygame.K_n)
    assert keymap.action_of(pygame.K_n, 0) == "guide"
    assert keymap.action_of(pygame.K_g, 0) is None
    assert keymap.chords["rack"] == ()
    keymap.reset("rack")
    assert keymap.action_of(pygame.K_n, 0) == "rack"
    assert keymap.chords["guide"] == ()


def test_what_is_bound_is_kept_by_name_and_read_again(keymap: Keymap) -> None:
    keymap.bind("guide", pygame.K_F10, CTRL + pygame.K_KP0)
    keymap.bind("undo", pygame.K_HOME)
    names = keymap.names()
    assert set(names) == {"guide", "undo"}
    again = Keymap()
    assert again.take({action: tuple(said) for action, said in names.items()}) == []
    assert again.chords == keymap.chords


def test_every_default_has_a_name_that_leads_back_to_it(keymap: Keymap) -> None:
    free = {action: chords for action, chords in DEFAULTS.items() if all(map(may_be_bound, chords))}
    assert free
    for action, chords in free.items():
        keymap.bind("guide", pygame.K_F9, *chords)
        names = tuple(keymap.names()["guide"])
        assert keymap.take({"guide": names}) == [], action
        assert keymap.chords["guide"] == (pygame.K_F9, *chords)


@pytest.mark.parametrize(
    "names",
    [{"guide": ("nokey",)}, {"fly": ("g",)}, {"guide": ("escape",)}, {"cancel": ("x",)}, {"guide": ("left shift",)}],
)
def test_a_wrong_entry_is_told_and_leaves_the_default(keymap: Keymap, names: dict[str, tuple[str, ...]]) -> None:
    assert keymap.take(names) == list(names)
    assert keymap.chords == DEFAULTS


def test_a_key_named_for_two_actions_is_the_first_ones(keymap: Keymap) -> None:
    assert keymap.take({"guide": ("x",), "rack": ("x",)}) == ["rack"]
    assert keymap.action_of(pygame.K_x, 0) == "guide"


def test_keys_are_told_as_people_call_them(hand: Hand) -> None:
    words = Words()
    assert words.key("undo") == "U, Ctrl+Z"
    assert words.key("strike") == "Space, Enter"
    assert words.key("turn_left", "turn_right") == "Left / Right"
    assert words.key("spin_up", "spin_left", "spin_down", "spin_right") == "W A S D"
    words.keys.bind("guide")
    assert words.key("guide") == "no key"
