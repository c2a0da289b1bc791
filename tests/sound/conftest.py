"""The sounds of a table without a device."""

from ..ui.conftest import data, guest, hand, two

__all__ = ["data", "guest", "hand", "two"]
