"""The figures of `docs/physics.md`, drawn from the engine: `python -m docs.figures`.

Needs the optional extra: `pip install -e '.[figures]'`. Lines are what pool2d does; dots are published.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from itertools import takewhile
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Circle

from benchmarks.targets import CORNER, INCH, TP_3_6, target
from pool2d import Ball, Event, Layout, Rollout, Table, load_table, simulate
from pool2d.physics.materials import materials

HERE = Path(__file__).parent / "figures"
_DATA = json.loads((Path(__file__).parents[1] / "tests" / "contacts.json").read_text(encoding="utf-8"))
CASES: dict[str, dict[str, Any]] = {case["id"]: case for case in _DATA}
TABLE = load_table("pool-9ft")
RADIUS = TABLE.knobs.ball.radius
COLORS = ("#14746f", "#c8812a", "#8e2f4a", "#3b5b92")


def first(rollout: Rollout, *kinds: str) -> Event:
    """The first event of one of these kinds."""
    return next(event for event in rollout.events if event.kind in kinds)


def direction(ball: Ball) -> float:
    """Where a ball is going, degrees."""
    return math.degrees(math.atan2(ball.vy, ball.vx))


def cut_shot(table: Table, cut: float, speed: float, roll: float, side: float = 0.0) -> Event:
    """The contact of a cue ball with a ball at a cut angle, travelling along +x; `roll` is R w / v."""
    angle = math.radians(cut)
    one = Ball("1", 1.27, 0.635)
    gap = 1e-7
    x = one.x - (2.0 * RADIUS + gap) * math.cos(angle)
    y = one.y - (2.0 * RADIUS + gap) * math.sin(angle)
    cue = Ball("cue", x, y, vx=speed, wy=roll * speed / RADIUS, wz=side * speed / RADIUS)
    return first(simulate(table, Layout([cue, one]), events=4), "ball_ball")


def settled(table: Table, ball: Ball) -> tuple[float, float]:
    """The velocity at which a ball comes to roll."""
    ux, uy = ball.vx - RADIUS * ball.wy, ball.vy + RADIUS * ball.wx
    return ball.vx - 2.0 / 7.0 * ux, ball.vy - 2.0 / 7.0 * uy


def throw(axes: Axes) -> None:
    """Cut-induced throw: friction drags the object ball off the line of centres."""
    table = TABLE.with_knobs({"ball.restitution": 1.0})
    cuts = [0.5 * i for i in range(2, 170)]
    for color, name in zip(COLORS, ("slow", "medium", "fast"), strict=False):
        case = CASES[f"B12_stun_{name}"]
        speed = case["inputs"]["v_mps"]
        thrown = [cut - direction(cut_shot(table, cut, speed, 0.0).after["1"]) for cut in cuts]
        axes.plot(cuts, thrown, color=color, label=f"{speed} m/s")
        axes.plot(case["inputs"]["cut_deg"], case["expected"]["throw_deg"], "o", color=color, markersize=4)
    axes.set(xlabel="cut angle, degrees", ylabel="throw, degrees", title="Throw of a stun shot")
    axes.legend()


def thirty_degrees(axes: Axes) -> None:
    """The 30-degree rule: where a rolling cue ball goes after hitting another."""
    cuts = [0.5 * i for i in range(2, 178)]
    for color, (name, knobs) in zip(
        COLORS,
        {"smooth, e = 1": {"ball.restitution": 1.0, "ball.law": "frictionless"}, "the preset's balls": {}}.items(),
        strict=False,
    ):
        table = TABLE.with_knobs(knobs)
        bent = []
        for cut in cuts:
            vx, vy = settled(table, cut_shot(table, cut, 1.0, 1.0).after["cue"])
            bent.append(abs(math.degrees(math.atan2(vy, vx))))
        axes.plot(cuts, bent, color=color, label=name)
    case = CASES["B03"]
    axes.plot(case["inputs"]["cut_deg"], case["expected"]["deflection_deg"], "o", color=COLORS[0], markersize=4)
    axes.axhline(30.0, color="#999999", linewidth=0.8, linestyle="--")
    axes.set(xlabel="cut angle, degrees", ylabel="cue ball's deflection, degrees", title="The 30-degree rule")
    axes.legend()


def snooker() -> Table:
    """The cushion and the balls of Mathavan's measurements."""
    radius = 0.02625
    return TABLE.with_knobs({
        "ball.radius": radius, "ball.mass": 0.1406, "cushion.nose_height": 1.4 * radius, "cushion.restitution": 0.98,
        "cushion.friction": 0.14, "cloth.mu_slide": 0.212,
    })  # fmt: skip


