"""Player files: what they say is what plays; what is wrong in them is said in one line, and saving loses nothing."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from pool2d import InputError
from pool2d.config.assets import asset
from pool2d.config.catalogue import PLAYERS, shipped
from pool2d.opponent.player import Judgement, Rates, Taste
from pool2d.opponent.player_file import load_player, player_names, save_measured
from pool2d.opponent.stray import Hand

ANN = """# Plays on Sundays.
name = "Ann"
title = "C"
rank = 30
words.en = "Hello."
words.de = "Guten Tag."

[hand]
aim = 2.5  # a little more on Mondays

[judgement]
ways = 2

[taste]
pace = 6
"""
DATA = "POOL2D_DATA"


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the user's own players."""
    monkeypatch.setenv(DATA, str(tmp_path))
    (tmp_path / PLAYERS).mkdir()
    return tmp_path / PLAYERS


def written(folder: Path, text: str = ANN, name: str = "ann") -> str:
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_a_file_says_what_plays(tmp_path: Path) -> None:
    ann = load_player(written(tmp_path))
    assert (ann.name, ann.title, ann.rank, ann.words.en, ann.words.de) == ("Ann", "C", 30.0, "Hello.", "Guten Tag.")
    assert (ann.hand, ann.judgement, ann.taste) == (Hand(aim=2.5), Judgement(ways=2.0), Taste(pace=6.0))
    assert ann.measured == Rates()


def test_without_a_name_a_player_is_called_as_the_file(tmp_path: Path) -> None:
    assert load_player(written(tmp_path, "", "bo")).name == "bo"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[hand]\naimm = 2", "hand.aimm = 2: unknown; did you mean hand.aim?"),
        ("[hand]\naim = 99", "hand.aim = 99: allowed is a number from 0 to 50"),
        ("[judgement]\nruns = 'many'", "judgement.runs = 'many': allowed is a number from 0 to 200"),
        ("words.fr = 'Salut.'", "words.fr = 'Salut.': unknown; did you mean words.en?"),
        ("words = 3", "words = 3: unknown"),
        ("name = 3", "name = 3: allowed is a text of up to 40 characters"),
        ("name = ' '", "name = ' ': allowed is a text of 1 to 40 characters"),
        ("[hand]\n[hand]", "not a TOML file"),
        ("[hand.aim]", "hand.aim = {}: allowed is a number from 0 to 50"),
        ("[measured]\npots = -1", "measured.pots = -1: allowed is a number from 0 to 100 %"),
    ],
)
def test_what_is_wrong_is_said_in_a_line(tmp_path: Path, text: str, said: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(InputError) as told:
        load_player(path)
    assert str(told.value).startswith(f"{path}: {said}")
    assert "\n" not in str(told.value)


def test_an_unknown_name_is_told_with_the_nearest() -> None:
    with pytest.raises(InputError, match=r"player: player = 'gretta': unknown; did you mean greta\?"):
        load_player("gretta")


def test_the_users_own_are_among_the_others_by_rank(home: Path) -> None:
    written(home)
    written(home, "rank = 101", "broken")
    names = player_names()
    assert set(names) == {*shipped(PLAYERS), "ann", "broken"}
    # Whoever cannot be read comes last, whatever it says.
    assert names[-1] == "broken"
    ranks = [load_player(name).rank for name in names[:-1]]
    assert ranks == sorted(ranks)
    assert load_player("ann").name == "Ann"


def test_at_least_eight_are_shipped_and_all_say_something() -> None:
    players = [load_player(name) for name in shipped(PLAYERS)]
    assert len(players) >= 8
    assert all(player.title and player.words.en and player.words.de for player in players)
    assert len({player.name for player in players}) == len({player.rank for player in players}) == len(players)


def test_the_stronger_stray_less_and_see_more() -> None:
    people = [player for player in map(load_player, player_names()) if player.title != "machine"]
    for weaker, stronger in pairwise(people):
        assert stronger.hand.aim < weaker.hand.aim
        assert stronger.judgement.runs > weaker.judgement.runs
        assert stronger.judgement.ways >= weaker.judgement.ways
    assert load_player(player_names()[-1]).hand.steady


@pytest.mark.parametrize(
    ("before", "kept"),
    [
        (ANN, ANN),
        (ANN.replace("[judgement]", "[measured]\npots = 3\n\n[judgement]"), ANN),
        (ANN.replace("rank = 30", "rank = 30\nmeasured.pots = 3"), ANN),
        ("", ""),
    ],
)
def test_saving_what_was_measured_keeps_the_rest(tmp_path: Path, before: str, kept: str) -> None:
    path = written(tmp_path, before)
    found = Rates("2026-11-27", "pool2d players --measure ann", 31.0, 42.0, 1.5, 5.0, 0.3, 12.0)
    for measured in (found, Rates("2026-11-28")):
        save_measured(path, measured)
        assert load_player(path).measured == measured
        assert Path(path).read_text(encoding="utf-8").startswith(kept)


def test_shipped_files_are_found_where_assets_are() -> None:
    assert load_player("ida") == load_player(str(asset(PLAYERS, "ida.toml")))
