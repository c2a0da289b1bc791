"""The dialog in which a match is set up: what `MatchDraft` holds as widgets, and the players' names."""

from __future__ import annotations

from collections.abc import Callable

from ...config.knobs import Knob, walk
from ...config.settings import Store
from ...draw import theme
from ...errors import InputError
from ...game.rules import GAMES
from ...game.rules.base import YES_NO
from ...game.session import Session, recorded
from ...game.setup import BREAKS, COIN, LAG
from ...table.preset import title_of
from ...table.table import Table
from ..dialogs.dialog import Dialog
from ..scene import Scene
from ..widgets.field import TextField
from ..widgets.inputs import Selector
from ..widgets.widget import Button, Gap, Heading, Toggle, Widget
from ..wording import player_text, ruling_text
from ..wording.words import Words
from .match_draft import RACES, TUNED, MatchDraft

# What is offered for a number, as far as its range goes.
_LADDER = (*range(11), 12, 15, 20, 25, 30, 35, 40, 50, 60, 75, 80, 100, 125, 150, 200, 250, 300, 400, 500, 750, 1000)
# As many rows as the game with the most options takes, lest the panel jump from one game to the next.
_TALL = 5.0
_SETTINGS = ("players.first", "players.second")
_SIDES = ("players.first_by", "players.second_by")


