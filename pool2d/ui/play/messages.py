"""The message line over a game: what is said at present, and what comes back once that has been read."""

from __future__ import annotations

import math
from collections.abc import Callable

Message = Callable[[], str]

# How long a notice is shown before the standing message comes back, s.
_READ = 4.0


class Messages:
    """Messages are asked for anew for every picture, as the language may change.

    `standing` gives the one that is shown where there is no other, or None where nothing stands. `warning` stays
    until what it warns of is mended, and hides all else.
    """

    def __init__(self, standing: Callable[[], Message | None]) -> None:
        self.standing = standing
        self.warning = ""
        self._message: Message = _silence
        self._age = math.inf

    @property
    def text(self) -> str:
        """What is said at present; empty where nothing is."""
        return self._message()

    @property
    def settled(self) -> bool:
        """Whether nothing else is going to be said by itself."""
        standing = self.standing()
        return standing is None or self._message == standing

    def show(self, message: Message) -> None:
        """Say this until something else is said, or until it has been read where one stands."""
        self._message, self._age = message, 0.0

    def say(self, text: str) -> None:
        """Show a text that is in no language, or in one for good, such as an error's."""
        self.show(lambda: text)

    def clear(self) -> None:
        """Go back to the standing message at once."""
        self.show(self.standing() or _silence)

    def update(self, dt: float) -> None:
        """Let `dt` seconds of reading pass."""
        self._age += dt
        standing = self.standing()
        if self._age > _READ and standing is not None:
            self._message = standing


def _silence() -> str:
    return ""
