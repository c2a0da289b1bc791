"""The scenes that `docs.pictures` draws: a hand brings the window to each. A new scene is one line of SCENES."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pygame

from pool2d import Ball, Shot
from pool2d.config.catalogue import TABLES, shipped
from pool2d.game.actions import Stroke
from pool2d.game.drills.drill_file import load as load_drill
from pool2d.game.match import Match
from pool2d.game.reasons import Fear, Reasons, Thought
from pool2d.game.records.record import load
from pool2d.game.records.recorded_shots import RecordedShots
from pool2d.game.records.recorder import record
from pool2d.game.rules import Note
from pool2d.game.session import Session
from pool2d.game.setup import LAG, Setup
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.scene import Scene
from pool2d.ui.widgets.inputs import Slider
from tests.ui.conftest import FRAME, Hand


class PictureScene(NamedTuple):
    """What a picture shows, in words, how a hand gets there, and on which table."""

    caption: str
    go: Callable[[Hand], None]
    table: str = "pool-9ft"


# A position in the middle of a game: a cut on the 3 into the side pocket is on.
MIDDLE = (
    Ball("cue", 0.72, 0.42), Ball("3", 1.02, 0.98), Ball("5", 1.93, 0.79), Ball("8", 2.02, 0.30),
    Ball("9", 0.33, 0.88), Ball("11", 1.52, 0.22), Ball("14", 2.31, 1.04), Ball("15", 1.46, 0.71),
)  # fmt: skip


def middle(hand: Hand) -> None:
    """The position, with a cut aimed."""
    hand.set_balls(*MIDDLE)
    hand.point(0.983, 0.937)


def pulling(hand: Hand) -> None:
    """The cue drawn back, with english."""
    middle(hand)
    for _ in range(6):
        hand.key(pygame.K_d)
    hand.press()
    hand.pull(0.16 * hand.play.stage.screen.measure)


def breaking(hand: Hand, after: float = 0.62) -> None:
    """A break, so many seconds after the stroke began."""
    hand.point(2.4, 0.637)
    for _ in range(60):
        hand.key(pygame.K_UP)
    hand.key(pygame.K_SPACE)
    run(hand, after)


def whole(hand: Hand) -> None:
    """The guide that shows all of a shot."""
    middle(hand)
    hand.key(pygame.K_g)


def arrows(hand: Hand) -> None:
    """A shot under way, with the arrows of speed and spin."""
    middle(hand)
    for _ in range(8):
        hand.key(pygame.K_w)
    hand.key(pygame.K_v)
    hand.key(pygame.K_SPACE)
    run(hand, 0.5)


def line(hand: Hand) -> None:
    """A shot held, the pointer on an event of its time line."""
    breaking(hand)
    hand.key(pygame.K_p)
    for _ in range(3):
        hand.key(pygame.K_RIGHT)
    shown = hand.play.state.playback
    assert shown is not None
    hand.move((hand.play.controller.timeline.x_of(shown.time, shown), hand.play.controller.timeline.track.centery))


def tuned(hand: Hand) -> None:
    """The panel of knobs, one of them turned: what the shot did before is seen faintly."""
    middle(hand)
    for _ in range(60):
        hand.key(pygame.K_UP)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_t)
    hand.app.step(0.0)
    assert hand.play.controller.tuning_panel is not None
    slider = next(widget for widget in hand.play.controller.tuning_panel.form.widgets if isinstance(widget, Slider))
    hand.move((slider.rect.left + slider.rect.width * 0.8, slider.rect.bottom - 1.5 * hand.play.stage.screen.unit))
    hand.press()
    hand.release()


def placing(hand: Hand) -> None:
    """The cue ball in hand, over a place where it has room."""
    hand.set_balls(*MIDDLE, in_hand=True)
    hand.point(0.62, 0.62)


def near(hand: Hand) -> None:
    """The rack from nearer."""
    hand.point(1.9, 0.637)
    for _ in range(5):
        hand.key(pygame.K_PLUS)
    run(hand, 1.0)


def geometry(hand: Hand) -> None:
    """What pymunk holds: noses, jaws and pockets."""
    middle(hand)
    hand.key(pygame.K_b)


def keys_page(hand: Hand) -> None:
    """The options' page of keys."""
    hand.key(pygame.K_o)
    for _ in range(4):
        hand.key(pygame.K_RIGHT)


