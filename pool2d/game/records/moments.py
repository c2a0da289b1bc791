"""Where a match stands, as a record's line tells it: enough to show it, and to go on from it, without playing up to it.

What is read is checked: a line may have been written by hand.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, fields, replace
from typing import Any

from ...errors import InputError
from ...physics.body import Body
from ...physics.event import Event
from ...physics.motion import Motion
from ...physics.rollout import Rollout
from ...physics.values import GONE, OFF, RESTING, Ball, EventKind, Layout
from ...table.position_text import read, write
from ...table.table import Table
from ..actions import Stroke
from ..match import Match, Moment, lagged
from ..rules import AIM, CHOOSE, OVER, PLACE, Note, Ruling, State
from ..rules import report as reports
from ..rules.notes import ENGLISH, note_of, written
from ..rules.report import Contact, ContactKind, Report
from ..rules.ruling import WRITTEN
from ..tally import Tally

# The keys of a line that tell the moment; one that has the first has them all.
BALLS, GAME, TALLIES, TURN = "balls", "game", "tallies", "turn"
# The keys of what is told of balls that went, each with the pocket or the cushion, and which contact that was.
_WENT: dict[str, ContactKind] = {"fell": reports.POCKET, "off": reports.OFF}
# How long a shot that is not played again is seen before it is over, s.
SEEN = 1.0
_SCORES = 1_000_000_000


def as_dict(moment: Moment) -> dict[str, Any]:
    """A moment as a record's line holds it, in JSON's types; `moment_of` reads it."""
    ruling, contacts = moment.ruling, () if moment.report is None else moment.report.contacts
    went = {key: [[c.ball, c.other] for c in contacts if c.kind == kind] for key, kind in _WENT.items()}
    return {
        BALLS: write(moment.layout),
        GAME: moment.state.as_dict(),
        TALLIES: [asdict(tally) for tally in moment.tallies],
        "notes": list(map(written, ruling.notes)),
        "fouls": list(map(written, ruling.fouls)),
        "spotted": [[ball, list(place)] for ball, place in ruling.spotted],
        "points": list(ruling.points),
        TURN: [moment.breaker, moment.frame, moment.shooter],
        **({"lag": True} if lagged(moment.state) else {}),
        **{key: balls for key, balls in went.items() if balls},
    }


def tells(data: Mapping[str, Any]) -> bool:
    """Whether a line holds its moment whole; lines of earlier versions hold a digest only."""
    return BALLS in data


def stamp(data: Mapping[str, Any]) -> str:
    """A digest of those parts of a line that say where the match stands."""
    said = json.dumps([data.get(key) for key in (BALLS, GAME, TALLIES, TURN)], sort_keys=True)
    return hashlib.sha256(said.encode()).hexdigest()[:16]


def moment_of(data: Mapping[str, Any], match: Match, source: str) -> Moment:
    """The moment that a line tells of a match, its action aside; raises InputError where it is none."""
    layout = _layout(data.get(BALLS), source)
    state = _state(data, match, layout, source)
    players = match.rules.players
    tallies = tuple(_tally(one, source) for one in _list(data, TALLIES, source))
    if len(tallies) != players:
        raise InputError(source, TALLIES, len(tallies), f"allowed are those of {players} players")
    breaker, frame, shooter = _numbers(data, TURN, 3, source)
    for player in (breaker, shooter):
        if not -1 <= player < players:
            raise InputError(source, TURN, player, f"allowed is -1 to {players - 1}")
    ruling = Ruling(
        state, layout, _notes(data, "notes", source), _notes(data, "fouls", source), _spotted(data, source),
        _numbers(data, "points", players, source),
    )  # fmt: skip
    return Moment(ruling, tallies, breaker, frame, shooter)


def same(a: Moment, b: Moment) -> bool:
    """Whether a match stands the same at two moments; what the referee said is not compared."""

    def counts(moment: Moment) -> tuple[object, ...]:
        return moment.state, moment.layout, moment.tallies, moment.breaker, moment.frame, moment.shooter

    return counts(a) == counts(b)


def unplayed(
    before: Moment, after: Moment, stroke: Stroke, data: Mapping[str, Any], table: Table, source: str
) -> Moment:
    """The moment `after` a stroke that nobody can play again: its shot shows the balls before it, then after it."""
    went = []
    for key, kind in _WENT.items():
        for pair in _list(data, key, source):
            whole = isinstance(pair, list) and len(pair) == 2 and isinstance(pair[1], str)
            if not whole or pair[0] not in before.layout:
                raise InputError(source, key, pair, "allowed are a ball and its pocket, or the cushion it went over")
            went.append(Contact(kind, pair[0], pair[1]))
    rollout = _jump(before.layout, after.layout, went, table)
    if lagged(before.state):
        return replace(after, action=stroke, rollout=rollout)
    report = Report(tuple(went), stroke.call, stroke.shot.ball, start=before.layout)
    return replace(after, action=stroke, rollout=rollout, report=report)


def _jump(start: Layout, end: Layout, went: list[Contact], table: Table) -> Rollout:
    """A shot of which only the beginning and the end are known: the balls lie as before it, then as after it."""
    where = {contact.ball: contact.other for contact in went}
    order = [*where, *(ball for ball in start if ball not in where)]
    tracks: dict[str, list[Motion]] = {}
    events = []
    for ball in order:
        if ball not in end or (end[ball] == start[ball]):
            continue
        old = Motion(_body(start[ball], table), start[ball].phase, 0.0, SEEN)
        new = Motion(_body(end[ball], table), end[ball].phase, SEEN, float("inf"))
        tracks[ball] = [old, new]
        if end[ball].phase in GONE and start[ball].phase not in GONE:
            # It is seen to go from where it went, not from where it lay.
            last = Motion(_body(end[ball], table), RESTING, SEEN, SEEN)
            kind: EventKind = "ball_off" if end[ball].phase == OFF else "ball_pocket"
            events.append(Event(SEEN, kind, where.get(ball), [last], [new]))
        else:
            events.append(Event(SEEN, "rolling_resting", None, [old], [new]))
    return Rollout(start, tracks, events, truncated=False)


def _body(ball: Ball, table: Table) -> Body:
    return Body(ball, 0, *table.body_of(ball))


# Reading.


def _layout(text: Any, source: str) -> Layout:
    if not isinstance(text, str):
        raise InputError(source, BALLS, text, "allowed is a position")
    return read(text, source).layout if text else Layout()


def _state(data: Mapping[str, Any], match: Match, layout: Layout, source: str) -> State:
    """The state of the game, its values of the types that they have, and nobody and nothing asked that is not there."""
    game = data.get(GAME)
    if not isinstance(game, dict):
        raise InputError(source, GAME, game, "allowed is a state of the game")
    try:
        state: State = match.rules_of(data.get("lag") is True).state(game)
    except InputError as error:
        raise error.at(source) from None
    for part, plain in ((state, type(state)()), (state.ask, type(state.ask)(AIM, 0))):
        for entry in fields(part):
            value = getattr(part, entry.name)
            if not _alike(value, getattr(plain, entry.name)):
                key = f"{GAME}.{WRITTEN.get(entry.name, entry.name)}"
                raise InputError(source, key, str(value), "allowed is a value of another type")
    ask, players = state.ask, match.rules.players
    if ask.kind not in (AIM, PLACE, CHOOSE, OVER) or (ask.kind in (AIM, PLACE) and ask.ball not in layout):
        raise InputError(source, f"{GAME}.ask", ask.ball or ask.kind, "allowed is what a match can ask for")
    if not -1 <= ask.player < players or (ask.player < 0 and ask.kind != OVER) or not 0 <= state.turn < players:
        raise InputError(source, f"{GAME}.ask.who", ask.player, f"allowed is 0 to {players - 1}")
    if len(state.scores) != players or len(state.fouls) != players:
        raise InputError(source, f"{GAME}.scores", state.scores, f"allowed are those of {players} players")
    return state


def _alike(value: Any, plain: Any) -> bool:
    """Whether a value has the type of a plain one; of what a plain tuple shows to be of one type, every part."""
    if isinstance(plain, tuple) and plain and isinstance(value, tuple):
        return all(_alike(part, plain[0]) for part in value)
    return type(value) is type(plain)


def _tally(data: Any, source: str) -> Tally:
    known = {entry.name for entry in fields(Tally)}
    if not isinstance(data, dict) or not set(data) <= known or not all(type(value) is int for value in data.values()):
        raise InputError(source, TALLIES, data, f"allowed are whole numbers for {', '.join(sorted(known))}")
    return Tally(**data)


def _notes(data: Mapping[str, Any], key: str, source: str) -> tuple[Note, ...]:
    """The notes of a line, but for those that a later version says: they may have no words here."""
    notes = [note_of(one, source, key) for one in _list(data, key, source)]
    return tuple(note for note in notes if note.key in ENGLISH)


def _spotted(data: Mapping[str, Any], source: str) -> tuple[tuple[str, tuple[float, float]], ...]:
    spotted = []
    for one in _list(data, "spotted", source):
        try:
            ball, (x, y) = one
            spotted.append((str(ball), (float(x), float(y))))
        except (TypeError, ValueError, OverflowError):
            raise InputError(source, "spotted", one, "allowed are a ball and its place") from None
    return tuple(spotted)


def _numbers(data: Mapping[str, Any], key: str, count: int, source: str) -> tuple[int, ...]:
    values = tuple(_list(data, key, source))
    if len(values) != count or not all(type(value) is int and abs(value) < _SCORES for value in values):
        raise InputError(source, key, list(values), f"allowed are {count} whole numbers")
    return values


def _list(data: Mapping[str, Any], key: str, source: str) -> list[Any]:
    values = data.get(key, [])
    if not isinstance(values, list):
        raise InputError(source, key, values, "allowed is a list")
    return values
