"""Records once preset, engine, rules or machine have changed: they are shown, and gone on with, as they were."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any

import pytest

from pool2d import InputError, Layout, Rollout, Shot, Table, load_table, simulate
from pool2d.cli import main
from pool2d.config.folders import data_folder
from pool2d.game import match
from pool2d.game.actions import Stroke
from pool2d.game.match import Match, lagged
from pool2d.game.records import engine, moments
from pool2d.game.records.earlier import digest
from pool2d.game.records.engine import Identity
from pool2d.game.records.record import CHANGED, GONE, PLAYED_BY, Record, load, seal
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import (
    BY_ENGINE,
    BY_MACHINE,
    BY_RECORD,
    BY_RULES,
    UNKNOWN,
    divergences,
    replayed,
    restored,
    strokes,
    verify,
)
from pool2d.game.rules import GAMES
from pool2d.game.rules.pool import nine_ball
from pool2d.game.setup import LAG, Setup
from pool2d.physics.values import POCKETED
from pool2d.table.preset import presets
from pool2d.table.table_data import as_data, table_of

from ..random_play import new_match, random_action


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POOL2D_DATA", str(tmp_path / "data"))


def played(path: Path, game: str = "nine-ball", seed: int = 3, actions: int = 16) -> Match:
    """A match on record, some of whose actions were undone and done again."""
    rng = random.Random(seed)
    with record(new_match(game, seed, race=2), path) as recorder:
        for _ in range(actions):
            if recorder.match.over:
                break
            recorder.play(random_action(recorder.match, rng))
            if rng.random() < 0.2 and recorder.undo() and rng.random() < 0.5:
                recorder.redo()
        return recorder.match


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "a.jsonl"


def bodies(path: Path) -> list[dict[str, Any]]:
    """What the lines of a record hold besides their sums."""
    return [
        {key: value for key, value in json.loads(line).items() if key != "sum"}
        for line in path.read_text().splitlines()
    ]


def rewrite(path: Path, lines: list[dict[str, Any]]) -> Record:
    """A record with good sums, whatever it says."""
    content, total = b"", ""
    for number, body in enumerate(lines):
        line, total = seal({**body, "n": number}, total)
        content += line
    path.write_bytes(content)
    return load(path)


@pytest.fixture
def other(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Have another engine, other rules or another machine play from now on, as far as they tell."""

    def become(**parts: str) -> None:
        now = engine.identity()._replace(**parts)
        monkeypatch.setattr(engine, "identity", lambda: now)

    return become


