"""What every test may use."""

from __future__ import annotations

import os
import tempfile

import pytest
from hypothesis import settings

import pool2d

# The presets, settings and pictures of whoever runs the tests are none of theirs.
for folder in ("DATA", "CONFIG", "CACHE", "PICTURES"):
    os.environ[f"POOL2D_{folder}"] = tempfile.mkdtemp(prefix="pool2d-")

# New examples on every run at a desk, the same ones every time on a build machine.
settings.register_profile("pool2d", deadline=None, print_blob=True, derandomize="CI" in os.environ)
settings.load_profile("pool2d")


@pytest.fixture(scope="session")
def table() -> pool2d.Table:
    """The default table; immutable, so one serves all."""
    return pool2d.load_table("pool-9ft")
