"""Lines that slip, roll and begin to roll on power laws: waves, integral equations, elements, limits, refusals."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import winkler as wk
from winkler.problems.line_rolling.rolled_strip import rolled_strip
from winkler.problems.method import Method

RADIUS, LOAD, MU = 0.6, 1e5, 0.3
EXPONENTS = [-0.3, 0.2, 0.5, 0.8]


def soil(k, poisson=0.3):
    return wk.PowerLawGraded(young=30e6, depth_scale=1.0, exponent=k, poisson=poisson)


@functools.cache
def bed(k, profile=None):
    return wk.PowerLawLineFoundation(profile or wk.Paraboloid(RADIUS), wk.GradedHalfSpace(soil(k), soil(k)))


def surface_waves(k, poisson):
    """Return displacements (u, w) by tractions (along, normal) of a wave of number one on E = z^k, integrated up."""

    def rate(log_depth, flat):
        z = math.exp(log_depth)
        u, w, along, normal = flat.reshape(4, 2)
        young = z**k
        shear = young / (2.0 * (1.0 + poisson))
        lame = 2.0 * shear * poisson / (1.0 - 2.0 * poisson)
        deep = (normal + lame * u) / (lame + 2.0 * shear)
        return z * np.array([along / shear - w, deep, (lame + 2.0 * shear) * u - lame * deep, along]).ravel()

    start = 30.0  # where the wave has died out, whatever it is there
    states = np.array([[1.0, 0.0], [0.0, 1.0], [-(start**k), 0.0], [0.0, -(start**k)]])
    places = np.concatenate(
        [np.linspace(math.log(start), math.log(0.1), 40), np.linspace(math.log(0.1), -60.0, 40)[1:]]
    )
    for high, low in zip(places[:-1], places[1:], strict=True):
        states = solve_ivp(rate, (high, low), states.ravel(), method="DOP853", rtol=1e-11, atol=1e-25).y[:, -1]
        states = np.linalg.qr(states.reshape(4, 2))[0]
    return states[:2] @ np.linalg.inv(states[2:])


@pytest.mark.parametrize(("k", "poisson"), [(0.3, 0.3), (-0.3, 0.2), (0.6, 0.45)])
def test_tractions_move_the_surface_as_waves_over_the_depth_do(k, poisson):
    moved = surface_waves(k, poisson)
    medium = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, k, poisson))
    assert medium.modulus / medium.along_modulus == pytest.approx(moved[0, 0] / moved[1, 1], rel=1e-6)


def moved_by(load, k, edges, x):
    """Return the integral of a traction times |x - s|^-k, from one place where it bends to the next."""
    places, total, power = sorted({x, *edges, *(-edge for edge in edges)}), 0.0, 1.0 / (1.0 - k)
    for low, high in zip(places[:-1], places[1:], strict=True):
        if x in {low, high}:
            side = 1.0 if x == low else -1.0
            whole = quad(
                lambda t, side=side: load(x + side * t**power) * power, 0.0, (high - low) ** (1.0 - k), limit=400
            )
        else:
            whole = quad(lambda s: load(s) * abs(x - s) ** -k, low, high, limit=400)
        total += whole[0]
    return total


@pytest.mark.parametrize("k", [-0.3, 0.5])
def test_the_traction_moves_what_sticks_as_one_and_the_rest_by_its_slip(k):
    """Cattaneo's condition by quadrature over the kernel |x - s|^-k of line loads."""
    path = wk.LinePath(LOAD, [0.0, 0.5 * MU * LOAD, -0.2 * MU * LOAD])
    state = wk.LineTangential(bed(k), wk.Coulomb(MU), path).solve().states[-1]
    a, medium = state.half_width, bed(k).medium
    level = math.cos(0.5 * math.pi * k) / (math.pi * medium.along_modulus)
    level *= math.sqrt(math.pi) * math.gamma(0.5 * k) / math.gamma(0.5 * (1.0 + k))
    stuck = state.stick_half_width
    x = np.array([0.0, 0.4 * stuck, 0.9 * stuck, 0.3 * stuck + 0.7 * a, 0.1 * stuck + 0.9 * a])
    edges = [strip.half_width for strip in state.strips]

    def traction(place):
        return float(state.traction(np.array([place]))[0])

    moved = np.array([level * moved_by(traction, k, edges, place) for place in x])
    np.testing.assert_allclose(moved[0] - moved, state.slip(x), rtol=1e-6, atol=1e-7 * np.ptp(moved))
    assert np.ptp(moved) > 1e-2 * abs(moved[0])


