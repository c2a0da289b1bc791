"""What a position is worth to a player: a chance to win, from how the game stands and what lies open.

A rack is run ball by ball. Where `p` is a player's chance to go on from one ball to the next, and `n` and `m` are the
balls that the players have yet to pot, the chance W(n, m) of whoever is at the table follows from itself:

    W(n, m) = p W(n - 1, m) + (1 - p) (1 - W(m, n)),    W(0, m) = 1

and with a first shot that comes off with chance q in place of p, V(q) = q W(n - 1, m) + (1 - q) (1 - W(m, n)). Where
both have to pot the same n balls, W(n) = p W(n - 1) + (1 - p) (1 - W(n)). A ball that has no way to any pocket counts
as more than one. Games that are scored are worth the points ahead instead, and those that a run from here brings.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import combinations, islice
from typing import Any, Final, NamedTuple

import numpy as np

from ..game.rules import CHOOSE, Choice, Rules, Ruling, State
from ..physics.values import GONE, Layout
from .pot_chance import strays, within
from .pot_lines import PotLine, pot_lines, shut
from .stray import Hand

# The least chance that whoever is at the table pots something: a fluke, a bank, a kick.
FLUKE: Final = 0.04
# What each further ball that lies open adds where the ones before should fail, as a share.
_FURTHER: Final = 0.12
# How many of the lines that lie open count at all.
_COUNT: Final = 3
# What a cue ball that is put behind a line has of the chances of one that is put anywhere.
_BEHIND: Final = 0.8
# How often who breaks goes on, where a break is to pot.
_BREAKS: Final = 0.55
# How often who has no pot gets away with a safety or an escape.
_ESCAPES: Final = 0.5
# By how much more a ball counts that has no way to any pocket: it has to be broken out first.
_STUCK: Final = 0.7
# So many cannons are counted on to follow one another, where there are no pockets.
_CANNONS: Final = 3
# What the end of a scored game counts, and the most that a run is held to bring, in points.
_END: Final = 30.0
_LONGEST: Final = 40.0


@lru_cache(maxsize=4096)
def chance_to_win(p: float, n: int, m: int) -> float:
    """W(n, m): the chance to win of who is at the table, with `n` balls to pot, the opponent having `m`."""
    if n <= 0 or m <= 0:
        return float(n <= 0)
    ours, theirs, miss = p * chance_to_win(p, n - 1, m), p * chance_to_win(p, m - 1, n), 1.0 - p
    # W(n, m) = ours + miss (1 - W(m, n)), and the same the other way round.
    return (ours + miss * (1.0 - theirs) - miss * miss) / (1.0 - miss * miss)


@lru_cache(maxsize=4096)
def chance_in_common(p: float, n: int) -> float:
    """W(n): the chance to win of who is at the table where both have to pot the same `n` balls."""
    return 1.0 if n <= 0 else (p * chance_in_common(p, n - 1) + 1.0 - p) / (2.0 - p)


class Race(NamedTuple):
    """How many balls who is at the table and who is not have yet to pot; `common` where they are the same ones."""

    mine: float
    theirs: float
    common: bool

    def potted(self) -> Race:
        """After the next ball."""
        return self._replace(mine=self.mine - 1.0, theirs=self.theirs - self.common)

    def other(self) -> Race:
        """As the other player has it."""
        return Race(self.theirs, self.mine, self.common)

    def win(self, p: float) -> float:
        """The chance to win of who is at the table, and goes on with a chance `p`."""
        if self.common:
            return _between(partial(chance_in_common, p), self.mine)
        return _between(lambda n: _between(partial(chance_to_win, p, n), self.theirs), self.mine)


@dataclass(frozen=True, slots=True)
class Scale:
    """How positions are valued: by which rules, for what hand, and with the chance `rate` of going on that it has."""

    rules: Rules[Any]
    hand: Hand
    rate: float

    def value(self, ruling: Ruling, player: int, looks: int = 1) -> float:
        """What a ruling is worth to a player: a chance to win, or points ahead where the game is scored."""
        if ruling.state.over:
            return self._over(ruling, player)
        if ruling.ask.kind == CHOOSE:
            return self._of_choice(ruling, player, looks)
        return self._at_table(ruling, player, self.opening(ruling))

    def passed(self, ruling: Ruling, player: int) -> float:
        """What it is worth to a player that the other comes to the table, with a common chance."""
        if self.rules.scored:
            return self.ahead(ruling.state, player) - self._answered * self._run(ruling, self.rate)
        return 1.0 - self._race(ruling, self.rules.other(player)).win(self.rate)

    def opening(self, ruling: Ruling) -> float:
        """The chance that who is at the table goes on from here."""
        if not ruling.state.shots and not self.rules.scored:
            return _BREAKS
        if not self.rules.table.geometry.pockets:
            return gathered(ruling.layout, self.rules.table.knobs.table.length, self.rate)
        share = 1.0 if ruling.ask.where in ("", "anywhere") else _BEHIND
        return max(FLUKE, either(share * line.chance for line in islice(self._lines(ruling), _COUNT)))

    def ahead(self, state: State, player: int) -> float:
        """How many points a player is ahead."""
        return 2.0 * state.scores[player] - sum(state.scores)

    @property
    def _answered(self) -> bool:
        """Whether there is somebody who comes to the table after a miss."""
        return self.rules.players > 1

    def _lines(self, ruling: Ruling) -> Iterator[PotLine]:
        table, layout, ask = self.rules.table, ruling.layout, ruling.ask
        cue = layout[ask.ball or table.furniture.cue]
        in_hand = bool(ask.where) or cue.phase in GONE
        return pot_lines(table, layout, cue, ask.on or self.rules.on_table(layout), self.hand, anywhere=in_hand)

    def _at_table(self, ruling: Ruling, player: int, chance: float) -> float:
        """What it is worth to a player that whoever is asked goes on with a chance."""
        mover = ruling.ask.player
        if self.rules.scored:
            run = self._run(ruling, chance)
            return self.ahead(ruling.state, player) + (run if mover == player else -run)
        race = self._race(ruling, mover)
        win = max(self._attack(chance, race), self._defence(race))
        return win if mover == player else 1.0 - win

    def _attack(self, chance: float, race: Race) -> float:
        """V(q): the chance to win of who goes for a pot that comes off with a chance."""
        return chance * race.potted().win(self.rate) + (1.0 - chance) * (1.0 - race.other().win(self.rate))

    def _defence(self, race: Race) -> float:
        """The chance to win of who plays safe, or gets out of a snooker: as often as not that fails.

        Where it does not, either player may be the next to have a chance.
        """
        failed = 1.0 - race.other().win(self.rate)
        return _ESCAPES * 0.5 * (race.win(self.rate) + failed) + (1.0 - _ESCAPES) * failed

    def _race(self, ruling: Ruling, mover: int) -> Race:
        """How the balls stand where a player is at the table."""
        left = [
            set(self.rules.to_pot(ruling.state, ruling.layout, player)) for player in (mover, self.rules.other(mover))
        ]
        stuck = shut(self.rules.table, ruling.layout, left[0] | left[1])
        mine, theirs = (len(balls) + _STUCK * min(len(balls & stuck), max(0, len(balls) - 1)) for balls in left)
        return Race(mine, theirs, left[0] == left[1])

    def _of_choice(self, ruling: Ruling, player: int, looks: int) -> float:
        """Whoever chooses takes what is best for them; what that leads to is looked at so many choices deep."""
        values = [self._after(ruling, key, player, looks) for key in ruling.ask.options]
        return max(values) if ruling.ask.player == player else min(values)

    def _after(self, ruling: Ruling, key: str, player: int, looks: int) -> float:
        if not looks:
            return self.passed(ruling, player)
        return self.value(self.rules.choose(ruling.state, ruling.layout, Choice(key)), player, looks - 1)

    def _over(self, ruling: Ruling, player: int) -> float:
        """1 for a win and 0 for a loss; in points the margin, and what the win itself counts."""
        winner = ruling.state.winner
        won = 0.5 if winner is None else float(winner == player)
        return self.ahead(ruling.state, player) + _END * (2.0 * won - 1.0) if self.rules.scored else won

    def _loose(self, ruling: Ruling) -> int:
        """How many balls have a way to a pocket; on a table without pockets, how many cannons to come."""
        balls = self.rules.on_table(ruling.layout)
        pockets = self.rules.table.geometry.pockets
        return len(balls) - len(shut(self.rules.table, ruling.layout, balls)) if pockets else _CANNONS

    def _run(self, ruling: Ruling, chance: float) -> float:
        """The points that a run is to bring whose first shot comes off with a chance, less what the answer brings."""
        ball = max((self.rules.worth(ball) for ball in ruling.ask.on), default=1.0)
        more = self.rate * (1.0 - self.rate ** self._loose(ruling)) / (1.0 - self.rate)
        answer = 0.5 * self._answered * min(_LONGEST, ball * more)
        attack = min(_LONGEST, ball * chance * (1.0 + more)) - (1.0 - chance) * answer
        return max(attack, -(1.0 - _ESCAPES) * answer)


def _between(f: Callable[[int], float], x: float) -> float:
    """A function of whole numbers, straight between them."""
    whole = int(x)
    part = x - whole
    return f(whole) + part * (f(whole + 1) - f(whole)) if part else f(whole)


def either(chances: Iterable[float]) -> float:
    """The chance that one of several comes off: the first counts whole, each further one a share."""
    missed = 1.0
    for place, chance in enumerate(chances):
        missed *= 1.0 - (_FURTHER if place else 1.0) * chance
    return 1.0 - missed


def gathered(layout: Layout, length: float, rate: float) -> float:
    """On a table without pockets: the chance of a cannon, which is better where the balls lie near each other."""
    pairs = list(combinations(layout.on_table(), 2))
    mean = sum(math.dist((a.x, a.y), (b.x, b.y)) for a, b in pairs) / (len(pairs) * length)
    return min(0.98, rate * (1.25 - 0.5 * mean))


def usual_rate(hand: Hand) -> float:
    """The chance that a hand goes on from one ball to the next: that of a pot of common length and cut.

    0.35 m to the ball, 0.7 m to the pocket, cut by 25 degrees, a window of 2.2 degrees either way; and even who never
    misses does not always come where he meant to.
    """
    spread = strays(hand, 0.028575, np.array(0.35), np.array(math.radians(25.0)))
    return 0.97 * within(math.radians(2.2), float(spread))
