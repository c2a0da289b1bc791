"""Balls on the screen: they turn, they can be told apart, they fall into the tray."""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import pygame
import pytest

from pool2d import Ball, Layout, load_table, simulate
from pool2d.draw import theme
from pool2d.draw.balls import ball_art, ball_marks, tray
from pool2d.draw.theme import PALETTES, Palette, Style
from pool2d.game.falling import DROP
from pool2d.physics.orientation import FACING, Quaternion, turn
from pool2d.table.furniture import Look
from pool2d.ui.stage.playback import Playback

from ..ui.conftest import FRAME, Hand

TABLE = load_table("pool-9ft")
POOL = ("yellow", "blue", "red", "purple", "orange", "green", "maroon", "black", "white")
SNOOKER = ("red", "yellow", "green", "brown", "blue", "pink", "black", "white")


def drawn(
    look: Look, orientation: Quaternion = FACING, radius: float = 30.0, style: Style = theme.PLAIN, alpha: int = 255
) -> pygame.Surface:
    side = round(2.0 * radius) + 20
    picture = pygame.Surface((side, side))
    placed = ball_art.Placed(look, (side // 2, side // 2), radius, orientation, alpha, shadow=False)
    ball_art.draw_all(picture, [placed], style)
    return picture


def pixels(picture: pygame.Surface) -> bytes:
    return pygame.image.tobytes(picture, "RGB")


def brightest(picture: pygame.Surface, x: int, y: int) -> float:
    return sum(picture.get_at((x, y))[:3]) / 3.0


def test_a_spot_goes_where_the_ball_turns_it() -> None:
    look = Look("#101010", number="8")
    middle = 40

    def white(orientation: Quaternion, x: int, y: int) -> bool:
        return brightest(drawn(look, orientation), middle + x, middle + y) > 100.0

    # Beside the digit on the spot, which is 15 pixels wide to each side.
    assert white(FACING, 13, 0)
    # Rolled to the right, the top goes to the right; rolled up the table, up the screen.
    assert not white(turn(0.0, 0.9, 0.0), -6, 0)
    assert white(turn(0.0, 0.9, 0.0), 20, 11)
    assert white(turn(-0.9, 0.0, 0.0), 11, -20)
    # A quarter turn hides both spots behind the rim, half a turn shows the other.
    assert not white(turn(0.0, math.pi / 2.0, 0.0), 13, 0)
    assert white(turn(0.0, math.pi, 0.0), 13, 0)


def test_both_spots_read_the_same_way() -> None:
    look = Look("#1846b2", number="14")
    assert pixels(drawn(look)) == pixels(drawn(look, turn(0.0, math.pi, 0.0)))
    assert pixels(drawn(look)) != pixels(drawn(look, turn(0.0, 0.0, math.pi)))


@pytest.mark.parametrize("radius", [1.0, 3.0, 11.4, 40.0, 75.0])
@pytest.mark.parametrize("ball", ["cue", "3", "12"])
def test_turning_shows_at_every_size_but_not_less_than_can_be_seen(ball: str, radius: float) -> None:
    look = ball_art.usual(ball)
    assert pixels(drawn(look, FACING, radius)) == pixels(drawn(look, turn(0.05 / radius, 0.0, 0.0), radius))
    if radius > 2.0:
        assert pixels(drawn(look, FACING, radius)) != pixels(drawn(look, turn(2.0 / radius, 0.0, 0.0), radius))


def test_many_balls_drawn_together_look_as_each_alone() -> None:
    ids = ["cue", "1", "2", "9", "15", "8"]
    balls = [
        ball_art.Placed(ball_art.usual(ball), (30.25 + 50.0 * i, 40.5), 11.0 + i % 2, turn(0.3 * i, 0.2, i))
        for i, ball in enumerate(ids)
    ]
    together, apart = pygame.Surface((330, 80)), pygame.Surface((330, 80))
    ball_art.draw_all(together, balls)
    ball_art._drawn.clear()
    for ball in balls:
        ball_art.draw_all(apart, [ball])
    assert pixels(together) == pixels(apart)


@pytest.mark.parametrize("radius", [3.0, 10.75, 33.0, 60.0])
@pytest.mark.parametrize("ball", ["cue", "6", "8", "12"])
def test_a_ball_looked_up_looks_nearly_as_one_painted(ball: str, radius: float) -> None:
    def picture(orientation: Quaternion, fine: bool) -> np.ndarray:
        side = round(2.0 * radius) + 4
        surface = pygame.Surface((side, side))
        place = (side / 2.0 + 0.25, side / 2.0 - 0.5)
        ball_art.draw_all(surface, [ball_art.Placed(ball_art.usual(ball), place, radius, orientation, fine=fine)])
        return pygame.surfarray.array3d(surface).astype(float)

    lies = [FACING, turn(0.5, 0.3, 0.0), turn(1.4, -0.4, 2.0), turn(0.0, 2.5, 0.7)]
    for orientation in lies:
        painted, looked_up = picture(orientation, True), picture(orientation, False)
        assert 0.0 < np.abs(painted - looked_up).mean() < 5.0
        # No other way of lying comes as near.
        nearest = min(lies, key=lambda other: float(np.abs(picture(other, True) - looked_up).mean()))
        assert nearest == orientation or ball == "cue"


def test_only_what_moves_while_a_shot_runs_is_drawn_roughly(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: dict[bool, int] = {}
    real = ball_art.draw_all

    def record(surface: pygame.Surface, balls: list[ball_art.Placed], style: Style = theme.PLAIN) -> list[pygame.Rect]:
        seen.clear()
        seen.update({fine: sum(ball.fine == fine for ball in balls) for fine in (True, False)})
        return real(surface, balls, style)

    monkeypatch.setattr(ball_art, "draw_all", record)
    hand.point(0.5, 0.5)
    assert seen == {True: 16, False: 0}
    hand.key(pygame.K_RETURN)
    while hand.time <= 0.02:
        hand.app.step(FRAME)
    assert seen == {True: 15, False: 1}
    hand.key(pygame.K_p)
    assert seen == {True: 16, False: 0}


def seen_as(color: theme.Color, kind: str) -> np.ndarray:
    """A colour as one without red or green cones sees it (Viénot, Brettel, Mollon 1999), in CIE Lab."""
    linear = (np.array(color[:3]) / 255.0) ** 2.2
    if kind == "deuteranopia":
        mixed = np.array([[0.29275, 0.70725, 0.0], [0.29275, 0.70725, 0.0], [-0.02234, 0.02234, 1.0]])
    else:
        mixed = np.array([[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1.0]])
    linear = np.clip(mixed @ linear, 0.0, 1.0)
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    x, y, z = np.cbrt(to_xyz @ linear / np.array([0.9505, 1.0, 1.089]))
    return np.array([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])


def closest(palette: Palette, names: tuple[str, ...], kind: str) -> tuple[float, str]:
    """How far apart the two colours are that are hardest to tell."""
    seen = {name: seen_as(getattr(palette, name), kind) for name in names}
    return min((float(np.linalg.norm(seen[a] - seen[b])), f"{a} {b}") for a, b in combinations(names, 2))


@pytest.mark.parametrize("kind", ["deuteranopia", "protanopia"])
@pytest.mark.parametrize("names", [POOL, SNOOKER])
def test_who_confuses_red_and_green_can_tell_the_colours_of_their_palette(names: tuple[str, ...], kind: str) -> None:
    least, pair = closest(theme.COLOR_BLIND, names, kind)
    assert least > 30.0, pair
    assert least > 1.7 * closest(theme.STANDARD, names, kind)[0]


@pytest.mark.parametrize("kind", ["deuteranopia", "protanopia"])
def test_no_ball_is_lost_on_the_cloth(kind: str) -> None:
    cloth = seen_as(theme.CLOTH, kind)
    names = {*POOL, *SNOOKER}
    assert min(np.linalg.norm(seen_as(getattr(theme.COLOR_BLIND, name), kind) - cloth) for name in names) > 25.0


@pytest.mark.parametrize("name", PALETTES)
def test_a_palette_colours_every_set_by_the_nearest_hue(name: str) -> None:
    palette = PALETTES[name]
    for preset, ball, hue in (
        ("snooker-12ft", "red7", "red"), ("snooker-12ft", "pink", "pink"), ("snooker-12ft", "brown", "brown"),
        ("english-7ft", "yellow2", "yellow"), ("pyramid-12ft", "5", "white"), ("carom-10ft", "red", "red"),
    ):  # fmt: skip
        look = load_table(preset).furniture.looks[ball]
        assert theme.hue(look.color) == hue
        if palette is not theme.STANDARD:
            assert palette.color(look.color) == getattr(palette, hue)
    assert {theme.hue(ball_art.usual(str(n)).color) for n in range(1, 9)} == set(POOL) - {"white"}


def test_shapes_tell_colours_apart_without_colour() -> None:
    orientation = turn(0.5, 0.4, 0.3)
    table = load_table("snooker-12ft")
    grey = Palette(**dict.fromkeys((*POOL, "brown", "pink"), (120, 120, 120)))
    looks = [table.furniture.looks[name] for name in ("red1", "yellow", "green", "brown", "blue", "pink", "black")]
    plain = {pixels(drawn(look, orientation, style=Style(grey))) for look in looks}
    marked = {pixels(drawn(look, orientation, style=Style(grey, patterned=True))) for look in looks}
    assert (len(plain), len(marked)) == (1, len(looks))
    assert set(ball_marks.SHAPES) <= set(POOL) | {"brown", "pink"}


def test_the_style_of_a_stage_is_the_style_of_its_balls(hand: Hand) -> None:
    def shot() -> bytes:
        hand.app.redraw()
        hand.app.step(0.0)
        return pixels(hand.app.window.surface)

    plain = shot()
    hand.play.state.show.style = Style(theme.COLOR_BLIND, patterned=True)
    other = shot()
    hand.play.state.show.style = Style()
    assert other != plain == shot()


def test_a_ball_falls_in_sight_and_lies_in_the_tray(hand: Hand) -> None:
    table = hand.play.state.session.table
    hole = next(pocket for pocket in table.geometry.pockets if pocket.name == "bottom-left")
    hand.set_balls(Ball("cue", 0.5, 0.5), Ball("1", 0.25, 0.25), Ball("2", 1.2, 0.3))
    play = hand.play
    play.state.hands.aim = play.state.hands.aim.with_speed(2.0).toward(-1.0, -1.0)
    tray = play.stage.screen.tray

    def in_tray() -> bool:
        return bool((pygame.surfarray.array3d(hand.app.window.surface.subsurface(tray)).max(axis=2) > 120).any())

    def near_hole() -> float:
        x, y = play.stage.view.to_screen(hole.x, hole.y)
        return float(
            pygame.surfarray.array3d(hand.app.window.surface)[
                round(x) - 9 : round(x) + 9, round(y) - 9 : round(y) + 9
            ].max()
        )

    hand.app.step(0.0)
    dark = near_hole()
    hand.key(pygame.K_SPACE)
    assert play.state.playback is not None
    drop = next(event.t for event in play.state.playback.rollout.events if event.kind == "ball_pocket")
    play.state.playback.time = drop + 0.4 * DROP
    hand.app.step(0.0)
    assert near_hole() > dark + 60.0
    assert not in_tray()
    play.state.playback.time = drop + DROP
    hand.app.step(0.0)
    assert near_hole() < dark + 20.0
    assert in_tray()
    hand.wait_for_rest()
    hand.app.step(0.0)
    assert in_tray()
    hand.key(pygame.K_u)
    assert not in_tray()


def test_the_trough_of_the_tray_has_ends_of_half_a_circle_and_none_without_balls() -> None:
    ground = (255, 0, 255)
    picture = pygame.Surface((400, 200))
    picture.fill(ground)
    room = pygame.Rect(50, 60, 300, 80)
    tray.draw(picture, room, [], theme.PLAIN)
    assert pygame.mask.from_threshold(picture, ground, (1, 1, 1)).count() == 400 * 200
    tray.draw(picture, room, [Look("#ffd000")] * 3, theme.PLAIN)
    free = pygame.mask.from_threshold(picture, ground, (1, 1, 1))
    free.invert()
    (trough,) = free.get_bounding_rects()
    assert trough.center == pytest.approx(room.center, abs=1)
    half = trough.height / 2.0
    for x in range(trough.left, trough.left + round(half)):
        for y in range(trough.top, trough.bottom):
            off = math.hypot(x + 0.5 - trough.left - half, y + 0.5 - trough.centery) - half
            if abs(off) > 1.5:
                assert free.get_at((x, y)) == (off < 0.0)


def test_the_last_ball_is_seen_to_its_end(hand: Hand) -> None:
    play = hand.play
    last = Layout([Ball("cue", 0.5, 0.5), Ball("1", 0.1, 0.1, vx=-0.5, vy=-0.5)])
    rollout = simulate(play.state.session.table, last)
    assert rollout.events[-1].kind == "ball_pocket"
    play.state.playback = Playback(rollout, None)
    play.state.playback.time = rollout.duration
    hand.app.step(0.5 * DROP)
    assert play.state.playback is not None
    hand.app.step(0.6 * DROP)
    assert play.state.playback is None
    play.state.playback = Playback(rollout, None)
    hand.key(pygame.K_SPACE)
    assert play.state.playback is None


def test_a_resting_table_looks_the_same_frame_after_frame(hand: Hand) -> None:
    hand.key(pygame.K_SPACE)
    hand.wait_for_rest()
    hand.app.step(0.0)
    before = pixels(hand.app.window.surface)
    for _ in range(3):
        hand.app.step(0.0)
    assert pixels(hand.app.window.surface) == before
