"""The guide shows what the shot does."""

from __future__ import annotations

import math
from itertools import pairwise

import pygame
import pytest

from pool2d import Ball, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.draw import guide, ways
from pool2d.draw.balls import ball_art
from pool2d.draw.view import fit
from pool2d.physics.values import POCKETED

from ..scenes import random_shot

TABLE = load_table("pool-9ft")
CUE = Ball("cue", 0.635, 0.5)
CUT = Layout([CUE, Ball("1", 1.5, 0.53)])


def angle(line: ways.Line) -> float:
    (ax, ay), (bx, by) = line[0], line[-1]
    return math.degrees(math.atan2(by - ay, bx - ax))


def seen(shot: Shot, layout: Layout = CUT) -> guide.Guide:
    return guide.foresee(short(layout, shot), "cue")


def short(layout: Layout, shot: Shot, level: int = guide.GHOST, table: Table = TABLE) -> Rollout:
    """As much of a shot as the guide of a level needs."""
    return simulate(table, layout, shot, until=guide.Enough(level, "cue"))


def test_the_ghost_of_a_ball_that_is_larger_than_others_is_as_large() -> None:
    large = Layout([CUE._replace(radius=0.035), Ball("1", 1.5, 0.53)])
    ghost = seen(Shot(angle=1.0, speed=2.0), large).ghost
    assert ghost is not None and TABLE.body_of(ghost)[0] == 0.035
    assert math.hypot(ghost.x - 1.5, ghost.y - 0.53) == pytest.approx(0.035 + 0.028575, rel=0.02)


def test_the_ghost_ball_touches_the_ball_it_will_hit() -> None:
    view = seen(Shot(angle=1.0, speed=2.0))
    assert view.ghost is not None
    one = CUT["1"]
    assert math.hypot(view.ghost.x - one.x, view.ghost.y - one.y) == pytest.approx(2 * 0.028575, abs=1e-8)
    assert view.cue[0] == (CUE.x, CUE.y)
    assert view.cue[-1] == pytest.approx((view.ghost.x, view.ghost.y))
    assert view.object[0] == pytest.approx((one.x, one.y))


def test_without_friction_the_object_ball_leaves_along_the_line_of_centres() -> None:
    smooth = TABLE.with_knobs({"ball.law": "frictionless"})
    view = guide.foresee(short(CUT, Shot(angle=1.0, speed=2.0), table=smooth), "cue")
    assert view.ghost is not None
    line = math.degrees(math.atan2(CUT["1"].y - view.ghost.y, CUT["1"].x - view.ghost.x))
    assert angle(view.object[:2]) == pytest.approx(line, abs=1e-6)
    # Friction throws it off that line, toward the way the cue ball travels, and more where it is slow.
    fast, slow = (angle(seen(Shot(angle=1.0, speed=speed)).object[:2]) for speed in (2.0, 1.0))
    assert slow < line - 0.5
    assert slow < fast < line - 0.3


def test_english_squirts_the_cue_ball_away() -> None:
    alone = Layout([CUE])
    straight = seen(Shot(angle=0.0, speed=2.0), alone)
    right = seen(Shot(angle=0.0, speed=2.0, side=0.4), alone)
    assert angle(straight.cue[:2]) == pytest.approx(0.0, abs=1e-9)
    assert angle(right.cue[:2]) > 1.0


def test_an_elevated_cue_makes_the_path_swerve_back() -> None:
    line = seen(Shot(angle=0.0, speed=3.0, side=0.3, elevation=20.0), Layout([CUE])).cue
    assert angle(line[1:3]) < angle(line[:2])


def distance(point: tuple[float, float], line: ways.Line) -> float:
    """How far a point is from a line of several pieces."""
    found = math.inf
    for (ax, ay), (bx, by) in pairwise(line):
        dx, dy = bx - ax, by - ay
        size = dx * dx + dy * dy
        part = min(max(((point[0] - ax) * dx + (point[1] - ay) * dy) / size, 0.0), 1.0) if size > 0.0 else 0.0
        found = min(found, math.dist(point, (ax + part * dx, ay + part * dy)))
    return found


