"""Half-spaces graded in depth: the stated tolerance holds, exact responses and known limits are met."""

from __future__ import annotations

import math
from dataclasses import dataclass

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.materials.depth_grading import ExponentialGrading, SigmoidalGrading, TabulatedGrading
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.depth_recursion import mesh, states_with_depth, surface_compliance, surface_compliance_across

EXPONENTIAL = ExponentialGrading(1.0, 3.0, depth_scale=1.0, poisson=0.3)


@dataclass(frozen=True)
class Growing:
    """E = exp(rate z) down to a depth, constant below: the equations of elasticity have constant coefficients."""

    rate: float
    end: float
    poisson: float

    @property
    def breaks(self):
        return (self.end,)

    @property
    def finest(self):
        return 1.0 / abs(self.rate)

    def young_at(self, z):
        return np.exp(self.rate * np.minimum(z, self.end))

    def poisson_at(self, z):
        return np.full(np.shape(z), self.poisson)

    def settled_at(self, tolerance):
        return self.end


@dataclass(frozen=True)
class CutPowerLaw:
    """E = (z + least)^k down to `most`, constant below."""

    k: float
    least: float
    most: float
    poisson: float

    @property
    def breaks(self):
        return (self.most,)

    @property
    def finest(self):
        return self.least

    def young_at(self, z):
        return (np.minimum(z, self.most) + self.least) ** self.k

    def poisson_at(self, z):
        return np.full(np.shape(z), self.poisson)

    def settled_at(self, tolerance):
        return self.most


def _equations(xi, nu, rate):
    """d/dz of U, W, tau / (2 G(0) xi), sigma / (2 G(0) xi), both stresses over exp(rate z)."""
    n, m = nu / (1 - nu), (1 - 2 * nu) / (1 - nu)
    a = mpmath.matrix([[0, 1, 2, 0], [-n, 0, 0, m], [1 / (1 - nu), 0, 0, n], [0, 0, -1, 0]]) * xi
    a[2, 2] -= rate
    a[3, 3] -= rate
    return a


def growing(grading: Growing, xi: float) -> mpmath.matrix:
    """2 G(0) Y at the surface, by the exponential of a matrix at 60 digits."""
    with mpmath.workdps(60):
        nu, rate, xi = mpmath.mpf(grading.poisson), mpmath.mpf(grading.rate), mpmath.mpf(xi)
        below = mpmath.matrix([[1, 0], [0, 1]])
        half = mpmath.matrix([[-2 * (1 - nu), 1 - 2 * nu], [1 - 2 * nu, -2 * (1 - nu)]])
        start = mpmath.matrix(4, 2)
        start[0:2, :], start[2:4, :] = half, below
        end = mpmath.expm(-_equations(xi, nu, rate) * mpmath.mpf(grading.end)) * start
        return end[0:2, :] * end[2:4, :] ** -1


@pytest.mark.few(2)
@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.5])
@pytest.mark.parametrize("rate", [1.5, -2.3])
def test_an_exponential_with_a_bottom(rate, nu):
    """Against a matrix exponential at 60 digits: every entry, long and short waves."""
    grading = Growing(rate, 1.7, nu)
    xi = np.array([1e-3, 0.1, 0.7, 2.0, 6.0, 40.0, 300.0])
    twice = 1.0 / (1.0 + nu)
    found = twice * surface_compliance(mesh(grading, 1e-8, 1e-4), xi)
    for i, number in enumerate(xi):
        exact = growing(grading, number)
        expected = [float(exact[0, 0]), float(exact[0, 1]), float(exact[1, 1])]
        np.testing.assert_allclose(found[:, i], expected, rtol=2e-10, atol=2e-10 * abs(expected[2]))
        assert float(exact[1, 0]) == pytest.approx(expected[1], abs=1e-14)  # Betti


