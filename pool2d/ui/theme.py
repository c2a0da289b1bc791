"""Colours and measures of the whole screen, in one place."""

from __future__ import annotations

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
ACCENT_LIT = (232, 200, 138)
ACCENT_DOWN = (176, 142, 80)
WARNING = (232, 122, 98)

CLOTH = (32, 138, 116)
CUSHION = (22, 104, 88)
NOSE = (70, 176, 150)
WOOD = (104, 58, 34)
WOOD_EDGE = (62, 34, 20)
COLLAR = (46, 40, 38)
HOLE = (6, 6, 7)
SIGHT = (226, 220, 206)
MARK = (58, 164, 140)

IVORY = (244, 240, 228)
DOT = (176, 30, 36)
CUE_SHAFT = (226, 196, 148)
CUE_BUTT = (58, 32, 26)
CUE_TIP = (70, 132, 178)
GUIDE_CUE = (196, 222, 212)
GUIDE_BALL = (238, 208, 136)
WAY_OLD = (24, 100, 84)
WAY_OTHER = (150, 190, 240)

# Numbers 1 to 7; a stripe has the colour of the number eight less.
BALLS = {
    1: (236, 186, 36),
    2: (28, 66, 168),
    3: (206, 40, 36),
    4: (94, 44, 136),
    5: (230, 110, 30),
    6: (22, 112, 66),
    7: (128, 28, 36),
    8: (24, 24, 26),
}


def unit(height: int) -> int:
    """The grid's pitch, in pixels, for a window of this height: 8 at 720. A tiny window has tiny letters."""
    return max(1, round(height / 90))
