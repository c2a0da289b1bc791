"""Without dask.distributed a cluster is refused in a line."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from ..commands.cli_runs import Capture, refusal
from .studies import written


def test_without_distributed_it_is_told(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    said = refusal(capsys, "study", str(written(tmp_path)), "--cluster", "tcp://127.0.0.1:8786")
    assert said == (
        "pool2d: command line: --cluster = 'tcp://127.0.0.1:8786': "
        "a cluster needs dask.distributed, of the extra cluster"
    )
