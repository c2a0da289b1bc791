"""A shot on the screen: which moment of it is shown, and how the time of it goes on."""

from __future__ import annotations

from ...game.falling import ending, settling
from ...physics.rollout import Event, Rollout
from ...physics.values import Shot

RATES = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
_FAST = 8.0


class Playback:
    """A rollout at a moment, `time`, in s; below 0 the cue has not yet met the ball.

    `end` is when the balls rest and the last that fell is out of sight. `again` says that the shot was seen
    before, `review` that its time line is out. Once the player has taken hold of it (`kept`), it stays at its
    end until it is left. `fast` multiplies the rate, which is one of RATES; so does, without a time line, that
    nothing moves from its place any more: a ball may spin on for many seconds.
    """

    def __init__(self, rollout: Rollout, shot: Shot | None, lead: float = 0.0, again: bool = False) -> None:
        self.rollout = rollout
        self.shot = shot
        self.end = ending(rollout)
        self._settled = settling(rollout)
        self.time = -lead
        self.rate = 1.0
        self.fast = False
        self.paused = False
        self.again = self.review = again
        self.kept = False
        self._at: int | None = None

    @property
    def ended(self) -> bool:
        """Whether the last moment is shown."""
        return self.time >= self.end

    @property
    def over(self) -> bool:
        """Whether there is nothing more to show."""
        return self.ended and not self.kept

    @property
    def running(self) -> bool:
        """Whether the next frame shows a later moment."""
        return not (self.paused or self.ended)

    @property
    def still(self) -> bool:
        """Whether it shows the same moment until a hand does something."""
        return self.kept and not self.running

    @property
    def event(self) -> Event | None:
        """The event at the moment shown, or the last before it."""
        return None if self._index < 0 else self.rollout.events[self._index]

    def update(self, dt: float) -> None:
        """Let `dt` seconds pass."""
        if self.running:
            self._at = None
            fast = self.fast or (self.time >= self._settled and not self.review)
            self.time = min(self.time + dt * self.rate * (_FAST if fast else 1.0), self.end)

    def pause(self) -> None:
        """Hold it, with its time line out."""
        self.review = self.kept = self.paused = True

    def toggle(self) -> None:
        """Hold it or let it run; from its end it runs again from the beginning."""
        if self.ended:
            self.seek(0.0)
            self.paused = False
        else:
            self.paused = not self.paused
        self.review = self.kept = True

    def change_rate(self, steps: int) -> None:
        """Go so many rates faster, or slower for a negative number."""
        at = min(max(RATES.index(self.rate) + steps, 0), len(RATES) - 1)
        self.rate = RATES[at]
        self.kept = True

    def seek(self, t: float) -> None:
        """Show the moment `t`."""
        self.time = min(max(t, 0.0), self.end)
        self.kept = True
        self._at = None

    def step(self, by: int) -> None:
        """Hold it at the next event, or the one before for -1."""
        before, last = self._index, len(self.rollout.events) - 1
        between = by < 0 and before >= 0 and self.rollout.events[before].t < self.time
        at = min(max(before if between else before + by, 0), last)
        if last >= 0:
            self.seek(self.rollout.events[at].t)
            self._at = at
        self.pause()

    def leave(self) -> None:
        """Go to the end, and be over."""
        self.time = self.end
        self.kept = False

    @property
    def _index(self) -> int:
        if self._at is not None:
            return self._at
        return sum(event.t <= self.time for event in self.rollout.events) - 1
