"""The window and its loop."""

from __future__ import annotations

import time
from collections.abc import Callable
from operator import attrgetter

import pygame

from ..config.folders import pictures_folder
from ..config.settings import GUIDES, Settings, Store
from ..draw import text
from ..draw.effects import effects_of, style_of
from ..draw.export import picture_file
from ..errors import InputError, suggest
from ..game.session import practice
from ..printable import printable
from ..sound.mixer import Sounds
from ..table.preset import load_table
from ..table.table import Table
from ..table.watcher import WATCH, PresetWatcher
from .dialogs.dialog import Dialog, bottom_scene
from .dialogs.help import Help
from .dialogs.options import OFFERED, OptionsPage
from .menus.drill_list import DrillList
from .menus.lobby import Lobby
from .menus.menu import Menu
from .play.play import Play
from .replay.replay_scene import Replay
from .scene import Scene
from .toasts import Toasts
from .window import LARGEST, SIZE, canvas, open_window, set_mode
from .wording import ruling_text, words
from .wording.keyboard import KEYBOARD
from .wording.keys import KEYS, Presses, action_of
from .wording.words import say

_FPS = 60
# Settings are written when they have been left alone for so long, s.
_SETTLED = 1.0


class App:
    """A window on a table. `step` is one frame; tests post events and call it as the loop does.

    `store` is the player's settings; without one they are the defaults and are not kept. `surface` is the
    window, where it is open already. With `menu` it opens with the menu, else with practice.
    """

    def __init__(
        self,
        table: Table,
        seed: int,
        size: tuple[int, int] = SIZE,
        store: Store | None = None,
        surface: pygame.Surface | None = None,
        menu: bool = False,
    ) -> None:
        self.store = store or Store()
        self.surface = surface or open_window(size, self.store.values.screen.full)
        self.size = size
        pygame.key.set_repeat(300, 30)
        self._presses = Presses()
        KEYBOARD.read()
        KEYS.lay()
        self._caption = ""
        self.sounds = Sounds()
        self.play = Play(practice(table, seed), self.sounds)
        self.toasts = Toasts()
        # What keys open over the table and over the menus alike.
        self._pages: dict[str | None, Callable[[Scene], Scene]] = {
            "options": lambda below: OptionsPage(below, self.store),
            "drills": lambda below: DrillList(below, self.play),
            "help": Help,
        }
        self._files = PresetWatcher(table)
        self._came: list[pygame.event.Event] = []
        self._unsaved = 0.0
        # Whether what rests on the screen has been drawn as it rests.
        self._drawn = False
        # The scene that the window shows as it was drawn last, with nothing else over it; None where that is not sure.
        self._shown: Scene | None = None
        self._take_names()
        self.store.listeners.append(self._apply)
        self._apply()
        self._take_keys()
        self.lobby = Lobby(self.play, self.store, lambda said: self.toast(said, wrong=True), self.toast)
        self.scene: Scene | None = self.lobby.menu() if menu else self.play
        for error in self.store.complaints:
            self.toast(str(error), wrong=True)

    def toast(self, said: str, wrong: bool = False) -> None:
        """Show a short note over whatever is on the screen."""
        self.toasts.say(said, wrong)
        self.redraw()

    def redraw(self) -> None:
        """Draw the next frame even where no event comes: something else has changed what is to be seen."""
        self._drawn = False

    def step(self, dt: float) -> bool:
        """Take the waiting events, let `dt` seconds pass and draw; False when the player has quit.

        A window that rests is not drawn again until an event comes, or `redraw` is called.
        """
        came, self._came = self._came, []
        for event in map(KEYS.understood, [*came, *pygame.event.get()]):
            if self._presses.idle(event):
                continue
            self.redraw()
            if event.type == pygame.QUIT:
                self.scene = None
            elif not self._window(event) and self.scene is not None:
                self._hand(event, self.scene)
        if self.scene is not None:
            self.scene = self.scene.update(dt)
        if self.scene is None:
            self._save()
            return False
        self._follow()
        self._watch(dt)
        self._keep(dt)
        self.toasts.update(dt)
        if not (self._drawn and self._still):
            self._draw(self.scene)
            self._drawn = self._still
        # Not only when it is drawn: a table may have come without any event.
        self._name()
        return True

    def _draw(self, scene: Scene) -> None:
        """Draw the scene, with notes over it, and present what has changed on the window."""
        on = canvas(self.surface)
        changed = scene.draw(on, kept=scene is self._shown and on is self.surface)
        self.toasts.draw(on)
        if on is not self.surface:
            self.surface.blit(on, (0, 0))
        self._shown = None if self.toasts.notes else scene
        if changed is None or self.toasts.notes:
            pygame.display.flip()
        else:
            pygame.display.update(changed)

    def _hand(self, event: pygame.event.Event, scene: Scene) -> None:
        """Let the scene take an event. A key that leads back to the table does not also strike, pressed twice."""
        self.scene = scene.handle(event)
        if event.type == pygame.KEYDOWN and self.scene is not scene and isinstance(self.scene, Play):
            self.scene.hands.armed = False

    def run(self, frames: int | None = None) -> None:
        """Play until the player quits, or for a number of frames."""
        clock = pygame.time.Clock()
        dt, count, preparing = 0.0, 0, True
        while (frames is None or count < frames) and self.step(dt):
            if frames is None and not preparing and self._drawn and self._still:
                self._rest()
                clock.tick()
            # A long pause, such as a window being dragged, is not made up for.
            dt = min(clock.tick(_FPS) / 1000.0, 0.1)
            count += 1
            # Between frames, and after the first: to open a device may take a moment.
            preparing = count < 2 or self.sounds.prepare()

    @property
    def _still(self) -> bool:
        """Whether the next frame would be as this one, unless an event comes."""
        return self.scene is not None and self.scene.still and not self.toasts.notes

    def _rest(self) -> None:
        """Do nothing until an event comes, or until the files are to be looked at again."""
        event = pygame.event.wait(round(1000 * WATCH))
        if event.type == pygame.NOEVENT:
            self._watch(WATCH)
            self._keep(WATCH)
        else:
            self._came.append(event)

    def close(self) -> None:
        self._save()
        # A match goes on under a drill that was opened over it; a drill has no record.
        self.lobby.play.session.leave()
        pygame.display.quit()
        self.sounds.close()

    # The window.

    def _window(self, event: pygame.event.Event) -> bool:
        """Whether an event was about the window itself, which is then done."""
        if event.type in (pygame.VIDEORESIZE, pygame.VIDEOEXPOSE):
            self._shown = None
        if event.type == pygame.VIDEORESIZE:
            self._resized()
            return True
        # What is typed into a field, or bound to an action, means nothing to the window.
        if event.type != pygame.KEYDOWN or (isinstance(self.scene, Dialog) and self.scene.typing):
            return False
        action = action_of(event.key, getattr(event, "mod", 0))
        if action == "fullscreen":
            self.store.turn("screen.full", not self.store.values.screen.full)
        elif action == "screenshot":
            self._screenshot()
        elif action == "mute":
            self.store.turn("sound.mute", not self.store.values.sound.mute)
            self.sounds.click()
            silent = self.sounds.muted
            self.toast(say("window.sound_off", key=KEYS.shown("mute")) if silent else say("window.sound_on"))
        elif action in self._pages and isinstance(self.scene, Play | Menu):
            # The hands leave the table, as they do when the window is left.
            self.scene.handle(pygame.event.Event(pygame.WINDOWFOCUSLOST))
            self.scene = self._pages[action](self.scene)
        else:
            return False
        return True

    def _resized(self) -> None:
        self.surface = pygame.display.get_surface() or self.surface
        if not self._full:
            self.size = self.surface.get_size()
            for name, pixels in zip(("screen.width", "screen.height"), self.size, strict=True):
                self.store.turn(name, min(pixels, LARGEST))

    @property
    def _full(self) -> bool:
        return bool(self.surface.get_flags() & pygame.FULLSCREEN)

    def _screenshot(self) -> None:
        path = pictures_folder() / time.strftime("pool2d-%Y%m%d-%H%M%S.png")
        for number in range(2, 100):
            if not path.exists():
                break
            path = path.with_stem(f"{path.stem.partition('_')[0]}_{number}")
        try:
            picture_file.save(self.surface, path)
            self.toast(say("window.picture_saved", path=path))
        except InputError as error:
            self.toast(say("window.picture_failed", reason=error), wrong=True)

    def _follow(self) -> None:
        """Settings and files are for the table that is on the screen."""
        if isinstance(self.scene, Play) and self.scene is not self.play:
            self.play = self.scene
            self._apply()

    def _name(self) -> None:
        """Name the window after the table that is seen."""
        seen = bottom_scene(self.scene) if self.scene is not None else None
        # What is played on, also before it is drawn for the first time.
        played = seen if isinstance(seen, Play) else self.play
        table = seen.stage.table if isinstance(seen, Replay) else played.session.table
        caption = f"pool2d \N{EN DASH} {ruling_text.table_title(table)}"
        if caption != self._caption:
            self._caption = caption
            pygame.display.set_caption(printable(caption, 200))

    # The settings.

    def _apply(self) -> None:
        """Do as the settings say."""
        self.redraw()
        values = self.store.values
        for error in words.speak(values.screen.language):
            self.toast(str(error), wrong=True)
        words.tell_speeds_in(values.aiming.speed_unit)
        self.toasts.still = values.screen.reduced_motion
        self.play.level = GUIDES.index(values.aiming.guide)
        self.play.effects = effects_of(values)
        self.play.stage.style = style_of(values)
        if self.play.tuning is not None:
            self.play.tuning.lay_out()
        self.sounds.volume = values.sound.volume
        self.sounds.mute(values.sound.mute)
        self._unsaved = 0.0
        if values.screen.full != self._full:
            self.surface = set_mode(self.size, values.screen.full)
            self._shown = None

    def _take_keys(self) -> None:
        """Bind the keys that the player has bound, and drop what is wrong among them."""
        wrong = KEYS.take(self.store.keys, str(self.store.path))
        for error in wrong:
            self.store.complain(error)
        if wrong:
            self.store.bind(KEYS.names())

    def _take_names(self) -> None:
        """Drop the names among the settings that stand for nothing."""
        for name, offered in OFFERED.items():
            value = attrgetter(name)(self.store.values)
            if value not in offered():
                self.store.complain(InputError(str(self.store.path), name, value, suggest(value, offered())))
                self.store.turn(name, attrgetter(name)(Settings()))

    def _keep(self, dt: float) -> None:
        """Keep what hands have changed in play, and write it once it has settled."""
        if GUIDES[self.play.level] != self.store.values.aiming.guide:
            self.store.turn("aiming.guide", GUIDES[self.play.level])
        self.lobby.watch()
        while text.failed:
            self.toast(say("window.font_failed", path=text.failed.pop()), wrong=True)
        self._unsaved += dt
        if self._unsaved > _SETTLED:
            self._save()

    def _save(self) -> None:
        try:
            self.store.save()
        except InputError as error:
            self.toast(str(error), wrong=True)

    # The preset's file.

    def _watch(self, dt: float) -> None:
        """Take a saved change of the preset's file, or say what is wrong with it and keep the old table.

        A match or a drill keeps its table; what has changed meanwhile is taken in practice after it.
        """
        if not self.play.session.is_practice:
            return
        table = self.play.session.table
        if (table.source, table.conditions) != self._files.behind:
            self._files = PresetWatcher(table)
            self.play.warning = ""
        if self._files.changed(dt):
            self.redraw()
            try:
                self.play.change_table(load_table(table.source, table.set, table.conditions))
                self.play.warning = ""
            except InputError as error:
                self.play.warning = str(error)
