"""The clauses of every game that is played on a pool table as it stands: a file in `tables` is found by its name."""

from __future__ import annotations

import pytest

from pool2d.game.rules import GAMES

from .cases import POOL, TABLES, Case, check, table

GAMES_HERE = sorted(path.stem for path in TABLES.glob("*.txt") if GAMES[path.stem].fits(POOL))


@pytest.mark.parametrize(
    ("game", "case"),
    [pytest.param(game, case, id=f"{game} {case.clause} {case.what}") for game in GAMES_HERE for case in table(game)],
)
def test_clause(game: str, case: Case) -> None:
    check(game, case)


def test_every_game_has_its_clauses() -> None:
    assert {path.stem for path in TABLES.glob("*.txt")} == set(GAMES) - {"practice"}
