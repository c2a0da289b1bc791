"""What `pool2d study` does: play a study to its file, from where that was left, and draw what it found."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from ..config.files import check_target
from ..draw.export import heat_map, picture_file, rests_picture
from ..errors import InputError, WorkerError
from ..game.records.engine import identity
from ..study import parquet, results
from ..study.findings import Findings, columns_of, findings
from ..study.simulate_many import each_chunk, simulate_many
from ..study.study_file import Study, load_study
from . import terminal
from .progress import Progress

# How long a scheduler may take to answer.
_PATIENCE = "10s"


@dataclass(frozen=True, slots=True)
class Plan:
    """Where a study's results and pictures go, and who plays it: a cluster, or so many processes."""

    out: Path
    size: tuple[int, int]
    workers: int | None = None
    cluster: str | None = None

    @property
    def rows(self) -> Path:
        """The file that grows: Parquet files cannot, so theirs lies beside it until all is played."""
        return self.out.with_name(self.out.name + ".part") if self.is_parquet else self.out

    @property
    def is_parquet(self) -> bool:
        return self.out.suffix == ".parquet"

    def picture(self, what: str) -> Path:
        """Where a picture goes."""
        return self.out.with_name(f"{self.out.stem}-{what}.png")


def study(file: Path, plan: Plan, overrides: Mapping[str, Any], conditions: Sequence[str]) -> int:
    """Play what is left of a study, then draw its pictures; the exit status."""
    try:
        return _study(file, plan, overrides, conditions)
    except KeyboardInterrupt as error:
        terminal.complain(f"pool2d: interrupted; {error if error.args else 'the same command goes on from there'}")
        return terminal.INTERRUPTED


def _study(file: Path, plan: Plan, overrides: Mapping[str, Any], conditions: Sequence[str]) -> int:
    asked = load_study(file, overrides, conditions)
    _check(plan)
    stamp = asked.stamp(identity())
    if plan.is_parquet and plan.out.exists():
        return _told_whole(plan, stamp)
    columns = results.header(simulate_many(asked.table, asked.layout, []))
    with results.Results(plan.rows, columns, stamp) as rows:
        _play(asked, rows, plan)
    found = findings(asked, results.rows(plan.rows, columns_of(asked)))
    for path in _drawn(asked, found, plan):
        terminal.tell(f"{path}: written")
    if plan.is_parquet:
        parquet.write(plan.rows, plan.out, stamp)
        plan.rows.unlink()
    terminal.tell(f"{plan.out}: {found.shots} shots" + (f", {found.failed} of them failed" if found.failed else ""))
    return 0


def _check(plan: Plan) -> None:
    """Raises InputError where the results could not be written or the shots not be played, before any is."""
    if plan.workers is not None and plan.cluster is not None:
        raise InputError("command line", "--workers", plan.workers, "allowed is --workers or --cluster, not both")
    if plan.out.suffix not in (".csv", ".parquet"):
        raise InputError("command line", "--out", str(plan.out), "allowed is a name that ends in .csv or .parquet")
    if plan.is_parquet:
        parquet.check(plan.out)
    if not plan.out.parent.is_dir():
        raise InputError(str(plan.out), "", None, "cannot be written: there is no such folder")
    for path in (plan.out, plan.picture("map"), plan.picture("rests")):
        check_target(path)


def _told_whole(plan: Plan, stamp: str) -> int:
    """What there is to say of a Parquet file that is there: they are written when all is played, and drawn."""
    if parquet.stamp_of(plan.out) != stamp:
        raise InputError(str(plan.out), "", None, "holds something else than this study; allowed is a new file")
    terminal.tell(f"{plan.out}: is whole already")
    return 0


def _play(asked: Study, rows: results.Results, plan: Plan) -> None:
    """Play what is left, and write it down as it comes; what ends it too early tells how far it came."""
    total = len(asked.sweep)
    if rows.count == total:
        return
    shots = islice(asked.sweep.shots(), rows.count, None)
    progress = Progress(total, rows.count)
    try:
        with (
            _players(plan) as executor,
            contextlib.closing(
                each_chunk(asked.table, asked.layout, shots, executor=executor, workers=plan.workers)
            ) as parts,
        ):
            for part in parts:
                rows.add(part)
                progress.went(len(part))
    except KeyboardInterrupt:
        raise KeyboardInterrupt(_left(rows, total)) from None
    except WorkerError as error:
        raise WorkerError(rows.count, f"{error.reason}; {_left(rows, total)}") from error
    finally:
        progress.end()


def _left(rows: results.Results, total: int) -> str:
    return f"{rows.path} has {rows.count} of {total} shots, and the same command goes on from there"


@contextlib.contextmanager
def _players(plan: Plan) -> Iterator[Executor | None]:
    """Who plays: a cluster's workers, or None for processes of our own. Raises InputError where there is no cluster."""
    if plan.cluster is None:
        yield None
        return
    try:
        from distributed import Client
    except ImportError:
        allowed = "a cluster needs dask.distributed, of the extra cluster"
        raise InputError("command line", "--cluster", plan.cluster, allowed) from None
    try:
        client: Any = Client(plan.cluster, timeout=_PATIENCE, set_as_default=False)  # type: ignore[no-untyped-call]
    except (OSError, ValueError, TypeError) as error:
        allowed = (
            f"no Dask scheduler answers there ({type(error).__name__}); allowed is an address such as tcp://host:8786"
        )
        raise InputError("command line", "--cluster", plan.cluster, allowed) from error
    with client:
        yield client.get_executor()


def _drawn(asked: Study, found: Findings, plan: Plan) -> Iterator[Path]:
    """Draw the pictures and say where each is."""
    if found.heat:
        picture_file.save(heat_map.draw(found.heat, plan.size), plan.picture("map"))
        yield plan.picture("map")
    picture_file.save(rests_picture.draw(found.rests, asked.table, asked.layout, plan.size), plan.picture("rests"))
    yield plan.picture("rests")
