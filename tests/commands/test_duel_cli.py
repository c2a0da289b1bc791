"""`pool2d duel`: the same records whoever plays them, what is told of them, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from pool2d import InputError
from pool2d.cli import main
from pool2d.commands import duelling
from pool2d.opponent.contests.contest import Contest, ContestOutcome, Performance

from ..opponent.contests.quick_players import written
from .cli_runs import Capture, refusal


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))
    return tmp_path / "data"


@pytest.fixture
def pair(tmp_path: Path) -> list[str]:
    """The files of two players who take no time."""
    return [written(tmp_path, "ann", 0.0), written(tmp_path, "bo", 20.0)]


def duel(*words: str) -> int:
    return main(["duel", "--game", "nine-ball", "--matches", "2", *words])


def told(capsys: Capture) -> str:
    out, err = capsys.readouterr()
    assert err == ""
    return out


def test_the_same_seed_writes_the_same_records_however_many_play(
    tmp_path: Path, pair: list[str], capsys: Capture
) -> None:
    answers = []
    for jobs in ("1", "2"):
        assert duel(*pair, "--json", "--seed", "3", "--jobs", jobs, "--out", str(tmp_path / jobs)) == 0
        (line,) = told(capsys).splitlines()
        answers.append(json.loads(line, parse_constant=pytest.fail))
    one, two = ({path.name: path.read_bytes() for path in (tmp_path / jobs).iterdir()} for jobs in "12")
    assert one == two
    assert set(one) == {"ann - bo 0001.jsonl", "ann - bo 0002.jsonl"}
    assert list(answers[0]) == [
        "game", "seed", "matches", "wins", "illegal", "seconds_per_shot", "pots", "attempts", "fouls",
    ]  # fmt: skip
    for answer in answers:
        answer.pop("seconds_per_shot")
    assert answers[0] == answers[1]
    assert (answers[0]["game"], answers[0]["seed"], answers[0]["matches"]) == ("nine-ball", 3, 2)
    assert (sum(answers[0]["wins"]), answers[0]["illegal"]) == (2, 0)


def outcome(winner: int, illegal: int = 0) -> ContestOutcome:
    return ContestOutcome(winner, illegal, (Performance([0.5, 1.5, 0.25], 4, 3, 1), Performance([0.25], 2, 1, 0)))


class Umpire:
    """Says how matches end that nobody plays; it leaves no records, and is interrupted where it has no more."""

    def __init__(self, *outcomes: ContestOutcome) -> None:
        self.outcomes = list(outcomes)
        self.contests: list[Contest] = []

    def __call__(self, contest: Contest) -> ContestOutcome:
        if not self.outcomes:
            raise KeyboardInterrupt
        self.contests.append(contest)
        return self.outcomes.pop(0)


def umpired(monkeypatch: pytest.MonkeyPatch, *outcomes: ContestOutcome) -> Umpire:
    umpire = Umpire(*outcomes)
    monkeypatch.setattr(duelling, "held", umpire)
    return umpire


def test_people_read_who_won_and_how(
    tmp_path: Path, pair: list[str], capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    umpire = umpired(monkeypatch, outcome(0), outcome(-1, 1))
    assert duel(*pair, "--jobs", "1", "--out", str(tmp_path / "out")) == 0
    assert told(capsys).splitlines() == [
        "nine-ball on pool-9ft, seed 0: 2 matches",
        "  ann             1 won,  50 % (9 to 91); 6 of 8 tries made, 2 fouls; 0.50 s a decision, the longest 1.50 s",
        "  bo              0 won,   0 % (0 to 66); 2 of 4 tries made, 0 fouls; 0.25 s a decision, the longest 0.25 s",
        "  illegal actions 1, undecided 1",
        f"{tmp_path / 'out'}: 2 records",
    ]
    assert [contest.number for contest in umpire.contests] == [0, 1]


def test_what_is_played_is_told_when_it_is_interrupted(
    tmp_path: Path, pair: list[str], capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    umpired(monkeypatch, outcome(1))
    left = tmp_path / "ann - bo 0002.part"
    left.write_text("half")
    assert duel(*pair, "--jobs", "1", "--json", "--out", str(tmp_path)) == 130
    out, err = capsys.readouterr()
    assert err == "pool2d: interrupted; 1 of 2 matches are played, and counted\n"
    assert (json.loads(out)["matches"], json.loads(out)["wins"]) == (1, [0, 1])
    assert not left.exists()


def test_everybody_plays_everybody(
    tmp_path: Path, pair: list[str], capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = [*pair, written(tmp_path, "cy", 5.0)]
    results = [outcome(winner) for winner in (0, 1, 0, 0, 1, 1)]
    words = ("--all", "--players", ",".join(names), "--jobs", "1", "--out", str(tmp_path / "out"))
    umpired(monkeypatch, *results)
    assert duel(*words) == 0
    lines = told(capsys).splitlines()
    assert lines[0] == "nine-ball on pool-9ft, seed 0: 2 matches of each two"
    assert [line.split() for line in lines[1:5]] == [
        ["Elo", "won", "ann", "bo", "cy"],
        ["ann", "1581", "3", "-", "1", "2"],
        ["bo", "1419", "1", "1", "-", "0"],
        ["cy", "1500", "2", "0", "2", "-"],
    ]
    umpired(monkeypatch, *results)
    assert duel(*words, "--json") == 0
    assert json.loads(told(capsys)) == {
        "game": "nine-ball", "seed": 0, "matches": 2, "players": names, "wins": [[0, 1, 2], [1, 0, 0], [0, 2, 0]],
        "elo": [1581, 1419, 1500], "illegal": 0,
    }  # fmt: skip


def test_without_names_all_who_are_shipped_play(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    umpire = umpired(monkeypatch, *(outcome(0) for _ in range(1000)))
    assert duel("--all", "--jobs", "1", "--out", str(tmp_path)) == 0
    files = dict.fromkeys(file for contest in umpire.contests for file in contest.files)
    assert len(files) >= 8
    assert len(umpire.contests) == len(files) * (len(files) - 1)


@pytest.mark.parametrize(
    ("game", "table"),
    [("eight-ball", "pool-9ft"), ("snooker", "snooker-12ft"), ("three-cushion", "carom-10ft")],
)
def test_a_game_finds_its_table(
    game: str, table: str, tmp_path: Path, pair: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    umpire = umpired(monkeypatch, outcome(0), outcome(1))
    assert duel(*pair, "--game", game, "--jobs", "1", "--out", str(tmp_path)) == 0
    assert umpire.contests[0].table.source == table


def test_records_go_to_the_data_folder(home: Path, pair: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    umpire = umpired(monkeypatch, outcome(0), outcome(1))
    assert duel(*pair, "--jobs", "1", "--set", "cloth.mu_roll=0.02") == 0
    contest = umpire.contests[0]
    assert contest.path.parent.parent == home / "duels"
    assert contest.table.knobs.cloth.mu_roll == 0.02


def test_a_folder_that_has_these_matches_is_refused(tmp_path: Path, pair: list[str], capsys: Capture) -> None:
    (tmp_path / "ann - bo 0002.jsonl").write_text("")
    line = refusal(capsys, "duel", *pair, "--matches", "2", "--out", str(tmp_path))
    assert line.endswith("ann - bo 0002.jsonl: is there already; allowed is a folder without these matches")


def test_a_disk_that_is_full_is_told(
    tmp_path: Path, pair: list[str], capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(contest: Contest) -> Any:
        raise InputError(str(contest.path), "", None, "cannot be written: no space")

    monkeypatch.setattr(duelling, "held", full)
    assert "cannot be written: no space" in refusal(capsys, "duel", *pair, "--jobs", "1", "--out", str(tmp_path))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["ida"], "needed are two PLAYERs, or --all"),
        (["ida", "tom", "rosa"], "needed are two PLAYERs, or --all"),
        (["ida", "tomm"], "player = 'tomm': unknown; did you mean tom?"),
        (["ida", "tom", "--all"], "do not go together"),
        (["ida", "tom", "--players", "ida"], "--players = 'ida': allowed is only with --all"),
        (["--all", "--players", "ida"], "--players = 'ida': allowed are two or more, each once"),
        (["--all", "--players", "ida,tom,ida"], "allowed are two or more, each once"),
        (["ida", "tom", "--game", "tennis"], "name = 'tennis': unknown"),
        (["ida", "tom", "--game", "practice"], "--game = 'practice': allowed is a game for two"),
        (["ida", "tom", "--game", "snooker", "--table", "pool-9ft"], "this table has not the balls or the rack for it"),
        (["ida", "tom", "--table", "pool-10ft"], "table = 'pool-10ft': unknown"),
        (["ida", "tom", "--matches", "0"], "--matches = 0.0: allowed is a number from 1 to 10000 matches"),
        (["ida", "tom", "--seed", "half"], "--seed = 'half': allowed is a number"),
        (["ida", "tom", "--jobs", "1.5"], "--jobs = '1.5': allowed is a whole number"),
        (["ida", "tom", "--out", ""], "--out = '': allowed is the name of a file"),
    ],
)
def test_what_is_refused(capsys: Capture, words: list[str], said: str) -> None:
    assert said in refusal(capsys, "duel", *words)
