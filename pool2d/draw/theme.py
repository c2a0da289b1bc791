"""Colours and measures of the whole screen, in one place."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache

Color = tuple[int, int, int] | tuple[int, int, int, int]

BACKGROUND = (13, 14, 16)
PANEL = (16, 18, 20, 235)
FACE = (30, 33, 35)
FACE_LIT = (46, 50, 52)
FACE_DOWN = (20, 22, 24)
SELECTED = (92, 78, 52)
VEIL = (6, 7, 8, 190)
EDGE = (56, 58, 60)
TEXT = (236, 232, 224)
QUIET = (160, 158, 152)
ACCENT = (214, 176, 106)
ACCENT_FAINT: Color = (214, 176, 106, 120)
ACCENT_LIT = (232, 200, 138)
ACCENT_DOWN = (176, 142, 80)
WARNING = (232, 122, 98)

CLOTH = (32, 138, 116)
HOLE = (6, 6, 7)

IVORY = (244, 240, 228)
DOT = (176, 30, 36)
CUE_SHAFT = (226, 196, 148)
CUE_TIP = (70, 132, 178)
# Where a ball in hand may be put.
AREA = (214, 176, 106, 40)
GUIDE_CUE = (196, 222, 212)
GUIDE_BALL = (238, 208, 136)
# What a shot that is aimed jumps over.
GUIDE_AIR = (255, 255, 236)
PATH_OLD = (24, 100, 84)
PATH_COMPARED = (150, 190, 240)


@dataclass(frozen=True, eq=False)
class Palette:
    """The colours of balls. It is compared by identity: there are few, and they are never copied.

    A ball has the colour that its preset gives; in any palette but STANDARD that of the nearest hue.
    """

    yellow: Color
    blue: Color
    red: Color
    purple: Color
    orange: Color
    green: Color
    maroon: Color
    black: Color
    brown: Color
    pink: Color
    white: Color = IVORY

    def color(self, wanted: str) -> Color:
        """The colour in this palette for one given as "#rrggbb"."""
        return rgb(wanted) if self is STANDARD else getattr(self, hue(wanted))


STANDARD = Palette(
    yellow=(242, 190, 26), blue=(24, 62, 178), red=(206, 28, 32), purple=(92, 36, 140), orange=(236, 106, 22),
    green=(8, 108, 62), maroon=(126, 20, 32), black=(22, 22, 25), brown=(116, 64, 30), pink=(238, 140, 160),
)  # fmt: skip
# Found by search so that those who confuse red and green tell every two colours of a set apart, and each
# from the cloth, mostly by how light and how blue they are.
COLOR_BLIND = Palette(
    yellow=(255, 245, 1), blue=(30, 56, 218), red=(170, 0, 13), purple=(134, 142, 221), orange=(225, 139, 0),
    green=(119, 177, 116), maroon=(70, 0, 77), black=(4, 9, 5), brown=(92, 50, 85), pink=(221, 114, 218),
)  # fmt: skip
# As bright and as full as the screen allows.
HIGH_CONTRAST = Palette(
    yellow=(255, 230, 0), blue=(0, 60, 255), red=(240, 0, 0), purple=(180, 70, 255), orange=(255, 130, 0),
    green=(0, 190, 0), maroon=(120, 0, 40), black=(0, 0, 0), brown=(130, 80, 20), pink=(255, 150, 200),
    white=(255, 255, 255),
)  # fmt: skip
PALETTES = {"standard": STANDARD, "colour-blind": COLOR_BLIND, "high contrast": HIGH_CONTRAST}


@dataclass(frozen=True, slots=True)
class Style:
    """How balls are drawn: their palette, and whether shapes mark the colours too."""

    palette: Palette = STANDARD
    patterned: bool = False


PLAIN = Style()


def rgb(color: str) -> tuple[int, int, int]:
    """A colour given as "#rrggbb"."""
    red, green, blue = bytes.fromhex(color[1:])
    return red, green, blue


@lru_cache(maxsize=256)
def hue(wanted: str) -> str:
    """The name of the standard colour nearest to "#rrggbb"."""
    given = rgb(wanted)

    def far(name: str) -> int:
        return sum((a - b) ** 2 for a, b in zip(given, getattr(STANDARD, name), strict=True))

    return min((field.name for field in fields(Palette)), key=far)


# Numbers 1 to 8; a stripe has the colour of the number eight less.
BALLS = {
    number: getattr(STANDARD, name)
    for number, name in enumerate(("yellow", "blue", "red", "purple", "orange", "green", "maroon", "black"), 1)
}


def unit(height: int) -> int:
    """The pitch of the grid, in pixels, that all sizes in a window of this height are counted in: 8 at 720."""
    return max(1, round(height / 90))
