"""What a referee sees of a shot, and nothing else: the rules judge by this. `referee.observe` makes it of a rollout."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from ...physics.values import Layout

ContactKind: TypeAlias = Literal["ball", "rail", "top", "pocket", "off"]
BALL: Final = "ball"
RAIL: Final = "rail"
TOP: Final = "top"
POCKET: Final = "pocket"
OFF: Final = "off"
# "double-hit": the tip was still on the cue ball when that met a ball; "second-hit": it struck it again; "push": it
# stayed with it; "scoop": it dug under it, and so lifted it.
StrokeFault: TypeAlias = Literal["double-hit", "second-hit", "push", "miscue", "scoop"]


class Contact(NamedTuple):
    """A ball met something: another ball, a rail, a pocket it fell into; or it left the table.

    A rail is a cushion, a jaw or the back of a pocket; its top, or a pocket's edge, on which a flying ball comes down
    is a "top". `other` is the other ball's id, or the name of the cushion or pocket; of a ball that left the table,
    the cushion it went over. The struck ball is `ball` in its contacts. A ball that is pressed against a rail it
    already lay on, or has not left, meets nothing.
    """

    kind: ContactKind
    ball: str
    other: str = ""


class Pot(NamedTuple):
    """A ball and the pocket it fell into."""

    ball: str
    pocket: str


@dataclass(frozen=True, slots=True)
class Call:
    """What the shooter said before the shot: the ball and pocket meant, or a safety, or a push out."""

    ball: str = ""
    pocket: str = ""
    safety: bool = False
    push: bool = False

    def as_dict(self) -> dict[str, Any]:
        """The call in JSON's types."""
        return {"ball": self.ball, "pocket": self.pocket, "safety": self.safety, "push": self.push}


@dataclass(frozen=True, slots=True)
class Report:
    """One shot as a referee saw it. It has more attributes than most classes, as no game needs all that a referee sees.

    Attributes:
        contacts: Who met what, in order.
        call: What was said before the shot.
        cue: The ball that was struck.
        first: The balls that the cue ball met first: several where it met them at the same moment.
        touching: The balls that touched the cue ball before the shot.
        pressed: Those of them that the shot pushed at.
        frozen: Pairs of a ball and the cushion that it lay on before the shot.
        stroke: What was wrong with the stroke itself.
        airborne: Whether the cue ball was in the air when it met its first ball.
        over: The object balls of which the cue ball passed over any part before it met its first ball.
        over_later: Those of which it did so afterwards.
        vaulted: The balls met first that it went over nonetheless: it came down beyond them before it met anything.
        on_rail: Of the balls that left the table, those that came to rest on a rail's top.
        kitchen: Whether the cue ball met its first ball behind the head string without having crossed that.
        stayed: Whether the cue ball neither crossed the head string nor met a ball beyond it.
        crossed: The object balls that went over the head string, either way.
        passed: The object balls that went over the middle of the table's length, either way.
        cleared: The object balls that came over that middle with their whole width.
        astray: Whether the cue ball went over the long string, which halves the table along its length.
        jammed: The cushions that the cue ball lay on and was shot into.
        strayed: On a table without pockets the object balls that stood in a corner (`corner_of`) and left it, if only
            for a while.
        start: The layout before the shot.
    """

    contacts: tuple[Contact, ...] = ()
    call: Call = field(default_factory=Call)
    cue: str = "cue"
    first: tuple[str, ...] = ()
    touching: tuple[str, ...] = ()
    pressed: tuple[str, ...] = ()
    frozen: tuple[tuple[str, str], ...] = ()
    stroke: tuple[StrokeFault, ...] = ()
    airborne: bool = False
    over: tuple[str, ...] = ()
    over_later: tuple[str, ...] = ()
    vaulted: tuple[str, ...] = ()
    on_rail: tuple[str, ...] = ()
    kitchen: bool = False
    stayed: bool = False
    crossed: tuple[str, ...] = ()
    passed: tuple[str, ...] = ()
    cleared: tuple[str, ...] = ()
    astray: bool = False
    jammed: tuple[str, ...] = ()
    strayed: tuple[str, ...] = ()
    start: Layout = field(default_factory=Layout)

    @property
    def pots(self) -> tuple[Pot, ...]:
        """The object balls that fell, in their order, and where."""
        return tuple(Pot(c.ball, c.other) for c in self.contacts if c.kind == POCKET and c.ball != self.cue)

    @property
    def potted(self) -> tuple[str, ...]:
        """The object balls that fell, in their order."""
        return tuple(pot.ball for pot in self.pots)

    @property
    def fallen(self) -> tuple[str, ...]:
        """Every ball that fell, the struck one too, in their order."""
        return tuple(c.ball for c in self.contacts if c.kind == POCKET)

    @property
    def off(self) -> tuple[str, ...]:
        """The object balls that left the table."""
        return tuple(ball for ball in self.left if ball != self.cue)

    @property
    def left(self) -> dict[str, str]:
        """The balls that left the table, the struck one too, in their order, and the cushion that each went over."""
        return {c.ball: c.other for c in self.contacts if c.kind == OFF}

    @property
    def scratch(self) -> bool:
        """Whether the cue ball fell into a pocket."""
        return any(c.kind == POCKET and c.ball == self.cue for c in self.contacts)

    @property
    def cue_off(self) -> bool:
        """Whether the cue ball left the table."""
        return self.cue in self.left

    @property
    def cue_gone(self) -> bool:
        """Whether the cue ball fell into a pocket or left the table."""
        return self.scratch or self.cue_off

    @property
    def after(self) -> tuple[Contact, ...]:
        """What came after the cue ball's first meeting with a ball; nothing where it met none."""
        for i, contact in enumerate(self.contacts):
            if contact.kind == BALL and contact.ball == self.cue:
                return self.contacts[i + 1 :]
        return ()

    @property
    def driven(self) -> tuple[str, ...]:
        """The balls driven to a rail after the first meeting, each once; falling or leaving counts too."""
        return tuple(dict.fromkeys(c.ball for c in self.after if c.kind != BALL))

    def called(self) -> str:
        """The ball that fell as it was called; where no pocket was, as was obvious; "" for none."""
        call = self.call
        if call.safety or call.push:
            return ""
        if call.pocket:
            return call.ball if Pot(call.ball, call.pocket) in self.pots else ""
        return next((pot.ball for pot in self.pots if self.obvious(pot) and call.ball in ("", pot.ball)), "")

    def obvious(self, pot: Pot) -> bool:
        """Whether a ball was met first and fell straight: no other ball, and no rail but the pocket's own."""
        before = [c.kind for c in self.contacts[: len(self.contacts) - len(self.after)] if self.cue == c.ball]
        parts = (f"{pot.pocket} jaw", f"{pot.pocket} back", pot.pocket)
        own = [c for c in self.of(pot.ball) if c.kind not in (RAIL, TOP) or c.other not in parts]
        straight = [Contact(BALL, pot.ball, self.cue), Contact(POCKET, pot.ball, pot.pocket)]
        return before == [BALL] and own == straight

    def of(self, ball: str) -> tuple[Contact, ...]:
        """The contacts of one ball, those with another ball told from its side."""
        mine = []
        for contact in self.contacts:
            if contact.ball == ball:
                mine.append(contact)
            elif contact.kind == BALL and contact.other == ball:
                mine.append(Contact(BALL, ball, contact.ball))
        return tuple(mine)