def rebound(table: Table, incidence: float, roll: float, side: float) -> Ball:
    """A ball just after the top cushion that it met `incidence` degrees from the cushion's line, at 1 m/s."""
    radius = table.knobs.ball.radius
    angle = math.radians(incidence)
    vx, vy = math.cos(angle), math.sin(angle)
    y = table.knobs.table.width - table.reach(radius) - 1e-7
    cue = Ball("cue", 0.8, y, vx, vy, -roll * vy / radius, roll * vx / radius, side / radius)
    return first(simulate(table, Layout([cue]), events=4), "ball_cushion").after["cue"]


def cushions(axes: Axes) -> None:
    """The rebound of a rolling ball, without side spin, with running and with reverse english."""
    table = snooker()
    angles = list(range(4, 90))
    for color, (side, name, label) in zip(
        COLORS,
        ((0.0, "C04_k1", "no english"), (2.0, "C05_k2", "running, R w = 2 v"), (-1.0, "C05_k-1", "reverse, R w = v")),
        strict=False,
    ):
        case = CASES[name]
        out = [-direction(rebound(table, angle, 1.0, side)) for angle in angles]
        axes.plot(angles, out, color=color, label=label)
        at, points = case["inputs"]["incident_deg"], case["expected"]["rebound_angle_deg"]
        axes.plot(at, points, "o", color=color, markersize=4)
    axes.plot([0, 90], [0, 90], color="#999999", linewidth=0.8, linestyle="--")
    axes.set(
        xlabel="incidence from the cushion, degrees", ylabel="rebound, degrees", title="A rolling ball and a cushion"
    )
    axes.legend()


def friction(axes: Axes) -> None:
    """Friction between balls by slip: Marlow's three points and the default through them, and a match set's."""
    slips = [0.02 * i for i in range(1, 360)]
    for color, name, label in ((COLORS[0], "pool-9ft", "default"), (COLORS[1], "carom-10ft", "carom-10ft")):
        mu = materials(load_table(name).knobs).ball.friction
        axes.semilogx(slips, [mu.at(slip) for slip in slips], color=color, label=label)
    axes.plot([0.0707, 0.707, 7.07], [0.11, 0.06, 0.01], "o", color=COLORS[0], markersize=4, label="Marlow")
    axes.set(xlabel="slip, m/s", ylabel="coefficient of friction", title="Friction between balls")
    axes.legend()


def springing_back(axes: Axes) -> None:
    """By how much rubber that springs back along the rail turns a rolling ball, over its english."""
    table = load_table("carom-10ft")
    sides = [0.05 * i for i in range(-40, 41)]
    for color, incidence in zip(COLORS, (70.0, 55.0, 40.0), strict=False):
        ways = [
            [
                -direction(rebound(table.with_knobs({"cushion.tangential": value}), incidence, 1.0, side))
                for side in sides
            ]
            for value in (table.knobs.cushion.tangential, 0.0)
        ]
        turned = [without - there for there, without in zip(*ways, strict=True)]
        axes.plot(sides, turned, color=color, label=f"{90.0 - incidence:g} degrees from the normal")
    for seen, name in ((-1.9, "strong reverse"), (-1.6, "reverse"), (-0.6, "little"), (-0.1, "strong running")):
        axes.axhline(seen, color="#999999", linewidth=0.8, linestyle="--")
        axes.annotate(name, (2.1, seen + 0.05), fontsize=7, ha="right")
    axes.set(
        xlabel="english R w / v, running to the right", ylabel="degrees further from the normal",
        title="Rubber that springs back; dashed: tracked shots",
    )  # fmt: skip
    axes.legend()


def bend(axes: Axes) -> None:
    """Speed carries the cue ball down the tangent line before its roll bends it: half-ball hits."""
    table = TABLE.with_knobs({"ball.restitution": 1.0, "ball.law": "frictionless"})
    for color, speed in zip(COLORS, (1.0, 2.0, 3.0), strict=False):
        angle = math.radians(30.0)
        one = Ball("1", 1.27, 0.9)
        start = (one.x - 2.0 * RADIUS * math.cos(angle), one.y - 2.0 * RADIUS * math.sin(angle))
        cue = Ball("cue", start[0] - 1e-7, start[1], vx=speed, wy=speed / RADIUS)
        way = simulate(table, Layout([cue, one])).path("cue", 0.005)
        path = [(x - start[0], y - start[1]) for _, x, y in way]
        shown = list(takewhile(lambda at: at[0] < 0.5 and at[1] > -0.5, path))
        axes.plot([x for x, _ in shown], [y for _, y in shown], color=color, label=f"{speed:g} m/s")
    axes.plot(*CASES["B11_2"]["expected"]["slide_end_xy_m"], "o", color=COLORS[1], markersize=5)
    axes.set(
        xlabel="along the aim, m",
        ylabel="across it, m",
        title="The cue ball's bend after a half-ball hit",
        aspect="equal",
    )
    axes.legend()


