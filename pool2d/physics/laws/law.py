"""What a law is: one object with all its parts, which read plain numbers and not the tree of knobs."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import final

from ..body import Body


class Friction:
    """A coefficient of friction that may fall as the slip grows: mu(s) = (a + b exp(-c s)) scale, s in m/s."""

    __slots__ = ("a", "b", "c", "scale")

    def __init__(self, a: float, b: float = 0.0, c: float = 0.0, scale: float = 1.0) -> None:
        self.a = a
        self.b = b
        self.c = c
        self.scale = scale

    def at(self, slip: float) -> float:
        """The coefficient at a slip."""
        return (self.a if self.b == 0.0 else self.a + self.b * math.exp(-self.c * slip)) * self.scale


@final
class BallNumbers:
    """What laws for two balls read: restitution, the friction of their surfaces, and the cloth's sliding friction."""

    __slots__ = ("restitution", "friction", "cloth")

    def __init__(self, restitution: float, friction: Friction, cloth: float) -> None:
        self.restitution = restitution
        self.friction = friction
        self.cloth = cloth


@final
class CushionNumbers:
    """What laws for cushions read.

    Restitution across the cushion and, `tangential`, along it; friction; the nose's height, m; and the cloth's
    sliding friction.
    """

    __slots__ = ("restitution", "tangential", "friction", "nose_height", "cloth")

    def __init__(
        self, restitution: float, tangential: float, friction: float, nose_height: float, cloth: float
    ) -> None:
        self.restitution = restitution
        self.tangential = tangential
        self.friction = friction
        self.nose_height = nose_height
        self.cloth = cloth


@final
class Nose:
    """What a ball feels at a nose: th, the friction of the rubber and that of the cloth under the ball, e and e_t."""

    __slots__ = ("sin", "cos", "rubber", "cloth", "restitution", "tangential")

    def __init__(
        self, sin: float, cos: float, rubber: float, cloth: float, restitution: float, tangential: float
    ) -> None:
        self.sin = sin
        self.cos = cos
        self.rubber = rubber
        self.cloth = cloth
        self.restitution = restitution
        self.tangential = tangential


@dataclass(frozen=True, slots=True)
class BallLaw:
    """How two balls exchange impulse.

    `collide(a, b, numbers)` changes two balls that touch; `friction(level, falling)` is the friction of their
    surfaces, which the contact has within a cluster too: of the two that a preset gives, the one that is the same
    at any slip and the one that falls as the slip grows, that which the law reads.
    """

    name: str
    collide: Callable[[Body, Body, BallNumbers], None]
    friction: Callable[[Friction, Friction], Friction]

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
