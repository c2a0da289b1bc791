"""The first time a quartic falls below zero: the one delicate numeric file.

A distance between two shapes, squared and less its value at contact, is a polynomial in time. It is
positive while they are apart, and a contact is where it falls through zero. Its derivative's roots
cut it into monotone pieces; the first piece that ends below zero holds the contact, where a bracketed
Newton iteration finds it to the last bit. Each derivative is treated in the same way, down to the
quadratic.
"""

from __future__ import annotations

import math
from typing import Final

INF: Final = math.inf


def first_root(c0: float, c1: float, c2: float, c3: float, c4: float, end: float) -> float:
    """The first t in [0, end] where c0 + c1 t + ... + c4 t^4 falls from positive to negative.

    Infinite where there is none. A polynomial that starts at zero or below must first rise above
    zero to fall again.
    """
    left, value = 0.0, c0
    ends = _turns(c1, 2.0 * c2, 3.0 * c3, 4.0 * c4, end)
    ends.append(end)
    for right in ends:
        value_right = (((c4 * right + c3) * right + c2) * right + c1) * right + c0
        if value > 0.0 >= value_right:
            return _bracketed(c0, c1, c2, c3, c4, left, right)
        left, value = right, value_right
    return INF


def falling_root(c0: float, c1: float, c2: float) -> float:
    """The one time, negative ones included, at which a quadratic falls through zero; inf where none.

    A quadratic falls through zero once at the most: its slope there is -sqrt(c1^2 - 4 c0 c2).
    """
    if c2 == 0.0:
        return -c0 / c1 if c1 < 0.0 else INF
    square = c1 * c1 - 4.0 * c0 * c2
    if square <= 0.0:
        return INF
    root = math.sqrt(square)
    # Two forms of one number; each is free of cancellation on its side.
    return 2.0 * c0 / (root - c1) if c1 < 0.0 else -(c1 + root) / (2.0 * c2)


def _turns(c0: float, c1: float, c2: float, c3: float, end: float) -> list[float]:
    """All roots in (0, end) of the cubic c0 + c1 t + c2 t^2 + c3 t^3, in order."""
    found: list[float] = []
    left, value = 0.0, c0
    ends = _quadratic(c1, 2.0 * c2, 3.0 * c3, end)
    ends.append(end)
    for right in ends:
        value_right = ((c3 * right + c2) * right + c1) * right + c0
        if (value > 0.0) != (value_right > 0.0):
            found.append(_bracketed(c0, c1, c2, c3, 0.0, left, right))
        left, value = right, value_right
    return found


def _quadratic(c0: float, c1: float, c2: float, end: float) -> list[float]:
    """All roots in (0, end) of c0 + c1 t + c2 t^2, in order."""
    if c2 == 0.0:
        roots = [-c0 / c1] if c1 != 0.0 else []
    else:
        square = c1 * c1 - 4.0 * c0 * c2
        if square <= 0.0:
            return []
        half = -0.5 * (c1 + math.copysign(math.sqrt(square), c1))
        roots = [half / c2]
        if half != 0.0:
            roots.append(c0 / half)
        roots.sort()
    return [root for root in roots if 0.0 < root < end]


def _bracketed(c0: float, c1: float, c2: float, c3: float, c4: float, left: float, right: float) -> float:
    """The root of a quartic that changes sign between `left` and `right`, by Newton or halving."""
    rising = (((c4 * right + c3) * right + c2) * right + c1) * right + c0 > 0.0
    t = 0.5 * (left + right)
    # Newton's steps are few; halving from a wide interval, down to a root of any size, takes up to two thousand.
    while True:
        value = (((c4 * t + c3) * t + c2) * t + c1) * t + c0
        if value == 0.0:
            return t
        if (value > 0.0) == rising:
            right = t
        else:
            left = t
        slope = ((4.0 * c4 * t + 3.0 * c3) * t + 2.0 * c2) * t + c1
        step = t - value / slope if slope != 0.0 else left
        if not left < step < right:
            step = 0.5 * (left + right)
        if abs(step - t) <= 2e-16 * (abs(t) + abs(step)) or not left < step < right:
            return step
        t = step
