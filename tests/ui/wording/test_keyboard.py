# ruff: noqa: RUF001
"""Keyboards of other layouts: keys of other alphabets go by their places, and the help shows what is on them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable

import pygame
import pytest

from pool2d.ui.dialogs.help import keys as help_lines
from pool2d.ui.wording.keyboard import PLACES, digit_of

from ..at_match import begin
from ..conftest import Hand

US = "abcdefghijklmnopqrstuvwxyz1234567890-=[]\\;'`,./"
LAYOUTS = {
    "Russian": "фисвуапршолдьтщзйкыегмцчня1234567890-=хъ\\жэёбю.",
    "Greek": "αβψδεφγηιξκλμνοπ;ρστθωςχυζ1234567890-=[]\\΄'`,./",
    "French": "qbcdefghijkl,noparstuvzxyw&é\"'(-è_çà)=^$*mù²;:!",
    "German": "abcdefghijklmnopqrstuvwxzy1234567890ß´ü+#öä^,.-",
    "Dvorak": "axje.uidchtnmbrl'poygk,qf;1234567890[]/=\\s-`wvz",
}
PLACE = {chr(us): place for place, us in PLACES.items()}

Lay = Callable[[str], None]


@pytest.fixture
def lay(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> Lay:
    """Plugs in a keyboard of a layout, as the system does."""

    def to(name: str) -> None:
        places = defaultdict(int, {ord(code): PLACE[us] for us, code in zip(US, LAYOUTS[name], strict=True)})
        monkeypatch.setattr(pygame.key, "ScancodeWrapper", lambda row: places)
        hand.post(pygame.KEYMAPCHANGED)

    return to


def press(hand: Hand, us: str, layout: str, mod: int = 0) -> None:
    """Press the key that is where a US keyboard has this one."""
    code = ord(LAYOUTS[layout][US.index(us)])
    for kind in (pygame.KEYDOWN, pygame.KEYUP):
        hand.post(kind, key=code, mod=mod, unicode="", scancode=PLACE[us])


@pytest.mark.parametrize("layout", ["Russian", "Greek"])
def test_letters_of_another_alphabet_go_by_place(hand: Hand, lay: Lay, layout: str) -> None:
    lay(layout)
    press(hand, "w", layout)
    press(hand, "d", layout)
    assert (hand.play.state.hands.aim.height, hand.play.state.hands.aim.side) == (0.05, 0.05)
    press(hand, "e", layout)
    assert hand.play.state.hands.aim.elevation == 1.0
    press(hand, "q", layout)
    assert hand.play.state.hands.aim.elevation == 0.0
    press(hand, "v", layout)
    assert hand.play.state.show.vectors


@pytest.mark.parametrize("layout", ["Russian", "Greek"])
def test_they_do_so_before_the_layout_is_known(hand: Hand, layout: str) -> None:
    press(hand, "w", layout)
    press(hand, "v", layout)
    assert hand.play.state.hands.aim.height == 0.05 and hand.play.state.show.vectors


def test_ctrl_with_another_alphabet(hand: Hand, lay: Lay) -> None:
    lay("Russian")
    hand.strike()
    press(hand, "z", "Russian", pygame.KMOD_CTRL)
    assert hand.play.state.session.strokes == 0


def test_on_a_french_keyboard_spin_is_around_the_left_hand(hand: Hand, lay: Lay) -> None:
    lay("French")
    aim = hand.play.state.hands.aim
    for us, side, height in (("w", 0.0, 0.05), ("s", 0.0, 0.0), ("a", -0.05, 0.0), ("d", 0.0, 0.0)):
        press(hand, us, "French")
        aim = hand.play.state.hands.aim
        assert (aim.side, aim.height) == pytest.approx((side, height)), us
    press(hand, "e", "French")
    assert hand.play.state.hands.aim.elevation == 1.0
    press(hand, "q", "French")
    assert hand.play.state.hands.aim.elevation == 0.0
    # All other letters mean what is written on them: M is where a US keyboard has a semicolon.
    press(hand, ";", "French")
    assert hand.app.store.values.sound.mute


def test_the_row_of_digits_presses_digits_on_a_french_keyboard(hand: Hand, lay: Lay) -> None:
    lay("French")
    session = begin(hand)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    options = session.ask.options
    assert options
    press(hand, "1", "French")
    assert session.ask.options != options


@pytest.mark.parametrize("key", [pygame.K_1, pygame.K_KP1])
def test_the_keypad_presses_what_the_digits_press(hand: Hand, key: int) -> None:
    session = begin(hand)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(1.0).toward(1.0, 0.0)
    hand.strike()
    options = session.ask.options
    hand.key(key)
    assert options and session.ask.options != options


def test_digits() -> None:
    row, pad = "1234567890", [pygame.K_KP1, pygame.K_KP2, pygame.K_KP9, pygame.K_KP0]
    assert [digit_of(ord(digit)) for digit in row] == [1, 2, 3, 4, 5, 6, 7, 8, 9, 0]
    assert [digit_of(key) for key in pad] == [1, 2, 9, 0]
    assert {digit_of(key) for key in (pygame.K_a, pygame.K_KP_PLUS, pygame.K_SLASH, pygame.K_COLON)} == {-1}


@pytest.mark.parametrize(
    ("layout", "spin", "guide", "undo"),
    [
        ("Russian", "Ц Ф Ы В", "П", "Г, Ctrl+Я"),
        ("Greek", "Σ Α Σ Δ", "Γ", "Θ, Ctrl+Ζ"),
        ("French", "Z Q S D", "G", "U, Ctrl+Z"),
        ("German", "W A S D", "G", "U, Ctrl+Z"),
        ("Dvorak", "W A S D", "G", "U, Ctrl+Z"),
    ],
)
def test_the_help_shows_the_letters_of_the_players_keyboard(
    hand: Hand, lay: Lay, layout: str, spin: str, guide: str, undo: str
) -> None:
    lay(layout)
    shown = [name for name, _ in help_lines(hand.app.words)]
    assert {spin, guide, undo} <= set(shown)
    assert hand.app.words.keys.names() == {}


def test_what_was_bound_stays_bound_on_another_keyboard(hand: Hand, lay: Lay) -> None:
    hand.app.words.keys.bind("spin_up", pygame.K_F10)
    lay("French")
    assert hand.app.words.key("spin_up") == "F10" and hand.app.words.keys.names() == {"spin_up": ["f10"]}
    hand.app.words.keys.reset("spin_up")
    assert hand.app.words.key("spin_up") == "Z" and hand.app.words.keys.names() == {}


@pytest.mark.parametrize("layout", ["German", "Dvorak"])
def test_where_a_layout_has_our_letters_they_are_what_counts(hand: Hand, lay: Lay, layout: str) -> None:
    lay(layout)
    keys = hand.app.words.keys
    for us, code in zip(US, LAYOUTS[layout], strict=True):
        if code.isascii():
            meant = keys.keyboard.meant(ord(code), PLACE[us], bound=keys.owner(ord(code)) is not None)
            assert chr(meant) == code
    # A sharp s is no minus.
    assert keys.keyboard.meant(ord("ß"), PLACE["-"], bound=False) == ord("ß")
