"""The guide shows what flies, and over what."""

from __future__ import annotations

import math
from itertools import pairwise

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table
from pool2d.draw import guide, ways
from pool2d.draw.view import fit
from pool2d.table.flights import jumped

from .test_guide import distance, short

TABLE = load_table("pool-9ft")

JUMPED = Layout([Ball("cue", 0.8, 0.635), Ball("7", 1.02, 0.635), Ball("1", 1.9, 0.66)])
JUMP = Shot(angle=0.9, speed=3.2, elevation=42.0)


def test_a_flight_is_a_part_of_the_way_of_its_own() -> None:
    rollout = short(JUMPED, JUMP)
    parts = ways.ways(rollout, "cue")
    slate = [event for event in rollout.events if event.kind == "ball_slate" and "cue" in event.balls]
    assert [part.aloft for part in parts[:2]] == [True, True]
    first, landing = parts[0], slate[0].before["cue"]
    assert first.lands and first.points[-1] == pytest.approx((landing.x, landing.y))
    # In the air a way is straight.
    assert len(first.points) == 2
    line = ways.joined(parts)
    assert line == ways.trace(rollout, "cue") and len(set(line)) == len(line)


def test_a_way_that_is_cut_off_in_the_air_does_not_land() -> None:
    (part,) = ways.ways(short(JUMPED, JUMP), "cue", length=0.2)
    assert part.aloft and not part.lands
    assert math.dist(part.points[0], part.points[-1]) == pytest.approx(0.2)


@pytest.mark.parametrize(("dash", "gap"), [(7.0, 5.0), (1.0, 0.25), (100.0, 5.0)])
def test_dashes_lie_on_the_line_and_are_as_long_as_they_should_be(dash: float, gap: float) -> None:
    line = [(0.0, 0.0), (3.0, 4.0), (3.0, 14.0), (33.0, 54.0)]
    pieces = ways.dashes(line, dash, gap)
    lengths = [sum(math.dist(a, b) for a, b in pairwise(piece)) for piece in pieces]
    assert lengths[:-1] == pytest.approx([dash] * (len(lengths) - 1)) and 0.0 < lengths[-1] <= dash + 1e-9
    assert pieces[0][0] == line[0]
    assert all(distance(point, line) < 1e-9 for piece in pieces for point in piece)
    assert sum(lengths) + gap * (len(pieces) - 1) >= 65.0 - gap - 1e-9


def test_the_guide_does_not_end_while_the_cue_ball_is_in_the_air() -> None:
    rollout = short(JUMPED, JUMP)
    assert guide.hit(rollout.events[-1], "cue") or any(guide.hit(event, "cue") == "1" for event in rollout.events)
    shown = guide.foresee(rollout, "cue")
    assert shown.ghost is not None and len(shown.object) > 1


def test_what_is_jumped_is_ringed_and_its_gap_written() -> None:
    pygame.font.init()
    rollout = short(JUMPED, JUMP)
    view = fit(2.54, 1.27, (0, 0, 640, 360))
    over = [(JUMPED[one.ball], one) for one in jumped(rollout, TABLE, "cue")]
    assert [ball.id for ball, _ in over] == ["7"]
    without, marked = (pygame.Surface((640, 360)) for _ in range(2))
    guide.draw(without, guide.foresee(rollout, "cue"), guide.GHOST, TABLE, view)
    guide.draw(marked, guide.foresee(rollout, "cue"), guide.GHOST, TABLE, view, over)
    off = pygame.surfarray.array3d(without) != pygame.surfarray.array3d(marked)
    x, y = view.to_screen(1.02, 0.635)
    columns, rows = off.any(axis=2).any(axis=1).nonzero()[0], off.any(axis=2).any(axis=0).nonzero()[0]
    assert columns.min() > x - 40 and columns.max() < x + 40
    assert y - 40 < rows.min() < y - 10 and rows.max() < y + 15


def test_the_gap_of_a_ball_below_the_cue_ball_is_written_below_it() -> None:
    """Above it the cue ball, drawn later, would hide the figure."""
    pygame.font.init()
    balls = Layout([Ball("cue", 1.0, 0.72), Ball("7", 1.0, 0.62), Ball("1", 1.0, 0.2)])
    rollout = short(balls, Shot(-90.0, 3.4, elevation=60.0, jump=True))
    view = fit(2.54, 1.27, (0, 0, 640, 360))
    over = [(balls[one.ball], one) for one in jumped(rollout, TABLE, "cue")]
    assert [ball.id for ball, _ in over] == ["7"]
    without, marked = (pygame.Surface((640, 360)) for _ in range(2))
    guide.draw(without, guide.foresee(rollout, "cue"), guide.GHOST, TABLE, view)
    guide.draw(marked, guide.foresee(rollout, "cue"), guide.GHOST, TABLE, view, over)
    off = pygame.surfarray.array3d(without) != pygame.surfarray.array3d(marked)
    _, y = view.to_screen(1.0, 0.62)
    rows = off.any(axis=2).any(axis=0).nonzero()[0]
    assert rows.min() > y - 12 and y + 14 < rows.max() < y + 40
