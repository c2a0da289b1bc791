"""Drawing, and a person at the table, without a screen."""

from ..ui.conftest import data, guest, hand, two

__all__ = ["data", "guest", "hand", "two"]
