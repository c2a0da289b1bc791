"""What is shown of a table beside its balls: the guide, arrows, geometry, and which motions are for show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from ...draw import guide, theme
from ...draw.effects import Effects
from .playback import Playback


@dataclass
class Show:
    """What is shown beside the balls: the options' guide `level`, `effects` and `style`, and what keys turn on.

    `why` is the playback with which it is told why its stroke was played.
    """

    level: int = guide.GHOST
    effects: Effects = field(default_factory=Effects)
    style: theme.Style = theme.PLAIN
    vectors: bool = False
    geometry: bool = False
    why: Playback | None = None

    @property
    def keys(self) -> dict[str, Callable[[], None]]:
        """What keys do, by the names of their actions."""
        return {"vectors": self._turn_vectors, "geometry": self._turn_geometry}

    def _turn_vectors(self) -> None:
        self.vectors = not self.vectors

    def _turn_geometry(self) -> None:
        self.geometry = not self.geometry

    def take_options(self, other: Show) -> None:
        """Show what the options say as the other does."""
        self.level, self.effects, self.style = other.level, other.effects, other.style
