"""What a law is: one object with all its parts, which read plain numbers and not the tree of knobs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import NamedTuple

from ..body import Body


class BallNumbers(NamedTuple):
    """What laws for two balls read: restitution, friction, what multiplies it, and the cloth's sliding friction."""

    restitution: float
    friction: float
    cling: float
    cloth: float


class CushionNumbers(NamedTuple):
    """What laws for cushions read: restitution, friction, the nose's height, m, and the cloth's sliding friction."""

    restitution: float
    friction: float
    nose_height: float
    cloth: float


class Nose(NamedTuple):
    """What a ball feels at a nose: th, the friction of the rubber and that of the cloth under the ball, and e."""

    sin: float
    cos: float
    rubber: float
    cloth: float
    restitution: float


@dataclass(frozen=True, slots=True)
class BallLaw:
    """How two balls exchange impulse.

    `collide(a, b, numbers)` changes two balls that touch; `friction(slip, numbers)` is the coefficient at a slip in
    m/s, which the contact has within a cluster too.
    """

    name: str
    collide: Callable[[Body, Body, BallNumbers], None]
    friction: Callable[[float, BallNumbers], float]

    def __post_init__(self) -> None:
        _whole(self)


@dataclass(frozen=True, slots=True)
class CushionLaw:
    """How a cushion returns a ball.

    `collide(ball, nx, ny, numbers)` changes a ball that touches a cushion in the direction (nx, ny); `nose(radius,
    numbers)` is what a ball of that radius feels at the nose within a cluster.
    """

    name: str
    collide: Callable[[Body, float, float, CushionNumbers], None]
    nose: Callable[[float, CushionNumbers], Nose]

    def __post_init__(self) -> None:
        _whole(self)


def _whole(law: BallLaw | CushionLaw) -> None:
    """Raises ValueError for a law that lacks a name or a part: at import, not in mid-shot."""
    missing = [entry.name for entry in fields(law) if not getattr(law, entry.name)]
    if missing:
        raise ValueError(f"the law {law.name!r} has no {', '.join(missing)}")