def german(hand: Hand) -> None:
    """The same words in German, and a palette for those who confuse red and green."""
    hand.app.store.turn("screen.language", "de")
    hand.app.store.turn("balls.palette", "colour-blind")
    hand.app.store.turn("balls.patterned", True)
    middle(hand)


def rest(hand: Hand) -> None:
    """A table as it is when the window opens."""
    width, height = hand.play.state.session.table.knobs.table.length, hand.play.state.session.table.knobs.table.width
    hand.point(0.8 * width, 0.5 * height)


def match(hand: Hand, game: str = "eight-ball", speed: float = 9.5) -> Session:
    """A match, its break played and ruled on."""
    setup = Setup(game, names=("Ann", "Bob"), race=3, breaker=0, seed=4)
    session = Session(Match(hand.play.state.session.table, setup))
    hand.app.scene = hand.app.lobby.begin(session)
    hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(speed).toward(1.0, 0.004)
    hand.strike()
    return session


def lag(hand: Hand) -> None:
    """The second ball is on its way back."""
    setup = Setup("nine-ball", names=("Ann", "Bob"), race=3, breaker=LAG, seed=4)
    session = Session(Match(hand.play.state.session.table, setup))
    hand.app.scene = hand.app.lobby.begin(session)
    for speed in (1.42, 1.46):
        hand.point(2.0, session.cue.y)
        hand.play.state.hands.aim = hand.play.state.hands.aim.with_speed(speed)
        hand.strike() if session.strokes == 0 else hand.key(pygame.K_SPACE)
    run(hand, 3.5)


def choosing(hand: Hand) -> None:
    """The opponent may choose what follows a break that was too soft."""
    match(hand, speed=1.0)


def new_match(hand: Hand) -> None:
    """The first entry of the menu."""
    scene(hand, lambda hand: hand.app.lobby.menu())
    hand.key(pygame.K_RETURN)


def calling(hand: Hand) -> None:
    """The second player calls a pocket."""
    session = match(hand)
    pocket = session.table.geometry.pockets[0]
    hand.point(pocket.x, pocket.y)
    hand.press()
    hand.release()
    one = session.layout[session.ask.on[0]]
    hand.point(one.x, one.y)


def snooker(hand: Hand) -> None:
    """A frame of snooker: the cue ball in hand, in the D."""
    session = Session(Match(hand.play.state.session.table, Setup("snooker", names=("Ann", "Bob"), breaker=0, seed=4)))
    hand.app.scene = hand.app.lobby.begin(session)
    red = session.layout[session.ask.on[0]]
    hand.point(red.x, red.y + 0.03)


def ended(hand: Hand) -> None:
    """The end of a frame."""
    session = match(hand)
    session.concede(0)
    end = hand.app.lobby.ended()
    assert end is not None
    hand.app.scene = end


def drill(hand: Hand) -> None:
    """A drill: its goal is marked on the cloth."""
    hand.app.scene = hand.play.drill(load_drill("follow"), hand.play)
    hand.app.step(FRAME)
    ball = hand.play.state.session.layout["1"]
    hand.point(ball.x, ball.y)


def scene(hand: Hand, make: Callable[[Hand], Scene]) -> None:
    """Another screen over the table."""
    hand.app.scene = make(hand)
    hand.app.redraw()


# What one who breaks as the match below begins, and pots the 1 then, may have thought of it.
WHY = Reasons(
    Thought("pot", Shot(-147.19, 2.58, 0.0, -0.45, 2.4), "1", "bottom-left", 0.95, 0.59, 20, 0.0, 0.05),
    (Thought("pot", Shot(-148.36, 1.2, 0.3, 0.0, 1.6), "1", "bottom-left", 1.0, 0.57, 20),
     Thought("safety", Shot(-146.6, 1.0, 0.0, 0.0, 1.6), "1", "", 0.9, 0.55, 20, 0.1, 0.9)),
    (Fear(Note("fear.missed", ball="1"), 0.05),),
)  # fmt: skip
BREAK = Stroke(Shot(0.3, 9.0))
STROKES = (BREAK, *(Stroke(shot) for shot in (Shot(62.0, 4.0), Shot(-30.0, 5.0), Shot(200.0, 4.5))))


