"""The options: every setting, with its effect at once, and the keys."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from ...config.knobs import Knob, walk
from ...config.settings import Store
from ...draw import text, theme
from ...draw.effects import style_of
from ..scene import Scene
from ..widgets.ball_row import BallRow
from ..widgets.inputs import Selector, Slider
from ..widgets.widget import Button, Gap, Heading, Tabs, Toggle, Widget, face, plate, tone
from ..wording.keys import DEFAULTS, FIXED, chord_of, may_be_bound
from ..wording.words import AUTO, Words, catalogue, languages
from .dialog import Dialog

KEYS_PAGE = "keys"
PAGES = ("aiming", "balls", "sound", "screen", KEYS_PAGE)
# The names that the ball art knows.
PALETTES = tuple(theme.PALETTES)
# Settings that are texts, and what is offered for them.
OFFERED: dict[str, Callable[[], Sequence[str]]] = {
    "balls.palette": lambda: PALETTES,
    "screen.language": lambda: (AUTO, *languages()),
}
# Settings that hands change elsewhere, by dragging the window's edge.
_ELSEWHERE = ("screen.width", "screen.height")
# So tall, in rows, is every page but the keys', lest the panel jump from one to the next.
_TALL = 5.4


class OptionsPage(Dialog):
    """The options over another scene; Esc or the button returns to that. Every change goes to `store` at once."""

    width = 68

    def __init__(self, below: Scene, store: Store) -> None:
        super().__init__(below, "", [])
        self.store = store
        self.page = PAGES[0]
        self._fill()

    def _fill(self) -> None:
        say = self.words.say
        page = self._page()
        self.form.set_rows(
            [
                [Heading(lambda: say("options.title"), theme.TEXT, large=True)],
                [Gap(0.15)],
                [Tabs(PAGES, lambda: self.page, self._open, lambda page: say(f"options.page.{page}"))],
                [Gap(0.4)],
                *([widget] for widget in page),
                [Gap(max(0.4, _TALL - sum(widget.rows for widget in page)))],
                [Heading(lambda: say("options.saved"))],
                [
                    Button(say("options.reset"), self._reset, say("options.reset_hint")),
                    Button(say("form.close"), self.close, strong=True),
                ],
            ]
        )

    def _page(self) -> list[Widget]:
        if self.page == KEYS_PAGE:
            rows = [KeyRow(self.words, action, self._keys_changed) for action in DEFAULTS if action not in FIXED]
            return [Heading(lambda: self.words.say("options.keys.intro"), lines=2), *rows]
        samples = [BallRow(lambda: style_of(self.store.values))] if self.page == "balls" else []
        return [*samples, *(self._widget(name, knob) for name, knob in self._settings())]

    def _settings(self) -> list[tuple[str, Knob]]:
        """The settings on the open page."""
        found = [(name, knob) for name, knob, _ in walk(self.store.values) if name.startswith(self.page + ".")]
        return [(name, knob) for name, knob in found if name not in _ELSEWHERE]

    def _widget(self, name: str, knob: Knob) -> Widget:
        say = self.words.say
        label, hint = say(f"setting.{name}"), say(f"setting.{name}_hint")

        def get() -> float | str:
            return next(value for other, _, value in walk(self.store.values) if other == name)

        def put(value: object) -> None:
            self.store.turn(name, value)
            if name == "screen.language":
                self._fill()

        if isinstance(knob.default, bool):
            return Toggle(label, lambda: bool(get()), put, hint)
        if isinstance(knob.default, str):
            options = OFFERED.get(name, lambda: knob.choices)
            return Selector(label, options, lambda: str(get()), put, hint, _told(self.words, name))
        return Slider(
            label, knob, lambda: float(get()), put, lambda: put(knob.default), hint,
            lambda value: self.words.quantity(value, ".4g", knob.unit),
        )  # fmt: skip

    def _open(self, page: str) -> None:
        self.page = page
        self.form.scroll = 0
        self._fill()

    def _keys_changed(self) -> None:
        self.store.bind(self.words.keys.names())

    def _reset(self) -> None:
        if self.page == KEYS_PAGE:
            self.words.keys.reset()
            self._keys_changed()
        for name, knob in self._settings():
            self.store.turn(name, knob.default)
        self._fill()


class KeyRow(Widget):
    """A row that shows an action and the keys bound to it, and binds others.

    A press or Enter makes it wait for a key, Delete restores the default keys. A key that is bound to another
    action is reported first, and taken from that action when it is pressed a second time. While it waits it takes
    every key, Tab and Esc too.
    """

    rows = 1.1

    def __init__(self, words: Words, action: str, changed: Callable[[], None]) -> None:
        super().__init__()
        self.words = words
        self.action = action
        self.changed = changed
        self.hint = words.say("options.keys.hint", keys=words.chords(*words.keys.defaults[action]))
        self.message = ""
        self._wanted = 0

    def release(self, pos: tuple[int, int]) -> None:
        if self.rect.collidepoint(pos):
            self._listen(not self.greedy)

    def leave(self) -> None:
        self._listen(False)

    def key(self, key: int, mod: int) -> bool:
        if self.greedy:
            self._take(key, mod)
            return True
        if key in (pygame.K_DELETE, pygame.K_BACKSPACE):
            self.words.keys.reset(self.action)
            self.changed()
        elif key in (pygame.K_RETURN, pygame.K_SPACE):
            self._listen(True)
        else:
            return False
        return True

    def _listen(self, on: bool) -> None:
        self.greedy, self._wanted = on, 0
        self.message = self.words.say("options.keys.press") if on else ""

    def _take(self, key: int, mod: int) -> None:
        say = self.words.say
        chord = chord_of(key, mod)
        owner = self.words.keys.owner(chord)
        if key == pygame.K_ESCAPE:
            self._listen(False)
        elif not may_be_bound(chord):
            if key not in _MODIFIERS:
                self.message = say("options.keys.fixed", key=self.words.chords(chord))
        elif owner not in (None, self.action) and chord != self._wanted:
            self._wanted = chord
            self.message = say("options.keys.taken", key=self.words.chords(chord), action=say(f"action.{owner}"))
        else:
            self.words.keys.bind(self.action, chord)
            self._listen(False)
            self.changed()

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        size = unit * 7 // 4
        color = theme.ACCENT if focused or self.greedy else theme.TEXT
        name = self.words.say(f"action.{self.action}")
        box = self.rect.inflate(0, -unit // 2)
        if not self.message:
            label = text.fitted(name, size, self.rect.width * 2 // 5 - unit)
            text.draw(surface, label, size, color, (self.rect.left, self.rect.centery), (0.0, 0.5))
            box.width = self.rect.width * 3 // 5
        box.right = self.rect.right
        edge = theme.ACCENT if self.greedy else tone(hovered)
        plate(surface, box, face(self.pressed or self.greedy, hovered), unit, edge)
        # What is told while the row waits for a key takes all of it.
        said = f"{name}: {self.message}" if self.message else self.words.key(self.action)
        tint = theme.ACCENT if self.message else theme.TEXT
        text.draw(surface, text.fitted(said, size, box.width - 2 * unit), size, tint, box.center, (0.5, 0.5))


_MODIFIERS = (
    pygame.K_LSHIFT, pygame.K_RSHIFT, pygame.K_LCTRL, pygame.K_RCTRL, pygame.K_LALT, pygame.K_RALT, pygame.K_LGUI,
    pygame.K_RGUI,
)  # fmt: skip


def _told(words: Words, name: str) -> Callable[[str], str]:
    """The text for each value of a setting, by the setting's name."""
    if name == "screen.language":
        return lambda code: _language(words, code)
    return lambda value: words.say_or(f"choice.{value}", value)


def _language(words: Words, code: str) -> str:
    """A language's own name for itself, by its code, as "Deutsch" for "de"."""
    return words.say("language.auto") if code == AUTO else catalogue(code).texts.get("language.name", code)
