"""The ends of frames and matches: who has won, the score, and what each player did."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from ...draw import text, theme
from ...game.match import Match
from ..dialogs.dialog import Dialog
from ..scene import GUARD, Scene
from ..widgets.widget import Button, Gap, Heading, Widget
from ..wording import ruling_text
from ..wording.words import Words


class End(Dialog):
    """An end, which comes of itself: keys that were meant for the shot before it do nothing here."""

    def __init__(self, below: Scene, title: str, rows: list[list[Widget]]) -> None:
        super().__init__(below, title, rows)
        self.form.focus = self.form.widgets[-1]
        self._age = 0.0

    def handle(self, event: pygame.event.Event) -> Scene | None:
        if event.type == pygame.KEYDOWN and self._age < GUARD:
            return self
        return super().handle(event)

    def update(self, dt: float) -> Scene | None:
        self._age += dt
        return super().update(dt)


# How long the end of a frame is left to be read where nobody is there to press on, s.
_READ = 4.0


class FrameOver(End):
    """Between two frames: who won the last and why, and the score; where no person plays it goes on by itself."""

    def __init__(
        self, below: Scene, match: Match, on: Callable[[], Scene], leave: Callable[[], Scene]
    ) -> None:  # fmt: skip
        say = below.words.say
        winner = match.state.winner
        won = say("ended.draw") if winner is None else say("ended.frame", name=match.names[winner])
        super().__init__(
            below,
            won,
            [
                [Heading(lambda: ruling_text.verdict(below.words, match.now, match), lines=2)],
                [Heading(lambda: say("ended.race", count=match.setup.race))],
                [Score(match)],
                [Gap(0.4)],
                [
                    Button(say("ended.menu"), lambda: self.go(leave())),
                    Button(say("ended.next"), lambda: self.go(on()), strong=True),
                ],
            ],
        )
        self._on = on if match.setup.watched else None

    def update(self, dt: float) -> Scene | None:
        if self._on is not None and self._age > _READ:
            self.go(self._on())
        return super().update(dt)


class MatchOver(End):
    """The end of a match: the winner and why, and the numbers of both players."""

    def __init__(self, below: Scene, match: Match, again: Callable[[], Scene], leave: Callable[[], Scene]) -> None:
        say = below.words.say
        assert match.winner is not None
        super().__init__(
            below,
            say("ended.match", name=match.names[match.winner]),
            [
                [Heading(lambda: ruling_text.verdict(below.words, match.now, match), lines=2)],
                [Heading(lambda: ruling_text.title(below.words, match.setup.game))],
                [Score(match)],
                [Gap(0.2)],
                [Grid(statistics(below.words, match))],
                [Gap(0.4)],
                [
                    Button(say("ended.menu"), lambda: self.go(leave())),
                    Button(say("ended.again"), lambda: self.go(again()), strong=True),
                ],
            ],
        )


class Score(Widget):
    """The names of the players with the frames they have won between them."""

    rows = 2.0
    focusable = False

    def __init__(self, match: Match) -> None:
        super().__init__()
        self.match = match

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        won = self.match.frames
        score = text.draw(
            surface, f"{won[0]} : {won[1]}", unit * 4, theme.ACCENT, self.rect.center, (0.5, 0.5)
        )  # fmt: skip
        room = (self.rect.width - score.width) // 2 - 2 * unit
        for name, x, side in ((0, score.left - 2 * unit, 1.0), (1, score.right + 2 * unit, 0.0)):
            shown = text.fitted(self.match.names[name], unit * 9 // 4, room)
            text.draw(surface, shown, unit * 9 // 4, theme.TEXT, (x, self.rect.centery), (side, 0.5))


class Grid(Widget):
    """Rows of a label in the middle and a value for each of two players beside it."""

    focusable = False

    def __init__(self, lines: Sequence[tuple[str, str, str]]) -> None:
        super().__init__()
        self.lines = lines
        self.rows = float(len(lines))

    def draw(self, surface: pygame.Surface, unit: int, focused: bool, hovered: bool) -> None:
        size, pitch, side = unit * 7 // 4, self.rect.height / max(1, len(self.lines)), self.rect.width // 8
        for i, (label, mine, theirs) in enumerate(self.lines):
            y = self.rect.top + (i + 0.5) * pitch
            if i:
                line = pygame.Rect(self.rect.left, round(y - pitch / 2), self.rect.width, 1)
                surface.fill(theme.EDGE, line)
            text.draw(surface, label, size, theme.QUIET, (self.rect.centerx, y), (0.5, 0.5))
            text.draw(surface, mine, size, theme.TEXT, (self.rect.left + side, y), (0.5, 0.5))
            text.draw(surface, theirs, size, theme.TEXT, (self.rect.right - side, y), (0.5, 0.5))


def statistics(words: Words, match: Match) -> list[tuple[str, str, str]]:
    """What each of two players did, as labels and their values; what the game does not know is left out."""
    tallies = match.now.tallies
    lines: list[tuple[str, str, str]] = []

    def tell(key: str, values: Sequence[str]) -> None:
        lines.append((words.say(f"ended.stat.{key}"), *values))  # type: ignore[arg-type]

    if any(tally.points for tally in tallies):
        tell("points", [str(tally.points) for tally in tallies])
    tell("innings", [str(tally.innings) for tally in tallies])
    tell(f"highest_{match.rules.series}", [str(tally.best) for tally in tallies])
    if match.table.geometry.pockets:
        tell("pots", [str(tally.pots) for tally in tallies])
        tell("success", [_percent(good, all_) for good, all_ in potting(match)])
    else:
        tell("average", [words.number(tally.points / max(1, tally.innings), ".2f") for tally in tallies])
    tell("fouls", [str(tally.fouls) for tally in tallies])
    return lines


def potting(match: Match) -> list[tuple[int, int]]:
    """For each player, how many strokes pocketed a ball without a foul, and how many strokes there were."""
    counts = [(0, 0)] * len(match.names)
    for moment in match.history:
        if moment.report is not None:
            good, strokes = counts[moment.shooter]
            potted = bool(moment.report.potted) and not moment.ruling.foul
            counts[moment.shooter] = good + potted, strokes + 1
    return counts


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / whole:.0f} %" if whole else "\N{EN DASH}"
