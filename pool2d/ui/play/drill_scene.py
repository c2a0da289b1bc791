"""A drill on the screen: a table on which it is played and judged."""

from __future__ import annotations

import math
from collections.abc import Callable

import pygame

from ...draw import cue_motion, pen, theme
from ...errors import BudgetError, InputError
from ...game.aim import Aim
from ...game.drills.drill import Drill, RestArea, Run, judge, start
from ...game.drills.drill_file import best, drills, keep, load
from ...game.drills.drill_session import DrillSession
from ...physics.simulate import simulate
from ..scene import Scene
from ..stage.playback import Playback
from ..wording import ruling_text
from ..wording.keys import KEYS
from ..wording.words import say
from .play import Play

# How strongly an area of the cloth is marked, of 255.
_TINT = 42


class DrillPlay(Play):
    """A drill being played; Esc goes back to `home`."""

    def __init__(self, drill: Drill, home: Scene, play: Play) -> None:
        self.drilling = DrillSession(drill)
        # The run before the stroke that was played last.
        self._before = self.drilling.run
        super().__init__(self.drilling, play.sounds)
        self.home = home
        self.entered = play.entered
        self.effects, self.level = play.effects, play.level
        self.stage.style = play.stage.style
        self.hands.pointer = play.hands.pointer
        self.best = best(drill.id)
        # The strokes of the solution that are still to be shown, and what was aimed before.
        self._shown: list[Playback] = []
        self._aimed: Aim | None = None
        self._keys |= {"same_shot": self._rack, "next_drill": self._next_drill, "solution": self._solution}
        self.message = self._goal

    @property
    def seen(self) -> Run:
        """The run as far as it has been seen: a shot that runs for the first time counts once the balls rest."""
        first = self.playback is not None and not self.playback.again
        return self._before if first else self.drilling.run

    @property
    def titles(self) -> tuple[str, str]:
        run = self.seen
        number = len(run.results) + (0 if run.standing.over else 1)
        parts = [say("drill.attempt", number=number, tries=run.drill.tries)]
        parts.append(say("drill.result", result=run.result, most=run.drill.most))
        if self.best is not None:
            parts.append(say("drill.best", best=self.best, most=run.drill.most))
        return title(run.drill), "   \N{MIDDLE DOT}   ".join(parts)

    # What is told.

    @property
    def standing_message(self) -> Callable[[], str]:
        """What is told again once other things have been read."""
        return self._outcome if self._between else self._goal

    def _goal(self) -> str:
        keys = say("drill.keys", next=KEYS.shown("next_drill"), solution=KEYS.shown("solution"))
        return f"{task(self.drilling.drill)} {keys}"

    def _outcome(self) -> str:
        run = self.drilling.run
        standing, steps = run.standing, len(run.drill.steps)
        if not standing.over:
            return say("drill.step", done=standing.done, steps=steps)
        parts = [ruling_text.missed(standing.missed) if standing.missed else say("drill.done")]
        if standing.done >= run.drill.goal and (standing.missed or steps > 1):
            parts.append(say("drill.reached"))
        if run.over:
            parts.append(say("drill.over", result=run.result, most=run.drill.most))
            parts += [say("drill.record")] if run.result and self._beaten else []
        parts.append(say("drill.again", key=KEYS.shown("strike")))
        return " ".join(parts)

    @property
    def _beaten(self) -> bool:
        return self.best is None or self.drilling.run.result > self.best

    # What hands and keys lead to.

    @property
    def _between(self) -> bool:
        """Whether an attempt is over and its balls still lie as they came to rest."""
        return self.playback is None and self.drilling.run.standing.over

    def _go_on(self) -> None:
        if self._between:
            self.hands.armed = False
            self._rack()
        else:
            super()._go_on()

    def _press(self, pos: tuple[int, int]) -> None:
        screen = self.stage.screen
        if self._between and screen.top.bottom <= pos[1] < screen.bottom.top:
            self._rack()
        else:
            super()._press(pos)

    def _strike(self, speed: float, drawn: bool = False) -> None:
        self._before = self.drilling.run
        super()._strike(speed, drawn)
        run = self.drilling.run
        if run is not self._before and run.standing.over and run.result:
            try:
                keep(run.drill.id, run.result)
                self.warning = ""
            except InputError as error:
                self.warning = str(error)

    def _rack(self) -> None:
        """Set the balls up again."""
        if self.drilling.run.over:
            self.best = best(self.drilling.drill.id)
        self.drilling.again()
        self.drop()
        self.message = self._goal

    def _undo(self) -> None:
        self.message = lambda: say("drill.no_undo", key=KEYS.shown("same_shot"))

    def _tune(self) -> None:
        self.message = lambda: say("play.practice_only")

    def _cancel(self) -> None:
        if self.hands.busy:
            super()._cancel()
        elif self._shown or self.playback is not None:
            self.drop()
            self.message = self.standing_message
        else:
            self.go_to(self.home)

    def _next_drill(self) -> None:
        names = drills()
        here = self.drilling.drill.id
        name = names[(names.index(here) + 1) % len(names)] if here in names else names[0]
        try:
            self.go_to(DrillPlay(load(name), self.home, self))
        except InputError as error:
            self.tell(str(error))

    # The solution.

    def _solution(self) -> None:
        """Show strokes that do it, from the beginning; the attempt stays where it is."""
        drill, standing = self.drilling.drill, start(self.drilling.drill)
        self.drop()
        try:
            for shot in drill.solution:
                rollout = simulate(drill.table, standing.layout, shot)
                standing = judge(drill, standing, rollout)
                shown = Playback(rollout, shot, cue_motion.lead(False, self.effects), again=True)
                shown.review = False
                self._shown.append(shown)
                if standing.over:
                    break
        except (InputError, BudgetError) as error:
            self._shown = []
            self.tell(str(error))
            return
        if self._shown:
            self._show_next()
        else:
            self.message = lambda: say("drill.no_solution")

    def _show_next(self) -> None:
        shown = self._shown.pop(0)
        self.hands.put_down()
        self._show(shown)
        if shown.shot is not None:
            # The diagrams show how it is struck.
            self._aimed = self._aimed or self.hands.aim
            self.hands.aim = Aim.of(shown.shot)
        strokes = len(self.drilling.drill.solution)
        number = strokes - len(self._shown)
        self.message = lambda: say("drill.solution", number=number, strokes=strokes)

    def _aim_as_before(self) -> None:
        """Aim as the player did before the solution was shown."""
        if self._aimed is not None:
            self.hands.aim, self._aimed = self._aimed, None
            self.hands.hold = self.hands.pointer

    def drop(self) -> None:
        self._shown = []
        self._aim_as_before()
        super().drop()

    def _come_to_rest(self, shown: Playback) -> None:
        super()._come_to_rest(shown)
        if self._shown:
            self._show_next()
        else:
            self._aim_as_before()
            self.message = self._outcome if self._between or not shown.again else self._goal

    # What is marked.

    def draw_marks(self, surface: pygame.Surface) -> bool:
        """The pocket that is called, and where balls have to come to rest."""
        run = self.seen
        step = run.drill.steps[min(run.standing.done, len(run.drill.steps) - 1)]
        view = self.stage.view
        for rest in step.rest:
            self._area(surface, rest)
        for pocket in run.drill.table.geometry.pockets:
            if pocket.name == step.pocket:
                pen.ring(surface, theme.ACCENT, view.to_screen(pocket.x, pocket.y), pocket.radius * view.scale, 2.5)
        return True

    def _area(self, surface: pygame.Surface, rest: RestArea) -> None:
        """Tint where a ball has to come to rest, its middle within."""
        table, view = self.drilling.drill.table, self.stage.view
        color = theme.IVORY if rest.ball == table.furniture.cue else theme.GUIDE_BALL
        if rest.at is not None:
            centre, radius = view.to_screen(*rest.at), rest.within * view.scale
            if math.isfinite(radius):
                pen.disc(surface, (*color[:3], _TINT), centre, radius)
                pen.ring(surface, color, centre, radius, 1.5)
            return
        size = table.knobs.table
        left, top = view.to_screen(max(0.0, rest.x[0]), min(size.width, rest.y[1]))
        right, bottom = view.to_screen(min(size.length, rest.x[1]), max(0.0, rest.y[0]))
        box = pygame.Rect(round(left), round(top), round(right - left), round(bottom - top))
        tint = pygame.Surface(box.size, pygame.SRCALPHA)
        tint.fill((*color[:3], _TINT))
        surface.blit(tint, box)
        pygame.draw.rect(surface, color, box, 1)


def title(drill: Drill) -> str:
    """A drill's name in the player's language."""
    return ruling_text.wording(drill).name


def task(drill: Drill) -> str:
    """What a drill asks for, in the player's language."""
    return ruling_text.wording(drill).text
