"""Racking again in 14.1, and what becomes of the cue ball and the fifteenth ball (WPA 7.8, Table 1)."""

from __future__ import annotations

import math

from ....physics.standing import inside
from ....physics.values import POCKETED, Ball, Layout
from ....table.outline import Corner, Point, distance_to_edge, edges
from ....table.table import Table
from ..spotting import KITCHEN, Where, put


def rerack(table: Table, layout: Layout, name: str, seed: int) -> tuple[Layout, Where]:
    """The layout with the pocketed balls racked, and the area of the cue ball, "" where it is not in hand.

    One object ball or none is left on the table. The rack's apex stays empty where one is, unless that and the
    cue ball both lie where the rack must stand. A cue ball in hand is taken off the table.
    """
    rack, cue = table.rack(name, seed), layout[table.furniture.cue]
    left = [ball for ball in layout.on_table() if ball.id != cue.id]
    cue_in = interferes(table, name, (cue.x, cue.y))
    ball_in = bool(left) and interferes(table, name, (left[0].x, left[0].y))
    racked, line = rack.put(cue), table.furniture.head_string
    if left and not (ball_in and cue_in):
        ball = left[0]
        racked = _without_apex(table, rack, name, ball.id).put(cue, ball)
        if ball_in:
            return put(racked, ball.id, _free_spot(table, racked, cue.id)), ""
        if cue_in and (_on_head_spot(table, ball) or (line is not None and ball.x < line)):
            return put(racked, cue.id, _free_spot(table, racked, ball.id)), ""
    return (racked.put(cue.still()._replace(phase=POCKETED)), KITCHEN) if cue_in else (racked, "")


def interferes(table: Table, name: str, place: Point) -> bool:
    """Whether a ball here lies within the outline of a rack of fifteen, or over it."""
    radius, rack = table.knobs.ball.radius, table.furniture.racks[name]
    x, y = rack.spot
    # Half of what a ball takes up in the rack, its play included.
    room = radius + 0.5 * rack.gap
    back, half = x + (4.0 * math.sqrt(3.0) + 1.0) * room, (4.0 + math.sqrt(3.0)) * room
    outline = [(x - 2.0 * room, y), (back, y - half), (back, y + half)]
    sides = edges([Corner(*corner, "") for corner in outline])
    return inside(*place, outline) or any(distance_to_edge(*place, side) < radius for side in sides)


def _without_apex(table: Table, rack: Layout, name: str, kept: str) -> Layout:
    """The rack with its apex empty and without the ball that is on the table: the apex ball takes its place."""
    spot = table.furniture.racks[name].spot
    apex = min(rack.values(), key=lambda ball: math.hypot(ball.x - spot[0], ball.y - spot[1]))
    if apex.id != kept:
        rack = put(rack, apex.id, (rack[kept].x, rack[kept].y))
    return rack.without(kept)


def _free_spot(table: Table, layout: Layout, other: str) -> Point:
    """The head spot, or the centre spot where a ball blocks the head spot."""
    spots = table.furniture.spots
    if not _on_head_spot(table, layout[other]):
        return spots["head"]
    return spots.get("center", (0.5 * table.knobs.table.length, spots["head"][1]))


def _on_head_spot(table: Table, ball: Ball) -> bool:
    """Whether a ball leaves no room for another on the head spot, whichever side of it it lies on."""
    return math.dist((ball.x, ball.y), table.furniture.spots["head"]) < 2.0 * table.knobs.ball.radius
