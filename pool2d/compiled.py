"""Which engine runs: the compiled one where it is there and made from these very sources, else the sources themselves.

`setup.py` compiles the modules of `physics/` with mypyc and leaves beside them a digest of their sources. Where the
sources are others now, an extension module may not be used: they are read instead, whatever lies beside them.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from functools import cache
from importlib.machinery import EXTENSION_SUFFIXES, ModuleSpec
from importlib.util import spec_from_file_location
from pathlib import Path
from types import ModuleType

# Set to anything but nothing or 0, only sources run.
INTERPRETED = "POOL2D_INTERPRETED"
# What the extension modules share is a library of this name, `__mypyc` added.
GROUP = "pool2d.physics.engine"
PHYSICS = Path(__file__).parent / "physics"
# They stay as they are: `help` reads what `simulate` says of itself, params are inherited from, and the others hold
# nothing that takes time.
_LEFT = ("__init__", "params", "registry", "rollout", "simulate", "values")


def modules() -> list[Path]:
    """The files that are compiled."""
    return [path for path in _sources() if path.stem not in _LEFT]


def stamp(folder: Path) -> Path:
    """Where the digest of the sources lies that the extension modules in a folder were made of, for this Python."""
    return folder / f"compiled{EXTENSION_SUFFIXES[0]}.txt"


def digest() -> str:
    """A digest of all sources of the engine; what is left uncompiled too, as its constants are compiled in."""
    # Where nothing is compiled, no start has to wait for this.
    import hashlib

    sha = hashlib.sha256()
    for path in _sources():
        sha.update(path.relative_to(PHYSICS).as_posix().encode() + b"\0" + path.read_bytes())
    return sha.hexdigest()


@cache
def is_compiled() -> bool:
    """Whether the compiled engine runs."""
    if os.environ.get(INTERPRETED, "0") not in ("", "0"):
        return False
    try:
        return stamp(PHYSICS).read_text() == digest()
    except (OSError, UnicodeDecodeError):
        return False


def engine() -> str:
    """Which engine runs, in a word: compiled or interpreted."""
    return "compiled" if is_compiled() else "interpreted"


def choose() -> None:
    """Let the sources of the engine be imported where the compiled one may not be used."""
    if not is_compiled() and not any(isinstance(finder, _Sources) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Sources())


class _Sources:
    """Finds the engine's modules by their sources alone."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        package, _, rest = fullname.partition(".physics.")
        if package != __package__ or not rest or path is None:
            return None
        folder = Path(path[0])
        name = rest.rpartition(".")[2]
        if (folder / name / "__init__.py").is_file():
            return None
        source = folder / f"{name}.py"
        if source.is_file():
            return spec_from_file_location(fullname, source)
        # An extension module that has lost its source is not to be found by others either.
        raise ModuleNotFoundError(f"No module named {fullname!r}", name=fullname)


def _sources() -> list[Path]:
    return sorted(PHYSICS.rglob("*.py"))
