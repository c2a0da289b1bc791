"""What the balls and cushions of one table are made of, as the laws read it: worked out once from its knobs."""

from __future__ import annotations

from typing import NamedTuple

from .laws.law import BallLaw, BallNumbers, CushionLaw, CushionNumbers
from .laws.registry import BALL_LAWS, CUSHION_LAWS
from .params import Physics


class Materials(NamedTuple):
    """The two laws of a table, and the numbers that each reads."""

    ball_law: BallLaw
    ball: BallNumbers
    cushion_law: CushionLaw
    cushion: CushionNumbers


def materials(physics: Physics) -> Materials:
    """The laws that a table's knobs name, with their numbers."""
    ball, cushion, cloth = physics.ball, physics.cushion, physics.cloth
    return Materials(
        BALL_LAWS[ball.law],
        BallNumbers(ball.restitution, ball.friction, ball.cling, cloth.mu_slide),
        CUSHION_LAWS[cushion.law],
        CushionNumbers(cushion.restitution, cushion.friction, cushion.nose_height, cloth.mu_slide),
    )
