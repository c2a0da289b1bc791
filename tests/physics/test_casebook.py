"""No case is forgotten."""

from __future__ import annotations

import pytest

from ..casebook import CONTACTS, MOTIONS, Casebook
from . import test_cases, test_cluster_cases
from .laws import test_ball_cases, test_cushion_cases, test_throw_cases

READERS = (test_ball_cases, test_cases, test_cluster_cases, test_cushion_cases, test_throw_cases)


@pytest.mark.parametrize("book", [MOTIONS, CONTACTS], ids=["motions", "contacts"])
def test_every_case_has_a_test(book: Casebook) -> None:
    assert READERS
    assert {case["id"] for case in book.cases} == book.used
