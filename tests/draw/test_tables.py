"""Every preset on the screen: its table drawn where the geometry is, its balls by their looks, and a shot."""

from __future__ import annotations

from collections.abc import Iterator

import pygame
import pytest

from pool2d import Ball, load_table
from pool2d.config.catalogue import TABLES, shipped
from pool2d.draw import theme
from pool2d.draw.balls import ball_art
from pool2d.draw.tabletop import table_picture
from pool2d.draw.view import fit
from pool2d.table.furniture import Look
from pool2d.table.outline import sides
from pool2d.ui.app import App

from ..ui.conftest import Hand
from .test_pictures import of_color

NAMES = shipped(TABLES)
SIZE = (1280, 720)


def near(color: pygame.Color, expected: tuple[int, ...], tolerance: int = 60) -> bool:
    return all(abs(a - b) <= tolerance for a, b in zip(color[:3], expected[:3], strict=True))


@pytest.fixture(params=NAMES)
def any_hand(request: pytest.FixtureRequest) -> Iterator[Hand]:
    app = App(load_table(request.param), seed=3)
    pygame.event.clear()
    yield Hand(app)
    app.close()


def test_a_shot_and_a_scratch_on_every_table(any_hand: Hand) -> None:
    session, table = any_hand.play.state.session, any_hand.play.state.session.table
    any_hand.key(pygame.K_SPACE)
    any_hand.wait_for_rest()
    assert session.strokes == 1
    cue = Ball(table.furniture.cue, *table.furniture.spots["head"], phase="pocketed")
    any_hand.set_balls(cue, in_hand=True)
    size = table.knobs.table
    any_hand.point(size.length * 1.02, size.width * 1.02)
    any_hand.press()
    assert session.in_hand
    any_hand.point(cue.x, cue.y)
    any_hand.press()
    any_hand.release()
    assert not session.in_hand


@pytest.mark.parametrize("name", NAMES)
def test_frame_cushion_and_cloth_lie_along_every_side(name: str) -> None:
    table = load_table(name)
    size = table.knobs.table
    view = fit(size.length, size.width, (0, 0, *SIZE))
    picture = table_picture.draw(table, SIZE, view)
    assert table.geometry.corners
    for a, b in sides(table.geometry.corners):
        length = ((b.x - a.x) ** 2 + (b.y - a.y) ** 2) ** 0.5
        nx, ny = (b.y - a.y) / length, (a.x - b.x) / length
        # Away from side pockets and diamonds.
        x, y = a.x + 0.29 * (b.x - a.x), a.y + 0.29 * (b.y - a.y)
        finish = table.furniture.finish
        for out, color, slack in ((-0.05, finish.cloth, 0.16), (0.025, finish.cloth, 0.16), (0.1, finish.wood, 0.3)):
            px, py = view.to_screen(x + out * nx, y + out * ny)
            assert of_color(picture.get_at((round(px), round(py))), color, slack), (name, a.cushion, out)
    for pocket in table.geometry.pockets:
        px, py = view.to_screen(pocket.x, pocket.y)
        assert near(picture.get_at((round(px), round(py))), theme.HOLE, 8)


def test_only_the_floor_is_where_the_l_is_not() -> None:
    table = load_table("l-shape")
    view = fit(2.54, 1.905, (0, 0, *SIZE))
    picture = table_picture.draw(table, SIZE, view)
    for x, y in ((1.9, 1.4), (2.4, 1.8), (2.62, 1.97)):
        px, py = view.to_screen(x, y)
        assert max(picture.get_at((round(px), round(py)))[:3]) < 48


def drawn(look: Look | None, ball: str = "x") -> pygame.Surface:
    picture = pygame.Surface((80, 80))
    ball_art.draw(picture, ball, (40.0, 40.0), 30.0, look=look)
    return picture


@pytest.mark.parametrize("ball", ["yellow", "green", "brown", "blue", "pink", "black", "red7"])
def test_snooker_balls_have_their_colours(ball: str) -> None:
    look = load_table("snooker-12ft").furniture.looks[ball]
    color = tuple(bytes.fromhex(look.color[1:]))
    # Where the light falls in full but does not gleam.
    assert near(drawn(look).get_at((33, 42)), color, 60)


def test_numbers_stripes_and_dots_can_be_told() -> None:
    plain = Look("#b81c22")
    pictures = [plain, Look("#b81c22", stripe=True), Look("#b81c22", dots=True), Look("#b81c22", number="8"), None]
    assert len({pygame.image.tobytes(drawn(look), "RGB") for look in pictures}) == len(pictures)


def test_pool_balls_need_no_look() -> None:
    assert ball_art.usual("9").stripe
    assert ball_art.usual("9").color == ball_art.usual("1").color
    assert ball_art.usual("cue").number == ""
    assert ball_art.usual("red1").number == ""
