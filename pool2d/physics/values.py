"""The values that go into a shot and come out of it: Ball, Layout, Shot."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal, NamedTuple

from ..errors import InputError

Phase = Literal["resting", "spinning", "rolling", "sliding", "airborne", "pocketed", "off"]
RESTING: Final = "resting"
SPINNING: Final = "spinning"
ROLLING: Final = "rolling"
SLIDING: Final = "sliding"
AIRBORNE: Final = "airborne"
POCKETED: Final = "pocketed"
OFF: Final = "off"
# Phases of a ball that is no longer played.
GONE: Final[tuple[Phase, ...]] = (POCKETED, OFF)

# What happens in a shot: contacts first, then changes of phase.
EventKind = Literal[
    "cue_ball", "ball_ball", "ball_cushion", "ball_pocket", "ball_slate", "ball_off", "cluster",
    "sliding_rolling", "rolling_resting", "spin_end",
]  # fmt: skip
# What `where` says of a "cue_ball" event whose tip has slipped.
MISCUE: Final = "miscue"
# What it says of one whose tip has met the ball again, and stays with it.
PUSH: Final = "push"


class Ball(NamedTuple):
    """One ball at one moment.

    Place in m, velocity in m/s, spin in rad/s; `phase` is resting, spinning, rolling, sliding, airborne,
    pocketed, or off the table. A radius or mass of None means the table's own. `z` is the height of its
    lowest point above the cloth, and `vz` how fast that rises.

    Examples:
        >>> from pool2d import Ball
        >>> ball = Ball("8", 1.9, 0.635, vx=0.5)
        >>> ball.vx, ball.still().vx
        (0.5, 0.0)
    """

    id: str
    x: float
    y: float
    vx: float = 0.0
    vy: float = 0.0
    wx: float = 0.0
    wy: float = 0.0
    wz: float = 0.0
    phase: Phase = RESTING
    radius: float | None = None
    mass: float | None = None
    z: float = 0.0
    vz: float = 0.0

    def still(self) -> Ball:
        """The same ball at rest."""
        return Ball(self.id, self.x, self.y, radius=self.radius, mass=self.mass)

    def state(self) -> dict[str, Any]:
        """What `simulate --json` prints of a ball."""
        return {name: getattr(self, name) for name in STATE_FIELDS}


MOTION_FIELDS = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
STATE_FIELDS = (*MOTION_FIELDS, "phase")


class Layout(Mapping[str, Ball]):
    """Balls by id: an immutable value.

    Examples:
        >>> from pool2d import Ball, Layout
        >>> layout = Layout([Ball("cue", 0.635, 0.635), Ball("1", 1.9, 0.66)])
        >>> layout["1"].y, list(layout.without("1")), len(layout.put(Ball("2", 1.0, 0.3)))
        (0.66, ['cue'], 3)
    """

    __slots__ = ("_balls",)

    def __init__(self, balls: Iterable[Ball] = ()) -> None:
        self._balls = {ball.id: ball for ball in balls}

    def __getitem__(self, ball_id: str) -> Ball:
        return self._balls[ball_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._balls)

    def __len__(self) -> int:
        return len(self._balls)

    def __repr__(self) -> str:
        return f"Layout({list(self._balls.values())!r})"

    def __hash__(self) -> int:
        return hash(frozenset(self._balls.values()))

    def put(self, *balls: Ball) -> Layout:
        """A copy with these balls added or replaced."""
        return Layout({**self._balls, **{ball.id: ball for ball in balls}}.values())

    def without(self, *ids: str) -> Layout:
        """A copy lacking these balls."""
        return Layout(ball for ball in self._balls.values() if ball.id not in ids)

    def on_table(self) -> list[Ball]:
        """The balls that have neither been pocketed nor left the table."""
        return [ball for ball in self._balls.values() if ball.phase not in GONE]


@dataclass(frozen=True, slots=True)
class Shot:
    """How the cue meets a ball.

    `angle` is the cue's direction in degrees; `speed` the cue's at impact, m/s; `side` and `height`
    the tip's offset as fractions of the ball's radius, in the plane across the cue (side > 0 is
    right-hand english, height > 0 is follow); `elevation` the butt's angle above level, degrees.
    An `easy` stroke is one whose cue is in nobody's way: it need not clear rails and balls, and is gone
    once it has met the ball. A `jump` is played with the jump cue.

    Examples:
        >>> from pool2d import Shot
        >>> shot = Shot(angle=0.4, speed=3.0, side=0.2, height=-0.1)  # a draw shot with right-hand english
        >>> shot.check()
        >>> Shot(speed=99.0).check()
        Traceback (most recent call last):
            ...
        pool2d.errors.InputError: shot: shot.speed = 99.0: allowed is a number from 0 to 50 m/s
    """

    angle: float = 0.0
    speed: float = 5.0
    side: float = 0.0
    height: float = 0.0
    elevation: float = 0.0
    ball: str = "cue"
    easy: bool = False
    jump: bool = False

    def check(self, source: str = "shot") -> None:
        """Raises InputError where a number is not finite, out of range, or the tip misses the ball."""
        for name, (lo, hi, unit) in SHOT_RANGES.items():
            value = getattr(self, name)
            if not lo <= value <= hi:
                raise InputError(source, f"shot.{name}", value, f"allowed is a number from {lo:g} to {hi:g}{unit}")
        if math.hypot(self.side, self.height) > 1.0:
            raise InputError(
                source, "shot.side, shot.height", (self.side, self.height),
                "the tip is off the ball; allowed is side^2 + height^2 up to 1",
            )  # fmt: skip


SHOT_RANGES: dict[str, tuple[float, float, str]] = {
    "angle": (-3600.0, 3600.0, " degrees"),
    "speed": (0.0, 50.0, " m/s"),
    "side": (-1.0, 1.0, ""),
    "height": (-1.0, 1.0, ""),
    "elevation": (0.0, 90.0, " degrees"),
}
