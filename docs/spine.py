"""The rooms of the package and who imports whom, from the imports as they are: `python -m docs.spine` prints them.

A line for each room, the ground last: its files, its lines, and the rooms below that it imports.
"""

from __future__ import annotations

import ast
from pathlib import Path

ROOT = Path(__file__).parents[1]
DEPTH = 2


def room(module: str) -> str:
    """The folder of a module, two deep at most; a module of the package itself is a room of its own."""
    parts = module.split(".")[1:]
    folders = parts if (ROOT / "pool2d" / Path(*parts)).is_dir() else parts[:-1] or parts
    return "/".join(folders[:DEPTH]) or "pool2d"


def imports(module: str, path: Path) -> set[str]:
    """The modules that a file imports, by full name."""
    found = set()
    package = module.split(".") if path.name == "__init__.py" else module.split(".")[:-1]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            whole = ".".join([*base, *([node.module] if node.module else [])])
            for alias in node.names:
                target = ROOT / Path(*f"{whole}.{alias.name}".split("."))
                found.add(f"{whole}.{alias.name}" if target.with_suffix(".py").exists() or target.is_dir() else whole)
    return {name for name in found if name.startswith("pool2d.")}


def rooms() -> dict[str, tuple[int, int, set[str]]]:
    """Each room's files, lines, and the other rooms that it imports."""
    found: dict[str, tuple[int, int, set[str]]] = {}
    for path in sorted((ROOT / "pool2d").rglob("*.py")):
        if path.name == "__init__.py":
            continue
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        here = room(module)
        files, lines, below = found.get(here, (0, 0, set[str]()))
        below |= {room(name) for name in imports(module, path)} - {here}
        found[here] = files + 1, lines + len(path.read_text(encoding="utf-8").splitlines()), below
    return found


def main() -> None:
    """Print the rooms, those first that nobody below imports."""
    left = rooms()
    while left:
        used = {name for _, _, below in left.values() for name in below}
        top = [name for name in left if name not in used] or list(left)
        for name in sorted(top):
            files, lines, below = left.pop(name)
            print(f"{name:<18} {files:>3} files {lines:>6} lines   {', '.join(sorted(below))}")


if __name__ == "__main__":
    main()
