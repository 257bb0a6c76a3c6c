"""What every test may rely on: no window system, no stale compiled code, the same random numbers in every run."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

os.environ["MPLBACKEND"] = "Agg"
if "NUMBA_CACHE_DIR" not in os.environ:
    _fresh = tempfile.TemporaryDirectory(prefix="winkler-numba-")
    os.environ["NUMBA_CACHE_DIR"] = _fresh.name

import hypothesis
import pytest

ROOT = Path(__file__).resolve().parents[1]

hypothesis.settings.register_profile("house", deadline=None, derandomize=True, database=None, print_blob=True)
hypothesis.settings.load_profile("house")


@pytest.fixture(scope="session")
def root() -> Path:
    """The folder of the project."""
    return ROOT


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Measured and independently computed files that the project does not ship; skips where they are absent."""
    given = os.environ.get("WINKLER_SHARED_DATA")
    folder = Path(given) if given else ROOT.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("the measured files are not here: set WINKLER_SHARED_DATA to their folder")
    return folder


@pytest.fixture(autouse=True)
def _figures_closed():
    """Close what a test drew."""
    yield
    import sys

    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")
