"""The cue ball in the player's hand: where it is held, and putting it down."""

from __future__ import annotations

from ..game.session import Session

Point = tuple[float, float]


class InHand:
    """`at` is where the ball is held over the table, m; None before a hand has moved it."""

    def __init__(self) -> None:
        self.at: Point | None = None

    def where(self, session: Session) -> Point:
        """Where the ball is held; at first where the rack has it."""
        if self.at is not None:
            return self.at
        start = session.table.rack(session.rack_name)[session.cue.id]
        return start.x, start.y

    def nudge(self, session: Session, dx: float, dy: float) -> None:
        """Move it by so much."""
        x, y = self.where(session)
        self.at = (x + dx, y + dy)

    def place(self, session: Session) -> bool:
        """Put it down; False where it has no room."""
        placed = session.place(*self.where(session))
        if placed:
            self.at = None
        return placed
