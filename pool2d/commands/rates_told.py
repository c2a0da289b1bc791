"""What was measured of a player, as people and as programs read it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from ..opponent.contests.ten_racks import grade
from ..opponent.player import Rates


def told_rates(rates: Rates) -> tuple[str, ...]:
    """Rates as people read them, in the order of the columns."""
    return (
        f"{rates.balls:g}", grade(rates.balls), f"{rates.pots:g} %", f"{rates.run:g}", f"{rates.break_and_runs:g} %",
        f"{rates.three_cushion:g}", f"{rates.snooker_break:g}",
    )  # fmt: skip


def rates_dict(rates: Rates) -> dict[str, Any] | None:
    """Rates in JSON's types with the grade; None where nothing was measured."""
    return {**asdict(rates), "grade": grade(rates.balls)} if rates.when else None