STOPPED = Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.0, 0.6)])
RACK = TABLE.rack("eight-ball", seed=3)
# Swerve, draw that turns the ball on its own line and off it, a stop shot, a masse, a break.
BENT = {
    "swerve": (Layout([CUE]), Shot(angle=0.0, speed=3.0, side=0.3, elevation=20.0)),
    "draw": (STOPPED, Shot(speed=3.0, height=-0.4)),
    "draw, cut": (CUT, Shot(angle=1.0, speed=4.0, height=-0.4)),
    "stop": (STOPPED, Shot(speed=4.0, height=-0.1)),
    "masse": (Layout([CUE]), Shot(angle=10.0, speed=3.0, side=0.4, height=-0.2, elevation=75.0)),
    "break": (RACK, Shot(angle=0.5, speed=7.0)),
}


@pytest.mark.parametrize("name", BENT)
@pytest.mark.parametrize("within", [0.0003, 0.003])
def test_the_chords_of_a_trace_stay_within_what_was_asked(name: str, within: float) -> None:
    rollout = simulate(TABLE, *BENT[name])
    for ball in rollout.tracks:
        line = ways.trace(rollout, ball, within=within)
        for motion, after in pairwise(rollout.tracks[ball]):
            end = min(after.t0, motion.t1)
            if motion.t0 < end and not motion.stays():
                # Its own chords: another part of the way that comes by must not stand in for them.
                chords = ways.trace(rollout, ball, motion.t0, end, within=within)
                assert set(chords[1:]) <= set(line)
                for step in range(41):
                    place = motion.place(motion.t0 + (end - motion.t0) * step / 40)
                    assert distance(place, chords) <= within * (1.0 + 1e-6)


def test_a_trace_has_few_chords_where_the_way_is_straight() -> None:
    rollout = simulate(TABLE, *BENT["break"])
    moved = [motion for track in rollout.tracks.values() for motion in track if not motion.stays()]
    chords = sum(len(list(pairwise(ways.trace(rollout, ball)))) for ball in rollout.tracks)
    assert len(moved) <= chords < 3 * len(moved)
    straight = simulate(TABLE, Layout([CUE]), Shot(angle=30.0, speed=0.5))
    assert len(straight.tracks["cue"]) == 4
    assert [len(ways.trace(straight, "cue", m.t0, m.t1)) for m in straight.tracks["cue"][1:3]] == [2, 2]


def test_the_way_of_the_cue_ball_after_the_contact_is_cut_to_length() -> None:
    view = guide.foresee(short(CUT, Shot(angle=1.0, speed=4.0)), "cue", length=0.3)
    assert sum(math.dist(a, b) for a, b in pairwise(view.after)) == pytest.approx(0.3)


@pytest.mark.parametrize("angle", [1.0, 2.7])
def test_the_object_balls_line_ends_at_what_it_meets(angle: float) -> None:
    shot = Shot(angle=angle, speed=3.0)
    met = next(
        event for event in simulate(TABLE, CUT, shot).events if event.kind == "ball_cushion" and "1" in event.balls
    )
    ball = met.before["1"]
    assert seen(shot).object[-1] == pytest.approx((ball.x, ball.y), abs=1e-9)


def test_the_object_balls_line_ends_where_it_comes_to_rest() -> None:
    shot = Shot(angle=1.8, speed=0.6)
    end = simulate(TABLE, CUT, shot).layout()["1"]
    assert seen(shot).object[-1] == pytest.approx((end.x, end.y), abs=1e-9)


@pytest.mark.parametrize("seed", range(40))
def test_what_the_guide_shows_is_the_same_of_as_much_of_a_shot_as_it_asks_for(seed: int) -> None:
    layout, shot = random_shot(TABLE, seed, 2 + seed % 9)
    whole = simulate(TABLE, layout, shot)
    full, part = guide.foresee(whole, "cue"), short(layout, shot)
    assert guide.foresee(part, "cue") == full
    assert [event.t for event in part.events] == [event.t for event in whole.events[: len(part.events)]]
    line = short(layout, shot, guide.LINE)
    assert guide.foresee(line, "cue").cue == full.cue
    assert len(short(layout, shot, guide.WHOLE).events) == len(whole.events)


def test_a_trace_meets_the_rollout() -> None:
    rollout = simulate(TABLE, CUT, Shot(angle=1.0, speed=4.0))
    line = ways.trace(rollout, "1")
    end = rollout.layout()["1"]
    assert line[0] == (CUT["1"].x, CUT["1"].y)
    assert line[-1] == pytest.approx((end.x, end.y), abs=1e-9)


def test_a_shot_that_meets_nothing_has_no_ghost() -> None:
    view = seen(Shot(angle=90.0, speed=0.3), Layout([CUE]))
    assert view.ghost is None
    assert view.object == []
    assert view.cue[-1][1] > CUE.y


