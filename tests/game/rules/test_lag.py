"""The lag by hand-written reports, clause by clause, and by strokes."""

from __future__ import annotations

from typing import NamedTuple

import pytest

from pool2d import InputError, Layout, Shot, load_table
from pool2d.game.actions import Stalemate, Stroke
from pool2d.game.match import Match, lagged
from pool2d.game.rules import AIM, CHOOSE, Choice, Ruling
from pool2d.game.rules.lag import Lag, LagState
from pool2d.game.rules.spotting import put
from pool2d.game.setup import LAG, Setup

from .notation import after, report

TABLE = load_table("pool-9ft")
BALLS = ("cue", "8")


def begun(breaker: int, lag: LagState) -> Ruling:
    raise AssertionError("nobody has chosen yet")


RULES = Lag(TABLE, begun)
# The least distance of a ball's middle from the head cushion, m.
NEAREST = TABLE.reach(TABLE.knobs.ball.radius)


class Lagged(NamedTuple):
    """A lag as a referee saw it: what the ball met, the gap it left, m, and whether it changed sides."""

    shot: str
    gap: float = 0.1
    astray: bool = False


GOOD = Lagged("{0}|right")


def lag(before: Ruling, seen: Lagged) -> Ruling:
    """The ruling after the next lag."""
    ball = before.ask.ball
    made = report(seen.shot.format(ball), cue=ball, astray=seen.astray)
    layout: Layout = after(put(before.layout, ball, (NEAREST + seen.gap, before.layout[ball].y)), made)
    assert isinstance(before.state, LagState)
    return RULES.judge(before.state, layout, made)


@pytest.mark.parametrize(
    ("seen", "note"),
    [
        (GOOD, "lag.rest"),
        (Lagged("{0}|right {0}|left"), "lag.rest"),
        (Lagged("{0}|left"), "lag.foot"),
        (Lagged(""), "lag.foot"),
        (Lagged("{0}|right {0}|left {0}|right"), "lag.foot"),
        (Lagged("{0}|right {0}>top-left"), "lag.lost"),
        (Lagged("{0}|right {0}^"), "lag.lost"),
        (Lagged("{0}|right {0}|top-left"), "lag.side"),
        (Lagged("{0}|right_jaw {0}|right"), "lag.side"),
        (Lagged("{0}|right", astray=True), "lag.astray"),
        (Lagged("{0}|right {0}-cue"), "lag.astray"),
        (Lagged("{0}|right", gap=-0.002), "lag.jaws"),
    ],
    ids=lambda value: value if isinstance(value, str) else value.shot.replace(" ", ","),
)
def test_what_makes_a_lag_bad(seen: Lagged, note: str) -> None:
    start = RULES.start(1)
    assert start.ask.kind == AIM and start.ask.player == 1 and start.ask.ball == "8"
    ruling = lag(start, seen)
    assert ruling.notes[0 if note == "lag.rest" else 1].key == note
    # Whatever came of it, the other lags next; a bad ball is taken off.
    assert (ruling.ask.player, ruling.ask.ball) == (0, "cue")
    assert ("8" in ruling.layout) == (note == "lag.rest")


def test_how_near_a_ball_has_come_is_told_in_millimetres() -> None:
    ruling = lag(RULES.start(1), Lagged("{0}|right", 0.0823))
    assert (ruling.notes[0].player, ruling.notes[0].points) == (1, 82)


@pytest.mark.parametrize(
    ("first", "second", "winner"),
    [
        (Lagged("{0}|right", 0.10), Lagged("{0}|right", 0.09), 1),
        (Lagged("{0}|right", 0.09), Lagged("{0}|right", 0.10), 0),
        (Lagged("{0}|right", 0.0), Lagged("{0}|right", 0.001), 0),
        # Too close to call: they lag again.
        (Lagged("{0}|right", 0.1000), Lagged("{0}|right", 0.1004), None),
        # A bad lag cannot win, however near.
        (Lagged("{0}|right", 2.0), Lagged("{0}|left", 0.01), 0),
        (Lagged("{0}|right {0}|top-left", 0.01), Lagged("{0}|right", 2.0), 1),
        (Lagged("", 0.01), Lagged("{0}|right {0}>", 0.02), None),
    ],
)
def test_who_wins_a_lag(first: Lagged, second: Lagged, winner: int | None) -> None:
    ruling = lag(lag(RULES.start(0), first), second)
    if winner is None:
        assert "lag.again" in [note.key for note in ruling.notes]
        assert (ruling.ask.kind, ruling.ask.player, ruling.ask.ball) == (AIM, 0, "cue")
        assert ruling.layout == RULES.start(0).layout
    else:
        assert (ruling.ask.kind, ruling.ask.player) == (CHOOSE, winner)
        assert ruling.ask.options == ("break", "give-break")


