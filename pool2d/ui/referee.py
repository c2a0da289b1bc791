"""What the players say to the referee and hear: calls before a shot, choices after it, and why."""

from __future__ import annotations

import math

import pygame

from ..game.match import Moment
from ..game.report import Call
from ..game.rules import AIM, CHOOSE, OVER, PLACE, Ask
from ..game.session import Session, placing
from . import pen, rulings, telling, theme
from .form import Form
from .hud import Screen
from .keys import KEYS, action_of
from .view import View
from .widgets import Button, Toggle, Widget
from .words import say

# How wide a button of the strip of calls is, in units.
_WIDE = 19
_CHOOSING = (pygame.K_TAB, pygame.K_LEFT, pygame.K_RIGHT, pygame.K_RETURN, pygame.K_SPACE)


class Referee:
    """The strip of buttons in the lower bar, which offers just what the ruling allows.

    `pocket` and `ball` are what has been called for the next shot, "" where that is left to be obvious.
    """

    def __init__(self) -> None:
        self.pocket = self.ball = ""
        self.safety = self.push = False
        self.form = Form([], margin=1)
        self._moment: Moment | None = None
        self._shown: object = None

    def follow(self, session: Session) -> None:
        """Offer what the present moment asks for; what was called holds for one shot, wherever it is played from."""
        now = session.match.now
        if now is not self._moment:
            if not placing(now):
                self.pocket = self.ball = ""
                self.safety = self.push = False
            self._moment = now
        # Said anew in another language, too.
        shown = (session.match.now, self.pocket, self.ball, say("referee.safety"))
        if shown != self._shown:
            self._shown = shown
            self.form.set_rows(self._rows(session))
            # While one aims, the keys are not the strip's.
            self.form.by_keys = session.ask.kind == CHOOSE

    def handle(self, event: pygame.event.Event, session: Session) -> bool:
        """Take an event; whether it was meant for the strip. Digits press its buttons in their order."""
        if not self.form.widgets:
            return False
        if event.type != pygame.KEYDOWN:
            return self.form.handle(event)
        number: int = event.key - pygame.K_1
        if 0 <= number < len(self.form.widgets):
            self.form.widgets[number].key(pygame.K_SPACE, 0)
            return True
        if action_of(event.key, getattr(event, "mod", 0)) == "call" and session.ask.call:
            self._next_call(session)
            return True
        # While there is nothing else to do the strip's keys come first.
        return session.ask.kind == CHOOSE and event.key in _CHOOSING and self.form.handle(event)

    def point_out(self, x: float, y: float, session: Session) -> bool:
        """Call the pocket at a point of the table, or take that back; whether there is one to be called."""
        if session.ask.kind != AIM or session.ask.call != "pocket":
            return False
        for pocket in session.table.geometry.pockets:
            if math.hypot(pocket.x - x, pocket.y - y) <= pocket.radius:
                self.pocket = "" if self.pocket == pocket.name else pocket.name
                return True
        return False

    def said(self, session: Session, aimed: str) -> Call:
        """The call that goes with a shot aimed at a ball."""
        ask = session.ask
        if self.safety or self.push:
            return Call(safety=self.safety, push=self.push)
        if ask.call == "pocket" and self.pocket:
            return Call(self.ball or aimed, self.pocket)
        if ask.call == "ball":
            return Call(self.ball or (aimed if aimed in ask.on else ""))
        return Call()

    def warning(self, session: Session, aimed: str) -> str:
        """What to say of an aim that would hit a ball that is not on; empty where all is well."""
        ask = session.ask
        wanted = (self.ball,) if ask.call == "ball" and self.ball else ask.on
        if session.free or self.push or ask.kind != AIM or not aimed or not wanted or aimed in wanted:
            return ""
        return say("referee.not_on", ball=rulings.ball(aimed))

    def verdict(self, session: Session) -> str:
        """What the last ruling says, in sentences, and what it leaves to the player."""
        ask = session.ask
        # To put the cue ball down is no news.
        moment = next(moment for moment in reversed(session.match.history) if not placing(moment))
        said = [rulings.verdict(moment, session.match)]
        if ask.kind in (AIM, PLACE) and not session.free:
            said += self._on(ask)
        if ask.kind == AIM and ask.where and not any(note.key.startswith("in-hand") for note in moment.ruling.notes):
            said.append(say(f"referee.movable.{ask.where}"))
        if ask.kind == OVER:
            said.append(say("referee.over", key=KEYS.shown("strike")))
        return " ".join(said)

    def _on(self, ask: Ask) -> list[str]:
        """What may be hit, where that is one ball or one of many alike, or has to be named."""
        names = {rulings.ball(ball) for ball in ask.on}
        said = []
        if len(names) == 1:
            alike = len(ask.on) > 1
            said.append(say("referee.on_any", ball=names.pop()) if alike else say("referee.on", ball=names.pop()))
        elif ask.call == "ball":
            said.append(say("referee.name_one"))
        if "push" in ask.may:
            said.append(say("referee.may_push"))
        return said

    def place(self, screen: Screen, session: Session) -> int:
        """Lay the strip out in the lower bar: a choice where else the cue's diagrams are, calls at the end.

        Returns how wide it is there.
        """
        self.follow(session)
        unit, count = screen.unit, len(self.form.widgets)
        if not count:
            return 0
        height = self.form.height(unit) + 2 * unit
        if session.ask.kind == CHOOSE:
            box = pygame.Rect(unit, 0, screen.message.left - 2 * unit, height)
            # A choice of many reaches a little over the table's rail, but never over its cloth.
            box.bottom = min(screen.height, screen.bottom.centery + height // 2)
        else:
            box = pygame.Rect(0, 0, min(screen.width, unit * (count * (_WIDE + 1) + 1)), height)
            box.midright = (screen.width - unit, screen.bottom.centery)
        self.form.place(box, unit)
        return 0 if session.ask.kind == CHOOSE else box.width + unit

    def draw(self, surface: pygame.Surface, view: View, session: Session) -> None:
        """Draw the strip, and a ring round a pocket that is called."""
        for pocket in session.table.geometry.pockets:
            if pocket.name == self.pocket:
                pen.ring(surface, theme.ACCENT, view.to_screen(pocket.x, pocket.y), pocket.radius * view.scale, 3.0)
        if self.form.widgets:
            self.form.draw(surface)

    # What is on the strip.

    def _rows(self, session: Session) -> list[list[Widget]]:
        """A row of calls, or rows of two choices."""
        row = self._row(session)
        across = 2 if session.ask.kind == CHOOSE else max(1, len(row))
        return [row[i : i + across] for i in range(0, len(row), across)]

    def _row(self, session: Session) -> list[Widget]:
        ask = session.ask
        row: list[Widget] = []
        if ask.call == "pocket" and ask.kind == AIM:
            where = telling.place_name(self.pocket) if self.pocket else say("referee.obvious")
            row.append(Button(say("referee.pocket", where=where), lambda: self._next_call(session)))
        if ask.call == "ball" and ask.kind == AIM:
            named = telling.ball_name(self.ball, ask.ball) if self.ball else say("referee.aimed_at")
            row.append(Button(say("referee.ball", ball=named), lambda: self._next_call(session)))
        if "safety" in ask.may:
            row.append(Toggle(say("referee.safety"), lambda: self.safety, self._declare_safety))
        if "push" in ask.may:
            row.append(Toggle(say("referee.push"), lambda: self.push, self._declare_push))
        return [*row, *(self._option(session, option) for option in ask.options)]

    def _option(self, session: Session, key: str) -> Button:
        return Button(rulings.option(key), lambda: session.choose(key), strong=session.ask.kind == CHOOSE)

    def _next_call(self, session: Session) -> None:
        """Go on to the next pocket or ball that may be called; after the last, to none."""
        if session.ask.call == "pocket":
            names = ["", *(pocket.name for pocket in session.table.geometry.pockets)]
            self.pocket = names[(names.index(self.pocket) + 1) % len(names)]
        else:
            names = ["", *session.ask.on]
            self.ball = names[(names.index(self.ball) + 1) % len(names)]

    def _declare_safety(self, said: bool) -> None:
        self.safety, self.push = said, False

    def _declare_push(self, said: bool) -> None:
        self.push, self.safety = said, False
