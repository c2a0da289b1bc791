"""The physics of balls on a cloth: standard library only, plain scalar floats, SI units.

x runs along the table, y across it, z up; angles in degrees counter-clockwise from +x.
"""

from ..compiled import choose

choose()
