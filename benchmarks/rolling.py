"""What a rolling resistance that rises with speed would change: `python -m benchmarks.rolling`.

Tracked shots on heated carom cloth have mu = a + b v with a = 0.0039 and b = 0.0018 s/m. A ball that slows by
v' = -(a + b v) g has a closed form, exponentials of time; two such balls meet at a root of no polynomial, while the
engine's every root is one of a quartic. This prints how far a ball rolls by that law and by the one coefficient that
the preset has, and by how much they differ where a shot is decided: over its first lengths of the table.
"""

from __future__ import annotations

import math

from pool2d import load_table

BASE, SLOPE = 0.0039, 0.0018
GRAVITY = 9.81


def rising(speed: float, time: float) -> float:
    """How far a ball has rolled after a time whose resistance rises with its speed, m."""
    decay = SLOPE * GRAVITY
    stop = math.log1p(SLOPE * speed / BASE) / decay
    time = min(time, stop)
    return (speed + BASE / SLOPE) * -math.expm1(-decay * time) / decay - BASE / SLOPE * time


def level(speed: float, time: float, mu: float) -> float:
    """The same with one coefficient."""
    time = min(time, speed / (mu * GRAVITY))
    return speed * time - 0.5 * mu * GRAVITY * time * time


def main() -> None:
    table = load_table("carom-10ft")
    mu, length = table.knobs.cloth.mu_roll, table.knobs.table.length
    print(f"{'speed':>6} {'rolls, rising':>14} {'level':>8}   apart after one length, two, at rest, cm")
    for speed in (0.3, 0.5, 1.0, 1.5, 2.0, 3.0):
        ends = rising(speed, math.inf), level(speed, math.inf, mu)
        apart = []
        for way in (length, 2.0 * length):
            root = speed * speed - 2.0 * mu * GRAVITY * way
            if root < 0.0:
                apart.append("      -")
                continue
            time = (speed - math.sqrt(root)) / (mu * GRAVITY)
            apart.append(f"{100.0 * (rising(speed, time) - way):7.1f}")
        print(f"{speed:6.1f} {ends[0]:12.2f} m {ends[1]:6.2f} m {' '.join(apart)} {100.0 * (ends[0] - ends[1]):8.1f}")


if __name__ == "__main__":
    main()
