"""Practice: everything may be arranged, and nobody rules."""

from __future__ import annotations

from ...stage.playback import Playback
from ...wording import shot_text
from ..messages import Message
from ..mode import Mode


class PracticeMode(Mode):
    """Strokes on a table that belongs to the player."""

    may_arrange = True

    @property
    def welcome(self) -> Message:
        return lambda: self.words.say("play.welcome", help=self.words.key("help"))

    def at_rest(self, shown: Playback) -> Message | None:
        if shown.again:
            return lambda: ""
        if self.session.in_hand or not shot_text.miscued(shown.rollout):
            cue = self.session.cue.id
            return lambda: shot_text.outcome(self.words, shown.rollout, cue)
        return None
