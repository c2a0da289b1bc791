"""Playback: which moment of a shot is shown, and how fast its time passes."""

from __future__ import annotations

from ...game.falling import ending, settling
from ...physics.event import Event
from ...physics.rollout import Rollout
from ...physics.values import Shot

RATES = (0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
_FAST = 8.0


class Playback:
    """A rollout that is being shown: `time` is the moment on the screen, s; below 0 the cue has not met the ball yet.

    `end` is when all balls rest and the last pocketed one is out of sight. `again`: the shot was seen before.
    `review`: the time line is shown. `kept`: the player has held or moved it, so it stays on its last moment until
    it is left. The time passes at one of RATES, faster while `fast`; and, without a time line, faster once no ball
    changes its place any more, as a ball may spin on for many seconds.
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
        """Whether the playback is done with, and the scene goes on."""
        return self.ended and not self.kept

    @property
    def running(self) -> bool:
        """Whether its time passes: the next frame shows a later moment."""
        return not (self.paused or self.ended)

    @property
    def still(self) -> bool:
        """Whether it shows the same moment until the player does something."""
        return self.kept and not self.running

    @property
    def event(self) -> Event | None:
        """The event at the moment shown, or the last before it."""
        return None if self._index < 0 else self.rollout.events[self._index]

    def update(self, dt: float) -> None:
        """Let `dt` s pass in the window."""
        if self.running:
            self._at = None
            fast = self.fast or (self.time >= self._settled and not self.review)
            self.time = min(self.time + dt * self.rate * (_FAST if fast else 1.0), self.end)

    def pause(self) -> None:
        """Stop its time and show the time line."""
        self.review = self.kept = self.paused = True

    def toggle(self) -> None:
        """Stop its time, or let it pass again; from its end it begins anew."""
        if self.ended:
            self.seek(0.0)
            self.paused = False
        else:
            self.paused = not self.paused
        self.review = self.kept = True

    def change_rate(self, steps: int) -> None:
        """Take a rate so many steps faster, or slower for a negative number."""
        at = min(max(RATES.index(self.rate) + steps, 0), len(RATES) - 1)
        self.rate = RATES[at]
        self.kept = True

    def seek(self, t: float) -> None:
        """Show the moment `t`, s."""
        self.time = min(max(t, 0.0), self.end)
        self.kept = True
        self._at = None

    def step(self, by: int) -> None:
        """Stop at the next event, or for -1 at the one before."""
        before, last = self._index, len(self.rollout.events) - 1
        between = by < 0 and before >= 0 and self.rollout.events[before].t < self.time
        at = min(max(before if between else before + by, 0), last)
        if last >= 0:
            self.seek(self.rollout.events[at].t)
            self._at = at
        self.pause()

    def leave(self) -> None:
        """Skip to the end, and be over."""
        self.time = self.end
        self.kept = False

    @property
    def _index(self) -> int:
        if self._at is not None:
            return self._at
        return sum(event.t <= self.time for event in self.rollout.events) - 1
