"""Records once preset, engine, rules or machine have changed: they are shown, and gone on with, as they were."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from benchmarks.random_play import random_action
from pool2d import InputError, Layout, Shot, Table, load_table, simulate
from pool2d.cli import main
from pool2d.config.folders import data_folder
from pool2d.game import judging
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.records import engine, moments
from pool2d.game.records.earlier import digest
from pool2d.game.records.record import CHANGED, GONE, PLAYED_BY, load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import (
    BY_ENGINE,
    BY_MACHINE,
    BY_RECORD,
    BY_RULES,
    divergences,
    restored,
    strokes,
    verify,
)
from pool2d.game.rules.pool import nine_ball
from pool2d.game.setup import Setup
from pool2d.physics.values import POCKETED

from .record_files import bodies, played, rewrite, stands


def own_preset(mu_roll: float = 0.01, cue: str = "") -> Path:
    """A preset of the player's own."""
    path = data_folder() / "tables" / "mine.toml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'name = "Mine"\nbase = "pool-8ft"\n[cloth]\nmu_roll = {mu_roll}\n{cue}')
    return path


@pytest.mark.parametrize("lost", [True, False])
def test_a_match_goes_on_on_the_table_that_it_had(path: Path, lost: bool, capsys: pytest.CaptureFixture[str]) -> None:
    preset = own_preset()
    with record(Match(load_table("mine"), Setup("nine-ball", breaker=0)), path) as recorder:
        recorder.play(Stroke(Shot(0.3, 7.0)))
        before = recorder.match
    assert load(path).outdated == ""
    if lost:
        preset.unlink()
    else:
        own_preset(0.02, "[balls]\ncue = 'white'\n")
    kept = load(path)
    assert kept.outdated == (GONE if lost else CHANGED)
    assert kept.table().knobs == before.table.knobs
    with resume(path) as again:
        assert stands(again.match, before)
        assert (again.changes, again.outdated) == ((), kept.outdated)
        again.match.table.settle(again.match.layout)
        again.play(random_action(again.match, random.Random(1)))
    assert verify(load(path)) is None
    assert next(take.same for take in strokes(load(path)))
    assert main(["replay", str(path), "--verify"]) == 0
    told = capsys.readouterr().out
    assert "as recorded" in told and ("not there any more" if lost else "its preset has changed since") in told


def test_the_table_is_written_once(path: Path) -> None:
    played(path)
    assert ["table" in body for body in bodies(path)] == [True] + [False] * (len(bodies(path)) - 1)


# Another engine.