def why(hand: Hand) -> None:
    """A stroke of a recorded match, and why it was played."""
    replay(hand, strokes=(BREAK, Stroke(Shot(-147.27, 2.66, 0.01, -0.43, 2.5), why=WHY)))
    hand.key(pygame.K_PAGEDOWN)
    hand.key(pygame.K_h)


def replay(hand: Hand, key: int = 0, strokes: tuple[Stroke, ...] = STROKES) -> None:
    """A recorded match, a shot of which is shown; `key` is pressed then."""
    folder = Path(tempfile.mkdtemp(prefix="pool2d-"))
    match = Match(hand.play.state.session.table, Setup("nine-ball", names=("Ann", "Bob"), race=3, breaker=0, seed=11))
    with record(match, folder / "match.jsonl") as recorder:
        for stroke in strokes:
            if match.ask.kind == "aim":
                recorder.play(stroke)
    app, shots = hand.app, RecordedShots(load(folder / "match.jsonl"))
    shown = Replay(shots, app.words, hand.play, app.store, app.sounds)
    hand.app.scene = shown
    run(hand, 1.0)
    if key:
        hand.key(key)


def run(hand: Hand, seconds: float) -> None:
    """Let time pass."""
    for _ in range(round(seconds / FRAME)):
        hand.app.step(FRAME)


SCENES: dict[str, PictureScene] = {
    "play": PictureScene("Aiming: the guide is a short run of the simulation", middle),
    "pulling": PictureScene("Drawing the cue back: the distance is the speed", pulling),
    "rolling": PictureScene("A break: trails of light show where the balls have been", breaking),
    "whole-guide": PictureScene("G: the guide for the whole shot", whole),
    "arrows": PictureScene("V: speed, roll and spin of every ball", arrows),
    "time-line": PictureScene("P: a shot held, gone through event by event", line),
    "tuning": PictureScene("T: every knob, and what it does to the last shot", tuned),
    "in-hand": PictureScene("The cue ball in hand", placing),
    "near": PictureScene("Ctrl and the wheel: from nearer", near),
    "geometry": PictureScene("B: the geometry that the physics sees", geometry),
    "options": PictureScene("O: the options", lambda hand: hand.key(pygame.K_o)),
    "keys": PictureScene("Every key can be bound", keys_page),
    "help": PictureScene("F1: what keys and hands do", lambda hand: hand.key(pygame.K_F1)),
    "german": PictureScene("In German, with colours and patterns for colour-blind eyes", german),
    "menu": PictureScene("The menu", lambda hand: scene(hand, lambda hand: hand.app.lobby.menu())),
    "new-match": PictureScene("A new match", new_match),
    "lag": PictureScene("A lag: who comes nearer to the head cushion chooses who breaks", lag),
    "choice": PictureScene("After a break that was too soft: what may be chosen", choosing),
    "call": PictureScene("A pocket is called by a click", calling),
    "snooker": PictureScene("Snooker: the cue ball in the D", snooker, "snooker-12ft"),
    "pause": PictureScene("Esc: the pause", lambda hand: scene(hand, lambda hand: hand.app.lobby.pause())),
    "frame-over": PictureScene("The end of a frame", ended),
    "drills": PictureScene("F2: drills, each with a goal", lambda hand: hand.key(pygame.K_F2)),
    "drill": PictureScene("A drill: where the cue ball has to come to rest", drill),
    "replay": PictureScene("`pool2d replay`: a recorded match", replay),
    "replay-shots": PictureScene("G lists its shots", lambda hand: replay(hand, pygame.K_g)),
    "why": PictureScene("H says why it was played: what was meant, what else was looked at, what was feared", why),
    **{f"table-{name}": PictureScene(f"`--table {name}`", rest, name) for name in shipped(TABLES)},
}
