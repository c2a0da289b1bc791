"""Which lines are executed, by what is being done."""

from __future__ import annotations

import runpy
from pathlib import Path

from benchmarks.lines import Lines

SOURCE = """\
def f(x):
    if x:
        return 1
    return 2
"""


def test_lines_count_for_each_name_under_which_they_are_executed(tmp_path: Path) -> None:
    folder, lines = tmp_path / "inside", Lines()
    folder.mkdir()
    for path in (folder / "a.py", tmp_path / "outside.py"):
        path.write_text(SOURCE)
    lines.start(folder)
    lines.switch("read")
    f, other = (runpy.run_path(str(path))["f"] for path in (folder / "a.py", tmp_path / "outside.py"))
    for name, x in (("yes", 1), ("no", 0), ("", 1), ("again", 1)):
        lines.switch(name)
        f(x)
        other(x)
    found = set(lines.stop())
    expected = {("read", 1), ("yes", 2), ("yes", 3), ("no", 2), ("no", 4), ("again", 2), ("again", 3)}
    assert found == {(name, str(folder / "a.py"), line) for name, line in expected}
