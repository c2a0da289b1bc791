"""A wheel holds everything: every package, and every asset."""

from __future__ import annotations

import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
SETUPTOOLS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]


def test_every_package_is_listed() -> None:
    found = {".".join(path.parent.relative_to(ROOT).parts) for path in (ROOT / "pool2d").rglob("__init__.py")}
    assert found <= set(SETUPTOOLS["packages"])


def test_every_asset_is_listed() -> None:
    data = SETUPTOOLS["package-data"]
    assets = [path for path in (ROOT / "assets").rglob("*") if path.is_file()]
    assert assets
    for path in assets:
        package = ".".join(("pool2d", *path.parent.relative_to(ROOT).parts))
        assert package in SETUPTOOLS["packages"]
        assert any(path.match(pattern) for pattern in data[package]), path


def test_type_checkers_may_read_the_types() -> None:
    assert (ROOT / "pool2d" / "py.typed").is_file()
    assert "py.typed" in SETUPTOOLS["package-data"]["pool2d"]
