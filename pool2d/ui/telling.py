"""A shot in words: each event with its numbers, and what came of it."""

from __future__ import annotations

import math

from ..physics.rollout import Event, Rollout
from ..physics.values import POCKETED, Ball
from ..table import Table

CONTACTS = ("cue_ball", "ball_ball", "ball_cushion", "ball_pocket", "cluster")
_STILL = 1e-6


def title(event: Event) -> str:
    """What happened, to which balls and where."""
    where = (event.where or "").replace("-", " ")
    if event.kind == "cue_ball":
        return "The cue strikes" if where != "miscue" else "Miscue"
    if event.kind == "ball_ball":
        first, second = _in_order(event)
        return f"{_name(first)} meets {_name(second)}"
    if event.kind == "cluster":
        return f"{', '.join(_name(ball) for ball in event.balls)} meet at once"
    ball = _name(event.balls[0])
    return {
        "ball_cushion": f"{ball} meets the cushion, {where}",
        "ball_pocket": f"{ball} falls, {where}",
        "sliding_rolling": f"{ball} slides no more: it rolls",
        "rolling_resting": f"{ball} comes to rest",
        "spin_end": f"{ball} stops spinning",
    }.get(event.kind, f"{ball}: {event.kind.replace('_', ' ')}")


def missed(rollout: Rollout) -> bool:
    """Whether the tip slipped off the ball."""
    return any(event.where == "miscue" for event in rollout.events)


def measures(event: Event, table: Table) -> str:
    """When and where it happened, the throw of a ball by a ball, and how much of their energy the balls keep."""
    before, after = event.before, event.after
    x = sum(ball.x for ball in before.values()) / len(before)
    y = sum(ball.y for ball in before.values()) / len(before)
    parts = [f"{event.t:.3f} s", f"at {x:.3f}, {y:.3f} m"]
    angle = throw(event)
    if angle is not None:
        parts.append(f"throw {abs(angle):.1f}\N{DEGREE SIGN}")
    kept = energy_kept(event, table)
    if kept is not None and event.kind in ("ball_ball", "ball_cushion", "cluster"):
        parts.append(f"keeps {100.0 * kept:.0f} % of the energy")
    return "   ".join(part for part in parts if after)


def change(event: Event, ball: str) -> str:
    """A ball's speed and spin, before and after: along the cloth, and about the vertical (side)."""
    old, new = event.before[ball], event.after[ball]
    return (
        f"{_name(ball)}  {_speed(old):.2f} to {_speed(new):.2f} m/s, "
        f"roll {_roll(old):.0f} to {_roll(new):.0f}, side {old.wz:.0f} to {new.wz:.0f} rad/s"
    )


def throw(event: Event) -> float | None:
    """The angle, in degrees, from the line of centres to the way a ball at rest is sent; None for other events.

    Positive to the left, seen along the line.
    """
    if event.kind != "ball_ball":
        return None
    first, second = _in_order(event)
    hitter, struck, sent = event.before[first], event.before[second], event.after[second]
    if _speed(struck) > _STILL or _speed(sent) < _STILL:
        return None
    line = math.atan2(struck.y - hitter.y, struck.x - hitter.x)
    return math.degrees(math.remainder(math.atan2(sent.vy, sent.vx) - line, math.tau))


def energy_kept(event: Event, table: Table) -> float | None:
    """The part of the balls' kinetic energy, of travel and spin, that is left afterwards; None where there was none."""
    before = sum(_energy(ball, table) for ball in event.before.values())
    after = sum(_energy(ball, table) for ball in event.after.values())
    return after / before if before > 0.0 else None


def outcome(rollout: Rollout, cue: str) -> str:
    """What came of a shot: a scratch, a cleared table, the balls that fell; or nothing worth saying."""
    end = rollout.layout()
    fallen = [ball.id for ball in rollout.start.on_table() if end[ball.id].phase == POCKETED]
    if cue in fallen:
        return "Scratch: the cue ball is in hand. Click where it shall stand."
    if all(ball.id == cue for ball in end.on_table()):
        return "The table is cleared. N sets up a new rack."
    return f"Down: {', '.join(sorted(fallen, key=lambda ball: (len(ball), ball)))}." if fallen else ""


def _energy(ball: Ball, table: Table) -> float:
    radius, mass = table.body_of(ball)
    spin = ball.wx**2 + ball.wy**2 + ball.wz**2
    return 0.5 * mass * (ball.vx**2 + ball.vy**2 + 0.4 * radius * radius * spin)


def _in_order(event: Event) -> tuple[str, str]:
    """The two balls, the faster first."""
    a, b = event.balls[:2]
    return (a, b) if _speed(event.before[a]) >= _speed(event.before[b]) else (b, a)


def _name(ball: str) -> str:
    return "Cue ball" if ball == "cue" else ball


def _speed(ball: Ball) -> float:
    return math.hypot(ball.vx, ball.vy)


def _roll(ball: Ball) -> float:
    return math.hypot(ball.wx, ball.wy)
