"""What the rules and the drills say, in the player's language."""

from __future__ import annotations

import pytest

from pool2d.config.knobs import walk
from pool2d.draw import text
from pool2d.game.drills.drill import MISSES
from pool2d.game.drills.drill_file import drills, load
from pool2d.game.rules import GAMES, Note, label, say
from pool2d.game.rules.notes import ENGLISH
from pool2d.ui.wording import ruling_text
from pool2d.ui.wording.words import Words, languages

NAMES = ("Ann", "Bob")
NOTES = [key for key in ENGLISH if not key.startswith("choice.")]
CHOICES = [key.removeprefix("choice.") for key in ENGLISH if key.startswith("choice.")]


@pytest.fixture
def words() -> Words:
    """What is said, in English at first."""
    return Words()


@pytest.mark.parametrize("key", NOTES)
@pytest.mark.parametrize("ball", ["3", "cue", "red7", "black"])
def test_english_is_what_the_rules_say(words: Words, key: str, ball: str) -> None:
    note = Note(key, 1, ball, 4)
    assert ruling_text.note_text(words, note, NAMES) == say(note, NAMES)


@pytest.mark.parametrize("key", CHOICES)
def test_an_option_in_english_is_what_the_rules_call_it(words: Words, key: str) -> None:
    about = {"group": ":red", "start-spot": ":left"}.get(key, "")
    assert ruling_text.option(words, key + about) == label(key + about)
    assert ruling_text.option(words, "pocket:top-right") == "The top right pocket"


@pytest.mark.parametrize("key", NOTES)
def test_german_says_every_note_otherwise(words: Words, key: str) -> None:
    note = Note(key, 1, "red7", 4)
    english = ruling_text.note_text(words, note, NAMES)
    words.speak("de")
    german = ruling_text.note_text(words, note, NAMES)
    assert german.endswith(".") and "{" not in german and not german[0].islower()
    # "Free Ball" is what it is called in German, too.
    assert (german.lower() == english.lower()) == (key == "free-ball")


@pytest.mark.parametrize(
    ("note", "german"),
    [
        (Note("foul.off", ball="3"), "Kugel 3 hat den Tisch verlassen."),
        (Note("foul.over", ball="3", where="top"), "Kugel 3 hat den Tisch über die Bande oben verlassen."),
        (Note("foul.cue-over", where="top-left"), "Der Spielball hat den Tisch über die Bande oben links verlassen."),
        (Note("foul.on-rail", ball="red2", where="left"), "Rot ist auf dem Rahmen liegen geblieben, links."),
        (Note("foul.jump", ball="black"), "Der Spielball ist über Schwarz gesprungen."),
        (Note("foul.wrong-ball", ball="red7"), "Rot wurde zuerst getroffen und war nicht an der Reihe."),
        (Note("spotted", ball="cue"), "Weiß wird wieder aufgesetzt."),
        (Note("score", 1, points=1), "Punkte für Bob: 1."),
        (Note("foul.double-hit", ball="12"), "Das Leder lag noch am Spielball, als er Kugel 12 traf."),
        (Note("in-hand.kitchen", 0), "Ann hat den Spielball in der Hand, im Kopffeld."),
        (Note("draw"), "Unentschieden."),
    ],
)
def test_a_note_in_german(words: Words, note: Note, german: str) -> None:
    words.speak("de")
    assert ruling_text.note_text(words, note, NAMES) == german


@pytest.mark.parametrize(
    ("key", "german"),
    [
        ("play", "Spielen"),
        ("group:yellow", "Gelb spielen"),
        ("start-spot:left", "Vom Punkt links"),
        ("pocket:top-right", "Tasche oben rechts"),
    ],
)
def test_an_option_in_german(words: Words, key: str, german: str) -> None:
    words.speak("de")
    assert ruling_text.option(words, key) == german


@pytest.mark.parametrize("language", languages())
def test_a_choice_fits_its_button(words: Words, language: str) -> None:
    words.speak(language)
    keys = {"group": "group:yellow", "start-spot": "start-spot:right", "pocket": "pocket:bottom-right"}
    for key in CHOICES:
        label = ruling_text.option(words, keys.get(key, key))
        assert text.fitted(label, 14, 184) == label


@pytest.mark.parametrize("game", GAMES)
def test_a_game_and_its_options_are_told_in_both_languages(words: Words, game: str) -> None:
    told = {}
    for language in ("en", "de"):
        words.speak(language)
        told[language] = [ruling_text.title(words, game)]
        for name, knob, _ in walk(GAMES[game].options_type()):
            told[language] += [ruling_text.setting(words, name), ruling_text.setting_hint(words, game, name, knob.doc)]
            assert (told[language][-1] == knob.doc) == (language == "en")
    assert told["en"][0] == GAMES[game].title
    # "Snooker" is what it is called in German, too.
    assert (told["en"][0] == told["de"][0]) == (game == "snooker")


@pytest.mark.parametrize("name", drills())
def test_a_shipped_drill_is_told_in_german(words: Words, name: str) -> None:
    drill = load(name)
    assert ruling_text.wording(words, drill) == (drill.name, drill.text)
    words.speak("de")
    german = ruling_text.wording(words, drill)
    assert german.text.endswith(".") and german.text != drill.text
    assert (german.name == drill.name) == (name == "line-up")


def test_what_a_stroke_missed_is_told(words: Words) -> None:
    assert ruling_text.missed(words, "") == ""
    assert ruling_text.missed(words, "wrong_first") == "The wrong ball was hit first."
    english = {key: ruling_text.missed(words, key) for key in MISSES}
    words.speak("de")
    assert ruling_text.missed(words, "wrong_first") == "Die falsche Kugel wurde zuerst getroffen."
    assert all(ruling_text.missed(words, key) != english[key] for key in MISSES)
