"""What is agreed before a match."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from ..config.knobs import Knob
from ..errors import InputError, suggest
from ..table.table import Table
from .rules import Rules
from .rules.lag import Lag

ALTERNATE, WINNER, LOSER = "alternate", "winner", "loser"
BREAKS = (ALTERNATE, WINNER, LOSER)
# Who breaks first, where it is not a player's number.
COIN, LAG = -1, -2
_RACE = Knob(1, 1, 100, "frames", "")
_SEED = Knob(0, -1e15, 1e15, "", "")
NAME = 40


@dataclass(frozen=True, slots=True)
class Setup:
    """What is agreed before a match.

    `race` is how many frames win it; `breaks` who breaks after the first frame: "alternate", "winner" or
    "loser". `breaker` breaks first; COIN leaves that to a coin, and LAG to a lag. `seed` gives the coin,
    which also says who lags first, and the racks. Without `names` the players are Player 1 and so on. `players` are
    the names of their files for those who are no people, "" for a person; without any, all are people.
    """

    game: str = "practice"
    options: Mapping[str, float | str] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    race: int = 1
    breaks: str = ALTERNATE
    breaker: int = COIN
    seed: int = 0
    players: tuple[str, ...] = ()

    def as_dict(self) -> dict[str, Any]:
        """The setup in JSON's types; `setup_of` reads it. A match of people says nothing of players."""
        data = {**asdict(self), "options": dict(self.options), "names": list(self.names), "players": list(self.players)}
        if not self.players:
            del data["players"]
        return data

    def is_person(self, player: int) -> bool:
        """Whether a person plays on this side; nobody's side, -1, is no person's."""
        return player >= 0 and not (self.players and self.players[player])

    @property
    def watched(self) -> bool:
        """Whether no person plays."""
        return bool(self.players) and all(self.players)


def can_lag(rules: type[Rules[Any]] | Rules[Any], table: Table) -> bool:
    """Whether a lag can decide who breaks."""
    return rules.players == Lag.players and Lag.fits(table)


def setup_of(data: Mapping[str, Any], source: str) -> Setup:
    """The setup that `as_dict` made it of; raises InputError for an unknown key. Match looks at the values."""
    known = {entry.name for entry in fields(Setup)}
    for key, value in data.items():
        if key not in known:
            raise InputError(source, key, value, suggest(key, known))
    for key, kind in (("options", dict), ("names", list), ("players", list), ("game", str), ("breaks", str)):
        if not isinstance(data.get(key, kind()), kind):
            raise InputError(source, key, data[key], f"allowed is a {kind.__name__}")
    for name in data.get("names", ()):
        _check_name(name, source)
    lists = {key: tuple(data.get(key, ())) for key in ("names", "players")}
    for name in lists["players"]:
        _check_player(name, source)
    return Setup(**{**data, **lists})


def checked(setup: Setup, rules: Rules[Any], table: Table) -> Setup:
    """The setup with every player named; raises InputError where a value is out of range."""
    players = rules.players
    for name, knob, value in (("race", _RACE, setup.race), ("seed", _SEED, setup.seed)):
        if type(value) is not int:
            raise InputError("match", name, value, f"allowed is a whole number; {knob.allowed()}")
        knob.check(value, "match", name)
    if setup.breaks not in BREAKS:
        raise InputError("match", "breaks", setup.breaks, suggest(setup.breaks, BREAKS))
    if type(setup.breaker) is not int or not LAG <= setup.breaker < players:
        allowed = f"allowed is 0 to {players - 1}, {COIN} for a coin and {LAG} for a lag"
        raise InputError("match", "breaker", setup.breaker, allowed)
    if setup.breaker == LAG and not can_lag(rules, table):
        raise InputError("match", "breaker", setup.breaker, "a lag needs two players, and a head and a foot cushion")
    names = setup.names or tuple(f"Player {number}" for number in range(1, players + 1))
    if len(names) != players:
        raise InputError("match", "names", names, f"allowed are {players} names")
    for name in names:
        _check_name(name, "match")
    if setup.players and len(setup.players) != players:
        raise InputError("match", "players", setup.players, f"allowed are {players} names, or none")
    for name in setup.players:
        _check_player(name, "match")
    return replace(setup, names=names, players=setup.players if any(setup.players) else ())


def _check_player(name: object, source: str) -> None:
    if name != "":
        _check_name(name, source, "players")


def _check_name(name: object, source: str, key: str = "names") -> None:
    if not isinstance(name, str) or not name.strip() or not name.isprintable() or len(name) > NAME:
        raise InputError(source, key, name, f"allowed is a text of up to {NAME} printable characters")
