"""What the table being played on looks like: the scene's state on a surface, from the cloth up."""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import replace
from typing import TYPE_CHECKING

import pygame

from ...draw import cue, cue_motion, theme, vectors
from ...draw.debug import ScreenPen, draw_geometry
from ...game.rules import AIM, CHOOSE
from ...game.rules.spotting import KITCHEN, D
from ...physics.strike import hop, miscue_limit
from ..frame import Frame
from ..stage import bars, scoreboard
from ..stage.legend import draw_legend
from ..stage.playback import Playback
from ..stage.shot_view import in_motion
from ..wording.words import manner, say

if TYPE_CHECKING:
    from .play import Play

# From this height on, m, the player is told that a real ball would leave the cloth.
_HOP = 0.005


def draw(frame: Frame, play: Play) -> None:
    """Draw the whole window, as it was laid out."""
    surface, screen = frame.surface, play.stage.screen
    play.stage.begin(frame)
    if play.draw_marks(surface) or play.geometry or play.vectors or play.tuning is not None:
        frame.cover()
    if play.playback is None:
        _at_rest(frame, play)
    else:
        in_motion(frame, play.stage, play.playback, play.effects)
    if play.geometry:
        draw_geometry(ScreenPen(surface, play.stage.view), play.session.table)
    if play.vectors:
        _vectors(surface, play)
    if play.playback is not None and play.playback.running:
        play.stage.bars.show(frame, screen, _bars_key(play, play.playback), lambda: _bars(surface, play))
    else:
        _bars(surface, play)
        frame.cover()
    if play.playback is not None and play.playback.review:
        play.timeline.draw(surface, play.playback, play.session.table)
        frame.replace([screen.bottom])
    if play.playback is None:
        play.call_strip.draw(surface)
    if play.tuning is not None:
        play.tuning.draw(surface)


def notes(play: Play, speed: float) -> str:
    """What is to be said of the shot that is aimed."""
    session, shot = play.session, play.hands.aim.shot(play.session.cue.id, speed)
    if play.playback is not None or session.ask.kind != AIM or speed == 0.0:
        return ""
    aimed = play.aimed(shot) if play.level or play.call_strip.calls.pocket else ""
    off = play.call_strip.warning(session, aimed) if play.level else ""
    limit = miscue_limit(session.table.knobs.cue.tip_friction)
    slips = say("play.miscue_ahead") if math.hypot(shot.side, shot.height) > limit else ""
    return " ".join(filter(None, (play.call_strip.message(session, aimed), off, slips, hop_note(play, speed))))


def hop_note(play: Play, speed: float) -> str:
    """What to say of a stroke so steep and hard that a real ball would leave the cloth."""
    if play.hands.aim.elevation == 0.0 or play.playback is not None or play.session.in_hand:
        return ""
    knobs = play.session.table.knobs
    apex = hop(play.hands.aim.shot("", speed), play.session.table.body_of(play.session.cue)[1], knobs)[1]
    if apex < _HOP:
        return ""
    return say("play.hop", height=f"{1000.0 * apex:.0f} mm")


def _at_rest(frame: Frame, play: Play) -> None:
    """The balls as they lie, the guide, and the cue or the ball in hand."""
    surface = frame.surface
    session, stage, hands = play.session, play.stage, play.hands
    held = play.in_hand.held(session)
    aiming = held is None and session.ask.kind == AIM
    if play.tuning is not None and hands.pull is None:
        stage.comparison(surface, play.tuning.old, play.tuning.other, play.tuning.new)
    elif aiming and hands.speed > 0.0:
        stage.guide(surface, play.level, session.layout, hands.aim.shot(session.cue.id, hands.speed))
    if aiming and session.movable and not session.is_practice:
        stage.glow(surface, session.cue)
    stage.balls(frame, session.layout, session.rollout, but=held.id if held is not None else "")
    if held is not None:
        _area(surface, play)
        stage.in_hand(surface, held, play.in_hand.may_stand(session))
    elif aiming:
        shot = hands.aim.shot(session.cue.id, hands.aim.speed)
        aimed = play.aimed(shot) if play.call_strip.calls.pocket else ""
        play.call_strip.mark(surface, stage.view, session, aimed, hands.pointer if hands.pull is None else None)
        cue.draw(surface, session.table, session.cue, hands.aim, cue_motion.stand(hands.drawn), stage.view)


def _area(surface: pygame.Surface, play: Play) -> None:
    """Where a cue ball in hand may go, where that is only a part of the table."""
    table, where = play.session.table, play.session.ask.where
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
    points = [play.stage.view.to_screen(x, y) for x, y in outline]
    shade = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    pygame.draw.polygon(shade, theme.AREA, points)
    surface.blit(shade, (0, 0))


def _vectors(surface: pygame.Surface, play: Play) -> None:
    """The arrows of what is shown; that of the cue before a stroke."""
    session, stage, shown = play.session, play.stage, play.playback
    vectors.draw(surface, session.layout if shown is None else shown.rollout.at(shown.time), session.table, stage.view)
    if shown is None and not session.in_hand:
        shot = play.hands.aim.shot(session.cue.id, play.hands.speed)
        vectors.draw_cue(surface, session.cue, shot, session.table, stage.view)
    elif shown is not None and shown.shot is not None and shown.time <= 0.0:
        start = shown.rollout.start[shown.shot.ball]
        vectors.draw_cue(surface, start, shown.shot, session.table, stage.view)
    draw_legend(surface, stage.screen)


def _bars_key(play: Play, shown: Playback) -> Hashable:
    """What the bars tell while a shot runs."""
    stage, tuning = play.stage, play.tuning
    drawn = (stage.screen, stage.style, stage.pocketed, play.hands.aim, play.message_text, play.warning, manner())
    # What stands to the players' credit comes with the moment, a drill's run with its stroke; it is told of a shot
    # only when it is seen again.
    error = tuning.error if tuning is not None else ""
    return *drawn, play.session.match.now, shown.shot, shown.again, error


def _bars(surface: pygame.Surface, play: Play) -> None:
    session, screen, hands = play.session, play.stage.screen, play.hands
    if session.match.rules.players == 1:
        bars.draw_bars(surface, screen, *play.titles)
    else:
        bars.draw_bars(surface, screen, "", "")
        # While a shot runs for the first time, what comes of it is not told yet.
        first = play.playback is not None and not play.playback.again
        scoreboard.draw(surface, screen, session.match, session.match.history[-2 if first else -1])
    play.stage.tray(surface)
    if session.ask.kind != CHOOSE or play.playback is not None:
        struck = play.playback.shot if play.playback is not None else None
        aim, speed = hands.aim, hands.speed
        if struck is not None:
            # The pointer that moves meanwhile aims at nothing yet.
            aim, speed = replace(aim, angle=struck.angle), struck.speed
        bars.draw_controls(surface, screen, aim, speed, session.table.knobs.cue.tip_friction)
    wrong = (play.tuning.error if play.tuning is not None else "") or play.warning
    message = wrong or f"{play.message_text} {notes(play, hands.speed)}".strip()
    taken = play.call_strip.taken if play.playback is None else 0
    bars.draw_message(surface, screen, message, theme.WARNING if wrong else theme.TEXT, taken)
