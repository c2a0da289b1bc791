"""The player's records: all of them, to look at, or those that can be continued."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from ...config.settings import Store
from ...errors import InputError
from ...game.records.record import load
from ...game.records.recorded_shots import RecordedShots
from ...game.records.recorder import records, remove
from ...sound.mixer import Sounds
from ..dialogs.list_page import ListPage
from ..scene import Scene
from ..widgets.list_row import ListRow
from ..widgets.widget import Widget
from ..wording.ruling_text import title
from .replay_scene import Replay


def open_replays(
    below: Scene, store: Store | None = None, sounds: Sounds | None = None,
    renewed: Callable[[], Scene] | None = None,
) -> Scene:  # fmt: skip
    """The player's records, the latest first, to look at one; Esc goes back to `below`, or what is `renewed`."""
    say = below.words.say

    def watch(path: Path) -> Scene:
        return Replay(RecordedShots(load(path, torn=True)), below.words, below, store, sounds)

    def named() -> str:
        return say("replay.title") if records() else say("replay.none")

    return RecordList(below, named, records, watch, renewed)


class RecordList(ListPage):
    """Records, which may be damaged; `open` leads on from one, and may raise InputError.

    Once one has been thrown away, the way back leads to what `renewed` makes in place of `below`.
    """

    def __init__(
        self, below: Scene, named: Callable[[], str], paths: Callable[[], Sequence[Path]],
        open: Callable[[Path], Scene], renewed: Callable[[], Scene] | None = None,
    ) -> None:  # fmt: skip
        self.renewed = renewed
        self.paths = paths
        self.open = open
        super().__init__(below, named)

    def entries(self) -> Sequence[Widget]:
        return [self._entry(path) for path in self.paths()]

    def _entry(self, path: Path) -> Widget:
        do, throw = self.reporting(partial(self._open, path)), self.reporting(partial(self._throw, path))
        sure = self.words.say("entry.sure")
        try:
            players, game, when = about(path)
        except (InputError, OSError, OverflowError, ValueError) as error:
            return ListRow(path.stem, do, below=str(error), remove=throw, sure=sure)
        return ListRow(players, do, note=title(self.words, game), below=when, remove=throw, sure=sure)

    def _throw(self, path: Path) -> None:
        remove(path)
        if self.renewed is not None:
            self.below = self._after = self.renewed()

    def _open(self, path: Path) -> None:
        self.go(self.open(path))


def about(path: Path) -> tuple[str, str, str]:
    """What a record says of its match: the players with the score, the game's name, and when it was played last.

    Raises InputError where it is damaged, OSError where it has gone, and OverflowError or ValueError for an odd time.
    """
    record = load(path, torn=True)
    when = time.strftime("%Y-%m-%d %H:%M", time.localtime(path.stat().st_mtime))
    score = f" {record.frames[0]} : {record.frames[1]} " if record.frames else " \N{EN DASH} "
    return score.join(record.setup.names), record.setup.game, when
