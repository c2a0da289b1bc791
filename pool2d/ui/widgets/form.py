"""A column of widgets: it keeps the focus, scrolls, and shows hints."""

from __future__ import annotations

import pygame

from ...draw import shapes, text, theme
from .widget import Widget, ring, scroll_mark

# How long the pointer rests on a widget until its hint is shown, s.
_HINT = 0.5


class Form:
    """Rows of widgets on a panel. It hands them the events that they are to take, and draws them.

    Tab and Shift+Tab move the focus, and so do Up and Down where the focused widget has no use for them; Page Up,
    Page Down, Home and End move it farther. Left and Right go along a row of several widgets. The wheel scrolls,
    and so does dragging the scroll bar. The ring round the focused widget is drawn while the focus is moved by
    keys. `margin` is the space between the widgets and the panel's edge, in units of the grid. It has more attributes
    than most classes, as it keeps what the mouse, the keys and the scroll bar are at.
    """

    def __init__(self, rows: list[list[Widget]], margin: int = 2) -> None:
        self.margin = margin
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.unit = 8
        self.rows: list[list[Widget]] = []
        self.focus: Widget | None = None
        self.scroll = 0
        self.by_keys = True
        self._held: Widget | None = None
        self._pressed = False
        self._scrolling: int | None = None
        self._inside = False
        self._hovered: Widget | None = None
        self._rest = 0.0
        self.set_rows(rows)

    @property
    def widgets(self) -> list[Widget]:
        return [widget for row in self.rows for widget in row]

    def set_rows(self, rows: list[list[Widget]]) -> None:
        """Show other rows; the focus stays on its widget, or goes to the one now in its place."""
        at = self.widgets.index(self.focus) if self.focus is not None else 0
        self.rows = rows
        if self.focus not in self.widgets:
            there = self.widgets[at : at + 1]
            self.focus = next((widget for widget in there + self.widgets if widget.focusable), None)
        if self._held is not None and self._held not in self.widgets:
            self._held.held, self._held = False, None
        if self._hovered not in self.widgets:
            self._hovered = None
        if self.rect.width:
            # The next event may come before the next picture.
            self.place(self.rect, self.unit)

    def height(self, unit: int) -> int:
        """The height of all rows together, in pixels, for a grid of `unit` pixels."""
        return sum(_row_height(row, unit) for row in self.rows)

    def place(self, rect: pygame.Rect, unit: int) -> None:
        """Lay the widgets out within `rect`, in pixels, on a grid of `unit` pixels."""
        self.rect, self.unit = rect, unit
        self.scroll = max(0, min(self.scroll, self.height(unit) - rect.height + 2 * self.margin * unit))
        margin = self.margin * unit
        y = rect.top + margin - self.scroll
        for row in self.rows:
            height = _row_height(row, unit)
            width = (rect.width - 2 * margin - (len(row) - 1) * unit) // len(row)
            for i, widget in enumerate(row):
                widget.rect = pygame.Rect(rect.left + margin + i * (width + unit), y, width, height)
            y += height

    def handle(self, event: pygame.event.Event) -> bool:
        """Take an event; returns whether the form had a use for it, so that nobody else is to take it."""
        if event.type == pygame.MOUSEMOTION:
            return self._move(event.pos)
        if event.type == pygame.MOUSEBUTTONDOWN and self.rect.collidepoint(event.pos):
            self._press(event.pos, event.button)
            return True
        if event.type == pygame.MOUSEBUTTONUP and event.button == 1 and self._pressed:
            # The release belongs to the form that took the press, also where its widget has gone since.
            self._release(event.pos)
            return True
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, getattr(event, "mod", 0))
        if event.type == pygame.TEXTINPUT and self.focus is not None:
            self.focus.type(event.text)
            return True
        if event.type == pygame.MOUSEWHEEL and self._inside:
            self.scroll -= event.y * 4 * self.unit
            return True
        if event.type == pygame.WINDOWFOCUSLOST:
            self.let_go()
        return False

    def let_go(self) -> None:
        """Release whatever is held by the mouse: the window has lost it, and its button's release may never come."""
        if self._held is not None:
            self._held.held, self._held.pointer = False, None
        self._held, self._pressed, self._scrolling = None, False, None

    def update(self, dt: float) -> None:
        self._rest += dt

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the panel, the widgets on it and perhaps a hint."""
        shapes.panel(surface, self.rect, self.unit)
        clip = surface.get_clip()
        surface.set_clip(self.rect)
        for widget in self.widgets:
            if widget.rect.colliderect(self.rect):
                shown = widget is self.focus and (self.by_keys or not widget.ringed)
                widget.draw(surface, self.unit, shown, widget is self._hovered)
        if self.focus is not None and self.by_keys and self.focus.ringed:
            ring(surface, self.focus, self.unit)
        mark = self._mark()
        if mark is not None:
            color = theme.TEXT if self._scrolling is not None else theme.QUIET if self._inside else theme.EDGE
            shapes.rounded(surface, mark, color, self.unit)
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
        if box.left < 0:
            # No room beside the form: below the widget then, or above it.
            box.topleft = (widget.rect.left, widget.rect.bottom + unit // 2)
            if box.bottom > surface.get_height():
                box.bottom = widget.rect.top - unit // 2
        box.clamp_ip(surface.get_rect())
        shapes.rounded(surface, box, theme.FACE, unit // 2, theme.EDGE)
        for i, line in enumerate(lines):
            text.draw(surface, line, size, theme.TEXT, (box.left + unit, box.top + unit // 2 + i * pitch))

    def _press(self, pos: tuple[int, int], button: int) -> None:
        self._pressed = button == 1
        mark = self._mark()
        if button != 1:
            return
        if mark is not None and mark.inflate(self.unit, 0).collidepoint(pos):
            self._scrolling = pos[1]
            return
        widget = self._under(pos)
        if widget is not None and widget.focusable:
            self.by_keys = False
            if self.focus is not None and self.focus is not widget:
                self.focus.leave()
            self.focus = self._held = widget
            widget.held, widget.pointer = True, pos
            widget.press(pos)

    def _release(self, pos: tuple[int, int]) -> None:
        held, self._held, self._pressed, self._scrolling = self._held, None, False, None
        if held is not None:
            held.held = False
            held.release(pos)

    def _move(self, pos: tuple[int, int]) -> bool:
        self._inside = self.rect.collidepoint(pos)
        if self._scrolling is not None:
            whole = self.height(self.unit) + 2 * self.margin * self.unit
            self.scroll += (pos[1] - self._scrolling) * whole // max(1, self.rect.height)
            self._scrolling = pos[1]
            return True
        if self._held is not None:
            self._held.pointer = pos if self._held.rect.collidepoint(pos) else None
            self._held.drag(pos)
            return True
        under = self._under(pos)
        if under is not self._hovered:
            if self._hovered is not None:
                self._hovered.pointer = None
            self._hovered, self._rest = under, 0.0
        if under is not None:
            under.pointer = pos
        return self._inside

    def _mark(self) -> pygame.Rect | None:
        """The scroll bar's handle, in pixels; None where all rows are in sight."""
        whole = self.height(self.unit) + 2 * self.margin * self.unit
        return scroll_mark(self.rect, self.scroll, self.rect.height, whole, self.unit)

    def _key(self, key: int, mod: int) -> bool:
        focus = self.focus
        if focus is not None and (key != pygame.K_TAB or focus.greedy) and focus.key(key, mod):
            return True
        if key in (pygame.K_TAB, pygame.K_UP, pygame.K_DOWN):
            back = key == pygame.K_UP or (key == pygame.K_TAB and bool(mod & pygame.KMOD_SHIFT))
            self._step(-1 if back else 1)
            return True
        if key in (pygame.K_PAGEUP, pygame.K_PAGEDOWN, pygame.K_HOME, pygame.K_END):
            self._leap(key)
            return True
        return key in (pygame.K_LEFT, pygame.K_RIGHT) and self._step_aside(-1 if key == pygame.K_LEFT else 1)

    def _step(self, by: int) -> None:
        stops = [widget for widget in self.widgets if widget.focusable]
        self.by_keys = True
        if stops:
            at = stops.index(self.focus) if self.focus in stops else -by
            self.focus = stops[(at + by) % len(stops)]
            self._show(self.focus)

    def _leap(self, key: int) -> None:
        """Move the focus by Home or End to the first or last widget, by Page Up or Down about as far as is in sight."""
        stops = [widget for widget in self.widgets if widget.focusable]
        self.by_keys = True
        if not stops:
            return
        if key in (pygame.K_HOME, pygame.K_END):
            to = stops[0 if key == pygame.K_HOME else -1]
        else:
            page = self.rect.height * 3 // 4
            here = (self.focus or stops[0]).rect.centery + (page if key == pygame.K_PAGEDOWN else -page)
            to = min(stops, key=lambda widget: abs(widget.rect.centery - here))
        if self.focus is not None and self.focus is not to:
            self.focus.leave()
        self.focus = to
        self._show(to)

    def _step_aside(self, by: int) -> bool:
        """Move the focus along its row; returns whether there was a widget to go to."""
        row = next((row for row in self.rows if self.focus in row), [])
        stops = [widget for widget in row if widget.focusable]
        at = stops.index(self.focus) + by if self.focus in stops else -1
        if not 0 <= at < len(stops):
            return False
        self.by_keys = True
        self.focus = stops[at]
        return True

    def _show(self, widget: Widget) -> None:
        """Scroll until a widget is in sight."""
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
