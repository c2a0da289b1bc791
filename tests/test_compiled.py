"""Which engine runs, and that both give the same bits."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.bits import digest
from pool2d import __version__, compiled
from pool2d.game.records.engine import identity

# What shots came out as before, on a machine that rounds like this one, and those of them with every cue level, as they
# were when no ball could leave the cloth yet and the tip struck once. A change of it is a change of every record.
MACHINE = "567a60b6f6f2d158"
BEFORE = "cf426180f095ff629d48c6bf7d802eb3bbbc9f4c62ed5fe37d86efc9d9b39d0b"
LEVEL = "58e1c0a60808c239e085e2cbc1ded2a4b9d4d621ac30085a3b33aa043396f589"
ROOT = Path(__file__).resolve().parent.parent
# Prints the file that holds the engine's motions, and a number that is taken from their source.
ASK = "import pool2d.physics.motion as motion; print(motion.__file__, motion.STILL)"


def run(*words: str, cwd: Path = ROOT, **environment: str) -> str:
    """What Python prints where pool2d is the one in a folder."""
    kept = {name: value for name, value in os.environ.items() if name != compiled.INTERPRETED}
    done = subprocess.run(
        [sys.executable, *words], cwd=cwd, env=kept | environment, capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of the program's sources, with nothing compiled."""
    left = shutil.ignore_patterns("__pycache__", "*.so", "*.pyd", "compiled.*.txt")
    shutil.copytree(ROOT / "pool2d", tmp_path / "pool2d", ignore=left)
    return tmp_path


def stamp_of(copy: Path) -> Path:
    return compiled.stamp(copy / "pool2d" / "physics")


def false_module(copy: Path, name: str = "motion") -> Path:
    """An extension module that cannot be loaded, so that it is noticed where it is used."""
    suffix = stamp_of(copy).name.removeprefix("compiled").removesuffix(".txt")
    path = copy / "pool2d" / "physics" / f"{name}{suffix}"
    path.write_bytes(b"no library")
    return path


def digest_of(copy: Path) -> str:
    return run("-c", "from pool2d.compiled import digest; print(digest())", cwd=copy)


def test_without_a_compiled_engine_the_sources_run(copy: Path) -> None:
    assert run("-c", ASK, cwd=copy).split()[0].endswith("motion.py")
    assert run("-m", "pool2d", "--version", cwd=copy) == f"pool2d {__version__} interpreted"


def test_an_engine_compiled_from_these_sources_runs(copy: Path) -> None:
    false_module(copy)
    stamp_of(copy).write_text(digest_of(copy))
    assert run("-m", "pool2d", "--version", cwd=copy) == f"pool2d {__version__} compiled"
    with pytest.raises(subprocess.CalledProcessError) as failed:
        run("-c", ASK, cwd=copy)
    assert "ImportError" in failed.value.stderr


@pytest.mark.parametrize("file", ["motion.py", "params.py", "laws/nose.py"])
def test_a_source_that_is_changed_is_what_runs_next(copy: Path, file: str) -> None:
    false_module(copy)
    stamp_of(copy).write_text(digest_of(copy))
    source = copy / "pool2d" / "physics" / file
    source.write_text(source.read_text().replace("STILL: Final = 1e-9", "STILL: Final = 2e-9") + "\n# Changed.\n")
    told = run("-c", ASK, cwd=copy).split()
    assert told[0].endswith("motion.py")
    assert float(told[1]) == (2e-9 if file == "motion.py" else 1e-9)
    assert run("-m", "pool2d", "--version", cwd=copy).endswith("interpreted")


def test_a_module_without_its_source_is_not_found(copy: Path) -> None:
    """As one of a law that was taken away."""
    false_module(copy, "laws/ball_gone")
    false_module(copy, "gone")
    assert "ball_gone" not in run(
        "-c", "import pool2d.physics.laws.registry as found; print(found.BALL_LAWS)", cwd=copy
    )
    with pytest.raises(subprocess.CalledProcessError) as failed:
        run("-c", "import pool2d.physics.gone", cwd=copy)
    assert "ModuleNotFoundError" in failed.value.stderr


@pytest.mark.parametrize(("value", "word"), [("1", "interpreted"), ("yes", "interpreted"), ("0", None), ("", None)])
def test_the_sources_can_be_asked_for(copy: Path, value: str, word: str | None) -> None:
    stamp_of(copy).write_text(digest_of(copy))
    told = run("-m", "pool2d", "--version", cwd=copy, POOL2D_INTERPRETED=value)
    assert told.endswith(word or "compiled")


def test_only_modules_with_work_to_do_are_compiled() -> None:
    names = {path.relative_to(compiled.PHYSICS).as_posix() for path in compiled.modules()}
    assert {"world.py", "motion.py", "cluster.py", "laws/cushion_mathavan2010.py"} <= names
    assert not {"__init__.py", "params.py", "laws/__init__.py"} & names


@pytest.mark.skipif(identity().machine != MACHINE, reason="this machine rounds otherwise")
def test_shots_keep_their_bits() -> None:
    assert digest(0, 40) == BEFORE
    assert digest(0, 40, level=True) == LEVEL


@pytest.mark.skipif(not compiled.is_compiled(), reason="the compiled engine is not here, or its sources were changed")
@pytest.mark.parametrize("first", range(0, 2000, 250))
def test_compiled_and_interpreted_give_the_same_bits(first: int) -> None:
    told = run("-m", "benchmarks.bits", "--first", str(first), "--shots", "250", POOL2D_INTERPRETED="1")
    assert "interpreted" in told
    assert told.split()[-1] == digest(first, 250)
