"""Restitution, and friction with one coefficient. ("physic-based billiard simulation", 2002.)"""

from __future__ import annotations

from ..body import Body
from . import pair
from .law import BallLaw, BallNumbers


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """P = j (n - f v_s / |v_s|) with the preset's coefficient f."""
    pair.collide(a, b, numbers, pair.constant)


LAW = BallLaw("impulse", collide, pair.constant)
