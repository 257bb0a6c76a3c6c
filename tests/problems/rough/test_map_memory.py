"""Memory of height maps is said before it is taken, and compared with what is free."""

from __future__ import annotations

import logging
import math

import numpy as np
import pytest

from winkler.checks import free_memory
from winkler.errors import InvalidInput
from winkler.loading import Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.surfaces import pressed_box
from winkler.numerics.surfaces.surface_grid import bytes_needed
from winkler.problems.rough import map_memory
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.topography import Topography

X = np.arange(32) / 32.0
WAVY = Topography(1e-6 * np.cos(2.0 * np.pi * X)[:, None] + 1e-6 * np.cos(2.0 * np.pi * X), [1e-3, 1e-3], True)
PROBLEM = SurfaceContact(WAVY, HalfSpace(Elastic(1e9, 0.3)), Force(0.1))


def test_a_large_map_says_what_it_takes_and_which_step_it_is_at(monkeypatch, caplog):
    monkeypatch.setattr(map_memory, "STATED_BYTES", 0)
    monkeypatch.setattr(map_memory, "free_memory", lambda: 3.0 * 2**30)
    monkeypatch.setattr(pressed_box, "REPORTED_PIXELS", 1)
    with caplog.at_level(logging.INFO, logger="winkler"):
        PROBLEM.solve()
    first, *steps = [record.getMessage() for record in caplog.records]
    gib = bytes_needed((32, 32), True) / 2**30
    assert first == (
        f"SurfaceContact: a map of 32 x 32 pixels takes about {gib:.2g} GiB of memory, of 3 GiB that are free."
    )
    assert steps[0].startswith("32 x 32 pixels, step 0: misfit ")
    assert steps[-1].endswith(", 6e-07 allowed")


def test_a_small_map_says_nothing(caplog):
    with caplog.at_level(logging.INFO, logger="winkler"):
        PROBLEM.solve()
    assert not caplog.records


def test_a_map_for_which_too_little_is_free_is_refused_before_it_is_solved(monkeypatch):
    monkeypatch.setattr(map_memory, "STATED_BYTES", 0)
    monkeypatch.setattr(map_memory, "free_memory", lambda: 1000.0)
    monkeypatch.setattr(Topography, "gaps", property(lambda self: pytest.fail("memory was taken")))
    with pytest.raises(
        InvalidInput, match=r"takes about 0.00014 GiB of memory, of 9.3e-07 GiB that are free; end other"
    ):
        next(iter(PROBLEM.steps()))


def test_a_map_of_sixteen_million_pixels_takes_less_than_the_machine_of_the_manual():
    """24 GiB, of which the manual states 12 at most."""
    assert bytes_needed((4096, 4096), True) < 4 * 2**30
    assert bytes_needed((2048, 2048), False) < 2 * 2**30


def test_free_memory_is_that_of_the_container(monkeypatch, tmp_path):
    system, limit, taken = (tmp_path / name for name in ("meminfo", "max", "current"))
    monkeypatch.setattr(free_memory, "MEMINFO", system)
    monkeypatch.setattr(free_memory, "GROUP_LIMITS", ((limit, taken),))
    assert free_memory.free_memory() == free_memory.whole_memory()
    system.write_text("MemTotal:  100 kB\nMemAvailable:   7 kB\n")
    assert free_memory.free_memory() == 7 * 1024
    limit.write_text("max\n")
    taken.write_text("1000\n")
    assert free_memory.free_memory() == 7 * 1024
    limit.write_text("5000\n")
    assert free_memory.free_memory() == 4000


def test_a_system_that_does_not_report_its_memory_is_trusted(monkeypatch, tmp_path):
    monkeypatch.setattr(free_memory, "MEMINFO", tmp_path / "none")
    monkeypatch.setattr(free_memory, "GROUP_LIMITS", ())
    monkeypatch.delattr(free_memory.os, "sysconf", raising=False)
    assert math.isinf(free_memory.free_memory())
