"""Where the project's data files are: beside the package in a checkout, inside it in a wheel."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]
_ROOT = next((root for root in (_PACKAGE / "assets", _PACKAGE.parent / "assets") if root.is_dir()), _PACKAGE / "assets")


def asset(folder: str, name: str) -> Path:
    """The path of one asset, whether or not it is there."""
    return _ROOT / folder / name


def assets(folder: str, ending: str) -> list[Path]:
    """Every asset in a folder with that ending."""
    return sorted((_ROOT / folder).glob("*" + ending))
