"""What holds of every rollout."""

from __future__ import annotations

import math
from collections.abc import Iterable

from pool2d import Ball, Layout, Rollout, Table
from pool2d.physics.values import MOTION_FIELDS, POCKETED, RESTING

NANOMETRE = 1e-9


def energy(table: Table, balls: Iterable[Ball], sizes: Layout | None = None) -> float:
    """Kinetic energy of travel and spin, J; `sizes` knows the radii and masses that states do not carry."""
    total = 0.0
    for ball in balls:
        radius, mass = table.body_of(sizes[ball.id] if sizes else ball)
        spin = ball.wx**2 + ball.wy**2 + ball.wz**2
        total += 0.5 * mass * (ball.vx**2 + ball.vy**2 + 0.4 * radius**2 * spin)
    return total


def misplaced(table: Table, layout: Layout) -> list[str]:
    """Every ball that is where no ball can be."""
    wrong = []
    balls = layout.on_table()
    for i, ball in enumerate(balls):
        if not all(math.isfinite(getattr(ball, name)) for name in MOTION_FIELDS):
            wrong.append(f"{ball} is not finite")
        if not table.on_cloth(ball.x, ball.y):
            wrong.append(f"{ball} is off the table")
        gap, element = table.element_gap(ball.x, ball.y, table.body_of(ball)[0])
        if element is not None and element.kind == "ball_cushion" and gap < -NANOMETRE:
            wrong.append(f"{ball} is {-gap} m inside {element.name}")
        for other in balls[:i]:
            gap = math.hypot(ball.x - other.x, ball.y - other.y) - table.touch(ball, other)
            if gap < -NANOMETRE:
                wrong.append(f"{ball} and {other} overlap by {-gap} m")
    return wrong


def assert_sound(table: Table, roll: Rollout, samples: int = 20) -> None:
    """Energy never rises, nothing overlaps or leaves the table, and all comes to rest."""
    times = sorted([event.t for event in roll.events] + [roll.duration * i / samples for i in range(samples)])
    assert [event.t for event in roll.events] == sorted(event.t for event in roll.events)
    for event in roll.events:
        if event.kind != "cue_ball":
            before = energy(table, event.before.values(), roll.start)
            after = energy(table, event.after.values(), roll.start)
            assert after <= before * (1.0 + 1e-12) + 1e-15, event
    left = math.inf
    for t in times:
        layout = roll.at(t)
        assert not misplaced(table, layout), t
        now = energy(table, layout.values())
        assert now <= left * (1.0 + 1e-12) + 1e-15, t
        left = now
    if not roll.truncated:
        assert {ball.phase for ball in roll.layout().values()} <= {RESTING, POCKETED}