@pytest.mark.few(1, slow=3)
@pytest.mark.parametrize("k", EXPONENTS)
def test_elements_march_to_the_same_slip(k):
    path = wk.LinePath(
        [LOAD, LOAD, LOAD, 1.3 * LOAD, 1.3 * LOAD, LOAD], LOAD * np.array([0, 0.2, -0.1, 0.15, 0.3, 0.1])
    )
    sums = wk.LineTangential(bed(k), wk.Coulomb(MU), path).solve()
    cells = wk.LineTangential(bed(k), wk.Coulomb(MU), path, method=Method.ELEMENTS).solve()
    np.testing.assert_allclose(cells.dissipation_per_length[1:], sums.dissipation_per_length[1:], rtol=3e-4)
    np.testing.assert_allclose(cells.slip_shift, sums.slip_shift, atol=1e-4 * np.max(np.abs(sums.slip_shift)))
    np.testing.assert_allclose(cells.stick_half_width, sums.stick_half_width, rtol=0.01)


def test_a_half_plane_is_the_limit():
    plain = wk.LineFoundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(*(wk.Elastic(30e6, 0.3),) * 2))
    path = wk.LinePath([LOAD, LOAD, LOAD, 1.3 * LOAD], LOAD * np.array([0.0, 0.2, -0.1, 0.15]))
    for k, error in ((0.0, 1e-11), (1e-5, 3e-4)):
        one, other = (wk.LineTangential(each, wk.Coulomb(MU), path).solve() for each in (bed(k), plain))
        np.testing.assert_allclose(one.slip_shift, other.slip_shift, rtol=error, atol=1e-18)
        np.testing.assert_allclose(one.dissipation_per_length, other.dissipation_per_length, rtol=error)
        marched, rolled = (
            wk.LineRollingStart(
                each, wk.Coulomb(MU), wk.Creepage(1e-3), wk.LineForce(LOAD), 0.2, reference=2.0, points=2, count=20
            ).solve()
            for each in (bed(k), plain)
        )
        np.testing.assert_allclose(marched.shear_force_per_length, rolled.shear_force_per_length, rtol=error)
        steady, carter = (
            wk.LineRolling(each, wk.Coulomb(MU), wk.LineShearForce(0.1 * LOAD), wk.LineForce(LOAD)).solve()
            for each in (bed(k), plain)
        )
        assert steady.longitudinal_creepage == pytest.approx(carter.longitudinal_creepage, rel=error)


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("k", EXPONENTS)
def test_rolling_has_a_closed_form_that_elements_meet(k):
    """Q / mu P = 1 - (c/a)^(2+k), and the creepage mu (E*/m_L) (a - c) / R."""
    contact, friction, medium = bed(k), wk.Coulomb(MU), bed(k).medium
    forces = MU * LOAD * np.array([0.1, -0.5, 0.9])
    rolled = wk.LineRolling(contact, friction, wk.LineShearForce(forces), wk.LineForce(LOAD)).solve()
    a = float(rolled.contact.half_width)
    share = (1.0 - np.abs(forces) / (MU * LOAD)) ** (1.0 / (2.0 + k))
    creepage = np.sign(forces) * MU * medium.modulus / medium.along_modulus * a * (1.0 - share) / RADIUS
    np.testing.assert_allclose(rolled.stick_share, share, rtol=1e-12)
    np.testing.assert_allclose(rolled.longitudinal_creepage, creepage, rtol=1e-12)
    back = wk.LineRolling(contact, friction, wk.Creepage(creepage), wk.LineForce(LOAD)).solve()
    np.testing.assert_allclose(back.shear_force_per_length, forces, rtol=1e-11)
    for index, force in enumerate(forces.tolist()):
        strip = rolled_strip(contact, a, MU, force=force / (medium.modulus * a), coupled=False)
        assert strip.creepage == pytest.approx(creepage[index], rel=2e-5)
        assert strip.loss * medium.modulus * a == pytest.approx(force * creepage[index], rel=2e-4)
    one = wk.LineRolling(contact, friction, wk.LineShearForce(forces[2]), wk.LineForce(LOAD)).solve()
    x = 0.5 * a * (strip.x[1:] + strip.x[:-1])
    edge = a * (1.0 - 2.0 * float(one.stick_share))
    away = (np.abs(x - edge) > 0.03 * a) & (np.abs(x) < 0.99 * a)  # slip rises steeply there
    np.testing.assert_allclose(one.slip(x)[away], strip.slip[away], atol=2e-3 * np.max(strip.slip))
    traction = np.interp(x, a * strip.x, medium.modulus * strip.traction)
    np.testing.assert_allclose(one.traction(x)[away], traction[away], atol=2e-3 * np.max(traction))


