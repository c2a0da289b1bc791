"""A column of widgets with a focus, that scrolls where it has to, and tells hints."""

from __future__ import annotations

import pygame

from . import text, theme
from .widgets import Widget

# How long the pointer rests on a widget until its hint is shown, s.
_HINT = 0.5


class Form:
    """Widgets in rows, on a panel.

    Tab and Shift+Tab (Up and Down too, where the widget has no use for them) move the focus, the wheel
    scrolls. A row may hold several widgets side by side.
    """

    def __init__(self, rows: list[list[Widget]]) -> None:
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.unit = 8
        self.rows: list[list[Widget]] = []
        self.focus: Widget | None = None
        self.scroll = 0
        self._held: Widget | None = None
        self._pressed = False
        self._hovered: Widget | None = None
        self._rest = 0.0
        self.set_rows(rows)

    @property
    def widgets(self) -> list[Widget]:
        return [widget for row in self.rows for widget in row]

    def set_rows(self, rows: list[list[Widget]]) -> None:
        """Show these; the focus stays with its widget if that is still there."""
        self.rows = rows
        if self.focus not in self.widgets:
            self.focus = next((widget for widget in self.widgets if widget.focusable), None)
        self._held = self._held if self._held in self.widgets else None
        self._hovered = None

    def height(self, unit: int) -> int:
        """How tall the rows are, in pixels."""
        return sum(_row_height(row, unit) for row in self.rows)

    def place(self, rect: pygame.Rect, unit: int) -> None:
        """Lay the widgets out in `rect`."""
        self.rect, self.unit = rect, unit
        self.scroll = max(0, min(self.scroll, self.height(unit) - rect.height + 4 * unit))
        y = rect.top + 2 * unit - self.scroll
        for row in self.rows:
            height = _row_height(row, unit)
            width = (rect.width - 4 * unit - (len(row) - 1) * unit) // len(row)
            for i, widget in enumerate(row):
                widget.rect = pygame.Rect(rect.left + 2 * unit + i * (width + unit), y, width, height)
            y += height

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it was meant for the form."""
        if event.type == pygame.MOUSEMOTION:
            return self._move(event.pos)
        if event.type == pygame.MOUSEBUTTONDOWN and self.rect.collidepoint(event.pos):
            widget = self._under(event.pos)
            self._pressed = event.button == 1
            if event.button == 1 and widget is not None and widget.focusable:
                self.focus = self._held = widget
                widget.press(event.pos)
            return True
        if event.type == pygame.MOUSEBUTTONUP and event.button == 1 and self._pressed:
            # The release belongs to the form that took the press, also where its widget has gone since.
            held, self._held, self._pressed = self._held, None, False
            if held is not None:
                held.release(event.pos)
            return True
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, getattr(event, "mod", 0))
        if event.type == pygame.TEXTINPUT and self.focus is not None:
            self.focus.type(event.text)
            return True
        if event.type == pygame.MOUSEWHEEL and self._hovered is not None:
            self.scroll -= event.y * 4 * self.unit
            return True
        return False

    def update(self, dt: float) -> None:
        self._rest += dt

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the panel, the widgets on it and perhaps a hint."""
        panel = pygame.Surface(self.rect.size, pygame.SRCALPHA)
        pygame.draw.rect(panel, theme.PANEL, panel.get_rect(), border_radius=self.unit)
        surface.blit(panel, self.rect)
        clip = surface.get_clip()
        surface.set_clip(self.rect)
        for widget in self.widgets:
            if widget.rect.colliderect(self.rect):
                widget.draw(surface, self.unit, widget is self.focus, widget is self._hovered)
        surface.set_clip(clip)
        if self._hovered is not None and self._hovered.hint and self._rest > _HINT and self._held is None:
            self._draw_hint(surface, self._hovered)

    def _draw_hint(self, surface: pygame.Surface, widget: Widget) -> None:
        unit, size = self.unit, self.unit * 3 // 2
        lines = text.wrap(widget.hint, size, 32 * unit)
        pitch = text.font(size).get_linesize()
        width = max(text.font(size).size(line)[0] for line in lines) + 2 * unit
        box = pygame.Rect(0, 0, width, pitch * len(lines) + unit)
        box.topright = (self.rect.left - unit, widget.rect.top)
        box.clamp_ip(surface.get_rect())
        pygame.draw.rect(surface, theme.FACE, box, border_radius=unit // 2)
        pygame.draw.rect(surface, theme.EDGE, box, 1, border_radius=unit // 2)
        for i, line in enumerate(lines):
            text.draw(surface, line, size, theme.TEXT, (box.left + unit, box.top + unit // 2 + i * pitch))

    def _move(self, pos: tuple[int, int]) -> bool:
        if self._held is not None:
            self._held.drag(pos)
            return True
        under = self._under(pos)
        if under is not self._hovered:
            self._hovered, self._rest = under, 0.0
        return self.rect.collidepoint(pos)

    def _key(self, key: int, mod: int) -> bool:
        if key != pygame.K_TAB and self.focus is not None and self.focus.key(key, mod):
            return True
        if key in (pygame.K_TAB, pygame.K_UP, pygame.K_DOWN):
            back = key == pygame.K_UP or (key == pygame.K_TAB and bool(mod & pygame.KMOD_SHIFT))
            self._step(-1 if back else 1)
            return True
        return False

    def _step(self, by: int) -> None:
        stops = [widget for widget in self.widgets if widget.focusable]
        if stops:
            at = stops.index(self.focus) if self.focus in stops else -by
            self.focus = stops[(at + by) % len(stops)]
            self._show(self.focus)

    def _show(self, widget: Widget) -> None:
        """Scroll so far that a widget is in sight."""
        margin = 2 * self.unit
        if widget.rect.top < self.rect.top + margin:
            self.scroll -= self.rect.top + margin - widget.rect.top
        elif widget.rect.bottom > self.rect.bottom - margin:
            self.scroll += widget.rect.bottom - self.rect.bottom + margin

    def _under(self, pos: tuple[int, int]) -> Widget | None:
        if not self.rect.collidepoint(pos):
            return None
        return next((widget for widget in self.widgets if widget.rect.collidepoint(pos)), None)


def _row_height(row: list[Widget], unit: int) -> int:
    return round(max(widget.rows for widget in row) * 3 * unit)
