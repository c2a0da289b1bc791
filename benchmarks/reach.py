"""Running the tests in a copy of the tree: to see which test executes which lines, or to show a changed tree to some.

Each run is a fork of this process, which has loaded what tests need of others and nothing of the project: so it begins
at once, and imports the project from the copy.
"""

from __future__ import annotations

import contextlib
import gc
import json
import os
import resource
import signal
import sys
import time
from collections import defaultdict
from collections.abc import Iterator
from functools import _lru_cache_wrapper, cache
from pathlib import Path
from typing import Any

import hypothesis
import numpy
import pymunk
import pytest

with contextlib.redirect_stdout(None):
    import pygame

from .lines import Lines

LOADED = (hypothesis, numpy, pymunk, pygame)
# A changed program may ask for all memory there is; it gets so much, bytes.
MEMORY = 6 << 30
# A test may wait so many times as long as it may compute: for others on a busy machine, but not for ever.
WAITING = 30.0
_OURS = ("pool2d", "tests", "benchmarks", "main", "docs")


class Watch:
    """Which lines each test executes: a plugin for pytest that writes {"seconds", "failed", "lines"} by test."""

    def __init__(self, out: Path) -> None:
        self._out = out
        self._lines = Lines()
        self._seconds: dict[str, float] = defaultdict(float)
        self._failed: set[str] = set()
        self._file = ""

    def pytest_configure(self) -> None:
        self._lines.start(Path.cwd() / "pool2d")

    @pytest.hookimpl(wrapper=True)
    def pytest_make_collect_report(self, collector: pytest.Collector) -> Iterator[Any]:
        # What a file of tests does when it is imported, all its tests build on.
        self._lines.switch(collector.nodeid if isinstance(collector, pytest.Module) else "")
        report = yield
        self._lines.switch("")
        return report

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[Any]:
        if file_of(item.nodeid) != self._file:
            self._file = file_of(item.nodeid)
            _forget()
        self._lines.switch(item.nodeid)
        done = yield
        self._lines.switch("")
        return done

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._seconds[report.nodeid] += report.duration
        if report.failed:
            self._failed.add(report.nodeid)

    def pytest_sessionfinish(self) -> None:
        lines: dict[str, dict[str, list[int]]] = defaultdict(lambda: defaultdict(list))
        # A path is told for each of its lines, a million times in all.
        within = cache(lambda path: Path(path).relative_to(Path.cwd()).as_posix())
        for context, path, line in self._lines.stop():
            lines[context][within(path)].append(line)
        self._out.write_text(json.dumps({"seconds": self._seconds, "failed": sorted(self._failed), "lines": lines}))


class Show:
    """Runs the tests that are named, each with the seconds that it may compute, in that order, until one fails."""

    def __init__(self, limits: dict[str, float], out: Path) -> None:
        self._limits = limits
        self._out = out

    def pytest_configure(self) -> None:
        signal.signal(signal.SIGPROF, _give_up)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        order = {test: place for place, test in enumerate(self._limits)}
        items[:] = sorted((item for item in items if item.nodeid in order), key=lambda item: order[item.nodeid])
        for item in items:
            item.add_marker(pytest.mark.timeout(WAITING * self._limits[item.nodeid]), append=False)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[Any]:
        # Again every second, lest what it ran into goes on from there.
        signal.setitimer(signal.ITIMER_PROF, self._limits[item.nodeid], 1.0)
        done = yield
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        return done

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        self._tell(report)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._tell(report)

    def _tell(self, report: pytest.CollectReport | pytest.TestReport) -> None:
        if report.failed:
            why = str(getattr(report.longrepr, "reprcrash", None) or report.longrepr)
            self._out.write_text(f"{report.nodeid}: {why.strip().splitlines()[-1]}")


def _give_up(number: int, frame: object) -> None:
    # No test catches this by what it says it raises.
    pytest.fail("still computing")


def file_of(test: str) -> str:
    return test.partition("::")[0]


def _forget() -> None:
    """Empty what functions keep of results: each file of tests then works out for itself what it needs."""
    for kept in gc.get_objects():
        if isinstance(kept, _lru_cache_wrapper) and kept.__module__.startswith("pool2d"):
            kept.cache_clear()


def begin(tree: Path, arguments: list[str], plugin: Watch | Show, log: Path) -> int:
    """Start pytest in a copy of the tree; the id of its process. What it prints goes to a file."""
    sys.stdout.flush()
    process = os.fork()
    if process == 0:
        status = 70
        try:
            if isinstance(plugin, Show):
                # With all that it starts it may have to be killed; while tests are watched, Ctrl+C ends them too.
                os.setpgid(0, 0)
            _become(tree, log, interpreted=isinstance(plugin, Watch))
            # Watched tests take much longer than by themselves, so no limit holds there; `Show` sets its own.
            fixed = ["-n", "0", "--timeout=0", "-p", "no:cacheprovider", "-x" if isinstance(plugin, Show) else "-q"]
            status = pytest.main([*fixed, *arguments], plugins=[plugin])
        finally:
            os._exit(status)
    return process


def _become(tree: Path, log: Path, interpreted: bool) -> None:
    """Make this process one that was started in the tree.

    Only lines that are interpreted can be watched. A tree that is shown to tests may be compiled: a source that was
    changed is never run so.
    """
    out = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(out, 1)
    os.dup2(out, 2)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    scratch = tree.with_name(f"{tree.name}-scratch")
    scratch.mkdir(exist_ok=True)
    # Random tests repeat on a build machine; what tests leave behind goes with the tree.
    os.environ.update(CI="1", TMPDIR=str(scratch), POOL2D_INTERPRETED="1" if interpreted else "")
    os.chdir(tree)
    sys.path[0] = str(tree)
    for name in [name for name in sys.modules if name.partition(".")[0] in _OURS]:
        del sys.modules[name]


def end(process: int, patience: float) -> int | None:
    """The status with which the process ends; None where it had to be killed, by a signal or after so many seconds."""
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        done, status = os.waitpid(process, os.WNOHANG)
        if done:
            return os.WEXITSTATUS(status) if os.WIFEXITED(status) else None
        time.sleep(0.02)
    os.killpg(process, signal.SIGKILL)
    os.waitpid(process, 0)
    return None
