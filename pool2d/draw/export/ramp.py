"""Numbers as colours: dark to bright, so that more is brighter also in grey and to eyes that see few colours."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

# Colours at even steps from 0 to 1: a dark violet, blue, green, a pale yellow. Their lightness rises evenly.
_COLORS = np.array([(38, 14, 68), (50, 50, 122), (32, 92, 138), (26, 132, 126), (84, 172, 92), (172, 204, 66),
                    (250, 236, 120)], float)  # fmt: skip


def colors(values: npt.NDArray[np.float64]) -> npt.NDArray[np.uint8]:
    """The colour of each value from 0 to 1, with a last axis of red, green and blue."""
    steps = np.linspace(0.0, 1.0, len(_COLORS))
    channels = [np.interp(values, steps, channel) for channel in _COLORS.T]
    levels: npt.NDArray[np.uint8] = np.rint(np.stack(channels, axis=-1)).astype(np.uint8)
    return levels
