"""A shot in words: each event with its numbers, and what came of it."""

from __future__ import annotations

import math
from string import digits

from ...physics.event import Event
from ...physics.rollout import Rollout
from ...physics.values import MISCUE, POCKETED, Ball, Layout
from ...table.table import Table
from .words import Words

_STILL = 1e-6


def title(words: Words, event: Event, cue: str) -> str:
    """What happened, to which balls and where; `cue` is the cue ball."""
    if event.where == MISCUE:
        return words.say("event.miscue")
    balls = [ball_name(words, ball, cue) for ball in (_in_order(event) if event.kind == "ball_ball" else event.balls)]
    where, every = place_name(words, event.where or ""), ", ".join(balls)
    spins = event.kind == "rolling_resting" and any(ball.wz for ball in event.after.values())
    through = event.kind == "cue_ball" and event.pairs
    kind = "spins_on" if spins else "cue_ball_through" if through else event.kind
    return begun(words.say(f"event.{kind}", ball=balls[0], other=balls[-1], balls=every, where=where))


def miscued(rollout: Rollout) -> bool:
    """Whether the tip slipped off the ball."""
    return any(event.where == MISCUE for event in rollout.events)


def measures(words: Words, event: Event, table: Table, start: Layout) -> str:
    """When and where it happened, the throw of a ball by a ball, and how much of their energy the balls keep.

    `start` is the layout of the shot: it tells which balls have a mass and radius of their own.
    """
    before, after = event.before, event.after
    x = sum(ball.x for ball in before.values()) / len(before)
    y = sum(ball.y for ball in before.values()) / len(before)
    place = words.say("telling.place", x=words.number(x, ".3f"), y=words.number(y, ".3f"))
    parts = [f"{words.number(event.t, '.3f')} s", place]
    angle = throw(event)
    if angle is not None:
        parts.append(words.say("telling.throw", angle=words.number(abs(angle), ".1f") + "\N{DEGREE SIGN}"))
    kept = energy_kept(event, table, start)
    if kept is not None and event.kind in ("ball_ball", "ball_cushion", "cluster"):
        parts.append(words.say("telling.kept", percent=f"{100.0 * kept:.0f} %"))
    return "   ".join(part for part in parts if after)


def change(words: Words, event: Event, ball: str, cue: str) -> str:
    """A ball's speed and spin, before and after: along the cloth, and about the vertical (side)."""
    old, new = event.before[ball], event.after[ball]
    told = words.say(
        "telling.change",
        ball=ball_name(words, ball, cue),
        speed=words.number(_speed(old), ".2f"), speed_after=words.number(_speed(new), ".2f"),
        roll=f"{_roll(old):.0f}", roll_after=f"{_roll(new):.0f}",
        side=f"{old.wz:.0f}", side_after=f"{new.wz:.0f}",
    )  # fmt: skip
    return begun(told)


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


def energy_kept(event: Event, table: Table, start: Layout) -> float | None:
    """The part of the balls' kinetic energy, of travel and spin, that is left afterwards; None where there was none."""
    before = sum(_energy(ball, table.body_of(start[ball.id])) for ball in event.before.values())
    after = sum(_energy(ball, table.body_of(start[ball.id])) for ball in event.after.values())
    return after / before if before > 0.0 else None


def outcome(words: Words, rollout: Rollout, cue: str) -> str:
    """What came of a shot: a scratch, a cleared table, the balls that fell; or nothing worth saying."""
    end = rollout.layout()
    fallen = [ball.id for ball in rollout.start.on_table() if end[ball.id].phase == POCKETED]
    if cue in fallen:
        return words.say("outcome.scratch")
    if all(ball.id == cue for ball in end.on_table()):
        return words.say("outcome.cleared", rack=words.key("rack"))
    fallen.sort(key=lambda ball: (len(ball), ball))
    return words.say("outcome.down", balls=", ".join(ball_name(words, ball, cue) for ball in fallen)) if fallen else ""


def _energy(ball: Ball, body: tuple[float, float]) -> float:
    radius, mass = body
    spin = ball.wx**2 + ball.wy**2 + ball.wz**2
    return 0.5 * mass * (ball.vx**2 + ball.vy**2 + 0.4 * radius * radius * spin)


def _in_order(event: Event) -> tuple[str, str]:
    """The two balls, the faster first."""
    a, b = event.balls[:2]
    return (a, b) if _speed(event.before[a]) >= _speed(event.before[b]) else (b, a)


def ball_name(words: Words, ball: str, cue: str) -> str:
    """What a ball is called: "cue ball", "red 6", or what its table calls it."""
    if ball == cue:
        return words.say("ball.its_own")
    color = ball.rstrip(digits)
    return f"{words.say(f'ball.{color}')} {ball[len(color) :]}".rstrip() if words.known(f"ball.{color}") else ball


def place_name(words: Words, name: str) -> str:
    """A cushion, a pocket or its jaw, by the words in its name; words that mean nothing stay."""
    place, _, jaw = name.partition(" ")
    told = " ".join(words.say_or(f"place.{word}", word) for word in place.split("-"))
    return words.say("telling.jaw", where=told) if jaw == "jaw" else f"{told} {jaw}".rstrip()


def begun(sentence: str) -> str:
    """A sentence with its first letter large."""
    return sentence[:1].upper() + sentence[1:]


def _speed(ball: Ball) -> float:
    return math.hypot(ball.vx, ball.vy)


def _roll(ball: Ball) -> float:
    return math.hypot(ball.wx, ball.wy)
