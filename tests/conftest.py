"""What every test may rely on: no window system, the same random numbers in every run, one place for compiled kernels.

Compiled kernels are stored from run to run in pytest's own cache (`pytest --cache-clear` drops them): compiling all of
them costs about a minute of processor time.  They are found by the content of a kernel and of all that it calls, so
what is stale is never used; see `winkler.numerics.jit`.
"""

from __future__ import annotations

import gc
import importlib
import os
import tempfile
from pathlib import Path
from typing import Any

os.environ["MPLBACKEND"] = "Agg"

import hypothesis
import pytest

# Importing and collecting make much that stays: looking for garbage less often saves a quarter of their time.
gc.set_threshold(100_000, 10, 10)

ROOT = Path(__file__).resolve().parents[1]

hypothesis.settings.register_profile("winkler", deadline=None, derandomize=True, database=None, print_blob=True)
hypothesis.settings.load_profile("winkler")


def pytest_configure(config: pytest.Config) -> None:
    """Name the place for compiled kernels before numba is imported; the workers and their children inherit it."""
    if "NUMBA_CACHE_DIR" not in os.environ:
        try:
            os.environ["NUMBA_CACHE_DIR"] = str(config.cache.mkdir("kernels"))
        except (AttributeError, OSError):  # no cache is wanted, or it cannot be written
            fresh = tempfile.TemporaryDirectory(prefix="winkler-numba-")
            config.add_cleanup(fresh.cleanup)
            os.environ["NUMBA_CACHE_DIR"] = fresh.name


def pytest_collection_finish() -> None:
    """Look no more for garbage among some ten thousand collected tests and what they imported: each look takes long."""
    gc.collect()
    gc.freeze()


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


@pytest.fixture(scope="session")
def owners(root: Path) -> list[type]:
    """The classes that have words of their own."""
    source = root / "src"
    pages = [page for page in source.rglob("*.py") if "__words__ = " in page.read_text(encoding="utf-8")]
    modules = [importlib.import_module(".".join(page.relative_to(source).with_suffix("").parts)) for page in pages]
    named = {item for module in modules for item in vars(module).values() if isinstance(item, type)}
    found = sorted((item for item in named if "__words__" in vars(item)), key=str)
    assert len(found) > 100
    return found


@pytest.fixture(scope="session")
def entries(owners: list[type]) -> dict[str, Any]:
    """Every entry of the glossary: the shared ones, and those of classes as ``Class.field``."""
    from winkler.vocabulary import GLOSSARY

    owned = {f"{cls.__name__}.{name}": entry for cls in owners for name, entry in vars(cls)["__words__"].items()}
    return GLOSSARY | owned


@pytest.fixture(autouse=True)
def _figures_closed():
    """Close what a test drew."""
    yield
    import sys

    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")
