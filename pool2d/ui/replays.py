"""The player's records, to look at one."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError
from ..game.record import ENDING, load, matches_folder
from ..game.reel import Reel
from ..settings import Store
from .pick import Pick
from .replay_scene import Replay
from .scene import Scene
from .sound import Sounds
from .words import say


def open_replays(below: Scene, store: Store | None = None, sounds: Sounds | None = None) -> Scene:
    """A list of the player's records, the latest first, to look at one; Esc goes back to `below`."""
    paths = records()

    def take(at: int) -> Scene | str:
        try:
            return Replay(Reel(load(paths[at], torn=True)), below, store, sounds)
        except InputError as error:
            return str(error)

    title = say("replay.title") if paths else say("replay.none")
    return Pick(below, title, [path.stem for path in paths], 0, say("replay.show"), take)


def records() -> list[Path]:
    """The player's records, the latest first: their names begin with the time."""
    return sorted(matches_folder().glob("*" + ENDING), key=lambda path: path.name, reverse=True)
