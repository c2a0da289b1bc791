"""How far the butt has to be raised, so that the cue goes through nothing on its way to the ball."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from ..errors import InputError, suggest
from ..physics.cue.cue_body import INF, TAPER, UPRIGHT, CueBody
from ..physics.values import Ball, Layout, Shot
from .rail_tops import AimFrame
from .table import Table

# What a cue is over that is raised for the bed alone.
CLOTH = "cloth"
# An elevation this near to one that clears, radians, clears.
_SAME = 1e-12


class Clearance(NamedTuple):
    """How far a stroke's butt has to be raised, degrees, and what it is over then.

    `elevation` is the least, from the shot's own on, at which the cue goes through nothing; None where there is none up
    to upright. `over` is what makes it that, or what is in the way to the last: a ball's id, the name of a cushion or
    jaw as events have it, "<pocket> back" for the far edge of a pocket, or "cloth"; empty where the shot's own
    elevation does.
    """

    elevation: float | None
    over: str


class _Bar(NamedTuple):
    """What is in the cue's way between two elevations, radians."""

    entry: float
    exit: float
    name: str


def least_elevation(table: Table, layout: Layout, shot: Shot) -> Clearance:
    """The least elevation, from the shot's own on, at which the cue goes through no rail and no ball.

    The cue is a cone (`cue_body`) that may run on as far as the middle of the ball. A rail is solid up to the height of
    its nose, and behind that as wide as rails are (`rail_tops`); a pocket's mouth and hole are open, and the rail goes
    on behind them. The hand is not counted. An easy stroke is clear as it is. Raises InputError as `simulate` does for
    balls that cannot stand there, and for a shot that is none.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, least_elevation, load_table
        >>> layout = Layout([Ball("cue", 0.1, 0.635), Ball("7", 1.0, 0.635)])
        >>> needed = least_elevation(load_table("pool-9ft"), layout, Shot(angle=0.0))
        >>> round(needed.elevation, 1), needed.over
        (8.3, 'left')
        >>> least_elevation(load_table("pool-9ft"), layout, Shot(angle=0.0, elevation=20.0))
        Clearance(elevation=20.0, over='')
    """
    shot.check()
    layout = table.settle(layout)
    if shot.ball not in layout:
        raise InputError("shot", "shot.ball", shot.ball, suggest(shot.ball, layout))
    if shot.easy:
        return Clearance(shot.elevation, "")
    bars = _bars(table, layout, shot)
    elevation, over = math.radians(shot.elevation), ""
    while True:
        met = [bar for bar in bars if bar.entry < elevation < bar.exit - _SAME]
        if not met:
            return Clearance(math.degrees(elevation) if over else shot.elevation, over)
        _, elevation, over = max(met, key=lambda bar: bar.exit)
        if elevation > UPRIGHT + _SAME:
            return Clearance(None, over)


def _bars(table: Table, layout: Layout, shot: Shot) -> list[_Bar]:
    """All that is in the cue's way at some elevation."""
    struck = layout[shot.ball]
    radius = table.body_of(struck)[0]
    cue = CueBody(radius, shot.side, shot.height)
    angle = math.radians(shot.angle)
    frame = AimFrame(struck.x, struck.y, math.cos(angle), math.sin(angle))
    centre = struck.z + radius
    bars = [_Bar(-INF, cue.over_bed(centre), CLOTH), *_rail_bars(table, frame, cue, centre)]
    others = (ball for ball in layout.on_table() if ball.id != shot.ball)
    bars += [bar for ball in others if (bar := _ball_bar(table, frame, cue, centre, ball)) is not None]
    return bars


def _ball_bar(table: Table, frame: AimFrame, cue: CueBody, centre: float, ball: Ball) -> _Bar | None:
    """Where a ball is in the way. Beside its middle it leans out over the cloth: there the cue may also pass below."""
    radius = table.body_of(ball)[0]
    span = cue.span(*frame.seen(ball.x, ball.y), ball.z + radius - centre, radius)
    return None if span is None else _Bar(*span, ball.id)


def _rail_bars(table: Table, frame: AimFrame, cue: CueBody, centre: float) -> Iterator[_Bar]:
    """Where rails are in the way: they are solid down to the floor, so that nothing passes below their edges."""
    tops = table.rail_tops
    z = tops.height - centre
    highest = -INF
    for edge in tops.inner:
        for way in edge.ways(frame, cue):
            clears = cue.over(way, z)
            highest = max(highest, clears)
            yield _Bar(-INF, clears, edge.name)
    if highest >= TAPER:
        return
    # A cue so level sinks toward its butt: what is furthest back on the rails may be what it comes to first.
    for edge in tops.outer:
        for way in edge.ways(frame, cue):
            yield _Bar(-INF, cue.over(way, z), edge.name)
    far = cue.reach * cue.reach - cue.side * cue.side - z * z
    butt = math.sqrt(max(0.0, far))
    place = frame.place(butt, cue.side)
    if tops.covers(*place):
        yield _Bar(-INF, cue.clears(butt, cue.side, z), tops.beside(*place))
