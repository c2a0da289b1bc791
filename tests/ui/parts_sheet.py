"""Parts of the window by themselves, in every way they can look: scoreboards, notes, time lines, the cue's diagrams."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import pygame

from pool2d import Ball, Layout, Shot, load_table, simulate
from pool2d.draw import theme
from pool2d.game.aim import Aim
from pool2d.game.match import Match, Moment
from pool2d.game.setup import Setup
from pool2d.ui.screen import Screen
from pool2d.ui.stage import bars, scoreboard
from pool2d.ui.stage.playback import Playback
from pool2d.ui.stage.timeline import Timeline
from pool2d.ui.toasts import Toasts
from pool2d.ui.wording.words import Words

SCREEN = Screen(1280, 720)
# Games whose standing is told each in its own way, and the tables for them.
GAMES = {
    "eight-ball": "pool-9ft", "straight": "pool-9ft", "one-pocket": "pool-9ft", "snooker": "snooker-12ft",
    "three-cushion": "carom-10ft",
}  # fmt: skip
# What a game's state may hold of its players.
STANDING: dict[str, Any] = {
    "scores": (47, 8), "fouls": (2, 1), "groups": ("solids", "stripes"), "pockets": ("bottom-left", "top-right"),
    "innings": (3, 12), "left": 51, "turn": 1,
}  # fmt: skip


def standing(match: Match, player: int, over: bool = False) -> Moment:
    """A moment in the middle of a frame, a player's turn."""
    ruling = match.now.ruling
    known = {field.name for field in fields(ruling.state)}
    state: Any = replace(ruling.state, **{name: value for name, value in STANDING.items() if name in known})
    state = replace(state, ask=replace(state.ask, player=player, kind="over" if over else state.ask.kind))
    tallies = tuple(replace(tally, frames=2 - i, run=1 + 2 * i) for i, tally in enumerate(match.now.tallies))
    return replace(match.now, ruling=ruling._replace(state=state), tallies=tallies)


def scoreboards() -> pygame.Surface:
    """In turn and out of it, in single frames and matches, and beside the tray where a record is shown."""
    words = Words()
    strips = []
    for game, table in GAMES.items():
        for race, player in ((1, 0), (3, 1)):
            match = Match(load_table(table), Setup(game, names=("Ann", "Bartholomew"), race=race, breaker=0, seed=4))
            for kind in ("own", "over", "beside"):
                strip = pygame.Surface((SCREEN.width, SCREEN.top.height))
                moment = standing(match, player, over=kind == "over")
                if kind == "beside":
                    scoreboard.draw_beside(strip, words, SCREEN, match, moment, 1 - player)
                else:
                    scoreboard.draw(strip, words, SCREEN, match, moment)
                strips.append(strip)
    return _below_each_other(strips)


def notes() -> pygame.Surface:
    """Notes sliding in, there, one of something wrong, one of several lines."""
    surface = pygame.Surface((640, 360))
    toasts = Toasts()
    toasts.say("A picture was saved")
    toasts.say(
        "Something is wrong here, and it takes so many words to say what it is that they go on below", wrong=True
    )
    toasts.update(0.2)
    toasts.say("Late")
    toasts.update(0.1)
    toasts.draw(surface)
    return surface


def controls() -> pygame.Surface:
    """The bars with aims of all kinds: off the middle, past where the tip slips, the butt raised, soft and hard."""
    words = Words()
    aims = (
        (Aim(), 0.0, 0.6), (Aim(33.3, side=0.3, height=-0.2, elevation=5.0), 3.0, 0.6),
        (Aim(359.999, side=-0.5, height=0.45, elevation=45.0), 10.0, 0.6), (Aim(elevation=80.0), 12.0, 1e9),
    )  # fmt: skip
    strips = []
    for aim, speed, friction in aims:
        whole = pygame.Surface((SCREEN.width, SCREEN.height))
        bars.draw_bars(whole, SCREEN, "A table", "A note")
        bars.draw_controls(whole, words, SCREEN, aim, speed, friction)
        said = "What is said goes on for longer than the room that is left for it. " * 4
        bars.draw_message(whole, SCREEN, said if aim.side else "Said.", theme.TEXT, 90 if aim.side > 0.0 else 0)
        strips.append(whole.subsurface(SCREEN.bottom))
    return _below_each_other([whole.subsurface(SCREEN.top), *strips])


def time_lines() -> pygame.Surface:
    """A shot that runs, one held on an event, and one at its end; the pointer on a button, on a mark and off both."""
    screen, table = Screen(2560, 1440), load_table("pool-9ft")
    shot = Shot(speed=2.0)
    rollout = simulate(table, Layout([Ball("cue", 0.6, 0.6), Ball("1", 1.2, 0.62)]), shot)
    strips = []
    for kind in ("runs", "held", "ended"):
        surface = pygame.Surface((screen.width, screen.height))
        shown, line = Playback(rollout, shot, again=True), Timeline(Words())
        line.place(screen, 0 if kind == "runs" else 700)
        if kind == "runs":
            shown.change_rate(-2)
            shown.update(1.0)
            line.hover = line.button("begin").center
        elif kind == "held":
            shown.step(1)
            shown.step(1)
            line.hover = (round(line.x_of(rollout.events[3].t, shown)) + 3, line.track.centery + 9)
        else:
            shown.seek(shown.end)
            shown.change_rate(2)
        line.draw(surface, shown, table)
        strips.append(surface.subsurface(screen.bottom))
    return _below_each_other(strips)


def _below_each_other(strips: list[pygame.Surface]) -> pygame.Surface:
    surface = pygame.Surface((strips[0].get_width(), sum(strip.get_height() for strip in strips)))
    y = 0
    for strip in strips:
        surface.blit(strip, (0, y))
        y += strip.get_height()
    return surface
