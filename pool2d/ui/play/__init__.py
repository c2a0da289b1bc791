"""Playing: the state, the hands that change it, and its view."""
