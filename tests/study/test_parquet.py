"""Results as Parquet, where pyarrow is there to write it; told where it is not."""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import pytest

from ..commands.cli_runs import Capture
from .studies import SHOTS, played, written


def test_parquet_holds_what_csv_does(tmp_path: Path, capsys: Capture) -> None:
    pytest.importorskip("pyarrow")
    import pyarrow.parquet

    file = written(tmp_path)
    out = tmp_path / "out.parquet"
    assert played(file) == 0
    assert played(file, "--out", str(out)) == 0
    assert capsys.readouterr().out.splitlines()[-1].startswith(f"{out}: {SHOTS} shots, ")
    table = pyarrow.parquet.read_table(out)
    with open(tmp_path / "study.csv", newline="") as opened:
        for there, row in zip(table.to_pylist(), csv.DictReader(opened), strict=True):
            assert list(there) == list(row)
            for name, value in there.items():
                if isinstance(value, (bool, int)):
                    assert row[name] == str(int(value)), name
                else:
                    assert row[name] == ("" if value is None else value if isinstance(value, str) else repr(value)), (
                        name
                    )
    kinds = {name: str(kind) for name, kind in zip(table.schema.names, table.schema.types, strict=True)}
    assert (kinds["shot"], kinds["scratch"], kinds["1.pocket"], kinds["1.x"]) == ("int64", "bool", "string", "double")
    assert {path.name for path in tmp_path.iterdir()} == {
        "study.toml", "study.csv", "study-map.png", "study-rests.png", "out.parquet", "out-map.png", "out-rests.png",
    }  # fmt: skip
    # It is known again, and another study is not written over it.
    assert played(file, "--out", str(out)) == 0
    assert capsys.readouterr().out == f"{out}: is whole already\n"
    content = out.read_bytes()
    assert played(file, "--out", str(out), "--set", "cloth.mu_roll=0.02") == 2
    assert "holds something else than this study; allowed is a new file" in capsys.readouterr().err
    assert out.read_bytes() == content
    out.write_text("no Parquet")
    assert played(file, "--out", str(out)) == 2
    assert f"{out}: cannot be read as Parquet" in capsys.readouterr().err


def test_without_pyarrow_it_is_told_before_anything_is_played(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    assert played(written(tmp_path), "--out", str(tmp_path / "out.parquet")) == 2
    assert capsys.readouterr().err == (
        f"pool2d: {tmp_path / 'out.parquet'}: Parquet needs pyarrow, of the extra parquet; "
        "without it allowed is a name that ends in .csv\n"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["study.toml"]
