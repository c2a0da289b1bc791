"""Restitution, and friction that falls as the slip grows. (Alciatore TP A.14, eqs. 15-17.)"""

from __future__ import annotations

import math

from ..body import Body
from . import pair
from .law import BallLaw, BallNumbers


def collide(a: Body, b: Body, numbers: BallNumbers) -> None:
    """P = j (n - f v_s / |v_s|) with f falling with |v_s|."""
    pair.collide(a, b, numbers, falling)


def falling(slip: float, numbers: BallNumbers) -> float:
    """mu(s) through Marlow's measurements, s in m/s. (Alciatore TP A.14, p. 4.)"""
    return (9.951e-3 + 0.108 * math.exp(-1.088 * slip)) * numbers.cling


LAW = BallLaw("alciatore", collide, falling)
