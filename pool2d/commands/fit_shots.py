"""What `pool2d fit SHOTS` does: fit knobs to tracked shots, tell how well, and write a preset that says so."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..config import catalogue
from ..config.files import check_target, write_text
from ..config.knobs import walk
from ..errors import InputError
from ..fit.evidence import evidence
from ..fit.fitted_preset import FittedKnob, preset_text
from ..fit.miss import Stretch, stands
from ..fit.shot_fit import setting_of, table_of
from ..fit.track_file import read_tracks
from ..fit.tracked_fit import TrackedFit, check_knobs, errors, has_optimiser, tasks
from ..study.crew import crew
from ..table.table import Table
from . import terminal
from .progress import Progress

_LONGEST_TITLE = 80


@dataclass(frozen=True, slots=True)
class FitPlan:
    """What is fitted to what, who does it, and where it goes; `noise` in m, `elevation` in degrees."""

    shots: Path
    table: Table
    names: tuple[str, ...]
    noise: float
    elevation: float
    out: str
    workers: int
    size: tuple[int, int]

    @property
    def preset(self) -> Path:
        """The file of the preset: a path, or the user's own preset of that name."""
        return Path(self.out) if self.out.endswith(".toml") else catalogue.own_path(catalogue.TABLES, self.out)

    def picture(self, what: str) -> Path:
        """Where a picture goes: beside the preset's path, or beside the tracks."""
        beside = Path(self.out).with_suffix("") if self.out.endswith(".toml") else self.shots.with_name(self.out)
        return beside.with_name(f"{beside.name}-{what}.png")

    def values(self) -> dict[str, float]:
        """The knobs as the table has them."""
        given = {name: value for name, _, value in walk(self.table.knobs)}
        return {name: float(given[name]) for name in self.names}

    @property
    def command(self) -> str:
        """What was asked for, as a line."""
        return f"pool2d fit {self.shots} --table {self.table.source} --knobs {','.join(self.names)}"


def fit_shots(plan: FitPlan) -> int:
    """Fit, tell and write; the exit status."""
    _check(plan)
    fit = TrackedFit(setting_of(plan.table, plan.values()), _stretches(plan), plan.noise, str(plan.shots))
    progress = Progress(tasks(len(fit.shots)), 0)
    try:
        with crew(plan.workers, progress.went) as workers:
            fit.run(workers)
        # Stages have ended before they had to.
        progress.went(progress.total - progress.done)
    except KeyboardInterrupt:
        return _interrupted(plan, fit)
    finally:
        progress.end()
    told = list(_told(fit))
    for line in told:
        terminal.tell(line)
    _write(plan, fit, told[-2:])
    _draw(plan, fit)
    return 0


def _interrupted(plan: FitPlan, fit: TrackedFit) -> int:
    """Keep what there is of a fit that Ctrl-C has ended."""
    if all(knob.value == knob.was for knob in _fitted(fit)):
        terminal.complain("pool2d: interrupted before any knob was turned; nothing is written")
        return terminal.INTERRUPTED
    _write(plan, fit, ["Interrupted: the best so far, neither settled nor judged."])
    terminal.complain(f"pool2d: interrupted; the best so far is kept, and --table {plan.out} goes on from there")
    return terminal.INTERRUPTED


def _check(plan: FitPlan) -> None:
    """Raises InputError where a fit could not be made or written, before it is begun."""
    if not has_optimiser():
        raise InputError("pool2d fit", "", None, "needs scipy, of the extra fit: pip install 'pool2d[fit]'")
    check_knobs(plan.names, "command line", "--knobs")
    if not plan.preset.parent.is_dir() and plan.out.endswith(".toml"):
        raise InputError(str(plan.preset), "", None, "cannot be written: there is no such folder")
    for path in (plan.preset, plan.picture("median"), plan.picture("worst")):
        check_target(path)


def _stretches(plan: FitPlan) -> list[Stretch]:
    """The shots that can be fitted; what cannot is told."""
    shots = []
    for shot in read_tracks(plan.shots).shots:
        seen = evidence(shot, plan.table, plan.noise)
        if seen is None or not stands(plan.table, seen):
            why = "no ball moves" if seen is None else "a ball stands where none can"
            terminal.complain(f"pool2d: {plan.shots}: shot {shot.name} is left out: {why}")
        else:
            shots.append(Stretch(seen, shot.end, plan.elevation))
    return shots


def _fitted(fit: TrackedFit) -> list[FittedKnob]:
    """The knobs before and after, as far as the fit has come."""
    found = fit.setting if fit.knob_fit is None else fit.knob_fit.setting
    uncertain = [None] * len(found.names) if fit.uncertain is None else fit.uncertain.tolist()
    return [FittedKnob(*row) for row in zip(found.names, fit.setting.values, found.values, uncertain, strict=True)]


def _told(fit: TrackedFit) -> Iterator[str]:
    """What a fit has found, in lines: shot by shot, knob by knob, and last of all its halves."""
    before, after = errors(fit.before).of, errors(fit.after).of
    yield f"{'shot':<12} {'half':<10} {'before, cm':>10} {'after, cm':>10}"
    for number, shot in enumerate(fit.shots):
        half = "held back" if number % 2 else "fitted"
        yield f"{shot.seen.shot.name:<12} {half:<10} {before[number]:>10.3g} {after[number]:>10.3g}"
    yield f"{'knob':<22} {'was':>10}   fitted, with what it may be off by, 95 times of 100"
    for knob in _fitted(fit):
        yield f"{knob.name:<22} {knob.was:>10.6g}   {knob}"
    for start, half in enumerate(("fitted", "held back")):
        was, now = errors(fit.before[start::2]), errors(fit.after[start::2])
        yield f"{len(now.of)} shots {half}: median error {now} cm with quartiles, before {was} cm"


def _write(plan: FitPlan, fit: TrackedFit, judged: Sequence[str]) -> None:
    """Write the preset, which names its evidence."""
    evidence = [f"Fitted to {len(fit.shots[::2])} of {len(fit.shots)} tracked shots on {time.strftime('%Y-%m-%d')}:"]
    knobs = {knob.name: knob for knob in _fitted(fit)}
    title = f"{plan.table.title}, fitted"[:_LONGEST_TITLE]
    text = preset_text(title, plan.table, knobs, [*evidence, plan.command, *judged])
    write_text(plan.preset, text)
    terminal.tell(f"{plan.preset}: written; play it: pool2d play --table {plan.out}")


def _draw(plan: FitPlan, fit: TrackedFit) -> None:
    """Draw the worst and the median of the shots that were held back."""
    from ..draw.export import picture_file, tracks_picture

    assert fit.knob_fit is not None
    table, sizes = table_of(fit.knob_fit.setting), errors(fit.after).of
    back = sorted(range(1, len(sizes), 2), key=lambda number: sizes[number])
    for what, number in (("median", back[len(back) // 2]), ("worst", back[-1])):
        shot = fit.shots[number]
        title = f"shot {shot.seen.shot.name}, the {what} of {len(back)} held back: {sizes[number]:.3g} cm off"
        picture = tracks_picture.draw(table, shot, fit.after[number], title, plan.size)
        picture_file.save(picture, plan.picture(what))
        terminal.tell(f"{plan.picture(what)}: written")
