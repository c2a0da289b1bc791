"""What tests of games and records may use."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from pool2d import Layout, Rollout, Shot, Table, simulate
from pool2d.game import judging
from pool2d.game.records import engine


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The data of whoever runs the tests is left alone."""
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """Where a record is kept."""
    return tmp_path / "a.jsonl"


@pytest.fixture
def other(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Have another engine, other rules or another machine play from now on, as far as they tell."""

    def become(**parts: str) -> None:
        now = engine.identity()._replace(**parts)
        monkeypatch.setattr(engine, "identity", lambda: now)

    return become


@pytest.fixture
def faster(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Have every shot roll a little further from now on."""

    def become() -> None:
        def roll(table: Table, layout: Layout, shot: Shot) -> Rollout:
            return simulate(table.with_knobs({"cloth.mu_roll": 0.97 * table.knobs.cloth.mu_roll}), layout, shot)

        monkeypatch.setattr(judging, "simulate", roll)

    return become
