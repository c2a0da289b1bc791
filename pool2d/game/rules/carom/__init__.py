"""The games of carom."""
