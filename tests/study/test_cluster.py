"""A Dask cluster is one more executor: the example of the documentation and a study, on a cluster here."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pool2d import WorkerError, simulate_many
from pool2d.cli import main

from ..commands.cli_runs import ROOT, Capture, refusal
from .many import LAYOUT, MIXED, TABLE, Here, assert_equal
from .studies import SHOTS, played, written

distributed = pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    # Two threads each: they must not share a table.
    with distributed.LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None) as here:
        yield here


def test_the_example_runs_as_it_stands(capsys: Capture) -> None:
    (block,) = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "studies.md").read_text(), re.DOTALL)
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(block, names)
    assert re.fullmatch(r"\d+% fall\n", capsys.readouterr().out)
    assert_equal(names["many"], simulate_many(names["table"], names["layout"], names["shots"], executor=Here()))


def test_a_cluster_plays_the_same_bits(cluster: Any) -> None:
    expected = simulate_many(TABLE, LAYOUT, MIXED, executor=Here())
    with distributed.Client(cluster) as client:
        assert_equal(simulate_many(TABLE, LAYOUT, MIXED, executor=client.get_executor(), chunk=3), expected)


def test_a_study_on_a_cluster_ends_in_the_same_bytes(cluster: Any, tmp_path: Path, capsys: Capture) -> None:
    file = written(tmp_path)
    out = tmp_path / "cluster.csv"
    words = ["--cluster", cluster.scheduler_address, "--out", str(out), "--size", "320x180"]
    assert main(["study", str(file), *words]) == 0
    assert f"{out}: {SHOTS} shots" in capsys.readouterr().out
    assert played(file) == 0
    assert out.read_bytes() == (tmp_path / "study.csv").read_bytes()


def test_a_cluster_that_ends_is_told() -> None:
    with (
        distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0", processes=False) as cluster,
        distributed.Client(cluster) as client,
        pytest.raises(WorkerError, match=r"the shots after the first \d+ did not come back"),
    ):
        executor = client.get_executor()

        def shots() -> Iterator[Any]:
            yield from MIXED
            client.close()
            yield from MIXED

        simulate_many(TABLE, LAYOUT, shots(), executor=executor, chunk=10)


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nowhere://x", "127.0.0.1", ""])
def test_where_no_scheduler_answers_it_is_told(
    address: str, tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pool2d.commands.study._PATIENCE", "500ms")
    said = refusal(capsys, "study", str(written(tmp_path)), "--cluster", address)
    assert said.startswith(f"pool2d: command line: --cluster = {address!r}: no Dask scheduler answers there")
