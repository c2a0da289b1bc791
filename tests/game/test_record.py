"""Records: to the bit, through kills and damage."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.random_play import new_match
from pool2d import InputError, Shot, load_table
from pool2d.cli import main
from pool2d.game.actions import Stroke
from pool2d.game.match import Match
from pool2d.game.records.record import load, matches_folder, seal
from pool2d.game.records.recorder import record, resume, unfinished
from pool2d.game.records.replaying import BY_RECORD, Divergence, restored, strokes, verify
from pool2d.game.rules import GAMES
from pool2d.game.setup import Setup, setup_of

from .record_files import played_on

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """What a record of a few actions holds."""
    path = tmp_path_factory.mktemp("good") / "a.jsonl"
    with record(new_match("nine-ball", 3), path) as recorder:
        played_on(recorder, 8, seed=3)
    return path.read_bytes()


@pytest.mark.parametrize("game", GAMES)
def test_a_record_verifies_and_is_gone_on_with(game: str) -> None:
    with record(new_match(game, 2, race=2)) as recorder:
        played_on(recorder, 14, seed=1)
        before = recorder.match
    assert verify(load(recorder.path)) is None
    with resume(recorder.path) as again:
        assert again.match.now.ruling == before.now.ruling
        assert again.match.now.tallies == before.now.tallies
        assert [moment.action for moment in again.match.history] == [moment.action for moment in before.history]
        played_on(again, 4, seed=9)
    assert verify(load(recorder.path)) is None


def test_the_table_is_kept() -> None:
    table = load_table("pool-8ft", {"cloth.mu_roll": 0.0125, "ball.law": "frictionless"}, ["heated"])
    with record(Match(table, Setup("nine-ball", names=("Ann", "Bob"), race=7))) as recorder:
        recorder.play(Stroke(Shot(0.0, 5.0)))
    kept = load(recorder.path)
    assert kept.setup == recorder.match.setup
    assert kept.table().knobs == table.knobs
    assert verify(kept) is None


def test_a_stroke_tells_whether_it_was_an_easy_one() -> None:
    with record(new_match("practice", 1)) as recorder:
        recorder.play(Stroke(Shot(10.0, 1.0)))
        recorder.play(Stroke(Shot(20.0, 1.0, elevation=3.0, easy=True)))
    kept = load(recorder.path)
    assert [entry.data["shot"] for entry in kept.entries] == ["cue:10.0,1.0", "cue:20.0,1.0,0.0,0.0,3.0,easy"]
    assert verify(kept) is None
    assert restored(kept).match.now.action == recorder.match.now.action


def test_what_was_undone_stays() -> None:
    with record(new_match("practice", 1)) as recorder:
        recorder.play(Stroke(Shot(10.0, 1.0)))
        recorder.undo()
        assert not recorder.undo()
        recorder.play(Stroke(Shot(20.0, 1.0)))
    kept = load(recorder.path)
    assert [entry.data["do"] for entry in kept.entries] == ["stroke", "undo", "stroke"]
    seen = list(strokes(kept))
    assert [take.number for take in seen] == [1, 2]
    assert [take.line for take in seen] == [2, 4]
    assert [take.moment.action for take in seen] == [Stroke(Shot(10.0, 1.0)), Stroke(Shot(20.0, 1.0))]
    assert seen[0].moment.rollout is not None
    assert len(restored(kept).match.history) == 2


def test_a_torn_line_is_dropped_on_resuming_only(good: bytes, tmp_path: Path) -> None:
    path = tmp_path / "torn.jsonl"
    whole = good.count(b"\n")
    for cut in range(good.index(b"\n") + 1, len(good), 37):
        path.write_bytes(good[:cut])
        lines = good[:cut].count(b"\n")
        if good[cut - 1 : cut] != b"\n":
            with pytest.raises(InputError, match=f"line {lines + 1}: the file is cut off within this line"):
                load(path)
            assert path.read_bytes() == good[:cut]
        resume(path).close()
        assert path.read_bytes() == b"".join(good.splitlines(keepends=True)[:lines])
    assert whole > 5


def refused(path: Path, content: bytes) -> str:
    """The one line that a damaged record gets from `replay --verify`, the file being left as it is."""
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        resume(path)
    assert path.read_bytes() == content
    return str(caught.value).removeprefix(str(path))


def test_damage_is_told_apart(good: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bad.jsonl"
    lines = good.splitlines(keepends=True)
    swapped = [*lines[:3], lines[4], lines[3], *lines[5:]]
    edited = good.replace(b'"do":"stroke"', b'"do":"strike"', 1)
    cases = {
        b"": ", line 1: not a record of pool2d",
        b"noise\nand more": ", line 1: not a record of pool2d",
        b"noise\n": ", line 1: not a record of pool2d",
        b"[1, 2]\n": ", line 1: not a record of pool2d",
        b'{"a": 1}\n': ", line 1: not a record of pool2d",
        b"\xff\xfe\x00\n" + good: ", line 1: not a record of pool2d",
        lines[0][:-20]: ", line 1: the file is cut off within this line",
        b"".join(swapped): ", line 4: n = 4: allowed is 3; lines are missing or not in their order",
        b"".join(lines[:2] + lines[3:]): ", line 3: n = 3: allowed is 2; lines are missing",
        b"".join(lines[:2] + lines[1:]): ", line 3: n = 1: allowed is 2",
        edited: ", line 2: sum = '",
        good.replace(b'"race":1', b'"race":9'): ", line 1: sum = '",
        lines[0] + b"noise\n": ", line 2: not a line of a record",
        lines[0] + b"[" * 100_000 + b"\n": ", line 2: not a line of a record",
        good.replace(b'"pool2d":1', b'"pool2d":2'): ", line 1: pool2d = 2: allowed is format 1",
        good.replace(b'"pool2d":1', b'"pool2d":"1"'): ", line 1: not a record of pool2d",
    }
    for content, words in cases.items():
        assert refused(path, content).startswith(words)
        assert main(["replay", str(path), "--verify"]) == 2
        told = capsys.readouterr()
        assert (told.out, told.err.count("\n")) == ("", 1)
        assert words in told.err


def sealed(*bodies: dict[str, Any]) -> bytes:
    """A record with good sums, whatever it says."""
    content, total = b"", ""
    for number, body in enumerate(bodies):
        line, total = seal({**body, "n": number}, total)
        content += line
    return content


def bodies(content: bytes) -> list[dict[str, Any]]:
    found = [json.loads(line) for line in content.splitlines()]
    for body in found:
        del body["sum"]
    return found


def test_a_change_with_good_sums_diverges(good: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "changed.jsonl"
    first, *rest = bodies(good)
    stroke = next(i for i, body in enumerate(rest) if body["do"] == "stroke")

    def diverges(header: dict[str, Any], **change: Any) -> Divergence:
        lines = [dict(body) for body in rest]
        lines[stroke].update(change)
        path.write_bytes(sealed(header, *lines))
        found = verify(load(path))
        assert found is not None
        assert found.why == BY_RECORD
        before = path.read_bytes()
        with pytest.raises(InputError, match=f"line {found.line}: .*the record has been changed since"):
            resume(path)
        assert path.read_bytes() == before
        return found

    assert diverges(first, digest="0").what == "the shot does not roll as recorded after this stroke"
    assert diverges(first, state="0").what == "the game does not stand as recorded after this stroke"
    assert diverges(first, shot="cue:1.5,3.0").line == stroke + 2
    assert "is refused" in diverges(first, shot="1:1.5,3.0").what
    with pytest.raises(InputError, match=f"^{path}, line {stroke + 2}: stroke is refused: "):
        list(strokes(load(path)))
    assert "is refused" in diverges(first, do="redo").what
    assert "is refused" in diverges(first, do="jump").what
    assert diverges({**first, "state": "0"}) == Divergence(1, "the balls do not start as recorded", BY_RECORD)
    assert main(["replay", str(path), "--verify"]) == 1
    assert capsys.readouterr().out.startswith(f"{path}: line 1: the balls do not start as recorded; what played it is")


@pytest.mark.parametrize(
    "change",
    [
        {"setup": 3}, {"setup": {"game": "chess"}}, {"setup": {"race": "x"}}, {"setup": {"names": [1, 2]}},
        {"table": 3}, {"table": {"name": "nowhere", "conditions": [], "set": {}}}, {"table": {"name": "pool-9ft"}},
        {"table": {"name": "pool-9ft", "conditions": [3], "set": {}}},
        {"table": {"name": "pool-9ft", "conditions": [], "set": {"cloth.mu_roll": "x"}}},
        {"table": {"name": "pool-9ft", "conditions": [], "set": {"x": 1}}},
    ],
)  # fmt: skip
def test_headers_of_noise_are_refused(
    good: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str], change: dict[str, Any]
) -> None:
    path = tmp_path / "bad.jsonl"
    first, *rest = bodies(good)
    path.write_bytes(sealed({**first, **change}, *rest))
    assert main(["replay", str(path), "--verify"]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    for lost in ("setup", "table", "state"):
        path.write_bytes(sealed({key: value for key, value in first.items() if key != lost}, *rest))
        with pytest.raises(InputError, match="line 1: the header is not whole"):
            load(path)


@st.composite
def damaged(draw: st.DrawFn, content: bytes) -> bytes:
    """A record with bytes changed, lost, doubled or put in."""
    at, size = draw(st.integers(0, len(content) - 1)), draw(st.integers(0, 400))
    put = draw(st.binary(max_size=20) | st.just(content[at : at + size]))
    return content[:at] + put + content[at + draw(st.integers(0, size)) :]


def test_no_damage_goes_unseen(good: bytes, tmp_path: Path) -> None:
    path = tmp_path / "damaged.jsonl"

    @given(st.data())
    def check(data: st.DataObject) -> None:
        content = data.draw(damaged(good))
        path.write_bytes(content)
        try:
            kept = load(path, torn=True)
        except InputError as error:
            assert str(error).isprintable()
            return
        # What is left of it is the beginning of the good one.
        assert good.startswith(content[: kept.size])
        assert content[: kept.size].endswith(b"\n")

    check()


@pytest.mark.parametrize("names", [[1, 2], [None, "Bo"]])
def test_a_record_of_players_without_names_is_told(tmp_path: Path, names: list[object]) -> None:
    data = new_match("nine-ball", 1).setup.as_dict() | {"names": names}
    with pytest.raises(InputError, match="names"):
        setup_of(data, "record")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"do": "stroke", "shot": "cue:0,5", "call": {"nosuch": None}}, "call.nosuch = None: allowed are ball, pocket"),
        ({"do": "stroke", "shot": "cue:0,5", "call": {"ball": None}}, "call.ball = None: allowed are ball, pocket"),
        ({"do": "stroke", "shot": "cue:0,5", "call": None}, "call = None: allowed is a dict"),
        ({"do": "\ud800"}, "do = '\\ud800': allowed is a text of printable characters"),
        ({"do": "concede", "player": 10**30}, "player = 1"),
        ({"do": "stroke", "shot": "cue:0,5", "call": {"ball": "\x00"}}, "call.ball = '\\x00': allowed is a text"),
    ],
)
def test_a_line_with_strange_values_is_told_in_one_line(
    tmp_path: Path, good: bytes, capsys: pytest.CaptureFixture[str], change: dict[str, Any], words: str
) -> None:
    path = tmp_path / "a.jsonl"
    path.write_bytes(sealed(bodies(good)[0], {"n": 1, **change, "state": "0"}))
    for more in ("--list", "--verify"):
        status = main(["replay", str(path), more])
        out, err = capsys.readouterr()
        assert status in (1, 2)
        assert words in out + err
        assert (out + err)[:-1].isprintable()


@pytest.mark.parametrize("name", ["a\x00", "\u202eeve", "x" * 50_000, "\ud800", "  ", "a\nb"])
def test_a_record_whose_players_cannot_be_shown_is_damaged(tmp_path: Path, good: bytes, name: str) -> None:
    head = bodies(good)[0]
    head["setup"]["names"][0] = name
    path = matches_folder() / "a.jsonl"
    path.parent.mkdir(parents=True)
    path.write_bytes(sealed(head))
    with pytest.raises(InputError, match="allowed is a text of "):
        load(path)
    assert unfinished() == []
