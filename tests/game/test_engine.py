"""What tells the engine, the rules and the machine that play a shot."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from pool2d.game.records import engine
from pool2d.game.records.engine import Identity

# What plays.


def test_an_engine_is_told_by_its_sources() -> None:
    mine = engine.identity()
    assert mine == engine.identity() and len(set(mine)) == 3
    assert all(len(part) == 16 and int(part, 16) >= 0 for part in mine)
    root = Path(engine.__file__).resolve().parents[2]
    assert all((root / part).exists() for part in (*engine.ENGINE, *engine.RULES))
    # Whatever module there is of the physics or the rules counts, and none of the window.
    assert {part.partition("/")[0] for part in (*engine.ENGINE, *engine.RULES)}.isdisjoint({"ui"})


def test_another_source_is_another_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "physics").mkdir()
    source = tmp_path / "physics" / "a.py"
    monkeypatch.setattr(resources, "files", lambda package: tmp_path)
    seen = set()
    for text in (b"a = 1\n", b"a = 2\n", b"a = 1\nb = 2\n"):
        source.write_bytes(text)
        seen.add(engine._digest_of(("physics",)))
    assert len(seen) == 3
    # The ends of lines are the system's.
    source.write_bytes(b"a = 1\r\nb = 2\r\n")
    assert engine._digest_of(("physics",)) in seen
    assert engine._digest_of(("nothing.py",)).startswith("version ")


@pytest.mark.parametrize("data", [None, 3, [], ["a", "b"], ["a", "b", 3], {"engine": "a"}])
def test_what_tells_no_engine_is_none(data: object) -> None:
    assert engine.identity_of(data) is None
    assert engine.identity_of(["a", "b", "c"]) == Identity("a", "b", "c")
