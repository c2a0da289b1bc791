"""A drill: a table on which it is played and judged."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ....draw import cue_motion
from ....errors import BudgetError, InputError
from ....game.actions import Stroke
from ....game.aim import Aim
from ....game.drills.best_results import best, keep
from ....game.drills.drill import Run, Step, judge, start
from ....game.drills.drill_session import DrillSession
from ....physics.rollout import Rollout
from ....physics.simulate import simulate
from ...stage.playback import Playback
from ...wording import ruling_text
from ..messages import Message
from ..mode import Mode
from ..state import PlayState


class DrillMode(Mode):
    """A drill on a table's state; `leave` goes back to where it was chosen, `next_drill` on to the one after it."""

    session: DrillSession

    def __init__(
        self, state: PlayState, session: DrillSession, leave: Callable[[], None], next_drill: Callable[[], None]
    ) -> None:
        super().__init__(session, state.words)
        self._state = state
        self._leave = leave
        # The run before the stroke that was played last.
        self._before = session.run
        self.best = best(session.drill.id)
        # The strokes of the solution that are still to be shown, and what was aimed before.
        self._solution: list[Playback] = []
        self._aimed: Aim | None = None
        self.keys = {"same_shot": self._set_up, "next_drill": next_drill, "solution": self._show_solution}
        self.no_undo = lambda: self.words.say("drill.no_undo", key=self.words.key("same_shot"))

    @property
    def seen(self) -> Run:
        """The run as far as it has been seen: a shot that runs for the first time counts once the balls rest."""
        shown = self._state.playback
        return self._before if shown is not None and not shown.again else self.session.run

    # What is said.

    @property
    def welcome(self) -> Message:
        return self._goal

    @property
    def standing(self) -> Message:
        return self._outcome if self._between else self._goal

    def titles(self, gone: Sequence[str] | None) -> tuple[str, str]:
        say = self.words.say
        run = self.seen
        number = len(run.results) + (0 if run.standing.over else 1)
        parts = [say("drill.attempt", number=number, tries=run.drill.tries)]
        parts.append(say("drill.result", result=run.result, most=run.drill.most))
        if self.best is not None:
            parts.append(say("drill.best", best=self.best, most=run.drill.most))
        return ruling_text.wording(self.words, run.drill).name, "   \N{MIDDLE DOT}   ".join(parts)

    @property
    def step(self) -> Step:
        run = self.seen
        return run.drill.steps[min(run.standing.done, len(run.drill.steps) - 1)]

    def _goal(self) -> str:
        keys = self.words.say("drill.keys", next=self.words.key("next_drill"), solution=self.words.key("solution"))
        return f"{ruling_text.wording(self.words, self.session.drill).text} {keys}"

    def _outcome(self) -> str:
        say = self.words.say
        run = self.session.run
        standing, steps = run.standing, len(run.drill.steps)
        if not standing.over:
            return say("drill.step", done=standing.done, steps=steps)
        parts = [ruling_text.missed(self.words, standing.missed) if standing.missed else say("drill.done")]
        if standing.done >= run.drill.goal and (standing.missed or steps > 1):
            parts.append(say("drill.reached"))
        if run.over:
            parts.append(say("drill.over", result=run.result, most=run.drill.most))
            parts += [say("drill.record")] if run.result and self._beaten else []
        parts.append(say("drill.again", key=self.words.key("strike")))
        return " ".join(parts)

    @property
    def _beaten(self) -> bool:
        return self.best is None or self.session.run.result > self.best

    @property
    def _between(self) -> bool:
        """Whether an attempt is over and its balls still lie as they came to rest."""
        return self._state.playback is None and self.session.run.standing.over

    # What happens at the session's turns.

    def play(self, stroke: Stroke) -> Rollout:
        """Play a stroke, and keep the result where it ends an attempt."""
        self._before = self.session.run
        rollout = self.session.play(stroke.shot, stroke.call)
        run = self.session.run
        if run.standing.over and run.result:
            try:
                keep(run.drill.id, run.result)
                self._state.messages.warning = ""
            except InputError as error:
                self._state.messages.warning = str(error)
        return rollout

    def at_rest(self, shown: Playback) -> Message:
        if self._solution:
            return self._show_next()
        self._aim_as_before()
        return self._outcome if self._between or not shown.again else self._goal

    def go_on(self) -> bool:
        """Between two attempts, set the balls up for the next."""
        if not self._between:
            return False
        self._set_up()
        return True

    def rack(self) -> bool:
        self._set_up()
        return True

    def drop(self) -> None:
        self._solution = []
        self._aim_as_before()

    def cancel(self) -> bool:
        """End what is shown, or else the drill."""
        if self._solution or self._state.playback is not None:
            self._state.drop()
            self._state.messages.clear()
        else:
            self._leave()
        return True

    def _set_up(self) -> None:
        if self.session.run.over:
            self.best = best(self.session.drill.id)
        self.session.again()
        self._state.drop()
        self._state.messages.show(self._goal)

    # The solution.

    def _show_solution(self) -> None:
        """Show strokes that do it, from the beginning; the attempt stays where it is."""
        drill, standing = self.session.drill, start(self.session.drill)
        state = self._state
        state.drop()
        try:
            for shot in drill.solution:
                rollout = simulate(drill.table, standing.layout, shot)
                standing = judge(drill, standing, rollout)
                shown = Playback(rollout, shot, cue_motion.lead(False, state.show.effects), again=True)
                shown.review = False
                self._solution.append(shown)
                if standing.over:
                    break
        except (InputError, BudgetError) as error:
            self._solution = []
            state.messages.say(str(error))
            return
        state.messages.show(self._show_next() if self._solution else lambda: self.words.say("drill.no_solution"))

    def _show_next(self) -> Message:
        """Show the solution's next stroke; what is said of it."""
        state, shown = self._state, self._solution.pop(0)
        state.hands.put_down()
        state.run(shown)
        if shown.shot is not None:
            # The diagrams show how it is struck.
            self._aimed = self._aimed or state.hands.aim
            state.hands.aim = Aim.of(shown.shot)
        strokes = len(self.session.drill.solution)
        number = strokes - len(self._solution)
        return lambda: self.words.say("drill.solution", number=number, strokes=strokes)

    def _aim_as_before(self) -> None:
        """Aim as the player did before the solution was shown."""
        if self._aimed is not None:
            self._state.hands.aim, self._aimed = self._aimed, None
            self._state.hands.keep_aim()
