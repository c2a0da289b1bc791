"""A recorded match as it is watched, apart from the window: which stroke is shown, and which moment of it."""

from __future__ import annotations

from ...config.settings import Store
from ...draw import cue_motion
from ...draw.effects import Effects, effects_of
from ...game.actions import Stroke
from ...game.records.recorded_shots import RecordedShots
from ...game.records.replaying import RecordedShot
from ...sound.mixer import Sounds
from ...table.table import Table
from ..stage.playback import Playback
from ..stage.show import Show
from ..stage.shown_balls import BallHistory, ShownBalls

# How long a shot's last moment is shown before the next begins, s.
PAUSE = 2.0


class ReplayState:
    """The strokes of a record, of which `at` is shown, counted from 0, and `playback` is its moment.

    A stroke that runs to its end leads on to the next; one that a hand holds or brings to its end stays. `why` is
    whether it is told why strokes were played. `show` says what is shown besides, `balls` how the balls are turned and
    which have fallen; `sounds` makes the strokes heard, and `store` says which motions are for show.
    """

    def __init__(self, shots: RecordedShots, store: Store, sounds: Sounds) -> None:
        self.shots = shots
        self.store = store
        self.sounds = sounds
        self.balls = BallHistory()
        self.show = Show()
        self.why = False
        self.at = 0
        # How many strokes `balls` has followed, and for how long the last moment has been shown, s.
        self._followed = 0
        self._rested = 0.0
        self.playback = self._played()

    @property
    def shot(self) -> RecordedShot:
        """The stroke that is shown."""
        return self.shots[self.at]

    @property
    def table(self) -> Table:
        """The table that it is played on."""
        return self.shot.match.table

    @property
    def shown_balls(self) -> ShownBalls:
        """The balls at the moment that is shown."""
        return self.balls.during(self.playback.rollout, self.playback.time)

    @property
    def effects(self) -> Effects:
        """What the player allows to move for show."""
        return effects_of(self.store.values)

    @property
    def still(self) -> bool:
        """Whether nothing changes by itself."""
        waits = self.playback.ended and not self.playback.paused and self.at + 1 < len(self.shots)
        return self.playback.still and self.shots.complete and not waits

    def go(self, at: int, paused: bool = False) -> None:
        """Show a stroke, from its beginning; the nearest there is."""
        self.at = min(max(at, 0), len(self.shots) - 1)
        # It may be that the record cannot be played so far.
        self.at = min(self.at, self.shot.number - 1)
        rate = self.playback.rate
        self.playback = self._played()
        self.playback.rate = rate
        self.playback.paused = paused
        self._rested = 0.0
        if not paused and self.playback.time == 0.0:
            self.sounds.play_events(self.table, self.playback.rollout, -1.0, 0.0)

    @property
    def told_why(self) -> bool:
        """Whether the record tells why the stroke was played."""
        action = self.shot.moment.action
        return isinstance(action, Stroke) and action.why is not None

    def turn_why(self) -> None:
        """Tell why strokes were played, or no more; to be read, the stroke is held at its beginning, until then."""
        self.why = not self.why
        if self.why:
            self.playback.seek(0.0)
        if self.playback.time <= 0.0:
            self.playback.paused = self.why

    def play_all(self) -> None:
        """Work out every stroke at once."""
        # Asked for the last, they play them all.
        self.shots[len(self.shots) - 1]
        self._follow()

    def update(self, dt: float) -> None:
        """Let the stroke go on by `dt` seconds, and work out another of those to come."""
        if not self.shots.complete:
            self.shots.play_next()
            self._follow()
        shown = self.playback
        before = shown.time
        shown.update(dt)
        self.sounds.play_events(self.table, shown.rollout, before, shown.time)
        if shown.ended and not shown.paused:
            self._rested += dt
            if self._rested >= PAUSE and self.at + 1 < len(self.shots):
                self.go(self.at + 1)
                self.playback.fast = shown.fast

    def _played(self) -> Playback:
        """The stroke that is shown, at its beginning."""
        shot = self.shot
        self._follow()
        action = shot.moment.action
        lead = cue_motion.lead(False, self.effects)
        shown = Playback(shot.rollout, action.shot if isinstance(action, Stroke) else None, lead, again=True)
        shown.kept = True
        return shown

    def _follow(self) -> None:
        """Let the balls of every stroke that is worked out lie as those before it left them."""
        played = self.shots.played
        for at in range(self._followed, len(played)):
            last = played[at - 1].moment if at else None
            self.balls.follow(played[at].before, played[at].rollout, last)
        self._followed = len(played)
