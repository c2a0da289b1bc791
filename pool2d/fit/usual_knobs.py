"""The knobs that are fitted where nobody says which: those that tracks of whole shots tell, and that the laws read."""

from __future__ import annotations

from ..physics.laws.law import Friction
from ..physics.laws.registry import BALL_LAWS
from ..table.table import Table

_CLOTH = ("cloth.mu_slide", "cloth.mu_roll", "cloth.mu_spin")
_CUSHION = ("cushion.restitution", "cushion.friction")
# Cushion laws whose rubber gives back slip along the rail.
_SPRINGY = ("mathavan2010", "han2005")


def usual_knobs(table: Table) -> tuple[str, ...]:
    """Knobs of cloth, cushions and balls; which friction there is between balls depends on their law."""
    tangential = ("cushion.tangential",) if table.knobs.cushion.law in _SPRINGY else ()
    return (*_CLOTH, *_CUSHION, *tangential, "ball.restitution", *_rubbing(table.knobs.ball.law))


def _rubbing(law: str) -> tuple[str, ...]:
    """The knobs of friction between balls that a law reads."""
    level, falling = Friction(1.0), Friction(2.0)
    known = {level.a: ("ball.friction",), falling.a: tuple(f"ball.friction_{part}" for part in "abc")}
    return known.get(BALL_LAWS[law].friction(level, falling).a, ())
