"""Tractions of height maps where the modulus follows a power of the depth: waves, discs, a ball in a loop, rolling."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import winkler as wk
from winkler.numerics.pixels.power_law import straightened
from winkler.numerics.surfaces.punched_grid import stuck_stiffness
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.problems.rough.compliance import compliance_of


def law(k, nu=0.3, depth=1.0):
    return wk.GradedHalfSpace(wk.PowerLawGraded(2.0 * (1.0 + nu), depth, k, nu))


def waves(k, nu):
    """Return what unit tractions of a wave number of one displace G = z^k: along the wave, and across it."""

    def rises(s, state):
        z = math.exp(s)
        m = z**k
        rest = 2.0 * m * nu / (1.0 - 2.0 * nu)
        u, w, t, n, v, tau = state
        stretch = (n + rest * u) / (rest + 2.0 * m)
        along = (rest + 2.0 * m) * u - rest * stretch
        return z * np.array([t / m - w, stretch, along, t, tau / m, m * v])

    deep = 14.0
    m = deep**k
    rest = 2.0 * m * nu / (1.0 - 2.0 * nu)
    fading = []  # with e^-z: u = 1, w = 1, without change of volume, and u = z, w = z + 3 - 4 nu
    for u, w, du, dw in ((1.0, 1.0, -1.0, -1.0), (deep, deep + 3.0 - 4.0 * nu, 1.0 - deep, 4.0 * nu - 2.0 - deep)):
        fading.append([u, w, m * (du + w), (rest + 2.0 * m) * dw - rest * u])
    found = []
    for one in fading:
        start = [*one, 1.0, -m]
        found.append(
            solve_ivp(rises, (math.log(deep), math.log(1e-9)), start, method="DOP853", rtol=1e-11, atol=1e-30).y[:, -1]
        )
    states = np.array(found).T
    return -(states[:2] @ np.linalg.inv(states[2:4]))[0, 0], -states[4, 0] / states[5, 0]


@pytest.mark.parametrize(("k", "nu"), [(0.3, 0.3), (-0.3, 0.2), (0.5, 0.45)])
def test_waves_move_the_surface_as_the_equations_of_equilibrium_say(k, nu):
    medium = law(k, nu)
    compliance = compliance_of(medium)
    normal = 2.0 / medium.modulus * compliance.power.whole(np.ones(1))[0]
    along, across = waves(k, nu)
    # at 1e-9 of the length of the wave the surface is not yet reached: what is left is z^(1 - k)
    assert normal * compliance.even == pytest.approx(along, rel=1e-4)
    assert normal * (compliance.even + compliance.along) == pytest.approx(across, rel=1e-4)


@pytest.mark.parametrize("k", [0.7, -0.5, 1e-9])
def test_the_integral_over_a_pixel(k):
    for x, y in ((0.5, 0.5), (-0.5, 200.5), (3.5, -1.5), (200.5, 0.5)):
        power, rule = -0.5 * (1.0 + k), {"epsabs": 0.0, "epsrel": 1e-11, "limit": 400}
        want = quad(lambda t, x=x, power=power: x * (x * x + t * t) ** power, 0.0, y, **rule)[0]
        assert straightened(np.array(x), np.array(y), k) == pytest.approx(want, rel=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("k", [0.4, -0.4])
def test_a_disc_is_pushed_and_twisted_as_in_closed_form(k):
    """Its edge is half a pixel wrong: the error is of first order, and is taken away."""
    medium, found = law(k), []
    for count in (16, 32):
        side = 2.0 / count
        x = side * (np.arange(count) - 0.5 * (count - 1))
        disc = np.hypot(x[:, None], x) < 1.0
        compliance = compliance_of(medium)
        pushed = medium.modulus * stuck_stiffness(disc, (side, side), compliance, tolerance=1e-6)[0]
        grid = TractionGrid.of(disc.shape, (1.0, 1.0), compliance.in_units_of(side), periodic=False)
        places = np.argwhere(np.broadcast_to(disc, (2, *disc.shape)))
        rows = tuple(places.T)
        matrix = np.empty((len(places), len(places)))
        for column, place in enumerate(places):
            one = np.zeros((2, *disc.shape))
            one[tuple(place)] = 1.0
            matrix[:, column] = grid.sheared(one)[rows]
        arm = np.stack([-np.broadcast_to(x, disc.shape), np.broadcast_to(x[:, None], disc.shape)])[rows]
        twisted = medium.modulus * side * float(arm @ np.linalg.solve(matrix, arm))
        radius = np.array([side * math.sqrt(np.count_nonzero(disc) / math.pi)])
        push, twist = medium.punch_shear_stiffness(radius)[0], medium.punch_torsional_stiffness(radius)[0]
        found.append((pushed / push, twisted / twist))
    assert 2.0 * np.array(found[1]) - found[0] == pytest.approx([1.0, 1.0], abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize(("k", "depth"), [(0.4, 1.0), (0.7, 1e-5), (-0.4, 1e-5), (-0.4, 10.0)])
def test_a_ball_in_a_loop_shifts_and_loses_as_its_springs_do(k, depth):
    """The method's springs are another derivation: Cattaneo's solution with the exponents of the grading."""
    medium, a = law(k, depth=depth), 0.01
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    force = float(wk.Indentation(bed, wk.Radius(a)).solve().force)
    path = wk.Path([0.0, 1.0, 2.0], wk.Force(force), wk.ShearForce([0.0, 0.2 * force, -0.2 * force]))
    springs = wk.Tangential(bed, wk.Coulomb(0.3), path).solve()
    ball = wk.SampledProfile([2.4 * a] * 2, wk.Paraboloid(1.0), (48, 48))
    found = wk.SurfaceTangential(ball, medium, wk.Coulomb(0.3), path).solve()
    assert found.shift[-1][0] == pytest.approx(springs.shift[-1], rel=2e-3)
    assert found.dissipation[-1] == pytest.approx(springs.dissipation[-1], rel=1.5e-2)


@pytest.mark.slow
def test_rolling_does_not_depend_on_the_depth_to_which_moduli_refer():
    ball = wk.SampledProfile([0.024] * 2, wk.Paraboloid(1.0), (36, 36))
    creepage, found = wk.Creepage(1.5e-3, 5e-4, 0.2), []
    for depth in (1.0, 1e-4):
        medium = wk.GradedHalfSpace(wk.PowerLawGraded(depth**0.7, depth, 0.7, 0.3))
        load = wk.Force(float(wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), wk.Radius(0.01)).solve().force))
        found.append(wk.SurfaceRolling(ball, medium, load, wk.Coulomb(0.3), creepage).solve())
    for name in ("longitudinal_force", "lateral_force", "moment", "stick_share"):
        assert getattr(found[0], name) == pytest.approx(getattr(found[1], name), rel=1e-5), name
    assert 0.1 < found[0].stick_share < 0.9


def test_nearly_no_power_rolls_as_a_half_space():
    """One body alone: the coupling of pressures with tractions is left out of a power law, so nu is 1/2."""
    solid = wk.Elastic(3.0, 0.5)
    ball = wk.SampledProfile([0.024] * 2, wk.Paraboloid(1.0), (18, 18))
    one, other = (
        wk.SurfaceRolling(ball, medium, wk.Force(2e-6), wk.Coulomb(0.3), wk.Creepage(2e-3, 0.0, 0.1)).solve()
        for medium in (wk.HalfSpace(solid), wk.GradedHalfSpace(wk.PowerLawGraded(3.0, 1.0, 1e-7, 0.5)))
    )
    assert other.longitudinal_force == pytest.approx(one.longitudinal_force, rel=1e-5)
    assert other.lateral_force == pytest.approx(one.lateral_force, rel=1e-5)


def test_gibsons_solid_bears_no_tractions():
    with pytest.raises(wk.OutsideValidity, match="no tangential stiffness"):
        compliance_of(law(1.0, 0.5))
