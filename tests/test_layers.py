"""Imports point down: knobs and errors, physics, the table, the game, the window, the command line."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
# The layer of a module, or of all modules of a package.
LAYERS = {
    "pool2d._version": 0, "pool2d.printable": 0, "pool2d.errors": 0, "pool2d.knobs": 0,
    "pool2d.physics": 1,
    "pool2d.outline": 2, "pool2d.geometry": 2, "pool2d.racks": 2, "pool2d.placing": 2, "pool2d.table": 2,
    "pool2d.assets": 2, "pool2d.reader": 2, "pool2d.files": 2, "pool2d.catalogue": 2, "pool2d.furnish": 2,
    "pool2d.preset": 2, "pool2d.table_data": 2, "pool2d.folders": 2, "pool2d.settings": 2, "pool2d.position": 2,
    "pool2d.scenario": 2, "pool2d": 2,
    "pool2d.game": 3,
    "pool2d.ui": 4,
    "pool2d.terminal": 5, "pool2d.outcome": 5, "pool2d.tables": 5,
    "pool2d.replay": 5, "pool2d.cli": 5, "pool2d.__main__": 6, "main": 6,
}  # fmt: skip
# Who may import what is not in the standard library.
GUESTS = {"pymunk": "pool2d.table", "pygame": "pool2d.ui", "numpy": "pool2d.ui"}


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in (ROOT / "main.py", *sorted((ROOT / "pool2d").rglob("*.py")))}


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


def layer(module: str) -> int:
    """The layer of the longest known name that the module is within."""
    if module in LAYERS:
        return LAYERS[module]
    known = [name for name in LAYERS if name != "pool2d" and within(module, name)]
    assert known, f"{module} has no layer: give it one in {Path(__file__).name}"
    return LAYERS[max(known, key=len)]


def imports(module: str, source: str, is_package: bool) -> Iterator[str]:
    """Every module that the source imports, wherever in it, by full name."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = module.split(".")[: len(module.split(".")) + is_package - node.level] if node.level else []
            whole = ".".join([*base, *([node.module] if node.module else [])])
            # `from package import module` imports the module too.
            yield whole
            yield from (f"{whole}.{alias.name}" for alias in node.names if f"{whole}.{alias.name}" in MODULES)


def faults(module: str, source: str, is_package: bool = False) -> list[str]:
    """What a module may not import, in words."""
    wrong = []
    for name in imports(module, source, is_package):
        top = name.partition(".")[0]
        if top in ("pool2d", "main"):
            if layer(name) > layer(module):
                wrong.append(f"{module} imports {name}, which is above it")
        elif top not in sys.stdlib_module_names and not (top in GUESTS and within(module, GUESTS[top])):
            wrong.append(f"{module} imports {top}")
    return wrong


@pytest.mark.parametrize("module", MODULES)
def test_imports_point_down(module: str) -> None:
    path = MODULES[module]
    assert faults(module, path.read_text(encoding="utf-8"), path.name == "__init__.py") == []


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("pool2d.physics.motion", "from ..table import Table"),
        ("pool2d.physics.motion", "from .. import table"),
        ("pool2d.physics.motion", "import pool2d"),
        ("pool2d.physics.motion", "def late():\n    import numpy"),
        ("pool2d.knobs", "from .physics.values import Ball"),
        ("pool2d.placing", "import pymunk"),
        ("pool2d.scenario", "from .game.session import Session"),
        ("pool2d.game.rules", "import pygame.font"),
        ("pool2d.game.rules", "from ..ui import app"),
        ("pool2d.ui.app", "from ..cli import main"),
        ("pool2d.ui.app", "import scipy"),
    ],
)
def test_arrows_that_point_up_are_seen(module: str, source: str) -> None:
    assert faults(module, source)


def test_a_module_without_a_layer_is_seen() -> None:
    with pytest.raises(AssertionError, match=r"pool2d\.stray has no layer"):
        layer("pool2d.stray")


def test_all_but_the_window_leaves_pygame_alone() -> None:
    code = "import sys, pool2d, pool2d.cli, pool2d.game; sys.exit('pygame' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_no_bits_depend_on_how_a_python_sums() -> None:
    """From 3.12 on `sum` of floats compensates: what rolls is summed by `math.fsum`."""
    for module, path in MODULES.items():
        if within(module, "pool2d.physics"):
            calls = [node.func for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Call)]
            assert "sum" not in {func.id for func in calls if isinstance(func, ast.Name)}, module
