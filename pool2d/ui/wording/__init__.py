"""What the window says, in the player's language."""
