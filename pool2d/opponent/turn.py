"""A turn as its player sees it: what is asked, what may be hit, and where the cue ball may be."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final

from ..game.rules import Ask, Choice, Rules, Ruling, State
from ..game.rules.spotting import put
from ..physics.values import Layout
from ..table.table import Table
from .candidates.places import places
from .player import Player
from .pot_lines import PotLine, pot_lines
from .worth import Scale, usual_rate

# From how many places at most a break is looked at: it takes long.
_BREAKS: Final = 4


@dataclass(frozen=True)
class Turn:
    """The rules, where the game stands by them, and the player who is asked."""

    rules: Rules[Any]
    ruling: Ruling
    player: Player

    @cached_property
    def scale(self) -> Scale:
        """How what comes of it is valued."""
        return Scale(self.rules, self.player.hand, usual_rate(self.player.hand))

    @property
    def table(self) -> Table:
        """The table that is played on."""
        return self.rules.table

    @property
    def state(self) -> State:
        """Where the game stands."""
        return self.ruling.state

    @property
    def layout(self) -> Layout:
        """Where the balls are."""
        return self.ruling.layout

    @property
    def ask(self) -> Ask:
        """What is asked."""
        return self.ruling.ask

    @property
    def me(self) -> int:
        """Which of the match's players it is."""
        return self.ask.player

    @property
    def opens(self) -> bool:
        """Whether the rack has yet to be broken."""
        return not self.state.shots

    @property
    def cues(self) -> tuple[str, ...]:
        """The balls that may be struck."""
        return self.ask.cues or (self.ask.ball,)

    def on(self, cue: str) -> list[str]:
        """The balls that may be hit first."""
        return [ball for ball in self.ask.on or self.rules.on_table(self.layout) if ball != cue]

    def wanted(self, layout: Layout) -> list[str]:
        """The balls that are to fall: those that may be hit first, and all that are to be potted to win."""
        more = () if self.rules.scored else self.rules.to_pot(self.state, layout, self.me)
        return [ball for ball in self.rules.on_table(layout) if not self.ask.on or ball in (*self.ask.on, *more)]

    @cached_property
    def goals(self) -> tuple[str, ...]:
        """The pockets that count."""
        return self.rules.goals(self.state, self.me)

    def lines(self, layout: Layout, cue: str) -> Iterator[PotLine]:
        """The pots that lie open to a cue ball, the likeliest first."""
        found = pot_lines(self.table, layout, layout[cue], self.on(cue), self.player.hand)
        return (line for line in found if line.pocket in self.goals)

    def chosen(self, choice: Choice) -> Ruling:
        """What follows from a choice."""
        return self.rules.choose(self.state, self.layout, choice)

    def placed(self, place: Choice | None) -> Ruling:
        """Where the game stands when a cue ball that is in hand was put there."""
        return self.ruling if place is None else self.chosen(place)

    def worth_of(self, ruling: Ruling) -> float:
        """What a ruling is worth to the player."""
        return self.scale.value(ruling, self.me)

    @cached_property
    def lost(self) -> float:
        """What the turn is worth where nothing comes of it: the other player is at the table as things stand."""
        return self.scale.passed(self.ruling, self.me)

    def stands(self, cue: str) -> Iterator[tuple[Choice | None, Layout]]:
        """Where the cue ball may stand: where it is; or, in hand, the few places that suit best."""
        if not self.ask.where:
            yield None, self.layout
            return
        places = sorted(self._places(cue), key=lambda place: -self._open(place, cue))
        count = int(self.player.judgement.places)
        for x, y in places[: min(_BREAKS, count) if self.opens else count]:
            yield Choice("place", x, y), put(self.layout, cue, (x, y))

    def _places(self, cue: str) -> list[tuple[float, float]]:
        return list(places(self.table, self.layout, self.ask, self.on(cue), self.player.hand))

    def _open(self, place: tuple[float, float], cue: str) -> float:
        """How likely the likeliest pot from a place is, in tenths: of places that are as good the first differ most."""
        return round(next((line.chance for line in self.lines(put(self.layout, cue, place), cue)), 0.0), 1)
