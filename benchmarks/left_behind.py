"""Whether a window that ends leaves a process behind: `python -m benchmarks.left_behind [--kills 100] [--seed 0]`.

A window in which two players play each other is started without a screen, and ended at a random moment from its start
on: killed, ended, interrupted, or closed as a player closes it. A moment later nothing that it started may be there;
what was started is known by a variable of its environment, which only Linux tells. Prints what stayed, and how much was
seen to run at all; the exit status is 1 if anything stayed.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import uuid
from pathlib import Path

_MARK = "POOL2D_LEFT_BEHIND"
# A window lives so long at most, s, and what it started may stay so long after it.
_LIFE, _PATIENCE = 5.0, 3.0
_CLOSED = "closed"
_WAYS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, _CLOSED)

# Plays until its standard input is closed, which closes the window.
_WINDOW = """
import os, select, sys
import pygame
from pool2d import load_table
from pool2d.game.session import recorded
from pool2d.game.setup import Setup
from pool2d.ui.app import App

table = load_table("pool-9ft")
app = App(table, seed=0, size=(640, 360))
app.play.state.begin(recorded(table, Setup("eight-ball", players=("greta", "marek"), seed=int(sys.argv[1]))))
print("plays", flush=True)
while app.step(1.0 / 60.0):
    pygame.time.wait(5)
    if select.select([sys.stdin], [], [], 0.0)[0]:
        pygame.event.post(pygame.event.Event(pygame.QUIT))
"""


def started(mark: str) -> list[int]:
    """The processes that run with this mark."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if f"{_MARK}={mark}\0".encode() in (folder / "environ").read_bytes():
                found.append(int(folder.name))
        except OSError:
            # It is gone, or another's.
            continue
    return found


def end_one(seed: int, folder: str) -> tuple[int, list[int], str]:
    """Start a window and end it: how many processes there were, which stayed, and how it ended."""
    rng, mark = random.Random(seed), uuid.uuid4().hex
    drivers = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "POOL2D_DATA": folder, "POOL2D_CONFIG": folder}
    window = subprocess.Popen(
        [sys.executable, "-c", _WINDOW, str(seed)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={**os.environ, **drivers, _MARK: mark},
    )
    time.sleep(rng.uniform(0.0, _LIFE))
    there, way = len(started(mark)), rng.choice(_WAYS)
    if isinstance(way, signal.Signals):
        window.send_signal(way)
    _, complaints = window.communicate(timeout=60)
    deadline = time.monotonic() + _PATIENCE
    while (stayed := started(mark)) and time.monotonic() < deadline:
        time.sleep(0.05)
    faults = [line for line in complaints.decode().splitlines() if "Error" in line]
    return there, stayed, "; ".join([str(way), *faults])


def main(kills: int, seed: int) -> int:
    seen, faults = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(seed, seed + kills):
            there, stayed, how = end_one(number, folder)
            seen += there
            faults += bool(stayed)
            if stayed or "Error" in how:
                print(f"seed {number}: {how}; {len(stayed)} of {there} processes stayed", flush=True)
            for process in stayed:
                os.kill(process, signal.SIGKILL)
    print(f"{kills} windows ended, {seen} processes running at that moment, {faults} times something stayed")
    return 1 if faults else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    sys.exit(main(chosen.kills, chosen.seed))
