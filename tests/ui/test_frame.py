"""What a frame knows: what is left from the last one, and where this one has changed."""

from __future__ import annotations

import pygame

from pool2d.ui.dialogs.options import OptionsPage
from pool2d.ui.frame import Frame

from .conftest import FRAME, Hand

A, B, BAR = pygame.Rect(1, 1, 5, 5), pygame.Rect(20, 1, 5, 5), pygame.Rect(0, 40, 60, 10)


def frame() -> Frame:
    made = Frame(pygame.Surface((60, 50)))
    made.begin()
    return made


def test_a_frame_counts_as_drawn_in_whole_unless_it_says_otherwise() -> None:
    made = frame()
    made.add([A])
    made.replace([BAR])
    assert made.before is made.changed is made.over is None
    made.begin()
    assert made.before is None


def test_what_was_drawn_over_is_cleared_by_the_next_frame_and_has_changed_in_both() -> None:
    made = frame()
    made.begin_over(cleared=False)
    made.add([A])
    made.replace([BAR])
    assert made.changed is None, "the first was drawn in whole"
    made.begin()
    assert made.before == [A], "what was replaced needs no clearing"
    made.begin_over(cleared=True)
    made.add([B])
    made.replace([BAR])
    assert made.changed == [A, B, BAR]
    made.begin()
    assert made.before == [B]


def test_what_may_be_anywhere_makes_this_frame_and_the_next_a_whole_one() -> None:
    made = frame()
    for spoil in (made.cover, made.forget):
        made.begin()
        made.begin_over(cleared=False)
        made.add([A])
        made.begin()
        made.begin_over(cleared=True)
        spoil()
        made.add([B])
        assert (made.changed is None) == (spoil == made.cover)
        made.begin()
        assert made.before is None


def test_a_scene_is_laid_out_before_it_takes_the_first_event(hand: Hand) -> None:
    hand.key(pygame.K_o)
    page = hand.app.scene
    assert isinstance(page, OptionsPage)
    close = page.form.widgets[-1].rect.center
    hand.key(pygame.K_ESCAPE)
    # The key that opens the page and a click on its button come in the same frame.
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_o, mod=0, unicode=""))
    for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
        pygame.event.post(pygame.event.Event(kind, pos=close, button=1))
    hand.app.step(FRAME)
    assert hand.app.scene is page.below


def test_an_event_after_a_resize_meets_what_stands_at_its_place_then(hand: Hand) -> None:
    size = (960, 540)
    pygame.display.set_mode(size, pygame.RESIZABLE)
    pygame.event.post(pygame.event.Event(pygame.VIDEORESIZE, size=size, w=size[0], h=size[1]))
    pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=(480, 200), rel=(0, 0), buttons=(0, 0, 0)))
    hand.app.step(FRAME)
    aim = hand.play.state.hands.aim.angle
    hand.move((400, 100))
    hand.move((480, 200))
    assert hand.play.stage.screen.width == 960 and hand.play.state.hands.aim.angle == aim
