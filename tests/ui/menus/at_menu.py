"""What tests of menus and of matches that are left have in common."""

from __future__ import annotations

import os
from pathlib import Path

import pygame

from pool2d import Shot, load_table
from pool2d.game.records.recorder import unfinished
from pool2d.game.session import Session, recorded
from pool2d.game.setup import Setup
from pool2d.ui.menus.menu import Menu

from ..conftest import Hand


def left_match(race: int = 2) -> Path:
    """A match that has been begun and left: the first stroke was played."""
    session = recorded(load_table("pool-9ft"), Setup("nine-ball", names=("Ann", "Bo"), race=race, breaker=0))
    session.play(Shot(speed=8.0))
    session.leave()
    return unfinished()[0]


def left_matches(*races: int) -> list[Path]:
    """Matches that were left, the first the latest."""
    paths = [left_match(race) for race in races]
    for age, path in enumerate(paths):
        os.utime(path, (10 - age, 10 - age))
    return paths


def playing(hand: Hand, race: int = 2) -> Session:
    """Begin a match in the window."""
    setup = Setup("nine-ball", names=("Ann", "Bo"), race=race, breaker=0)
    hand.app.scene = hand.app.lobby.begin(recorded(load_table("pool-9ft"), setup))
    return hand.play.state.session


def labels(hand: Hand) -> list[str]:
    scene = hand.app.scene
    assert isinstance(scene, Menu)
    return [item.entry.label() for item in scene.items]


def choose(hand: Hand, label: str, by_mouse: bool = False) -> None:
    """Choose an entry of the menu that is open."""
    scene = hand.app.scene
    assert isinstance(scene, Menu)
    item = scene.items[labels(hand).index(label)]
    if by_mouse:
        hand.move(item.rect.center)
        hand.press()
        hand.release()
        return
    for _ in scene.items:
        if scene.form.focus is not item:
            hand.key(pygame.K_DOWN)
    hand.key(pygame.K_RETURN)


def shown(hand: Hand) -> object:
    return type(hand.app.scene)
