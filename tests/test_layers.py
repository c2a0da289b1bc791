"""Imports point down, between rooms and within them, and never in a circle."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
# From the ground up; what stands in one line may import each other's files, as long as no circle comes of it.
FLOORS = (
    ("pool2d._version", "pool2d.compiled", "pool2d.errors", "pool2d.lazy", "pool2d.printable"),
    ("pool2d.config",),
    ("pool2d.physics",),
    ("pool2d.table",),
    ("pool2d.study", "pool2d"),
    ("pool2d.fit",),
    ("pool2d.game.rules",),
    ("pool2d.game",),
    ("pool2d.opponent",),
    ("pool2d.sound", "pool2d.draw"),
    ("pool2d.ui.wording",),
    ("pool2d.ui", "pool2d.ui.frame", "pool2d.ui.scene", "pool2d.ui.screen"),
    ("pool2d.ui.widgets",),
    ("pool2d.ui.dialogs",),
    ("pool2d.ui.stage",),
    ("pool2d.ui.play",),
    ("pool2d.ui.replay",),
    ("pool2d.ui.menus",),
    ("pool2d.ui.toasts", "pool2d.ui.window", "pool2d.ui.app", "pool2d.ui.start"),
    ("pool2d.commands",),
    ("pool2d.cli",),
    ("pool2d.__main__", "main"),
)
FLOOR = {name: number for number, names in enumerate(FLOORS) for name in names}
# Packages whose modules have to be named above, one by one.
NAMED = ("pool2d", "pool2d.ui")
# Who may import what is not in the standard library.
GUESTS = {
    "pymunk": ("pool2d.table",),
    "pygame": ("pool2d.sound", "pool2d.draw", "pool2d.ui"),
    "pyarrow": ("pool2d.study.parquet",),
    "distributed": ("pool2d.commands.study",),
    "scipy": ("pool2d.fit",),
    "numpy": ("pool2d.study", "pool2d.fit", "pool2d.opponent", "pool2d.sound", "pool2d.draw", "pool2d.ui"),
}


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in (ROOT / "main.py", *sorted((ROOT / "pool2d").rglob("*.py")))}
PACKAGES = [path.parent for path in sorted((ROOT / "pool2d").rglob("__init__.py"))]


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


def floor(module: str) -> int:
    """The floor of the longest known name that the module is within."""
    if module in FLOOR:
        return FLOOR[module]
    known = [name for name in FLOOR if name not in NAMED and within(module, name)]
    assert known, f"{module} has no floor: give it one in {Path(__file__).name}"
    return FLOOR[max(known, key=len)]


def imports(module: str, source: str, is_package: bool) -> Iterator[str]:
    """Every module that the source imports, wherever in it, for type checking too, by full name."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = module.split(".")[: len(module.split(".")) + is_package - node.level] if node.level else []
            whole = ".".join([*base, *([node.module] if node.module else [])])
            # `from package import module` imports the module; what else it names stands in the package's own file.
            names = [f"{whole}.{alias.name}" for alias in node.names]
            yield from (name for name in names if name in MODULES)
            if any(name not in MODULES for name in names):
                yield whole


def imports_of(module: str) -> set[str]:
    path = MODULES[module]
    return set(imports(module, path.read_text(encoding="utf-8"), path.name == "__init__.py"))


def faults(module: str, names: set[str]) -> list[str]:
    """What a module may not import, in words."""
    wrong = []
    for name in sorted(names):
        top = name.partition(".")[0]
        if top in ("pool2d", "main"):
            if floor(name) > floor(module):
                wrong.append(f"{module} imports {name}, which is above it")
        elif top not in sys.stdlib_module_names and not any(within(module, room) for room in GUESTS.get(top, ())):
            wrong.append(f"{module} imports {top}")
    return wrong


def circles(arrows: dict[str, set[str]]) -> list[list[str]]:
    """The groups of modules that import each other in a loop."""
    reached: dict[str, set[str]] = {}
    for start in arrows:
        seen, todo = set[str](), [start]
        while todo:
            for name in arrows.get(todo.pop(), set()) - seen:
                seen.add(name)
                todo.append(name)
        reached[start] = seen
    loops = {tuple(sorted(name for name in reached[start] if start in reached.get(name, set()))) for start in arrows}
    return sorted(list(loop) for loop in loops if loop)


@pytest.mark.parametrize("module", MODULES)
def test_imports_point_down(module: str) -> None:
    assert faults(module, imports_of(module)) == []


def test_no_modules_import_each_other_in_a_circle() -> None:
    assert circles({module: imports_of(module) & MODULES.keys() for module in MODULES}) == []


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("pool2d.physics.motion", "from ..table.table import Table"),
        ("pool2d.physics.motion", "from ..table import table"),
        ("pool2d.physics.motion", "import pool2d"),
        ("pool2d.physics.motion", "def late():\n    import numpy"),
        ("pool2d.config.knobs", "from ..physics.values import Ball"),
        ("pool2d.game.session", "import pymunk"),
        ("pool2d.table.scenario", "from ..game.session import Session"),
        ("pool2d.game.rules", "import pygame.font"),
        ("pool2d.game.rules", "from ...ui import app"),
        ("pool2d.draw.pen", "from ..ui.wording.words import Words"),
        ("pool2d.ui.stage.stage", "from ..play.play import Play"),
        ("pool2d.ui.app", "from ..cli import main"),
        ("pool2d.ui.app", "import scipy"),
    ],
)
def test_arrows_that_point_up_are_seen(module: str, source: str) -> None:
    assert faults(module, set(imports(module, source, MODULES[module].name == "__init__.py")))


def test_circles_are_seen() -> None:
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": set()}) == [["a", "b", "c"]]
    assert circles({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


@pytest.mark.parametrize("module", ["pool2d.stray", "pool2d.ui.stray"])
def test_a_module_without_a_floor_is_seen(module: str) -> None:
    with pytest.raises(AssertionError, match=rf"{module} has no floor"):
        floor(module)


@pytest.mark.parametrize("package", PACKAGES, ids=lambda path: path.name)
def test_a_room_has_one_duty_and_few_files(package: Path) -> None:
    """The duty is said by its `__init__`; beside that it has three files at least, and about twenty at most."""
    assert ast.get_docstring(ast.parse((package / "__init__.py").read_text(encoding="utf-8")))
    files = [path for path in package.iterdir() if path.suffix == ".py" and path.name != "__init__.py"]
    assert 3 <= len(files) <= 20


def test_no_two_classes_have_one_name() -> None:
    named: Counter[str] = Counter()
    for path in MODULES.values():
        tree = ast.parse(path.read_text(encoding="utf-8"))
        named.update(node.name for node in tree.body if isinstance(node, ast.ClassDef) and node.name[0] != "_")
    assert [name for name, count in named.items() if count > 1] == []


def test_no_two_modules_have_one_name() -> None:
    named = Counter(path.name for path in MODULES.values() if path.name not in ("__init__.py", "__main__.py"))
    assert [name for name, count in named.items() if count > 1] == []


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
