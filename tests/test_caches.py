"""Where nothing of the user can be written there is a private folder, or nothing is stored; see .ci/unprivileged."""

from __future__ import annotations

import os
import stat
import tempfile
from pathlib import Path

import numpy as np
import pytest

from winkler.numerics import cache_folders as caches
from winkler.numerics.jit import Kernel, compiled
from winkler.values.errors import InvalidInput

pytestmark = pytest.mark.skipif(os.name == "nt", reason="containers are")

NAMES = ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "HOME")


@pytest.fixture
def place(tmp_path, monkeypatch) -> Path:
    """Let temporary files lie in a folder of this test, and this process have made none yet."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(caches, "private_folder", caches.private_folder.__wrapped__)
    for name in NAMES:
        monkeypatch.delenv(name, raising=False)
    return tmp_path


def test_the_folder_is_private_and_its_name_cannot_be_guessed(place):
    one, other = caches.private_folder(), caches.private_folder()
    assert stat.S_IMODE(one.stat().st_mode) == 0o700
    assert one.parent == place
    assert len({one.name, other.name}) == 2
    assert other.is_dir()  # its process still runs
    caches._remove(one, os.getpid() + 1)
    assert one.is_dir()
    caches._remove(one, os.getpid())
    assert not one.exists()


def test_what_a_killed_process_left_is_removed_and_nothing_else(place):
    left, link = place / f"{caches.FOLDER_PREFIX}left", place / f"{caches.FOLDER_PREFIX}x"
    victim, other = place / "victim", place / "y"
    for folder in (left, victim, other):
        (folder / "inside").mkdir(parents=True)
    link.symlink_to(victim)
    caches.private_folder()
    assert not left.exists()
    assert (victim / "inside").is_dir()
    assert (other / "inside").is_dir()


@pytest.mark.parametrize(("mode", "taken"), [(0o777, False), (0o770, False), (0o1777, True), (0o755, True)])
def test_a_place_where_others_could_exchange_it_is_not_taken(place, mode, taken):
    place.chmod(mode)
    assert (caches.private_folder() is not None) is taken


def test_kernels_and_fonts_lie_there_if_nothing_else_can_be_written(place, monkeypatch):
    requested = []
    monkeypatch.setattr(caches, "_writable", requested.append)
    monkeypatch.setenv("HOME", "/home/of/nobody")
    assert caches.with_kernels(Path("/package/module.py"))
    caches.with_fonts()
    assert Path("/package/__pycache__") in requested
    assert Path("/home/of/nobody/.cache/numba") in requested
    for name in ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME"):
        assert Path(os.environ[name]).relative_to(place).parts[0].startswith(caches.FOLDER_PREFIX)
        monkeypatch.delenv(name)


def test_a_home_is_left_as_it_is(place, monkeypatch):
    monkeypatch.setenv("HOME", str(place))
    before = dict(os.environ)
    assert caches.with_kernels(place / "missing" / "module.py")
    caches.with_fonts()
    assert dict(os.environ) == before
    assert list(place.iterdir()) == []


def test_a_path_without_a_home_is_no_place():
    """`~/.cache` of a user without a home would lie in whatever folder is the current one."""
    assert not caches._writable(Path("~/.cache/numba"))
    assert not caches._writable(Path(os.devnull) / "numba")


def test_without_any_place_kernels_are_stored_nowhere_and_figures_are_refused(place, monkeypatch):
    def none():
        raise FileNotFoundError("No usable temporary directory found")

    monkeypatch.setattr(caches, "_writable", lambda _: False)
    monkeypatch.setattr(tempfile, "gettempdir", none)
    assert not caches.with_kernels(Path("/package/module.py"))
    kernel = Kernel(_twice.function)
    assert kernel(np.ones(2)) == 4.0
    assert kernel.machine._cache.cache_path is None
    with pytest.raises(InvalidInput, match="there is none; set TMPDIR to one"):
        caches.with_fonts()


@compiled
def _twice(numbers: np.ndarray) -> float:
    total = 0.0
    for i in range(numbers.size):
        total += 2.0 * numbers[i]
    return total
