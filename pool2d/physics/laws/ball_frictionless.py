"""Restitution alone: P = j n."""

from __future__ import annotations

from .law import BallLaw, Friction
from .pair import collide


def none(level: Friction, falling: Friction) -> Friction:
    """No friction at any slip."""
    return Friction(0.0)


LAW = BallLaw("frictionless", collide, none)
