"""pool2d: a 2D pool table whose physics can be trusted."""

from ._version import __version__
from .errors import BudgetError, InputError
from .physics.rollout import Event, Rollout
from .physics.simulate import simulate
from .physics.values import Ball, Layout, Shot
from .preset import load_table
from .scenario import Scenario, load_scenario
from .table import Table

__all__ = [
    "Ball",
    "BudgetError",
    "Event",
    "InputError",
    "Layout",
    "Rollout",
    "Scenario",
    "Shot",
    "Table",
    "__version__",
    "load_scenario",
    "load_table",
    "simulate",
]
