"""What balls, cushions and cloth of one table are made of, as the engine reads it: worked out once from its knobs."""

from __future__ import annotations

from typing import Final, final

from .detect import Element
from .flight.impact import Surface
from .laws.law import BallLaw, BallNumbers, CushionLaw, CushionNumbers, Friction
from .laws.registry import BALL_LAWS, CUSHION_LAWS
from .motion import ClothNumbers
from .params import Physics

# A ball that kept all its speed off the slate would hop for ever.
MOST_BOUNCE: Final = 0.95


@final
class Materials:
    """The two laws of a table, the numbers that each reads, those of its pockets' facings, and the cloth's.

    And, for balls off the cloth, the slate, the rails' top and the liner at the back of the pockets.
    """

    __slots__ = ("ball_law", "ball", "cushion_law", "cushion", "facing", "cloth", "slate", "rail", "liner")

    def __init__(
        self,
        ball_law: BallLaw,
        ball: BallNumbers,
        cushion_law: CushionLaw,
        cushion: CushionNumbers,
        facing: CushionNumbers,
        cloth: ClothNumbers,
        slate: Surface,
        rail: Surface,
        liner: Surface,
    ) -> None:
        self.ball_law = ball_law
        self.ball = ball
        self.cushion_law = cushion_law
        self.cushion = cushion
        self.facing = facing
        self.cloth = cloth
        self.slate = slate
        self.rail = rail
        self.liner = liner

    def of(self, element: Element) -> CushionNumbers:
        """The numbers of a nose or a jaw: a cushion's, or a facing's."""
        return self.facing if element.facing else self.cushion


def materials(physics: Physics) -> Materials:
    """The laws that a table's knobs name, with their numbers."""
    ball, cushion, facing, cloth = physics.ball, physics.cushion, physics.facing, physics.cloth
    law = BALL_LAWS[ball.law]
    return Materials(
        law,
        BallNumbers(
            ball.restitution,
            law.friction(
                Friction(ball.friction, scale=ball.cling),
                Friction(ball.friction_a, ball.friction_b, ball.friction_c, ball.cling),
            ),
            cloth.mu_slide,
        ),
        CUSHION_LAWS[cushion.law],
        CushionNumbers(cushion.restitution, cushion.tangential, cushion.friction, cushion.nose_height, cloth.mu_slide),
        CushionNumbers(
            facing.restitution * cushion.restitution,
            min(1.0, cushion.tangential + facing.tangential),
            facing.friction * cushion.friction,
            cushion.nose_height,
            cloth.mu_slide,
        ),
        ClothNumbers(cloth.mu_slide, cloth.mu_roll, cloth.mu_spin, physics.gravity),
        Surface(min(cloth.bounce, MOST_BOUNCE), cloth.bounce_friction),
        Surface(physics.rail.restitution, cloth.bounce_friction),
        Surface(physics.pocket.restitution, physics.pocket.friction),
    )
