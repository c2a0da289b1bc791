"""What the documents say of the code is so: the files that they name are there, and the rooms are drawn as they are."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from docs import spine

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
FILES = [str(path.relative_to(ROOT).as_posix()) for top in ("docs", "tests", "pool2d", "benchmarks", "assets")
         for path in (ROOT / top).rglob("*") if "__pycache__" not in path.parts]  # fmt: skip
# Names of files that a reader has or makes, and that no checkout holds.
READERS = re.compile(r"shot\.|match\.|mine\.toml|settings\.toml|main\.py$|\.venv/")
NAMED = re.compile(r"`((?:[\w.-]+/)*[\w.-]+(?:\.(?:py|toml|txt|json|md)|/))`")
LINKED = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
RUN = re.compile(r"python -m ((?:docs|tests|benchmarks)\.[\w.]+)")


def missing(page: Path, text: str) -> list[str]:
    """The files that a page names, links or tells one to run, and that are not there."""
    wrong = [name for name in NAMED.findall(text) if not READERS.match(name) and not is_there(name)]
    wrong += [link for link in LINKED.findall(text) if not (page.parent / link).exists()]
    wrong += [
        name
        for name in RUN.findall(text)
        if not (ROOT / name.rstrip(".").replace(".", "/")).with_suffix(".py").exists()
    ]
    return wrong


def is_there(name: str) -> bool:
    """Whether a file or folder ends so; a path is told from any folder that holds it."""
    return any(f"/{file}".endswith("/" + name.rstrip("/")) for file in FILES)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_file_that_a_page_names_is_there(page: Path) -> None:
    assert missing(page, page.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    "text", ["`physics/turning.py`", "see [this](gone.md)", "`python -m benchmarks.gone`", "`ui/gone/`", "`gone.toml`"]
)
def test_a_file_that_is_not_there_is_seen(text: str) -> None:
    assert missing(ROOT / "docs" / "design.md", text)


def test_the_picture_of_the_rooms_is_what_the_imports_are() -> None:
    assert spine.picture() in spine.PAGE.read_text(encoding="utf-8"), "run python -m docs.spine"


def test_arrows_that_follow_from_others_are_left_out() -> None:
    found = {"a": {"b", "c", "d"}, "b": {"c"}, "c": set[str](), "d": set[str]()}
    assert spine.reduced(found) == {"a": {"b", "d"}, "b": {"c"}, "c": set(), "d": set()}
    assert spine.ordered(found) == ["a", "b", "c", "d"]


@pytest.mark.parametrize(
    ("module", "room"),
    [
        ("pool2d.cli", "cli"),
        ("pool2d.physics.laws.ball", "physics"),
        ("pool2d.game.match", "game"),
        ("pool2d.game.rules.pool.straight", "game/rules"),
        ("pool2d.ui.play.hands", "ui/play"),
        ("pool2d.ui.app", "ui/app"),
    ],
)
def test_the_room_of_a_module(module: str, room: str) -> None:
    assert spine.room(module) == room


@pytest.mark.parametrize("name", ["README.md", "docs/records.md"])
def test_the_python_of_a_page_runs(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path))
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / name).read_text(encoding="utf-8"), re.DOTALL)
    assert blocks
    for block in blocks:
        exec(block, {"__name__": "__main__"})
        assert capsys.readouterr().out
