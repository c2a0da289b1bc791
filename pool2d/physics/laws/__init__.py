"""How bodies that touch change their velocities: the laws that a preset can name."""
