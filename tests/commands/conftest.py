"""What tests of the commands may use."""

from __future__ import annotations

from pathlib import Path

import pytest

from .cli_runs import PLAY


@pytest.fixture
def play(tmp_path: Path) -> str:
    """The path of a scenario with a shot."""
    path = tmp_path / "play.toml"
    path.write_text(PLAY)
    return str(path)
