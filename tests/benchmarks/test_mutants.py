"""The small changes that `benchmarks.mutants` makes, and which tests it shows them to."""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

import pytest

from benchmarks.mutants import LAYERS, ROOT, Map, goes, layer_of, mutants
from benchmarks.mutations import sites
from benchmarks.reach import Show, begin, end


def changed(source: str) -> set[str]:
    """Every source that one change leads to."""
    given = textwrap.dedent(source).encode()
    return {made.decode() for change in sites(given) if (made := change.made(given)) is not None}


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("x = a + b", {"x = a - b"}),
        ("x = (a) * (b)", {"x = (a) / (b)"}),
        ("x -= y", {"x += y", "pass"}),
        ("x = -y", {"x = (y)"}),
        ("x = not y", {"x = (y)"}),
        ("x = 0.5", {"x = 1.0"}),
        ("x = 0.0", {"x = 1.0"}),
        ("x = 3", {"x = 4"}),
        ("x = True", {"x = False"}),
        ("x = a and b or c", {"x = a or b or c", "x = a and b and c"}),
        ("x = a is b", {"x = a is not b"}),
        ("x = a not in b", {"x = a in b"}),
        # The boundary matters among whole numbers.
        ("x = a < b", {"x = a >= b"}),
        ("x = len(a) < b", {"x = len(a) >= b", "x = len(a) <= b"}),
        ("x = min(a, b)", {"x = max(a, b)"}),
        ("x = math.sin(a)", {"x = math.cos(a)"}),
        ("x = f(a, b)", {"x = f(b, a)"}),
        ("x = math.hypot(a, b)", set()),
        ("x = 'ä' + a", {"x = 'ä' - a"}),
        ("if a:\n    b()", {"if not (a):\n    b()", "if a:\n    pass"}),
        ("def f() -> None:\n    g()", {"def f() -> None:\n    pass"}),
        ("def f() -> bool:\n    return a()", {"def f() -> bool:\n    return not (a())"}),
        ("def f() -> float:\n    return a", {"def f() -> float:\n    return -(a)"}),
        ("def f() -> A | None:\n    return a", {"def f() -> A | None:\n    return None"}),
        ("def f() -> list[A]:\n    return a", {"def f() -> list[A]:\n    return []"}),
        ("def f(a=1) -> None: ...", {"def f(a=2) -> None: ..."}),
        ("for a in b:\n    continue", {"for a in b:\n    pass"}),
        ("a.b = c", {"pass"}),
        # What nobody could notice.
        ('"""1 + 1"""', set()),
        ("x: Literal[1]", set()),
        ("x: Literal[1] = 1", {"x: Literal[1] = 2"}),
        ("raise E(1 + 1)", {"pass"}),
        ('x = f"{a:1}"', set()),
        ("def __repr__(self) -> str:\n    return 1 + 1", set()),
        ("if TYPE_CHECKING:\n    x = 1", set()),
        ("x = zip(a, b, strict=True)", {"x = zip(b, a, strict=True)"}),
        ("@dataclass(frozen=True)\nclass A: ...", set()),
    ],
)
def test_changes(source: str, expected: set[str]) -> None:
    assert changed(source) == expected


def test_a_change_is_found_by_the_line_and_the_statement_it_is_in() -> None:
    change, other = sites(b"def f(a=1):\n    return g(\n        -a)\n")
    assert (change.line, change.reach) == (1, ())
    assert (other.line, other.reach) == (3, (3, 2))


def test_a_map_leads_to_the_narrowest_test_first() -> None:
    seconds = dict.fromkeys(("t.py::a", "t.py::b", "u.py::c", "u.py::d", "v.py::e"), 0.1)
    known = Map(
        {
            "seconds": seconds,
            "failed": ["v.py::e"],
            "lines": {
                "t.py::a": {"m.py": [1, 2, 3]},
                "t.py::b": {"m.py": [2]},
                "u.py::d": {"m.py": [2, 3]},
                "v.py::e": {"m.py": [2]},
            },
        }
    )
    # `d` may have worked out what `c` is told as well; `e` fails by itself.
    assert known.tests("m.py", (2,)) == ["u.py::c", "t.py::b", "u.py::d", "t.py::a"]
    assert known.tests("m.py", (1,)) == ["t.py::b", "t.py::a"]
    assert known.tests("m.py", (4,)) == known.tests("n.py", ()) == []
    assert set(known.tests("m.py", ())) == set(seconds) - {"v.py::e"}


def test_each_go_takes_twice_the_time_of_the_one_before() -> None:
    tests = [str(i) for i in range(20)]
    parts = list(goes(tests, dict.fromkeys(tests, 2.0)))
    assert [len(part) for part in parts] == [2, 4, 8, 6]
    assert [test for part in parts for test in part] == tests


def test_the_seed_draws_as_many_in_each_layer() -> None:
    drawn = mutants(list(LAYERS), 40, 5)
    assert drawn == mutants(list(LAYERS), 40, 5) != mutants(list(LAYERS), 40, 6)
    for layer, folder in LAYERS.items():
        those = [mutant for mutant in drawn if mutant.layer == layer]
        assert len(those) == 10
        assert all(layer_of(mutant.path) == layer and mutant.path.startswith(folder) for mutant in those)
        assert all((ROOT / mutant.path).is_file() for mutant in those)


@pytest.mark.skipif(sys.platform == "win32", reason="it forks")
@pytest.mark.parametrize(("body", "noticed"), [("time.sleep(1.0)", False), ("while True: pass", True)])
def test_a_test_may_wait_longer_than_it_may_compute(tmp_path: Path, body: str, noticed: bool) -> None:
    tree, out = tmp_path / "tree", tmp_path / "out.txt"
    tree.mkdir()
    (tree / "test_one.py").write_text(f"import time\n\ndef test_one():\n    {body}\n")
    limits = {"test_one.py::test_one": 0.5}
    status = end(begin(tree, ["test_one.py"], Show(limits, out), tmp_path / "log.txt"), 100.0)
    assert status == noticed
    assert out.exists() == noticed
