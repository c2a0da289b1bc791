"""What a recorded match looks like on the window: the shot, whose it is, how the match stands, what came of it."""

from __future__ import annotations

import pygame

from ...draw import pen, shapes, text, theme, vectors
from ...draw.debug import ScreenPen, draw_geometry
from ...game.actions import Stroke
from ...game.records.recorded_shots import RecordedShots
from ...game.records.replaying import UNKNOWN, RecordedShot
from ...game.rules.report import Call
from ...table.flights import flies
from ..frame import Frame
from ..screen import Screen
from ..stage import scoreboard, why_panel
from ..stage.legend import draw_legend
from ..stage.shot_view import in_motion
from ..stage.stage import Stage
from ..stage.timeline import Timeline
from ..widgets.widget import plate
from ..wording import ruling_text
from ..wording.shot_text import ball_name, place_name
from ..wording.words import Words
from .replay_state import ReplayState


def draw(frame: Frame, words: Words, state: ReplayState, stage: Stage, timeline: Timeline) -> None:
    """Draw the whole window, as it was laid out."""
    shown, shot = state.playback, state.shot
    surface, screen = frame.surface, stage.screen
    stage.begin(frame)
    in_motion(frame, stage, state.shown_balls, shown, state.effects)
    if state.show.geometry:
        draw_geometry(ScreenPen(surface, stage.view), stage.table)
    if state.show.vectors:
        vectors.draw(surface, shown.rollout.at(shown.time), stage.table, stage.view)
        if shown.shot is not None and shown.time <= 0.0:
            vectors.draw_cue(surface, shown.rollout.start[shown.shot.ball], shown.shot, stage.table, stage.view)
        draw_legend(surface, words, screen, flies(shown.rollout))
    _upper_bar(surface, words, stage, state, timeline.hover)
    if state.why and shot.moment.action is not None:
        why_panel.draw(surface, words, stage, shot.match, shot.before, shot.moment.action)
    said = caption(words, state)
    _caption(surface, screen, said)
    if state.show.geometry or state.show.vectors or state.why or said[0]:
        frame.cover()
    timeline.draw(surface, shown, stage.table)
    frame.replace([screen.top, screen.bottom])


# The upper bar: from shot to shot on the left, the players on the right.


# The left side and the width of each button, in units; the last is there where it is told why a stroke was played.
_BUTTONS = {"earlier": (2, 3), "list": (6, 17), "later": (24, 3), "why": (28, 3)}


