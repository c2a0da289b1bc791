"""A complaint about a preset names the line."""

from __future__ import annotations

from pathlib import Path

import pytest

from pool2d import InputError, load_table
from pool2d.config.reader import line_of

TEXT = """\
base = "pool-9ft"
gravity = 9.81

[cloth]
# mu_roll = 1
mu_roll = 0.01

[racks.eight-ball]
spot = "foot"
"""


@pytest.mark.parametrize(
    ("key", "line"),
    [
        ("gravity", 2),
        ("cloth.mu_roll", 6),
        ("racks.eight-ball.spot", 9),
        ("cloth.mu_slide", 0),
        ("ball.mu_roll", 0),
        ("gravity, base", 2),
    ],
)
def test_the_line_of_a_key(tmp_path: Path, key: str, line: int) -> None:
    path = tmp_path / "t.toml"
    path.write_text(TEXT)
    assert line_of(path, key) == line


def test_a_bad_value_is_told_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "t.toml"
    path.write_text(TEXT.replace("mu_roll = 0.01", "mu_roll = 7"))
    with pytest.raises(InputError, match=r"t\.toml, line 6: cloth\.mu_roll = 7: allowed"):
        load_table(path)


def test_an_override_has_no_line(tmp_path: Path) -> None:
    path = tmp_path / "t.toml"
    path.write_text(TEXT)
    with pytest.raises(InputError) as caught:
        load_table(path, {"cloth.mu_roll": 7.0})
    assert caught.value.line == 0
