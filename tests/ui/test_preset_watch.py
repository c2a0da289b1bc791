"""A preset that is saved while the window is open."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from pool2d import load_table
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.table.preset import preset_path
from pool2d.ui.app import App


class Own(NamedTuple):
    """A window on a table of one's own, its file, and what was in it at first."""

    app: App
    preset: Path
    good: str


@pytest.fixture
def own(tmp_path: Path) -> Iterator[Own]:
    preset = tmp_path / "mine.toml"
    good = preset_path("pool-9ft").read_text()
    preset.write_text(good)
    app = App(load_table(str(preset)), seed=1)
    app.step(0.0)
    yield Own(app, preset, good)
    app.close()


def test_a_saved_preset_changes_the_table_and_a_broken_one_does_not(own: Own) -> None:
    app, preset, good = own
    preset.write_text(good.replace("mu_roll = 0.01 ", "mu_roll = 0.02 "))
    app.step(1.0)
    assert app.play.state.session.table.knobs.cloth.mu_roll == 0.02
    preset.write_text(good.replace("mu_roll = 0.01 ", "mu_rol = 0.03 "))
    app.step(1.0)
    assert app.play.state.session.table.knobs.cloth.mu_roll == 0.02
    assert "mu_rol" in app.play.state.messages.warning and "mu_roll?" in app.play.state.messages.warning
    line = 1 + next(number for number, text in enumerate(good.splitlines()) if text.startswith("mu_roll"))
    assert f"line {line}:" in app.play.state.messages.warning
    preset.unlink()
    app.step(1.0)
    assert "cannot be read" in app.play.state.messages.warning
    preset.write_text(good)
    app.step(1.0)
    assert app.play.state.messages.warning == ""
    assert app.play.state.session.table.knobs.cloth.mu_roll == 0.01


def test_a_change_of_the_base_is_taken_too(tmp_path: Path) -> None:
    base, mine = tmp_path / "base.toml", tmp_path / "mine.toml"
    base.write_text('base = "pool-9ft"\n[cloth]\nmu_roll = 0.012\n')
    mine.write_text('base = "base.toml"\n[ball]\nrestitution = 0.93\n')
    app = App(load_table(str(mine)), seed=1)
    try:
        app.step(0.0)
        assert app.play.state.session.table.knobs.cloth.mu_roll == 0.012
        base.write_text('base = "pool-9ft"\n[cloth]\nmu_roll = 0.0215\n')
        app.step(1.0)
        assert app.play.state.session.table.knobs.cloth.mu_roll == 0.0215
        assert app.play.state.session.table.knobs.ball.restitution == 0.93
    finally:
        app.close()


def test_a_match_keeps_its_table_and_practice_takes_what_was_saved_meanwhile(own: Own) -> None:
    app, preset, good = own
    app.scene = app.lobby.begin(recorded(app.play.state.session.table, Setup("nine-ball", breaker=0)))
    preset.write_text(good.replace("mu_roll = 0.01 ", "mu_roll = 0.02 "))
    app.step(1.0)
    assert app.play.state.session.table.knobs.cloth.mu_roll == 0.01
    assert app.play.state.messages.warning == ""
    app.lobby.leave()
    app.scene = app.play
    app.step(1.0)
    assert app.play.state.session.table.knobs.cloth.mu_roll == 0.02
