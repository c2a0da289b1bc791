"""Every parameter of a table: its physics, its size, its pockets."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..physics.params import Physics
from .geometry import CornerKnobs, SideKnobs, TableKnobs


@dataclass(frozen=True, slots=True)
class Knobs(Physics):
    """Every parameter of a table."""

    table: TableKnobs = field(default_factory=TableKnobs)
    corner: CornerKnobs = field(default_factory=CornerKnobs)
    side: SideKnobs = field(default_factory=SideKnobs)
