"""The height maps compute with arrays of any library of the array API, and end where numpy ends."""

from __future__ import annotations

import builtins
import math

import numpy as np
import pytest

from winkler.loading.loads import Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.arrays import cast, dot, given, library_of, namespace_of, to_numpy
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.surfaces.punched_grid import punch
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

COUNT = 72
X = np.arange(COUNT) / COUNT
WAVY = (
    0.1 * np.random.default_rng(1).random((COUNT, COUNT)) - np.cos(2.0 * np.pi * X)[:, None] - np.cos(2.0 * np.pi * X)
)
HEIGHTS = WAVY - WAVY.min()
PIXEL = (1.0 / COUNT, 1.0 / COUNT)


@pytest.fixture(params=["foreign", "strict"])
def library(request):
    """Return a library: arrays that refuse numpy, and the strict reference of the standard where it is installed."""
    pytest.importorskip("array_api_compat")
    if request.param == "strict":
        return pytest.importorskip("array_api_strict")
    from foreign_arrays import FOREIGN

    return FOREIGN


def test_numpy_is_itself():
    one = np.arange(3.0)
    assert namespace_of(one) is np
    assert library_of(np) is np
    assert to_numpy(one) is one
    assert cast(one, np.dtype(np.float64)) is one
    assert dot(one, one) == 5.0
    assert given(one)
    assert not given(())
    assert not given(np.empty(0))


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize(
    ("drive", "ceiling"), [(ByDepth(0.3), math.inf), (ByLoad(300.0), math.inf), (ByLoad(300.0), 2.0)]
)
def test_what_another_library_computes_is_certified_here(library, periodic, drive, ceiling):
    """By transforms of numpy on a grid of the test's own."""
    found = press(library.asarray(HEIGHTS), PIXEL, drive, periodic=periodic, ceiling=ceiling, tolerance=1e-8)
    assert not isinstance(found.pressure, np.ndarray)
    p, depth = to_numpy(found.pressure), found.depth
    gap = displaced(p, periodic) + HEIGHTS - depth
    soft = p < ceiling * (1.0 - 1e-12)
    assert p.min() >= 0.0
    assert np.min(gap, where=soft, initial=0.0) >= -1.1e-8 * depth
    assert np.sum(p * np.where(soft, np.abs(gap), np.maximum(gap, 0.0))) <= 1.1e-8 * np.sum(p) * depth
    if isinstance(drive, ByLoad):
        assert np.sum(p) == pytest.approx(drive.load, rel=1e-10)
    touching = p > 0.0
    stiffness = float(np.sum(to_numpy(punch(library.asarray(touching), PIXEL, periodic=periodic))))
    assert stiffness == pytest.approx(float(np.sum(punch(touching, PIXEL, periodic=periodic))), rel=1e-6)


def displaced(p, periodic):
    """Return displacements over E*: 2 / |q| in waves, or Love's integral from corner to corner."""
    n, side = COUNT, 1.0 / COUNT
    if periodic:
        q = 2.0 * np.pi * np.hypot(np.fft.fftfreq(n, side)[:, None], np.fft.rfftfreq(n, side))
        q[0, 0] = np.inf
        return np.fft.irfft2(np.fft.rfft2(p) * 2.0 / q, s=p.shape)
    apart = np.concatenate((np.arange(n), np.arange(-n, 0))) * side

    def corner(a, b):
        x, y = apart[:, None] + a * side, apart[None, :] + b * side
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    love = (corner(0.5, 0.5) - corner(-0.5, 0.5) - corner(0.5, -0.5) + corner(-0.5, -0.5)) / np.pi
    waves = np.fft.rfft2(love) * np.fft.rfft2(p, s=(2 * n, 2 * n))
    return np.fft.irfft2(waves, s=(2 * n, 2 * n))[:n, :n]


def test_a_march_through_loads_in_another_library(library):
    rough = Topography(-HEIGHTS * 1e-6, [1e-3, 1e-3], True)
    problem = SurfaceContact(rough, HalfSpace(Elastic(1e9, 0.3)), Force([0.1, 0.11, 0.3]))
    here, there = problem.solve(), problem.solve(arrays=library)
    for name in ("depth", "force", "stiffness", "area", "mean_gap"):
        np.testing.assert_allclose(getattr(there, name), getattr(here, name), rtol=1e-5, err_msg=name)
    assert isinstance(there.last.pressure, np.ndarray)
    np.testing.assert_allclose(there.last.pressure, here.last.pressure, atol=1e-4 * here.last.pressure.max())


def test_without_array_api_compat_one_sentence_says_what_to_install(monkeypatch):
    original = builtins.__import__

    def refusing(name, *more, **named):
        if name == "array_api_compat":
            raise ImportError(name)
        return original(name, *more, **named)

    monkeypatch.setattr(builtins, "__import__", refusing)
    from foreign_arrays import FOREIGN

    with pytest.raises(InvalidInput, match=r"need array-api-compat: pip install"):
        namespace_of(FOREIGN.asarray([1.0]))
