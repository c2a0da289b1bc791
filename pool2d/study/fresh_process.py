"""Processes that are started afresh, that no Ctrl-C reaches, and that end with whoever started them."""

from __future__ import annotations

import os
import signal
import threading
from importlib import import_module
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnContext, SpawnProcess


class FreshProcess(SpawnProcess):
    """A process that no Ctrl-C reaches while it starts: it is held back until `attend` has it ignored."""

    def start(self) -> None:
        if not hasattr(signal, "pthread_sigmask"):
            super().start()
            return
        # It would lift the block as it starts, so it has to run before.
        resource_tracker.ensure_running()
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
        try:
            super().start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)


class FreshContext(SpawnContext):
    """Makes such processes: a copy of one that has threads or a window may hang."""

    Process = FreshProcess


def attend(line: Connection) -> None:
    """What a process does first. Ctrl-C goes to all of a terminal's processes; that it ends is for us to say.

    Nothing is ever sent over the line: that its other end is closed, by whoever started the process or by their
    death, is what is waited for.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_leave_with, args=(line,), daemon=True).start()


def attended(alive: Connection, module: str, name: str, *args: object) -> None:
    """Attend to a line, and only then fetch and call a function: we may go while it is being imported."""
    attend(alive)
    getattr(import_module(module), name)(*args)


def _leave_with(line: Connection) -> None:
    """End this process when the other end of the line is closed, whatever it is doing."""
    line.poll(None)
    os._exit(1)
