"""Balls off the cloth: how they fall, what they meet in the air, and how they part from it."""
