"""Playing a record again: through the engine and the rules as they are, and against what it says.

Where the two differ, the match goes on as it is recorded. Why they differ is told apart by what played then and what
plays now: the engine, the rules or the machine may have changed; where none has, the record was.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from ...errors import BudgetError, InputError
from ...physics.rollout import Rollout
from ..actions import Action, Stroke, from_dict
from ..match import Match, Moment
from . import engine, moments
from .earlier import digest
from .engine import Identity, identity_of
from .record import PLAYED_BY, REDO, UNDO, Record, RecordLine

# Why a line does not come out as it says. Of a record of an earlier version, which does not tell what played it,
# it is UNKNOWN.
BY_ENGINE, BY_RULES, BY_MACHINE, BY_RECORD, UNKNOWN = "engine", "rules", "machine", "record", "unknown"
REASONS = {
    BY_ENGINE: "the engine has changed since",
    BY_RULES: "the rules have changed since",
    BY_MACHINE: "this machine rounds otherwise than the one it was played on",
    BY_RECORD: "what played it is the same, so the record has been changed since",
    UNKNOWN: "the table or pool2d has changed since",
}
_ROLLS, _STANDS = "the shot does not roll", "the game does not stand"


class Divergence(NamedTuple):
    """Where a replay differs from its record, and why: one of REASONS."""

    line: int
    what: str
    why: str

    def __str__(self) -> str:
        return f"{self.what}; {REASONS[self.why]}"


class DivergenceError(InputError):
    """A record cannot be played past a line; `found` says which and why."""

    def __init__(self, source: str, found: Divergence) -> None:
        super().__init__(source, "", None, str(found), found.line)
        self.found = found


class ReplayedLine(NamedTuple):
    """A line of a record, the match as it stands after it, and how that differs from how it would come out now."""

    entry: RecordLine
    match: Match
    found: Divergence | None


class RecordedShot(NamedTuple):
    """A stroke of a record, to be looked at: its number, counted from 1, its line, and the moment it led to.

    `before` is the moment in which it was played. `found` tells where it would come out otherwise now; a shot that
    would roll otherwise is not `same`: `rollout` shows the balls as recorded before it, then after it, if the record
    tells that, and else how it rolls now.
    """

    number: int
    line: int
    match: Match
    before: Moment
    moment: Moment
    rollout: Rollout
    same: bool
    found: Divergence | None


class Restored(NamedTuple):
    """A match as its record left it, and what has changed since, so that it would have come out otherwise."""

    match: Match
    changes: tuple[str, ...]


def replayed(record: Record) -> Iterator[ReplayedLine]:
    """The match after each line, the first included. It is one match, which goes on with the iteration.

    Raises DivergenceError where the record cannot be gone on with: an action is refused, and what it led to is not
    told or not to be believed.
    """
    source = str(record.path)
    match = Match(record.table(), record.setup)
    then: Identity | None = None
    for entry in (record.head, *record.entries):
        then = identity_of(entry.data.get(PLAYED_BY)) or then
        yield ReplayedLine(entry, match, _Line(match, entry, then, source).played())


def divergences(record: Record) -> Iterator[Divergence]:
    """Every line that does not come out as it says, as far as the record can be played.

    Raises InputError where its table or setup is none.
    """
    try:
        for entry, _, found in replayed(record):
            if found is not None:
                yield found
                if not moments.tells(entry.data):
                    # From here on all is otherwise.
                    return
    except DivergenceError as error:
        yield error.found


def verify(record: Record) -> Divergence | None:
    """Play a record through the engine and the rules; the first line that does not come out as it says.

    Raises InputError where its table or setup is none.
    """
    return next(divergences(record), None)


def restored(record: Record) -> Restored:
    """The match as a record left it, and what has changed since.

    Raises InputError where the record itself has been changed, or does not tell enough to go on with it.
    """
    changes: dict[str, None] = {}
    for step in replayed(record):
        if step.found is not None:
            if step.found.why in (BY_RECORD, UNKNOWN):
                raise DivergenceError(str(record.path), step.found)
            changes[step.found.why] = None
    return Restored(step.match, tuple(changes))


def strokes(record: Record) -> Iterator[RecordedShot]:
    """Every stroke of a record in its order, also those that were undone, each worked out when it is asked for.

    Raises InputError where an entry's action is refused.
    """
    number = 0
    for entry, match, found in replayed(record):
        rollout = match.now.rollout
        if entry.data.get("do") == "stroke" and rollout is not None:
            number += 1
            same = rollout.digest() == entry.data.get("digest")
            yield RecordedShot(number, entry.line, match, match.history[-2], match.now, rollout, same, found)


class _Line:
    """A line of a record, to be played in a match that stands where the line before has left it.

    `then` is what played it, as far as that is told.
    """

    def __init__(self, match: Match, entry: RecordLine, then: Identity | None, source: str) -> None:
        self.match = match
        self.data, self.number = entry.data, entry.line
        self.then = then
        self.source = source
        self.before = match.now
        self.action: Action | None = None

    def played(self) -> Divergence | None:
        """Play it, and set the match right where it is recorded otherwise; how they differ."""
        do = self.data.get("do")
        edited = moments.tells(self.data) and moments.stamp(self.data) != self.data.get("state")
        if do in (UNDO, REDO):
            if not (self.match.undo() if do == UNDO else self.match.redo()):
                raise self.diverged(f"{do} is refused: there is nothing to go to")
            return self.edited() if edited else self.stands()
        if do is not None and (refused := self.refused(do)) is not None:
            self.set_right(refused)
            return refused
        found = self.edited() if edited else self.rolls() or self.stands(BY_RULES, BY_ENGINE)
        if found is not None:
            self.set_right(found, played=True)
        return found

    def refused(self, do: str) -> Divergence | None:
        """Carry the action out; how it is refused."""
        try:
            self.action = from_dict(self.data, self.source)
        except InputError as error:
            raise self.diverged(f"{do} is refused: {error}") from None
        try:
            self.match.play(self.action)
        except (InputError, BudgetError) as error:
            found = self.found(f"{do} is refused: {error}", BY_RULES, BY_ENGINE)
            if found.why in (BY_RECORD, UNKNOWN):
                raise DivergenceError(self.source, found) from None
            return found
        return None

    def rolls(self) -> Divergence | None:
        """How the shot rolls otherwise than recorded."""
        rollout = self.match.now.rollout
        if rollout is None or rollout.digest() == self.data.get("digest"):
            return None
        return self.found(f"{_ROLLS} {self.as_recorded}", BY_ENGINE)

    def stands(self, *changed: str) -> Divergence | None:
        """How the match stands otherwise than recorded, for which what may have `changed` is to blame."""
        state = self.data.get("state")
        if not moments.tells(self.data):
            alike = digest(self.match) == state
        else:
            now = self.match.now
            # A later version may tell the same otherwise.
            alike = moments.stamp(moments.as_dict(now)) == state or moments.same(self.recorded(), now)
        return None if alike else self.found(self.standing, *changed)

    def edited(self) -> Divergence:
        """How a line differs that contradicts itself."""
        return Divergence(self.number, self.standing, BY_RECORD)

    def set_right(self, found: Divergence, played: bool = False) -> None:
        """Have the match stand as recorded, where the line tells how; `played` where it stands otherwise now."""
        if not moments.tells(self.data):
            if not played:
                raise DivergenceError(self.source, found)
            return
        now, then = self.match.now, replace(self.recorded(), action=self.action)
        if played and not found.what.startswith(_ROLLS):
            then = replace(then, rollout=now.rollout, report=now.report)
        elif isinstance(self.action, Stroke):
            table = self.match.table
            then = moments.unplayed(self.before, then, self.action, self.data, table, self.source)
        self.match.accept(then, instead=played)

    def recorded(self) -> Moment:
        """The moment as the line tells it; raises DivergenceError where it cannot be read."""
        try:
            return moments.moment_of(self.data, self.match, self.source)
        except InputError as error:
            raise self.diverged(str(error), BY_RULES) from None

    @property
    def standing(self) -> str:
        """What is said where the match stands otherwise."""
        return f"{_STANDS} {self.as_recorded}" if "do" in self.data else "the balls do not start as recorded"

    @property
    def as_recorded(self) -> str:
        return f"as recorded after this {self.data.get('do')}"

    def diverged(self, what: str, *changed: str) -> DivergenceError:
        return DivergenceError(self.source, self.found(what, *changed))

    def found(self, what: str, *changed: str) -> Divergence:
        """A difference, and why: what has changed of what may be to blame, or else the record."""
        if self.then is None:
            return Divergence(self.number, what, UNKNOWN)
        now, reasons = engine.identity(), (*changed, BY_MACHINE)
        why = next((reason for reason in reasons if getattr(now, reason) != getattr(self.then, reason)), BY_RECORD)
        return Divergence(self.number, what, why if changed else BY_RECORD)
