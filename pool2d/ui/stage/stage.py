"""The table with what lies on it, on a window of some size; remembers what costs time to draw."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from ...draw import guide, pen, theme
from ...draw.balls import ball_art, tray
from ...draw.tabletop.background import Background
from ...draw.view import View, fit
from ...physics.orientation import FACING, Quaternion
from ...physics.rollout import Rollout
from ...physics.values import OFF, RESTING, Ball, Layout
from ...table.flights import jumped
from ...table.furniture import Look
from ...table.table import Table
from ..frame import Frame
from ..screen import Screen
from . import bars
from .camera import Camera
from .shown_balls import ShownBalls

# A ball in hand has light round it: discs so many times as wide, each of so much light, of 255.
_GLOW, _LIGHT = (1.9, 1.65, 1.4, 1.2), 34


class Stage:
    """The surface being drawn on, the table, and where the one is on the other; `style` is how balls are drawn."""

    def __init__(self, table: Table) -> None:
        self.table = table
        self.style = theme.PLAIN
        self.bars = bars.CachedBars()
        self.screen = Screen(1280, 720)
        self.camera = Camera()
        self._background = Background()
        self._fit(0)

    def lay_out(self, screen: Screen, table: Table, panel: int = 0) -> None:
        """Put a table between the bars of a window, less `panel` pixels on the right."""
        self.table, self.screen = table, screen
        self._fit(panel)

    def begin(self, frame: Frame) -> None:
        """Draw the table, or as much of it as the last frame has drawn over."""
        # The bars are drawn over the rest.
        frame.surface.set_clip(self.screen.table)
        frame.begin_over(self._background.show(frame.surface, self.table, self.camera.home, self.view, frame.before))
        frame.surface.set_clip(None)

    @property
    def view(self) -> View:
        """Where the table is on the window at this moment."""
        return self.camera.view

    @property
    def still(self) -> bool:
        """Whether the camera rests and the table's picture is drawn in full."""
        return self.camera.settled and self._background.settled

    def balls(self, frame: Frame, shown: ShownBalls, but: str = "", running: bool = False) -> None:
        """Draw every ball on the table as it lies, `but` one, and those on their way into a pocket.

        While a shot is `running`, balls that move are drawn for one frame only, and roughly.
        """
        # On its way the camera shows each frame another size of ball, for which no skin is worth making.
        rough = running and self.camera.settled
        layout, orientations = shown.layout, shown.states.orientations
        balls = []
        if shown.rollout is not None and shown.rotation is not None:
            balls = tray.going(shown.rollout, shown.rotation, self.table, shown.t, self._placed)
        balls += [
            self._placed(ball, orientations.get(ball.id, FACING), not rough or ball.phase == RESTING)
            for ball in ball_art.from_below(layout.on_table())
            if ball.id != but
        ]
        frame.add(ball_art.draw_all(frame.surface, balls, self.style))

    def ball(self, surface: pygame.Surface, ball: Ball, faint: bool = False) -> None:
        look = self.table.furniture.looks.get(ball.id)
        centre = self.view.to_screen(ball.x, ball.y)
        ball_art.draw(surface, ball.id, centre, self._radius(ball), faint, look, style=self.style)

    def tray(self, surface: pygame.Surface, gone: Sequence[str], layout: Layout) -> None:
        """Draw the balls of a layout that have fallen, and those that are off the table."""
        off = [layout[ball].phase == OFF for ball in gone]
        tray.draw(surface, self.screen.tray, [self._look(ball) for ball in gone], self.style, off=off)

    def in_hand(self, surface: pygame.Surface, ball: Ball, free: bool) -> None:
        """Draw a ball held over the table, ringed by whether it has room there."""
        color = theme.ACCENT if free else theme.WARNING
        self.glow(surface, ball, color)
        self.ball(surface, ball, faint=True)
        pen.ring(surface, color, self.view.to_screen(ball.x, ball.y), self._radius(ball) + 2.0, 2.0)

    def glow(self, surface: pygame.Surface, ball: Ball, color: theme.Color = theme.ACCENT) -> None:
        """Draw light round a ball that can be taken, or is held."""
        place, radius = self.view.to_screen(ball.x, ball.y), self._radius(ball)
        for part in _GLOW:
            pen.disc(surface, (*color[:3], _LIGHT), place, radius * part)

    def guide(self, surface: pygame.Surface, level: int, rollout: Rollout | None, ball: str) -> None:
        """Draw what a shot that strikes `ball` would do, as far as it can be foreseen."""
        if rollout is not None:
            if level == guide.WHOLE:
                guide.draw_whole(surface, rollout, self.table, self.view, style=self.style)
            fore = guide.foresee(rollout, ball, within=guide.fineness(self.view))
            over = [(rollout.ball_at(one.ball, one.t), one) for one in jumped(rollout, self.table, ball)]
            guide.draw(surface, fore, level, self.table, self.view, over)

    def comparison(
        self, surface: pygame.Surface, before: Rollout | None, compared: Rollout | None, now: Rollout | None
    ) -> None:
        """Draw what a shot did before the table was tuned, what it does now, and on the table compared."""
        for rollout, cue, other in (
            (before, theme.PATH_OLD, theme.PATH_OLD),
            (compared, theme.PATH_COMPARED, theme.PATH_COMPARED),
            (now, theme.GUIDE_CUE, theme.GUIDE_BALL),
        ):
            if rollout is not None:
                guide.draw_whole(surface, rollout, self.table, self.view, cue, other, self.style)

    def _fit(self, panel: int) -> None:
        size = self.table.knobs.table
        left, top, width, height = self.screen.table
        area = (left, top, max(1, width - panel), height)
        self.camera.fit(fit(size.length, size.width, area), (size.length, size.width), area)

    def _look(self, ball: str) -> Look:
        return ball_art.look_of(self.table, ball)

    def _placed(self, ball: Ball, orientation: Quaternion, fine: bool = True) -> ball_art.Placed:
        placed = ball_art.placed_on(self.table, self.view, ball, orientation)._replace(fine=fine)
        if self.camera.settled:
            return placed
        # On its way each frame has balls of another size, whose light is worked out for each part of a pixel.
        x, y = placed.centre
        return placed._replace(centre=(round(x), round(y)))

    def _radius(self, ball: Ball) -> float:
        return self.table.body_of(ball)[0] * self.view.scale
