"""Pictures: the table to scale, balls where they are, and `render`."""

from __future__ import annotations

import math
from pathlib import Path

import pygame
import pytest

from pool2d import Ball, Layout, Scenario, Shot, load_table
from pool2d.cli import main
from pool2d.draw import pen, theme
from pool2d.draw.balls import ball_art
from pool2d.draw.export.render import render
from pool2d.draw.tabletop import table_picture
from pool2d.draw.view import View, fit

TABLE = load_table("pool-9ft")
SIZE = (1280, 720)
VIEW = fit(2.54, 1.27, (0, 0, *SIZE))


def near(color: pygame.Color, expected: tuple[int, ...], tolerance: int = 40) -> bool:
    return all(abs(a - b) <= tolerance for a, b in zip(color[:3], expected[:3], strict=True))


def at(picture: pygame.Surface, x: float, y: float, view: View = VIEW) -> pygame.Color:
    px, py = view.to_screen(x, y)
    return picture.get_at((round(px), round(py)))


def of_color(color: pygame.Color, expected: str, tolerance: float = 0.16) -> bool:
    """Whether a colour is `expected` in some light: its channels are in the same proportion."""
    parts = [[channel / max(some[:3]) for channel in some[:3]] for some in (color, theme.rgb(expected))]
    return max(color[:3]) > 20 and all(abs(a - b) <= tolerance for a, b in zip(*parts, strict=True))


def test_cloth_cushion_wood_and_holes_are_where_the_geometry_says() -> None:
    picture = table_picture.draw(TABLE, SIZE, VIEW)
    finish = TABLE.furniture.finish
    assert of_color(at(picture, 1.2, 0.7), finish.cloth)
    assert of_color(at(picture, 0.9, -0.025), finish.cloth)
    assert of_color(at(picture, 0.9, -0.1), finish.wood, 0.3)
    # The nose is brighter than the shadow before it and the cushion's top behind it.
    before, nose, top = (max(at(picture, 0.9, y)[:3]) for y in (0.003, -0.006, -0.03))
    assert nose > 1.3 * before
    assert nose > 1.3 * top
    for pocket in TABLE.geometry.pockets:
        assert near(at(picture, pocket.x, pocket.y), theme.HOLE, 8)
        # The rim is where the ball falls, toward the table's middle.
        dx, dy = 1.27 - pocket.x, 0.635 - pocket.y
        outside = (pocket.radius + 0.025) / math.hypot(dx, dy)
        assert not near(at(picture, pocket.x + dx * outside, pocket.y + dy * outside), theme.HOLE, 8)


@pytest.mark.parametrize("ball", ["cue", "1", "8", "12"])
def test_a_ball_is_round_centred_and_of_its_size(ball: str) -> None:
    picture = pygame.Surface((100, 100), pygame.SRCALPHA)
    ball_art.draw(picture, ball, (50.5, 50.5), 20.0, faint=False)
    alpha = pygame.surfarray.array_alpha(picture)
    assert alpha[50, 50] == 255
    for angle in range(0, 360, 15):
        dx, dy = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        assert alpha[round(50 + 18.5 * dx), round(50 + 18.5 * dy)] == 255


def test_a_ball_moves_by_less_than_a_pixel() -> None:
    def drawn(x: float) -> bytes:
        picture = pygame.Surface((60, 60), pygame.SRCALPHA)
        ball_art.draw(picture, "1", (x, 30.0), 11.0)
        return pygame.image.tobytes(picture, "RGBA")

    assert drawn(30.0) != drawn(30.25) != drawn(30.5)
    assert drawn(30.0) == drawn(30.05)


def test_numbers_are_legible_at_720_lines() -> None:
    picture = pygame.Surface((60, 60))
    ball_art.draw(picture, "8", (30.0, 30.0), 0.028575 * VIEW.scale)
    level = [sum(picture.get_at((x, 30))[:3]) / 3 for x in range(22, 39)]
    # From the black ball over its white spot to the dark digit: strong contrast both ways.
    assert max(level) > 200
    middle = [sum(picture.get_at((x, y))[:3]) / 3 for x in range(28, 33) for y in range(26, 35)]
    assert min(middle) < 90


def test_lines_and_rings_are_smoothed() -> None:
    picture = pygame.Surface((80, 80))
    pen.line(picture, (255, 255, 255), (5, 10), (75, 30), 2.0)
    pen.ring(picture, (255, 255, 255), (40.3, 50.6), 20.0, 2.0)
    shades = {picture.get_at((x, y))[0] for x in range(80) for y in range(80)}
    assert len(shades) > 20


def test_render_shows_balls_paths_and_where_they_end(tmp_path: Path) -> None:
    layout = Layout([Ball("cue", 0.635, 0.635), Ball("1", 1.635, 0.645)])
    out = tmp_path / "picture.png"
    render(Scenario(TABLE, layout, Shot(angle=2.0, speed=1.5)), out, SIZE)
    picture = pygame.image.load(out)
    assert picture.get_size() == SIZE
    assert not near(at(picture, 0.635 + 0.012, 0.635 + 0.012), theme.CLOTH, 60)
    assert near(at(picture, 0.9, 0.635 + 0.265 * math.tan(math.radians(2.0))), theme.GUIDE_CUE, 60)


def test_render_from_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario = tmp_path / "s.toml"
    scenario.write_text('[[balls]]\nid = "cue"\nx = 1.0\ny = 0.5\nvx = 1.0\n')
    out = tmp_path / "o.png"
    assert main(["render", str(scenario), str(out), "--size", "640x360"]) == 0
    assert pygame.image.load(out).get_size() == (640, 360)
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("out", "size", "words"),
    [
        ("o.gif", "640x360", "ends in"),
        ("missing/o.png", "640x360", "cannot be written"),
        ("o.png", "640", "--size"),
        ("o.png", "1x1", "--size"),
        ("o.png", "widexhigh", "--size"),
    ],
)
def test_render_refuses_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], out: str, size: str, words: str
) -> None:
    scenario = tmp_path / "s.toml"
    scenario.write_text('[[balls]]\nid = "cue"\nx = 1.0\ny = 0.5\n')
    assert main(["render", str(scenario), str(tmp_path / out), "--size", size]) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1


@pytest.mark.parametrize("name", ["pool-9ft", "l-shape"])
def test_a_picture_is_the_same_however_it_is_cut(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    table, size = load_table(name), (320, 180)
    view = fit(table.knobs.table.length, table.knobs.table.width, (0, 0, *size))
    pictures = set()
    for rows in (23, 64, 180):
        monkeypatch.setattr(table_picture, "_ROWS", rows)
        monkeypatch.setattr(table_picture, "kept", lambda *_: None)
        pictures.add(pygame.image.tobytes(table_picture.draw(table, size, view), "RGB"))
    assert len(pictures) == 1
