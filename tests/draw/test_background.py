"""The table's picture behind everything: sharp at rest, and true while the window or the table changes."""

from __future__ import annotations

import threading
import time
import weakref
from collections.abc import Callable

import pygame
import pytest

from pool2d import Table, load_table
from pool2d.draw.tabletop import table_picture
from pool2d.draw.tabletop.background import Background
from pool2d.draw.view import View, fit

TABLE = load_table("english-7ft")


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[tuple[int, int]]:
    """The sizes of the pictures drawn in full; none is kept from before."""
    sizes: list[tuple[int, int]] = []
    full = table_picture.draw

    def draw(table: Table, size: tuple[int, int], view: View, workers: int = 2) -> pygame.Surface:
        sizes.append(size)
        return full(table, size, view, workers)

    monkeypatch.setattr(table_picture, "draw", draw)
    monkeypatch.setattr(table_picture, "kept", lambda *_: None)
    return sizes


def shown(background: Background, width: int, table: Table = TABLE) -> tuple[pygame.Surface, View]:
    """A frame of a window of that width, and its view."""
    surface = pygame.Surface((width, width * 9 // 16))
    view = fit(1.83, 0.915, (0, 0, *surface.get_size()))
    background.show(surface, table, view, view)
    return surface, view


def wait_for(done: Callable[[], bool]) -> None:
    """Until something is so, at most half a minute."""
    for _ in range(6000):
        if done():
            return
        time.sleep(0.005)
    raise AssertionError("it does not come")


def test_a_window_being_dragged_waits_for_no_picture_and_gets_one_at_rest(drawn: list[tuple[int, int]]) -> None:
    background = Background()
    for width in (320, 352, 384, 416):
        picture, view = shown(background, width)
        # Quick or not, pockets and cloth are where they belong.
        for pocket in TABLE.geometry.pockets:
            x, y = view.to_screen(pocket.x, pocket.y)
            assert max(picture.get_at((round(x), round(y)))[:3]) < 40
        x, y = view.to_screen(0.9, 0.45)
        assert picture.get_at((round(x), round(y)))[2] > 100
    assert drawn == [(320, 180)]

    def settled() -> bool:
        shown(background, 416)
        return background.settled

    wait_for(settled)
    picture, view = shown(background, 416)
    assert drawn == [(320, 180), (416, 234)]
    full = table_picture.draw(TABLE, (416, 234), view)
    assert pygame.image.tobytes(picture, "RGB") == pygame.image.tobytes(full, "RGB")


def test_a_table_being_changed_is_shown_as_it_is_at_once(drawn: list[tuple[int, int]]) -> None:
    background = Background()
    shown(background, 480)
    wide = TABLE.with_knobs({"corner.mouth": 0.12, "corner.drop_radius": 0.075})
    picture, view = shown(background, 480, wide)
    assert drawn == [(480, 270)]
    pocket = wide.geometry.pockets[0]
    old = TABLE.geometry.pockets[0]
    x, y = view.to_screen(pocket.x, pocket.y - pocket.radius + 0.008)
    assert old.y - old.radius > pocket.y - pocket.radius + 0.02
    assert max(picture.get_at((round(x), round(y)))[:3]) < 60


def test_what_does_not_show_changes_no_picture(drawn: list[tuple[int, int]]) -> None:
    background = Background()
    first, _ = shown(background, 320)
    second, _ = shown(background, 320, TABLE.with_knobs({"cloth.mu_roll": 0.02}))
    assert drawn == [(320, 180)]
    assert pygame.image.tobytes(first, "RGB") == pygame.image.tobytes(second, "RGB")


def near_to(home: View, scale: float) -> View:
    """The middle of a window of 480 pixels, so many times as large."""
    return View(home.scale * scale, 240.0 - 0.9 * home.scale * scale, 135.0 + 0.45 * home.scale * scale)


def test_from_nearer_it_is_cut_out_of_a_larger_picture(drawn: list[tuple[int, int]]) -> None:
    background = Background()
    _, home = shown(background, 480)
    surface = pygame.Surface((480, 270))
    for scale in (1.5, 2.0, 3.0):
        near = near_to(home, scale)

        # True from the first frame on, until it is sharp.
        def settled(near: View = near) -> bool:
            background.show(surface, TABLE, home, near)
            pocket = max(TABLE.geometry.pockets, key=lambda hole: -abs(hole.x - 0.9))
            x, y = near.to_screen(pocket.x, pocket.y)
            if surface.get_rect().collidepoint(x, y):
                assert max(surface.get_at((round(x), round(y)))[:3]) < 40
            assert surface.get_at((240, 135))[2] > 100
            return background.settled

        wait_for(settled)
    assert drawn == [(480, 270), (960, 540)]


def test_no_frame_waits_for_the_larger_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    background = Background()
    surface, home = shown(background, 480)
    full, go_on = table_picture.draw, threading.Event()

    def slow(table: Table, size: tuple[int, int], view: View, workers: int) -> pygame.Surface:
        assert go_on.wait(30.0)
        return full(table, size, view, workers)

    monkeypatch.setattr(table_picture, "draw", slow)
    near = near_to(home, 2.0)
    for _ in range(20):
        background.show(surface, TABLE, home, near)
        assert not background.settled
    soft = pygame.image.tobytes(surface, "RGB")
    go_on.set()

    def settled() -> bool:
        background.show(surface, TABLE, home, near)
        return background.settled

    wait_for(settled)
    assert pygame.image.tobytes(surface, "RGB") != soft


def test_what_goes_wrong_on_the_way_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    background = Background()
    surface, home = shown(background, 480)

    def fail(*_: object, **__: object) -> pygame.Surface:
        raise MemoryError

    monkeypatch.setattr(table_picture, "draw", fail)

    def failed() -> bool:
        try:
            background.show(surface, TABLE, home, near_to(home, 2.0))
        except MemoryError:
            return True
        return False

    wait_for(failed)


def test_only_boxes_are_filled_until_the_picture_or_the_surface_is_another(drawn: list[tuple[int, int]]) -> None:
    background = Background()
    shown(background, 320)
    surface, view = shown(background, 352)
    box = pygame.Rect(40, 40, 8, 8)

    def show(onto: pygame.Surface) -> bool:
        """Whether only the box was filled, and if so, that it was and nothing else."""
        onto.fill("red")
        filled = background.show(onto, TABLE, view, view, [box])
        assert onto.get_at(box.center)[:3] != (255, 0, 0)
        assert (onto.get_at((100, 100))[:3] == (255, 0, 0)) is filled
        return filled

    assert show(surface)
    # The full picture takes the place of the quick one.
    wait_for(lambda: not show(surface))
    assert background.settled and show(surface)
    other = surface.copy()
    assert not show(other) and show(other)
    assert not show(surface)


def test_no_second_picture_is_held_once_the_full_one_is_shown(
    drawn: list[tuple[int, int]], monkeypatch: pytest.MonkeyPatch
) -> None:
    lean: list[weakref.ref[pygame.Surface]] = []
    real = table_picture.window_copy

    def window_copy(picture: pygame.Surface) -> pygame.Surface:
        lean.append(weakref.ref(picture))
        return real(picture)

    monkeypatch.setattr(table_picture, "window_copy", window_copy)
    background = Background()
    for width in (320, 352):
        wait_for(lambda width=width: bool(shown(background, width)) and background.settled)  # type: ignore[misc]
    assert len(lean) >= 2
    wait_for(lambda: not any(ref() for ref in lean))
