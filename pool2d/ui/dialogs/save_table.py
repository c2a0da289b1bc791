"""The question for a name under which the table that is played on is saved as the player's own preset."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ...errors import InputError
from ...table.preset import differences, save_preset
from ...table.table import Table
from ..scene import Scene
from .dialog import TextPrompt


def ask_to_save(below: Scene, table: Table, saved: Callable[[Path], None]) -> TextPrompt:
    """A dialog that asks for a preset's name and saves the table; `saved` is called with the file's path."""
    say = below.words.say

    def save(name: str) -> str:
        try:
            path = save_preset(name, table.source, differences(table), name)
        except InputError as error:
            return error.allowed
        saved(path)
        return ""

    return TextPrompt(
        below, say("saving.title"), say("saving.name"), f"{say('saving.my')}-{Path(table.source).stem}", save
    )
