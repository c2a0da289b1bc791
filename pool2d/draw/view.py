"""From metres on the table to pixels on the screen, and back."""

from __future__ import annotations

from dataclasses import dataclass

# How much round the playing surface is shown, m: the cushions, the rails and a little floor.
FRAME = 0.16


@dataclass(frozen=True, slots=True)
class View:
    """Where the table is on a surface: pixels per metre, and the pixel of the table's origin.

    On the table y points up, on the surface down.
    """

    scale: float
    left: float
    bottom: float

    def to_screen(self, x: float, y: float) -> tuple[float, float]:
        return self.left + x * self.scale, self.bottom - y * self.scale

    def to_table(self, px: float, py: float) -> tuple[float, float]:
        return (px - self.left) / self.scale, (self.bottom - py) / self.scale

    def zoomed(self, factor: float) -> View:
        """The same view on a surface `factor` times as large."""
        return View(self.scale * factor, self.left * factor, self.bottom * factor)


def fit(length: float, width: float, area: tuple[int, int, int, int]) -> View:
    """The view that shows a table with its frame as large as `area` (left, top, width, height) allows."""
    left, top, w, h = area
    scale = max(1.0, min(w / (length + 2.0 * FRAME), h / (width + 2.0 * FRAME)))
    return View(scale, left + (w - length * scale) / 2.0, top + (h + width * scale) / 2.0)
