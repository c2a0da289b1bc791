"""What is so on a table that is played on: the session, the shot that is shown, and what is said."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

from ...draw import cue_motion
from ...errors import BudgetError, InputError
from ...game.actions import Stroke
from ...game.aim import Aim
from ...game.rules import AIM, OVER
from ...game.session import Session, practice
from ...physics.rollout import Rollout
from ...physics.values import Ball, Layout, Shot
from ...sound.mixer import Sounds
from ...table.clearance import Clearance
from ...table.preset import load_table
from ...table.table import Table
from ..scene import Scene, Wish
from ..stage.playback import Playback
from ..stage.show import Show
from ..stage.shown_balls import BallHistory, ShownBalls
from ..wording import ruling_text, shot_text
from ..wording.words import Words
from .calls import Calls
from .foresight import Foresight
from .hands import Hands
from .in_hand import InHand
from .messages import Messages
from .mode import Mode

# A shot shorter than this, s, that is seen again stays on its last moment until it is left.
_SHORT = 4.0


class PlayState:
    """A session as it is played, without a window.

    While `playback` is set, its shot is shown. `wish` is the scene that is to come next, None for this one. With
    `easy_stroke` shots are easy ones, as the options have it. It has more attributes and methods than most classes, as
    it is the one place where what hands, panels and menus do to a game is done.
    """

    def __init__(self, session: Session, words: Words, sounds: Sounds, mode_of: Callable[[PlayState], Mode]) -> None:
        self.session = session
        self.words = words
        self.sounds = sounds
        self.playback: Playback | None = None
        self.hands = Hands()
        self.in_hand = InHand()
        self.calls = Calls()
        self.balls = BallHistory()
        self.foresight = Foresight()
        self.show = Show()
        self.wish: Scene | Wish | None = None
        self.easy_stroke = False
        # The last stroke, and the elevation that its player had chosen for it.
        self._struck: tuple[Shot | None, float] = None, 0.0
        self._mode_of = mode_of
        self.mode = mode_of(self)
        self.messages = Messages(lambda: self.mode.standing)
        self.hands.player = session.ask.player
        self.messages.show(self.mode.welcome)

    # What is so.

    @property
    def rollout(self) -> Rollout | None:
        """The shot that is shown, if one is."""
        return None if self.playback is None else self.playback.rollout

    @property
    def held(self) -> Ball | None:
        """The ball that the player holds over the table, if any."""
        return self.in_hand.held(self.session) if self.playback is None else None

    @property
    def shown_balls(self) -> ShownBalls:
        """The balls at the moment that is shown."""
        if self.playback is None:
            return self.balls.at_rest(self.session.layout, self.session.rollout)
        return self.balls.during(self.playback.rollout, self.playback.time)

    @property
    def gone(self) -> tuple[str, ...]:
        """The balls that have fallen for good or are off the table, as the tray shows them."""
        return self.shown_balls.gone(self.session.match)

    @property
    def titles(self) -> tuple[str, str]:
        """What the upper bar says on its left and on its right."""
        return self.mode.titles(None if self.playback is None else self.gone)

    def aimed(self, speed: float | None = None) -> Shot:
        """The shot that is aimed, at the speed of a stroke by key or another, m/s, its butt as high as it has to be."""
        shot = self.chosen(speed)
        # Who plays without hands has seen to that.
        least = self.clearance.elevation if self.mode.persons_turn else None
        return shot if least is None else replace(shot, elevation=least)

    def chosen(self, speed: float | None = None) -> Shot:
        """The shot as the hands have it, whatever is in its way."""
        return self.hands.aim.shot(self.session.cue.id, speed, self.easy_stroke)

    @property
    def clearance(self) -> Clearance:
        """How far the butt has to be raised for what is aimed, and over what."""
        return self.foresight.clearance(self.session.table, self.session.layout, self.chosen())

    def first_hit(self, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        return self.foresight.first_hit(self.session.table, self.show.level, self.session.layout, shot)

    def go_to(self, wish: Scene | Wish) -> None:
        """Have another scene come as soon as the event that is being taken is done with."""
        self.wish = wish

    # The stroke, and its shot.

    def strike(self, speed: float, drawn: bool = False) -> None:
        """Play the shot that is aimed; `drawn` where a hand has drawn the cue back already."""
        self.hands.put_down()
        if self.session.ask.kind == OVER:
            self.wish = Wish.ENDED
            return
        if self.session.ask.kind == AIM and self.clearance.elevation is None:
            # Why not is said as long as it is aimed so.
            self.messages.show(lambda: "")
            return
        shot = self.aimed(speed)
        try:
            self.play(Stroke(shot, self.calls.said(self.session, self.first_hit(shot))), drawn)
        except (InputError, BudgetError) as error:
            self.messages.say(str(error))
            return
        self._struck = shot, self.hands.aim.elevation

    def play(self, stroke: Stroke, drawn: bool) -> None:
        """Play a stroke and show it; raises InputError and BudgetError as the session does, nothing having changed."""
        rollout = self.mode.play(stroke)
        self.hands.put_down()
        self.run(Playback(rollout, stroke.shot, cue_motion.lead(drawn, self.show.effects)))
        self.messages.show(lambda: self.words.say("play.miscue") if shot_text.miscued(rollout) else "")

    def replay(self) -> None:
        """Show the last shot again."""
        last = self.session.rollout
        if last is None:
            self.messages.show(lambda: self.words.say("play.no_shot"))
        elif self.playback is None:
            self.hands.put_down()
            shown = Playback(last, self.session.shot, cue_motion.lead(False, self.show.effects), again=True)
            # One so short would be gone before a hand is on its time line: it waits on its last moment.
            shown.kept = shown.end < _SHORT
            self.run(shown)
            self.messages.show(lambda: "")

    def run(self, playback: Playback) -> None:
        """Run a shot from its beginning; without a stroke before it, the tip is heard at once."""
        self.playback = playback
        if playback.time == 0.0:
            self.sounds.play_events(self.session.table, playback.rollout, -1.0, 0.0)

    def update(self, dt: float) -> Playback | None:
        """Let `dt` seconds pass; the shot that came to rest meanwhile, if one did."""
        if self.playback is None:
            self._change_hands()
            self.hands.rested += dt
            self.messages.update(dt)
            self.mode.update(dt)
            return None
        shown, before = self.playback, self.playback.time
        shown.update(dt)
        self.sounds.play_events(self.session.table, shown.rollout, before, shown.time)
        if not shown.over:
            return None
        self._come_to_rest(shown)
        return shown

    def _change_hands(self) -> None:
        """Once the shot has been seen, the next player takes the cue level, with no spin and no force set."""
        player = self.session.ask.player
        if player != self.hands.player and player >= 0:
            self.hands.take_over()
            self.hands.armed = False
            self.hands.player = player

    def _come_to_rest(self, shown: Playback) -> None:
        """Show no shot any more, and say what came of it."""
        self.playback = None
        self.hands.rest(keep=shown.review)
        if shot_text.miscued(shown.rollout) and not shown.again:
            self.sounds.chalk()
        if (words := self.mode.at_rest(shown)) is not None:
            self.messages.show(words)
        if not shown.again:
            self.wish = Wish.ENDED

    # What changes the balls, the table or the session.

    def begin(self, session: Session) -> None:
        """Go over to another session, and leave the one that was played."""
        self.drop()
        self.leave()
        self.session = session
        self.calls.forget()
        self.take_up(self._mode_of(self))
        self.hands.player = session.ask.player
        self.hands.take_over()
        self.hands.face(session.cue, session.layout)
        last = None
        for before, moment in pairwise(session.match.history):
            if moment.rollout is not None:
                self.balls.follow(before, moment.rollout, last)
                last = moment

    def leave(self) -> None:
        """Play the session no more: what it holds beside the table is let go of."""
        self.mode.leave()
        self.session.leave()

    def take_up(self, mode: Mode) -> None:
        """Play the session in this mode."""
        self.mode = mode
        self.messages.show(mode.welcome)

    def undo(self) -> None:
        """Take back what was done last."""
        say = self.words.say
        if self.mode.no_undo is not None:
            self.messages.show(self.mode.no_undo)
            return
        self.drop()
        undone = self.session.undo()
        self.messages.show(lambda: say("play.undone") if undone else say("play.nothing_to_undo"))
        self.wish = Wish.ENDED

    def redo(self) -> None:
        """Do again what was taken back last."""
        say = self.words.say
        self.drop()
        redone = self.session.redo()
        self.messages.show(lambda: say("play.redone") if redone else say("play.nothing_to_redo"))
        self.wish = Wish.ENDED

    def rack(self) -> None:
        """Set up a new rack, or what the mode has in its place."""
        if self.mode.rack() or not self.may_arrange():
            return
        self.drop()
        self.session.rack(random.randrange(1 << 30))
        self.hands.face(self.session.cue, self.session.layout)
        self.messages.show(lambda: self.words.say("play.new_rack"))

    def open_table(self, name: str) -> None:
        """Go over to another preset, with a new rack; raises InputError."""
        self.take_table(load_table(name))
        table = self.session.table
        self.messages.show(lambda: self.words.say("play.new_table", table=ruling_text.table_title(self.words, table)))

    def take_table(self, table: Table, layout: Layout | None = None) -> None:
        """Go over to a table, with a new rack or these balls; raises InputError, changing nothing."""
        session = practice(table, random.randrange(1 << 30))
        if layout is not None:
            session.arrange(layout)
        self.begin(session)

    def change_table(self, table: Table) -> None:
        """Play on with other parameters; raises InputError where the balls do not fit."""
        self.session.change_table(table)
        self.playback = None
        self.messages.show(lambda: self.words.say("play.file_changed"))

    def may_arrange(self) -> bool:
        """Whether the mode leaves balls and table to the player; where it does not, that is said."""
        if not self.mode.may_arrange:
            self.messages.show(lambda: self.words.say("play.practice_only"))
        return self.mode.may_arrange

    def arrange(self, layout: Layout, shot: Shot | None = None) -> bool:
        """Put the balls so, and aim so; False, and nothing is changed, where they cannot stand."""
        try:
            self.session.arrange(layout)
        except InputError as error:
            self.messages.say(str(error))
            return False
        self.drop()
        self.aim_as(shot)
        return True

    def aim_as(self, shot: Shot | None) -> None:
        """Aim a shot, or leave the aim as it is, until the pointer is moved."""
        if shot is not None:
            struck, elevation = self._struck
            self.hands.aim = Aim.of(replace(shot, elevation=elevation) if shot == struck else shot)
        self.hands.keep_aim()

    def drop(self) -> None:
        """Let go of whatever is under way."""
        self.mode.drop()
        self.playback = None
        self.hands.put_down()
        self.in_hand.put_back()

    def hand_over_cue_ball(self) -> None:
        """Put a cue ball that a foul has given into the hand, from where it lies: once, lest it come back by itself."""
        now = self.session.match.now
        if (
            self.playback is None
            and self.mode.persons_turn
            and not self.hands.busy
            and self.in_hand.given_at is not now
        ):
            self.in_hand.given_at = now
            if self.session.in_hand_by_foul and not self.in_hand.ball:
                self.in_hand.take(self.session.cue.id)
                self.hands.keep_aim()
