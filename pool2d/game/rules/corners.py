"""The corners of a table, in which scoring is limited at straight rail (UMB, art. 52)."""

from __future__ import annotations

from ...table.table import Table


def corner_of(table: Table, x: float, y: float) -> str:
    """The corner a point is in, "" for none: cut off at a quarter of the length and width, the line with it.

    These are the barred zones of straight rail: 71 and 35.5 cm on a match table, which is from memory.
    """
    return next((name for name, (u, v, limit) in lines(table).items() if u * x + v * y <= limit), "")


def lines(table: Table) -> dict[str, tuple[float, float, float]]:
    """The lines ux + vy = limit that cut the corners off."""
    u, v = 4.0 / table.knobs.table.length, 4.0 / table.knobs.table.width
    return {
        "head right": (u, v, 1.0),
        "head left": (u, -v, -3.0),
        "foot right": (-u, v, -3.0),
        "foot left": (-u, -v, -7.0),
    }
