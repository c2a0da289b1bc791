"""The time line by itself: what its keys and the wheel do, which mark is pointed at, and what its buttons look like."""

from __future__ import annotations

import pygame
import pytest

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.ui.screen import Screen
from pool2d.ui.stage.playback import Playback
from pool2d.ui.stage.timeline import COLORS, Timeline
from pool2d.ui.wording.words import Words

TABLE = load_table("pool-9ft")
ROLL = simulate(TABLE, Layout([Ball("cue", 0.635, 0.5), Ball("1", 1.5, 0.53)]), Shot(angle=1.0, speed=3.0))
SCREEN = Screen(1280, 720)
WORDS = Words()


@pytest.fixture
def line() -> Timeline:
    made = Timeline(WORDS)
    made.place(SCREEN, 0)
    made.begin(None)
    return made


@pytest.fixture
def shown() -> Playback:
    playback = Playback(ROLL, None, again=True)
    playback.pause()
    return playback


def post(line: Timeline, shown: Playback, kind: int, **fields: object) -> bool:
    return line.handle(pygame.event.Event(kind, fields), shown)


def picture(line: Timeline, shown: Playback, box: pygame.Rect) -> bytes:
    surface = pygame.Surface((SCREEN.width, SCREEN.height))
    line.draw(surface, shown, TABLE)
    return pygame.image.tobytes(surface.subsurface(box), "RGB")


@pytest.mark.parametrize(
    ("keys", "time", "rate", "paused", "over"),
    [
        ((pygame.K_SPACE, pygame.K_p), 1.0, 1.0, False, False),
        ((pygame.K_COMMA, pygame.K_LEFTBRACKET), 1.0, 0.5, True, False),
        ((pygame.K_PERIOD, pygame.K_RIGHTBRACKET), 1.0, 2.0, True, False),
        ((pygame.K_HOME,), 0.0, 1.0, True, False),
        ((pygame.K_END,), ROLL.duration, 1.0, True, False),
        ((pygame.K_ESCAPE, pygame.K_RETURN, pygame.K_KP_ENTER), ROLL.duration, 1.0, True, True),
    ],
)
def test_keys(
    line: Timeline, keys: tuple[int, ...], time: float, rate: float, paused: bool, over: bool
) -> None:  # fmt: skip
    for key in keys:
        shown = Playback(ROLL, None, again=True)
        shown.pause()
        shown.seek(1.0)
        assert post(line, shown, pygame.KEYDOWN, key=key)
        assert (shown.time, shown.rate, shown.paused, shown.over) == (time, rate, paused, over)


def test_what_is_not_meant_for_it_is_left_to_others(line: Timeline, shown: Playback) -> None:
    shown.seek(1.0)
    inside = line.button("end").center
    assert not post(line, shown, pygame.KEYDOWN, key=pygame.K_w)
    assert not post(line, shown, pygame.MOUSEBUTTONDOWN, pos=inside, button=3)
    assert not post(line, shown, pygame.MOUSEBUTTONUP, pos=inside, button=3)
    assert not post(line, shown, pygame.KEYUP, key=pygame.K_SPACE)
    assert shown.time == 1.0 and shown.paused


def test_the_wheel_goes_to_and_fro_and_holds(line: Timeline, shown: Playback) -> None:
    shown.toggle()
    shown.seek(1.0)
    assert post(line, shown, pygame.MOUSEWHEEL, y=3)
    assert shown.paused and shown.time == pytest.approx(1.06)
    post(line, shown, pygame.MOUSEWHEEL, y=-1)
    assert shown.time == pytest.approx(1.04)


def test_of_the_marks_near_the_pointer_the_nearest_contact_is_told(line: Timeline, shown: Playback) -> None:
    unit = SCREEN.unit
    at = {event: line.x_of(event.t, shown) for event in ROLL.events}
    contacts = [event for event in ROLL.events if event.kind in COLORS]
    rolling = [event for event in ROLL.events if event.kind not in COLORS]
    assert contacts and rolling
    seen = set()
    for x in range(line.track.left - 2 * unit, line.track.right + 2 * unit):
        line.hover = (x, line.track.centery)
        near = [event for event in contacts if abs(at[event] - x) <= 0.75 * unit]
        near = near or [event for event in rolling if abs(at[event] - x) <= 0.75 * unit]
        pointed = line.pointed(shown)
        assert (pointed is None) == (not near)
        if pointed is not None:
            assert pointed in near and abs(at[pointed] - x) == min(abs(at[event] - x) for event in near)
            seen.add(pointed.kind)
    assert {"ball_ball", "ball_cushion"} < seen and seen - set(COLORS)


def test_while_the_line_is_dragged_no_mark_is_told(line: Timeline, shown: Playback) -> None:
    contact = next(event for event in ROLL.events if event.kind == "ball_ball")
    pos = (round(line.x_of(contact.t, shown)), line.track.centery)
    post(line, shown, pygame.MOUSEMOTION, pos=pos)
    assert line.pointed(shown) is contact
    post(line, shown, pygame.MOUSEBUTTONDOWN, pos=pos, button=1)
    assert line.pointed(shown) is None
    post(line, shown, pygame.MOUSEBUTTONUP, pos=pos, button=1)
    assert line.pointed(shown) is contact


def test_a_button_is_lit_under_the_pointer_alone(line: Timeline, shown: Playback) -> None:
    actions = ("begin", "back", "toggle", "forth", "end", "slower", "faster", "leave")
    plain = {action: picture(line, shown, line.button(action)) for action in actions}
    assert len(set(plain.values())) == len(actions)
    for hovered in actions:
        line.hover = line.button(hovered).center
        for action in actions:
            assert (picture(line, shown, line.button(action)) != plain[action]) == (action == hovered)


def test_the_first_button_shows_whether_the_shot_runs(line: Timeline, shown: Playback) -> None:
    box = line.button("toggle")
    held = picture(line, shown, box)
    shown.toggle()
    assert picture(line, shown, box) != held
    shown.seek(shown.end)
    assert picture(line, shown, box) == held


def test_beside_a_panel_the_line_is_shorter(line: Timeline, shown: Playback) -> None:
    whole = line.track
    line.place(SCREEN, 300)
    assert line.track.left == whole.left and line.track.width == whole.width - 300
    assert line.x_of(shown.end, shown) == line.track.right
    assert line.x_of(-1.0, shown) == line.track.left


def test_the_line_is_taken_hold_of_from_a_little_beside_it(line: Timeline, shown: Playback) -> None:
    unit = SCREEN.unit
    assert unit >= 8
    for beside, taken in ((1.0, True), (2.0, False)):
        for y in (line.track.top - round(beside * unit), line.track.bottom + round(beside * unit)):
            shown.seek(0.0)
            post(line, shown, pygame.MOUSEBUTTONDOWN, pos=(line.track.centerx, y), button=1)
            post(line, shown, pygame.MOUSEBUTTONUP, pos=(line.track.centerx, y), button=1)
            assert (shown.time > 0.0) == taken
