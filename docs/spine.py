"""The picture of the rooms and their imports in `docs/design.md`: `python -m docs.spine` draws it from the code.

A room is a folder of the package; `ui/` and `game/rules/` are shown apart, and so is each module that lies in no room.
An arrow says that a room imports another. One that follows from others is left out: where a imports b, and b c, the
picture has no arrow from a to c. Beside that, each room's files and lines are printed, the highest first.
"""

from __future__ import annotations

import re
from pathlib import Path

from tests.test_layers import MODULES, imports_of

PAGE = Path(__file__).with_name("design.md")
BLOCK = re.compile(r"```mermaid\n.*?```\n", re.DOTALL)
# Folders whose own folders and modules are shown one by one.
WITHIN = ("ui", "game/rules")

Arrows = dict[str, set[str]]


def room(module: str) -> str:
    """The room of a module, which `pool2d.` begins."""
    parts = module.split(".")[1:]
    if "/".join(parts[:2]) in WITHIN or parts[0] in WITHIN:
        return "/".join(parts[:2])
    return parts[0]


def modules() -> list[str]:
    """Every module that is not merely the `__init__` of a folder."""
    return [name for name, path in MODULES.items() if "." in name and path.name != "__init__.py"]


def arrows() -> Arrows:
    """The rooms that each room imports; a folder's `__init__`, which names its face, does not count."""
    found: Arrows = {room(module): set() for module in modules()}
    for module in modules():
        own = room(module)
        found[own] |= {room(name) for name in imports_of(module) if name.startswith("pool2d.")} - {own}
    return found


def below(found: Arrows, start: str) -> set[str]:
    """All rooms that one imports, directly or by others."""
    seen, todo = set[str](), [start]
    while todo:
        new = found[todo.pop()] - seen
        seen |= new
        todo += new
    return seen


def reduced(found: Arrows) -> Arrows:
    """The arrows without those that follow from others."""
    reach = {name: below(found, name) for name in found}
    return {name: {to for to in direct if not any(to in reach[by] for by in direct)} for name, direct in found.items()}


def ordered(found: Arrows) -> list[str]:
    """The rooms from the top down: each before all that it imports."""
    reach = {name: below(found, name) for name in found}
    return sorted(found, key=lambda name: (-len(reach[name]), name))


def picture() -> str:
    """The block of Mermaid that `docs/design.md` shows."""
    found = arrows()
    few = reduced(found)
    names = ordered(found)
    lines = [f'    {_key(name)}["{name}"]' for name in names]
    lines += [f"    {_key(name)} --> {_key(to)}" for name in names for to in names if to in few[name]]
    return "\n".join(["```mermaid", "flowchart TD", *lines, "```"]) + "\n"


def _key(name: str) -> str:
    return name.replace("/", "_")


def main() -> None:
    """Draw the picture into the page, and print each room's size."""
    PAGE.write_text(BLOCK.sub(lambda _: picture(), PAGE.read_text(encoding="utf-8"), count=1), encoding="utf-8")
    for name in ordered(arrows()):
        paths = [MODULES[module] for module in modules() if room(module) == name]
        lines = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in paths)
        print(f"{name:<14} {len(paths):>3} files {lines:>6} lines")


if __name__ == "__main__":
    main()
