"""A hand at the tuning panel."""

from __future__ import annotations

import pygame

from pool2d.ui.play.tuning_panel import TuningPanel
from pool2d.ui.widgets.widget import Widget

from ..conftest import Hand


def opened(hand: Hand) -> TuningPanel:
    if hand.play.controller.tuning_panel is None:
        hand.key(pygame.K_t)
    assert hand.play.controller.tuning_panel is not None
    return hand.play.controller.tuning_panel


def widget(panel: TuningPanel, label: str) -> Widget:
    return next(one for one in panel.form.widgets if getattr(one, "label", "") == label)


def press(hand: Hand, pos: tuple[int, int]) -> None:
    hand.move(pos)
    hand.press()
    hand.release()


def shot(hand: Hand) -> None:
    hand.point(1.7, 0.9)
    hand.key(pygame.K_SPACE)
    hand.key(pygame.K_SPACE)
