"""Cases from independent sources, kept in JSON files: ids, inputs, expected values, tolerances, sources."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

Case = dict[str, Any]
Test = Callable[..., None]


class Casebook:
    """The cases of a file, and which of them have a test."""

    def __init__(self, name: str) -> None:
        self.cases: list[Case] = json.loads((Path(__file__).parent / name).read_text(encoding="utf-8"))
        self.used: set[str] = set()
        # Tests go through what is expected: where that is nothing they would pass.
        assert all(case["expected"] for case in self.cases)

    def run(self, prefix: str) -> Callable[[Test], Test]:
        """Run a test on every case whose id starts so."""
        chosen = [case for case in self.cases if case["id"].startswith(prefix)]
        assert chosen
        self.used.update(case["id"] for case in chosen)
        return pytest.mark.parametrize("case", chosen, ids=[case["id"] for case in chosen])


MOTIONS = Casebook("cases.json")
CONTACTS = Casebook("contacts.json")


def near(case: Mapping[str, Any], expected: Any) -> Any:
    """The expected value, to compare with at the case's tolerance."""
    tolerance = case["tolerance"]
    return pytest.approx(expected, rel=tolerance.get("rel", 0.0), abs=tolerance.get("abs", 0.0))
