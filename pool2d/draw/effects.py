"""Which motion the player wants to see besides the balls', from the settings."""

from __future__ import annotations

from dataclasses import dataclass

from ..config.settings import Settings
from . import theme


@dataclass(frozen=True, slots=True)
class Effects:
    """`trails` asks for light trails behind moving balls; `reduced_motion` forbids all that is only for show.

    With `instant` players who are no people are not seen to aim.
    """

    trails: bool = True
    reduced_motion: bool = False
    instant: bool = False

    @property
    def trail(self) -> bool:
        """Whether moving balls leave a light trail."""
        return self.trails and not self.reduced_motion

    @property
    def stroke(self) -> bool:
        """Whether the cue is seen to strike."""
        return not self.reduced_motion

    @property
    def eased(self) -> bool:
        """Whether the camera glides to where it is sent; otherwise it is there at once."""
        return not self.reduced_motion


def effects_of(values: Settings) -> Effects:
    """What the settings allow to move."""
    return Effects(values.balls.trails, values.screen.reduced_motion, values.screen.instant_players)


def style_of(values: Settings) -> theme.Style:
    """How the settings want balls drawn."""
    return theme.Style(theme.PALETTES.get(values.balls.palette, theme.STANDARD), values.balls.patterned)
