"""One event of a shot, with the balls that it concerns just before and just after."""

from __future__ import annotations

from typing import Any, final

from .motion import Motion
from .values import Ball, EventKind


@final
class Event:
    """Something that happened: a contact, or a change of phase.

    Attributes:
        t: When, s after the shot.
        kind: What, as in `simulate --json`.
        balls: The ids of the balls that it concerns; of a stroke the struck one first.
        where: The cushion, jaw or pocket, or all of them for a cluster; "miscue" for a tip that slipped.
        pairs: The balls that touched each other, the pair that set it off first.
        rails: Pairs of a ball and the cushion that it touched.
    """

    __slots__ = ("t", "kind", "balls", "where", "pairs", "rails", "_old", "_new")

    def __init__(
        self,
        t: float,
        kind: EventKind,
        where: str | None,
        old: list[Motion],
        new: list[Motion],
        pairs: tuple[tuple[str, str], ...] = (),
        rails: tuple[tuple[str, str], ...] = (),
    ) -> None:
        self.t = t
        self.kind: EventKind = kind
        self.balls = tuple([motion.id for motion in new])
        self.where = where
        self.pairs = pairs
        self.rails = rails
        self._old = old
        self._new = new

    def __reduce__(self) -> tuple[Any, ...]:
        """What copies and pickles are made of, as compiled classes have to say."""
        return Event, (self.t, self.kind, self.where, self._old, self._new, self.pairs, self.rails)

    @property
    def before(self) -> dict[str, Ball]:
        """The balls' states just before it, by id."""
        return {motion.id: motion.at(self.t) for motion in self._old}

    @property
    def after(self) -> dict[str, Ball]:
        """The balls' states just after it, by id."""
        return {motion.id: motion.at(self.t) for motion in self._new}

    def __repr__(self) -> str:
        where = f" {self.where}" if self.where else ""
        return f"<{self.t:.6f} {self.kind} {' '.join(self.balls)}{where}>"

    def as_dict(self) -> dict[str, Any]:
        """What `simulate --json` prints of an event."""
        return {
            "t": self.t,
            "kind": self.kind,
            "balls": list(self.balls),
            "where": self.where,
            "before": {ball_id: ball.state() for ball_id, ball in self.before.items()},
            "after": {ball_id: ball.state() for ball_id, ball in self.after.items()},
        }