def test_with_the_ghost_ball_a_dot_ends_the_way_of_the_object_ball_and_a_line_alone_has_neither() -> None:
    shown, view = seen(Shot(angle=1.0, speed=1.0)), fit(2.54, 1.27, (0, 0, 1280, 720))
    assert shown.ghost is not None
    x, y = view.to_screen(*shown.object[-1])
    middle = view.to_screen(shown.ghost.x, shown.ghost.y)

    def drawn(level: int, what: guide.Guide = shown) -> pygame.Surface:
        picture = pygame.Surface((1280, 720))
        guide.draw(picture, what, level, TABLE, view)
        return picture

    def lit(picture: pygame.Surface, place: tuple[float, float], reach: int) -> int:
        """How many pixels are lit in a square about a place."""
        part = picture.subsurface((round(place[0]) - reach, round(place[1]) - reach, 2 * reach + 1, 2 * reach + 1))
        return int((pygame.surfarray.array3d(part).max(axis=2) > 40).sum())

    # The dot is three pixels in radius, some of it beyond the end of the way, which is thinner.
    assert lit(drawn(guide.GHOST), (x, y), 6) > 30
    for level in (guide.LINE, guide.WHOLE):
        assert lit(drawn(level), (x, y), 6) == 0
    # The ghost ball is drawn with the whole guide too.
    assert lit(drawn(guide.GHOST), middle, 20) > 100 and lit(drawn(guide.WHOLE), middle, 20) > 100
    assert lit(drawn(guide.LINE), middle, 20) < 100
    nothing = seen(Shot(angle=90.0, speed=0.3), Layout([CUE]))
    for level in (guide.LINE, guide.GHOST, guide.WHOLE):
        assert lit(drawn(level, nothing), view.to_screen(CUE.x, CUE.y + 0.02), 6) > 0


@pytest.mark.parametrize("ball", ["1", "2", "3", "14"])
def test_in_the_whole_guide_a_way_has_the_colour_of_its_ball(ball: str) -> None:
    layout = Layout([Ball("cue", 0.6, 0.6), Ball(ball, 0.9, 0.6)])
    rollout = simulate(TABLE, layout, Shot(speed=1.5))
    view = fit(2.54, 1.27, (0, 0, 1280, 720))
    picture = pygame.Surface((1280, 720))
    guide.draw_whole(picture, rollout, TABLE, view)
    # Where the object ball is half-way, beyond where the cue ball comes.
    at = rollout.layout()[ball].x
    x, y = view.to_screen(0.5 * (at + rollout.layout()["cue"].x), 0.6)
    drawn, own = picture.get_at((round(x), round(y))), pygame.Color(ball_art.usual(ball).color)
    assert drawn.hsva[0] == pytest.approx(own.hsva[0], abs=3.0)
    assert drawn.hsva[1] > 25.0


def test_the_whole_guide_rings_the_pocket_that_a_ball_falls_into() -> None:
    layout = Layout([Ball("cue", 0.6, 0.6), Ball("3", 0.3, 0.3)])
    rollout = simulate(TABLE, layout, Shot(angle=225.0, speed=2.5))
    fallen = rollout.layout()["3"]
    assert fallen.phase == POCKETED
    view = fit(2.54, 1.27, (0, 0, 1280, 720))
    picture = pygame.Surface((1280, 720))
    guide.draw_whole(picture, rollout, TABLE, view)
    x, y = view.to_screen(fallen.x, fallen.y)
    radius = 0.028575 * view.scale
    ring = [
        picture.get_at((round(x + radius * math.cos(turn)), round(y + radius * math.sin(turn))))[0]
        for turn in (i * math.tau / 12 for i in range(12))
    ]
    assert min(ring) > 60


def test_while_an_aim_turns_no_ball_at_rest_is_painted_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    view, picture = fit(2.54, 1.27, (0, 0, 1280, 720)), pygame.Surface((1280, 720))

    def draw(turn: float) -> tuple[float, float]:
        rollout = simulate(TABLE, CUT, Shot(angle=turn, speed=1.2))
        guide.draw_whole(picture, rollout, TABLE, view)
        end = rollout.layout()["1"]
        return view.to_screen(end.x, end.y)

    ends = [draw(1.0)]
    monkeypatch.setattr(ball_art, "render", lambda *_: pytest.fail("painted"))
    ends += [draw(1.0 + 0.1 * i) for i in range(1, 9)]
    assert len({(x % 1.0 // 0.25, y % 1.0 // 0.25) for x, y in ends}) > 3
