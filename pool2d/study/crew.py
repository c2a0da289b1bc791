"""Who does the work: this process, or several of our own; told as each task is done."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from functools import partial
from typing import Any, TypeVar

from ..errors import InputError, WorkerError
from .workers import processes

Result = TypeVar("Result")
# A process of ours has one processor: linear algebra that started threads of its own would only wait for others.
_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


class Crew:
    """Does a task for each of many jobs; `done` is called as each comes back."""

    def __init__(self, executor: Executor | None = None, done: Callable[[int], None] = lambda count: None) -> None:
        self._executor = executor
        self._done = done

    def each(self, task: Callable[..., Result], jobs: Sequence[tuple[Any, ...]]) -> list[Result]:
        """What comes of each job, in their order; raises what a task raises, and WorkerError where one is lost."""
        return list(self.stream(task, jobs))

    def stream(self, task: Callable[..., Result], jobs: Sequence[tuple[Any, ...]]) -> Iterator[Result]:
        """What comes of each job as soon as it and those before it are done; raises as `each`."""
        for result in self._begun(task, jobs):
            found = result()
            self._done(1)
            yield found

    def _begun(self, task: Callable[..., Result], jobs: Sequence[tuple[Any, ...]]) -> list[Callable[[], Result]]:
        if self._executor is None:
            return [partial(task, *job) for job in jobs]
        futures = [self._executor.submit(task, *job) for job in jobs]
        return [partial(_result, one) for one in futures]


def _result(future: Future[Result]) -> Result:
    try:
        return future.result()
    except InputError:
        raise
    except Exception as error:
        raise WorkerError(0, f"{type(error).__name__}: {error}") from error


@contextmanager
def crew(workers: int, done: Callable[[int], None]) -> Iterator[Crew]:
    """So many processes, which end with the block; for one, this process."""
    if workers == 1:
        yield Crew(None, done)
        return
    for name in _THREADS:
        os.environ.setdefault(name, "1")
    with processes(workers) as executor:
        yield Crew(executor, done)