@pytest.mark.parametrize("rate", [1.5, -2.3])
def test_waves_across(rate):
    """(G u')' = xi^2 G u with G = G(0) exp(rate z): two exponentials, and one below; xi u / tau at the surface."""
    grading = Growing(rate, 1.7, 0.3)
    xi = np.array([1e-3, 0.7, 6.0, 300.0])
    found = surface_compliance_across(mesh(grading, 1e-8, 1e-4), xi)
    for number, solution in zip(xi, found, strict=True):
        with mpmath.workdps(60):
            b, w, end = mpmath.mpf(rate), mpmath.mpf(number), mpmath.mpf(1.7)
            root = mpmath.sqrt(b * b / 4 + w * w)
            up, down = -b / 2 + root, -b / 2 - root
            # at the bottom u' = -xi u
            part = -(down + w) / (up + w) * mpmath.exp((down - up) * end)
            exact = -w * (part + 1) / (part * up + down) * mpmath.mpf("2.6")
        assert solution == pytest.approx(float(exact), rel=1e-9)


@pytest.mark.slow
def test_the_tangential_modulus():
    """Narrow contacts feel the surface, wide ones the depth: G* = 4 G / (2 - nu)."""
    medium = DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-3)
    narrow, wide = medium.tangential_stiffness(np.array([1e-5, 1e4]))
    assert narrow == pytest.approx(4.0 / 2.6 / 1.7, rel=1e-3)
    assert wide == pytest.approx(3.0 * 4.0 / 2.6 / 1.7, rel=2e-3)


def test_states_at_depth():
    """Tractions and displacements at depth, against the same matrix exponential."""
    grading, depth, xi = Growing(1.5, 1.7, 0.3), 0.6, 2.3
    found = {
        rung.depth: [float(part[0]) for part in rung[1:]]
        for rung in states_with_depth(mesh(grading, 1e-8, 1e-3, (depth,)), np.array([xi]))
    }[depth]
    with mpmath.workdps(60):
        y = growing(grading, xi)
        top = mpmath.matrix([0, 0, 0, -1])
        top[0:2] = y * top[2:4]
        state = mpmath.expm(_equations(mpmath.mpf(xi), mpmath.mpf("0.3"), 1.5) * depth) * top
    twice, grown = 1.0 / 1.3, math.exp(1.5 * depth)
    expected = [float(state[0]) / twice, float(state[1]) / twice, float(state[2]) * grown, float(state[3]) * grown]
    np.testing.assert_allclose(found, expected, rtol=1e-9)


def compliance(grading, xi: float) -> float:
    """E(0) / (1 - nu^2) times xi C / 2: Riccati's equation for Y in z, which uses no cells."""
    from scipy.integrate import solve_ivp

    # waves have no effect below 20 / xi; in between breaks everything is smooth
    depth = min(20.0 / xi, grading.settled_at(1e-13))
    edges = [depth, *sorted((z for z in grading.breaks if z < depth), reverse=True), 0.0]

    def nu(z):
        return float(grading.poisson_at(np.array(z)))

    def shear(z):
        return float(grading.young_at(np.array(z))) / (2.0 * (1.0 + nu(z)))

    def riccati(z, y):
        v, g = nu(z), shear(z)
        n, m = v / (1 - v), (1 - 2 * v) / (1 - v)
        a, b = np.array([[0.0, 1.0], [-n, 0.0]]), np.diag([1.0 / g, m / (2.0 * g)])
        c, d = np.diag([2.0 * g / (1 - v), 0.0]), np.array([[0.0, n], [-1.0, 0.0]])
        y = y.reshape(2, 2)
        return xi * (a @ y + b - y @ c @ y - y @ d).ravel()

    v, g = nu(depth), shear(depth)
    y = (np.array([[-2 * (1 - v), 1 - 2 * v], [1 - 2 * v, -2 * (1 - v)]]) / (2 * g)).ravel()
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        step = min(abs(high - low), grading.finest)
        y = solve_ivp(riccati, (low, high), y, method="DOP853", rtol=1e-11, atol=1e-13, max_step=step).y[:, -1]
    return float(-y[3] * shear(0.0) / (1.0 - nu(0.0)))


