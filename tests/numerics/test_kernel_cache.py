"""A cache of kernels that is damaged, full or another's costs time and one sentence, never the run or the numbers."""

from __future__ import annotations

import errno
import types

import numpy as np
import pytest

from winkler.numerics import cache_folders as caches
from winkler.numerics import kernel_cache
from winkler.numerics.jit import Kernel


def tripled(x: float) -> float:
    return 3.0 * x


def quadrupled(x: float) -> float:
    return 4.0 * x


@pytest.fixture
def place(tmp_path, monkeypatch, caplog):
    """Let kernels be kept in a folder of this test."""
    import numba

    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(kernel_cache, "_said", set())
    caplog.set_level("WARNING")
    return tmp_path


def hits(function=tripled):
    """Return how often a kernel that is made anew, as by another process, came from the disk."""
    kernel = Kernel(function)
    assert kernel(2.0) == function(2.0)
    return sum(kernel.machine.stats.cache_hits.values())


def kept(place):
    return [path for path in place.rglob("*") if path.is_file()]


def test_a_kernel_is_kept_in_one_file_and_found_again(place, caplog):
    assert hits() == 0
    assert len(kept(place)) == 1
    assert hits() == 1
    assert caplog.messages == []


@pytest.mark.parametrize("damage", ["emptied", "cut short", "zeros", "one bit"])
def test_a_damaged_file_is_compiled_anew_and_said_once(damage, place, caplog):
    hits()
    (path,) = kept(place)
    whole = path.read_bytes()
    changed = bytearray(whole)
    changed[len(whole) // 2] ^= 1
    contents = {"emptied": b"", "cut short": whole[:-9], "zeros": bytes(len(whole)), "one bit": bytes(changed)}
    for _ in range(2):
        path.write_bytes(contents[damage])
        assert hits() == 0
    assert path.stat().st_size > 1000
    assert hits() == 1
    assert len(caplog.messages) == 1
    assert "were damaged" in caplog.messages[0]


def full(*_, **__):
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("where", ["os.replace", "os.makedirs"])
def test_a_full_disk_costs_the_cache_alone(where, place, caplog, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(where, full)
        assert hits() == 0
    assert kept(place) == []
    if where != "os.makedirs":  # there numba itself finds no place
        assert len(caplog.messages) == 1
        assert "no space left on device" in caplog.messages[0]
        assert "NUMBA_CACHE_DIR" in caplog.messages[0]
    assert hits() == 0
    assert hits() == 1


def test_the_file_of_another_kernel_is_not_taken_for_this_one(place, monkeypatch):
    """numba names files by numbers: after a kill between index and code, a name may lead to older code."""
    hits()
    (path,) = kept(place)
    code = quadrupled.__code__.replace(co_name="tripled", co_firstlineno=tripled.__code__.co_firstlineno)
    other = types.FunctionType(code, globals(), "tripled")
    other.__module__, other.__qualname__ = tripled.__module__, tripled.__qualname__
    assert hits(other) == 0
    assert len(kept(place)) == 2
    assert path in kept(place)


def test_files_of_an_older_source_are_removed(place, monkeypatch):
    hits()
    (path,) = kept(place)
    older = path.with_name(path.name.replace(path.name.split(".")[-3], "0" * 12))
    path.rename(older)
    assert hits() == 0
    assert kept(place) == [path]


def test_without_a_place_nothing_is_kept(place, monkeypatch):
    monkeypatch.setattr(caches, "_writable", lambda _: False)
    monkeypatch.setattr(caches, "private_folder", lambda: None)
    assert Kernel(tripled)(2.0) == 6.0
    assert kept(place) == []
    assert np.isfinite(hits())
