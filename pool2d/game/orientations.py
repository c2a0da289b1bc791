"""What a layout does not hold: each ball's orientation, and the order in which balls were pocketed or went off."""

from __future__ import annotations

import math
import random
from typing import NamedTuple
from weakref import WeakKeyDictionary

from ..physics.orientation import BallRotation, Quaternion, product, turn
from ..physics.rollout import Rollout
from ..physics.values import GONE, Layout
from .actions import Arrange, NextFrame, Stalemate
from .falling import gone
from .match import Moment

# How far the number of a racked ball is from the top, rad, at most and mostly; and how far it is askew.
_TILT, _SKEW = 0.75, 1.1


class BallStates(NamedTuple):
    """The orientation of each ball, and the balls that are no longer played in the order in which they went."""

    orientations: dict[str, Quaternion]
    gone: list[str]


class OrientationTracker:
    """Carries the balls' orientations, and the order in which they went, from shot to shot.

    How the balls of a shot turn is a value like the shot: it starts from where the shot shown before it has ended,
    and is remembered as long as the shot exists. Without a shot the balls lie as racked.
    """

    def __init__(self) -> None:
        self._shots: WeakKeyDictionary[Rollout, _Shot] = WeakKeyDictionary()
        self._shown: _Shot | None = None
        self._racked: tuple[Layout, BallStates] | None = None

    def states(self, layout: Layout, rollout: Rollout | None = None, t: float = math.inf) -> BallStates:
        """The states of the balls of `layout`, which is that of `rollout`, if any, `t` s after its start."""
        if rollout is None:
            return self._rack(layout)
        shot = self._shots.get(rollout)
        if shot is None:
            before = self._before(rollout.start)
            shot = self._shots[rollout] = _Shot(
                BallRotation(rollout, before.orientations), before.gone, gone(rollout), rollout.layout()
            )
        self._shown = shot
        here = _gone(layout)
        down = [ball for ball in shot.before + gone(rollout, t) if ball in here]
        return BallStates(shot.turning.orientations(t), down)

    def follow(self, before: Moment, rollout: Rollout, last: Moment | None) -> None:
        """Start the stroke `rollout`, played from the layout of `before`, with the orientations that `last` left.

        `last` is the moment of the stroke before it, None for the first.
        """
        if last is not None and last.rollout is not None:
            self.states(last.rollout.start, last.rollout)
        racked = last is None or before.state.racks != last.state.racks
        if racked or isinstance(before.action, NextFrame | Arrange | Stalemate):
            self.states(rollout.start)
        self.states(rollout.start, rollout)

    def rotation(self, rollout: Rollout) -> BallRotation:
        """How the balls of a shot turn; raises KeyError for a shot that has not been shown."""
        return self._shots[rollout].turning

    def _before(self, start: Layout) -> BallStates:
        """How the balls lie where a shot starts that was not shown before."""
        orientations, down = racked_orientations(start), []
        if self._shown is not None:
            orientations |= self._shown.turning.orientations(math.inf)
            down = self._shown.before + self._shown.gone
        elif self._racked is not None:
            orientations |= self._racked[1].orientations
        return BallStates(orientations, _order(down, start))

    def _rack(self, layout: Layout) -> BallStates:
        shot, self._shown = self._shown, None
        if shot is not None:
            self._racked = shot.end, BallStates(shot.turning.orientations(math.inf), shot.before + shot.gone)
        if self._racked is None or self._racked[0] is not layout:
            orientations, known = racked_orientations(layout), []
            if self._racked is not None and _moved(self._racked[0], layout) <= 1:
                # No new rack: a hand has moved a ball, and does not turn it.
                orientations |= self._racked[1].orientations
                known = self._racked[1].gone
            self._racked = layout, BallStates(orientations, _order(known, layout))
        return self._racked[1]


class _Shot(NamedTuple):
    """A shot that was shown: how its balls turn, those gone before it and by it, and how it ended."""

    turning: BallRotation
    before: list[str]
    gone: list[str]
    end: Layout


def racked_orientations(layout: Layout) -> dict[str, Quaternion]:
    """The orientations of racked balls: askew, numbers mostly in sight; the same for the same layout."""
    orientations = {}
    for ball in layout.values():
        rng = random.Random(f"{ball.id} {ball.x!r} {ball.y!r}")
        skew, way = rng.gauss(0.0, _SKEW), math.tau * rng.random()
        tilt = _TILT * math.sqrt(rng.random())
        orientations[ball.id] = product(turn(tilt * math.cos(way), tilt * math.sin(way), 0.0), turn(0.0, 0.0, skew))
    return orientations


def _order(known: list[str], layout: Layout) -> list[str]:
    """The balls of a layout that are gone, in the order in which they went; first those of which it is not known."""
    down = _gone(layout)
    order = [ball for ball in known if ball in down]
    return [ball for ball in down if ball not in order] + order


def _moved(before: Layout, after: Layout) -> int:
    """How many balls of `after` are not where `before` has them."""
    places = {ball.id: (ball.x, ball.y) for ball in before.values()}
    return sum(places.get(ball.id) != (ball.x, ball.y) for ball in after.values())


def _gone(layout: Layout) -> list[str]:
    return [ball.id for ball in layout.values() if ball.phase in GONE]
