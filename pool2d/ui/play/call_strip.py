"""What the players say to the referee and hear: calls before a shot, choices after it, and why."""

from __future__ import annotations

import pygame

from ...draw import pen, theme
from ...draw.view import View
from ...game.match import Moment
from ...game.rules import CHOOSE
from ...game.session import Session, placing
from ..screen import Screen
from ..widgets.form import Form
from ..widgets.widget import Button, Toggle, Widget
from ..wording import ruling_text, shot_text
from ..wording.keyboard import digit_of
from ..wording.words import Words
from .calls import Calls

# How wide a button of the strip of calls is, in units.
_WIDE = 19
_CHOOSING = (pygame.K_TAB, pygame.K_LEFT, pygame.K_RIGHT, pygame.K_RETURN, pygame.K_SPACE)


class CallStrip:
    """The strip of buttons in the lower bar, which offers just what the ruling allows; `calls` is what was said.

    `taken` is how much of the message's room it takes, in pixels; `offers` whether there is a person to press them.
    """

    def __init__(self, calls: Calls, words: Words) -> None:
        self.calls = calls
        self.words = words
        self.form = Form([], margin=1)
        self.taken = 0
        self.offers = True
        self._moment: Moment | None = None
        self._shown: object = None

    def follow(self, session: Session) -> None:
        """Offer what the present moment asks for; what was called holds for one shot, wherever it is played from."""
        now = session.match.now
        if now is not self._moment:
            if not placing(now):
                self.calls.forget()
            self._moment = now
        # Said anew in another language, too.
        shown = (session.match.now, self.calls.pocket, self.calls.meant(session), self.words.language, self.offers)
        if shown != self._shown:
            self._shown = shown
            self.form.set_rows(self._rows(session) if self.offers else [])
            # While one aims, the keys are not the strip's.
            self.form.by_keys = session.ask.kind == CHOOSE

    def handle(self, event: pygame.event.Event, session: Session) -> bool:
        """Take an event; whether it was meant for the strip. Digits press its buttons in their order."""
        if not self.form.widgets:
            return False
        if event.type != pygame.KEYDOWN:
            return self.form.handle(event)
        number = digit_of(event.key) - 1
        if 0 <= number < len(self.form.widgets):
            self.form.widgets[number].key(pygame.K_SPACE, 0)
            return True
        mod = getattr(event, "mod", 0)
        step = -1 if mod & pygame.KMOD_SHIFT else 1
        action = self.words.keys.action_of(event.key, mod)
        if action == "call" and self.calls.pockets(session):
            self.calls.next_pocket(session, step)
            return True
        if action in ("call", "call_ball") and self.calls.balls(session):
            self.calls.next_ball(session, step)
            return True
        # While there is nothing else to do the strip's keys come first.
        return session.ask.kind == CHOOSE and event.key in _CHOOSING and self.form.handle(event)

    def place(self, screen: Screen, session: Session) -> None:
        """Lay the strip out in the lower bar: a choice where else the cue's diagrams are, calls at the end."""
        self.follow(session)
        self.taken = 0
        unit, count = screen.unit, len(self.form.widgets)
        if not count:
            return
        height = self.form.height(unit) + 2 * unit
        if session.ask.kind == CHOOSE:
            box = pygame.Rect(unit, 0, screen.message.left - 2 * unit, height)
            # A choice of many reaches a little over the table's rail, but never over its cloth.
            box.bottom = min(screen.height, screen.bottom.centery + height // 2)
        else:
            box = pygame.Rect(0, 0, min(screen.width, unit * (count * (_WIDE + 1) + 1)), height)
            box.midright = (screen.width - unit, screen.bottom.centery)
            self.taken = box.width + unit
        self.form.place(box, unit)

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the strip."""
        if self.form.widgets:
            self.form.draw(surface)

    def mark(
        self, surface: pygame.Surface, view: View, session: Session, aimed: str, pointer: tuple[int, int] | None
    ) -> None:  # fmt: skip
        """Mark what is called on the table: rings round ball and pocket, and a line between them.

        A faint ring is round what a click at the pointer would mean.
        """
        call = self.calls.said(session, aimed)
        named = call.ball if self.calls.pocket or self.calls.ball else self.calls.meant(session)
        marks: dict[str, theme.Color] = {mark: theme.ACCENT for mark in (named, call.pocket) if mark}
        if pointer is not None:
            for mark in self.calls.under(*view.to_table(*pointer), session):
                if mark:
                    marks.setdefault(mark, theme.ACCENT_FAINT)
        places = {pocket.name: (pocket.x, pocket.y, pocket.radius) for pocket in session.table.geometry.pockets}
        balls = session.layout
        places |= {ball.id: (ball.x, ball.y, session.table.body_of(ball)[0]) for ball in balls.on_table()}
        if call.ball and call.pocket:
            ends = [view.to_screen(*places[mark][:2]) for mark in (call.ball, call.pocket)]
            pen.line(surface, theme.ACCENT_FAINT, ends[0], ends[1], 1.5)
        for mark, color in marks.items():
            x, y, radius = places[mark]
            pen.ring(surface, color, view.to_screen(x, y), radius * view.scale + (3.0 if mark in balls else 0.0), 3.0)

    # What is on the strip.

    def _rows(self, session: Session) -> list[list[Widget]]:
        """A row of calls, or rows of two choices."""
        row = self._row(session)
        across = 2 if session.ask.kind == CHOOSE else max(1, len(row))
        return [row[i : i + across] for i in range(0, len(row), across)]

    def _row(self, session: Session) -> list[Widget]:
        say = self.words.say
        ask = session.ask
        row: list[Widget] = []
        calls = self.calls
        if calls.pockets(session):
            row.append(Button(say("referee.pocket", where=self._called()), lambda: calls.next_pocket(session)))
        elif calls.balls(session):
            row.append(Button(self._ball_named(session), lambda: calls.next_ball(session)))
        if "safety" in ask.may:
            row.append(Toggle(say("referee.safety"), lambda: calls.safety, lambda said: calls.declare(safety=said)))
        if "push" in ask.may:
            row.append(Toggle(say("referee.push"), lambda: calls.push, lambda said: calls.declare(push=said)))
        return [*row, *(self._option(session, option) for option in ask.options)]

    def _option(self, session: Session, key: str) -> Button:
        label = ruling_text.option(self.words, key)
        return Button(label, lambda: session.choose(key), strong=session.ask.kind == CHOOSE)

    def _called(self) -> str:
        """The ball and the pocket called, as far as they are, for a button."""
        parts = [ruling_text.ball(self.words, self.calls.ball)] if self.calls.ball else []
        parts += [shot_text.place_name(self.words, self.calls.pocket)] if self.calls.pocket else []
        return ", ".join(parts) or self.words.say("referee.obvious")

    def _ball_named(self, session: Session) -> str:
        """The button of the ball that is named, or is to be struck."""
        say = self.words.say
        if session.ask.cues:
            return say("referee.strikes", ball=ruling_text.ball(self.words, session.match.rules.spoken(session.cue.id)))
        ball = self.calls.ball
        named = shot_text.ball_name(self.words, ball, session.cue.id) if ball else say("referee.aimed_at")
        return say("referee.ball", ball=named)
