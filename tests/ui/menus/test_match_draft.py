"""A match that is being agreed on, without a window."""

from __future__ import annotations

import pytest

from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.game.match import Match
from pool2d.game.setup import COIN, LAG
from pool2d.ui.menus.match_draft import TUNED, MatchDraft


def draft(table: str = "pool-9ft", **kept: float | str) -> MatchDraft:
    store = Store()
    for name, value in kept.items():
        store.turn(f"match.{name}", value)
    return MatchDraft(store, load_table(table))


@pytest.mark.parametrize("table", ["pool-9ft", "snooker-12ft", "carom-10ft", "pyramid-12ft", "english-7ft"])
def test_it_begins_with_a_game_for_the_table_that_is_practised_on(table: str) -> None:
    made = draft(table)
    assert made.preset == table and made.fits(table)
    assert made.table is not None
    assert Match(made.table, made.setup(("Ann", "Bo"))).names == ("Ann", "Bo")


def test_a_table_that_the_game_is_none_for_brings_another_game_and_a_game_another_table() -> None:
    made = draft()
    made.take_table("carom-10ft")
    assert made.game == "three-cushion"
    made.options = {"points": 10.0}
    made.take_game("snooker")
    assert made.preset == "snooker-12ft" and made.options == {}


def test_who_lags_needs_a_head_cushion() -> None:
    made = draft()
    made.breaker = LAG
    made.take_table("snooker-12ft")
    assert made.breaker == LAG
    made.take_table("l-shape")
    assert LAG not in made.breakers and made.breaker == COIN


@pytest.mark.parametrize(("kept", "race"), [(98.0, 1), (7.0, 7), (2.5, 1)])
def test_a_race_that_is_not_offered_is_one_frame(kept: float, race: int) -> None:
    assert draft(race=kept).race == race


def test_what_is_agreed_is_kept_for_the_next() -> None:
    store, table = Store(), load_table("pool-9ft", {"cloth.mu_roll": 0.02})
    made = MatchDraft(store, table)
    assert made.tables[-1] == TUNED
    made.take_table(TUNED)
    made.take_game("nine-ball")
    made.options, made.race, made.breaker, made.breaks = {"push_out": "no"}, 5, 1, "loser"
    assert made.table is table and made.preset == TUNED
    made.keep(store)
    again = MatchDraft(store, load_table("snooker-12ft"))
    assert (again.game, again.options, again.race, again.breaker, again.breaks, again.preset) == (
        "nine-ball", {"push_out": "no"}, 5, 1, "loser", "pool-9ft",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("kept", "options"),
    [
        ("target=75.0", {"target": 75.0}),
        ("target=75", {"target": 75.0}),
        ("target=0.5", {"target": 1.0}),
        ("target=9999.0", {"target": 1000.0}),
        ("target=1.2.3", {}),
        ("target=yes", {}),
        ("target", {}),
        ("points=75.0", {}),
    ],
)
def test_a_number_that_was_kept_counts_within_its_range(kept: str, options: dict[str, float | str]) -> None:
    assert draft(game=f"straight {kept}").options == options


def test_a_table_that_cannot_be_read_is_told() -> None:
    made = draft(game="nine-ball")
    assert made.table is None or made.error == ""
    made.preset = "gone"
    assert made.table is None and "gone" in made.error
    made.preset = "pool-9ft"
    assert made.error == ""
