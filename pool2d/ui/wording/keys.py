"""What every key does: one table of defaults, which the player may change, and which the help lists."""

from __future__ import annotations

from collections.abc import Mapping

import pygame

from .keyboard import Keyboard

# A chord is a key's code, plus this where Ctrl is held.
CTRL = 1 << 27

DEFAULTS: dict[str, tuple[int, ...]] = {
    "turn_left": (pygame.K_LEFT,),
    "turn_right": (pygame.K_RIGHT,),
    "harder": (pygame.K_UP,),
    "softer": (pygame.K_DOWN,),
    "strike": (pygame.K_SPACE, pygame.K_RETURN),
    "spin_up": (pygame.K_w,),
    "spin_left": (pygame.K_a,),
    "spin_down": (pygame.K_s,),
    "spin_right": (pygame.K_d,),
    "no_spin": (pygame.K_BACKSPACE,),
    "lower": (pygame.K_q,),
    "raise": (pygame.K_e,),
    "jump_cue": (pygame.K_F8,),
    "guide": (pygame.K_g,),
    "vectors": (pygame.K_v,),
    "fast": (pygame.K_TAB,),
    "replay": (pygame.K_r,),
    "pause": (pygame.K_p,),
    "why": (pygame.K_h,),
    "undo": (pygame.K_u, CTRL + pygame.K_z),
    "redo": (CTRL + pygame.K_y,),
    "call": (pygame.K_y,),
    "call_ball": (pygame.K_F9,),
    "rack": (pygame.K_n,),
    "same_shot": (pygame.K_F5, CTRL + pygame.K_r),
    "next_ball": (pygame.K_x,),
    "add_ball": (pygame.K_c, pygame.K_INSERT),
    "remove_ball": (pygame.K_DELETE,),
    "mirror": (pygame.K_F6,),
    "mirror_ends": (pygame.K_F7,),
    "copy": (CTRL + pygame.K_c,),
    "paste": (CTRL + pygame.K_v,),
    "save_position": (CTRL + pygame.K_s,),
    "open_position": (CTRL + pygame.K_o,),
    "drills": (pygame.K_F2,),
    "next_drill": (pygame.K_F3,),
    "solution": (pygame.K_F4,),
    "tune": (pygame.K_t,),
    "geometry": (pygame.K_b,),
    "nearer": (pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS),
    "farther": (pygame.K_MINUS, pygame.K_KP_MINUS),
    "look_up": (pygame.K_i,),
    "look_left": (pygame.K_j,),
    "look_down": (pygame.K_k,),
    "look_right": (pygame.K_l,),
    "whole_table": (pygame.K_0, pygame.K_KP0),
    "mute": (pygame.K_m,),
    "options": (pygame.K_o,),
    "fullscreen": (pygame.K_f, pygame.K_F11),
    "screenshot": (pygame.K_F12,),
    "help": (pygame.K_F1,),
    "cancel": (pygame.K_ESCAPE,),
    "quit": (CTRL + pygame.K_q,),
}

# The help tells these together; every other action has a line of its own.
TOGETHER = (
    ("turn_left", "turn_right"),
    ("harder", "softer"),
    ("spin_up", "spin_left", "spin_down", "spin_right"),
    ("lower", "raise"),
    ("call", "call_ball"),
    ("next_ball", "add_ball", "remove_ball"),
    ("mirror", "mirror_ends"),
    ("copy", "paste"),
    ("save_position", "open_position"),
    ("drills", "next_drill", "solution"),
    ("nearer", "farther"),
    ("look_up", "look_left", "look_down", "look_right"),
)
HELD = ("fast",)
# What goes on while its key is held down; all else is done once for each press.
REPEATED = (
    "turn_left", "turn_right", "harder", "softer", "spin_up", "spin_left", "spin_down", "spin_right", "lower", "raise",
    "nearer", "farther", "look_up", "look_left", "look_down", "look_right", "undo", "redo",
)  # fmt: skip
# So do keys that move through something or delete letters, in every scene.
_MOVING = (
    pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN, pygame.K_PAGEUP, pygame.K_PAGEDOWN, pygame.K_BACKSPACE,
    pygame.K_DELETE,
)  # fmt: skip
HANDS = (
    "move",
    "pull",
    "ease",
    "wheel",
    "mean",
    "zoom",
    "pan",
    "line",
    "shots",
    "ball",
    "cue",
    "place",
    "carry",
    "put",
)

# These lie around the left hand, and go by their places where the letters there mean nothing else: on a French keyboard
# they are Z, Q, S and D.
_PLACED = ("spin_up", "spin_left", "spin_down", "spin_right", "lower", "raise")

# What goes back and what only changes other keys cannot be bound; nor can going back be bound to another key.
FIXED = ("cancel",)
_RESERVED = (
    pygame.K_ESCAPE, pygame.K_LSHIFT, pygame.K_RSHIFT, pygame.K_LCTRL, pygame.K_RCTRL, pygame.K_LALT, pygame.K_RALT,
    pygame.K_LGUI, pygame.K_RGUI, pygame.K_CAPSLOCK, pygame.K_NUMLOCK, pygame.K_UNKNOWN,
)  # fmt: skip


