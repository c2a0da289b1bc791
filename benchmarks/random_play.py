"""Matches played by dice, for the benchmarks and the tests of matches and records."""

from __future__ import annotations

import random

from pool2d.game.actions import Action, Arrange, Concede, NextFrame, Stalemate, Stroke
from pool2d.game.match import Match
from pool2d.game.records.recorder import Recorder
from pool2d.game.rules import AIM, OVER, PLACE, Choice
from pool2d.game.setup import Setup

from .matches import SHORT, place, stroke, table_for


def new_match(game: str, seed: int, race: int = 1) -> Match:
    """A match that nobody has played yet."""
    return Match(table_for(game), Setup(game, SHORT.get(game, {}), race=race, seed=seed))


def random_action(match: Match, rng: random.Random) -> Action:
    """Something that may be done now."""
    ask, ruling = match.ask, match.now.ruling
    if ask.kind == OVER:
        return NextFrame()
    if rng.random() < 0.01:
        return Concede(ask.player) if rng.random() < 0.5 else Stalemate()
    if match.setup.game == "practice" and len(ruling.layout.on_table()) < 2:
        return Arrange(match.table.rack(next(iter(match.table.furniture.racks)), rng.randrange(1000)))
    if ask.kind == AIM:
        return Stroke(*stroke(match.table, ruling, rng))
    return place(match.table, ruling, rng) if ask.kind == PLACE else Choice(rng.choice(ask.options))


def go_on(recorder: Recorder, actions: int, rng: random.Random, undone: float) -> None:
    """Random actions on record, so many parts of which are undone, and half of those done again."""
    for _ in range(actions):
        if recorder.match.over:
            break
        recorder.play(random_action(recorder.match, rng))
        if rng.random() < undone and recorder.undo() and rng.random() < 0.5:
            recorder.redo()
