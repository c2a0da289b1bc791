"""Many shots from one layout, played by whoever there is, in the order in which they are given."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import Executor
from itertools import chain, islice

from ..errors import InputError
from ..physics.values import Layout, Shot
from ..table.table import Table
from .summaries import Summaries, joined
from .summarize import summarize
from .workers import in_order, packed, processes, processors

# Shots handed out at once: enough that handing out costs little, few enough that they come back steadily.
CHUNK = 32
# Chunks handed out and not come back: as many as keep a cluster busy, or, for each of our processes, one to play,
# one to take up next, and some for those that take longer.
_AHEAD = 256
_AHEAD_EACH = 4


def simulate_many(
    table: Table,
    layout: Layout,
    shots: Iterable[Shot],
    *,
    executor: Executor | None = None,
    chunk: int | None = None,
) -> Summaries:
    """Play each shot from `layout`, and keep what came of it.

    `shots` is gone through once, a little ahead of what is played. `executor` is anything with the `submit` of
    `concurrent.futures.Executor`, and stays open; without one, processes play, as many as there are processors.
    They are started afresh, so a script has to call this below `if __name__ == "__main__":`. `chunk` shots are handed
    out at once. Neither changes any bit of what comes back, on machines that round alike.

    A shot that fails is a row with its error. Raises InputError where the layout or `chunk` is wrong, WorkerError where
    shots do not come back, as from a process that was killed.

    Examples:
        >>> from pool2d import Ball, Layout, Shot, load_table, simulate_many
        >>> layout = Layout([Ball("cue", 1.27, 0.4), Ball("1", 1.27, 0.9)])
        >>> shots = (Shot(angle=90.0, speed=0.25 * i) for i in range(5))
        >>> many = simulate_many(load_table("pool-9ft"), layout, shots)
        >>> many.balls, many.potted.tolist(), many.scratch.tolist()
        (('cue', '1'), [0, 0, 0, 1, 1], [False, False, False, False, False])
        >>> many.columns()["1.pocket"].tolist()
        ['', '', '', 'top-side', 'top-side']
    """
    parts = list(each_chunk(table, layout, shots, executor=executor, chunk=chunk))
    return joined(parts) if parts else summarize(table, layout, [])


def each_chunk(
    table: Table,
    layout: Layout,
    shots: Iterable[Shot],
    *,
    executor: Executor | None = None,
    chunk: int | None = None,
    workers: int | None = None,
) -> Generator[Summaries, None, None]:
    """The summaries of `simulate_many` in pieces as they come, from so many `workers` where there is no executor."""
    if chunk is not None and (type(chunk) is not int or chunk < 1):
        raise InputError("simulate_many", "chunk", chunk, "allowed is a whole number from 1")
    table.settle(layout)
    chunks = _chunks(shots, chunk or CHUNK)
    if executor is not None:
        yield from in_order(executor, packed(table, layout), chunks, _AHEAD)
        return
    first = list(islice(chunks, 2))
    count = workers or processors()
    if len(first) < 2 or count == 1:
        # There is nothing to share out.
        yield from (summarize(table, layout, some) for some in chain(first, chunks))
        return
    with processes(count) as pool:
        yield from in_order(pool, packed(table, layout), chain(first, chunks), _AHEAD_EACH * count)


def _chunks(shots: Iterable[Shot], size: int) -> Iterator[list[Shot]]:
    source = iter(shots)
    while some := list(islice(source, size)):
        for shot in some:
            if not isinstance(shot, Shot):
                raise InputError("simulate_many", "shots", shot, "allowed are shots")
        yield some
