"""The clauses of nine-ball, ten-ball, straight pool and one-pocket: see `tables`."""

from __future__ import annotations

from .cases import Case, check, rows


@rows("nine-ball")
def test_nine_ball(case: Case) -> None:
    check("nine-ball", case)


@rows("ten-ball")
def test_ten_ball(case: Case) -> None:
    check("ten-ball", case)


@rows("straight")
def test_straight(case: Case) -> None:
    check("straight", case)


@rows("one-pocket")
def test_one_pocket(case: Case) -> None:
    check("one-pocket", case)
