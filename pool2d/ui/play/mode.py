"""What differs between the ways to play: practice, a match, a drill."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ...game.actions import Stroke
from ...game.drills.drill import Step
from ...game.session import Session
from ...physics.rollout import Rollout
from ..stage.playback import Playback
from ..wording import ruling_text
from ..wording.words import Words
from .messages import Message


class Mode:
    """One way to play a session. `may_arrange` is whether balls may be moved and the table tuned as one likes.

    `keys` is what keys do in this mode only, or otherwise than in the others, by the names of their actions;
    `no_undo` says why a stroke cannot be taken back, where it cannot.
    """

    may_arrange = False
    no_undo: Message | None = None

    def __init__(self, session: Session, words: Words) -> None:
        self.session = session
        self.words = words
        self.keys: Mapping[str, Callable[[], None]] = {}

    @property
    def persons_turn(self) -> bool:
        """Whether it is for a person's hands to go on; else they only look on."""
        return True

    @property
    def still(self) -> bool:
        """Whether nothing is going to happen by itself."""
        return True

    @property
    def no_stalemate(self) -> Message | None:
        """Why the frame cannot be begun again, where somebody does not agree to that."""
        return None

    # What is said.

    @property
    def standing(self) -> Message | None:
        """What is said once other things have been read; None where nothing is."""
        return None

    @property
    def welcome(self) -> Message:
        """What is said first."""
        raise NotImplementedError

    def titles(self, gone: Sequence[str] | None) -> tuple[str, str]:
        """What the upper bar says on its left and on its right.

        `gone` are the balls that have fallen or left the table so far in the shot that is shown; None where none is.
        """
        say = self.words.say
        number, left = self.session.strokes + 1, self.session.left
        if gone is not None:
            # What a shot leads to is not told before it is seen.
            number -= 1
            left = sum(ball != self.session.cue.id for ball in self.session.layout) - len(gone)
        note = f"{say('play.shot', number=number)}   \N{MIDDLE DOT}   {say('play.left', count=left)}"
        table = self.session.table
        title = ruling_text.table_title(self.words, table)
        return say("play.tuned", table=title) if table.set or table.conditions else title, note

    @property
    def step(self) -> Step | None:
        """What the stroke has to do, to be marked on the cloth; None where that is left to the player."""
        return None

    # What happens at a session's turns.

    def play(self, stroke: Stroke) -> Rollout:
        """Play a stroke; raises InputError and BudgetError as the session does."""
        rollout = self.session.do(stroke).rollout
        assert rollout is not None
        return rollout

    def at_rest(self, shown: Playback) -> Message | None:
        """Do what follows on a shot that has been seen; what is to be said of it, None for what is said already."""
        return self.standing

    def go_on(self) -> bool:
        """Take a key of the stroke, or a press on the cloth, before it means a stroke; whether it meant this."""
        return False

    def update(self, dt: float) -> None:
        """Let `dt` seconds pass while no shot is shown."""

    def rack(self) -> bool:
        """Set the balls up in the mode's own way; False where it has none."""
        return False

    def drop(self) -> None:
        """Let go of whatever the mode is showing."""

    def leave(self) -> None:
        """Let go of whatever the mode holds beside the table: the session is left."""

    def cancel(self) -> bool:
        """Take the key that goes back; whether it meant something in this mode."""
        return False
