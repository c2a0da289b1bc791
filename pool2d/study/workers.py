"""Who plays many shots: anything that takes tasks as `concurrent.futures` does; processes of our own by default."""

from __future__ import annotations

import os
import pickle
import threading
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager

from ..errors import WorkerError
from ..physics.values import Layout, Shot
from ..table.table import Table
from .fresh_process import FreshContext, attend
from .summaries import Summaries
from .summarize import summarize

# Windows can wait for no more.
_MOST = 60
_UNGUARDED = "; a script that starts processes has to do so below `if __name__ == '__main__':`"
# The table that a thread plays on: a Space must not be asked by two at once.
_here = threading.local()


def packed(table: Table, layout: Layout) -> bytes:
    """A table and the balls on it, as they are sent: some kilobytes."""
    return pickle.dumps((table, layout))


def play(kit: bytes, shots: list[Shot]) -> Summaries:
    """Play shots on what `packed` made: the task that is handed out. A thread builds a table once."""
    if getattr(_here, "kit", None) != kit:
        _here.table, _here.layout = pickle.loads(kit)
        _here.kit = kit
    return summarize(_here.table, _here.layout, shots)


def in_order(executor: Executor, kit: bytes, chunks: Iterable[list[Shot]], ahead: int) -> Iterator[Summaries]:
    """What comes of each chunk of shots, in their order; no more than `ahead` are handed out at once.

    Raises WorkerError where a chunk does not come back. What is still handed out then, or when nobody asks any more,
    is taken back.
    """
    waiting: deque[Future[Summaries]] = deque()
    done = 0
    try:
        for shots in chunks:
            if len(waiting) == ahead:
                yield (part := _result(waiting.popleft(), done))
                done += len(part)
            waiting.append(_handed_out(executor, kit, shots, done))
        while waiting:
            yield (part := _result(waiting.popleft(), done))
            done += len(part)
    finally:
        for future in waiting:
            future.cancel()


def _handed_out(executor: Executor, kit: bytes, shots: list[Shot], done: int) -> Future[Summaries]:
    try:
        return executor.submit(play, kit, shots)
    except Exception as error:
        raise _lost(error, done) from error


def _result(future: Future[Summaries], done: int) -> Summaries:
    try:
        return future.result()
    except Exception as error:
        raise _lost(error, done) from error


def _lost(error: Exception, done: int) -> WorkerError:
    """The shots themselves raise nothing, so whatever is raised tells of the one who was to play them."""
    hint = _UNGUARDED if isinstance(error, BrokenExecutor) and not done else ""
    return WorkerError(done, f"{type(error).__name__}: {error}{hint}")


def processors() -> int:
    """How many processors this process may use."""
    allowed = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(allowed, _MOST)


@contextmanager
def processes(count: int) -> Iterator[Executor]:
    """So many processes that play. They end with the block, at once where an error or Ctrl-C ends it, and if we die.

    They are started afresh: a copy of a process that has threads or a window may hang.
    """
    context = FreshContext()
    # Nothing is ever sent. That our end is closed, by us or by our death, is what they wait for.
    theirs, ours = context.Pipe(duplex=False)
    pool = ProcessPoolExecutor(count, context, attend, (theirs,))
    try:
        yield pool
    except BaseException:
        ours.close()
        raise
    finally:
        pool.shutdown(cancel_futures=True)
        ours.close()
        theirs.close()
