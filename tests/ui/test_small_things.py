"""Small things of the window, each of which could be lost without anything else showing it."""

from __future__ import annotations

import pygame
import pytest

from pool2d.draw import text, theme
from pool2d.errors import BudgetError
from pool2d.game.drills.drill_file import load
from pool2d.ui.dialogs.list_page import ListPage
from pool2d.ui.dialogs.pick import Pick
from pool2d.ui.menus.menu import Item, MenuEntry
from pool2d.ui.play.modes.drill_mode import DrillMode
from pool2d.ui.play.modes.practice_mode import PracticeMode
from pool2d.ui.widgets.list_row import ListRow
from pool2d.ui.widgets.widget import Heading, Widget

from .at_match import begin
from .conftest import FRAME, Hand


@pytest.mark.parametrize(
    ("key", "tip"),
    [(pygame.K_w, (0.0, 0.05)), (pygame.K_s, (0.0, -0.05)), (pygame.K_a, (-0.05, 0.0)), (pygame.K_d, (0.05, 0.0))],
)
def test_each_key_of_the_tip_moves_it_one_way(hand: Hand, key: int, tip: tuple[float, float]) -> None:
    hand.key(key)
    assert (hand.play.state.hands.aim.side, hand.play.state.hands.aim.height) == tip


def test_a_key_whose_release_was_never_told_is_pressed_anew(hand: Hand) -> None:
    hand.post(pygame.KEYDOWN, key=pygame.K_v, mod=0, unicode="v")
    hand.post(pygame.KEYDOWN, key=pygame.K_v, mod=0, unicode="v")
    assert hand.play.state.show.vectors
    hand.post(pygame.WINDOWFOCUSLOST)
    hand.post(pygame.KEYDOWN, key=pygame.K_v, mod=0, unicode="v")
    assert not hand.play.state.show.vectors


def test_delete_throws_away_only_what_can_be_and_when_asked_twice() -> None:
    gone: list[str] = []
    kept, lost = ListRow("kept", lambda: None), ListRow("lost", lambda: None, remove=lambda: gone.append("lost"))
    assert not kept.key(pygame.K_DELETE, 0)
    assert lost.key(pygame.K_DELETE, 0) and not gone
    assert lost.key(pygame.K_DELETE, 0) and gone == ["lost"]
    lost.key(pygame.K_DELETE, 0)
    lost.leave()
    lost.key(pygame.K_DELETE, 0)
    assert gone == ["lost"]


def test_enter_on_a_list_leads_on_or_tells_what_is_wrong(hand: Hand) -> None:
    answers: list[object] = ["not this one", hand.play]
    pick = Pick(hand.play, "Which?", ["a", "b"], 1, "Take", lambda at: answers.pop(0))  # type: ignore[arg-type,return-value]
    enter = pygame.event.Event(pygame.KEYDOWN, key=pygame.K_RETURN, mod=0)
    assert pick.chosen == "b"
    assert pick.handle(enter) is pick and pick.wrong == "not this one"
    assert pick.handle(enter) is hand.play


def test_the_wheel_holds_a_shot_that_is_seen_again(hand: Hand) -> None:
    hand.strike()
    hand.key(pygame.K_r)
    hand.app.step(0.5)
    shown = hand.play.state.playback
    assert shown is not None and not shown.paused
    hand.wheel(1)
    assert shown.paused


def test_a_line_of_a_menu_says_what_it_is_at_its_left() -> None:
    def drawn(label: str) -> pygame.Rect:
        item = Item(MenuEntry(lambda: label, lambda: None), lambda entry: None)
        item.rect = pygame.Rect(10, 10, 300, 36)
        surface = pygame.Surface((320, 60))
        item.draw(surface, 8, False, False)
        light = pygame.mask.from_threshold(surface, (236, 232, 222), (140, 140, 140, 255)).get_bounding_rects()
        return light[0].unionall(light)

    place = drawn("HHHH")
    assert abs(place.left - 26) <= 3 and abs(place.centery - 30) <= 3 and 15 < place.width < 100
    # As large as a line of a menu is, and not cut before it fills its room of 268 pixels.
    for label in ("HHHH", "H" * 19):
        wide = text.font(18).size(label)[0]
        assert wide <= 268 and abs(drawn(label).width - wide) <= 4


