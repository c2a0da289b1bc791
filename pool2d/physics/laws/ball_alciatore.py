"""Restitution, and friction that falls as the slip grows. (Alciatore TP A.14, eqs. 15-17.)"""

from __future__ import annotations

from .law import BallLaw, Friction
from .pair import collide


def fading(level: Friction, falling: Friction) -> Friction:
    """mu(s) = a + b exp(-c s), whose knobs' defaults go through Marlow's measurements. (Alciatore TP A.14, p. 4.)"""
    return falling


LAW = BallLaw("alciatore", collide, fading)
