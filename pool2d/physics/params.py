"""The physical knobs: cloth, balls, cushions, cue."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from ..config.knobs import choice, knob
from .laws.registry import BALL_LAWS, CUSHION_LAWS
from .values import Shot


@dataclass(frozen=True, slots=True)
class Cloth:
    mu_slide: float = knob(0.2, 0.01, 1.0, "", "sliding friction of a ball on the cloth")
    mu_roll: float = knob(0.01, 0.001, 0.2, "", "rolling resistance of the cloth")
    mu_spin: float = knob(0.0127, 0.001, 0.5, "", "friction that slows spin about the vertical")
    bounce: float = knob(0.5, 0.0, 1.0, "", "speed a ball keeps off the slate, of which none gives back over 0.95")
    bounce_friction: float = knob(0.2, 0.0, 1.0, "", "friction of a ball that comes down on the cloth or a rail's top")


@dataclass(frozen=True, slots=True)
class BallKnobs:
    radius: float = knob(0.028575, 0.01, 0.06, "m", "radius of a ball")
    mass: float = knob(0.17, 0.01, 2.0, "kg", "mass of a ball")
    restitution: float = knob(0.95, 0.0, 1.0, "", "speed kept along the line of centres, ball on ball")
    friction: float = knob(0.06, 0.0, 1.0, "", "friction between two balls, for laws with the same at any slip")
    friction_a: float = knob(9.951e-3, 0.0, 1.0, "", "friction a + b exp(-c slip) between two balls: at fast slip")
    friction_b: float = knob(0.108, 0.0, 1.0, "", "friction a + b exp(-c slip) between two balls: what slow slip adds")
    friction_c: float = knob(
        1.088, 0.0, 20.0, "s/m", "friction a + b exp(-c slip) between two balls: how soon it falls"
    )
    cling: float = knob(1.0, 0.0, 5.0, "", "multiplies the friction between balls: dirt and chalk, up to 3")
    law: str = choice("alciatore", tuple(BALL_LAWS), "how two balls exchange impulse")


@dataclass(frozen=True, slots=True)
class CushionKnobs:
    restitution: float = knob(0.92, 0.0, 1.0, "", "speed kept across the cushion")
    tangential: float = knob(0.0, 0.0, 1.0, "", "slip along the cushion that its rubber gives back after a grip")
    friction: float = knob(0.17, 0.0, 1.0, "", "friction between a ball and the cushion")
    nose_height: float = knob(0.0362903, 0.01, 0.1, "m", "height of the cushion's nose above the cloth")
    law: str = choice("mathavan2010", tuple(CUSHION_LAWS), "how a cushion returns a ball")


@dataclass(frozen=True, slots=True)
class FacingKnobs:
    """What pockets' facings are of, beside the cushions whose ends they are: left alone, of the same."""

    restitution: float = knob(1.0, 0.0, 1.0, "", "speed kept across a pocket's facing, as a part of a cushion's")
    tangential: float = knob(0.0, 0.0, 1.0, "", "slip along a facing that it gives back, on top of what a cushion does")
    friction: float = knob(1.0, 0.0, 5.0, "", "friction between a ball and a pocket's facing, in times a cushion's")


@dataclass(frozen=True, slots=True)
class RailKnobs:
    """The top of the rails, behind the cushions' noses."""

    width: float = knob(0.14, 0.1, 0.5, "m", "width of the rails, from the cushion's nose to their outer edge")
    height: float = knob(0.0, 0.0, 0.05, "m", "height of the rails' top above the cushion's nose")
    restitution: float = knob(0.5, 0.0, 0.95, "", "speed a ball keeps that comes down on a rail's top")


@dataclass(frozen=True, slots=True)
class PocketKnobs:
    """The back of the pockets, which balls meet that come fast or fly."""

    restitution: float = knob(0.1, 0.0, 0.95, "", "speed kept off the back of a pocket")
    friction: float = knob(0.0, 0.0, 1.0, "", "friction between a ball and the back of a pocket: lifts it out again")


@dataclass(frozen=True, slots=True)
class Cue:
    mass: float = knob(0.54, 0.1, 2.0, "kg", "mass of the cue")
    end_mass: float = knob(0.0085, 0.0, 0.1, "kg", "mass of the shaft's end that moves aside: squirt; 0 is none")
    tip_restitution: float = knob(0.73, 0.0, 1.0, "", "restitution of the tip: leather 0.71-0.75, phenolic 0.81-0.87")
    tip_friction: float = knob(0.6, 0.05, 10.0, "", "friction of the chalked tip: sets where a miscue begins")
    follow_through: float = knob(0.2, 0.0, 1.0, "m", "how far the tip runs on after a hard hit; 0 is gone at once")


@dataclass(frozen=True, slots=True)
class JumpCue:
    """What differs in a cue for jumping: it is light, so that it stops early, and its tip is hard."""

    mass: float = knob(0.28, 0.1, 2.0, "kg", "mass of the jump cue: about half of a playing cue's")
    tip_restitution: float = knob(0.84, 0.0, 1.0, "", "restitution of the jump cue's tip: phenolic 0.81-0.87")


@dataclass(frozen=True, slots=True)
class Physics:
    """Every physical parameter of one table."""

    gravity: float = knob(9.81, 0.1, 30.0, "m/s2", "acceleration of free fall")
    cloth: Cloth = field(default_factory=Cloth)
    ball: BallKnobs = field(default_factory=BallKnobs)
    cushion: CushionKnobs = field(default_factory=CushionKnobs)
    facing: FacingKnobs = field(default_factory=FacingKnobs)
    rail: RailKnobs = field(default_factory=RailKnobs)
    pocket: PocketKnobs = field(default_factory=PocketKnobs)
    cue: Cue = field(default_factory=Cue)
    jump_cue: JumpCue = field(default_factory=JumpCue)

    def struck_by(self, shot: Shot) -> Physics:
        """The same with the cue that a shot is played with as its `cue`."""
        if not shot.jump:
            return self
        jump = self.jump_cue
        return replace(self, cue=replace(self.cue, mass=jump.mass, tip_restitution=jump.tip_restitution))
