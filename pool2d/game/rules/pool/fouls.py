"""The fouls that the pool games share. Clauses are those of the WPA's Rules of Play of 15 September 2025."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ..lost import balls_off, cue_ball_off
from ..notes import Note
from ..report import Report


def shared_fouls(report: Report, on: Collection[str], *, kitchen: bool = False, push: bool = False) -> tuple[Note, ...]:
    """Every foul of a shot, the gravest first.

    `on` are the balls that may be hit first. `kitchen`: the cue ball was in hand behind the head string.
    `push`: it was a push out, in which any ball or none may be hit, and no rail is needed (5.4, 6.4).
    """
    hit = () if push else (*_hit(report, on), *_rail(report))
    played = _from_kitchen(report) if kitchen else ()
    # 3.5: object balls that are driven off the table.
    return (*_cue_ball(report), *balls_off(report), *hit, *played, *_stroke(report))


def _cue_ball(report: Report) -> Iterator[Note]:
    """3.1: the cue ball is pocketed or driven off the table."""
    if report.scratch:
        yield Note("foul.scratch")
    yield from cue_ball_off(report)


def _hit(report: Report, on: Collection[str]) -> Iterator[Note]:
    """3.2: a wrong ball is hit first; of balls met at the same moment the shooter has the benefit. 3.3: none is hit."""
    if not report.first:
        yield Note("foul.no-hit")
    elif not set(report.first) & set(on):
        yield Note("foul.wrong-ball", ball=report.first[0])


def _rail(report: Report) -> Iterator[Note]:
    """3.3: after the hit no ball is pocketed or driven to a rail; 2.7 says when one is."""
    if report.first and not report.driven:
        yield Note("foul.no-rail")


def _from_kitchen(report: Report) -> Iterator[Note]:
    """3.11: the first ball hit is behind the head string, or the cue ball stays there and meets nothing beyond."""
    if report.stayed:
        yield Note("foul.stayed")
    elif report.kitchen:
        yield Note("foul.kitchen")


def _stroke(report: Report) -> Iterator[Note]:
    """3.7: double hit; 3.8: push shot; 3.16 (c), 2.11: a tip that digs under the cue ball and lifts it.

    A miscue is no foul of its own, but one that is meant is, as that which makes the cue ball jump is taken to be:
    nobody has to put the tip so low.
    """
    for fault in report.stroke:
        if fault != "miscue":
            yield Note(f"foul.{fault}", ball=report.first[0] if report.first else "")
