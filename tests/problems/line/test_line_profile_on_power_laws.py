"""Sections on bodies graded by a power of the depth: the closed form of one strip, and a dense solution of two."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.surfaces.strip_elements import element_compliance, power_compliance, power_elements

LOAD = wk.LineForce(200e3)


def graded(exponent):
    return wk.GradedHalfSpace(wk.PowerLawGraded(200e9, 1e-3, exponent, 0.3))


@pytest.mark.few(2)
@pytest.mark.parametrize("exponent", [-0.3, 0.01, 0.2, 0.5, 0.9])
def test_one_roller_as_in_closed_form(exponent):
    """`LineIndentation` on flat punches of all half-widths, with no elements (Giannakopoulos, Pallot)."""
    medium = graded(exponent)
    found = wk.LineProfileContact(wk.CylinderRow([10e-3], [0.0], [0.0]), medium, LOAD).solve()
    exact = wk.LineIndentation(wk.PowerLawLineFoundation(wk.Paraboloid(10e-3), medium), LOAD).solve()
    a = exact.half_width
    assert not found.refined
    assert found.contact_length == pytest.approx(2.0 * a, rel=found.strip_error)
    assert found.strip_error < 0.003
    assert found.peak_pressure == pytest.approx(exact.peak_pressure, rel=2e-6)
    x = np.linspace(-0.95, 0.95, 20) * a
    assert found.pressure(x) == pytest.approx(exact.pressure(x), abs=3e-3 * exact.peak_pressure)
    beside = np.array([1.1, 1.5, 2.0, 5.0, 40.0]) * a
    assert found.separation(beside) == pytest.approx(exact.separation(beside), rel=1e-4)
    assert found.separation(-beside) == pytest.approx(exact.separation(beside), rel=1e-4)


@pytest.mark.few(1)
@pytest.mark.parametrize("exponent", [0.3, 0.7])
def test_two_rollers_as_by_a_dense_matrix(exponent):
    """Point loads cos(pi k/2) c^k/(pi E* r^(1+k)) integrated along y and over elements, and every set tried in turn."""
    medium, drop, apart, radius = graded(exponent), 1e-6, 0.2e-3, 10e-3
    found = wk.LineProfileContact(
        wk.CylinderRow([radius, radius], [-apart, apart], [0.0, drop]), medium, LOAD, elements=4096
    ).solve()
    k, count = exponent, 600
    along = math.sqrt(math.pi) * math.gamma(0.5 * k) / math.gamma(0.5 * (1.0 + k))
    strength = math.cos(0.5 * math.pi * k) * 1e-3**k / (math.pi * medium.modulus) * along
    edges = np.linspace(-3.0 * apart, 3.0 * apart, count + 1)
    x, width = 0.5 * (edges[1:] + edges[:-1]), edges[1] - edges[0]
    away = x[:, None] - edges
    matrix = strength * -np.diff(np.sign(away) * np.abs(away) ** (1.0 - k), axis=1) / (1.0 - k)
    f = np.minimum((x + apart) ** 2, (x - apart) ** 2 + 2.0 * radius * drop) / (2.0 * radius)
    active = np.ones(count, dtype=bool)
    for _ in range(60):
        n = int(active.sum())
        whole = np.block(
            [[matrix[np.ix_(active, active)], -np.ones((n, 1))], [width * np.ones((1, n)), np.zeros((1, 1))]]
        )
        solved = np.linalg.solve(whole, np.append(-f[active], LOAD.force_per_length))
        p = np.zeros(count)
        p[active] = solved[:-1]
        overlaps = ~active & (f + matrix @ p - solved[-1] < 0.0)
        if not (overlaps.any() or np.any(p < 0.0)):
            break
        active = (active & (p >= 0.0)) | overlaps
    else:
        pytest.fail("no set was found")
    left = x < 0.5 * radius * drop / apart  # of the valley
    forces = width * np.array([np.sum(p[left]), np.sum(p[~left])])
    assert found.strip_count == 2.0
    assert found.strip_forces == pytest.approx(forces, rel=2e-4)
    assert found.strip_peaks == pytest.approx([np.max(p[left]), np.max(p[~left])], rel=1e-4)
    assert found.contact_length == pytest.approx(width * np.count_nonzero(p), abs=4.0 * width)


def test_a_force_between_equal_rollers_tilts_nothing_and_turns_towards_one():
    section = wk.CylinderRow([10e-3, 10e-3], [-0.3e-3, 0.3e-3], [0.0, 0.0])
    middle, beside = (
        wk.LineProfileContact(section, graded(0.4), LOAD, wk.LineOfAction(place)).solve() for place in (0.0, 0.1e-3)
    )
    assert middle.tilt == pytest.approx(0.0, abs=1e-9)
    assert beside.strip_forces[1] > 1.5 * beside.strip_forces[0]
    assert beside.line_of_action == pytest.approx(0.1e-3, rel=1e-9)


def test_power_zero_is_a_half_plane():
    edges = np.linspace(0.0, 4.0, 9)
    assert power_elements(PowerLawSurface(0.0, 2.0), 8, 0.5, 1.0) == pytest.approx(
        0.5 * element_compliance(edges)[:, 0], rel=1e-13
    )
    x = np.array([0.3, 7.0])
    assert power_compliance(PowerLawSurface(0.0, 2.0), x) == pytest.approx(-np.log(x) / np.pi, rel=1e-13)


def test_gradings_far_beside_the_elements():
    """An all but homogeneous grading against refined strips of a half-plane, beyond the last elements."""
    section = wk.CylinderRow([10e-3, 10e-3], [-0.25e-3, 0.25e-3], [0.0, 2e-6])
    solid, grading = wk.Elastic(210e9, 0.3), wk.ExponentialGrading(210e9, 210.0001e9, 1e-3, 0.3)
    graded_body, plain = (
        wk.LineProfileContact(section, medium, LOAD).solve()
        for medium in (wk.DepthGradedHalfSpace(grading), wk.HalfSpace(solid))
    )
    x = np.array([-5e-3, -1e-3, -6e-4, 0.0, 6e-4, 1e-3, 3e-3])
    assert graded_body.separation(x) == pytest.approx(plain.separation(x), rel=1e-6)


def test_what_is_not_known_is_refused():
    found = wk.LineProfileContact(wk.CylinderRow([10e-3], [0.0], [0.0]), graded(0.5), LOAD).solve()
    with pytest.raises(wk.OutsideValidity, match="stresses inside a GradedHalfSpace are not implemented"):
        found.stresses(0.0, 1e-4)
    gibson = wk.GradedHalfSpace(wk.PowerLawGraded(200e9, 1e-3, 1.0, 0.5))
    with pytest.raises(wk.OutsideValidity, match="exponent below 1"):
        wk.LineProfileContact(wk.CylinderRow([10e-3], [0.0], [0.0]), gibson, LOAD).solve()
