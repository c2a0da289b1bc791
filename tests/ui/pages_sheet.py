"""Pages and questions over a plain scene, each as it looks when there is most to be told, on one picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from unittest import mock

import pygame

from pool2d import InputError, load_table
from pool2d.config.settings import Store
from pool2d.draw import theme
from pool2d.game.drills.drill import Drill
from pool2d.game.drills.drill_file import drills as shipped_drills
from pool2d.game.drills.drill_file import load as load_drill
from pool2d.game.match import Match
from pool2d.game.setup import Setup
from pool2d.ui import window
from pool2d.ui.dialogs.dialog import Confirm, Dialog, TextPrompt
from pool2d.ui.dialogs.options import KEYS_PAGE, KeyRow, OptionsPage
from pool2d.ui.dialogs.pick import Pick
from pool2d.ui.frame import Frame
from pool2d.ui.menus import drill_list
from pool2d.ui.menus.drill_list import DrillList
from pool2d.ui.menus.ended import MatchOver
from pool2d.ui.menus.menu import MenuEntry, pause_menu
from pool2d.ui.scene import Scene
from pool2d.ui.wording.words import Words

SIZE = (1280, 720)
WRONG = "something is wrong here, and it takes so many words to say what that the line is full, and a second one too"


class Plain(Scene):
    """Nothing but a colour."""

    def __init__(self) -> None:
        self.words = Words()

    @property
    def bottom(self) -> Scene:
        return self

    def draw(self, frame: Frame) -> None:
        frame.surface.fill(theme.BACKGROUND)


def _nothing() -> Scene | None:
    return None


def match_over(below: Scene) -> Dialog:
    """A match of snooker that was won, with all that is told of both players."""
    match = Match(load_table("snooker-12ft"), Setup("snooker", names=("Ann", "Bartholomew"), breaker=0, seed=4))
    now = match.now
    tallies = tuple(
        replace(tally, points=60 + i, innings=12 - i, best=20 + i, pots=9 - i, fouls=2 + i, frames=1 - i)
        for i, tally in enumerate(now.tallies)
    )
    match._past[-1] = replace(now, tallies=tallies)
    with mock.patch.object(Match, "winner", 0):
        return MatchOver(below, match, lambda: below, lambda: below)


def prompt(below: Scene) -> Dialog:
    """A question whose answer was refused."""
    page = TextPrompt(below, "Save the table", "Name", "my table", lambda name: WRONG)
    page.wrong = WRONG
    return page


def pick(below: Scene) -> Dialog:
    """A list whose chosen name was refused."""
    page = Pick(below, "Shots", [f"name {i}" for i in range(12)], 5, "Show", lambda at: WRONG)
    page.wrong = WRONG
    return page


def pause(below: Scene) -> Dialog:
    """A menu of which one entry tells more."""
    entries = [MenuEntry(lambda: "Go on", _nothing), MenuEntry(lambda: "Leave", _nothing, lambda: ("One", "Two"))]
    return pause_menu(below, entries)


def binding(below: Scene) -> Dialog:
    """The keys: one row waits for a key, another is under the pointer, a third is held, and the last has none."""
    page = OptionsPage(below, Store())
    page._open(KEYS_PAGE)
    rows = [widget for widget in page.form.widgets if isinstance(widget, KeyRow)][:5]
    page.form.set_rows([[row] for row in rows])
    page.lay_out(SIZE)
    page.form.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=rows[1].rect.center))
    rows[0]._listen(True)
    rows[2].held, rows[2].pointer = True, rows[2].rect.center
    page.words.keys.bind(rows[4].action)
    return page


def drills(below: Scene) -> Dialog:
    """The drills, of which one cannot be read and one has been played."""
    known = iter(shipped_drills())

    def load(name: str) -> Drill:
        if name == "broken":
            raise InputError("broken.toml", "goal", 3, WRONG)
        return load_drill(name)

    names = ["broken", next(known), next(known)]
    results = {names[1]: 3}
    with mock.patch.multiple(drill_list, drills=lambda: names, load=load, best=results.get):
        return DrillList(below, mock.Mock())


def confirm(below: Scene) -> Dialog:
    return Confirm(below, "Does Ann concede the frame?", "Concede", _nothing)


PAGES: tuple[Callable[[Scene], Dialog], ...] = (match_over, prompt, pick, pause, binding, drills, confirm)


def page(make: Callable[[Scene], Dialog]) -> pygame.Surface:
    """What is on the window of a page."""
    frame = Frame(pygame.Surface(SIZE))
    shown = make(Plain())
    shown.lay_out(SIZE)
    shown.draw(frame)
    return frame.surface.subsurface(shown.form.rect.inflate(16, 16))


def splash(part: float) -> pygame.Surface:
    """What is seen before the table is."""
    surface = pygame.Surface(SIZE)
    with mock.patch.object(window, "__version__", "1.2.3"):
        window.draw_splash(surface, part)
    return surface


def pages() -> pygame.Surface:
    """All of them, one below the other."""
    pictures = [*map(page, PAGES), splash(0.6).subsurface((400, 260, 480, 240))]
    surface = pygame.Surface(
        (max(picture.get_width() for picture in pictures), sum(map(pygame.Surface.get_height, pictures)))
    )
    y = 0
    for picture in pictures:
        surface.blit(picture, (0, y))
        y += picture.get_height()
    return surface