def test_a_later_engine_shows_and_goes_on_with_what_was_recorded(
    path: Path, faster: Callable[[], None], other: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    before = played(path)
    as_it_was = list(strokes(load(path)))
    faster()
    other(engine="later")
    kept = load(path)
    found = list(divergences(kept))
    assert found and {one.why for one in found} == {BY_ENGINE}
    assert main(["replay", str(path), "--verify"]) == 1
    told = capsys.readouterr().out
    assert f"line {found[0].line}: the shot does not roll as recorded" in told
    assert "the engine has changed since" in told and f"and {len(found) - 1} lines more" in told
    for take, old in zip(strokes(kept), as_it_was, strict=True):
        assert take.before.layout == old.before.layout
        assert moments.same(take.moment, old.moment)
        assert take.moment.ruling == old.moment.ruling
        if take.same:
            continue
        # Nothing is shown that was not recorded: the balls before the shot, and after it.
        assert take.found is not None and take.found.why == BY_ENGINE
        assert take.rollout.at(0.0) == take.before.layout
        end = take.rollout.layout()
        assert {ball.id: ball for ball in end.on_table()} == {ball.id: ball for ball in old.moment.layout.on_table()}
        assert take.moment.report is not None and old.moment.report is not None
        assert take.moment.report.pots == old.moment.report.pots
    with resume(path) as again:
        assert stands(again.match, before)
        assert again.changes == (BY_ENGINE,)
        again.play(random_action(again.match, random.Random(9)))
        ahead = again.match
    # What the later engine has played is laid to it, and plays again.
    assert [body.get(PLAYED_BY, [""])[0] for body in bodies(path)][-1] == "later"
    assert [one.line for one in divergences(load(path))] == [one.line for one in found]
    with resume(path) as once_more:
        assert stands(once_more.match, ahead)
        assert once_more.match.undo() and stands_as(once_more.match, before)


def test_who_plays_is_written_where_it_is_another(path: Path, other: Callable[..., None]) -> None:
    played(path, actions=4)
    first = engine.identity().engine
    for turn, name in enumerate(("later", "later", "last", "last", "later", "later")):
        other(engine=name)
        with resume(path) as again:
            again.play(random_action(again.match, random.Random(turn)))
            again.play(random_action(again.match, random.Random(turn)))
    told = [body[PLAYED_BY][0] for body in bodies(path) if PLAYED_BY in body]
    assert told == [first, "later", "last", "later"]


def stands_as(a: Match, b: Match) -> bool:
    return digest(a) == digest(b)


def test_an_earlier_engine_lays_to_the_later_one_what_that_has_played(
    path: Path, faster: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    played(path, actions=6)
    with monkeypatch.context() as patch:
        now = engine.identity()._replace(engine="later")
        patch.setattr(engine, "identity", lambda: now)
        faster()
        with resume(path) as again:
            again.play(Stroke(Shot(20.0, 3.0))) if again.match.ask.kind == "aim" else None
            again.play(random_action(again.match, random.Random(2)))
    monkeypatch.setattr(judging, "simulate", simulate)
    assert restored(load(path)).changes in ((BY_ENGINE,), ())


@pytest.mark.parametrize(("part", "why"), [("engine", BY_ENGINE), ("machine", BY_MACHINE), ("rules", BY_RECORD)])
def test_a_shot_that_rolls_otherwise_is_laid_to_what_has_changed(
    path: Path, faster: Callable[[], None], other: Callable[..., None], part: str, why: str
) -> None:
    played(path)
    faster()
    other(**{part: "other"})
    found = verify(load(path))
    assert found is not None and found.why == why
    if why == BY_RECORD:
        with pytest.raises(InputError, match="the record has been changed since"):
            resume(path)
    else:
        resume(path).close()


def test_other_rules_are_told_and_the_match_stands_as_it_was_judged(
    path: Path, other: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = played(path, actions=10)
    judge = nine_ball.NineBall.judge

    def harsh(self: Any, state: Any, layout: Layout, report: Any) -> Any:
        ruling = judge(self, state, layout, report)
        return ruling._replace(state=replace(ruling.state, fouls=(2, 2)))

    monkeypatch.setattr(nine_ball.NineBall, "judge", harsh)
    other(rules="later")
    found = verify(load(path))
    assert found is not None and found.why == BY_RULES and found.what.startswith("the game does not stand")
    again = restored(load(path))
    assert again.changes == (BY_RULES,)
    assert stands(again.match, before)
    # The shot itself rolls as ever, and is shown.
    assert all(take.same for take in strokes(load(path)))
    assert all(x.report == y.report for x, y in zip(again.match.history, before.history, strict=True))


def test_an_action_that_later_rules_refuse_is_believed(
    path: Path, other: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = played(path, actions=10)

    def refuse(self: Match, action: Any) -> Any:
        raise InputError("match", "action", "any", "allowed is none")

    monkeypatch.setattr(Match, "play", refuse)
    other(rules="later")
    again = restored(load(path))
    assert again.changes == (BY_RULES,)
    assert stands(again.match, before)
    assert len(RecordedShots(load(path)).played) == 1


def test_a_rack_that_is_set_up_otherwise_starts_as_recorded(
    path: Path, other: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = played(path, actions=3)
    rack = Table.rack
    monkeypatch.setattr(Table, "rack", lambda self, name, seed=0, *more: rack(self, name, seed + 1, *more))
    other(engine="later")
    again = restored(load(path))
    assert stands(again.match, before)
    assert next(divergences(load(path))).what == "the balls do not start as recorded"


def test_what_has_changed_nothing_is_not_told(path: Path, other: Callable[..., None]) -> None:
    before = played(path)
    other(engine="later", rules="later", machine="other")
    assert verify(load(path)) is None
    again = restored(load(path))
    assert again.changes == () and stands(again.match, before)


def test_a_changed_line_is_told_from_a_changed_engine(
    path: Path, faster: Callable[[], None], other: Callable[..., None], capsys: pytest.CaptureFixture[str]
) -> None:
    played(path)
    lines = bodies(path)
    last = max(i for i, body in enumerate(lines) if body.get("do") == "stroke")
    lines[last]["balls"] = lines[last]["balls"].replace("cue@", "cue@1", 1)
    faster()
    other(engine="later")
    found = [one for one in divergences(rewrite(path, lines)) if one.why == BY_RECORD]
    assert [one.line for one in found] == [last + 1]
    assert main(["replay", str(path), "--verify"]) == 1
    assert f"line {last + 1}: the game does not stand as recorded" in capsys.readouterr().out
    with pytest.raises(InputError, match="the record has been changed since"):
        resume(path)


@pytest.mark.parametrize("key", ["balls", "game", "tallies", "turn"])
def test_a_moment_that_was_changed_with_its_stamp_is_told_while_the_engine_is_the_same(path: Path, key: str) -> None:
    played(path, actions=4)
    lines = bodies(path)
    body = lines[1]
    body[key] = {
        "balls": body["balls"].replace("cue@", "cue@0.1,0.1 x@", 1),
        "game": {**body["game"], "shots": 99},
        "tallies": [{**one, "points": one["points"] + 1} for one in body["tallies"]],
        "turn": [body["turn"][0], 7, body["turn"][2]],
    }[key]
    body["state"] = moments.stamp(body)
    found = verify(rewrite(path, lines))
    assert found is not None and (found.line, found.why) == (2, BY_RECORD)


def test_a_ball_that_fell_is_seen_to_fall_where_it_did(
    path: Path, faster: Callable[[], None], other: Callable[..., None]
) -> None:
    for seed in range(40):
        path.unlink(missing_ok=True)
        before = played(path, seed=seed, actions=6)
        fell = [m for m in before.history if m.report is not None and m.report.pots]
        if fell:
            break
    faster()
    other(engine="later")
    after = restored(load(path)).match.history
    seen = 0
    for old, new in zip(before.history, after, strict=True):
        if old.report is None or new.rollout is None or new.rollout.digest() == old.rollout.digest():  # type: ignore[union-attr]
            continue
        drops = [event for event in new.rollout.events if event.kind == "ball_pocket"]
        assert {event.balls[0] for event in drops} <= {
            ball.id for ball in new.layout.values() if ball.phase == POCKETED
        }
        wanted = [(pot.ball, pot.pocket) for pot in old.report.pots if new.layout[pot.ball].phase == POCKETED]
        assert [(e.balls[0], e.where) for e in drops if e.balls[0] in dict(wanted)] == wanted
        seen += len(wanted)
    assert seen


def test_the_strokes_before_a_line_that_cannot_be_played_are_all_there_are(path: Path) -> None:
    played(path, actions=12)
    lines = bodies(path)
    third = [body for body in lines if body.get("do") == "stroke"][2]
    third["shot"] = third["shot"].replace("cue", "9")
    shots = RecordedShots(rewrite(path, lines))
    assert len(shots) > 2 and not shots.complete and shots.fault is None
    last = shots[len(shots) - 1]
    assert (len(shots), last.number, shots.complete) == (2, 2, True)
    assert shots.fault is not None and shots[99] is last
