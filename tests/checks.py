"""What holds of every rollout."""

from __future__ import annotations

import math
from collections.abc import Iterable

from pool2d import Ball, Layout, Rollout, Table
from pool2d.physics.values import GONE, MOTION_FIELDS, POCKETED, RESTING

NANOMETRE = 1e-9


def energy(table: Table, balls: Iterable[Ball], sizes: Layout | None = None) -> float:
    """Energy of travel, spin and height above the cloth, J; `sizes` knows radii and masses that states do not carry."""
    total = 0.0
    for ball in balls:
        radius, mass = table.body_of(sizes[ball.id] if sizes else ball)
        spin = ball.wx**2 + ball.wy**2 + ball.wz**2
        total += 0.5 * mass * (ball.vx**2 + ball.vy**2 + ball.vz**2 + 0.4 * radius**2 * spin)
        # What has fallen into a pocket is told as lying at the height of the cloth.
        total += mass * table.knobs.gravity * (-radius if ball.phase == POCKETED else ball.z)
    return total


def misplaced(table: Table, layout: Layout) -> list[str]:
    """Every ball that is where no ball can be."""
    wrong = []
    balls = layout.on_table()
    for i, ball in enumerate(balls):
        if not all(math.isfinite(getattr(ball, name)) for name in MOTION_FIELDS):
            wrong.append(f"{ball} is not finite")
        radius = table.body_of(ball)[0]
        if ball.z == 0.0:
            if not table.on_cloth(ball.x, ball.y):
                wrong.append(f"{ball} is off the table")
        elif (room := table.bed.room(ball.x, ball.y, ball.z, radius))[0] < -NANOMETRE:
            wrong.append(f"{ball} is {-room[0]} m inside {room[1]}")
        gap, element = table.element_gap(ball.x, ball.y, radius) if ball.z == 0.0 else (0.0, None)
        if element is not None and element.kind == "ball_cushion" and gap < -NANOMETRE:
            wrong.append(f"{ball} is {-gap} m inside {element.name}")
        for other in balls[:i]:
            touch = table.body_of(other)[0] + radius
            gap = math.hypot(ball.x - other.x, ball.y - other.y, ball.z - other.z + 2.0 * radius - touch) - touch
            if gap < -NANOMETRE:
                wrong.append(f"{ball} and {other} overlap by {-gap} m")
    return wrong


def assert_sound(table: Table, roll: Rollout, samples: int = 20) -> None:
    """Energy rises by what a tip brings alone, nothing overlaps or leaves the table, and all comes to rest."""
    strokes = {event.t for event in roll.events if event.kind == "cue_ball"}
    times = sorted([event.t for event in roll.events] + [roll.duration * i / samples for i in range(samples)])
    assert [event.t for event in roll.events] == sorted(event.t for event in roll.events)
    for event in roll.events:
        if event.kind != "cue_ball":
            before = energy(table, event.before.values(), roll.start)
            after = energy(table, event.after.values(), roll.start)
            assert after <= before + 1e-12 * abs(before) + 1e-15, event
    left = 1e9
    for t in times:
        layout = roll.at(t)
        assert not misplaced(table, layout), t
        now = energy(table, layout.values())
        assert t in strokes or now <= left + 1e-12 * abs(left) + 1e-15, t
        left = now
    if not roll.truncated:
        assert {ball.phase for ball in roll.layout().values()} <= {RESTING, *GONE}
