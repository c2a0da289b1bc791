"""Random hands at the whole window: `python -m benchmarks.monkey [--events 20000] [--seed 0]`.

Keys of several layouts, clicks, drags, the wheel, typed text of every kind, files that are dropped, the focus lost and
gained and windows from one pixel to those of a large screen come as they please, over the table and over every menu;
now and then a match of another game begins. Nothing may be raised, and frames of a running shot have to look as if
all of it had been drawn anew. Prints what was wrong with the events that led to it; the exit status is 1 if
anything was.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import tempfile
import traceback
from collections import Counter, deque
from typing import Any

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame

from benchmarks.matches import SHORT, table_for
from pool2d import load_table
from pool2d.config.settings import Store
from pool2d.draw.balls import ball_skin
from pool2d.game.rules import GAMES
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.ui.app import App
from pool2d.ui.frame import Frame
from pool2d.ui.play.play import Play
from pool2d.ui.replay.replay_scene import Replay
from pool2d.ui.stage.bars import CachedBars
from pool2d.ui.window import canvas
from pool2d.ui.wording.keyboard import PLACES
from pool2d.ui.wording.keys import CTRL, DEFAULTS

SIZE = (960, 540)
# Sizes that a window may be dragged to, and for how many events it stays so.
SIZES = ((1, 1), (960, 2), (2, 540), (160, 90), (159, 91), (640, 360), (300, 900), (1920, 1080), (3840, 2160))
STAYS = 12
# The letters that keyboards give in the places of a US keyboard's a to z.
LAYOUTS = (
    "abcdefghijklmnopqrstuvwxyz", "qbcdefghijkl,noparstuvzxyw", "abcdefghijklmnopqrstuvwxzy",
    "фисвуапршолдьтщзйкыегмцчня", "αβψδεφγηιξκλμνοπ;ρστθωςχυζ", "ضصثقفغعهخحجدشسيبلاتنمكطئءؤ",
)  # fmt: skip
# What may be typed or pasted: letters, signs, nothing, and what has no picture, no width, no end.
TEXTS = (
    *"abc19.-", "ß", "é", "\u0301", "漢字", "🎱", "\u200b", "\u202e", "\x00", "\x1b[31m", "\n", "\ud800", "", " ",
    "0" * 400, "wide" * 20_000, "../../x", "con", "nan", "1e400",
)  # fmt: skip
# What may be dropped on the window.
DROPPED = ("", "/", "nowhere.toml", "match.jsonl", "\udcff.toml", "a" * 5000)
# A match begins every so many events.
PITCH = 250
# What every menu understands, more often than the rest.
COMMON = (
    pygame.K_RETURN, pygame.K_ESCAPE, pygame.K_TAB, pygame.K_SPACE, pygame.K_DELETE, pygame.K_UP, pygame.K_DOWN,
    pygame.K_LEFT, pygame.K_RIGHT, pygame.K_1, pygame.K_2, pygame.K_3,
)  # fmt: skip
# What leaves the window or writes pictures.
SPARED = ("quit", "fullscreen", "screenshot")
GAMES_PLAYED = [name for name in GAMES if name != "practice"]


class Monkey:
    """Hands that do anything, the same for the same seed."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        # New racks are drawn from here.
        random.seed(seed)
        self.app = App(load_table("pool-9ft"), seed=seed, size=SIZE, store=Store.open(), menu=True)
        self.keys = [key for action, keys in DEFAULTS.items() if action not in SPARED for key in keys]
        self.keys += 3 * COMMON
        self.last: deque[str] = deque(maxlen=30)
        self.seen: Counter[str] = Counter()
        self.compared = 0
        # What is done, and how often, of 100.
        doing = {
            self.key: 32, self.place_key: 3, self.move: 25, self.click: 15, self.wheel: 5, self.type: 5, self.wait: 10,
            self.leave: 2, self.cover: 1, self.drop: 1, self.lay: 0.5, self.resize: 0.5,
        }  # fmt: skip
        self.hands, self.often = list(doing), list(doing.values())
        self.letters = LAYOUTS[0]
        # How many events the window stays of another size than its own.
        self.size_left = 0

    def act(self, number: int) -> None:
        """Do one thing, and look at the window."""
        if number % PITCH == 0:
            self.begin(number)
        self.seen[type(self.app.scene).__name__] += 1
        kind = self.rng.choices(self.hands, self.often)[0]
        kind()
        if self.size_left:
            self.size_left -= 1
            if not self.size_left:
                self.resize(SIZE)
        if self.app.scene is None:
            self.app.scene = self.app.lobby.menu()
        self.compare()

    def begin(self, seed: int) -> None:
        game = self.rng.choice(GAMES_PLAYED)
        breaker, race = self.rng.choice((-2, -1, 0, 1)), self.rng.choice((1, 2))
        setup = Setup(game, SHORT.get(game, {}), race=race, breaker=breaker, seed=seed)
        self.last.append(f"match of {game}")
        self.app.scene = self.app.lobby.begin(recorded(table_for(game), setup))

    def post(self, kind: int, **fields: Any) -> None:
        self.last.append(f"{pygame.event.event_name(kind)} {fields}")
        pygame.event.post(pygame.event.Event(kind, **fields))
        self.app.step(1.0 / 60.0)

    def place(self) -> tuple[int, int]:
        """Somewhere on the window, or a little beside it, as a drag may end."""
        width, height = self.app.window.surface.get_size()
        beside = 5 if self.rng.random() < 0.05 else 0
        return self.rng.randrange(-beside, width + beside), self.rng.randrange(-beside, height + beside)

    def key(self) -> None:
        key = self.rng.choice(self.keys)
        key, mod = (key - CTRL, pygame.KMOD_CTRL) if CTRL <= key < 2 * CTRL else (key, 0)
        self.post(pygame.KEYDOWN, key=key, mod=mod, unicode="")
        self.post(pygame.KEYUP, key=key, mod=mod)

    def place_key(self) -> None:
        """A letter key, told with its place and what the layout gives there."""
        at = self.rng.randrange(26)
        for kind in (pygame.KEYDOWN, pygame.KEYUP):
            self.post(kind, key=ord(self.letters[at]), mod=0, unicode=self.letters[at], scancode=pygame.KSCAN_A + at)

    def move(self) -> None:
        self.post(pygame.MOUSEMOTION, pos=self.place(), rel=(0, 0), buttons=(0, 0, 0))

    def click(self) -> None:
        """A click or a drag; sometimes another button is let go than was pressed."""
        at, button = self.place(), self.rng.choice((1, 1, 1, 2, 3))
        self.post(pygame.MOUSEBUTTONDOWN, pos=at, button=button)
        if self.rng.random() < 0.5:
            at = self.place()
            self.post(pygame.MOUSEMOTION, pos=at, rel=(0, 0), buttons=(1, 0, 0))
        self.post(pygame.MOUSEBUTTONUP, pos=at, button=self.rng.choice((button, button, 1)))

    def wheel(self) -> None:
        self.post(pygame.MOUSEWHEEL, x=0, y=self.rng.choice((-1, 1)), flipped=False)

    def type(self) -> None:
        self.post(pygame.TEXTINPUT, text=self.rng.choice(TEXTS))
        if self.rng.random() < 0.1:
            self.post(pygame.TEXTEDITING, text=self.rng.choice(TEXTS), start=0, length=1)

    def wait(self) -> None:
        dt = self.rng.choice((1.0 / 60.0, 0.1, 1.0, 3.0))
        self.last.append(f"{dt:.3f} s")
        self.app.step(dt)

    def leave(self) -> None:
        """The window is left, sometimes with a button or a key held, and perhaps come back to."""
        if self.rng.random() < 0.3:
            self.post(pygame.MOUSEBUTTONDOWN, pos=self.place(), button=self.rng.choice((1, 2, 3)))
        if self.rng.random() < 0.3:
            self.post(pygame.KEYDOWN, key=self.rng.choice(COMMON), mod=0, unicode="")
        self.post(pygame.WINDOWFOCUSLOST)
        if self.rng.random() < 0.7:
            self.post(pygame.WINDOWFOCUSGAINED)

    def drop(self) -> None:
        """Files or text dragged here from elsewhere."""
        self.post(pygame.DROPBEGIN)
        for _ in range(self.rng.choice((1, 1, 3))):
            self.post(pygame.DROPFILE, file=self.rng.choice(DROPPED))
        self.post(pygame.DROPTEXT, text=self.rng.choice(TEXTS))
        self.post(pygame.DROPCOMPLETE)

    def lay(self) -> None:
        """Another keyboard layout."""
        self.letters = self.rng.choice(LAYOUTS)
        self.app.words.keys.keyboard.read = self.read  # type: ignore[method-assign]
        self.post(pygame.KEYMAPCHANGED)

    def read(self) -> None:
        """Tell the app of the layout, as a system would that has it."""
        given = dict(zip(range(pygame.KSCAN_A, pygame.KSCAN_A + 26), map(ord, self.letters), strict=True))
        self.app.words.keys.keyboard.codes = {us: given.get(place, us) for place, us in PLACES.items()}

    def resize(self, size: tuple[int, int] | None = None) -> None:
        """Drag the window to another size, for a while."""
        self.size_left = STAYS if size is None else 0
        size = size or self.rng.choice((*SIZES, (self.rng.randrange(1, 1500), self.rng.randrange(1, 900))))
        pygame.display.set_mode(size, pygame.RESIZABLE)
        self.post(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1])

    def cover(self) -> None:
        """What the system tells where another window has hidden this one, and spoiled it."""
        self.app.window.surface.fill("red")
        self.post(pygame.VIDEOEXPOSE)

    def compare(self) -> None:
        """Raise AssertionError where a frame of a shot is not as one that is drawn as a whole."""
        scene = self.app.scene
        if not isinstance(scene, Play | Replay) or scene.state.playback is None:
            return
        if canvas(self.app.window.surface) is not self.app.window.surface:
            # So small a window is never drawn on in parts.
            return
        for _ in range(3):
            self.app.step(1.0 / 60.0)
            if self.app.scene is not scene or not scene.stage.still or self.app.toasts.notes:
                return
            seen = pygame.image.tobytes(self.app.window.surface, "RGB")
            # Bars that are kept would say the same again.
            scene.stage.bars = CachedBars()
            scene.draw(Frame(self.app.window.surface))
            assert pygame.image.tobytes(self.app.window.surface, "RGB") == seen, "something was left over on the window"
            self.compared += 1


def main(arguments: argparse.Namespace) -> int:
    with tempfile.TemporaryDirectory() as folder:
        for name in ("DATA", "CONFIG", "CACHE"):
            os.environ[f"POOL2D_{name}"] = os.path.join(folder, name.lower())
        # A skin that is made meanwhile would make a difference between a frame and the next.
        ball_skin.known = lambda coat, radius: True
        monkey = Monkey(arguments.seed)
        wrong = 0
        for number in range(arguments.events):
            try:
                monkey.act(number)
            except Exception:
                wrong += 1
                print(f"--seed {arguments.seed}, event {number}, in {type(monkey.app.scene).__name__}, after")
                print(*monkey.last, sep="\n")
                traceback.print_exc(file=sys.stdout)
                monkey.app.scene = monkey.app.lobby.menu()
        monkey.app.close()
    scenes = ", ".join(f"{name} {count}" for name, count in monkey.seen.most_common())
    print(f"{arguments.events} events, {wrong} went wrong; {monkey.compared} frames compared; {scenes}")
    return int(wrong > 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--events", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    sys.exit(main(parser.parse_args()))
