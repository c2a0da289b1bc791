"""The catalogues of words: the same keys and places in each, none missing, none idle, and none in the code instead."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from pool2d.config import catalogue
from pool2d.config.assets import asset
from pool2d.config.knobs import walk
from pool2d.config.reader import read_toml
from pool2d.config.settings import GUIDES, Settings
from pool2d.fit.measurements import MEASUREMENTS
from pool2d.game.drills.drill import MISSES
from pool2d.game.explained import ENGLISH as REASONS
from pool2d.game.rules import GAMES
from pool2d.game.rules.notes import ENGLISH as RULINGS
from pool2d.game.setup import BREAKS
from pool2d.table.preset import conditions, title_of
from pool2d.table.table_knobs import Knobs
from pool2d.ui.dialogs.options import PAGES, PALETTES
from pool2d.ui.play import by_hand_page, tuning_panel
from pool2d.ui.stage import timeline
from pool2d.ui.stage.legend import LEGEND
from pool2d.ui.wording import words as words_module
from pool2d.ui.wording.keys import DEFAULTS, FIXED, HANDS, rows
from pool2d.ui.wording.words import Words, languages, places
from pool2d.ui.wording.words import catalogue as catalogue_of

PACKAGE = Path(words_module.__file__).parents[2]
SOURCES = sorted([*(PACKAGE / "ui").rglob("*.py"), *(PACKAGE / "draw").rglob("*.py")])
# What shows its words to the player.
SHOWS = {"draw", "Heading", "Button", "Toggle", "Choice", "Slider", "TextField", "toast", "Ask", "draw_message"}
NAMES = {"pool2d"}
ENGLISH = catalogue_of("en").texts
KNOBS = {f"knob.{name}": knob for name, knob, _ in walk(Knobs())}
OPTIONS = {(game, name): knob for game, rules in GAMES.items() for name, knob, _ in walk(rules.options_type())}
# What English takes from the knobs and the rules themselves.
ELSEWHERE = (
    {f"{key}_hint": knob.doc for key, knob in KNOBS.items()}
    | {f"game.{name}": rules.title for name, rules in GAMES.items()}
    | {f"option.{GAMES[game].options_type.home(name)}.{name}_hint": knob.doc for (game, name), knob in OPTIONS.items()}
    | {f"ruling.{key}": text for key, text in RULINGS.items()}
    | {f"why.{key}": text for key, text in REASONS.items()}
    | {
        f"drills.{name}.{part}": str(read_toml(catalogue.find(catalogue.DRILLS, name))[part])
        for name in catalogue.shipped(catalogue.DRILLS)
        for part in ("name", "text")
    }
    | {f"table.{name}": title_of(name) for name in catalogue.shipped(catalogue.TABLES)}
)


def called(node: ast.AST) -> str:
    """The name of the function that is called, if one is."""
    function = node.func if isinstance(node, ast.Call) else None
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def asked() -> Iterator[tuple[str, str]]:
    """Every key that the window asks for, as a pattern, and where."""
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if called(node) not in ("say", "say_or", "known"):
                continue
            assert isinstance(node, ast.Call)
            key = node.args[0] if node.args else None
            counted = r"(\.one)?" if any(place.arg == "count" for place in node.keywords) else ""
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                yield re.escape(key.value) + counted, path.name
            elif isinstance(key, ast.JoinedStr):
                parts = [re.escape(str(part.value)) if isinstance(part, ast.Constant) else ".+" for part in key.values]
                yield "".join(parts), path.name


@pytest.mark.parametrize("language", languages())
def test_a_catalogue_reads_well(language: str) -> None:
    read = catalogue_of(language)
    assert read.complaints == []
    assert all(text.strip() for text in read.texts.values())


@pytest.mark.parametrize("language", languages())
def test_every_language_says_everything(language: str) -> None:
    wanted = set(ENGLISH) | set(() if language == "en" else ELSEWHERE)
    assert set(catalogue_of(language).texts) == wanted


@pytest.mark.parametrize("language", languages())
def test_every_language_has_the_same_places_to_fill(language: str) -> None:
    texts = catalogue_of(language).texts
    assert texts
    for key, text in texts.items():
        assert places(text) == places((ENGLISH | ELSEWHERE)[key]), key


def test_what_an_option_does_is_translated_once() -> None:
    homes = {(GAMES[game].options_type.home(name), name): knob.doc for (game, name), knob in OPTIONS.items()}
    assert all(homes[GAMES[game].options_type.home(name), name] == knob.doc for (game, name), knob in OPTIONS.items())
    assert {home for home, name in homes if name in ("three_foul", "points")} == {
        "rotation", "straight", "one-pocket", "carom", "four-ball",
    }  # fmt: skip


def test_every_text_asked_for_is_there() -> None:
    patterns = list(asked())
    assert patterns
    for pattern, where in patterns:
        assert any(re.fullmatch(pattern, key) for key in ENGLISH | ELSEWHERE), f"{where} asks for {pattern}"


def test_no_text_is_idle() -> None:
    patterns = [pattern for pattern, _ in asked()]
    idle = [key for key in ENGLISH if not any(re.fullmatch(pattern, key) for pattern in patterns)]
    # The language's own name is read from its catalogue.
    assert idle == ["language.name"]


def test_everything_named_in_tables_has_its_texts() -> None:
    wanted = [f"help.{actions[0]}" for actions in rows()]
    wanted += [f"action.{action}" for action in DEFAULTS if action not in FIXED]
    wanted += [f"hand.{name}.{part}" for name in HANDS for part in ("name", "does")]
    wanted += [f"options.page.{page}" for page in PAGES]
    wanted += [f"choice.{value}" for value in (*GUIDES, *PALETTES)]
    turned = [name for name, _, _ in walk(Settings()) if name not in ("screen.width", "screen.height")]
    wanted += [f"setting.{name}{ending}" for name in turned for ending in ("", "_hint")]
    wanted += [*KNOBS, *(f"choice.{value}" for knob in KNOBS.values() for value in knob.choices)]
    wanted += [f"condition.{name}" for name in conditions()]
    wanted += [f"tuning.page.{page}" for page in tuning_panel.PAGES]
    wanted += [f"by_hand.{name}{ending}" for row in by_hand_page.ROWS for name in row for ending in ("", "_hint")]
    wanted += [f"by_hand.knob.{each.turns}" for each in MEASUREMENTS]
    wanted += [f"timeline.{action}" for action in timeline.TIMELINE_KEYS.values()]
    wanted += [f"vectors.{name}" for _, name in LEGEND]
    wanted += [f"match.breaks_by.{name}" for name in BREAKS]
    wanted += [f"option.{name}" for _, name in OPTIONS]
    wanted += [f"choice.{value}" for knob in OPTIONS.values() for value in knob.choices]
    wanted += [f"drill.missed.{key}" for key in MISSES]
    assert [key for key in wanted if key not in ENGLISH] == []


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.name)
def test_no_words_stand_in_the_code(path: Path) -> None:
    shown = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if called(node) in SHOWS:
            assert isinstance(node, ast.Call)
            for value in (*node.args, *(keyword.value for keyword in node.keywords)):
                value = value.body if isinstance(value, ast.Lambda) else value
                if isinstance(value, ast.Constant) and isinstance(value.value, str) and value.value not in NAMES:
                    shown.append(value.value)
    assert not [text for text in shown if re.search(r"[^\W\d_]{2}", text)]


def test_another_language_says_it_otherwise() -> None:
    words = Words()
    words.speak("de")
    assert words.say("form.cancel") == "Abbrechen"
    assert words.number(2.5, ".2f") == "2,50"
    words.speak("en")
    assert words.say("form.cancel") == "Cancel"
    assert words.number(2.5, ".2f") == "2.50"


def test_auto_is_the_systems_language_and_english_where_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    words = Words()
    for variable in ("LC_ALL", "LC_MESSAGES"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv("LANG", "de_AT.UTF-8")
    words.speak("auto")
    assert words.say("form.save") == "Speichern"
    monkeypatch.setenv("LANG", "tlh_KX.UTF-8")
    words.speak("auto")
    assert words.say("form.save") == "Save"


def test_places_are_filled_and_what_is_missing_is_left_standing() -> None:
    words = Words()
    assert words.say("window.picture_saved", path="here.png") == "Saved here.png"
    assert words.say("window.picture_saved") == "Saved {path}"
    assert words.say("no.such.text") == "no.such.text"


@pytest.mark.parametrize(("unit", "said"), [("m/s", "2.50 m/s"), ("km/h", "9.0 km/h"), ("mph", "5.6 mph")])
def test_speeds_are_told_in_the_players_unit(unit: str, said: str) -> None:
    words = Words()
    words.speed_unit = unit
    assert words.speed(2.5) == said


def test_a_damaged_catalogue_is_told_and_english_stands_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    words = Words()
    (tmp_path / "de.toml").write_text('[form]\ncancel = "Ab {"\nsave = "Behalten"\nclose = 3\n')

    def find(folder: str, name: str) -> Path:
        return tmp_path / name if name == "de.toml" else asset(folder, name)

    monkeypatch.setattr(words_module, "asset", find)
    catalogue_of.cache_clear()
    try:
        assert [error.key for error in words.speak("de")] == ["form.cancel", "form.close"]
        assert words.say("form.save") == "Behalten"
        assert words.say("form.cancel") == "Cancel"
        (tmp_path / "de.toml").write_bytes(b"\xff")
        catalogue_of.cache_clear()
        assert len(words.speak("de")) == 1
        assert words.say("form.save") == "Save"
    finally:
        catalogue_of.cache_clear()
