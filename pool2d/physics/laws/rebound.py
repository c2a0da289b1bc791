"""How fast two bodies part."""

from __future__ import annotations

from typing import Final

# Two bodies that meet more slowly than this part as fast as they met, m/s. Viscoelastic contacts do
# become elastic as they slow (Brilliantov & Poeschel 2004), and it ends the bouncing of a ball that
# its own spin presses on a cushion: it would otherwise take endlessly many bounces in a finite time.
GENTLE: Final = 5e-3


def rebound(approach: float, restitution: float) -> float:
    """The speed at which two bodies part that met at `approach`, both positive, m/s."""
    return max(restitution * approach, min(approach, GENTLE))