def button(action: str, screen: Screen) -> pygame.Rect:
    """The place of a button, by its action."""
    unit = screen.unit
    left, width = _BUTTONS[action]
    return pygame.Rect(left * unit, unit // 2, width * unit, 3 * unit)


def buttons(state: ReplayState) -> list[str]:
    """The actions of the buttons that are there."""
    return [action for action in _BUTTONS if action != "why" or state.told_why]


def under(pos: tuple[int, int], screen: Screen, state: ReplayState) -> str:
    """The action of the button at a place, if any."""
    return next((action for action in buttons(state) if button(action, screen).collidepoint(pos)), "")


def _upper_bar(
    surface: pygame.Surface, words: Words, stage: Stage, state: ReplayState, pointer: tuple[int, int] | None
) -> None:  # fmt: skip
    screen, shot = stage.screen, state.shot
    unit, bar = screen.unit, screen.top
    surface.fill(theme.PANEL[:3], bar)
    pointed = "" if pointer is None else under(pointer, screen, state)
    for action in buttons(state):
        box = button(action, screen)
        lit = action == pointed
        plate(surface, box, theme.FACE_LIT if lit else theme.FACE, unit, theme.TEXT if lit else None)
        _sign(surface, action, box, state, screen.small)
    told = words.say("replay.shot", number=state.at + 1, count=len(state.shots))
    box = button("list", screen)
    text.draw(surface, text.fitted(told, screen.small, box.width), screen.small, theme.TEXT, box.center, (0.5, 0.5))
    left = button(buttons(state)[-1], screen).right + 2 * unit
    title = text.fitted(ruling_text.title(words, shot.match.rules.name), screen.small, screen.tray.left - left)
    text.draw(surface, title, screen.small, theme.QUIET, (left, bar.centery), (0.0, 0.5))
    stage.tray(surface, state.shown_balls.gone(shot.match), state.shown_balls.layout)
    # Until a shot has come to its end the score is the one that it was played at.
    moment = shot.moment if state.playback.ended else shot.before
    scoreboard.draw_beside(surface, words, screen, shot.match, moment, shot.moment.shooter)


def _sign(surface: pygame.Surface, action: str, box: pygame.Rect, state: ReplayState, size: int) -> None:
    """The sign of a button: that of the list is the number of the shot."""
    if action == "why":
        color = theme.ACCENT if state.why else theme.TEXT
        text.draw(surface, "?", size, color, box.center, (0.5, 0.5))
    elif action != "list":
        possible = state.at > 0 if action == "earlier" else state.at + 1 < len(state.shots)
        _skip(surface, box, -1.0 if action == "earlier" else 1.0, theme.TEXT if possible else theme.EDGE)


def _skip(surface: pygame.Surface, box: pygame.Rect, side: float, color: theme.Color) -> None:
    """The sign of going to another shot."""
    x, y, r = box.centerx, box.centery, box.height * 0.22
    for at in (-1.0, 0.1):
        tip, back = x + side * r * (at + 1.0), x + side * r * at
        pen.polygon(surface, color, [(back, y - r), (back, y + r), (tip, y)])


# What is said over the table's lower edge.


def caption(words: Words, state: ReplayState) -> tuple[str, bool]:
    """What there is to say of the moment shown, and whether something is wrong."""
    shot, shown = state.shot, state.playback
    shots = state.shots
    if not shot.same:
        return unlike(words, shot), True
    if shown.ended:
        said = [words.say("replay.undone")] if shot.line in shots.undone else []
        said += [words.say("replay.judged", why=words.say(f"since.{shot.found.why}"))] if shot.found is not None else []
        return " ".join([*said, ruling_text.verdict(words, shot.moment, shot.match), *invited(words, state)]), False
    if shown.time <= 0.0 and (said_before := [*called(words, shot), *invited(words, state)]):
        return " ".join(said_before), False
    if shots.fault is not None and state.at + 1 == len(shots):
        return str(shots.fault), True
    if shots.outdated and state.at == 0:
        return words.say(f"since.preset_{shots.outdated}"), False
    return "", False


def invited(words: Words, state: ReplayState) -> list[str]:
    """How to be told why the shot was played, where that is known and not told yet."""
    return [words.say("replay.why", key=words.key("why"))] if state.told_why and not state.why else []


def unlike(words: Words, shot: RecordedShot) -> str:
    """What is said of a shot that does not roll as it was recorded."""
    if shot.found is None or shot.found.why == UNKNOWN:
        return words.say("replay.differs")
    return words.say("replay.unlike", why=words.say(f"since.{shot.found.why}"))


def line(words: Words, shots: RecordedShots, shot: RecordedShot) -> str:
    """A shot in a list: its number, who played it, and what came of it."""
    notes = ruling_text.verdict(words, shot.moment, shot.match)
    name = shot.match.names[shot.moment.shooter]
    back = f" ({words.say('replay.taken_back')})" if shot.line in shots.undone else ""
    return f"{shot.number}   {name}{back}   {notes}".rstrip()


def called(words: Words, shot: RecordedShot) -> list[str]:
    """What the player said before the shot, if anything."""
    stroke = shot.moment.action
    if not isinstance(stroke, Stroke) or stroke.call == Call():
        return []
    call = stroke.call
    ball = ball_name(words, call.ball, stroke.shot.ball) if call.ball else ""
    pocket = place_name(words, call.pocket) if call.pocket else ""
    what = [ball, pocket, words.say("replay.safety") * call.safety, words.say("replay.push") * call.push]
    name = shot.match.names[shot.moment.shooter]
    return [words.say("replay.calls", player=name, what=", ".join(filter(None, what)))]


def _caption(surface: pygame.Surface, screen: Screen, said: tuple[str, bool]) -> None:
    """A line or two over the table's lower edge."""
    told, wrong = said
    if not told:
        return
    unit, size = screen.unit, screen.small
    lines = text.wrap(told, size, screen.width * 3 // 4)
    pitch = text.font(size).get_linesize()
    width = max(text.font(size).size(line)[0] for line in lines) + 4 * unit
    box = pygame.Rect(0, 0, width, pitch * len(lines) + unit)
    box.midbottom = (screen.width // 2, screen.bottom.top - unit // 2)
    shapes.panel(surface, box, unit)
    for i, line in enumerate(lines):
        place = (box.centerx, box.top + unit // 2 + i * pitch)
        text.draw(surface, line, size, theme.WARNING if wrong else theme.TEXT, place, (0.5, 0.0))
