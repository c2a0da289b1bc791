"""What the table being played on looks like: the scene's state on a surface, from the cloth up."""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import replace

import pygame

from ...draw import cue, cue_motion, guide, theme, vectors
from ...draw.debug import ScreenPen, draw_geometry
from ...draw.view import View
from ...game.aim import Aim
from ...game.rules import AIM, CHOOSE
from ...game.rules.spotting import KITCHEN, D
from ...physics.strike import miscue_limit
from ...physics.values import Shot
from ...table.flights import flies
from ..frame import Frame
from ..stage import bars, scoreboard, why_panel
from ..stage.legend import draw_legend
from ..stage.playback import Playback
from ..stage.shot_view import in_motion
from ..stage.stage import Stage
from ..wording import clearance_text, flight_text
from . import drill_marks
from .call_words import called, off_target
from .controller import Controller
from .state import PlayState


def draw(frame: Frame, state: PlayState, controller: Controller) -> None:
    """Draw the whole window, as it was laid out."""
    show, stage, panel, step = state.show, controller.stage, controller.tuning_panel, state.mode.step
    surface, table, shown = frame.surface, state.session.table, state.playback
    stage.style = show.style
    stage.begin(frame)
    if step is not None:
        drill_marks.draw(surface, stage.view, table, step)
    if step is not None or show.geometry or show.vectors or panel is not None:
        frame.cover()
    if shown is None:
        _at_rest(frame, state, controller)
    else:
        in_motion(frame, stage, state.shown_balls, shown, show.effects)
    if show.geometry:
        draw_geometry(ScreenPen(surface, stage.view), table)
    if show.vectors:
        _vectors(surface, state, stage)
    if shown is not None and shown is show.why:
        _why(frame, state, stage)
    if shown is not None and shown.running:
        key = _bars_key(state, controller, shown)
        stage.bars.show(frame, stage.screen, key, lambda: _bars(surface, state, controller))
    else:
        _bars(surface, state, controller)
        frame.cover()
    if shown is not None and shown.review:
        controller.timeline.draw(surface, shown, table)
        frame.replace([stage.screen.bottom])
    if shown is None:
        controller.call_strip.draw(surface)
    if panel is not None:
        panel.draw(surface)


def notes(state: PlayState, speed: float) -> str:
    """What is to be said of the shot that is aimed."""
    session, shot = state.session, state.aimed(speed)
    looks_on = state.playback is not None or not state.mode.persons_turn
    if looks_on or session.ask.kind != AIM or speed == 0.0:
        return ""
    if state.clearance.elevation is None:
        others = state.foresight.other_tips(session.table, session.layout, state.chosen())
        return clearance_text.refused(state.words, state.clearance, session.layout, others)
    aimed = state.first_hit(shot) if state.show.level or state.calls.pocket else ""
    off = off_target(state.words, state.calls, session, aimed) if state.show.level else ""
    limit = miscue_limit(session.table.knobs.cue.tip_friction)
    slips = state.words.say("play.miscue_ahead") if math.hypot(shot.side, shot.height) > limit else ""
    said = called(state.words, state.calls, session, aimed)
    return " ".join(filter(None, (said, off, slips, *_stroke_notes(state, shot))))


def _stroke_notes(state: PlayState, shot: Shot) -> list[str]:
    """What comes of where the cue ball lies: nothing is said while that is yet to be put down."""
    session = state.session
    if state.held is not None:
        return []
    twice = state.words.say("play.double_hit_ahead") if strikes_twice(state, shot) else ""
    return [twice, clearance_text.raised(state.words, state.clearance, session.layout), hop_note(state, shot.speed)]


def strikes_twice(state: PlayState, shot: Shot) -> bool:
    """Whether the guide, where it is shown, foresees that the tip would meet the ball again."""
    level, session = state.show.level, state.session
    return level > 0 and state.foresight.strikes_twice(session.table, level, session.layout, shot)


def hop_note(state: PlayState, speed: float) -> str:
    """What to say of a stroke so steep and hard that its ball leaves the cloth."""
    if state.aimed(speed).elevation == 0.0 or state.playback is not None or state.session.in_hand:
        return ""
    session, shot, level = state.session, state.aimed(speed), state.show.level
    foreseen = state.foresight.rollout(session.table, level, session.layout, shot) if level != guide.NONE else None
    return flight_text.aimed(state.words, session.table, shot, session.table.body_of(session.cue)[1], foreseen)


def _at_rest(frame: Frame, state: PlayState, controller: Controller) -> None:
    """The balls as they lie, the guide, and the cue or the ball in hand."""
    surface, session, stage, hands = frame.surface, state.session, controller.stage, state.hands
    held = state.in_hand.held(session)
    aiming, by_hand = held is None and session.ask.kind == AIM, state.mode.persons_turn
    if controller.tuning is not None and hands.pull is None:
        stage.comparison(surface, controller.tuning.old, controller.tuning.other, controller.tuning.new)
    elif aiming and by_hand and hands.speed > 0.0:
        _guide(surface, state, stage)
    if aiming and by_hand and session.movable and not state.mode.may_arrange:
        stage.glow(surface, session.cue)
    stage.balls(frame, state.shown_balls, but=held.id if held is not None else "")
    if held is not None:
        _area(surface, state, stage.view)
        stage.in_hand(surface, held, not by_hand or state.in_hand.may_stand(session))
    elif aiming:
        # The shot of the guide, so that one is worked out; before the cue is drawn back far enough, the one of before.
        shot = state.aimed(hands.speed or hands.aim.speed)
        aimed = state.first_hit(shot) if state.calls.pocket else ""
        pointer = hands.pointer if by_hand and hands.pull is None else None
        controller.call_strip.mark(surface, stage.view, session, aimed, pointer)
        cue.draw(surface, session.table, session.cue, Aim.of(shot), cue_motion.stand(hands.drawn), stage.view)


