"""Random hands at the whole window: `python -m benchmarks.monkey [--events 20000] [--seed 0]`.

Keys, clicks, drags, typed letters and the loss of the focus come as they please, over the table and over every menu;
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
from pool2d.game.rules import GAMES
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.settings import Store
from pool2d.ui import ball_skin
from pool2d.ui.app import App
from pool2d.ui.hud import KeptBars
from pool2d.ui.keys import CTRL, DEFAULTS
from pool2d.ui.play import Play
from pool2d.ui.replay_scene import Replay

SIZE = (960, 540)
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

    def act(self, number: int) -> None:
        """Do one thing, and look at the window."""
        if number % PITCH == 0:
            self.begin(number)
        self.seen[type(self.app.scene).__name__] += 1
        kind = self.rng.choices(
            (self.key, self.move, self.click, self.wheel, self.type, self.wait, self.leave, self.cover),
            (35, 25, 15, 5, 5, 12, 2, 1),
        )[0]
        kind()
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
        return self.rng.randrange(SIZE[0]), self.rng.randrange(SIZE[1])

    def key(self) -> None:
        key = self.rng.choice(self.keys)
        key, mod = (key - CTRL, pygame.KMOD_CTRL) if CTRL <= key < 2 * CTRL else (key, 0)
        self.post(pygame.KEYDOWN, key=key, mod=mod, unicode="")
        self.post(pygame.KEYUP, key=key, mod=mod)

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
        self.post(pygame.TEXTINPUT, text=self.rng.choice("abc19.-"))

    def wait(self) -> None:
        dt = self.rng.choice((1.0 / 60.0, 0.1, 1.0, 3.0))
        self.last.append(f"{dt:.3f} s")
        self.app.step(dt)

    def leave(self) -> None:
        self.post(pygame.WINDOWFOCUSLOST)

    def cover(self) -> None:
        """What the system tells where another window has hidden this one, and spoiled it."""
        self.app.surface.fill("red")
        self.post(pygame.VIDEOEXPOSE)

    def compare(self) -> None:
        """Raise AssertionError where a frame of a shot is not as one that is drawn as a whole."""
        scene = self.app.scene
        if not isinstance(scene, Play | Replay) or scene.playback is None:
            return
        for _ in range(3):
            self.app.step(1.0 / 60.0)
            if self.app.scene is not scene or not scene.stage.still or self.app.toasts.notes:
                return
            seen = pygame.image.tobytes(self.app.surface, "RGB")
            # Bars that are kept would say the same again.
            scene.stage.bars = KeptBars()
            scene.draw(self.app.surface)
            assert pygame.image.tobytes(self.app.surface, "RGB") == seen, "something was left over on the window"
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
