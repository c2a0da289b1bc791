"""The process that thinks: it answers as `decide` does, is missed where it dies, and ends with whoever started it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from pool2d import Table
from pool2d.game.match import Match
from pool2d.game.rules import Choice
from pool2d.game.setup import LAG, Setup
from pool2d.opponent.deciding import Decision, decide
from pool2d.opponent.player import Judgement, Player
from pool2d.opponent.thinker import Thinker, ThinkerError

from ..study.test_workers import alive

ROOT = Path(__file__).resolve().parents[2]
QUICK = Player("quick", judgement=Judgement(ways=1, paces=1, heights=1, sides=1, few=1, runs=0, safeties=1, kicks=1))
# One that is still thinking whenever it is looked at.
SLOW = Player("slow", judgement=Judgement(few=20, runs=200, safeties=200, kicks=720))


@pytest.fixture
def match(table: Table) -> Match:
    """Nine-ball, the cue ball lying where it is to be broken from."""
    match = Match(table, Setup("nine-ball", breaker=0, players=("quick", "quick")))
    match.play(Choice("place", 0.5, 0.5))
    return match


@pytest.fixture
def thinker(match: Match) -> Iterator[Thinker]:
    thinker = Thinker(match.table, match.setup)
    yield thinker
    thinker.close()


def answer(thinker: Thinker) -> Decision:
    for _ in range(6000):
        if (decision := thinker.answer()) is not None:
            return decision
        time.sleep(0.01)
    raise AssertionError("no answer has come")


def ends(process: int) -> bool:
    for _ in range(600):
        if not alive(process):
            return True
        time.sleep(0.1)
    return False


def test_it_decides_as_whoever_asks_would(match: Match, thinker: Thinker) -> None:
    for seed in ("1", "2"):
        thinker.ask(match.now.ruling, QUICK, seed)
        assert answer(thinker) == decide(match.judge, match.now.ruling, QUICK, seed)
    assert thinker.answer() is None


def test_a_lag_is_thought_of_by_its_own_rules(table: Table) -> None:
    match = Match(table, Setup("nine-ball", breaker=LAG, players=("quick", "quick")))
    thinker = Thinker(table, match.setup)
    thinker.ask(match.now.ruling, QUICK, "1")
    assert answer(thinker) == decide(match.judge, match.now.ruling, QUICK, "1")
    thinker.close()


def test_one_that_dies_is_told_and_thinks_again(match: Match, thinker: Thinker) -> None:
    thinker.ask(match.now.ruling, SLOW, "1")
    process = thinker.pid
    assert process is not None
    os.kill(process, signal.SIGTERM)
    with pytest.raises(ThinkerError, match="it has ended"):
        answer(thinker)
    assert thinker.pid is None
    thinker.ask(match.now.ruling, QUICK, "1")
    assert answer(thinker) == decide(match.judge, match.now.ruling, QUICK, "1")


def test_one_that_died_while_nobody_asked_is_told_when_asked(match: Match, thinker: Thinker) -> None:
    process = thinker.pid
    assert process is not None
    os.kill(process, signal.SIGTERM)
    assert ends(process)
    thinker.ask(match.now.ruling, QUICK, "1")
    with pytest.raises(ThinkerError):
        answer(thinker)


def test_what_fails_in_it_is_told_and_it_lives_on(match: Match, thinker: Thinker) -> None:
    process = thinker.pid
    thinker.ask(match.now.ruling._replace(layout=None), QUICK, "1")  # type: ignore[arg-type]
    with pytest.raises(ThinkerError, match="Error: "):
        answer(thinker)
    thinker.ask(match.now.ruling, QUICK, "1")
    assert answer(thinker) and thinker.pid == process


def test_what_was_asked_before_is_forgotten(match: Match, thinker: Thinker) -> None:
    thinker.ask(match.now.ruling, SLOW, "1")
    thinker.ask(match.now.ruling, QUICK, "2")
    assert answer(thinker) == decide(match.judge, match.now.ruling, QUICK, "2")
    assert thinker.answer() is None


def test_closing_ends_it_in_the_middle_of_a_thought(match: Match, thinker: Thinker) -> None:
    thinker.ask(match.now.ruling, SLOW, "1")
    process = thinker.pid
    assert process is not None and alive(process)
    thinker.close()
    assert ends(process)
    thinker.close()


THINKING = """
import sys, time
from pool2d import load_table
from pool2d.game import Match, Setup
from pool2d.opponent.thinker import Thinker
from tests.opponent.test_thinker import SLOW

if __name__ == "__main__":
    match = Match(load_table("pool-9ft"), Setup("eight-ball", players=("slow", "slow")))
    thinker = Thinker(match.table, match.setup)
    thinker.ask(match.now.ruling, SLOW, "1")
    print(thinker.pid, flush=True)
    time.sleep(60.0)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX")
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGKILL])
def test_it_ends_with_whoever_started_it(end: signal.Signals, tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(THINKING)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment)
    assert run.stdout is not None
    process = int(run.stdout.readline())
    run.send_signal(end)
    run.communicate(timeout=60)
    assert ends(process)
