"""What every test may rely on: no window system, the same random numbers in every run, one place for compiled kernels.

Compiled kernels are stored from run to run in pytest's own cache (`pytest --cache-clear` drops them): compiling all of
them costs about a minute of processor time.  They are found by the content of a kernel and of all that it calls, so
what is stale is never used; see `winkler.numerics.jit`.
"""

from __future__ import annotations

import gc
import importlib
import os
import signal
import tempfile
from pathlib import Path
from typing import Any

os.environ["MPLBACKEND"] = "Agg"
# As many tests run at once as there are cores: threads of linear algebra would only wait for each other, which takes
# twice the processor time where matrices are solved.  Children inherit it.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import hypothesis
import pytest

# Importing and collecting make much that stays: looking for garbage less often saves a quarter of their time.
gc.set_threshold(100_000, 10, 10)

ROOT = Path(__file__).resolve().parents[1]

hypothesis.settings.register_profile("winkler", deadline=None, derandomize=True, database=None, print_blob=True)
hypothesis.settings.load_profile("winkler")


def pytest_configure(config: pytest.Config) -> None:
    """Name the place for compiled kernels before numba is imported, and hear Ctrl-C; workers and children inherit both.

    A shell that starts pytest in the background (``pytest &`` in a script) starts it deaf to Ctrl-C.
    """
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if "NUMBA_CACHE_DIR" not in os.environ:
        try:
            os.environ["NUMBA_CACHE_DIR"] = str(config.cache.mkdir("kernels"))
        except (AttributeError, OSError):  # no cache is wanted, or it cannot be written
            fresh = tempfile.TemporaryDirectory(prefix="winkler-numba-")
            config.add_cleanup(fresh.cleanup)
            os.environ["NUMBA_CACHE_DIR"] = fresh.name


def pytest_sessionstart(session: pytest.Session) -> None:
    """Name failures at once; workers show nothing, and `-v` names each test."""
    shown = session.config.pluginmanager.get_plugin("terminalreporter")
    if shown is not None and session.config.get_verbosity() < 1:
        session.config.pluginmanager.register(Failures(shown))


class Failures:
    """Names a test as soon as it fails, with the first line of why: its whole report stands at the end of the run."""

    def __init__(self, shown: Any) -> None:
        self.shown = shown

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Write it below the dots."""
        if report.failed:
            crash = getattr(report.longrepr, "reprcrash", None)
            reason = crash.message.partition("\n")[0] if crash else ""
            self.shown.write_line(f"\nFAILED {report.nodeid} ({report.when}): {reason}"[:300], red=True)


MOST_SLOW = 3
"""Slow members of one test."""


def _spread(members: list[pytest.Item], count: int) -> list[pytest.Item]:
    """So many members of a test, far from each other, which have as many values of each parameter as possible."""
    width = len(members).bit_length()
    left = sorted(range(len(members)), key=lambda place: f"{place:0{width}b}"[::-1])  # van der Corput's order
    chosen: list[pytest.Item] = []
    seen: set[tuple[str, int]] = set()  # a parameter and its value, which its members share
    while left and len(chosen) < count:
        values = [{(name, id(value)) for name, value in members[place].callspec.params.items()} for place in left]
        best = max(range(len(left)), key=lambda place: len(values[place] - seen))
        seen |= values[best]
        chosen.append(members[left.pop(best)])
    return chosen


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run as many members of a test as its mark ``few`` says; of the others some are slow tests, and some long ones.

    Of more than `MOST_SLOW` slow members the others are long ones, too.
    """
    found: dict[tuple[pytest.Item, str], list[pytest.Item]] = {}
    for item in items:
        marks = {mark.name for mark in item.iter_markers()}
        if "few" in marks and not marks & {"slow", "long", "manual"}:
            found.setdefault((item.parent, item.originalname), []).append(item)
    for members in found.values():
        few = members[0].get_closest_marker("few")
        count, slow = few.args[0], few.kwargs.get("slow", len(members))
        chosen = _spread(members, count + slow)
        for item in members:
            if item not in chosen[:count]:
                item.add_marker(pytest.mark.slow if item in chosen else pytest.mark.long)
    slow: dict[tuple[pytest.Item, str], list[pytest.Item]] = {}
    for item in items:
        if {mark.name for mark in item.iter_markers()} & {"slow", "long", "manual", "browser"} == {"slow"}:
            slow.setdefault((item.parent, item.originalname), []).append(item)
    for members in (each for each in slow.values() if len(each) > MOST_SLOW):
        for item in set(members) - set(_spread(members, MOST_SLOW)):
            item.add_marker(pytest.mark.long)


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
    from winkler.values.vocabulary import GLOSSARY

    owned = {f"{cls.__name__}.{name}": entry for cls in owners for name, entry in vars(cls)["__words__"].items()}
    return GLOSSARY | owned


@pytest.fixture(autouse=True)
def _figures_closed():
    """Close what a test drew."""
    yield
    import sys

    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")