def _guide(surface: pygame.Surface, state: PlayState, stage: Stage) -> None:
    """What the stroke would do; off, it is not worked out either."""
    session, level = state.session, state.show.level
    if level != guide.NONE and state.clearance.elevation is not None:
        shot = state.aimed(state.hands.speed)
        stage.guide(surface, level, state.foresight.rollout(session.table, level, session.layout, shot), shot.ball)


def _area(surface: pygame.Surface, state: PlayState, view: View) -> None:
    """Where a cue ball in hand may go, where that is only a part of the table."""
    table, where = state.session.table, state.session.ask.where
    line, radius = table.furniture.head_string, table.furniture.d_radius
    if line is None or where not in (KITCHEN, D):
        return
    if where == KITCHEN:
        width = table.knobs.table.width
        outline = [(0.0, 0.0), (line, 0.0), (line, width), (0.0, width)]
    else:
        middle = table.furniture.spots["head"][1]
        turns = (math.pi * (0.5 + i / 48) for i in range(49))
        outline = [(line + radius * math.cos(turn), middle + radius * math.sin(turn)) for turn in turns]
    points = [view.to_screen(x, y) for x, y in outline]
    shade = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    pygame.draw.polygon(shade, theme.AREA, points)
    surface.blit(shade, (0, 0))


def _vectors(surface: pygame.Surface, state: PlayState, stage: Stage) -> None:
    """The arrows of what is shown; that of the cue before a stroke."""
    session, shown = state.session, state.playback
    vectors.draw(surface, session.layout if shown is None else shown.rollout.at(shown.time), session.table, stage.view)
    if shown is None and not session.in_hand:
        shot = state.aimed(state.hands.speed)
        vectors.draw_cue(surface, session.cue, shot, session.table, stage.view)
    elif shown is not None and shown.shot is not None and shown.time <= 0.0:
        start = shown.rollout.start[shown.shot.ball]
        vectors.draw_cue(surface, start, shown.shot, session.table, stage.view)
    draw_legend(surface, state.words, stage.screen, shown is not None and flies(shown.rollout))


def _why(frame: Frame, state: PlayState, stage: Stage) -> None:
    """Why the shot that is seen again was played."""
    session = state.session
    if session.before is not None and session.last is not None and session.last.action is not None:
        why_panel.draw(frame.surface, state.words, stage, session.match, session.before, session.last.action)
        frame.cover()


def _bars_key(state: PlayState, controller: Controller, shown: Playback) -> Hashable:
    """What the bars tell while a shot runs."""
    stage, tuning = controller.stage, controller.tuning
    said = (state.messages.text, state.messages.warning, state.words.manner)
    drawn = (stage.screen, stage.style, state.gone, state.hands.aim, *said)
    # What stands to the players' credit comes with the moment, a drill's run with its stroke; it is told of a shot
    # only when it is seen again.
    error = tuning.error if tuning is not None else ""
    return *drawn, state.session.match.now, shown.shot, shown.again, error


def _bars(surface: pygame.Surface, state: PlayState, controller: Controller) -> None:
    session, screen, hands = state.session, controller.stage.screen, state.hands
    if session.match.rules.players == 1:
        bars.draw_bars(surface, screen, *state.titles)
    else:
        bars.draw_bars(surface, screen, "", "")
        # While a shot runs for the first time, what comes of it is not told yet.
        first = state.playback is not None and not state.playback.again
        scoreboard.draw(surface, state.words, screen, session.match, session.match.history[-2 if first else -1])
    controller.stage.tray(surface, state.gone, state.shown_balls.layout)
    if session.ask.kind != CHOOSE or state.playback is not None:
        struck = state.playback.shot if state.playback is not None else None
        aim, speed = hands.aim, hands.speed
        if struck is not None:
            # The pointer that moves meanwhile aims at nothing yet.
            aim, speed = replace(aim, angle=struck.angle, elevation=struck.elevation), struck.speed
        elif session.ask.kind == AIM and not session.in_hand:
            aim = replace(aim, elevation=state.aimed().elevation)
        bars.draw_controls(surface, state.words, screen, aim, speed, session.table.knobs.cue.tip_friction)
    wrong = (controller.tuning.error if controller.tuning is not None else "") or state.messages.warning
    taken = controller.call_strip.taken if state.playback is None else 0
    if wrong:
        bars.draw_message(surface, screen, wrong, theme.WARNING, taken)
    else:
        bars.draw_message(surface, screen, state.messages.text, theme.TEXT, taken, notes(state, hands.speed))