@pytest.fixture
def faster(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Have every shot roll a little further from now on."""

    def become() -> None:
        def roll(table: Table, layout: Layout, shot: Shot) -> Rollout:
            return simulate(table.with_knobs({"cloth.mu_roll": 0.97 * table.knobs.cloth.mu_roll}), layout, shot)

        monkeypatch.setattr(match, "simulate", roll)

    return become


def stands(a: Match, b: Match) -> bool:
    """Whether two matches are the same to the bit, at every moment."""
    pairs = zip(a.history, b.history, strict=True)
    return digest(a) == digest(b) and all(moments.same(x, y) and x.action == y.action for x, y in pairs)


# The table.


@pytest.mark.parametrize("name", presets())
def test_a_table_comes_back_from_its_data(name: str) -> None:
    table = load_table(name, {"cloth.mu_roll": 0.0123, "ball.law": "frictionless"}, ["worn-cloth"])
    back = table_of(json.loads(json.dumps(as_data(table))), "record")
    assert (back.source, back.title, back.set, back.conditions) == (
        table.source,
        table.title,
        table.set,
        ("worn-cloth",),
    )
    assert (back.knobs, back.base) == (table.knobs, table.base)
    assert back.furniture == table.furniture
    # Racks and groups are also drawn from in their order.
    assert list(back.furniture.racks) == list(table.furniture.racks)
    assert list(back.furniture.groups) == list(table.furniture.groups)
    assert back.boxes() == table.boxes() and back.geometry.outline == table.geometry.outline
    assert as_data(back) == as_data(table)


@pytest.mark.parametrize(
    "change",
    [
        {"title": "a\nb"}, {"title": 3}, {"knobs": {"cloth.mu_roll": "x"}}, {"knobs": {"x": 1}}, {"knobs": None},
        {"furniture": {"spots": {}}}, {"furniture": []}, {"furniture": {"outline": [{"x": 0.0, "y": 0.0}]}},
        {"set": {"cloth.mu_roll": 9e9}}, {"conditions": "worn"},
    ],
)  # fmt: skip
def test_the_data_of_no_table_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(InputError, match=r"^record: "):
        table_of({**as_data(load_table("pool-7ft")), **change}, "record")


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


# Moments.


@pytest.mark.parametrize("game", GAMES)
@pytest.mark.parametrize("breaker", [0, LAG])
def test_every_moment_comes_back_from_its_line(game: str, breaker: int) -> None:
    try:
        played_match = new_match(game, 2, race=2)
        played_match = Match(played_match.table, replace(played_match.setup, breaker=breaker, names=()))
    except InputError:
        return  # Nobody lags alone.
    rng = random.Random(f"{game} {breaker}")
    for _ in range(30):
        now = played_match.now
        line = json.loads(json.dumps(moments.as_dict(now)))
        back = moments.moment_of(line, played_match, "line")
        assert back == replace(now, action=None, rollout=None, report=None)
        assert repr(back.layout) == repr(now.layout)
        if played_match.over:
            break
        ask = played_match.ask
        lagging = lagged(played_match.state) and ask.kind == "aim"
        stroke = Stroke(Shot(0.0, rng.uniform(1.2, 1.8), ball=ask.ball))
        played_match.play(stroke if lagging else random_action(played_match, rng))


@pytest.mark.parametrize(
    "change",
    [
        {"balls": 3}, {"balls": "cue@x"}, {"balls": ""}, {"game": None}, {"game": {"turn": "x"}}, {"game": {"luck": 1}},
        {"game": {"turn": 2}}, {"game": {"ask": 3}}, {"game": {"ask": {"kind": "aim", "who": 3}}},
        {"game": {"ask": {"kind": "aim", "who": 0, "ball": "x"}}}, {"game": {"ask": {"kind": "fly", "who": 0}}},
        {"game": {"scores": [1]}}, {"game": {"scores": [0, None]}}, {"tallies": []}, {"tallies": [{}]},
        {"tallies": [{"frames": 1.5}, {}]}, {"tallies": [{"luck": 1}, {}]}, {"turn": [0, 0]}, {"turn": [0, 0, 7]},
        {"turn": [0, 0, True]}, {"notes": 3}, {"notes": [3]}, {"notes": [{"key": 3}]}, {"notes": [{"who": 3}]},
        {"spotted": [["9"]]}, {"spotted": [["9", ["a", 1]]]}, {"points": [1]}, {"points": "12"},
    ],
)  # fmt: skip
def test_what_is_no_moment_is_refused(change: dict[str, Any]) -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = json.loads(json.dumps(moments.as_dict(game.now)))
    if isinstance(change.get("game"), dict):
        change = {"game": {**line["game"], **change["game"]}}
    with pytest.raises(InputError, match=r"^line: "):
        moments.moment_of({**line, **change}, game, "line")


def test_who_is_asked_keeps_the_name_that_records_have_for_it() -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = json.loads(json.dumps(moments.as_dict(game.now)))
    ask = line["game"]["ask"]
    assert list(ask)[:2] == ["kind", "who"] and "player" not in ask
    refused: list[tuple[dict[str, Any], str]] = [({"who": "x"}, "game.who"), ({"player": 0}, "player")]
    for change, key in refused:
        with pytest.raises(InputError, match=rf"^line: {key} = "):
            moments.moment_of({**line, "game": {**line["game"], "ask": {**ask, **change}}}, game, "line")


def test_a_note_that_this_version_has_no_words_for_is_left_out() -> None:
    game = Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0))
    line = moments.as_dict(game.now)
    back = moments.moment_of({**line, "notes": [{"key": "foul.talking"}, *line["notes"]]}, game, "line")
    assert back.ruling.notes == game.now.ruling.notes


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
    monkeypatch.setattr(match, "simulate", simulate)
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
