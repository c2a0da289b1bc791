"""What is played on the screen, apart from the hands: the session, the shot that is shown, and what is told."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from itertools import pairwise

from ...draw import cue_motion, guide
from ...draw.effects import Effects
from ...errors import BudgetError, InputError
from ...game.aim import Aim
from ...game.rules import OVER
from ...game.session import Session, practice
from ...physics.rollout import Rollout
from ...physics.values import Layout, Shot
from ...sound.mixer import Sounds
from ...table.preset import load_table
from ...table.table import Table
from ..scene import Scene
from ..stage.playback import Playback
from ..stage.stage import Stage
from ..stage.timeline import Timeline
from ..wording import ruling_text, shot_text
from ..wording.keys import KEYS
from ..wording.words import say
from .call_strip import CallStrip
from .hands import Hands
from .in_hand import InHand
from .tuning import Tuning

# How long a notice is told before the referee's word comes back, s.
_READ = 4.0
# A shot shorter than this, s, that is seen again stays on its last moment until it is left.
_SHORT = 4.0


class SessionScene(Scene):
    """A session on screen.

    While `playback` is set, its shot is shown. `effects` is what the options allow to move for show; `warning`
    stays until what it warns of is mended. `message` says what is told until the next; in a match the referee's word
    comes back after a while. It is asked anew for every picture, as the language may change.
    """

    def __init__(self, session: Session, sounds: Sounds | None = None) -> None:
        self.session = session
        self.sounds = sounds or Sounds()
        self.stage = Stage(session.table)
        self.stage.cue_counts = session.match.rules.cue_counts
        self.hands = Hands()
        self.level = guide.GHOST
        self.playback: Playback | None = None
        self.timeline = Timeline()
        self.in_hand = InHand()
        self.call_strip = CallStrip()
        self.tuning: Tuning | None = None
        self.effects = Effects()
        self._message: Callable[[], str] = self._welcome
        # How long that has been told, and how long the balls have been at rest, s.
        self._age = self._rested = math.inf
        self._player = session.ask.player
        self.warning = ""
        # What opens once a shot or a choice has ended the frame.
        self.ended: Callable[[], Scene | None] = lambda: None
        self._next: Scene | None = None

    @property
    def table(self) -> Table:
        return self.session.table

    @property
    def rollout(self) -> Rollout | None:
        """The shot that is shown, if one is."""
        return None if self.playback is None else self.playback.rollout

    @property
    def message(self) -> Callable[[], str]:
        return self._message

    @message.setter
    def message(self, words: Callable[[], str]) -> None:
        self._message, self._age = words, 0.0

    @property
    def message_text(self) -> str:
        """What is told at present; empty where nothing is."""
        return self.message()

    @property
    def standing_message(self) -> Callable[[], str] | None:
        """What is told again once other things have been read; None in practice, where nobody rules."""
        return None if self.session.is_practice else self._verdict

    def _welcome(self) -> str:
        return say("play.welcome", help=KEYS.shown("help"))

    def _verdict(self) -> str:
        return self.call_strip.verdict(self.session, self.in_hand.held(self.session) is not None)

    def tell_standing_message(self) -> None:
        """Tell what is told where there is nothing else to tell."""
        self.message = self.standing_message or (lambda: "")

    @property
    def titles(self) -> tuple[str, str]:
        """What the upper bar tells of practice, on its left and on its right."""
        number, left = self.session.strokes + 1, self.session.left
        if self.playback is not None:
            # A shot that is seen is not told of before it is.
            number -= 1
            left = sum(ball != self.session.cue.id for ball in self.session.layout) - len(self.stage.pocketed)
        note = f"{say('play.shot', number=number)}   \N{MIDDLE DOT}   {say('play.left', count=left)}"
        table = self.session.table
        title = ruling_text.table_title(table)
        return say("play.tuned", table=title) if table.set or table.conditions else title, note

    @property
    def time(self) -> float:
        """The moment of that shot, s; below 0 the cue is still on its way."""
        return 0.0 if self.playback is None else self.playback.time

    def go_to(self, scene: Scene) -> None:
        """Show another scene as soon as the event that is being taken is done with."""
        self._next = scene

    def tell(self, words: str) -> None:
        """Tell this until something else is told."""
        self.message = lambda: words

    def aimed(self, shot: Shot) -> str:
        """The ball that a shot would meet first; empty where it meets none."""
        rollout = self.stage.foresee(self.level, self.session.layout, shot)
        pairs = [pair for event in rollout.events for pair in event.pairs if shot.ball in pair] if rollout else []
        return next((ball for ball in pairs[0] if ball != shot.ball), "") if pairs else ""

    def begin(self, session: Session) -> None:
        """Go over to another session, and leave the one that was played."""
        self.drop()
        self.tuning = None
        self.session.leave()
        self.session = session
        self.stage.cue_counts = session.match.rules.cue_counts
        self.call_strip = CallStrip()
        self.message = self._welcome if session.is_practice else self._verdict
        self._player = session.ask.player
        self.hands.take_over()
        self.hands.face(self.session.cue, self.session.layout)
        last = None
        for before, moment in pairwise(session.match.history):
            if moment.rollout is not None:
                self.stage.tracker.follow(before, moment.rollout, last)
                last = moment

    def _strike(self, speed: float, drawn: bool = False) -> None:
        """Play the shot that is aimed; `drawn` where a hand has drawn the cue back already."""
        self.hands.put_down()
        if self.session.ask.kind == OVER:
            self._next = self.ended()
            return
        shot = self.hands.aim.shot(self.session.cue.id, speed)
        try:
            rollout = self.session.play(shot, self.call_strip.calls.said(self.session, self.aimed(shot)))
        except (InputError, BudgetError) as error:
            self.tell(str(error))
            return
        self._show(Playback(rollout, shot, cue_motion.lead(drawn, self.effects)))
        self.message = lambda: say("play.miscue") if shot_text.missed(rollout) else ""

    def _replay(self) -> None:
        last = self.session.rollout
        if last is None:
            self.message = lambda: say("play.no_shot")
        elif self.playback is None:
            self.hands.put_down()
            shown = Playback(last, self.session.shot, cue_motion.lead(False, self.effects), again=True)
            # One so short would be gone before a hand is on its time line: it waits on its last moment.
            shown.kept = shown.end < _SHORT
            self._show(shown)
            self.timeline.begin(self.hands.pointer)
            self.message = lambda: ""

    def _pause(self) -> None:
        """Hold the shot that runs, or the last one at its beginning."""
        if self.playback is None:
            self._replay()
        if self.playback is not None:
            self.timeline.begin(self.hands.pointer)
            self.playback.pause()

    def _show(self, playback: Playback) -> None:
        """Run a shot from its beginning; without a stroke before it, the tip is heard at once."""
        self.playback = playback
        if playback.time == 0.0:
            self.sounds.play_events(self.session.table, playback.rollout, -1.0, 0.0)

    def _fast_forward(self, fast: bool) -> None:
        if self.playback is not None:
            self.playback.fast = fast

    def _undo(self) -> None:
        self.drop()
        undone = self.session.undo()
        self.message = lambda: say("play.undone") if undone else say("play.nothing_to_undo")
        self._next = self.ended()

    def _redo(self) -> None:
        self.drop()
        redone = self.session.redo()
        self.message = lambda: say("play.redone") if redone else say("play.nothing_to_redo")
        self._next = self.ended()

    def _rack(self) -> None:
        if not self.practising():
            return
        self.drop()
        self.session.rack(random.randrange(1 << 30))
        self.hands.face(self.session.cue, self.session.layout)
        self.message = lambda: say("play.new_rack")

    def open_table(self, name: str) -> None:
        """Go over to another preset, with a new rack; raises InputError."""
        self.take_table(load_table(name))
        table = self.session.table
        self.message = lambda: say("play.new_table", table=ruling_text.table_title(table))

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
        if self.tuning is not None:
            self.tuning.refresh()
        self.message = lambda: say("play.file_changed")

    def practising(self) -> bool:
        """Whether this is practice; where it is not, that is told."""
        if not self.session.is_practice:
            self.message = lambda: say("play.practice_only")
        return self.session.is_practice

    def arrange(self, layout: Layout, shot: Shot | None = None) -> bool:
        """Put the balls so, and aim so; False, and nothing is changed, where they cannot stand."""
        try:
            self.session.arrange(layout)
        except InputError as error:
            self.tell(str(error))
            return False
        self.drop()
        self.aim_as(shot)
        return True

    def aim_as(self, shot: Shot | None) -> None:
        """Aim a shot, or leave the aim as it is, until the pointer is moved."""
        if shot is not None:
            self.hands.aim = Aim.of(shot)
        self.hands.hold = self.hands.pointer

    def drop(self) -> None:
        """Let go of whatever is under way."""
        self.playback = None
        self.hands.put_down()

    def pass_time(self, dt: float) -> None:
        """Let the shot that is shown, the camera and the panels go on by `dt` seconds."""
        self.call_strip.follow(self.session)
        self.call_strip.form.update(dt)
        if self.playback is None:
            self._change_hands()
            self._rested += dt
            self._age += dt
            if self._age > _READ and self.standing_message is not None:
                self._message = self.standing_message
        if self.tuning is not None:
            self.tuning.follow(self.hands.aim.shot(self.session.cue.id))
            self.tuning.update(dt)
        self.stage.camera.update(dt, self.effects.eased)
        if self.playback is not None:
            before = self.playback.time
            self.playback.update(dt)
            self.sounds.play_events(self.session.table, self.playback.rollout, before, self.playback.time)
            if self.playback.over:
                self._come_to_rest(self.playback)

    def _change_hands(self) -> None:
        """Once the shot has been seen, the next player takes the cue level, with no spin and no force set."""
        player = self.session.ask.player
        if player != self._player and player >= 0:
            self.hands.take_over()
            self.hands.armed = False
            self._player = player

    def _come_to_rest(self, shown: Playback) -> None:
        """Show no shot any more, and tell what came of it."""
        self.playback = None
        self._rested = 0.0
        if shot_text.missed(shown.rollout) and not shown.again:
            self.sounds.chalk()
        if shown.again or not self.session.is_practice:
            self.tell_standing_message()
        elif self.session.in_hand or not shot_text.missed(shown.rollout):
            cue = self.session.cue.id
            self.message = lambda: shot_text.outcome(shown.rollout, cue)
        if not shown.again:
            self._next = self.ended()
