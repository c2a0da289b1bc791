"""Restitution alone."""

from __future__ import annotations

from ..body import Body
from . import pair
from .law import BallLaw, BallNumbers


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """P = j n."""
    pair.collide(a, b, numbers, none)


def none(slip: float, numbers: BallNumbers) -> float:
    """No friction at any slip."""
    return 0.0


LAW = BallLaw("frictionless", collide, none)
