"""Positions with goals: what they are, how strokes are judged, where they are kept."""
