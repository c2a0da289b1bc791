"""Every file and folder that the README, CONTRIBUTING and the docs name is there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
# A path in backticks: folders and a file of a kind kept here, or a folder with a stroke at its end.
PATH = re.compile(r"(?<![\w`/.*])((?:[\w*-]+/)+(?:[\w<>*-]+\.(?:py|toml|md|txt|ttf|png|jpg|gif))?)(?![\w/])")
LINK = re.compile(r"\]\(([^)#\s]+)")
COMMAND = re.compile(r"python -m ((?:tests|docs|benchmarks)(?:\.\w+)+)")


def named(text: str) -> Iterator[str]:
    """What looks like a path in this repository; `<name>` stands for any."""
    for span in re.findall(r"`([^`\n]+)`", text):
        yield from PATH.findall(re.sub(r"<\w+>", "*", span))
    yield from (link for link in LINK.findall(text) if "://" not in link)
    yield from (module.replace(".", "/") + ".py" for module in COMMAND.findall(text))


def is_there(path: str, page: Path) -> bool:
    """From the page, from the root, or from a folder of the package, as a page on that part may say it."""
    folders = (page.parent.glob(path), ROOT.glob(path), (ROOT / "pool2d").rglob(path))
    return any(found for folder in folders for found in folder)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_path_named_is_there(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert [path for path in named(text) if not is_there(path, page)] == []


def test_a_page_that_guides_names_paths_that_are_looked_for() -> None:
    found = list(named((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")))
    assert {"assets/words/*.toml", "pool2d/game/rules/*/*.py", "docs/design.md"} <= set(found)
    assert not is_there("pool2d/game/rules/pool/no_such_game.py", ROOT / "README.md")
