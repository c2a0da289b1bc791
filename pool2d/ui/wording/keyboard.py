"""The player's keyboard: what its keys give, and which key is meant where a layout has no Latin letters."""

from __future__ import annotations

import unicodedata
from typing import Any

import pygame

# The keys that give letters, digits and signs, by their places: the key of a US keyboard that is there.
_SIGNS = {
    pygame.KSCAN_MINUS: pygame.K_MINUS, pygame.KSCAN_EQUALS: pygame.K_EQUALS,
    pygame.KSCAN_LEFTBRACKET: pygame.K_LEFTBRACKET, pygame.KSCAN_RIGHTBRACKET: pygame.K_RIGHTBRACKET,
    pygame.KSCAN_BACKSLASH: pygame.K_BACKSLASH, pygame.KSCAN_SEMICOLON: pygame.K_SEMICOLON,
    pygame.KSCAN_APOSTROPHE: pygame.K_QUOTE, pygame.KSCAN_GRAVE: pygame.K_BACKQUOTE,
    pygame.KSCAN_COMMA: pygame.K_COMMA, pygame.KSCAN_PERIOD: pygame.K_PERIOD, pygame.KSCAN_SLASH: pygame.K_SLASH,
}  # fmt: skip
_LETTERS = {pygame.KSCAN_A + i: pygame.K_a + i for i in range(26)}
_DIGITS = {pygame.KSCAN_1 + i: ord(digit) for i, digit in enumerate("1234567890")}
PLACES: dict[int, int] = {**_LETTERS, **_DIGITS, **_SIGNS}
_KEYPAD = {getattr(pygame, f"K_KP{digit}"): digit for digit in range(10)}
# The letters of alphabets lie below this code.
_ALPHABETS = 0x1100


class Keyboard:
    """`codes` is what the keys give at present, by the US keys in their places."""

    def __init__(self) -> None:
        self.codes = {us: us for us in PLACES.values()}

    def read(self) -> None:
        """Take the layout that the system has now; there has to be a window."""
        # pygame looks a key's state up by its place; asked in a row of the places themselves, it tells the place.
        row: Any = range(512)
        places: Any = pygame.key.ScancodeWrapper(row)
        found = {places[code]: code for code in range(ord(" "), _ALPHABETS)}
        self.codes = {us: found.get(place, us) for place, us in PLACES.items()}

    @property
    def latin(self) -> bool:
        """Whether there are keys that give Latin letters."""
        return any(pygame.K_a <= code <= pygame.K_z for code in self.codes.values())

    def saw(self, key: int, place: int) -> bool:
        """Take note of what a key gives; whether that is news."""
        us = PLACES.get(place)
        if us is None or not ord(" ") < key < _ALPHABETS or self.codes[us] == key:
            return False
        self.codes[us] = key
        return True

    def meant(self, key: int, place: int, bound: bool) -> int:
        """The key that is meant by one that gives `key`, at a place; `bound` where it has a meaning of its own.

        That is the key itself, but where it gives none of ours the one that a US keyboard has in its place: a letter
        of another alphabet, and what stands in the row of the digits of a French keyboard.
        """
        us = PLACES.get(place)
        if us is None or (bound and self.latin):
            return key
        strange = not (_is_latin(key) or key < 128)
        digit = chr(us).isdigit() and not chr(key).isdigit()
        return us if strange or digit or not self.latin else key

    def given(self, key: int) -> int:
        """What the player's keyboard gives where a key is meant by its place; elsewhere the key itself."""
        return key if self.latin else self.codes.get(key, key)


def digit_of(key: int) -> int:
    """The digit that a key presses, of the upper row or of the keypad; -1 where it is none."""
    return key - pygame.K_0 if pygame.K_0 <= key <= pygame.K_9 else _KEYPAD.get(key, -1)


def _is_latin(key: int) -> bool:
    return key < _ALPHABETS and unicodedata.name(chr(key), "").startswith("LATIN")