TABLE = TabulatedGrading([0.0, 1.0, 2.0, 4.0], [1.0, 2.0, 4.0, 3.0], [0.2, 0.3, 0.3, 0.5])


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "grading",
    [
        EXPONENTIAL,
        pytest.param(ExponentialGrading(1.0, 100.0, depth_scale=1.0, poisson=0.3), marks=pytest.mark.slow),
        ExponentialGrading(30.0, 1.0, depth_scale=0.7, poisson=0.5),
        SigmoidalGrading(5.0, 1.0, transition_depth=2.0, transition_width=0.2, poisson=-0.2),
        TABLE,
    ],
    ids=lambda grading: type(grading).__name__,
)
def test_the_response_without_cells(grading):
    medium = DepthGradedHalfSpace(grading, tolerance=1e-6)
    for xi in (0.7, 6.0):
        found = 1.0 + medium.response.excess(np.array([xi]))[0]
        assert found == pytest.approx(compliance(grading, xi), rel=3e-7)


def test_complex_and_very_short_waves():
    """Beyond the waves of the recursion a series goes on; both are the same function of complex wave numbers."""
    response = DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-6).response
    limit = 100.0 / EXPONENTIAL.finest
    circle = 5.0 * limit + 4.5 * limit * np.exp(2j * np.pi * (np.arange(256) + 0.5) / 256)
    # Cauchy: the mean over the circle, part of it climbed, part of it summed, is the value in the middle
    mean = np.mean(response.excess(circle))
    assert mean == pytest.approx(response.excess(np.array([5.0 * limit]))[0], abs=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [3.0, pytest.param(1.0 / 3.0, marks=pytest.mark.slow)])
