"""Impulse by impulse, with friction at the nose and at the cloth. (Mathavan, Jackson and Parkin 2010.)"""

from __future__ import annotations

import math
from typing import Final

from ..body import Body
from ..energy import take_back
from ..roots import INF
from .law import CushionLaw, CushionNumbers, Nose
from .nose import State, along_nose, drag, dragged, give, rate, seen, springing_back
from .rebound import rebound

# Steps of the integration, for each of compression and restitution. Against 2,000
# steps the speeds after a rebound are off by 0.11 % of the speed before it at the most, 0.02 % on
# average, and the spins times the radius by 1 %; with a snooker cushion by twice that. The largest are
# where a slip turns about within a step. (`python -m pytest tests/physics/laws/test_steps.py`)
STEPS: Final = 16
# Many times the steps that a contact takes which does not jam.
_ENOUGH: Final = 20


def collide(ball: Body, nx: float, ny: float, numbers: CushionNumbers, steps: int = STEPS) -> None:
    """Impulse by impulse, with friction at the nose and, as the nose presses the ball down, at the cloth.

    The state is integrated over the cushion's normal impulse: first until the ball has stopped going
    in, then until the cushion has given back e^2 of the work it took. (Mathavan, Jackson and Parkin,
    Proc. IMechE C 224:1863-1873, 2010, eqs. 12-17.) Then the rubber springs back along the rail.
    """
    approach = ball.vx * nx + ball.vy * ny
    if approach <= 0.0:
        return
    nose = pressing(ball.radius, numbers)
    restitution = rebound(approach, nose.restitution) / approach
    cos = nose.cos
    state = along_nose(ball, nx, ny)
    step = approach / (cos * steps)
    turned, work, push = -state[4], 0.0, 0.0
    for _ in range(_ENOUGH * steps):
        change = rate(state, nose, step)
        last = state[1] + step * change[1] <= 0.0
        part = -state[1] / change[1] if last else step
        after = _moved(state, change, part)
        work += 0.5 * (state[1] + after[1]) * cos * part
        push += part
        state = after
        if last:
            break
    work *= restitution * restitution
    for _ in range(_ENOUGH * steps):
        change = rate(state, nose, step)
        # Within a step the cushion gives back (-vY + |vY'| part / 2) cos part.
        out, gain = -state[1], -change[1]
        square = out * out + 2.0 * gain * work / cos
        reach = out + math.sqrt(square) if square > 0.0 else 0.0
        whole = 2.0 * work / cos / reach if reach > 0.0 else INF
        last = whole <= step
        part = whole if last else step
        work -= (out + 0.5 * gain * part) * cos * part
        push += part
        state = _moved(state, change, part)
        if last:
            break
    if nose.tangential > 0.0:
        state = dragged(state, springing_back(drag(turned + state[4], nose), push, nose), nose)
    before = ball.energy()
    give(ball, nx, ny, state[0], state[1], state[2], state[3], state[4])
    take_back([ball], before, True)


def pressing(radius: float, numbers: CushionNumbers) -> Nose:
    """The nose presses the ball on the cloth, whose friction counts."""
    sin, cos = seen(radius, numbers)
    return Nose(sin, cos, numbers.friction, numbers.cloth, numbers.restitution, numbers.tangential)


def _moved(state: State, change: State, step: float) -> State:
    return (
        state[0] + step * change[0], state[1] + step * change[1],
        state[2] + step * change[2], state[3] + step * change[3], state[4] + step * change[4],
    )  # fmt: skip


LAW = CushionLaw("mathavan2010", collide, pressing)
