"""Restitution, and friction with one coefficient. ("physic-based billiard simulation", 2002.)"""

from __future__ import annotations

from .law import BallLaw
from .pair import collide, constant

LAW = BallLaw("impulse", collide, constant)