def test_the_tolerance_holds(ratio):
    """Coarse media against fine ones, whose cells and kernels have nothing in common."""
    a = np.array([1e-5, 0.7])
    grading = ExponentialGrading(1.0, ratio, depth_scale=1.0, poisson=0.3)
    fine = DepthGradedHalfSpace(grading, tolerance=1e-5).punch_stiffness(a)
    for tolerance in (1e-2, 1e-3):
        coarse = DepthGradedHalfSpace(grading, tolerance=tolerance).punch_stiffness(a)
        assert 1e-12 < np.max(np.abs(coarse / fine - 1.0)) < tolerance


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    "grading", [TABLE, ExponentialGrading(1.0, 100.0, 1.0, 0.5), ExponentialGrading(100.0, 1.0, 1.0, 0.3)]
)
def test_the_default_tolerance_holds(grading):
    """E ratios up to 100, rising and falling, and a table that ends incompressible."""
    a = np.array([0.05, 0.7])
    found, finer = (DepthGradedHalfSpace(grading, tolerance=t).punch_stiffness(a) for t in (1e-6, 1e-7))
    np.testing.assert_allclose(found, finer, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("grading", "a", "allowed"), [(EXPONENTIAL, 0.8, 1e-8), (ExponentialGrading(1.0, 1e3, 1.0, 0.3), 0.05, 1e-6)]
)
def test_a_flat_punch_by_ritz(grading, a, allowed):
    """k(a) from above: the energy of any displacement outside is too large; here by Legendre polynomials, n = 24.

    With the logarithm of a body that stiffens a thousandfold they converge slowly: to the tolerance of the medium.
    """
    from scipy.special import spherical_jn

    medium, count = DepthGradedHalfSpace(grading), 24
    # (I + K) phi = 1 in the weak sense: phi = sum of c_n P_2n(x / a), whose cosine transform is a Bessel function
    nodes, weights = np.polynomial.legendre.leggauss(24)
    edges = np.concatenate([[0.0], np.geomspace(1e-3, 4.0, 14), np.arange(8.0, 8000.0, 4.0)]) / a
    width = np.diff(edges)[:, None]
    xi, w = (edges[:-1, None] + 0.5 * width * (nodes + 1.0)).ravel(), (0.5 * width * weights).ravel()
    m = medium.response.excess(xi)
    waves = np.array([(-1) ** n * spherical_jn(2 * n, xi * a) for n in range(count)])
    matrix = np.diag(1.0 / (4.0 * np.arange(count) + 1.0)) + a * (2.0 / np.pi) * (waves * (w * m)) @ waves.T
    c = np.linalg.solve(matrix, np.eye(count)[0])
    assert float(medium.punch_stiffness(np.array(a))) == pytest.approx(2.0 * medium.modulus * a * c[0], rel=allowed)


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("ratio", [1e3, 1e4, 1e6])
def test_a_thousand_to_a_million_times_stiffer_below(ratio):
    """Wide punches were not resolved on bodies that stiffen a thousandfold.

    A wide punch rests on what lies far below, under a soft skin whose columns are squeezed: by the energy of the
    pressure of a flat punch, F^2 ln(a) / (4 pi a^2) times the integral of 1/M(z) - 1/M, which for this grading is
    ln(E / E(0)) / M.  That the skin is stretched besides, a few per cent of it, is left out.
    """
    nu = 0.3
    medium = DepthGradedHalfSpace(ExponentialGrading(1.0, ratio, depth_scale=1.0, poisson=nu))
    a = np.array([1e-9 / ratio, 2000.0, 4000.0, 8000.0])
    share = medium.punch_stiffness(a) / (2.0 * medium.modulus * a)
    assert share[0] == pytest.approx(1.0, abs=1e-6)
    first, second = np.diff(a[1:] * (ratio / share[1:] - 1.0)) / math.log(2.0)
    assert first == pytest.approx(second, rel=0.05)
    wanted = (1.0 - 2.0 * nu) / (1.0 - nu) ** 2 * math.log(ratio) / (2.0 * math.pi)
    assert second == pytest.approx(wanted, rel=0.05)


def test_tables_are_kept_by_ratios():
    """Another modulus and another length: the same numbers in their units, from the tables that stand."""
    from winkler.numerics.transforms import punch_tables

    def stiffness(unit, length, kind):
        gradings = {
            "exponential": ExponentialGrading(1.3 * unit, 4.1 * unit, 0.7 * length, 0.3),
            "sigmoidal": SigmoidalGrading(1.3 * unit, 4.1 * unit, 1.1 * length, 0.7 * length, 0.3),
            "tabulated": TabulatedGrading(np.array([0.0, 0.7, 1.9]) * length, np.array([1.0, 3.0, 2.0]) * unit,
                                          [0.2, 0.3, 0.4]),
        }  # fmt: skip
        medium = DepthGradedHalfSpace(gradings[kind], wk.Elastic(5.0 * unit, 0.2), tolerance=1e-3)
        return float(medium.punch_stiffness(np.array(0.9 * length))) / (unit * length)

    for kind in ("exponential", "sigmoidal", "tabulated"):
        first = stiffness(1.0, 1.0, kind)
        solved = punch_tables._tables.cache_info().misses
        assert stiffness(2.1e11, 3.7e-4, kind) == pytest.approx(first, rel=1e-12)
        assert punch_tables._tables.cache_info().misses == solved


@pytest.mark.slow
def test_a_power_law_that_is_cut_off():
    """Between its ends a power law presses back as the closed form predicts."""
    k, nu = 0.3, 0.3
    exact = GradedHalfSpace.between(PowerLawGraded(1.0, 1.0, k, nu))
    miss = []
    for least in (1e-3, 1e-4):
        medium = DepthGradedHalfSpace(CutPowerLaw(k, least, 1e4, nu), tolerance=1e-4)
        stiffness = float(medium.punch_stiffness(np.array([1.0]))[0])
        miss.append(stiffness / (2.0 * exact.modulus / (1.0 + k)) - 1.0)
    # the skin softer than E(least) is missing: the surface sinks less by a part (least / a)^(1 - k)
    fall = 0.1 ** (1.0 - k)
    assert miss[1] == pytest.approx(fall * miss[0], rel=0.1)
    assert (miss[1] - fall * miss[0]) / (1.0 - fall) == pytest.approx(0.0, abs=3e-4)


