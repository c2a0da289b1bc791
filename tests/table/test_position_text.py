"""Positions as text: what is written reads back to the bit, and noise gets one line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from pool2d import Ball, InputError, Layout, Shot, load_scenario, load_table
from pool2d.cli import main
from pool2d.physics.values import OFF, POCKETED, RESTING
from pool2d.table.position_text import Position, read, read_shot, write, write_shot

from ..scenes import random_shot

names = st.text(min_size=1, max_size=12).filter(lambda name: name.isprintable() and name.strip() == name)
places = st.floats(-100.0, 100.0)
balls = st.builds(
    Ball,
    id=names,
    x=places,
    y=places,
    **dict.fromkeys(("vx", "vy", "wx", "wy", "wz", "z", "vz"), st.just(0.0)),
    phase=st.sampled_from([RESTING, POCKETED, OFF]),
    radius=st.none() | st.floats(0.01, 0.06),
    mass=st.none() | st.floats(0.01, 2.0),
)
layouts = st.lists(balls, max_size=22, unique_by=lambda ball: ball.id).map(Layout)
shots = st.builds(
    Shot,
    angle=st.floats(-3600.0, 3600.0),
    speed=st.floats(0.0, 50.0),
    side=st.floats(-0.7, 0.7),
    height=st.floats(-0.7, 0.7),
    elevation=st.floats(0.0, 90.0),
    ball=names,
    easy=st.booleans(),
    jump=st.booleans(),
)


def bits(layout: Layout) -> list[str]:
    """Every bit of the balls, in their order: also the sign of a zero."""
    return [repr(tuple(ball)) for ball in layout.values()]


@given(layouts, st.none() | shots)
def test_what_is_written_reads_back_to_the_bit(layout: Layout, shot: Shot | None) -> None:
    text = write(layout, shot)
    assume(text)
    assert text.isprintable()
    back = read(text)
    assert bits(back.layout) == bits(layout)
    assert repr(back.shot) == repr(shot)
    assert write(back.layout, back.shot) == text


@given(shots)
def test_a_shot_reads_back_to_the_bit(shot: Shot) -> None:
    assert repr(read_shot(write_shot(shot))) == repr(shot)


def test_a_table_goes_with_it() -> None:
    table = load_table("pool-7ft", {"cloth.mu_roll": 0.0125, "ball.law": "frictionless"}, ["heated", "dirty-balls"])
    layout = table.rack("eight-ball", 3)
    back = read(write(layout, table=table))
    assert (back.table, back.conditions, back.set) == (table.source, table.conditions, table.set)
    same = load_table(back.table, back.set, back.conditions)
    assert same.knobs == table.knobs
    assert bits(same.settle(back.layout)) == bits(layout)


def test_it_is_short_and_plain() -> None:
    layout = Layout(
        [Ball("cue", 0.635, 0.3175), Ball("8", 2.6, 1.3, phase=POCKETED), Ball("my ball", 1.0, 1.0, mass=0.2)]
    )
    text = write(layout, Shot(12.5, 3.0, side=0.2))
    assert text == "cue@0.635,0.3175 8@2.6,1.3! my%20ball@1.0,1.0,m0.2 cue:12.5,3.0,0.2"
    assert write_shot(Shot(12.5, 3.0, easy=True)) == "cue:12.5,3.0,easy"
    assert write_shot(Shot(12.5, 3.0, easy=True, jump=True)) == "cue:12.5,3.0,easy,jump"
    assert read_shot("cue:12.5,3.0,jump") == Shot(12.5, 3.0, jump=True)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("   ", "empty"),
        ("pool-9ft pool-8ft", "word = 'pool-8ft': allowed are a table"),
        ("cue@1", "y is ''; allowed is a number from -100 to 100 m"),
        ("cue@1,nan", "y is 'nan'"),
        ("cue@1,1e999", "y in cue@1,1e999 = inf"),
        ("cue@1_0,1", "x is '1_0'"),
        ("cue@1,٣", "y is '٣'"),
        ("cue@1,1,z3", "and then r and a radius"),
        ("cue@1,1,r0.03,r0.03", "and then r and a radius"),
        ("cue@1,1,r3", "radius in cue@1,1,r3 = 3.0: allowed is a number from 0.01"),
        ("cue@1,1 cue@2,1", "this ball is there already"),
        ("cue@1,1 cue:1,2 cue:1,2", "there is a shot already"),
        ("cue:1", "allowed is ball:angle,speed"),
        ("cue:1,2,3,4,5,6", "allowed is ball:angle,speed"),
        ("cue:easy", "allowed is ball:angle,speed"),
        ("cue:1,easy", "allowed is ball:angle,speed"),
        ("cue:1,easy,2", "allowed is ball:angle,speed"),
        ("cue:1,2,jump,easy", "allowed is ball:angle,speed"),
        ("cue:jump", "allowed is ball:angle,speed"),
        ("cue:1,2,eas", "allowed is ball:angle,speed"),
        ("cue:1,60", "shot.speed = 60.0: allowed is a number from 0 to 50 m/s"),
        ("cue:1,2,0.9,0.9", "the tip is off the ball"),
        ("@1,1", "a name is missing"),
        ("%ff@1,1", "a name is missing or cannot be read"),
        ("%0a@1,1", "a name is missing or cannot be read"),
        ("pool-9ft".ljust(200_001), "longer than 200000 characters"),
    ],
)
def test_what_is_wrong_is_told(text: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        read(text, "clipboard")
    assert str(caught.value).startswith("clipboard: ")
    assert words in str(caught.value)
    assert str(caught.value).isprintable()


def test_as_long_as_is_allowed_it_is_read() -> None:
    assert read("pool-9ft".ljust(200_000)).table == "pool-9ft"


@given(st.text() | st.text(alphabet="cue1@:=,.!+-%0 reinfa"))
@example("a=@:")
@example("cue@1,1,m")
def test_noise_is_refused_or_read(text: str) -> None:
    for reader in (read, read_shot):
        try:
            reader(text)
        except InputError as error:
            assert str(error).isprintable()


def test_a_scenario_file_takes_a_position(tmp_path: Path) -> None:
    table = load_table("pool-8ft", {"cloth.mu_roll": 0.013})
    layout, shot = random_shot(table, 5)
    path = tmp_path / "s.toml"
    path.write_text(f'position = "{write(layout, shot, table)}"')
    scenario = load_scenario(path)
    assert scenario.table.knobs == table.knobs
    assert scenario.simulate().digest() == table_digest(layout, shot)
    path.write_text('table = "pool-9ft"\nposition = "pool-8ft cue@1,1 cue:1,2"\nballs = [{id = "1", x = 2, y = 1}]')
    scenario = load_scenario(path)
    assert (scenario.table.source, list(scenario.layout), scenario.shot) == ("pool-9ft", ["cue", "1"], Shot(1.0, 2.0))
    for text, words in (
        ("position = 3", "position = 3: allowed is a text"),
        ('position = "1@1,1 cue:1,2"', "shot.ball"),
    ):
        path.write_text(text)
        with pytest.raises(InputError, match=words):
            load_scenario(path)


def table_digest(layout: Layout, shot: Shot) -> str:
    import pool2d

    return pool2d.simulate(load_table("pool-8ft", {"cloth.mu_roll": 0.013}), layout, shot).digest()


def test_simulate_takes_a_position(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["simulate", "--json", "--position", "pool-9ft cue@0.6,0.6 1@1.9,0.6 cue:5,1"]
    assert main([*words, "--shot", "cue:0,3"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["events"][0]["after"]["cue"]["vy"] == 0.0
    assert main(words) == 0
    assert json.loads(capsys.readouterr().out)["events"][0]["after"]["cue"]["vy"] > 0.0


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["--position", "cue@9"], "--position: word = 'cue@9'"),
        (["--position", "cue@9,9"], "balls.cue.x, y = (9.0, 9.0): the ball is off the table"),
        (["--position", "pool-9 cue@1,1"], "did you mean pool-9ft?"),
        (["--position", "cue@1,1", "--shot", "1:2,3"], "shot.ball = '1': unknown; known are cue"),
        (["--shot", "cue:1,2"], "allowed are scenario files, or --position and --shot"),
        (["--position", "cue@1,1", "some.toml"], "not both"),
        ([], "allowed are scenario files"),
    ],
)
def test_bad_positions_on_the_command_line(words: list[str], line: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", *words]) == 2
    told = capsys.readouterr()
    assert (told.out, told.err.count("\n")) == ("", 1)
    assert line in told.err


def test_an_empty_position_is_a_value() -> None:
    assert Position() == Position(Layout(), None, "", (), {})
