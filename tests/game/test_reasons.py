"""Why a stroke was played: a value that is kept in records to the bit, and judged by nobody."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pool2d import InputError, Shot, load_table
from pool2d.game import Fear, Match, Reasons, Setup, Stroke, Thought
from pool2d.game.actions import as_dict, from_dict
from pool2d.game.records.record import load
from pool2d.game.records.recorder import record, resume
from pool2d.game.records.replaying import strokes, verify
from pool2d.game.rules import Note
from pool2d.game.rules.report import Call

from .record_files import bodies, rewrite

SHARES = st.floats(0.0, 1.0)
TEXTS = st.sampled_from(["", "3", "red7", "top-right"])
SHOTS = st.builds(Shot, st.floats(-360.0, 360.0), st.floats(0.0, 12.0), st.floats(-0.5, 0.5), jump=st.booleans())
PLACES = st.none() | st.tuples(st.floats(-1.0, 3.0), st.floats(-1.0, 3.0))
THOUGHTS = st.builds(
    Thought, st.sampled_from(["pot", "safety", "hope"]), SHOTS, TEXTS, TEXTS, SHARES, st.floats(-200.0, 200.0),
    st.integers(0, 200), SHARES, SHARES, PLACES,
)  # fmt: skip
NOTES = st.builds(Note, st.sampled_from(["foul.scratch", "fear.missed", "fear.left"]), st.integers(-1, 1), TEXTS)
REASONS = st.builds(
    Reasons,
    THOUGHTS,
    st.lists(THOUGHTS, max_size=3).map(tuple),
    st.lists(st.builds(Fear, NOTES, SHARES), max_size=3).map(tuple),
)

WHY = Reasons(
    Thought("pot", Shot(12.3, 2.1, 0.1), "3", "top-right", 0.7, 0.55, 30, 0.1, 0.3, (0.6, 0.4)),
    (Thought("safety", Shot(170.0, 1.2), "5", chance=1.0, value=-0.5),),
    (Fear(Note("foul.scratch"), 0.1), Fear(Note("fear.left", 1), 0.2)),
)


@given(REASONS)
def test_reasons_come_back_from_json_to_the_bit(why: Reasons) -> None:
    stroke = Stroke(Shot(1.0, 2.0), Call("3", "top-right"), why)
    assert from_dict(json.loads(json.dumps(as_dict(stroke), allow_nan=False)), "a") == stroke


def test_a_stroke_without_reasons_says_nothing_of_them() -> None:
    assert "why" not in as_dict(Stroke(Shot(1.0, 2.0)))
    assert from_dict(as_dict(Stroke(Shot(1.0, 2.0))), "a") == Stroke(Shot(1.0, 2.0))


def changed(path: str, value: object) -> dict[str, Any]:
    """A stroke's line with one value of its reasons changed, found by keys and numbers with dots between them."""
    line: dict[str, Any] = json.loads(json.dumps(as_dict(Stroke(Shot(1.0, 2.0), why=WHY))))
    *way, last = path.split(".")
    inner: Any = line
    for step in way:
        inner = inner[int(step) if step.isdigit() else step]
    inner[last] = value
    return line


