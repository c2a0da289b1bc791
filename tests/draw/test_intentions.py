"""What was meant and what else was looked at, as ways and lines on the table."""

from __future__ import annotations

import math
from dataclasses import replace

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.draw import intentions, theme
from pool2d.draw.intentions import numbered
from pool2d.draw.view import fit
from pool2d.game import Reasons, Thought

TABLE = load_table("pool-9ft")
# The 1 lies before the top right corner, dead straight; the 2 in the middle.
START = Layout([Ball("cue", 1.9, 0.63), Ball("1", 2.2, 0.93), Ball("2", 1.2, 0.9)])
POT = Thought("pot", Shot(45.0, 2.0), "1", "top-right", 0.9, 0.6)
SAFE = Thought("safety", Shot(159.0, 1.0), "2", chance=1.0, value=0.5)


def test_what_was_meant_is_followed_to_its_end_and_others_to_what_they_meet() -> None:
    found = intentions.intentions(TABLE, START, Reasons(POT, (SAFE, replace(POT, shot=Shot(45.05, 2.0)))))
    meant, (safe, other) = found.meant, found.others
    assert meant is not None and safe is not None and other is not None
    rollout = simulate(TABLE, START, POT.shot)
    end = rollout.layout()
    # The 1 into its pocket, the cue ball on to where it rests.
    assert end["1"].phase == "pocketed"
    assert math.dist(meant.balls[-1].points[-1], (end["1"].x, end["1"].y)) < 0.1
    assert meant.fore.after[-1] == pytest.approx((end["cue"].x, end["cue"].y), abs=1e-3)
    assert other.balls and len(other.fore.after) <= 2
    # The safety's 2 to its first rail, not back from it.
    length = sum(math.dist(a, b) for a, b in zip(safe.fore.object, safe.fore.object[1:], strict=False))
    gone = simulate(TABLE, START, SAFE.shot).layout()["2"]
    assert safe.fore.object[0] == pytest.approx((1.2, 0.9)) and length > 0.1
    assert safe.balls == safe.fore.object_ways and gone.phase == "resting"


def test_a_cue_ball_that_was_in_hand_is_shown_where_another_stroke_would_have_put_it() -> None:
    elsewhere = replace(POT, place=(1.6, 0.33))
    (other,) = intentions.intentions(TABLE, START, Reasons(SAFE, (elsewhere,))).others
    assert other is not None and other.stand is not None
    assert (other.stand.x, other.stand.y) == other.fore.cue[0] == (1.6, 0.33)


@pytest.mark.parametrize(
    "wrong",
    [
        replace(POT, shot=Shot(45.0, 2.0, ball="17")),
        replace(POT, place=(2.2, 0.93)),
        replace(POT, place=(99.0, 99.0)),
    ],
    ids=["no such ball", "on another ball", "off the table"],
)
def test_what_no_table_allows_is_left_out(wrong: Thought) -> None:
    found = intentions.intentions(TABLE, START, Reasons(wrong, (wrong, POT)))
    assert found.meant is None and found.others[0] is None and found.others[1] is not None


def test_numbers_do_not_lie_upon_each_other() -> None:
    found = intentions.intentions(TABLE, START, Reasons(SAFE, (POT, replace(POT, shot=Shot(45.02, 2.0)), SAFE)))
    others = [(number, other) for number, other in enumerate(found.others, 1) if other is not None]
    size = TABLE.knobs.table
    places = dict(numbered(others, fit(size.length, size.width, (0, 0, 640, 360)), 18.0))
    assert sorted(places) == [1, 2, 3]
    assert min(math.dist(places[a], places[b]) for a, b in ((1, 2), (1, 3), (2, 3))) >= 17.9


def drawn(why: Reasons) -> pygame.Surface:
    surface = pygame.Surface((640, 360), depth=32)
    surface.fill(theme.CLOTH)
    size = TABLE.knobs.table
    view = fit(size.length, size.width, (0, 0, 640, 360))
    intentions.draw(surface, intentions.intentions(TABLE, START, why), TABLE, view)
    return surface


def count(surface: pygame.Surface, color: theme.Color) -> int:
    return pygame.mask.from_threshold(surface, color[:3], (20, 20, 20, 255)).count()


def test_what_was_meant_and_the_others_have_colours_of_their_own() -> None:
    alone, both = drawn(Reasons(POT)), drawn(Reasons(POT, (SAFE,)))
    assert count(alone, intentions.MEANT) > 30 and count(alone, intentions.OTHER) == 0
    assert count(both, intentions.MEANT) > 30 and count(both, intentions.OTHER) > 30
