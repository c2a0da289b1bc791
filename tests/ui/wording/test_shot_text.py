"""A shot in words: what came of it, and an event's numbers worked out here from its balls."""

from __future__ import annotations

import math

import pytest

from pool2d import Ball, Layout, Rollout, Shot, load_table, simulate
from pool2d.ui.wording import shot_text
from pool2d.ui.wording.words import Words

TABLE = load_table("pool-9ft")
WORDS = Words()
RADIUS = TABLE.knobs.ball.radius
CORNERS = [pocket for pocket in TABLE.geometry.pockets if "side" not in pocket.name]


def into(corner: int, ball: str, away: float = 0.3) -> Ball:
    """A ball that rolls straight into a corner pocket."""
    hole = CORNERS[corner]
    way = math.atan2(math.copysign(1.0, 0.635 - hole.y), math.copysign(1.0, 1.27 - hole.x))
    vx, vy = -1.5 * math.cos(way), -1.5 * math.sin(way)
    x, y = hole.x + away * math.cos(way), hole.y + away * math.sin(way)
    return Ball(ball, x, y, vx=vx, vy=vy, wx=-vy / RADIUS, wy=vx / RADIUS)


def outcome(*balls: Ball, cue: str = "cue") -> str:
    return shot_text.outcome(WORDS, simulate(TABLE, Layout(balls)), cue)


def test_what_came_of_a_shot() -> None:
    cue, nine = Ball("cue", 1.27, 0.5), Ball("9", 1.6, 0.9)
    assert outcome(cue, nine) == ""
    assert outcome(cue, nine, into(0, "10"), into(1, "2")) == WORDS.say("outcome.down", balls="2, 10")
    assert outcome(into(0, "cue"), nine) == outcome(into(0, "cue"), into(1, "9")) == WORDS.say("outcome.scratch")
    assert outcome(cue, into(0, "9")) == WORDS.say("outcome.cleared", rack=WORDS.key("rack"))
    # Whichever ball was struck is the cue ball.
    assert outcome(nine, cue, into(0, "3"), cue="3") == WORDS.say("outcome.scratch")


def test_a_tip_that_slips_is_told_instead_of_the_stroke() -> None:
    def struck(side: float) -> Rollout:
        return simulate(TABLE, Layout([Ball("cue", 0.6, 0.6)]), Shot(angle=0.0, speed=2.0, side=side))

    clean, slipped = struck(0.2), struck(0.69)
    assert shot_text.miscued(slipped) and not shot_text.miscued(clean)
    assert shot_text.title(WORDS, slipped.events[0], "cue") == WORDS.say("event.miscue")
    assert shot_text.title(WORDS, clean.events[0], "cue") != WORDS.say("event.miscue")


@pytest.mark.parametrize("way", [0.0, 75.0, 160.0, 250.0])
@pytest.mark.parametrize("side", [-0.5, 0.5])
def test_throw_is_from_the_line_of_centres_to_the_left(way: float, side: float) -> None:
    """Right english throws an object ball that is hit full to the left, left english to the right."""
    cos, sin = math.cos(math.radians(way)), math.sin(math.radians(way))
    balls = Layout([Ball("cue", 1.2, 0.6), Ball("1", 1.2 + 0.3 * cos, 0.6 + 0.3 * sin)])
    # Against squirt, so that the hit is nearly full.
    events = simulate(TABLE, balls, Shot(angle=way + side, speed=2.0, side=side)).events
    contact = next(event for event in events if event.kind == "ball_ball")
    throw = shot_text.throw(contact)
    assert throw is not None
    before, sent = contact.before, contact.after["1"]
    line = math.atan2(before["1"].y - before["cue"].y, before["1"].x - before["cue"].x)
    across = sent.vy * math.cos(line) - sent.vx * math.sin(line)
    assert math.sin(math.radians(throw)) == pytest.approx(across / math.hypot(sent.vx, sent.vy))
    assert math.copysign(1.0, throw) == math.copysign(1.0, side)
    told = shot_text.measures(WORDS, contact, TABLE, balls)
    x, y = ((before["cue"].x + before["1"].x) / 2.0, (before["cue"].y + before["1"].y) / 2.0)
    assert f"{x:.3f}" in told and f"{y:.3f}" in told and f"{abs(throw):.1f}" in told


def test_energy_is_of_travel_and_of_spin_of_balls_of_any_mass() -> None:
    heavy = Ball("1", 1.5, 0.6, mass=0.3, radius=0.03)
    balls = Layout([Ball("cue", 0.6, 0.61), heavy])
    events = simulate(TABLE, balls, Shot(angle=0.0, speed=4.0, height=0.3)).events
    contact = next(event for event in events if event.kind == "ball_ball")

    def energy(ball: Ball, mass: float, radius: float) -> float:
        spin = ball.wx**2 + ball.wy**2 + ball.wz**2
        return 0.5 * mass * (ball.vx**2 + ball.vy**2) + 0.2 * mass * radius**2 * spin

    mass = TABLE.knobs.ball.mass
    before, after = (
        energy(at["cue"], mass, RADIUS) + energy(at["1"], 0.3, 0.03) for at in (contact.before, contact.after)
    )
    assert shot_text.energy_kept(contact, TABLE, balls) == pytest.approx(after / before)


def test_a_ball_that_stops_and_spins_is_told_to_spin_on() -> None:
    for spin in (0.0, 30.0):
        roll = simulate(TABLE, Layout([Ball("1", 1.2, 0.6, vx=0.2, wy=0.2 / RADIUS, wz=spin)]))
        stop = next(event for event in roll.events if event.kind == "rolling_resting")
        key = "event.spins_on" if spin else "event.rolling_resting"
        assert shot_text.title(WORDS, stop, "cue") == shot_text.begun(WORDS.say(key, ball="1"))