@pytest.mark.parametrize(
    ("path", "value", "told"),
    [
        ("why", [], "why = []: allowed is a dict"),
        ("why", None, "why = None: allowed is a dict"),
        ("why.kind", "plot", "why.kind = 'plot': unknown; did you mean pot?"),
        ("why.kind", 3, "why.kind = 3: allowed is a str"),
        ("why.chanse", 0.5, "why.chanse = 0.5: unknown; did you mean chance?"),
        ("why.chance", 1.5, "why.chance = 1.5: allowed is a number from 0 to 1"),
        ("why.chance", 1, "why.chance = 1: allowed is a float"),
        ("why.fouls", -0.1, "why.fouls = -0.1: allowed is a number from 0 to 1"),
        ("why.lost", "x", "why.lost = 'x': allowed is a float"),
        ("why.value", True, "why.value = True: allowed is a float"),
        ("why.runs", 2.0, "why.runs = 2.0: allowed is a int"),
        ("why.ball", 3, "why.ball = 3: allowed is a str"),
        ("why.shot", "cue", "why.shot = 'cue': allowed is ball:angle,speed,side,height,elevation"),
        ("why.place", [0.5], "why.place = [0.5]: allowed are x and y, in m"),
        ("why.place", ["a", "b"], "why.place = ['a', 'b']: allowed are x and y, in m"),
        ("why.others", {}, "why.others = {}: allowed is a list"),
        ("why.others.0", 3, "why.others = 3: allowed is a dict"),
        ("why.others.0.kind", "x", "why.others.kind = 'x': unknown"),
        ("why.others.0.others", [], "why.others.others = []: unknown"),
        ("why.fears.0.share", 7.0, "why.fears.share = 7.0: allowed is a number from 0 to 1"),
        ("why.fears.0.key", 7, "why.fears = {'key': 7}: allowed are notes, of key, player, ball"),
        ("why.fears.0.more", 7, "allowed are notes, of key, player, ball"),
    ],
)
def test_what_is_no_reason_is_told_by_its_key(path: str, value: object, told: str) -> None:
    if path.startswith("why.others.0") and path.count(".") == 2:
        line = changed("why.others", [value])
    else:
        line = changed(path, value)
    with pytest.raises(InputError) as error:
        from_dict(line, "a.jsonl")
    assert told in str(error.value) and str(error.value).startswith("a.jsonl: ")


@pytest.mark.parametrize("name", ["kind", "shot"])
def test_a_thought_needs_its_kind_and_its_shot(name: str) -> None:
    line = as_dict(Stroke(Shot(1.0, 2.0), why=WHY))
    del line["why"][name]
    with pytest.raises(InputError, match=rf"why\.{name} = None: allowed is a str"):
        from_dict(line, "a.jsonl")


def test_a_fear_that_a_later_version_has_words_for_is_left_out() -> None:
    read = from_dict(changed("why.fears.0.key", "fear.of-the-dark"), "a")
    assert isinstance(read, Stroke) and read.why is not None
    assert read.why.fears == WHY.fears[1:]


def played(path: Path, *strokes: Stroke) -> Match:
    with record(Match(load_table("pool-9ft"), Setup("nine-ball", breaker=0, seed=3)), path) as recorder:
        for stroke in strokes:
            recorder.play(stroke)
        return recorder.match


def test_a_record_keeps_why_and_judges_nothing_by_it(tmp_path: Path) -> None:
    break_shot = Shot(0.4, 8.0)
    match = played(tmp_path / "a.jsonl", Stroke(break_shot, why=WHY))
    plain = played(tmp_path / "b.jsonl", Stroke(break_shot))
    assert match.now.state == plain.now.state and match.layout == plain.layout
    kept = load(tmp_path / "a.jsonl")
    assert verify(kept) is None
    (shot,) = strokes(kept)
    assert shot.moment.action == Stroke(break_shot, why=WHY)
    with resume(tmp_path / "a.jsonl") as again:
        assert again.match.now.action == Stroke(break_shot, why=WHY)
    lines = [bodies(tmp_path / name)[1] for name in ("a.jsonl", "b.jsonl")]
    assert lines[0].pop("why") == WHY.as_dict()
    assert lines[0] == lines[1]


def test_verifying_looks_at_no_reasons(tmp_path: Path) -> None:
    played(tmp_path / "a.jsonl", Stroke(Shot(0.4, 8.0), why=WHY))
    lines = bodies(tmp_path / "a.jsonl")
    lines[1]["why"]["chance"] = 0.123
    assert verify(rewrite(tmp_path / "a.jsonl", lines)) is None
    del lines[1]["why"]
    assert verify(rewrite(tmp_path / "a.jsonl", lines)) is None


def test_a_record_with_no_reasons_at_all_in_their_place_is_told_by_its_line(tmp_path: Path) -> None:
    played(tmp_path / "a.jsonl", Stroke(Shot(0.4, 8.0), why=WHY))
    lines = bodies(tmp_path / "a.jsonl")
    lines[1]["why"]["chance"] = 7.0
    found = verify(rewrite(tmp_path / "a.jsonl", lines))
    assert found is not None and found.line == 2
    assert "why.chance = 7.0: allowed is a number from 0 to 1" in found.what
