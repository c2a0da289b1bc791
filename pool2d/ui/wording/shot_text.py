"""A shot in words: each event with its numbers, and what came of it."""

from __future__ import annotations

import math
from string import digits

from ...physics.event import Event
from ...physics.rollout import Rollout
from ...physics.values import AIRBORNE, GONE, MISCUE, OFF, POCKETED, PUSH, Ball, Layout
from ...table.table import Table
from .words import Words

_STILL = 1e-6
# Lower hops and heights than this, m, are told of no event.
_LOW = 5e-5
_BACK = " back"


def title(words: Words, event: Event, cue: str) -> str:
    """What happened, to which balls and where; `cue` is the cue ball."""
    if event.where == MISCUE:
        return words.say("event.miscue")
    balls = [ball_name(words, ball, cue) for ball in (_in_order(event) if event.kind == "ball_ball" else event.balls)]
    where, every = place_name(words, (event.where or "").removesuffix(_BACK)), ", ".join(balls)
    return begun(words.say(f"event.{_told_as(event)}", ball=balls[0], other=balls[-1], balls=every, where=where))


def _told_as(event: Event) -> str:
    """The words for an event: those for its kind, or for what is special about it."""
    where = event.where or ""
    if event.kind == "rolling_resting" and any(ball.wz for ball in event.after.values()):
        return "spins_on"
    if event.kind == "cue_ball" and event.t > 0.0:
        return "cue_ball_push" if where == PUSH else "cue_ball_again"
    if event.kind == "cue_ball" and event.pairs:
        return "cue_ball_through"
    if event.kind == "ball_cushion" and where.endswith(_BACK):
        return "ball_back"
    if event.kind == "ball_slate" and where:
        # A cushion and a pocket may have one name; the rails' top is higher than the bed, the rim is not.
        return "landed_on_rail" if height_of(event) > _LOW else "landed_on_rim"
    return "taken_off" if event.kind == "ball_off" and not where else event.kind


def height_of(event: Event) -> float:
    """How high above the cloth it happened, m: the lowest point of the highest ball."""
    return max(ball.z for ball in event.before.values())


def hop_of(event: Event, gravity: float) -> float:
    """How high the highest of its balls goes after it, m; 0 where none rises."""
    rising = [ball for ball in event.after.values() if ball.phase == AIRBORNE and ball.vz > 0.0]
    return max((ball.z + 0.5 * ball.vz * ball.vz / gravity for ball in rising), default=0.0)


def millimetres(words: Words, length: float) -> str:
    """A small length, m, in millimetres, to a tenth where it is less than ten of them."""
    return f"{words.number(1000.0 * length, '.1f' if abs(length) < 0.00995 else '.0f')} mm"


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
    if (height := height_of(event)) > _LOW:
        parts.append(words.say("telling.height", height=millimetres(words, height)))
    if (hop := hop_of(event, table.physics.gravity)) > _LOW:
        parts.append(words.say("telling.hop", height=millimetres(words, hop)))
    angle = throw(event)
    if angle is not None:
        parts.append(words.say("telling.throw", angle=words.number(abs(angle), ".1f") + "\N{DEGREE SIGN}"))
    kept = energy_kept(event, table, start)
    if kept is not None and event.kind in ("ball_ball", "ball_cushion", "ball_slate", "cluster"):
        parts.append(words.say("telling.kept", percent=f"{100.0 * kept:.0f} %"))
    return "   ".join(part for part in parts if after)


def change(words: Words, event: Event, ball: str, cue: str, brief: bool = False) -> str:
    """A ball's speed and spin, before and after: along the cloth, about the vertical (side), and its speed upward.

    Of the last where there is any; where it is to be `brief`, of side too.
    """
    old, new = event.before[ball], event.after[ball]
    side, side_after = words.number(old.wz, ".0f"), words.number(new.wz, ".0f")
    numbers = {
        "speed": words.number(_speed(old), ".2f"), "speed_after": words.number(_speed(new), ".2f"),
        "roll": words.number(_roll(old), ".0f"), "roll_after": words.number(_roll(new), ".0f"),
    }  # fmt: skip
    name = ball_name(words, ball, cue)
    if brief and side == side_after == "0":
        told = words.say("telling.change_unspun", ball=name, **numbers)
    else:
        told = words.say("telling.change", ball=name, side=side, side_after=side_after, **numbers)
    if max(abs(old.vz), abs(new.vz)) > _STILL:
        rise, rise_after = (words.number(ball.vz, ".2f") for ball in (old, new))
        told = words.say("telling.rise", told=told, rise=rise, rise_after=rise_after)
    return begun(told)


def throw(event: Event) -> float | None:
    """The angle, in degrees, from the line of centres to the way a ball at rest is sent; None for other events.

    Positive to the left, seen along the line; nothing is told of balls that meet in the air.
    """
    if event.kind != "ball_ball":
        return None
    first, second = _in_order(event)
    hitter, struck, sent = event.before[first], event.before[second], event.after[second]
    if _speed(struck) > _STILL or _speed(sent) < _STILL or height_of(event) > _LOW:
        return None
    line = math.atan2(struck.y - hitter.y, struck.x - hitter.x)
    return math.degrees(math.remainder(math.atan2(sent.vy, sent.vx) - line, math.tau))


def energy_kept(event: Event, table: Table, start: Layout) -> float | None:
    """The part of the balls' kinetic energy, of travel and spin, that is left afterwards; None where there was none."""
    before = sum(_energy(ball, table.body_of(start[ball.id])) for ball in event.before.values())
    after = sum(_energy(ball, table.body_of(start[ball.id])) for ball in event.after.values())
    return after / before if before > 0.0 else None


def outcome(words: Words, rollout: Rollout, cue: str) -> str:
    """What came of a shot: a scratch, a cleared table, the balls that fell or left it; or nothing worth saying."""
    end = rollout.layout()
    if cue in end and end[cue].phase in GONE and rollout.start[cue].phase not in GONE:
        return words.say("outcome.cue_off" if end[cue].phase == OFF else "outcome.scratch")
    if all(ball.id == cue for ball in end.on_table()):
        return words.say("outcome.cleared", rack=words.key("rack"))
    said = []
    for phase, key in ((POCKETED, "down"), (OFF, "off")):
        gone = sorted((ball.id for ball in rollout.start.on_table() if end[ball.id].phase == phase), key=_by_number)
        if gone:
            said.append(words.say(f"outcome.{key}", balls=", ".join(ball_name(words, ball, cue) for ball in gone)))
    return " ".join(said)


def _by_number(ball: str) -> tuple[int, str]:
    return len(ball), ball


def _energy(ball: Ball, body: tuple[float, float]) -> float:
    radius, mass = body
    spin = ball.wx**2 + ball.wy**2 + ball.wz**2
    return 0.5 * mass * (ball.vx**2 + ball.vy**2 + ball.vz**2 + 0.4 * radius * radius * spin)


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
    """How fast a ball goes in plan, m/s."""
    return math.hypot(ball.vx, ball.vy)


def _roll(ball: Ball) -> float:
    return math.hypot(ball.wx, ball.wy)