def test_the_marked_line_of_a_menu_is_lit_and_what_is_told_of_it_stands_below(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn = []
    monkeypatch.setattr(
        text, "draw", lambda surface, said, size, color, place, *more: drawn.append((said, color, place))
    )
    item = Item(MenuEntry(lambda: "A", lambda: None, lambda: ["b", "c"]), lambda entry: None)
    item.rect = pygame.Rect(10, 10, 300, 80)
    for focused in (False, True):
        item.draw(pygame.Surface((320, 120)), 8, focused, False)
    assert [color for said, color, _ in drawn if said == "A"] == [theme.TEXT, theme.ACCENT_LIT]
    heights = [place[1] for _, _, place in drawn[:3]]
    assert heights == sorted(heights) and heights[1] - heights[0] == heights[2] - heights[1] > 8


class Empty(ListPage):
    def entries(self) -> list[Widget]:
        return []


def test_a_shelf_tells_what_it_is_for_where_it_has_something_to_say(hand: Hand) -> None:
    def said(shelf: ListPage) -> list[str]:
        return [widget.words() for widget in shelf.form.widgets if isinstance(widget, Heading)]

    assert said(Empty(hand.play, lambda: "Shelf", lambda: "What lies here.")) == ["Shelf", "What lies here."]
    assert said(Empty(hand.play, lambda: "Shelf")) == ["Shelf"]


@pytest.mark.parametrize(
    ("game", "table", "within", "beyond"),
    [("eight-ball", "pool-9ft", (0.3, 0.3), (0.9, 0.3)), ("snooker", "snooker-12ft", (0.6, 0.8), (0.3, 0.3))],
)
def test_where_a_ball_in_hand_may_go_is_shaded(
    hand: Hand, game: str, table: str, within: tuple[float, float], beyond: tuple[float, float]
) -> None:
    begin(hand, game, table)
    view = hand.play.stage.view

    def colors() -> list[pygame.Color]:
        hand.app.redraw()
        hand.app.step(0.0)
        places = (view.to_screen(*place) for place in (within, beyond))
        return [hand.app.window.surface.get_at((round(x), round(y))) for x, y in places]

    # The guide and the cue are out of the way of both.
    hand.play.state.hands.aim = hand.play.state.hands.aim.toward(1.0, 0.0)
    before = colors()
    hand.key(pygame.K_x)
    hand.play.state.in_hand.at = (1.2, 1.1)
    inside, outside = colors()
    assert inside.r > before[0].r + 8 and outside == before[1]


def test_a_drill_on_the_table_is_as_the_settings_say(hand: Hand) -> None:
    hand.app.store.turn("aiming.guide", "off")
    hand.app.store.turn("balls.patterned", True)
    hand.play.drill(load("stop-shot"), hand.play)
    hand.app.step(FRAME)
    assert isinstance(hand.play.state.mode, DrillMode)
    assert hand.play.state.show.level == 0 and hand.play.stage.style.patterned
    # What is chosen there holds for the table that it came from.
    hand.key(pygame.K_g)
    hand.app.store.turn("balls.patterned", False)
    hand.key(pygame.K_ESCAPE)
    assert isinstance(hand.play.state.mode, PracticeMode)
    assert hand.play.state.show.level == 1 and not hand.play.stage.style.patterned


def test_a_shot_that_the_engine_gives_up_is_told_and_the_balls_stay(two: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    before = two.play.state.session.layout

    def gives_up(*given: object, **more: object) -> None:
        raise BudgetError(50_000, 1.0, {})

    monkeypatch.setattr("pool2d.ui.play.foresight.simulate", gives_up)
    monkeypatch.setattr(two.play.state.session, "do", gives_up)
    two.key(pygame.K_SPACE)
    assert two.open and two.play.state.playback is None
    assert "not over" in two.play.state.messages.text and two.play.state.session.layout == before
