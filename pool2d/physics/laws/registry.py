"""Every law by its name: each is a module here, `ball_NAME` or `cushion_NAME`, that defines LAW."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from .law import BallLaw, CushionLaw


def _found() -> tuple[dict[str, BallLaw], dict[str, CushionLaw]]:
    """The laws for balls and for cushions; raises ValueError for one that is not named as its module is."""
    balls: dict[str, BallLaw] = {}
    cushions: dict[str, CushionLaw] = {}
    for module in sorted(path.stem for path in Path(__file__).parent.glob("*.py")):
        kind, _, name = module.partition("_")
        if kind not in ("ball", "cushion") or not name:
            continue
        law = import_module(f".{module}", __package__).LAW
        if law.name != name:
            raise ValueError(f"the law in {module} is named {law.name!r}")
        if isinstance(law, BallLaw):
            balls[name] = law
        else:
            cushions[name] = law
    return balls, cushions


BALL_LAWS, CUSHION_LAWS = _found()
