"""Pictures kept on disk: found again, never trusted when damaged, never in the way."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from pool2d import load_table
from pool2d.draw.tabletop import cache, table_picture
from pool2d.draw.view import View, fit

from ..test_layers import MODULES, imports

SIZE = (160, 90)


@pytest.mark.parametrize(
    ("platform", "variables", "expected"),
    [
        ("linux", {"XDG_CACHE_HOME": "/c"}, "/c/pool2d"),
        ("linux", {}, "/h/.cache/pool2d"),
        ("darwin", {"XDG_CACHE_HOME": "/c"}, "/h/Library/Caches/pool2d"),
        ("win32", {"LOCALAPPDATA": "/l"}, "/l/pool2d/Cache"),
        ("win32", {}, "/h/AppData/Local/pool2d/Cache"),
        ("win32", {"LOCALAPPDATA": "/l", "POOL2D_CACHE": "/mine"}, "/mine"),
    ],
)
def test_the_platforms_place(
    monkeypatch: pytest.MonkeyPatch, platform: str, variables: dict[str, str], expected: str
) -> None:
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA", "POOL2D_CACHE"):
        monkeypatch.delenv(name, raising=False)
    for name, value in {"HOME": "/h", "USERPROFILE": "/h", **variables}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(sys, "platform", platform)
    assert cache.folder() == Path(expected)


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("POOL2D_CACHE", str(tmp_path / "kept"))
    return tmp_path / "kept"


def test_what_is_saved_is_loaded(place: Path) -> None:
    assert cache.load("a", 3) is None
    cache.save("a", b"xyz")
    assert bytes(cache.load("a", 3) or b"") == b"xyz"
    assert [path.name for path in place.iterdir()] == ["a.pixels"]


@pytest.mark.parametrize("content", [b"", b"x", b"xyz", b"xyzabcd", b"xyz" * 1000])
def test_a_damaged_picture_is_not_taken(place: Path, content: bytes) -> None:
    cache.save("a", b"xyz")
    (place / "a.pixels").write_bytes(content)
    assert cache.load("a", 3) is None
    cache.save("a", b"xyz")
    assert bytes(cache.load("a", 3) or b"") == b"xyz"


def test_where_nothing_can_be_written_nothing_is_lost(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("POOL2D_CACHE", str(tmp_path / "file" / "below"))
    cache.save("a", b"xyz")
    assert cache.load("a", 3) is None
    table = load_table("pool-9ft")
    assert table_picture.draw(table, SIZE, fit(2.54, 1.27, (0, 0, *SIZE))).get_size() == SIZE


def test_the_longest_unused_go_when_there_is_no_room(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "_ROOM", 3 * 104)
    for name in "abc":
        cache.save(name, b"." * 100)
        stamp = 10**9 * (1 + ord(name))
        os.utime(place / f"{name}.pixels", ns=(stamp, stamp))
    # Being used makes the oldest the youngest.
    assert cache.load("a", 100)
    cache.save("d", b"." * 100)
    assert {path.stem for path in place.iterdir()} == {"a", "c", "d"}


def test_a_picture_is_drawn_once_for_all_that_look_alike(place: Path) -> None:
    table = load_table("pool-9ft")
    view = fit(2.54, 1.27, (0, 0, *SIZE))
    assert table_picture.kept(table, SIZE, view) is None
    table_picture.draw(table, SIZE, view)
    for alike in (load_table("pool-9ft"), table.with_knobs({"cloth.mu_roll": 0.02})):
        assert table_picture.kept(alike, SIZE, view) is not None
    for other in (load_table("pool-8ft"), table.with_knobs({"corner.mouth": 0.12})):
        assert table_picture.kept(other, SIZE, view) is None
    assert table_picture.kept(table, SIZE, View(view.scale, view.left + 1.0, view.bottom)) is None


def test_other_code_draws_another_picture(tmp_path: Path) -> None:
    code = [tmp_path / "one.py", tmp_path / "two.py"]
    code[0].write_text("a")
    code[1].write_text("b")
    names = {cache.name_of("x", str(path)) for path in code} | {cache.name_of("y", str(code[0]))}
    assert len(names) == 3


def test_a_change_in_what_the_code_imports_draws_another_picture(tmp_path: Path) -> None:
    """However it is imported, and through others."""
    inner = tmp_path / "package" / "inner"
    inner.mkdir(parents=True)
    files = {
        "package/inner/draws.py": "from . import (\n    one,\n    two as other,\n)\n",
        "package/inner/one.py": "from ..below import something\n",
        "package/inner/two.py": "def late():\n    from ..deep.under import x\n",
        "package/below.py": "",
        "package/deep/under.py": "",
        "package/deep/__init__.py": "",
        "package/idle.py": "",
    }
    for name, content in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content)

    def named() -> str:
        cache._code.cache_clear()
        return cache.name_of("x", str(inner / "draws.py"))

    before = named()
    for file in files:
        (tmp_path / file).write_text((tmp_path / file).read_text() + "# changed\n")
        assert (named() == before) == (file in ("package/idle.py", "package/deep/__init__.py"))
        before = named()


def test_all_that_draws_a_table_belongs_to_its_digest() -> None:
    """As the parser reads the imports, not as the cache does."""
    reached, ahead = set(), ["pool2d.draw.tabletop.table_picture"]
    while ahead:
        module = ahead.pop()
        if module not in reached:
            reached.add(module)
            path = MODULES[module]
            found = imports(module, path.read_text(encoding="utf-8"), path.name == "__init__.py")
            ahead += [one for one in found if one in MODULES]
    assert {
        "pool2d.draw.view",
        "pool2d.table.outline",
        "pool2d.table.geometry",
        "pool2d.draw.tabletop.cloth",
    } <= reached
    known = {path.resolve() for path in cache.sources(Path(table_picture.__file__))}
    # A package that is named only on the way to its module is not read.
    assert {MODULES[module] for module in reached if MODULES[module].name != "__init__.py"} <= known


def test_an_entry_that_is_no_file_is_passed_over(place: Path) -> None:
    place.mkdir(parents=True)
    os.mkfifo(place / "a.pixels")
    assert cache.load("a", 3) is None
    cache.save("a", b"xyz")
    assert bytes(cache.load("a", 3) or b"") == b"xyz"
