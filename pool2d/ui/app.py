"""The window and its loop."""

from __future__ import annotations

from operator import attrgetter

import pygame

from ..config.settings import GUIDES, Settings, Store
from ..errors import InputError, suggest
from ..game.session import practice
from ..sound.mixer import Sounds
from ..table.preset import load_table
from ..table.table import Table
from ..table.watcher import WATCH, PresetWatcher
from .dialogs.help import Help
from .dialogs.options import OFFERED, OptionsPage
from .menus.drill_list import DrillList
from .menus.lobby import Lobby
from .play.play import Play
from .scene import Scene
from .toasts import Toasts
from .window import LARGEST, SIZE, Window
from .wording import ruling_text
from .wording.words import Words

_FPS = 60
# Settings are written when they have been left alone for so long, s.
_SETTLED = 1.0


class App:
    """A window on a table. `step` is one frame; tests post events and call it as the loop does.

    `store` is the player's settings; without one they are the defaults and are not kept. `words` is what it says and
    the keys that it goes by, as they say. `surface` is the window, where it is open already. With `menu` it opens with
    the menu, else with practice.
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
        self.window = Window(surface, size, self.store.values.screen.full)
        pygame.key.set_repeat(300, 30)
        self.words = Words()
        self.words.keys.read()
        self.sounds = Sounds()
        self.play = Play(practice(table, seed), self.words, self.sounds)
        self.toasts = Toasts()
        self._files = PresetWatcher(table)
        self._unsaved = 0.0
        # Whether what rests on the screen has been drawn as it rests.
        self._drawn = False
        # The scene that was laid out last, and for which size.
        self._laid_out: tuple[Scene, tuple[int, int]] | None = None
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
        for event in map(self.words.keys.understood, self.window.events()):
            if self.words.keys.idle(event):
                continue
            self.redraw()
            self._arrive()
            if event.type == pygame.QUIT:
                self.scene = None
            elif self.scene is not None and not self._is_for_window(event, self.scene):
                self.scene = self.scene.handle(event)
                self._arrive(event.type == pygame.KEYDOWN)
        if self.scene is not None:
            self.scene = self.scene.update(dt)
        if self.scene is None:
            self._save()
            return False
        self._arrive()
        self._watch(dt)
        self._keep(dt)
        self.toasts.update(dt)
        if not (self._drawn and self._still):
            self._draw(self.scene)
            self._drawn = self._still
        # Not only when it is drawn: a table may have come without any event.
        self._name(self.scene)
        return True

    def _arrive(self, by_key: bool = False) -> None:
        """Before anything else reaches it, let a scene that has just come know, and lay it out for the window."""
        scene, size = self.scene, self.window.room
        if scene is None or (scene, size) == self._laid_out:
            return
        if self._laid_out is None or scene is not self._laid_out[0]:
            scene.enter(by_key)
        self._laid_out = (scene, size)
        self.window.frame.forget()
        scene.lay_out(size)

    def _draw(self, scene: Scene) -> None:
        """Draw the scene, with notes over it, and present what has changed on the window."""
        frame = self.window.begin()
        scene.lay_out(frame.size)
        scene.draw(frame)
        if self.toasts.notes:
            self.toasts.draw(frame.surface)
            frame.cover()
        self.window.present()

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
        if not self.window.wait(WATCH):
            self._watch(WATCH)
            self._keep(WATCH)

    def close(self) -> None:
        self._save()
        self.play.close()
        self.window.close()
        self.sounds.close()

    # The window.

    def _is_for_window(self, event: pygame.event.Event, scene: Scene) -> bool:
        """Whether an event is about the window itself, whatever it shows; what it asks for is then done."""
        say = self.words.say
        if event.type == pygame.VIDEOEXPOSE:
            self.window.frame.forget()
        if event.type == pygame.VIDEORESIZE:
            self._resized()
            return True
        # What is typed into a field, or bound to an action, means nothing to the window.
        if event.type != pygame.KEYDOWN or scene.takes_text:
            return False
        action = self.words.keys.action_of(event.key, getattr(event, "mod", 0))
        if action == "fullscreen":
            self.store.turn("screen.full", not self.store.values.screen.full)
        elif action == "screenshot":
            self._screenshot()
        elif action == "mute":
            self.store.turn("sound.mute", not self.store.values.sound.mute)
            self.sounds.click()
            silent = self.sounds.muted
            self.toast(say("window.sound_off", key=self.words.key("mute")) if silent else say("window.sound_on"))
        elif scene.opens_pages and (page := self._page(action, scene)) is not None:
            scene.leave()
            self.scene = page
        else:
            return False
        return True

    def _page(self, action: str | None, below: Scene) -> Scene | None:
        """The page that a key opens over the table and over the menus alike, if it opens one."""
        if action == "options":
            return OptionsPage(below, self.store)
        if action == "drills":
            return DrillList(below, self.play)
        return Help(below) if action == "help" else None

    def _resized(self) -> None:
        self.window.resized()
        if not self.window.full:
            for name, pixels in zip(("screen.width", "screen.height"), self.window.size, strict=True):
                self.store.turn(name, min(pixels, LARGEST))

    def _screenshot(self) -> None:
        say = self.words.say
        try:
            self.toast(say("window.picture_saved", path=self.window.screenshot()))
        except InputError as error:
            self.toast(say("window.picture_failed", reason=error), wrong=True)

    def _name(self, scene: Scene) -> None:
        """Name the window after the table that is seen."""
        title = ruling_text.table_title(self.words, scene.table or self.play.state.session.table)
        self.window.name(f"pool2d \N{EN DASH} {title}")

    # The settings.

    def _apply(self) -> None:
        """Do as the settings say."""
        self.redraw()
        values = self.store.values
        for error in self.words.speak(values.screen.language):
            self.toast(str(error), wrong=True)
        self.words.speed_unit = values.aiming.speed_unit
        self.toasts.still = values.screen.reduced_motion
        self.play.take_options(values)
        self.sounds.volume = values.sound.volume
        self.sounds.mute(values.sound.mute)
        self._unsaved = 0.0
        self.window.full = values.screen.full

    def _take_keys(self) -> None:
        """Bind the keys that the player has bound, and drop what is wrong among them."""
        source, said, allowed = str(self.store.path), self.store.keys, self.words.say("options.keys.unknown")
        wrong = self.words.keys.take(said)
        for action in wrong:
            self.store.complain(InputError(source, f"keys.{action}", list(said[action]), allowed))
        if wrong:
            self.store.bind(self.words.keys.names())

    def _take_names(self) -> None:
        """Drop the names among the settings that stand for nothing."""
        for name, offered in OFFERED.items():
            value = attrgetter(name)(self.store.values)
            if value not in offered():
                self.store.complain(InputError(str(self.store.path), name, value, suggest(value, offered())))
                self.store.turn(name, attrgetter(name)(Settings()))

    def _keep(self, dt: float) -> None:
        """Keep what hands have changed in play, and write it once it has settled."""
        level = GUIDES[self.play.state.show.level]
        if level != self.store.values.aiming.guide:
            self.store.turn("aiming.guide", level)
        self.lobby.watch()
        for path in self.window.faults():
            self.toast(self.words.say("window.font_failed", path=path), wrong=True)
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
        if not self.play.state.mode.may_arrange:
            return
        table = self.play.state.session.table
        if (table.source, table.conditions) != self._files.behind:
            self._files = PresetWatcher(table)
            self.play.state.messages.warning = ""
        if self._files.changed(dt):
            self.redraw()
            try:
                self.play.state.change_table(load_table(table.source, table.set, table.conditions))
                self.play.state.messages.warning = ""
            except InputError as error:
                self.play.state.messages.warning = str(error)
