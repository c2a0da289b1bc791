"""The fouls that the pool games share. Clauses are those of the WPA's rules of play, section 6."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ..report import Report
from .words import Note


def seen(report: Report, on: Collection[str], *, rail: bool = True, kitchen: bool = False) -> tuple[Note, ...]:
    """Every foul of a shot, the gravest first.

    `on` are the balls that may be hit first. `rail`: without a ball pocketed, one must be driven to a
    rail. `kitchen`: the cue ball was in hand behind the head string.
    """
    return (*_cue_ball(report), *_balls_off(report), *_hit(report, on, kitchen), *_rail(report, rail), *_stroke(report))


def _cue_ball(report: Report) -> Iterator[Note]:
    """6.1 Cue ball scratch or off the table."""
    if report.scratch:
        yield Note("foul.scratch")
    if report.cue_off:
        yield Note("foul.cue-off")


def _balls_off(report: Report) -> Iterator[Note]:
    """6.5 Ball driven off the table."""
    for ball in report.off:
        yield Note("foul.off", ball=ball)


def _hit(report: Report, on: Collection[str], kitchen: bool) -> Iterator[Note]:
    """6.2 Wrong ball first; 6.11 bad play from behind the head string.

    Of balls met at the same moment the shooter has the benefit.
    """
    if not report.first:
        yield Note("foul.no-hit")
    elif not set(report.first) & set(on):
        yield Note("foul.wrong-ball", ball=report.first[0])
    if kitchen and report.kitchen:
        yield Note("foul.kitchen")


def _rail(report: Report, rail: bool) -> Iterator[Note]:
    """6.3 No rail after contact."""
    if rail and report.first and not report.driven:
        yield Note("foul.no-rail")


def _stroke(report: Report) -> Iterator[Note]:
    """6.7 Double hit; 6.8 push shot. A miscue is no foul of its own (8.18)."""
    for fault in report.stroke:
        if fault in ("double-hit", "push"):
            yield Note(f"foul.{fault}", ball=report.first[0] if report.first else "")
