"""From a preset to a table with balls on it; the only part that knows pymunk."""
