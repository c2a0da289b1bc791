"""What is seen of a player at the table, movement by movement; each takes as many frames as it lasts."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from typing import Final, TypeAlias

from ....game.aim import Aim, drawn_back
from ..hands import Hands
from ..in_hand import InHand

# A movement: it waits for the next frame wherever it yields, and is sent how long that has been, s.
Movement: TypeAlias = Generator[None, float, None]

# How far a practice stroke draws the cue back, as a part of a full pull, and how long it takes, s.
_PRACTICE: Final = 0.22
_SWING: Final = 0.5
# How long the last stroke back takes, s.
_BACK: Final = 0.55


class Movements:
    """Moves a player's hands. Where it is `hurried` all that is left is done within the frame.

    `eased` tells whether things may glide; where they may not, they are at once where they are to be.
    """

    def __init__(self, hands: Hands, in_hand: InHand, eased: Callable[[], bool]) -> None:
        self.hands = hands
        self.in_hand = in_hand
        self.eased = eased
        self.hurried = False

    def wait(self, seconds: float) -> Movement:
        """Do nothing for so long."""
        return self._during(seconds, lambda part: None)

    def turn(self, aim: Aim, seconds: float) -> Movement:
        """Turn the cue to an aim, the shorter way round."""
        return self._glide(seconds, self._to(aim))

    def carry(self, start: tuple[float, float], end: tuple[float, float], seconds: float) -> Movement:
        """Carry the cue ball from one place to another."""

        def put(part: float) -> None:
            self.in_hand.at = (start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part)

        return self._glide(seconds, put)

    def practise(self, strokes: int) -> Movement:
        """Swing the cue a few times without touching the ball."""

        def put(part: float) -> None:
            self.hands.swing = 0.5 * _PRACTICE * (1.0 - math.cos(2.0 * math.pi * strokes * part))

        return self._during(strokes * _SWING, put if self.eased() else lambda part: None)

    def draw_back(self, aim: Aim) -> Movement:
        """Draw the cue back for the stroke, as far as its speed asks for; the aim becomes what the hand makes of it."""
        turn, full = self._to(aim), drawn_back(aim.speed)

        def put(part: float) -> None:
            turn(part)
            self.hands.swing = full * part

        return self._glide(_BACK, put)

    def _to(self, aim: Aim) -> Callable[[float], None]:
        """What takes the present aim to another, by parts of the way."""
        start = self.hands.aim
        angle = math.remainder(aim.angle - start.angle, 360.0)
        ways = [_way(getattr(start, name), getattr(aim, name)) for name in _NUMBERS]

        def put(part: float) -> None:
            speed, side, height, elevation = (way(part) for way in ways)
            turned = (start.angle + angle * part) % 360.0
            self.hands.aim = Aim(turned, speed, side, height, elevation, aim.jump)

        return put

    def _glide(self, seconds: float, put: Callable[[float], None]) -> Movement:
        """Start and end softly; at once where nothing may glide, which leaves as long to look at it."""
        if self.eased():
            return self._during(seconds, lambda part: put(part * part * (3.0 - 2.0 * part)))
        put(1.0)
        return self.wait(seconds)

    def _during(self, seconds: float, put: Callable[[float], None]) -> Movement:
        """Have `put` take the parts of the time that have passed, up to 1."""
        passed = 0.0
        while passed < seconds and not self.hurried:
            put(passed / seconds)
            passed += yield
        put(1.0)


_NUMBERS: Final = ("speed", "side", "height", "elevation")


def _way(start: float, end: float) -> Callable[[float], float]:
    """What lies on the way from one number to another."""
    return lambda part: end if part == 1.0 else start + (end - start) * part
