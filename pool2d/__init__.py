"""pool2d: a 2D pool table whose physics can be trusted.

The names are fetched when they are first asked for, so that the window can open before physics and tables are read.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._version import __version__
from .lazy import fetched

if TYPE_CHECKING:
    from .errors import BudgetError, InputError, WorkerError
    from .physics.event import Event
    from .physics.rollout import Rollout
    from .physics.simulate import simulate
    from .physics.values import Ball, Layout, Shot
    from .study.simulate_many import simulate_many
    from .study.summaries import Summaries
    from .table.clearance import Clearance, least_elevation
    from .table.preset import load_table
    from .table.scenario import Scenario, load_scenario
    from .table.table import Table
else:
    __getattr__, __dir__ = fetched(
        __name__,
        {
            "errors": ("BudgetError", "InputError", "WorkerError"),
            "physics.rollout": ("Event", "Rollout"),
            "physics.simulate": ("simulate",),
            "physics.values": ("Ball", "Layout", "Shot"),
            "study.simulate_many": ("simulate_many",),
            "study.summaries": ("Summaries",),
            "table.clearance": ("Clearance", "least_elevation"),
            "table.preset": ("load_table",),
            "table.scenario": ("Scenario", "load_scenario"),
            "table.table": ("Table",),
        },
    )

__all__ = [
    "Ball",
    "BudgetError",
    "Clearance",
    "Event",
    "InputError",
    "Layout",
    "Rollout",
    "Scenario",
    "Shot",
    "Summaries",
    "Table",
    "WorkerError",
    "__version__",
    "least_elevation",
    "load_scenario",
    "load_table",
    "simulate",
    "simulate_many",
]
