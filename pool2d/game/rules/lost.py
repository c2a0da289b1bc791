"""The fouls by balls that left the table, as every game tells them: over which cushion, or onto which rail.

A ball is off the table where it comes to rest elsewhere than on the bed, on a rail's top too; one that comes back by
itself is not (WPA 8.4; BCA 3.28; WEPF S 2).
"""

from __future__ import annotations

from collections.abc import Iterator

from .notes import Note
from .report import Report


def cue_ball_off(report: Report) -> Iterator[Note]:
    """The foul of a cue ball that left the table."""
    if report.cue_off:
        yield _told(report, report.cue, "foul.cue-", "")


def balls_off(report: Report) -> Iterator[Note]:
    """The fouls of object balls that left the table, in their order."""
    for ball in report.off:
        yield ball_off(report, ball, ball)


def ball_off(report: Report, ball: str, name: str) -> Note:
    """The foul of a ball that left the table, spoken of by a name."""
    return _told(report, ball, "foul.", name)


def _told(report: Report, ball: str, whose: str, name: str) -> Note:
    """How a ball left the table, as far as it was seen."""
    where = report.left[ball]
    how = "off" if not where else "on-rail" if ball in report.on_rail else "over"
    return Note(f"{whose}{how}", ball=name, where=where)