@pytest.mark.slow
def test_narrow_and_wide_contacts():
    medium = DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-3)
    narrow, wide = medium.punch_stiffness(np.array([1e-5, 1e3])) / np.array([1e-5, 1e3])
    assert narrow == pytest.approx(2.0 * 1.0 / 0.91, rel=1e-3)
    assert wide == pytest.approx(2.0 * 3.0 / 0.91, rel=2e-3)


@pytest.mark.slow
def test_a_sharp_step_is_a_coating():
    coating = CoatedHalfSpace([Layer(wk.Elastic(4.0, 0.3), 1.0)], on=wk.Elastic(1.0, 0.3))
    a = np.array([0.5, 2.0])
    wide, narrow = (
        DepthGradedHalfSpace(SigmoidalGrading(4.0, 1.0, 1.0, width, 0.3), tolerance=1e-4).punch_stiffness(a)
        for width in (0.02, 0.01)
    )
    # what the width of the step does is of first order in it
    np.testing.assert_allclose(2.0 * narrow - wide, coating.punch_stiffness(a), rtol=5e-5)


def test_a_constant_grading_is_a_half_space():
    medium = DepthGradedHalfSpace(ExponentialGrading(2.0, 2.0, 1.0, 0.3))
    assert float(medium.punch_stiffness(np.array(0.7))) == pytest.approx(2.0 * 2.0 / 0.91 * 0.7, rel=1e-10)


@pytest.mark.slow
def test_indentation_and_fields():
    bed = wk.Foundation(wk.Paraboloid(1.0), DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-3))
    contact = wk.Indentation(bed, wk.Radius(0.5)).solve()
    surface = wk.restore(contact, [0.0, 0.3])
    np.testing.assert_allclose(surface.displacement, contact.depth - np.array([0.0, 0.045]), rtol=1e-6)
    assert contact.force > 4.0 / 3.0 / 0.91 * 0.5**3  # stiffer than what it is at the surface
    assert "divided into thin cells" in str(contact.validity[0])


@pytest.mark.slow
def test_a_curve_is_its_own_derivative():
    bed = wk.Foundation(wk.Paraboloid(1.0), DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-4))
    step = 1e-3
    contact = wk.Indentation(bed, wk.Depth(0.3 + step * np.arange(-2, 3))).solve()
    slope = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) @ contact.force / (12.0 * step)
    assert slope == pytest.approx(contact.stiffness[2], rel=1e-7)


@pytest.mark.slow
def test_fields_inside():
    """At the surface they are those of the surface, deep down the pressure carries the force."""
    bed = wk.Foundation(wk.Paraboloid(1.0), DepthGradedHalfSpace(EXPONENTIAL, tolerance=1e-3))
    contact = wk.Indentation(bed, wk.Radius(0.5)).solve()
    r = np.array([0.0, 0.2, 0.45, 0.8])
    surface, inside = wk.restore(contact, r), wk.restore(contact, r, np.zeros(4))
    np.testing.assert_allclose(-inside.axial_stress, surface.pressure, atol=1e-5 * surface.pressure[0])
    np.testing.assert_allclose(inside.axial_displacement, surface.displacement, rtol=1e-6)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    top = np.arcsinh(15.0)
    r, share = np.sinh(0.5 * top * (nodes + 1.0)), 0.5 * top * weights * np.cosh(0.5 * top * (nodes + 1.0))
    deep = wk.restore(contact, r, np.full(r.shape, 0.3))
    # beyond r = 15 lies a part (z / r)^3 of the force
    assert float(-share @ (2.0 * np.pi * r * deep.axial_stress)) == pytest.approx(contact.force, rel=1e-5)


