"""Fields of viscoelastic contacts: elastic limits, two bodies, flat punches, and what is not known."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fields.peaks import peak_stress
from winkler.fields.restoration import restore, restore_body
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import Maxwell, StandardSolid
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import OutsideValidity

SOFT = StandardSolid(1.0, 4.0, 0.3, poisson=0.3)
STEEL = wk.Elastic(10.0, 0.2)
R = np.array([0.0, 0.04, 0.09, 0.1, 0.15])
Z = np.array([0.001, 0.03, 0.05, 0.1, 0.02])
FIELDS = ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "radial_displacement", "axial_displacement")


def last(medium, time, depth, shape=None, count=500):
    bed = wk.Foundation(wk.Paraboloid(1.0) if shape is None else shape, medium)
    *_, state = ViscoelasticIndentation(bed, Path(time, Depth(depth)), count=count).steps()
    return state


@pytest.mark.parametrize(("duration", "shear"), [(1e7, 1.0), (1e-7, 5.0)], ids=["slow", "fast"])
@pytest.mark.parametrize("second", [wk.Rigid(), STEEL], ids=["rigid", "elastic"])
def test_slow_and_fast_are_hertz(duration, shear, second):
    """On the surface and in both bodies."""
    state = last(ViscoelasticHalfSpace(SOFT, second), [0.0, duration], [0.0, 0.01], count=200)
    hertz = wk.Indentation(
        wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(2.6 * shear, 0.3), second)), Depth(0.01)
    ).solve()
    surface, exact = restore(state, R), restore(hertz, R)
    scale = exact.pressure[0]
    assert surface.pressure == pytest.approx(exact.pressure, abs=1e-4 * scale)
    assert surface.displacement == pytest.approx(exact.displacement, rel=1e-6)
    assert surface.gap == pytest.approx(exact.gap, abs=1e-8)
    for side in (1.0,) if isinstance(second, wk.Rigid) else (1.0, -1.0):
        inside, below = restore(state, R, side * Z), restore(hertz, R, side * Z)
        for word in FIELDS:
            size = np.max(np.abs(getattr(below, word)))
            assert getattr(inside, word) == pytest.approx(getattr(below, word), abs=1e-4 * size), word


def test_the_peak_is_that_of_hertz():
    state = last(ViscoelasticHalfSpace(SOFT), [0.0, 1e7], [0.0, 0.01], count=60)
    hertz = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(2.6, 0.3))), Depth(0.01)).solve()
    peak, place = peak_stress(state), peak_stress(hertz)
    assert peak.von_mises == pytest.approx(place.von_mises, rel=1e-4)
    assert peak.z == pytest.approx(place.z, rel=1e-3)


def test_both_functions_that_restore_the_body():
    state = last(ViscoelasticHalfSpace(SOFT), [0.0, 0.3, 0.4], [0.0, 0.01, 0.008], count=100)
    r, z = np.array([0.03, 0.08]), np.array([0.02, 0.05])
    inside, body = restore(state, r, z), restore_body(state, r, 0.0, z)
    assert body.zz_stress == pytest.approx(inside.axial_stress, rel=1e-9)


def test_pressures_add_up_to_the_force():
    """And the stress deep below carries it: a path with unloading, under a cone."""
    state = last(ViscoelasticHalfSpace(SOFT), [0.0, 0.3, 0.4], [0.0, 0.01, 0.0085], wk.Cone(1.2))
    nodes, weights = np.polynomial.legendre.leggauss(60)
    angle = 0.25 * np.pi * (nodes + 1.0)
    r = state.radius * np.sin(angle)
    total = 0.25 * np.pi * weights @ (2.0 * np.pi * r * restore(state, r).pressure * state.radius * np.cos(angle))
    assert total == pytest.approx(state.force, rel=1e-5)
    depth = 100.0 * state.radius
    deep = restore(state, 0.0, depth)
    assert float(deep.axial_stress) == pytest.approx(-1.5 * state.force / (np.pi * depth**2), rel=1e-3)


def test_two_alike_share_the_displacement():
    """Two bodies that creep in proportion: each moves by its part; the surfaces meet."""
    harder = StandardSolid(3.0, 12.0, 0.3, poisson=0.3)
    state = last(ViscoelasticHalfSpace(SOFT, harder), [0.0, 0.3, 0.4], [0.0, 0.01, 0.008], count=200)
    tiny = 1e-9
    first = float(restore(state, 0.03, tiny).axial_displacement)
    second = float(restore(state, 0.03, -tiny).axial_displacement)
    assert first == pytest.approx(3.0 * second, rel=1e-5)
    assert first + second == pytest.approx(float(restore(state, 0.03).displacement), rel=1e-6)


def test_an_elastic_partner_moves_with_the_load_only():
    """After the touch it is where it was; the other still recovers."""
    state = last(ViscoelasticHalfSpace(SOFT, STEEL), [0.0, 1.0, 1.05], [0.0, 0.01, -0.01], count=200)
    assert state.radius == 0.0
    first, second = restore(state, 0.0, 1e-9), restore(state, 0.0, -1e-9)
    assert float(second.axial_displacement) == 0.0
    assert float(first.axial_displacement) == pytest.approx(float(restore(state, 0.0).displacement), rel=1e-6)
    assert float(first.axial_stress) == 0.0


def test_a_flat_punch():
    """Singular at its rim, with the relaxed load."""
    state = last(ViscoelasticHalfSpace(Maxwell(0.25, 0.4)), [0.0, 0.0, 0.4], [0.0, 0.01, 0.01], wk.FlatPunch(0.1), 2)
    places = np.array([0.0, 0.05])
    exact = np.exp(-1.0) * 0.01 / (np.pi * np.sqrt(0.01 - places**2))
    assert restore(state, places).pressure == pytest.approx(exact, rel=1e-9)
    assert state.pressure(places) == pytest.approx(exact, rel=1e-9)
    outside = restore(state, 0.2)
    assert float(outside.displacement) == pytest.approx(2.0 / np.pi * 0.01 * np.arcsin(0.5), rel=1e-9)
    assert np.isinf(peak_stress(state).von_mises)


def test_nothing_is_nothing():
    state = last(ViscoelasticHalfSpace(SOFT), [0.0, 0.1, 0.2, 1.0], [-0.1, -0.05, -0.02, 0.01], count=20)
    problem = ViscoelasticIndentation(state.bed, Path([0.0, 0.1, 1.0], Depth([-0.1, -0.05, 0.01])), count=20)
    first = next(iter(problem.steps()))
    fields = restore(first, R)
    assert np.all(fields.pressure == 0.0)
    assert np.all(fields.displacement == 0.0)
    assert fields.gap == pytest.approx(0.1 + 0.5 * R**2)


@pytest.mark.parametrize(
    ("second", "z", "message"),
    [(wk.Rigid(), -0.1, "rigid"), (StandardSolid(1.0, 1.0, 0.1), 0.1, "different relaxation functions")],
)
def test_what_is_not_known(second, z, message):
    state = last(ViscoelasticHalfSpace(SOFT, second), [0.0, 1.0], [0.0, 0.01], count=20)
    with pytest.raises(OutsideValidity, match=message):
        restore(state, 0.0, z)
