"""Tests of players at work without a screen."""