class NewMatch(Dialog):
    """Sets up a match and has it begin: a game, and a table that it can be played on.

    What cannot be played is told, and nothing is lost. All that is agreed, in `draft`, is kept in `store`, and stands
    there the next time; `begin` leads to the match.
    """

    width = 64

    def __init__(self, below: Scene, store: Store, table: Table, begin: Callable[[Session], Scene]) -> None:
        super().__init__(below, "", [])
        self.store = store
        self.begin = begin
        self.draft = MatchDraft(store, table)
        # What went wrong with the last start.
        self.wrong = ""
        self.fields = [_name_field(self.words, number, name) for number, name in enumerate(store.values.players.names)]
        self._fill()

    @property
    def barred(self) -> str:
        """Why no match can start as it is set up; empty where one can."""
        say = self.words.say
        draft = self.draft
        if draft.error:
            return draft.error
        if draft.game and draft.fits(draft.preset):
            return ""
        table = self._title(draft.preset)
        if draft.game and any(draft.fits(draft.preset, game) for game in draft.games):
            return say("match.other_game", game=ruling_text.title(self.words, draft.game), table=table)
        return say("match.no_game", table=table)

    @property
    def names(self) -> tuple[str, ...]:
        """The players as they are called in the match."""
        first, second = (self._name(side) for side in range(2))
        # Who plays against themselves is told apart.
        return first, second if second != first else f"{second} 2"

    def start(self) -> None:
        """Begin the match; what speaks against it is told."""
        for name, field in zip(_SETTINGS, self.fields, strict=True):
            self.store.turn(name, field.value.strip())
        table = self.draft.table
        if table is None or self.barred:
            return
        self.draft.keep(self.store)
        try:
            session = recorded(table, self.draft.setup(self.names))
        except InputError as error:
            self.wrong = str(error)
            return
        self.go(self.begin(session))

    # What is on the panel.

    def _fill(self) -> None:
        say = self.words.say
        options = self._option_widgets()
        self.form.set_rows(
            [
                [Heading(lambda: say("match.title"), theme.TEXT, large=True)],
                [Gap(0.2)],
                *self._game_and_table(),
                [Gap(0.2)],
                [self._side(0), self._side(1)],
                [self._named(0), self._named(1)],
                *self._race_and_breaks(),
                [Gap(0.2)],
                *([widget] for widget in options),
                [Gap(max(0.2, _TALL - sum(widget.rows for widget in options)))],
                [Heading(lambda: self.wrong or self.barred, theme.WARNING, lines=2)],
                [
                    Button(say("form.cancel"), self.close),
                    Button(self._started, self.start, strong=True, barred=lambda: bool(self.barred)),
                ],
            ]
        )

    def _game_and_table(self) -> list[list[Widget]]:
        say = self.words.say
        draft = self.draft
        game = Selector(
            say("setting.match.game"), lambda: draft.games, lambda: draft.game, self._take_game,
            say("setting.match.game_hint"),
            lambda name: ruling_text.title(self.words, name) if name else "",
        )  # fmt: skip
        table = Selector(
            say("setting.match.table"), lambda: draft.tables, lambda: draft.preset, self._take_table, shown=self._title
        )
        return [[game], [table]]

    @property
    def _started(self) -> str:
        """What the button says that begins the match."""
        say = self.words.say
        return say("match.watch") if all(self.draft.sides) else say("match.start")

    def _side(self, side: int) -> Selector:
        """Who plays a side."""
        say, name = self.words.say, _SIDES[side]
        return Selector(
            say(f"setting.{name}"), lambda: self.draft.offered, lambda: self.draft.sides[side],
            lambda who: self._take_side(side, who),
            say(f"setting.{name}_hint"), self._who,
        )  # fmt: skip

    def _named(self, side: int) -> Widget:
        """A person's name; of a player, what there is to be said."""
        player = self.draft.player(side)
        if player is None:
            return self.fields[side]
        return Heading(lambda: player_text.about(self.words, player), lines=4)

    def _who(self, name: str) -> str:
        player = self.draft.player_of(name)
        return self.words.say("match.person") if player is None else player_text.title(self.words, player)

    def _name(self, side: int) -> str:
        player, field = self.draft.player(side), self.fields[side]
        return field.value.strip() or field.instead if player is None else player.name

    def _race_and_breaks(self) -> list[list[Widget]]:
        say = self.words.say
        draft = self.draft
        race = Selector(
            say("setting.match.race"), lambda: [str(frames) for frames in RACES], lambda: str(draft.race),
            self._take_race,
            say("setting.match.race_hint"),
        )  # fmt: skip
        breaker = Selector(
            say("setting.match.breaker"), lambda: [str(who) for who in draft.breakers], lambda: str(draft.breaker),
            self._take_breaker,
            say("setting.match.breaker_hint"),
            lambda who: self._breaker_name(int(who)),
        )  # fmt: skip
        breaks = Selector(
            say("setting.match.breaks"), lambda: BREAKS, lambda: draft.breaks, self._take_breaks,
            say("setting.match.breaks_hint"),
            lambda name: say(f"match.breaks_by.{name}"),
        )  # fmt: skip
        return [[race], [breaker], [breaks if draft.race > 1 else Gap(breaks.rows)]]

    def _option_widgets(self) -> list[Widget]:
        game = self.draft.game
        return [self._option(name, knob) for name, knob, _ in walk(GAMES[game].options_type())] if game else []

    def _option(self, name: str, knob: Knob) -> Widget:
        draft = self.draft
        label = ruling_text.setting(self.words, name)
        hint = ruling_text.setting_hint(self.words, draft.game, name, knob.doc)

        def put(value: float | str) -> None:
            draft.options[name] = value

        def get() -> float | str:
            return draft.options.get(name, knob.default)

        if knob.choices == YES_NO:
            return Toggle(label, lambda: get() == "yes", lambda on: put("yes" if on else "no"), hint)
        if knob.choices:
            return Selector(label, lambda: knob.choices, lambda: str(get()), put, hint, self._choice)
        steps = [f"{step}" for step in _LADDER if knob.lo <= step <= knob.hi]
        # What a number means that is none, such as no limit.
        return Selector(
            label, lambda: steps, lambda: f"{float(get()):g}", lambda step: put(float(step)), hint,
            lambda step: self.words.say_or(f"option.{name}_{step}", step),
        )  # fmt: skip

    def _title(self, name: str) -> str:
        """The name of a table as its preset has it; that of the preset where it cannot be read."""
        table = self.draft.table_of(name)
        if name == TUNED and table is not None:
            return self.words.say("match.tuned", table=ruling_text.table_title(self.words, table))
        return ruling_text.preset_title(self.words, name, title_of(name) if table is None else table.title)

    def _breaker_name(self, breaker: int) -> str:
        say = self.words.say
        if breaker == COIN:
            return say("match.coin")
        return say("match.lag") if breaker == LAG else self.names[breaker]

    def _choice(self, value: str) -> str:
        return self.words.say(f"choice.{value}")

    # What is chosen.

    def _take_table(self, name: str) -> None:
        self.draft.take_table(name)
        self.wrong = ""
        self._fill()

    def _take_game(self, name: str) -> None:
        self.draft.take_game(name)
        self.wrong = ""
        self._fill()

    def _take_side(self, side: int, who: str) -> None:
        self.draft.sides[side] = who
        self._fill()

    def _take_race(self, race: str) -> None:
        self.draft.race = int(race)
        self._fill()

    def _take_breaker(self, breaker: str) -> None:
        self.draft.breaker = int(breaker)

    def _take_breaks(self, breaks: str) -> None:
        self.draft.breaks = breaks


def _name_field(words: Words, player: int, value: str) -> TextField:
    name = _SETTINGS[player]
    field = TextField(words.say(f"setting.{name}"), value)
    field.hint = words.say(f"setting.{name}_hint")
    field.instead = words.say("match.player", number=player + 1)
    return field
