"""The public names: they are what is promised, import late, carry examples that run, and docs/api.md tells of them."""

from __future__ import annotations

import doctest
import importlib
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from docs import api

ROOT = Path(__file__).resolve().parent.parent
PROMISED = {
    "pool2d": "Ball BudgetError Event InputError Layout Rollout Scenario Shot Summaries Table WorkerError "
    "load_scenario load_table simulate simulate_many",
    "pool2d.game": "Ask Call Choice Concede Contact GAMES Match NextFrame Report Rules Ruling Setup State Stroke "
    "game games_for observe",
    "pool2d.opponent": "Chance Hand Judgement Player Taste chances",
}
WITH_EXAMPLES = (
    "load_table",
    "Layout",
    "Ball",
    "Shot",
    "simulate",
    "simulate_many",
    "Rollout",
    "game",
    "Match",
    "observe",
    "Chance",
    "chances",
)
NAMES = [(package, name) for package in api.PACKAGES for name in api.homes(package)]


def item(package: str, name: str) -> Any:
    return getattr(importlib.import_module(package), name)


@pytest.mark.parametrize("package", PROMISED)
def test_what_is_promised_is_exported_and_no_more(package: str) -> None:
    module = importlib.import_module(package)
    names = {name for name in module.__all__ if not name.startswith("_")}
    assert names == set(api.homes(package)) >= set(PROMISED[package].split())
    assert set(module.__all__) <= set(dir(module))
    with pytest.raises(AttributeError, match="has no attribute 'simulat'"):
        _ = module.simulat


@pytest.mark.parametrize(("package", "name"), NAMES)
def test_a_public_name_is_what_its_home_defines(package: str, name: str) -> None:
    assert item(package, name) is getattr(importlib.import_module(api.homes(package)[name]), name)


def test_names_are_fetched_when_they_are_asked_for() -> None:
    code = "import sys, pool2d, pool2d.game; print(*sorted(name for name in sys.modules if name.startswith('pool2d')))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["pool2d", "pool2d._version", "pool2d.game", "pool2d.lazy"]


@pytest.mark.parametrize(("package", "name"), NAMES)
def test_the_examples_of_a_public_name_run(package: str, name: str) -> None:
    value = item(package, name)
    module = importlib.import_module(api.homes(package)[name])
    found = doctest.DocTestFinder().find(value, name, module, globs={}) if hasattr(value, "__module__") else []
    assert name not in WITH_EXAMPLES or any(test.examples for test in found)
    for test in found:
        said: list[str] = []
        assert doctest.DocTestRunner().run(test, out=said.append).failed == 0, "".join(said)


def test_the_page_is_what_the_docstrings_make() -> None:
    page = api.PAGE.read_text(encoding="utf-8")
    assert not api.is_stale(page), "docs/api.md is out of date: pip install -e '.[docs]', then python -m docs.api"
    anchors = set(re.findall(r'<a id="(.+?)"></a>', page))
    assert anchors == {api.anchor(package, name) for package, name in NAMES} == set(re.findall(r"\]\(#(.+?)\)", page))


def test_a_stale_page_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    page = api.PAGE.read_text(encoding="utf-8")
    assert api.is_stale(page.replace("One ball at one moment.", "A ball."))
    source_of = api.source_of
    for old, new in (
        ("One ball at one moment.", "A ball."),
        ("wz: float = 0.0", "wz: float = 1.0"),
        ("def without(self, *ids", "def without(self, *names"),
    ):
        monkeypatch.setattr(api, "source_of", lambda module, old=old, new=new: source_of(module).replace(old, new))
        assert api.is_stale(page), new


def test_the_page_can_be_made() -> None:
    """By whichever griffe2md is there, which may set it otherwise than the one that made the page."""
    pytest.importorskip("griffe2md")
    page = api.render()
    assert not api.is_stale(page)
    assert "One ball at one moment." in page and ">>> table = load_table" in page
