"""A session: what is played in the window, a match or practice, with its record if one is kept."""

from __future__ import annotations

from contextlib import suppress
from itertools import pairwise

from ..errors import InputError
from ..physics.rollout import Rollout
from ..physics.values import Ball, Layout, Shot
from ..table.table import Table
from .actions import Action, Arrange, Concede, NextFrame, Stalemate, Stroke
from .match import Match, Moment
from .records.recorder import Recorder, record, remove
from .rules import AIM, PLACE, Ask, Choice, Ruling
from .rules.report import Call
from .rules.spotting import may_place
from .setup import Setup

PRACTICE = "practice"


class Session:
    """A match as the window plays it: shots, cue ball in hand, choices, undo and redo.

    With a `recorder` every action is written to the disk; practice has none. It has more methods than most classes, as
    the window asks it for all that concerns the game.
    """

    def __init__(self, match: Match, recorder: Recorder | None = None) -> None:
        self.match = match
        self.recorder = recorder
        # The ball that was taken to be struck, and for which moment.
        self._taken: tuple[Moment | None, str] = None, ""

    @property
    def table(self) -> Table:
        return self.match.table

    @property
    def layout(self) -> Layout:
        return self.match.layout

    @property
    def ruling(self) -> Ruling:
        return self.match.now.ruling

    @property
    def ask(self) -> Ask:
        """What is to happen next."""
        return self.match.ask

    @property
    def is_practice(self) -> bool:
        """Whether this is practice: balls may be arranged and the table tuned."""
        return self.match.setup.game == PRACTICE

    @property
    def persons_turn(self) -> bool:
        """Whether it is for a person to go on; so it is between frames, as long as a person plays at all."""
        setup = self.match.setup
        return setup.is_person(self.ask.player) or (self.match.state.over and not setup.watched)

    @property
    def gives_up(self) -> int:
        """Who it is that a person may give the frame up for: whoever is asked, or the person beside the table."""
        setup, asked = self.match.setup, self.ask.player
        return asked if setup.watched or setup.is_person(asked) else self.match.rules.other(asked)

    @property
    def cue(self) -> Ball:
        """The ball to be struck, also while it is in hand."""
        moment, taken = self._taken
        ball = taken if moment is self.match.now else self.ask.ball
        return self.layout[ball or self.table.furniture.cue]

    def take_cue(self, ball: str) -> None:
        """Have this ball struck next; raises InputError where the rules do not leave the choice."""
        if ball not in self.ask.cues:
            allowed = ", ".join(self.ask.cues) or self.ask.ball
            raise InputError("match", "ball to be struck", ball, f"allowed is {allowed}")
        self._taken = self.match.now, ball

    @property
    def in_hand(self) -> bool:
        """Whether the cue ball has to be placed before anything else."""
        return self.ask.kind == PLACE

    @property
    def movable(self) -> bool:
        """Whether the cue ball may be placed now, be it in hand or on the table."""
        return bool(self.ask.where)

    @property
    def in_hand_by_foul(self) -> bool:
        """Whether a foul has given the cue ball in hand while it lies on the table, and nobody has placed it yet."""
        now = self.match.now
        played = not self.is_practice and self.match.state.shots > 0 and not placing(now)
        return played and self.ask.kind == AIM and self.movable

    @property
    def last(self) -> Moment | None:
        """The last stroke of this frame, unless the balls were arranged or racked since."""
        for moment in reversed(self.match.history):
            if moment.state.racks != self.match.state.racks:
                break
            if moment.rollout is not None:
                return moment
            if moment.action is None or isinstance(moment.action, Arrange | NextFrame | Stalemate):
                break
        return None

    @property
    def before(self) -> Moment | None:
        """The moment in which the last stroke was played; None where there was none."""
        last, pairs = self.last, pairwise(self.match.history)
        return next((before for before, moment in pairs if moment is last), None)

    @property
    def rollout(self) -> Rollout | None:
        """The rollout of the last stroke; None where there was none."""
        return None if self.last is None else self.last.rollout

    @property
    def shot(self) -> Shot | None:
        """The last stroke's shot."""
        action = None if self.last is None else self.last.action
        return action.shot if isinstance(action, Stroke) else None

    @property
    def strokes(self) -> int:
        """How many strokes have been played since the balls were racked or arranged."""
        return self.match.state.shots

    @property
    def left(self) -> int:
        """How many object balls are on the table."""
        cue = self.cue.id
        return sum(ball.id != cue for ball in self.layout.on_table())

    def play(self, shot: Shot, call: Call | None = None) -> Rollout:
        """Play a shot to its end, and have it judged.

        Raises InputError where no shot is asked for or it is out of range, BudgetError where it does not
        end; nothing has changed then.
        """
        rollout = self.do(Stroke(shot, call or Call())).rollout
        assert rollout is not None
        return rollout

    def may_place(self, x: float, y: float) -> bool:
        """Whether the cue ball may be put here: in the area that is asked for, and with room."""
        return self.movable and may_place(self.table, self.layout, self.cue.id, self.ask.where, x, y)

    def place(self, x: float, y: float) -> bool:
        """Put the cue ball on the table; False, and nothing done, where it may not stand there."""
        if not self.may_place(x, y):
            return False
        self.do(Choice("place", x, y))
        return True

    def choose(self, key: str) -> None:
        """Pick one of the options that are offered; raises InputError for another."""
        self.do(Choice(key))

    def concede(self, player: int) -> None:
        """A player gives the frame up."""
        self.do(Concede(player))

    def stalemate(self) -> None:
        """The players agree that the frame gets nowhere, and begin it again."""
        self.do(Stalemate())

    def next_frame(self) -> None:
        """Rack for the next frame; raises InputError before this one is over."""
        self.do(NextFrame())

    def arrange(self, layout: Layout) -> None:
        """Put the balls somewhere by hand; raises InputError where they cannot stand there, or in a match."""
        self.do(Arrange(layout))

    def rack(self, seed: int, name: str = "") -> None:
        """Set up a new rack, the table's first where none is named; raises InputError in a match."""
        self.arrange(self.table.rack(name or next(iter(self.table.furniture.racks)), seed))

    def undo(self) -> bool:
        """Undo the last action, and with it how the cue ball was placed since; False where there is nothing to undo.

        Against a player that is no person it goes back to the last decision of a person's.
        """
        undone = self._decided_before and self._back()
        while undone and not self._decides and self._back():
            pass
        return undone

    def redo(self) -> bool:
        """Redo what was last undone, up to a decision of a person's; False where nothing was, or something else was
        played since."""
        done = self._forth()
        while done and not self._decides and self._forth():
            pass
        return done

    def change_table(self, table: Table) -> None:
        """Practise on with other parameters.

        Raises InputError, changing nothing, where the balls do not fit, or in a match.
        """
        if not self.is_practice:
            raise InputError("table", "", None, "the table stays as it is for the length of a match")
        self.match.change_table(table)

    def leave(self) -> None:
        """Close the record, so that the match can be continued later; a record without any action is deleted."""
        if self.recorder is not None:
            self.recorder.close()
            if not self.recorder.begun:
                with suppress(InputError):
                    remove(self.recorder.path)

    def do(self, action: Action) -> Moment:
        """Carry out whatever was decided; raises as `Match.play`, nothing having changed then."""
        moment = (self.recorder or self.match).play(action)
        self._taken = None, ""
        return moment

    @property
    def _decides(self) -> bool:
        """Whether a person stands before a decision; in a match without people, any player."""
        return self.match.setup.watched or self.persons_turn

    @property
    def _decided_before(self) -> bool:
        """Whether there is a decision to go back to."""
        setup = self.match.setup
        before = self.match.history[:-1]
        return setup.watched or any(setup.is_person(moment.ruling.ask.player) for moment in before)

    def _back(self) -> bool:
        """Undo one action, and how the cue ball was placed before; whether there was one."""
        undone = False
        while True:
            last = self.match.now
            if not (self.recorder or self.match).undo():
                return undone
            undone = True
            if not placing(last):
                return True

    def _forth(self) -> bool:
        """Redo one action, and how the cue ball was placed for it; whether there was one."""
        done = (self.recorder or self.match).redo()
        while done and placing(self.match.now) and (self.recorder or self.match).redo():
            pass
        return done


def placing(moment: Moment) -> bool:
    """Whether a moment came of placing the cue ball."""
    return isinstance(moment.action, Choice) and moment.action.key == "place"


def practice(table: Table, seed: int = 0) -> Session:
    """Practice on a table, with its first rack."""
    return Session(Match(table, Setup(game=PRACTICE, seed=seed)))


def recorded(table: Table, setup: Setup) -> Session:
    """A match that is written down as it is played; raises InputError where it cannot be."""
    match = Match(table, setup)
    return Session(match, record(match))
