"""Files of measurements."""

from __future__ import annotations

from pathlib import Path

import pytest

from pool2d import InputError
from pool2d.fit.measured_file import read_measured
from pool2d.fit.readings import Reading


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(text)
    return path


def test_a_file_names_its_table_and_what_was_read_off(tmp_path: Path) -> None:
    text = 'table = "pool-8ft"\n[lag]\nseconds = [8.4, 8.4]\n[spin]\nturns = "14 +-0.5"\nseconds = 4\n'
    measured = read_measured(written(tmp_path, text))
    assert measured.table == "pool-8ft"
    assert measured.readings == {
        "lag.seconds": Reading(8.4, 0.1), "spin.turns": Reading(14.0, 0.5), "spin.seconds": Reading(4.0, 0.1),
    }  # fmt: skip


def test_a_file_may_be_empty_and_name_no_table(tmp_path: Path) -> None:
    measured = read_measured(written(tmp_path, ""))
    assert (measured.table, measured.readings) == (None, {})


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("\n[lag]\nseconds = 0.1\n", "mine.toml, line 3: lag.seconds = 0.1: allowed is a number from 0.5 to 120 s"),
        ("[lag]\nsecond = 8\n", "mine.toml, line 2: lag.second = 8: unknown; did you mean seconds?"),
        ("[lags]\nseconds = 8\n", "mine.toml: lags = {'seconds': 8}: unknown; did you mean lag?"),
        ("lag = 8\n", "mine.toml, line 1: lag = 8: allowed is a section [lag]"),
        ("table = 8\n", "mine.toml, line 1: table = 8: allowed is a preset's name or a path"),
        ('[rebound]\nkept = "half"\n', "mine.toml, line 2: rebound.kept = 'half': allowed are numbers such as"),
        ("[lag\n", "mine.toml: not a TOML file"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(tmp_path: Path, text: str, told: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(InputError) as caught:
        read_measured(path)
    assert str(caught.value).replace(str(path), path.name).startswith(told)


def test_the_name_ends_in_toml(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"ends in \.toml"):
        read_measured(tmp_path / "mine.csv")
