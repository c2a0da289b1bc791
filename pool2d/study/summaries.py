"""What is kept of many shots: numpy columns, a row for each shot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Numbers: TypeAlias = npt.NDArray[np.int16]
# What stands for "none" where a ball or a pocket is told by its number.
NONE = -1


@dataclass(frozen=True, eq=False, slots=True)
class Summaries:
    """What came of many shots, a row for each in their order. It has more columns than most classes have attributes.

    Balls are told by their place in `balls`, pockets by theirs in `pockets`, -1 for none. With n shots and b balls a
    column is of shape (n,) or (n, b). Of a shot that failed there is `error`; all else of its row is none, nan or 0.

    Attributes:
        balls: The ids of the layout's balls, in its order.
        pockets: The names of the table's pockets.
        scenarios: What failed, by its row: a scenario file's content, with which it can be played again.
        angle: The shot's, (n,), degrees; so are the next four, in the units of `Shot`.
        speed: See `angle`.
        side: See `angle`.
        height: See `angle`.
        elevation: See `angle`.
        struck: The ball that the cue met, (n,).
        first: The ball that the struck ball met first, (n,).
        pocket: The pocket that each ball fell into, (n, b).
        off: Whether each ball left the table, (n, b).
        x: Where each ball came to rest, (n, b), m; nan for one that is not on the table. So is `y`.
        y: See `x`.
        cushions: How often each ball came to a cushion or a jaw, (n, b): one that is pressed against a cushion on
            which it lies does not come there.
        duration: When the last ball came to rest, (n,), s.
        events: How many events there were, (n,).
        miscue: Whether the tip slipped, (n,).
        error: Why the shot failed, (n,), texts; "" for one that did not.
    """

    balls: tuple[str, ...]
    pockets: tuple[str, ...]
    scenarios: dict[int, dict[str, Any]]
    angle: Floats
    speed: Floats
    side: Floats
    height: Floats
    elevation: Floats
    struck: Numbers
    first: Numbers
    pocket: Numbers
    off: npt.NDArray[np.bool_]
    x: Floats
    y: Floats
    cushions: npt.NDArray[np.int32]
    duration: Floats
    events: npt.NDArray[np.int32]
    miscue: npt.NDArray[np.bool_]
    error: npt.NDArray[np.object_]

    def __len__(self) -> int:
        return len(self.angle)

    @property
    def fell(self) -> npt.NDArray[np.bool_]:
        """Whether each ball fell into a pocket, (n, b)."""
        fell: npt.NDArray[np.bool_] = self.pocket != NONE
        return fell

    @property
    def scratch(self) -> npt.NDArray[np.bool_]:
        """Whether the struck ball fell into a pocket, (n,)."""
        return self.of_struck(self.fell)

    @property
    def potted(self) -> npt.NDArray[np.int64]:
        """How many balls other than the struck one fell into pockets, (n,)."""
        fallen: npt.NDArray[np.int64] = self.fell.sum(axis=1) - self.scratch
        return fallen

    @property
    def left(self) -> npt.NDArray[np.int64]:
        """How many balls left the table, the struck one included, (n,)."""
        left: npt.NDArray[np.int64] = self.off.sum(axis=1)
        return left

    def of_struck(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        """Of a column of shape (n, b), what it says of the ball that was struck, (n,); 0 where there was none."""
        if not self.balls:
            return np.zeros(len(self), values.dtype)
        mine = values[np.arange(len(self)), self.struck]
        return np.where(self.struck == NONE, np.zeros((), values.dtype), mine)

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """All of it as columns of shape (n,), by name, for a table or a data frame.

        Balls and pockets are told by their names there, "" for none; what there is of each ball is named after it,
        such as "8.x".
        """
        balls = np.array([*self.balls, ""], object)
        pockets = np.array([*self.pockets, ""], object)
        plain = ("angle", "speed", "side", "height", "elevation")
        columns: dict[str, npt.NDArray[Any]] = {name: getattr(self, name) for name in plain}
        columns |= {"struck": balls[self.struck], "first": balls[self.first], "potted": self.potted, "off": self.left}
        columns |= {name: getattr(self, name) for name in ("scratch", "miscue", "duration", "events")}
        for i, ball in enumerate(self.balls):
            columns[f"{ball}.pocket"] = pockets[self.pocket[:, i]]
            columns |= {f"{ball}.{name}": getattr(self, name)[:, i] for name in ("off", "cushions", "x", "y")}
        columns["error"] = self.error
        return columns


# The columns, with the type of each; those of them that have a value for each ball.
TYPES: dict[str, type] = {
    **dict.fromkeys(("angle", "speed", "side", "height", "elevation", "x", "y", "duration"), np.float64),
    **dict.fromkeys(("struck", "first", "pocket"), np.int16),
    **dict.fromkeys(("cushions", "events"), np.int32),
    **dict.fromkeys(("off", "miscue"), np.bool_),
    "error": np.object_,
}
COLUMNS = tuple(field.name for field in fields(Summaries) if field.name in TYPES)
_OF_BALLS = ("pocket", "off", "x", "y", "cushions")


def gathered(
    balls: tuple[str, ...], pockets: tuple[str, ...], rows: Sequence[Sequence[Any]], failed: dict[int, dict[str, Any]]
) -> Summaries:
    """The summaries of rows that have their values in the order of `COLUMNS`."""
    values = zip(*rows, strict=True) if rows else ((),) * len(COLUMNS)
    columns = dict(zip(COLUMNS, values, strict=True))
    arrays: dict[str, npt.NDArray[Any]] = {name: np.array(column, TYPES[name]) for name, column in columns.items()}
    for name in _OF_BALLS:
        arrays[name] = arrays[name].reshape(len(rows), len(balls))
    return Summaries(balls, pockets, failed, **arrays)


def joined(parts: Sequence[Summaries]) -> Summaries:
    """Summaries of the same balls, one after another."""
    failed: dict[int, dict[str, Any]] = {}
    row = 0
    for part in parts:
        failed |= {row + number: scenario for number, scenario in part.scenarios.items()}
        row += len(part)
    arrays = {name: np.concatenate([getattr(part, name) for part in parts]) for name in COLUMNS}
    return Summaries(parts[0].balls, parts[0].pockets, failed, **arrays)