@pytest.mark.slow
def test_fields_inside_are_those_of_many_layers():
    """A linear rise of E in 60 exact layers against the same rise as a table; stresses between and on both sides."""
    depths = np.linspace(0.0, 1.0, 61)
    middles = 0.5 * (depths[1:] + depths[:-1])
    layers = [Layer(wk.Elastic(float(1.0 + z), 0.3), 1.0 / 60.0) for z in middles]
    cut = CoatedHalfSpace(layers, on=wk.Elastic(2.0, 0.3))
    graded = DepthGradedHalfSpace(TabulatedGrading([0.0, 1.0], [1.0, 2.0], [0.3, 0.3]), tolerance=1e-4)
    r, z = np.array([0.0, 0.3, 0.6, 0.0, 0.3]), np.array([1.0, 1.0, 1.0, 2.0, 2.0]) * (0.5 + 0.5 / 60.0)
    fields = []
    for medium in (cut, graded):
        contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), wk.Radius(0.4)).solve()
        fields.append(wk.restore(contact, r, z))
    for part in ("axial_stress", "radial_stress", "hoop_stress", "shear_stress", "axial_displacement"):
        one, other = (getattr(field, part) for field in fields)
        np.testing.assert_allclose(one, other, atol=2e-3 * np.max(np.abs(other)))


def test_bad_input():
    with pytest.raises(wk.InvalidInput, match="surface_young is -1"):
        ExponentialGrading(-1.0, 1.0, 1.0, 0.3)
    with pytest.raises(wk.InvalidInput, match="poisson is 0.6"):
        SigmoidalGrading(1.0, 2.0, 1.0, 1.0, 0.6)
    with pytest.raises(wk.InvalidInput, match="one length"):
        TabulatedGrading([0.0, 1.0], [1.0, 2.0, 3.0], [0.3, 0.3])
    with pytest.raises(wk.InvalidInput, match="depths does not rise from index 1"):
        TabulatedGrading([0.0, 2.0, 1.0], [1.0, 2.0, 3.0], [0.3, 0.3, 0.3])
    with pytest.raises(wk.InvalidInput, match="youngs is 0.0 at index 1; give a row of at least 2 positive"):
        TabulatedGrading([0.0, 1.0], [1.0, 0.0], [0.3, 0.3])
    with pytest.raises(wk.InvalidInput, match="poissons"):
        TabulatedGrading([0.0, 1.0], [1.0, 1.0], [0.3, 0.7])
    with pytest.raises(wk.InvalidInput, match="depths is .*; give a row of at least 2 finite numbers"):
        TabulatedGrading(["surface", 1.0], [1.0, 1.0], [0.3, 0.3])
    with pytest.raises(wk.InvalidInput, match="grading is a Elastic"):
        DepthGradedHalfSpace(wk.Elastic(1.0, 0.3))
    with pytest.raises(wk.InvalidInput, match="tolerance is 0.5"):
        DepthGradedHalfSpace(EXPONENTIAL, tolerance=0.5)
    with pytest.raises(wk.InvalidInput, match="second is a str"):
        DepthGradedHalfSpace(EXPONENTIAL, second="steel")


@pytest.mark.slow
def test_a_table_of_4001_points_is_answered():
    """Points on one straight line state the body of its two ends."""

    def compliance(count):
        z, young = np.linspace(0.0, 1.0, count), np.linspace(4.0, 1.0, count)
        cells = mesh(TabulatedGrading(z, young, np.linspace(0.2, 0.35, count)), 1e-6, 0.1)
        return surface_compliance(cells, np.array([0.1, 1.0, 10.0]))

    assert compliance(4001) == pytest.approx(compliance(2), rel=2e-6)
