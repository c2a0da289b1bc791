"""The strokes that a player thinks of, each found by geometry or by looking round, and refined on the engine."""
