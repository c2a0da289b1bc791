"""Records of earlier versions, which hold no more of a moment than a digest."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from benchmarks.random_play import new_match, random_action
from pool2d import InputError, Shot, load_table
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.records.earlier import digest
from pool2d.game.records.record import PLAYED_BY, load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import (
    UNKNOWN,
    divergences,
    replayed,
    verify,
)
from pool2d.game.rules import GAMES
from pool2d.game.setup import Setup

from .record_files import bodies, played, rewrite, stands

# Records of earlier versions.

EARLIER = {"practice": "122f8cb2ba7dae8b", "eight-ball": "4556f79632c0693b", "straight-rail": "48f6db1832bc4018"}


def as_before(path: Path) -> Iterator[dict[str, Any]]:
    """The lines of a record as versions wrote them that told a table by its names, and a digest of each moment."""
    gone = {PLAYED_BY, "balls", "game", "tallies", "turn", "notes", "fouls", "spotted", "points", "fell", "lag"}
    for entry, game, _ in replayed(load(path)):
        body = {key: value for key, value in entry.data.items() if key not in gone | {"sum"}}
        if "table" in body:
            body["table"] = {key: body["table"][key] for key in ("name", "conditions", "set")}
        yield {**body, "state": digest(game)}


@pytest.mark.parametrize("game", GAMES)
def test_records_of_earlier_versions_open_and_verify(path: Path, game: str) -> None:
    before = played(path, game, actions=8)
    kept = rewrite(path, list(as_before(path)))
    assert verify(kept) is None
    assert (kept.outdated, kept.played_by) == ("", None)
    with resume(path) as again:
        assert stands(again.match, before) and again.changes == ()
        if not again.match.over:
            again.play(random_action(again.match, random.Random(5)))
        after = again.match
    assert verify(load(path)) is None
    with resume(path) as again:
        assert stands(again.match, after)


def test_a_record_whose_first_stroke_cannot_be_played_is_none_to_look_at(path: Path) -> None:
    with record(Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0)), path) as recorder:
        recorder.play(Stroke(Shot(0.0, 3.0)))
    lines = bodies(path)
    lines[1]["shot"] = "1:0.0,3.0"
    with pytest.raises(InputError, match="line 2: stroke is refused"):
        RecordedShots(rewrite(path, lines))


def test_the_digest_of_earlier_versions_is_what_it_was() -> None:
    # Worked out by the version that wrote them, of a match that nobody has played yet.
    for game, told in EARLIER.items():
        assert digest(new_match(game, 4)) == told


def test_an_earlier_record_that_no_longer_plays_is_told_as_ever(path: Path, faster: Callable[[], None]) -> None:
    played(path)
    kept = rewrite(path, list(as_before(path)))
    faster()
    found = list(divergences(kept))
    assert [one.why for one in found] == [UNKNOWN]
    assert str(found[0]).endswith("the table or pool2d has changed since")
    content = path.read_bytes()
    with pytest.raises(InputError, match="the table or pool2d has changed since"):
        resume(path)
    assert path.read_bytes() == content
