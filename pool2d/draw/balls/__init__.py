"""Balls as lit spheres, pixel by pixel."""