def chain(axes: Axes) -> None:
    """Five balls in line, the first one moving: touching, and a little apart."""
    table = TABLE.with_knobs({"ball.restitution": 1.0, "ball.law": "frictionless"})
    for color, (name, gap) in zip(COLORS, {"touching": 0.0, "0.1 mm apart": 1e-4}.items(), strict=False):
        balls = [Ball(str(i), 0.6 + i * 2.0 * RADIUS + max(0, i - 1) * gap, 0.635) for i in range(5)]
        balls[0] = balls[0]._replace(vx=0.5)
        rollout = simulate(table, Layout(balls), events=12 if gap else 1)
        hits = [event for event in rollout.events if event.kind in ("ball_ball", "cluster") and event.t < 0.01]
        after = hits[-1].t
        axes.plot(
            range(1, 6), [rollout.ball_at(str(i), after).vx / 0.5 for i in range(5)], "-", color=color, label=name
        )
    axes.plot(range(1, 6), CASES["E01_5"]["expected"]["v"], "o", color=COLORS[0], markersize=5)
    axes.set(
        xlabel="ball", ylabel="velocity / that of the first before", title="A chain of five balls", xticks=range(1, 6)
    )
    axes.legend()


def rack(axes: Axes) -> None:
    """A tight rack struck square: velocities just after."""
    table = TABLE.with_knobs({"ball.restitution": 1.0, "ball.law": "frictionless"})
    balls = [Ball("cue", 1.7, 0.635, vx=8.0)]
    for i in range(5):
        for j in range(i + 1):
            x, y = 1.905 + i * math.sqrt(3.0) * RADIUS, 0.635 + (2 * j - i) * RADIUS
            balls.append(Ball(f"{len(balls):02d}", x, y))
    event = first(simulate(table, Layout(balls), events=4), "cluster")
    for ball in event.after.values():
        axes.add_patch(Circle((ball.x, ball.y), RADIUS, color="#e8e2d4" if ball.id == "cue" else "#d9ece8"))
        axes.annotate(
            "", (ball.x + 0.035 * ball.vx, ball.y + 0.035 * ball.vy), (ball.x, ball.y),
            arrowprops={"arrowstyle": "->", "color": COLORS[0], "lw": 1.4},
        )  # fmt: skip
    for ball, (vx, vy) in zip(balls, CASES["E05_15_1"]["expected"]["v"], strict=True):
        at = event.before[ball.id]
        axes.plot([at.x + 0.28 * vx], [at.y + 0.28 * vy], "o", color=COLORS[1], markersize=4)
    axes.set(xlim=(1.75, 2.38), ylim=(0.35, 0.92), aspect="equal", title="A tight rack, just struck square at 8 m/s")
    axes.set_xticks([])
    axes.set_yticks([])


def pockets(axes: Axes) -> None:
    """How wide a corner pocket is to balls at an angle off its axis, the slower the wider: Alciatore's pocket."""
    table = load_table("pool-9ft", CORNER)
    speeds = [0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0]
    for color, (angle, published) in zip(COLORS, TP_3_6.items(), strict=True):
        sizes = [target(table, "corner", angle, speed) / INCH for speed in speeds]
        axes.plot(speeds, sizes, color=color, label=f"{angle:.0f} degrees")
        axes.plot(1.4, published, "o", color=color, markersize=5)
    axes.set(
        xscale="log", ylim=(1.5, 4.2), xticks=speeds, xticklabels=[f"{speed:g}" for speed in speeds],
        xlabel="speed at the mouth, m/s", ylabel="target, inches", title="How large a corner pocket plays",
    )  # fmt: skip
    axes.minorticks_off()
    axes.legend()


FIGURES: dict[str, Callable[[Axes], None]] = {
    "throw": throw,
    "thirty-degrees": thirty_degrees,
    "friction": friction,
    "cushions": cushions,
    "springing-back": springing_back,
    "bend": bend,
    "chain": chain,
    "rack": rack,
    "pockets": pockets,
}


def main() -> None:
    HERE.mkdir(exist_ok=True)
    for name, draw in FIGURES.items():
        figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
        axes.grid(color="#eeeeee")
        draw(axes)
        figure.savefig(HERE / f"{name}.png", dpi=110)
        plt.close(figure)


if __name__ == "__main__":
    main()