def test_the_balls_start_side_by_side_in_their_halves_behind_the_head_string() -> None:
    for name in ("pool-7ft", "english-7ft", "snooker-12ft", "carom-10ft"):
        table = load_table(name)
        layout = Lag(table, begun).start().layout
        a, b = layout.values()
        width = table.knobs.table.width
        # Wholly behind the line, and less than a ball's width from it.
        radius, line = table.body_of(a)[0], table.furniture.spots["head"][0]
        assert a.x == b.x and line - 3.0 * radius < a.x < line - radius
        assert (a.y, b.y) == (width * 0.25, width * 0.75)
        # They are as large and as heavy as each other, also where the game's balls are not.
        assert table.body_of(a) == table.body_of(b)


def match(seed: int = 4) -> Match:
    return Match(TABLE, Setup("nine-ball", names=("Ann", "Bo"), breaker=LAG, seed=seed))


def play(game: Match, *speeds: float, angle: float = 0.0) -> None:
    for speed in speeds:
        game.play(Stroke(Shot(speed=speed, angle=angle, ball=game.ask.ball)))


@pytest.mark.parametrize("key", ["break", "give-break"])
def test_who_wins_the_lag_says_who_breaks(key: str) -> None:
    game = match()
    assert lagged(game.state)
    first = game.ask.player
    play(game, 1.4, 1.6)
    assert (game.ask.kind, game.ask.player) == (CHOOSE, first)
    game.play(Choice(key))
    breaker = first if key == "break" else 1 - first
    assert not lagged(game.state)
    assert (game.ask.player, game.now.breaker, game.state.breaker) == (breaker,) * 3
    # The lag leaves no numbers behind, and the rack is the one of a match without.
    assert all(tally.strokes == tally.innings == 0 for tally in game.now.tallies)
    same = Match(TABLE, Setup("nine-ball", breaker=breaker, seed=4))
    assert game.layout == same.layout


def test_a_lag_is_undone_and_done_again() -> None:
    game = match()
    play(game, 1.4, 1.6)
    game.play(Choice("break"))
    rulings = [moment.ruling for moment in game.history]
    while game.undo():
        pass
    assert game.now.ruling == rulings[0]
    while game.redo():
        pass
    assert [moment.ruling for moment in game.history] == rulings


def test_a_ball_played_aslant_goes_astray() -> None:
    game = match()
    # Over the long string, off the foot cushion and back, by way of no side cushion.
    angle = -7.0 if game.layout[game.ask.ball].y > TABLE.knobs.table.width / 2 else 7.0
    play(game, 1.4, angle=angle)
    assert [note.key for note in game.now.ruling.notes[:2]] == ["lag.bad", "lag.astray"]


def test_a_lag_may_begin_again_by_agreement() -> None:
    game = match()
    start = game.now.ruling
    play(game, 1.4)
    game.play(Stalemate())
    assert game.layout == start.layout and game.ask == start.ask


def test_a_lag_is_refused_where_there_is_no_cushion_for_it_or_no_opponent() -> None:
    with pytest.raises(InputError, match=r"breaker = -2: a lag needs two players, and a head and a foot cushion"):
        Match(load_table("l-shape"), Setup("nine-ball", breaker=LAG))
    with pytest.raises(InputError, match=r"breaker"):
        Match(TABLE, Setup("practice", breaker=LAG))
    with pytest.raises(InputError, match=r"allowed is 0 to 1, -1 for a coin and -2 for a lag"):
        Match(TABLE, Setup("nine-ball", breaker=-3))


@pytest.mark.parametrize("key", ["break", "give-break"])
def test_a_stalemate_at_straight_pool_is_lagged_for(key: str) -> None:
    """WPA 1.13, 7: an opening break by who wins the lag, or the opponent; the scores stay."""
    game = Match(TABLE, Setup("straight", breaker=1, seed=4))
    play(game, 0.5)
    assert game.state.scores == (0, -2)
    game.play(Choice("accept"))
    racked = game.layout
    game.play(Stalemate())
    assert lagged(game.state)
    assert (game.ask.player, game.state.scores, game.now.shooter) == (1, (0, -2), -1)
    # A stalemate in a lag is no way round it.
    game.play(Stalemate())
    assert (lagged(game.state), game.state.scores) == (True, (0, -2))
    play(game, 1.4, 1.4)
    assert (game.ask.player, game.state.scores) == (1, (0, -2)), "two lags alike are lagged again"
    play(game, 1.4, 1.6)
    game.play(Choice(key))
    player = 1 if key == "break" else 0
    assert not lagged(game.state)
    assert (game.ask.player, game.ask.where, game.now.breaker, game.state.scores) == (
        player,
        "kitchen",
        player,
        (0, -2),
    )
    assert game.state.opening  # type: ignore[attr-defined]
    assert len(game.layout.on_table()) == 16
    assert game.layout != racked
    assert game.now.frame == 0


def test_without_cushions_for_a_lag_who_broke_breaks_again() -> None:
    game = Match(load_table("l-shape"), Setup("straight", breaker=1))
    game.play(Stalemate())
    assert (lagged(game.state), game.ask.player, game.ask.where) == (False, 1, "kitchen")
