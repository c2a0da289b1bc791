"""What came of a shot, told: as JSON, or a line for each event."""

from __future__ import annotations

from typing import Any

from ..physics.rollout import Rollout
from . import terminal


def as_dict(rollout: Rollout, step: float | None) -> dict[str, Any]:
    """A rollout in JSON's types, with each ball's path where a `step`, s, is given."""
    result: dict[str, Any] = {
        "duration": rollout.duration,
        "balls": {ball.id: ball.state() for ball in rollout.layout().values()},
        "events": [event.as_dict() for event in rollout.events],
    }
    if rollout.truncated:
        result["truncated"] = True
    if step is not None:
        result["path"] = {ball: rollout.path(ball, step) for ball in rollout.start}
    return result


def tell(path: str, rollout: Rollout, step: float | None) -> None:
    """A rollout for people: a line for each event, and where each ball ended."""
    cut = ", cut short" if rollout.truncated else ""
    terminal.tell(f"{path}: {len(rollout.events)} events in {rollout.duration:.3f} s{cut}")
    for event in rollout.events:
        where = f" at {event.where}" if event.where else ""
        terminal.tell(f"  {event.t:9.4f} s  {event.kind:<16} {' '.join(event.balls)}{where}")
    for ball in rollout.layout().values():
        terminal.tell(f"  {ball.id:>4}  x {ball.x:8.4f} m  y {ball.y:8.4f} m  {ball.phase}")
    if step is not None:
        for name in rollout.start:
            for t, x, y in rollout.path(name, step):
                terminal.tell(f"  {name:>4}  t {t:8.4f} s  x {x:8.4f} m  y {y:8.4f} m")
