"""What the rules of every game have: options, what a match asks of them, and what they build rulings from.

A game goes round: a `Ruling` says in `state.ask` what is to happen next; the player shoots or chooses;
`judge` or `choose` answers with the next ruling. Nothing here changes: each ruling holds a new state
and a new layout.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Generic, TypeVar, Unpack

from ...config.knobs import apply, walk
from ...errors import InputError
from ...physics.values import GONE, Layout
from ...table.furniture import Rack
from ...table.furniture_file import read_rack
from ...table.table import Table
from .notes import Note
from .report import Report
from .ruling import AIM, CHOOSE, OVER, PLACE, Ask, Asked, Choice, Ruling, State, read_value
from .spotting import AREAS, Spotted, Where, may_place, put, within

# What an option may be that is on or off.
YES_NO = ("yes", "no")


@dataclass(frozen=True, slots=True)
class Options:
    """What may be set about a game, described by knobs; a game without options has none."""

    @classmethod
    def home(cls, option: str) -> str:
        """Whose texts say what an option does: the name, with dashes, of the file that says so first in English."""
        docs = {kind: knob.doc for kind in cls.__mro__[:-1] for name, knob, _ in walk(kind()) if name == option}
        first = next(kind for kind in reversed(docs) if docs[kind] == docs[cls])
        return first.__module__.rpartition(".")[2].replace("_", "-")


S = TypeVar("S", bound=State)


class Rules(Generic[S]):
    """The rules of one game on one table, with options.

    A game fills in the class attributes and `start`, `judge` and `picked`. `name` is its file's, with dashes; a low
    `rank` puts it early in lists of games. `racks` are the racks it can be played from, the first that the table has
    being taken; `rack` is one of its own, described as in a preset, for tables that have none of them; `groups` are the
    groups of balls that it needs; `scored` tells whether points are counted, and `series` what those of one turn at the
    table are called: a run, or a break.
    `lags`: it is no game, but the lag before one. `lags_again`: a stalemate is lagged for. `cue_counts`: a ball that
    was struck and falls is a pot, and stays down.
    It has more attributes than most classes, as what tells one game from another stands in its class.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    rank: ClassVar[int] = 100
    players: ClassVar[int] = 2
    racks: ClassVar[tuple[str, ...]] = ()
    rack: ClassVar[Mapping[str, Any]] = {}
    groups: ClassVar[tuple[str, ...]] = ()
    scored: ClassVar[bool] = False
    series: ClassVar[str] = "run"
    lags: ClassVar[bool] = False
    lags_again: ClassVar[bool] = False
    cue_counts: ClassVar[bool] = False
    options_type: ClassVar[type[Options]] = Options
    state_type: ClassVar[type[State]] = State

    def __init__(self, table: Table, options: Mapping[str, object] | None = None) -> None:
        """Raises InputError for an unknown option or value, and for a table that lacks the racks or balls."""
        self.table = table
        self.options: Any = apply(self.options_type(), options or {}, f"options of {self.name}")
        if not self.fits(table):
            raise InputError(table.source, "game", self.name, "this table has not the balls or the rack for it")

    @classmethod
    def fits(cls, table: Table) -> bool:
        """Whether a table has the rack, the balls and, where they are needed, the pockets for this game."""
        furniture = table.furniture
        racked = any(rack in furniture.racks for rack in cls.racks) or cls._own_rack(table) is not None
        anyhow = not cls.racks and not cls.rack
        return (racked or anyhow) and all(group in furniture.groups for group in cls.groups)

    @classmethod
    def _own_rack(cls, table: Table) -> Rack | None:
        """The rack that the game brings; None where it brings none, or the table lacks its balls or its spot."""
        with suppress(InputError):
            return read_rack(cls.rack, table.furniture, cls.name) if cls.rack else None
        return None

    # What a match asks.

    def start(self, breaker: int = 0, seed: int = 0) -> Ruling:
        """The first ruling of a game: the balls racked, and who does what."""
        raise NotImplementedError

    def judge(self, state: S, layout: Layout, report: Report) -> Ruling:
        """What follows from a shot; `layout` is as it was when the balls had come to rest."""
        raise NotImplementedError

    def choose(self, state: S, layout: Layout, choice: Choice) -> Ruling:
        """What follows from a choice; raises InputError for one that the state does not ask for."""
        ask = state.ask
        if choice.key == "place" and ask.where and ask.kind in (AIM, PLACE):
            return self._placed(state, layout, choice)
        if choice.key not in ask.options:
            allowed = ", ".join((*ask.options, *(("place",) if ask.where else ()))) or "nothing"
            raise InputError(self.name, "choice", choice.key, f"allowed is {allowed}")
        return self.picked(state, layout, choice.key)

    def picked(self, state: S, layout: Layout, key: str) -> Ruling:
        """What follows from one of the options that the state offers."""
        raise NotImplementedError

    def stalemate(self, state: S) -> Ruling:
        """What follows when the players see no progress: who began begins again."""
        return self.start(state.breaker, state.seed + 1)

    def conceded(self, state: S, layout: Layout, player: int) -> Ruling:
        """What follows when a player gives the game up."""
        return self.ruled(self.ended(state, self.other(player)), layout, Note("concedes", player))

    def pots(self, player: int, report: Report, ruling: Ruling) -> tuple[str, ...]:
        """The balls of a stroke that count as potted by its player.

        They stay down, and the stroke was no foul, and the player goes on or has won.
        """
        if ruling.foul or ruling.ask.player != player:
            return ()
        spotted, fell = dict(ruling.spotted), report.fallen if self.cue_counts else report.potted
        return tuple(ball for ball in fell if ball not in spotted)

    # What who plans asks: hints, where a game has any to give.

    def to_pot(self, state: S, layout: Layout, player: int) -> tuple[str, ...]:
        """The balls that a player has yet to pot to win, where the game is not scored."""
        return self.on_table(layout)

    def worth(self, ball: str) -> float:
        """What a ball that is potted scores, where the game is."""
        return 1.0

    def goals(self, state: S, player: int) -> tuple[str, ...]:
        """The pockets in which a ball counts for a player."""
        return tuple(pocket.name for pocket in self.table.geometry.pockets)

    def state(self, data: Mapping[str, Any]) -> S:
        """A state from what `as_dict` made of it; raises InputError."""
        state: S = read_value(self.state_type, data, f"state of {self.name}")
        return state

    # What games build rulings from.

    def cue_of(self, player: int) -> str:
        """The ball that a player strikes."""
        return self.table.furniture.cue

    def other(self, player: int) -> int:
        """The opponent."""
        return (player + 1) % self.players

    def spoken(self, ball: str) -> str:
        """The name by which rulings speak of a ball."""
        return ball

    def racked(self, state: S) -> tuple[S, Layout]:
        """The balls of a new rack, the cue ball a little behind the head string, and the state that knows of it."""
        name = next((rack for rack in self.racks if rack in self.table.furniture.racks), "")
        own = None if name else self._own_rack(self.table)
        name = name or (self.name if own else next(iter(self.table.furniture.racks)))
        layout = self.table.rack(name, state.seed + 1000 * state.racks, own)
        line, cue = self.table.furniture.head_string, layout[self.table.furniture.cue]
        if line is not None and cue.x >= line:
            layout = put(layout, cue.id, (line - 2.0 * self.table.body_of(cue)[0], cue.y))
        return replace(state, racks=state.racks + 1, shots=0), layout

    def on_table(self, layout: Layout) -> tuple[str, ...]:
        """The object balls on the table."""
        return tuple(ball.id for ball in layout.on_table() if ball.id != self.table.furniture.cue)

    def to_play(self, state: S, layout: Layout, player: int, where: Where = "", **more: Unpack[Asked]) -> S:
        """The state in which a player is to shoot, with the cue ball in hand where an area is named.

        It has to be placed first where it is off the table or outside the area.
        """
        cue = layout[self.cue_of(player)]
        lies = cue.phase not in GONE and within(self.table, where, cue.x, cue.y)
        return replace(state, turn=player, ask=Ask(AIM if lies or not where else PLACE, player, cue.id, where, **more))

    def to_choose(self, state: S, player: int, *options: str) -> S:
        """The state in which a player has to choose."""
        return replace(state, ask=Ask(CHOOSE, player, options=options))

    def ended(self, state: S, winner: int) -> S:
        """The state in which the game is over; -1 where nobody has won."""
        return replace(state, ask=Ask(OVER, winner))

    def ruled(
        self,
        state: S,
        layout: Layout,
        *notes: Note,
        fouls: tuple[Note, ...] = (),
        spotted: Spotted = (),
        points: tuple[int, ...] = (),
    ) -> Ruling:
        """A ruling whose notes tell of the fouls, what else happened and what is next."""
        every = (
            *fouls,
            *notes,
            *(Note("spotted", ball=self.spoken(ball)) for ball, _ in spotted),
            self.next_note(state),
        )
        return Ruling(state, layout, every, fouls, spotted, points or (0,) * len(state.scores))

    def next_note(self, state: S) -> Note:
        """What is next, in words."""
        ask = state.ask
        if ask.kind == OVER:
            return Note("wins", ask.player) if ask.player >= 0 else Note("draw")
        if ask.kind == CHOOSE:
            return Note("chooses", ask.player)
        if not state.shots:
            return Note("break", ask.player)
        return Note(f"in-hand.{ask.where}" if ask.where else "turn", ask.player)

    def _placed(self, state: S, layout: Layout, choice: Choice) -> Ruling:
        ask = state.ask
        if not may_place(self.table, layout, ask.ball, ask.where, choice.x, choice.y):
            allowed = f"allowed is {AREAS[ask.where]}, clear of other balls"
            raise InputError(self.name, "place", (choice.x, choice.y), allowed)
        layout = put(layout, ask.ball, (choice.x, choice.y))
        return Ruling(replace(state, ask=replace(ask, kind=AIM)), layout, points=(0,) * len(state.scores))
