"""Memory of height maps is said before it is taken, and compared with what is free."""

from __future__ import annotations

import logging
import math

import numpy as np
import pytest

from winkler.loading.loads import Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.surfaces import pressed_box
from winkler.numerics.surfaces.surface_grid import bytes_needed
from winkler.problems.rough import map_memory
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.topography import Topography
from winkler.values.checks import free_memory
from winkler.values.errors import InvalidInput

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


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("periodic", [True, False])
def test_a_million_pixels_are_solved_to_what_is_stated(periodic):
    """Checked in double digits by transforms of the test's own; the solver's steps are in single ones."""
    n, side, tolerance = 1024, 1e-3, 1e-6
    waves = np.random.default_rng(3).normal(size=(n, n // 2 + 1)) + 0.0j
    q = 2.0 * np.pi * np.hypot(np.fft.fftfreq(n, side / n)[:, None], np.fft.rfftfreq(n, side / n))
    q[0, 0] = math.inf
    heights = np.fft.irfft2(waves * np.where((q > 2e4) & (q < 8e5), q**-1.8, 0.0))
    rough = Topography(heights * 1e-6 / heights.std(), [side, side], periodic)
    medium = HalfSpace(Elastic(1e9, 0.3))
    contact = SurfaceContact(rough, medium, Force(2.0), tolerance=tolerance).solve()
    p = contact.last.pressure
    if periodic:
        moved = np.fft.irfft2(np.fft.rfft2(p) * 2.0 / q, s=p.shape)
    else:
        apart = np.concatenate((np.arange(n), np.arange(-n, 0))) * side / n

        def corner(a, b):
            x, y = apart[:, None] + a * side / n, apart[None, :] + b * side / n
            return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

        love = (corner(0.5, 0.5) - corner(-0.5, 0.5) - corner(0.5, -0.5) + corner(-0.5, -0.5)) / np.pi
        moved = np.fft.irfft2(np.fft.rfft2(love) * np.fft.rfft2(p, s=(2 * n, 2 * n)))[:n, :n]
    gap = moved / medium.modulus + rough.gaps - contact.depth
    assert p.min() == 0.0
    assert np.sum(p) * (side / n) ** 2 == pytest.approx(2.0, rel=1e-12)
    assert -gap.min() == pytest.approx(contact.penetration * contact.depth, rel=1e-3)
    assert -gap.min() <= tolerance * contact.depth
    assert np.sum(p * np.abs(gap)) <= tolerance * np.sum(p) * contact.depth
    np.testing.assert_allclose(contact.last.separation, np.maximum(gap, 0.0), atol=1e-9 * contact.depth)
