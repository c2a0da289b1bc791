"""A hand that trembles, but looks: it pots what a person would, through the controls that a person has.

It aims by the mouse, reads where the guide's line ends, corrects with the wheel, pulls back until the speed
shown is right, and lets go. It knows nothing that is not on the screen.
"""

from __future__ import annotations

import math
import random

import pygame

from pool2d import Ball
from pool2d.draw import guide
from pool2d.physics.values import POCKETED

from ..conftest import Hand

SHOTS = 100
RADIUS = 0.028575
# How far a hand is off, in pixels, and when it is content with its aim, in degrees.
TREMBLE = 1.5
CLOSE_ENOUGH = 0.3


class Shaky(Hand):
    """A hand whose every movement is off by a pixel or two."""

    rng = random.Random(7)

    def toward(self, pos: tuple[float, float]) -> None:
        """Move there in a few uneven steps, which all come in one frame."""
        start = self.at
        for part in (0.3, 0.7, 1.0):
            x, y = (round(a + part * (b - a) + self.rng.gauss(0.0, TREMBLE)) for a, b in zip(start, pos, strict=True))
            if part < 1.0:
                pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=(x, y), rel=(0, 0), buttons=(0, 0, 0)))
        self.move((x, y))

    def miss(self, pocket: tuple[float, float]) -> float:
        """By how many degrees the object ball's line, as it is drawn, goes to the left of the pocket."""
        play = self.play
        shot = play.state.hands.aim.shot("cue", play.state.hands.speed)
        session = play.state.session
        rollout = play.state.foresight.rollout(session.table, play.state.show.level, session.layout, shot)
        assert rollout is not None
        line = guide.foresee(rollout, "cue").object
        if not line:
            return math.nan
        (ax, ay), (bx, by) = line[0], line[-1]
        return math.degrees(
            math.remainder(math.atan2(by - ay, bx - ax) - math.atan2(pocket[1] - ay, pocket[0] - ax), math.tau)
        )

    def correct(self, pocket: tuple[float, float], gain: float) -> None:
        """Turn the wheel until the line goes into the pocket; `gain` is how much faster the line turns than the cue."""
        for _ in range(12):
            miss = self.miss(pocket)
            if abs(miss) < CLOSE_ENOUGH:
                return
            if abs(miss) < gain * 0.05:
                pygame.key.set_mods(pygame.KMOD_LSHIFT)
                self.wheel(round(miss / gain / 0.01) or int(math.copysign(1.0, miss)))
                pygame.key.set_mods(0)
            else:
                self.wheel(round(miss / gain / 0.05))

    def stroke(self, speed: float) -> None:
        """Pull back until about this speed is shown, and let go."""
        start, angle = self.at, math.radians(self.play.state.hands.aim.angle)
        self.press()
        far = 0.0
        while self.play.state.hands.speed < speed:
            far += 12.0
            self.toward((start[0] - far * math.cos(angle), start[1] + far * math.sin(angle)))
        self.release()


def test_a_trembling_hand_pots_what_the_guide_promises(hand: Hand) -> None:
    rng = random.Random(11)
    hand.app.window.surface = pygame.display.set_mode((960, 540), pygame.RESIZABLE)
    shaky = Shaky(hand.app)
    potted = 0
    for _ in range(SHOTS):
        cue, ball, pocket = position(rng, hand)
        shaky.set_balls(cue, ball)
        line = math.atan2(pocket[1] - ball.y, pocket[0] - ball.x)
        # By eye: through where the cue ball must be to send the other toward the pocket.
        ghost = (ball.x - 2 * RADIUS * math.cos(line), ball.y - 2 * RADIUS * math.sin(line))
        shaky.toward(hand.play.stage.view.to_screen(*ghost))
        cut = math.remainder(line - math.atan2(ghost[1] - cue.y, ghost[0] - cue.x), math.tau)
        shaky.correct(pocket, math.dist(ghost, (cue.x, cue.y)) / (2 * RADIUS * math.cos(cut)))
        shaky.stroke(rng.uniform(1.5, 4.0))
        assert hand.play.state.session.strokes == 1
        potted += hand.play.state.session.layout["1"].phase == POCKETED
        shaky.key(pygame.K_RETURN)
    assert potted >= 95


def position(rng: random.Random, hand: Hand) -> tuple[Ball, Ball, tuple[float, float]]:
    """A cue ball, an object ball near a pocket, and the pocket: straight, or cut by up to 50 degrees."""
    table = hand.play.state.session.table
    while True:
        pocket = rng.choice(table.geometry.pockets)
        # Out of a corner the middle of the table lies at 45 degrees, out of a side pocket straight across.
        along = 0.0 if abs(pocket.x - 1.27) < 0.1 else math.copysign(1.0, 1.27 - pocket.x)
        out = math.atan2(math.copysign(1.0, 0.635 - pocket.y), along) + math.radians(rng.uniform(-15.0, 15.0))
        far, off = rng.uniform(0.2, 0.6), rng.uniform(0.2, 0.6)
        ball = Ball("1", pocket.x + far * math.cos(out), pocket.y + far * math.sin(out))
        cut = out + math.radians(rng.choice([0.0, rng.uniform(-50.0, 50.0)]))
        cue = Ball("cue", ball.x + off * math.cos(cut), ball.y + off * math.sin(cut))
        if 0.1 < cue.x < 2.44 and 0.1 < cue.y < 1.17:
            return cue, ball, (pocket.x, pocket.y)
