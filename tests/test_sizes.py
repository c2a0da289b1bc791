"""How large files, functions and classes may be, so that each is read without scrolling for long."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from statistics import median, quantiles

import pytest

ROOT = Path(__file__).resolve().parent.parent
FILES = [path for folder in ("pool2d", "tests", "benchmarks", "docs") for path in sorted((ROOT / folder).rglob("*.py"))]
# Lines of a file; attributes and methods of a class.
LONGEST, ATTRIBUTES, METHODS = 320, 12, 25
# What the docstring of a larger class says, before it says why.
LARGER = "than most classes"


def trees() -> Iterator[tuple[Path, ast.Module]]:
    """The package's files, parsed."""
    for path in FILES:
        if path.is_relative_to(ROOT / "pool2d"):
            yield path, ast.parse(path.read_text(encoding="utf-8"))


def attributes(kind: ast.ClassDef) -> set[str]:
    """What a class declares, and what its methods set on `self`."""
    declared = {
        node.target.id for node in kind.body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)
    }
    return declared | {
        node.attr
        for node in ast.walk(kind)
        if isinstance(node, ast.Attribute)
        and isinstance(node.ctx, ast.Store)
        and isinstance(node.value, ast.Name)
        and node.value.id == "self"
    }


def too_large(kind: ast.ClassDef) -> bool:
    """Whether a class is larger than most and its docstring does not say so."""
    methods = [node for node in kind.body if isinstance(node, ast.FunctionDef)]
    large = len(attributes(kind)) > ATTRIBUTES or len(methods) > METHODS
    return large and LARGER not in " ".join((ast.get_docstring(kind) or "").split())


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_file_is_too_long(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= LONGEST


def test_functions_are_short() -> None:
    lengths = [
        1 + (node.end_lineno or 0) - node.lineno
        for _, tree in trees()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef)
    ]
    assert median(lengths) <= 5
    assert quantiles(lengths, n=10)[-1] <= 16


def test_a_large_class_says_why() -> None:
    # How many numbers the engine's classes hold is for the physics to say.
    kinds = [
        (path, node)
        for path, tree in trees()
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef) and path.parent.name != "physics"
    ]
    assert [f"{path.name}: {kind.name}" for path, kind in kinds if too_large(kind)] == []


@pytest.mark.parametrize(
    ("source", "large"),
    [
        ("class A:\n" + "\n".join(f"    a{i}: int = 0" for i in range(13)), True),
        ("class A:\n" + "\n".join(f"    a{i}: int = 0" for i in range(12)), False),
        ("class A:\n    def f(self):\n" + "\n".join(f"        self.a{i} = 0" for i in range(13)), True),
        ("class A:\n" + "\n".join(f"    def f{i}(self): ..." for i in range(26)), True),
        ("class A:\n" + "\n".join(f"    def f{i}(self): ..." for i in range(25)), False),
        (
            'class A:\n    """It has more than most\n    classes."""\n'
            + "\n".join(f"    a{i}: int" for i in range(13)),
            False,
        ),
    ],
)
def test_large_classes_are_seen(source: str, large: bool) -> None:
    (kind,) = ast.parse(source).body
    assert isinstance(kind, ast.ClassDef)
    assert too_large(kind) is large