class Keymap:
    """Which chords do what: the defaults, with what the player has bound in their place.

    `defaults` are those for the player's `keyboard`.
    """

    def __init__(self) -> None:
        self.keyboard = Keyboard()
        self.defaults = dict(DEFAULTS)
        self.chords = dict(DEFAULTS)
        # The keys that are down.
        self._down: set[int] = set()

    # What keys mean.

    def read(self) -> None:
        """Go by the layout that the system has now; there has to be a window."""
        self.keyboard.read()
        self._lay()

    def _lay(self) -> None:
        """Go by the keyboard as it is known now."""
        before, self.defaults = self.defaults, _defaults(self.keyboard)
        for action in _PLACED:
            if self.chords[action] == before[action]:
                self.chords[action] = self.defaults[action]

    def understood(self, event: pygame.event.Event) -> pygame.event.Event:
        """An event as it is meant: a key of another alphabet is the one of ours in its place."""
        if event.type == pygame.KEYMAPCHANGED:
            self.read()
        if event.type not in (pygame.KEYDOWN, pygame.KEYUP):
            return event
        place = getattr(event, "scancode", 0)
        if self.keyboard.saw(event.key, place):
            self._lay()
        key = self.keyboard.meant(event.key, place, bound=self.owner(event.key) is not None)
        return event if key == event.key else pygame.event.Event(event.type, {**event.dict, "key": key})

    def idle(self, event: pygame.event.Event) -> bool:
        """Take an event; whether it only tells that a key is held, of which nothing more is to come.

        The system tells of a key that is held again and again, as if it were pressed anew.
        """
        if event.type == pygame.WINDOWFOCUSLOST:
            self._down.clear()
        elif event.type == pygame.KEYUP:
            self._down.discard(event.key)
        elif event.type == pygame.KEYDOWN:
            held = event.key in self._down
            self._down.add(event.key)
            action = self.action_of(event.key, getattr(event, "mod", 0))
            return held and event.key not in _MOVING and action not in REPEATED
        return False

    def action_of(self, key: int, mod: int) -> str | None:
        """The action bound to a key, if any. With Ctrl held, a key that means nothing more means the same."""
        ctrl = bool(mod & (pygame.KMOD_CTRL | pygame.KMOD_META))
        return (self.owner(key + CTRL) if ctrl else None) or self.owner(key)

    def owner(self, chord: int) -> str | None:
        """The action that has a chord."""
        return next((action for action, chords in self.chords.items() if chord in chords), None)

    # What is bound.

    def bind(self, action: str, *chords: int) -> None:
        """Do `action` by these chords alone, and nothing else by any of them."""
        for other, theirs in self.chords.items():
            self.chords[other] = tuple(chord for chord in theirs if chord not in chords)
        self.chords[action] = chords

    def reset(self, *actions: str) -> None:
        """Give actions their own chords back, from whatever has them."""
        for action in actions or tuple(DEFAULTS):
            self.bind(action, *self.defaults[action])

    def names(self) -> dict[str, list[str]]:
        """What differs from the defaults, as it is kept in the settings."""
        return {
            action: [_name(chord) for chord in chords]
            for action, chords in self.chords.items()
            if chords != self.defaults[action]
        }

    def take(self, names: Mapping[str, tuple[str, ...]]) -> list[str]:
        """Bind what the settings say, in place of everything bound; returns the actions whose entry is wrong.

        A wrong entry leaves its action with its default.
        """
        self.chords = dict(self.defaults)
        wrong = []
        taken: set[int] = set()
        for action, said in names.items():
            chords = tuple(_chord(name) for name in said)
            good = action in DEFAULTS and action not in FIXED and not taken & set(chords)
            if good and all(may_be_bound(chord) for chord in chords):
                self.bind(action, *chords)
                taken |= set(chords)
            else:
                wrong.append(action)
        return wrong


def _defaults(keyboard: Keyboard) -> dict[str, tuple[int, ...]]:
    """The defaults for a keyboard."""
    placed = {action: keyboard.codes[DEFAULTS[action][0]] for action in _PLACED}
    others = {chord for action, chords in DEFAULTS.items() if action not in _PLACED for chord in chords}
    if not keyboard.latin or others & set(placed.values()):
        return dict(DEFAULTS)
    return {**DEFAULTS, **{action: (key,) for action, key in placed.items()}}


def fine_step(mod: int) -> float:
    """By how many degrees a fine turn of the aim goes."""
    if mod & pygame.KMOD_SHIFT:
        return 0.01
    return 1.0 if mod & pygame.KMOD_CTRL else 0.05


def chord_of(key: int, mod: int) -> int:
    """A key as it is pressed."""
    return key + CTRL if mod & (pygame.KMOD_CTRL | pygame.KMOD_META) else key


def may_be_bound(chord: int) -> bool:
    """Whether a chord may be given a meaning."""
    return chord & ~CTRL not in _RESERVED


def rows() -> list[tuple[str, ...]]:
    """The actions, those together that the help tells together."""
    grouped = {action: group for group in TOGETHER for action in group}
    return list(dict.fromkeys(grouped.get(action, (action,)) for action in DEFAULTS))


def key_name(key: int) -> str:
    """The name of a key, without Ctrl; keys that only some keyboards have are known to SDL alone."""
    return pygame.key.name(key) or pygame.key.name(key, use_compat=False)


def _name(chord: int) -> str:
    name = key_name(chord & ~CTRL)
    return f"Ctrl+{name}" if chord & CTRL else name


def _chord(name: str) -> int:
    ctrl = name.lower().startswith("ctrl+") and len(name) > 5
    try:
        return pygame.key.key_code(name[5:] if ctrl else name) + (CTRL if ctrl else 0)
    except ValueError:
        return pygame.K_UNKNOWN
