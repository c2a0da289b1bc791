"""Which way a session is played."""

from __future__ import annotations

from ..mode import Mode
from ..state import PlayState
from .match_mode import MatchMode
from .opponent_mode import OpponentMode
from .practice_mode import PracticeMode


def mode_of(state: PlayState) -> Mode:
    """How the session of a state is played, where it is no drill's."""
    session = state.session
    if session.is_practice:
        return PracticeMode(session, state.words)
    if session.match.setup.players:
        return OpponentMode(state)
    return MatchMode(session, state.words, state.calls, state.in_hand)
