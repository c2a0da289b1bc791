"""The time line in the lower bar, by which a player goes through a shot that is shown again."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby

import pygame

from ...draw import pen, text, theme
from ...physics.event import Event
from ...physics.values import EventKind
from ...table.table import Table
from ..screen import Screen
from ..widgets.widget import plate
from ..wording import shot_text
from ..wording.words import Words
from .playback import Playback

Pos = tuple[int, int]

# The colour of an event's mark; contacts stand out, changes of phase are short and quiet.
COLORS: dict[EventKind, theme.Color] = {
    "cue_ball": (126, 190, 255),
    "ball_ball": theme.ACCENT,
    "cluster": (255, 146, 84),
    "ball_cushion": (96, 208, 170),
    "ball_slate": (178, 206, 104),
    "ball_pocket": (240, 104, 112),
    "ball_off": (236, 110, 196),
}
# What keys do while the time line is out; all others mean what they always do.
TIMELINE_KEYS = {
    pygame.K_SPACE: "toggle", pygame.K_p: "toggle",
    pygame.K_LEFT: "back", pygame.K_RIGHT: "forth",
    pygame.K_COMMA: "slower", pygame.K_LEFTBRACKET: "slower",
    pygame.K_PERIOD: "faster", pygame.K_RIGHTBRACKET: "faster",
    pygame.K_HOME: "begin", pygame.K_END: "end",
    pygame.K_ESCAPE: "leave", pygame.K_RETURN: "leave", pygame.K_KP_ENTER: "leave",
}  # fmt: skip
# How far a notch of the wheel goes, s.
_NOTCH = 0.02
# How near to a mark the pointer must be, in units.
_NEAR = 0.75


class Timeline:
    """The controls of a playback: the line with a mark for each event, and the buttons.

    `handle` takes the events that are meant for it; `hover` is where the pointer is, in pixels, None off the
    window.
    """

    def __init__(self, words: Words) -> None:
        self.words = words
        self.hover: Pos | None = None
        self._scrubbing = False
        self._screen = Screen(1280, 720)
        self._room = 1280
        self._do: dict[str, Callable[[Playback], None]] = {
            "begin": lambda shown: shown.seek(0.0),
            "back": lambda shown: shown.step(-1),
            "toggle": Playback.toggle,
            "forth": lambda shown: shown.step(1),
            "end": lambda shown: shown.seek(shown.end),
            "slower": lambda shown: shown.change_rate(-1),
            "faster": lambda shown: shown.change_rate(1),
            "leave": Playback.leave,
        }

    # Where things are.

    def place(self, screen: Screen, panel: int) -> None:
        """Lay it out for a window, less `panel` pixels on the right."""
        self._screen, self._room = screen, screen.width - panel

    @property
    def track(self) -> pygame.Rect:
        """The rectangle of the line itself, in pixels."""
        unit = self._screen.unit
        top = self._screen.bottom.top + unit * 3 // 2
        return pygame.Rect(2 * unit, top, max(1, self._room - 4 * unit), max(2, unit // 2))

    def button(self, action: str) -> pygame.Rect:
        """The rectangle of a button, by its action."""
        unit = self._screen.unit
        left = 2 * unit + list(self._do).index(action) * 7 * unit // 2
        # The rate is written between its two buttons.
        left += 6 * unit if action in ("faster", "leave") else 0
        left += unit * 3 // 2 if action in ("slower", "faster", "leave") else 0
        left += unit * 3 // 2 if action == "leave" else 0
        return pygame.Rect(left, self._screen.bottom.top + unit * 9 // 2, 3 * unit, 3 * unit)

    def x_of(self, t: float, shown: Playback) -> float:
        """The x on the line, in pixels, of the moment `t`, s."""
        return self.track.left + self.track.width * max(t, 0.0) / max(shown.end, 1e-9)

    # Hands.

    def begin(self, pointer: Pos | None) -> None:
        """Show the time line; `pointer` is where the pointer is at that time."""
        self.hover = pointer
        self.let_go()

    def let_go(self) -> None:
        """Forget a drag."""
        self._scrubbing = False

    def handle(self, event: pygame.event.Event, shown: Playback) -> bool:
        """Take an event; returns whether the time line had a use for it."""
        if event.type == pygame.KEYDOWN:
            action = TIMELINE_KEYS.get(event.key)
            if action is not None:
                self._do[action](shown)
            return action is not None
        if event.type == pygame.MOUSEMOTION:
            self.hover = event.pos
            if self._scrubbing:
                self._scrub(event.pos, shown)
        elif event.type == pygame.MOUSEWHEEL:
            shown.pause()
            shown.seek(shown.time + _NOTCH * event.y)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._press(event.pos, shown)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._scrubbing = False
        else:
            return False
        return True

    def _press(self, pos: Pos, shown: Playback) -> None:
        self.hover = pos
        pressed = self._under_pointer()
        if pressed:
            self._do[pressed](shown)
        elif self._on_track(pos):
            self._scrubbing = True
            shown.pause()
            self._scrub(pos, shown)

    def _under_pointer(self) -> str:
        """The action of the button under the pointer, if any."""
        at = self.hover
        return "" if at is None else next((action for action in self._do if self.button(action).collidepoint(at)), "")

    def _scrub(self, pos: Pos, shown: Playback) -> None:
        shown.seek((pos[0] - self.track.left) / self.track.width * shown.end)

    def _on_track(self, pos: Pos) -> bool:
        reach = self._screen.unit * 3 // 2
        return self.track.inflate(2 * reach, 2 * reach).collidepoint(pos)

    def pointed(self, shown: Playback) -> Event | None:
        """The event whose mark is under the pointer, contacts before changes of phase, the nearest of them."""
        if self.hover is None or self._scrubbing or not self._on_track(self.hover):
            return None
        x = self.hover[0]
        near = [(event.kind not in COLORS, abs(self.x_of(event.t, shown) - x), i)
                for i, event in enumerate(shown.rollout.events)
                if abs(self.x_of(event.t, shown) - x) <= _NEAR * self._screen.unit]  # fmt: skip
        return shown.rollout.events[min(near)[2]] if near else None

    # Drawing.

    def draw(self, surface: pygame.Surface, shown: Playback, table: Table) -> None:
        """Draw it over the lower bar."""
        bar = self._screen.bottom
        surface.fill(theme.PANEL[:3], pygame.Rect(bar.left, bar.top, self._room, bar.height))
        self._draw_track(surface, shown)
        self._draw_buttons(surface, shown)
        self._draw_words(surface, self.pointed(shown) or shown.event, shown, table)

    def _draw_track(self, surface: pygame.Surface, shown: Playback) -> None:
        unit, track = self._screen.unit, self.track
        pygame.draw.rect(surface, theme.EDGE, track, border_radius=track.height)
        x = self.x_of(shown.time, shown)
        done = pygame.Rect(track.left, track.top, round(x) - track.left, track.height)
        pygame.draw.rect(surface, theme.QUIET, done, border_radius=track.height)
        pointed = self.pointed(shown)
        for kind in (None, *COLORS):
            # One mark for all events of a kind that fall on the same pixel.
            places = (round(self.x_of(event.t, shown)) for event in shown.rollout.events
                      if (event.kind if event.kind in COLORS else None) == kind)  # fmt: skip
            for place, _ in groupby(places):
                color = COLORS[kind] if kind else theme.QUIET
                _mark(surface, place, track, unit * (5 if kind else 3) // 4, color)
        if pointed is not None:
            at = self.x_of(pointed.t, shown)
            pen.ring(surface, theme.TEXT, (at, track.centery), unit * 0.9, 1.4)
        pen.disc(surface, theme.TEXT, (x, track.centery), unit * 0.6)

    def _draw_buttons(self, surface: pygame.Surface, shown: Playback) -> None:
        unit = self._screen.unit
        for action in self._do:
            box = self.button(action)
            lit = action == self._under_pointer()
            plate(surface, box, theme.FACE_LIT if lit else theme.FACE, unit, theme.TEXT if lit else None)
            running = action == "toggle" and not (shown.paused or shown.ended)
            _symbol(surface, "hold" if running else action, box)
        slower, faster = self.button("slower"), self.button("faster")
        rate = f"{shown.rate:g}x" if shown.rate >= 1.0 else f"1/{1.0 / shown.rate:g}x"
        middle = ((slower.right + faster.left) / 2, slower.centery)
        text.draw(surface, rate, self._screen.small, theme.TEXT, middle, (0.5, 0.5))

    def _draw_words(self, surface: pygame.Surface, event: Event | None, shown: Playback, table: Table) -> None:
        """Draw the moment and its event in words: a title with numbers, then a line for each ball."""
        unit, size = self._screen.unit, self._screen.small
        left = self.button("leave").right + 2 * unit
        right = self.track.right
        clock = f"{self.words.number(max(shown.time, 0.0), '.3f')} / {self.words.number(shown.end, '.2f')} s"
        cue = table.furniture.cue if shown.shot is None else shown.shot.ball
        y = self._screen.bottom.top + unit * 13 // 4
        pitch = text.font(size).get_linesize()
        place = text.draw(surface, clock, size, theme.TEXT, (right, y), (1.0, 0.0))
        button = self._under_pointer()
        if button:
            hint = text.draw(surface, _hint(self.words, button), size, theme.QUIET, (right, y + pitch), (1.0, 0.0))
            right = hint.left - 2 * unit
        if event is None:
            return
        color = COLORS.get(event.kind, theme.TEXT)
        title = text.fitted(shot_text.title(self.words, event, cue), size, place.left - left - 2 * unit)
        name = text.draw(surface, title, size, color, (left, y))
        told = shot_text.measures(self.words, event, table, shown.rollout.start)
        numbers = text.fitted(told, size, place.left - name.right - 4 * unit)
        text.draw(surface, numbers, size, theme.TEXT, (name.right + 2 * unit, y))
        balls = text.fitted(self._balls(event, cue, brief=False), size, right - left)
        if balls.endswith("\N{HORIZONTAL ELLIPSIS}"):
            balls = text.fitted(self._balls(event, cue, brief=True), size, right - left)
        text.draw(surface, balls, size, theme.TEXT, (left, y + pitch))

    def _balls(self, event: Event, cue: str, brief: bool) -> str:
        return "    ".join(shot_text.change(self.words, event, ball, cue, brief) for ball in event.balls)


def _hint(words: Words, action: str) -> str:
    """What a button does, and its key."""
    first = next(key for key, other in TIMELINE_KEYS.items() if other == action)
    return words.say(f"timeline.{action}", key=words.chords(first))


def _mark(surface: pygame.Surface, x: int, track: pygame.Rect, half: int, color: theme.Color) -> None:
    pygame.draw.rect(surface, color, (x - 1, track.centery - half, 2, 2 * half))


def _symbol(surface: pygame.Surface, action: str, box: pygame.Rect) -> None:
    """Draw a button's symbol: the usual ones of media players."""
    x, y, r = box.centerx, box.centery, box.height * 0.22
    color = theme.TEXT

    def triangle(at: float, to: float) -> None:
        pen.polygon(surface, color, [(at, y - r), (at, y + r), (to, y)])

    def bar(at: float) -> None:
        pen.line(surface, color, (at, y - r), (at, y + r), r * 0.55)

    if action in ("begin", "end"):
        side = -1.0 if action == "begin" else 1.0
        triangle(x - side * r * 1.3, x - side * r * 0.2)
        triangle(x - side * r * 0.2, x + side * r * 0.9)
        bar(x + side * r * 1.2)
    elif action in ("back", "forth"):
        side = -1.0 if action == "back" else 1.0
        triangle(x - side * r * 0.8, x + side * r * 0.6)
        bar(x + side * r * 0.9)
    elif action == "toggle":
        triangle(x - r * 0.7, x + r * 1.0)
    elif action == "hold":
        bar(x - r * 0.5)
        bar(x + r * 0.5)
    elif action in ("slower", "faster"):
        pen.line(surface, color, (x - r * 0.8, y), (x + r * 0.8, y), r * 0.4)
        if action == "faster":
            pen.line(surface, color, (x, y - r * 0.8), (x, y + r * 0.8), r * 0.4)
    else:
        pen.line(surface, color, (x - r * 0.8, y - r * 0.8), (x + r * 0.8, y + r * 0.8), r * 0.4)
        pen.line(surface, color, (x - r * 0.8, y + r * 0.8), (x + r * 0.8, y - r * 0.8), r * 0.4)