@pytest.mark.few(1, slow=3)
@pytest.mark.parametrize("k", EXPONENTS)
def test_rolling_that_begins_comes_to_the_steady_state(k):
    a = float(wk.LineIndentation(bed(k), wk.LineForce(LOAD)).solve().half_width)
    for share in (0.1, 0.5, 0.9):
        pull = wk.LineShearForce(share * MU * LOAD)
        begun = wk.LineRollingStart(bed(k), wk.Coulomb(MU), pull, wk.LineForce(LOAD), 8.0 * a, points=2).solve()
        assert begun.longitudinal_creepage[-1] == pytest.approx(begun.steady.longitudinal_creepage, rel=2e-3)


def test_slip_grows_with_poissons_ratio_and_with_a_softer_second_body():
    path = wk.LinePath(LOAD, [0.0, 0.2 * LOAD])

    def shift(*bodies):
        contact = wk.PowerLawLineFoundation(wk.Paraboloid(RADIUS), wk.GradedHalfSpace(*bodies))
        return wk.LineTangential(contact, wk.Coulomb(MU), path).solve().slip_shift[-1]

    twice = wk.PowerLawGraded(60e6, 1.0, 0.5, 0.3)
    assert shift(twice, twice) < shift(twice, soil(0.5)) < shift(soil(0.5), soil(0.5))


def test_two_bodies_that_are_alike_do_not_draw_each_other_along():
    def note(*bodies):
        contact = wk.PowerLawLineFoundation(wk.Paraboloid(RADIUS), wk.GradedHalfSpace(*bodies))
        drive = wk.LineShearForce(0.1 * LOAD)
        rolled = wk.LineRolling(contact, wk.Coulomb(MU), drive, wk.LineForce(LOAD)).solve()
        return next(each for each in rolled.validity if each.assumption is wk.Assumption.UNCOUPLED)

    assert note(soil(0.5), soil(0.5)).standing is wk.Standing.EXACT
    assert note(soil(0.5)).standing is wk.Standing.APPROXIMATE
    assert "not known" in note(soil(0.5), soil(0.5, 0.2)).statement


def test_what_power_laws_do_not_tell():
    alone = wk.PowerLawLineFoundation(wk.Paraboloid(RADIUS), wk.GradedHalfSpace(soil(0.5)))
    drive, load = wk.LineShearForce(0.1 * LOAD), wk.LineForce(LOAD)
    with pytest.raises(wk.OutsideValidity, match="coupled = False"):
        wk.LineRolling(alone, wk.Coulomb(MU), drive, load, coupled=True).solve()
    coupled = wk.LineRolling(bed(0.5), wk.Coulomb(MU), drive, load, coupled=True).solve()
    assert (
        coupled.longitudinal_creepage
        == wk.LineRolling(bed(0.5), wk.Coulomb(MU), drive, load).solve().longitudinal_creepage
    )
    with pytest.raises(wk.OutsideValidity, match="stresses"):
        coupled.stresses(0.0, 0.1)
    pushed = wk.LineTangential(bed(0.5), wk.Coulomb(MU), wk.LinePath(LOAD, [0.0, 0.1 * LOAD])).solve()
    with pytest.raises(wk.OutsideValidity, match="stresses"):
        pushed.states[-1].stresses(0.0, 0.1)
    with pytest.raises(wk.OutsideValidity, match="bulk stress"):
        wk.LineTangential(bed(0.5), wk.Coulomb(MU), wk.LinePath(LOAD, [0.0, 0.1 * LOAD], [0.0, 1e3]))
    gibson = wk.PowerLawLineFoundation(wk.Paraboloid(RADIUS), wk.GradedHalfSpace(soil(1.0, 0.5)))
    with pytest.raises(wk.OutsideValidity, match="Gibson"):
        wk.LineTangential(gibson, wk.Coulomb(MU), wk.LinePath(LOAD, [0.0, 0.1 * LOAD]))
