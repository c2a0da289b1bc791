"""A cue as a cloud of points, to see whether it goes through something: slow, plain, and nothing of the exact way."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pool2d import Layout, Shot, Table
from pool2d.physics.detect import Jaw, Pocket

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# Tip and butt, half as wide as they are, and the length, m.
TIP, BUTT, LENGTH = 0.0128 / 2, 0.03 / 2, 58 * 0.0254
RAIL = 0.14


def goes_through(table: Table, layout: Layout, shot: Shot, elevation: float, slack: float = 0.0) -> bool:
    """Whether any point of the cue, from the middle of the ball on, is deeper than `slack`, m, in something."""
    x, y, z = _points(table, layout, shot, elevation)
    top = table.knobs.cushion.nose_height
    low = z < top - slack
    found = bool(_on_rails(table, x[low], y[low], slack).any()) or bool((z[x.size // 2 :] < -slack).any())
    for ball in layout.on_table():
        if ball.id != shot.ball:
            radius = table.body_of(ball)[0]
            far = np.hypot(np.hypot(x - ball.x, y - ball.y), z - radius)
            found = found or bool((far < radius - slack).any())
    return found


def _points(table: Table, layout: Layout, shot: Shot, elevation: float) -> tuple[Array, Array, Array]:
    """Points of the cue's side, from the front to the butt."""
    ball = layout[shot.ball]
    radius = table.body_of(ball)[0]
    aim, tilt = math.radians(shot.angle), math.radians(elevation)
    back = np.array([-math.cos(aim) * math.cos(tilt), -math.sin(aim) * math.cos(tilt), math.sin(tilt)])
    right = np.array([math.sin(aim), -math.cos(aim), 0.0])
    up = np.cross(back, right)
    up *= np.sign(up[2]) if up[2] else 1.0
    if tilt == math.pi / 2:
        up = np.array([math.cos(aim), math.sin(aim), 0.0])
    depth = radius * math.sqrt(1.0 - shot.side**2 - shot.height**2)
    # Closer together near the ball, where half a millimetre is a degree.
    along = ((depth + LENGTH) * np.linspace(0.0, 1.0, 700) ** 2)[:, None]
    wide = TIP + (BUTT - TIP) * (along - depth) / LENGTH
    turn = np.linspace(0.0, 2.0 * math.pi, 64, endpoint=False)[None, :]
    centre = np.array([ball.x, ball.y, radius])
    cloud = (
        centre
        + along[..., None] * back
        + (shot.side * radius + wide * np.cos(turn))[..., None] * right
        + (shot.height * radius + wide * np.sin(turn))[..., None] * up
    ).reshape(-1, 3)
    return cloud[:, 0], cloud[:, 1], cloud[:, 2]


def _on_rails(table: Table, x: Array, y: Array, slack: float) -> Mask:
    """Which places are over a rail, and further from its edges toward the table than `slack`."""
    cloth = _inside(x, y, table.geometry.outline)
    jaws = np.zeros_like(cloth)
    holes = np.zeros_like(cloth)
    for element in table.elements:
        if isinstance(element, Jaw):
            # The outline goes round jaws by chords, which leave a little of them outside.
            jaws |= np.hypot(x - element.x, y - element.y) < element.radius - slack
        elif isinstance(element, Pocket):
            # Open behind its middle; nearer to the table it is as wide as its facings leave it.
            tips = [jaw for jaw in table.elements if isinstance(jaw, Jaw) and jaw.name == f"{element.name} jaw"]
            ux = sum(jaw.x for jaw in tips) / len(tips) - element.x
            uy = sum(jaw.y for jaw in tips) / len(tips) - element.y
            behind = (x - element.x) * ux + (y - element.y) * uy < slack * math.hypot(ux, uy)
            holes |= behind & (np.hypot(x - element.x, y - element.y) < element.radius + slack)
    near = np.full(x.shape, np.inf)
    for (ax, ay), (bx, by) in _sides(table.geometry.outline):
        near = np.minimum(near, _distance(x, y, ax, ay, bx, by))
    beyond = np.full(x.shape, np.inf)
    for (ax, ay), (bx, by) in _sides(table.surface):
        beyond = np.minimum(beyond, _distance(x, y, ax, ay, bx, by))
    return jaws | (~cloth & ~holes & (near > slack + 1e-4) & (beyond < RAIL - slack))


def _sides(polygon: Sequence[tuple[float, float]]) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    return list(zip(polygon, (*polygon[1:], polygon[0]), strict=True))


def _distance(x: Array, y: Array, ax: float, ay: float, bx: float, by: float) -> Array:
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    along = np.clip(((x - ax) * dx + (y - ay) * dy) / square, 0.0, 1.0) if square > 0.0 else np.zeros_like(x)
    return np.asarray(np.hypot(x - ax - along * dx, y - ay - along * dy))


def _inside(x: Array, y: Array, polygon: Sequence[tuple[float, float]]) -> Mask:
    found = np.zeros(x.shape, bool)
    for (ax, ay), (bx, by) in _sides(polygon):
        if ay != by:
            found ^= ((ay > y) != (by > y)) & (x < ax + (y - ay) * (bx - ax) / (by - ay))
    return found
