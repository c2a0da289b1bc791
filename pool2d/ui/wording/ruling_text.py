"""What the rules, the drills and the presets say, in the player's language.

Their English is their own: a catalogue has `game.<game>`, `ruling.<key>`, `option.<file>.<option>_hint`,
`table.<preset>` and `drills.<drill>` only in another language.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from string import digits

from ...game.drills.drill import Drill, Wording
from ...game.match import Match, Moment
from ...game.rules import GAMES, Note
from ...game.rules import notes as rules
from ...table.table import Table
from .shot_text import ball_name, place_name
from .words import Words


def note_text(words: Words, note: Note, names: Sequence[str]) -> str:
    """A note of a ruling as a sentence; `names` are the players'."""
    return rules.say(note, names, _template(words, note.key), partial(ball, words), partial(place_name, words))


def option(words: Words, key: str) -> str:
    """What one of `Ask.options` is called."""
    called = partial(ball if key.startswith("group:") else place_name, words)
    return rules.label(key, _template(words, "choice." + key.partition(":")[0]), called)


def title(words: Words, game: str) -> str:
    """The title of a game."""
    return words.say_or(f"game.{game}", GAMES[game].title)


def table_title(words: Words, table: Table) -> str:
    """What a table is called."""
    return preset_title(words, table.source, table.title)


def preset_title(words: Words, name: str, own: str) -> str:
    """What the table of a preset is called; its own title, where the language has no other for it."""
    return words.say_or(f"table.{name}", own)


def setting(words: Words, name: str) -> str:
    """What is set by one of a game's options; what its values are called is `choice.<value>`."""
    return words.say(f"option.{name}")


def setting_hint(words: Words, game: str, name: str, doc: str) -> str:
    """What one of a game's options does; `doc` is what its knob says, in English."""
    return words.say_or(f"option.{GAMES[game].options_type.home(name)}.{name}_hint", doc)


def wording(words: Words, drill: Drill) -> Wording:
    """A drill's name and text; in English, or what language it was written in, where it is not translated."""
    own = drill.wording_in(words.language)
    return Wording(words.say_or(f"drills.{drill.id}.name", own.name), words.say_or(f"drills.{drill.id}.text", own.text))


def missed(words: Words, key: str) -> str:
    """Why a stroke did not do what a drill wants, from `Standing.missed`."""
    return words.say(f"drill.missed.{key}") if key else ""


def verdict(words: Words, moment: Moment, match: Match) -> str:
    """What fell in a stroke of a match, and what the ruling says of it."""
    said = []
    report = moment.report
    if report is not None and report.call.push:
        said.append(words.say("referee.pushed", player=match.names[moment.shooter]))
    # A struck ball falls without foul only where that is a point.
    fallen = () if report is None else report.potted if moment.ruling.foul else report.fallen
    if fallen:
        said.append(words.say("referee.fell", balls=", ".join(ball(words, match.rules.spoken(one)) for one in fallen)))
    elif report is not None and not moment.ruling.foul and match.table.geometry.pockets:
        said.append(words.say("referee.none_fell"))
    elif report is not None and not moment.ruling.foul and not any(moment.ruling.points):
        said.append(words.say("referee.no_point"))
    return " ".join([*said, *(note_text(words, note, match.names) for note in moment.ruling.notes)])


def _template(words: Words, key: str) -> dict[str, str]:
    return {key: words.say_or(f"ruling.{key}", rules.ENGLISH[key])}


def ball(words: Words, name: str) -> str:
    """What a ball is called in a sentence, as by the rules' `ball_name`: one of many alike has no number."""
    if name.isdigit():
        return words.say("ball.numbered", number=name)
    return ball_name(words, "white" if name == "cue" else name.rstrip(digits), "cue")
