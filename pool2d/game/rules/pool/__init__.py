"""The games of pool."""
