"""What every key and hand does: one table that binds them and that the help lists."""

from __future__ import annotations

from dataclasses import dataclass

import pygame


@dataclass(frozen=True, slots=True)
class Binding:
    """An action, the keys that do it (with Ctrl or without), how the help names them and what they do."""

    action: str
    keys: tuple[int, ...]
    shown: str
    does: str
    ctrl: bool | None = None


BINDINGS = (
    Binding("turn_left", (pygame.K_LEFT,), "Left / Right", "turn the aim by 0.05 degrees (Shift 0.01, Ctrl 1)"),
    Binding("turn_right", (pygame.K_RIGHT,), "", ""),
    Binding("harder", (pygame.K_UP,), "Up / Down", "speed of a key stroke"),
    Binding("softer", (pygame.K_DOWN,), "", ""),
    Binding("strike", (pygame.K_SPACE, pygame.K_RETURN), "Space, Enter", "strike; place a ball in hand; skip to rest"),
    Binding("spin_up", (pygame.K_w,), "W A S D", "move the tip on the ball: follow, left, draw, right", ctrl=False),
    Binding("spin_left", (pygame.K_a,), "", "", ctrl=False),
    Binding("spin_down", (pygame.K_s,), "", "", ctrl=False),
    Binding("spin_right", (pygame.K_d,), "", "", ctrl=False),
    Binding("no_spin", (pygame.K_BACKSPACE,), "Backspace", "no spin, level cue"),
    Binding("lower", (pygame.K_q,), "Q / E", "lower or raise the butt of the cue", ctrl=False),
    Binding("raise", (pygame.K_e,), "", "", ctrl=False),
    Binding("guide", (pygame.K_g,), "G", "guide: off, line, ghost ball, whole shot"),
    Binding("vectors", (pygame.K_v,), "V", "arrows of speed, spin and the cue"),
    Binding("fast", (pygame.K_TAB,), "Tab (hold)", "fast-forward"),
    Binding("replay", (pygame.K_r,), "R", "see the last shot again"),
    Binding("pause", (pygame.K_p,), "P", "hold the shot, with its time line"),
    Binding("undo", (pygame.K_u,), "U, Ctrl+Z", "take back the last shot"),
    Binding("undo", (pygame.K_z,), "", "", ctrl=True),
    Binding("rack", (pygame.K_n,), "N", "new rack"),
    Binding("tune", (pygame.K_t,), "T", "tune the table: every knob, and what it does to the last shot"),
    Binding("geometry", (pygame.K_b,), "B", "show the geometry that the physics sees"),
    Binding("nearer", (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "+ / -", "see the table from nearer"),
    Binding("farther", (pygame.K_MINUS, pygame.K_KP_MINUS), "", ""),
    Binding("look_up", (pygame.K_i,), "I J K L", "look up, left, down, right"),
    Binding("look_left", (pygame.K_j,), "", ""),
    Binding("look_down", (pygame.K_k,), "", ""),
    Binding("look_right", (pygame.K_l,), "", ""),
    Binding("whole_table", (pygame.K_0, pygame.K_KP0), "0", "see the whole table"),
    Binding("fullscreen", (pygame.K_f, pygame.K_F11), "F, F11", "full screen"),
    Binding("screenshot", (pygame.K_F12,), "F12", "save a picture of the window"),
    Binding("help", (pygame.K_F1,), "F1", "this page"),
    Binding("cancel", (pygame.K_ESCAPE,), "Esc", "put the cue down; close this page"),
    Binding("quit", (pygame.K_q,), "Ctrl+Q", "quit", ctrl=True),
)

HANDS = (
    ("Move", "aim: the cue points through the pointer"),
    ("Press, pull back, release", "strike; the distance is the speed"),
    ("Ease forward, right click, Esc", "put the cue down without a stroke"),
    ("Wheel", "fine aim, as Left / Right (Ctrl: zoom at the pointer)"),
    ("Drag with the middle button", "move the view"),
    ("Drag on the time line", "go through the shot; Left and Right by events, , and . for its speed, Esc leaves"),
    ("Drag on the ball diagram", "where the tip meets the ball"),
    ("Drag on the cue diagram", "how steep the cue is"),
    ("Click with a ball in hand", "place it; red where it has no room"),
)


def action_of(key: int, mod: int) -> str | None:
    """The action bound to a key, if any."""
    ctrl = bool(mod & (pygame.KMOD_CTRL | pygame.KMOD_META))
    return next((b.action for b in BINDINGS if key in b.keys and b.ctrl in (None, ctrl)), None)


def fine_step(mod: int) -> float:
    """By how many degrees a fine turn of the aim goes."""
    if mod & pygame.KMOD_SHIFT:
        return 0.01
    return 1.0 if mod & pygame.KMOD_CTRL else 0.05
