"""Restitution, and friction that falls as the slip grows. (Alciatore TP A.14, eqs. 15-17.)"""

from __future__ import annotations

from .law import BallLaw, Friction
from .pair import collide


def falling(coefficient: float, cling: float) -> Friction:
    """mu(s) through Marlow's measurements, s in m/s, whatever the preset's coefficient. (Alciatore TP A.14, p. 4.)"""
    return Friction(9.951e-3, 0.108, 1.088, cling)


LAW = BallLaw("alciatore", collide, falling)
