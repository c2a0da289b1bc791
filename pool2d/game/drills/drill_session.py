"""A drill as hands play it: a session in which the balls stand as the drill says, and each stroke is judged."""

from __future__ import annotations

from dataclasses import replace

from ...errors import InputError
from ...physics.rollout import Rollout
from ...physics.values import Shot
from ..match import Match, Moment
from ..rules import AIM, OVER, Ask
from ..rules.report import Call
from ..rules.ruling import AskKind
from ..session import PRACTICE, Session
from ..setup import Setup
from .drill import Drill, Run, begin


class DrillSession(Session):
    """A session on a drill; `run` is where it stands. Between two attempts no stroke is asked for."""

    def __init__(self, drill: Drill) -> None:
        super().__init__(Match(drill.table, Setup(game=PRACTICE)))
        self.drill = drill
        self.run: Run = begin(drill)
        self._stroke: Moment | None = None
        self.arrange(self.run.standing.layout)

    @property
    def is_practice(self) -> bool:
        """No: balls and table are the drill's."""
        return False

    @property
    def ask(self) -> Ask:
        kind: AskKind = OVER if self.run.standing.over else AIM
        return replace(super().ask, kind=kind, where="", options=())

    @property
    def last(self) -> Moment | None:
        """The last stroke of this attempt, though the balls may have been set up since for the next step."""
        return self._stroke

    def play(self, shot: Shot, call: Call | None = None) -> Rollout:
        """Play a shot and have the drill judge it; raises as any session's, and InputError between attempts."""
        if self.run.standing.over:
            raise InputError("drill", "action", "a stroke", "the attempt is over; the balls have to be set up first")
        rollout = super().play(shot, call)
        self._stroke = self.match.now
        self.run = self.run.after(rollout)
        if not self.run.standing.over and self.run.standing.layout != self.layout:
            self.arrange(self.run.standing.layout)
        return rollout

    def again(self) -> None:
        """Set the balls up for the next attempt, or where there is none left for a new run."""
        self.run = begin(self.drill) if self.run.over else self.run.again()
        self._stroke = None
        self.arrange(self.run.standing.layout)

    def rack(self, seed: int = 0, name: str = "") -> None:
        self.again()

    def undo(self) -> bool:
        """False: what was played counts."""
        return False

    def redo(self) -> bool:
        return False
