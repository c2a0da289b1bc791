"""The same shots by pooltool, the Python peer: `python -m benchmarks.speed --peer`, where it is installed.

Its table of seven feet, its balls placed as ours are in parts of the cloth, the cue ball sent off at the same speed.
"""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from functools import partial
from typing import Any

from .machine import loop, took

# How many samples are taken of a case.
_SAMPLES = 10


def samples() -> dict[str, list[float]] | None:
    """The samples of the cases that pooltool can play, in loops; None where it is not installed."""
    if importlib.util.find_spec("pooltool") is None:
        return None
    pooltool: Any = importlib.import_module("pooltool")
    found: dict[str, list[float]] = {}
    for name, scene in _scenes().items():
        found[name] = []
        for number in range(-1, _SAMPLES):
            system = scene(pooltool, max(number, 0))
            before = loop()
            seconds = took(partial(pooltool.simulate, system, inplace=True))
            # The first shot is compiled.
            if number >= 0:
                found[name].append(seconds / (0.5 * (before + loop())))
    return found


def _scenes() -> dict[str, Callable[[Any, int], Any]]:
    from pool2d import Layout, Shot, load_table
    from tests.scenes import break_shot, random_shot

    from .speed_cases import two_balls

    table = load_table("pool-7ft")

    def placed(peer: Any, layout: Layout, shot: Shot) -> Any:
        """A layout of ours on a table of the peer's, along which y runs."""
        size, cloth = table.knobs.table, peer.Table.default()
        across, along = cloth.w / size.width, cloth.l / size.length
        balls = {
            ball.id: peer.Ball.create(ball.id, xy=((size.width - ball.y) * across, ball.x * along))
            for ball in layout.values()
        }
        system = peer.System(cue=peer.Cue(cue_ball_id=shot.ball), table=cloth, balls=balls)
        system.cue.set_state(V0=shot.speed, phi=(shot.angle + 90.0) % 360.0, a=-shot.side, b=shot.height, theta=0.0)
        return system

    return {
        "break": lambda peer, seed: placed(peer, *break_shot(table, seed)),
        "two balls": lambda peer, seed: placed(peer, *two_balls(table, seed)),
        "16 balls, random": lambda peer, seed: placed(peer, *random_shot(table, seed)),
    }
