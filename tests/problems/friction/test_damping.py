"""Damping under a steady normal load, against closed forms, mpmath and independent quadrature (theory 9)."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.problems.friction.damping_springs import SlippingSprings
from winkler.problems.friction.damping_validity import damping_notes
from winkler.problems.friction.tangential import Tangential
from winkler.reference.damping import ball_loss, small_loss

MEDIUM = wk.HalfSpace.between(wk.Elastic(young=200e9, poisson=0.3), wk.Elastic(young=200e9, poisson=0.3))
BALL = wk.Foundation(wk.Paraboloid(10e-3), MEDIUM)
MU = 0.35
BETA = MU * MEDIUM.modulus / MEDIUM.shear_modulus


def exact_ball(y):
    """Return the bracket of Mindlin and Deresiewicz at 50 digits."""
    with mp.workdps(50):
        y = mp.mpf(float(y))
        power = (1 - y) ** (mp.mpf(5) / 3)
        return mp.mpf(18) / 5 * (1 - power - 5 * y / 6 * (1 + (1 - y) ** (mp.mpf(2) / 3)))


def test_the_number_of_the_theory():
    force = 120.0
    swing = wk.FrictionDamping(BALL, Coulomb(MU), wk.Force(force), wk.ShearForce(0.6 * MU * force)).solve()
    scaled = swing.loss_per_cycle * swing.contact.radius * MEDIUM.shear_modulus / (MU * force) ** 2
    assert scaled == pytest.approx(0.0410573844465, rel=2e-12)


def test_a_ball_of_any_amplitude():
    """Against Mindlin and Deresiewicz at 50 digits, from a millionth of the sliding force to sliding."""
    force = 120.0
    y = np.array([1e-4, 1e-3, 0.02, 0.2, 0.5, 0.8, 0.99, 0.999999, 1.0])
    swing = wk.FrictionDamping(BALL, Coulomb(MU), wk.Force(force), wk.ShearForce(y * MU * force)).solve()
    scale = (MU * force) ** 2 / (swing.contact.radius * MEDIUM.shear_modulus)
    exact = np.array([float(scale * exact_ball(each)) for each in y])
    # for small amplitudes only springs close to the edge slide: d - g there is known to the rounding of d
    np.testing.assert_allclose(swing.loss_per_cycle, exact, rtol=1e-11)
    np.testing.assert_allclose(swing.loss_per_cycle[2:], exact[2:], rtol=1e-12)
    np.testing.assert_allclose(
        swing.loss_per_cycle[2:],
        ball_loss(
            y[2:] * MU * force,
            force=force,
            coefficient=MU,
            radius=swing.contact.radius,
            shear_modulus=MEDIUM.shear_modulus,
        ),
        rtol=1e-9,
    )
    shift = BETA * swing.contact.depth * (1.0 - (1.0 - y) ** (2.0 / 3.0))
    np.testing.assert_allclose(swing.shift[:-2], shift[:-2], rtol=1e-11)
    assert swing.shift[-1] == pytest.approx(BETA * swing.contact.depth, rel=1e-14)


PROFILES = {
    "ball": wk.Paraboloid(10e-3),
    "sphere": wk.Sphere(10e-3),
    "cone": wk.Cone(half_angle=1.5),
    "fourth power": wk.PowerLaw(coefficient=1e6, exponent=4.0),
    "rounded punch": wk.RoundedPunch(flat_radius=1e-4, edge_radius=1e-2),
    "truncated cone": wk.TruncatedCone(half_angle=1.5, flat_radius=1e-4),
}


@pytest.mark.parametrize("name", PROFILES)
def test_against_a_march_along_the_path(name):
    """`Tangential` round the loop, from its first turning point on, under a static shift too."""
    bed = wk.Foundation(PROFILES[name], MEDIUM)
    contact = wk.Indentation(bed, wk.Radius(3e-4)).solve()
    for part in (0.2, 0.8, 1.6):
        shift = part * BETA * contact.depth
        lateral = np.array([0.0, 1.0, -1.0, 1.0, -1.0]) * shift + 0.1 * shift
        path = Path(np.arange(5.0), wk.Depth(contact.depth), wk.Shift(lateral))
        marched = Tangential(bed, Coulomb(MU), path).solve().dissipation
        swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(contact.depth), wk.Shift(shift)).solve()
        assert marched[4] - marched[2] == pytest.approx(swing.loss_per_cycle, rel=1e-9)


@pytest.mark.parametrize("name", PROFILES)
def test_small_amplitudes_are_cubic(name):
    """The ratio to (4/3) G*^2 U^3 / (mu E* g'(a)) tends to one, with the amplitude."""
    bed = wk.Foundation(PROFILES[name], MEDIUM)
    contact = wk.Indentation(bed, wk.Radius(3e-4)).solve()
    slope = float(bed.gap_slope(np.array([contact.radius]))[0])
    small = BETA * contact.depth * np.array([1e-3, 1e-4])
    swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(contact.depth), wk.Shift(small)).solve()
    numbers = {"coefficient": MU, "modulus": MEDIUM.modulus, "shear_modulus": MEDIUM.shear_modulus}
    off = swing.loss_per_cycle / small_loss(small, gap_slope=slope, **numbers) - 1.0
    assert abs(off[0]) < 3e-3
    assert abs(off[1]) < 3e-4
    assert np.all(np.abs(off[1]) <= 0.11 * np.abs(off[0]) + 1e-9)


@pytest.mark.parametrize("name", PROFILES)
def test_partial_and_gross_slip_of_every_profile(name):
    """Against the sum over the springs, by another rule, split where sliding begins."""
    bed = wk.Foundation(PROFILES[name], MEDIUM)
    contact = wk.Indentation(bed, wk.Radius(3e-4)).solve()
    limit = BETA * contact.depth
    prescribed = limit * np.array([0.3, 0.9, 1.0, 1.7])
    swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(contact.depth), wk.Shift(prescribed)).solve()
    for amplitude, loss, shear in zip(prescribed, swing.loss_per_cycle, swing.shear_force, strict=True):
        core = max(contact.depth - amplitude / BETA, 0.0)
        stick = wk.Indentation(bed, wk.Depth(core)).solve()

        def lost(x, amplitude=amplitude):
            bound = BETA * (contact.depth - float(bed.gap(np.array([x]))[0]))
            return 8.0 * MEDIUM.shear_modulus * bound * (amplitude - bound)

        start = stick.radius if core > 0.0 else 0.0
        breaks = [b for b, _ in bed.kinks if start < b < contact.radius]
        expected = sum(
            quad(lost, low, high, epsabs=0.0, epsrel=1e-11, limit=400)[0]
            for low, high in zip([start, *breaks], [*breaks, contact.radius], strict=True)
        )
        assert loss == pytest.approx(expected, rel=1e-9)
        assert shear == pytest.approx(MU * (contact.force - stick.force), rel=1e-11)
    # beyond gross slip every further dU costs 4 mu F dU
    assert swing.loss_per_cycle[3] - swing.loss_per_cycle[2] == pytest.approx(
        4.0 * MU * contact.force * (prescribed[3] - prescribed[2]), rel=1e-11
    )


def test_gross_slip_of_a_cone():
    """W = 4 mu F U - (8 mu^2 E*^2 / G*) Int (d - g)^2 dx, in closed form: the integral is a d^2 / 3."""
    bed = wk.Foundation(wk.Cone(half_angle=1.4), MEDIUM)
    contact = wk.Indentation(bed, wk.Force(50.0)).solve()
    shift = 1.5 * BETA * contact.depth
    swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Force(50.0), wk.Shift(shift)).solve()
    closed = 4.0 * MU * 50.0 * shift - 8.0 * MU**2 * MEDIUM.modulus**2 / MEDIUM.shear_modulus * (
        contact.radius * contact.depth**2 / 3.0
    )
    assert swing.loss_per_cycle == pytest.approx(closed, rel=1e-12)


def test_a_flat_punch_loses_nothing_until_it_slides():
    bed = wk.Foundation(wk.FlatPunch(radius=1e-3), MEDIUM)
    limit = MU * 500.0 / (2.0 * MEDIUM.shear_modulus * 1e-3)
    shift = limit * np.array([0.5, 0.999999, 1.5, 4.0])
    swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Force(500.0), wk.Shift(shift)).solve()
    np.testing.assert_array_equal(swing.loss_per_cycle[:2], 0.0)
    np.testing.assert_allclose(swing.loss_per_cycle[2:], 4.0 * MU * 500.0 * (shift[2:] - limit), rtol=1e-12)
    np.testing.assert_allclose(swing.shear_force, MU * 500.0 * np.minimum(shift / limit, 1.0), rtol=1e-12)


def test_a_graded_medium():
    """Power-law gradings keep one ratio of stiffnesses; small amplitudes feel k'(a) / g'(a)."""
    soil = wk.GradedHalfSpace(wk.PowerLawGraded(young=50e6, depth_scale=0.1, exponent=0.4, poisson=0.3))
    bed = wk.Foundation(wk.Paraboloid(0.5), soil)
    contact = wk.Indentation(bed, wk.Radius(0.02)).solve()
    ratio = float(soil.tangential_stiffness(np.ones(1))[0] / soil.normal_stiffness(np.ones(1))[0])
    beta = MU / ratio
    small = 1e-4 * beta * contact.depth
    swing = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(contact.depth), wk.Shift(np.array([small]))).solve()
    edge = np.array([contact.radius])
    growth = 2.0 * float(soil.normal_stiffness(edge)[0] / bed.gap_slope(edge)[0])
    assert swing.loss_per_cycle[0] == pytest.approx(2.0 / 3.0 * ratio * growth * small**3 / beta, rel=3e-4)
    # half of the sliding force, after Ciavarella and Jaeger
    half = wk.FrictionDamping(
        bed, Coulomb(MU), wk.Depth(contact.depth), wk.ShearForce(0.5 * MU * contact.force)
    ).solve()
    stick = wk.Indentation(bed, wk.Force(0.5 * contact.force)).solve()
    assert half.shift == pytest.approx(beta * (contact.depth - stick.depth), rel=1e-10)
    again = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(contact.depth), wk.Shift(half.shift)).solve()
    assert again.shear_force == pytest.approx(half.shear_force, rel=1e-10)
    assert again.loss_per_cycle == pytest.approx(half.loss_per_cycle, rel=1e-10)


@pytest.mark.slow
def test_springs_of_different_kinds_are_computed_and_labelled():
    """As on bodies graded in depth; coatings have rings, tests/problems/friction/test_steady_slip.py."""
    coat = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young=400e9, poisson=0.2), thickness=50e-6)], on=MEDIUM.first)
    bed = wk.Foundation(wk.Paraboloid(10e-3), coat)
    contact = wk.Indentation(bed, wk.Radius(60e-6)).solve()
    shift = 0.4 * MU * contact.depth
    springs = SlippingSprings(MU, contact)

    def lost(x):
        x = np.array([x])
        stiff = float(bed.tangential_stiffness(x)[0])
        bound = MU * float(bed.normal_stiffness(x)[0]) / stiff * (contact.depth - float(bed.gap(x)[0]))
        return 8.0 * stiff * bound * max(shift - bound, 0.0)

    expected = quad(lost, 0.0, contact.radius, epsabs=0.0, epsrel=1e-8, limit=400)[0]
    assert springs.loss(np.array([shift]))[0] == pytest.approx(expected, rel=1e-6)
    notes = damping_notes(bed, float(contact.radius), MU)
    (label,) = [note for note in notes if "Independent slip of the springs" in note.statement]
    assert label.standing is wk.Standing.APPROXIMATE
    force = springs.force(np.array([shift]))
    assert springs.shift(force)[0] == pytest.approx(shift, rel=1e-9)
    assert springs.stiffness > force[0] / shift


def test_quantities_of_vibration_engineering():
    """Loss factor 4/pi for sliding throughout, twice as much damping at half of the frequency, one loop of them all."""
    amplitude = np.array([0.0, 1e-8, 1e-6, 1e-2])
    swing = wk.FrictionDamping(BALL, Coulomb(MU), wk.Force(20.0), wk.Shift(amplitude)).solve()
    assert swing.loss_factor[0] == 0.0
    assert np.all(np.diff(swing.loss_factor) > 0.0)
    assert swing.loss_factor[-1] == pytest.approx(4.0 / math.pi, rel=1e-3)
    np.testing.assert_allclose(swing.loss_factor[1:], (swing.loss_stiffness / swing.secant_stiffness)[1:], rtol=1e-14)
    stuck = 2.0 * MEDIUM.shear_modulus * swing.contact.radius
    assert swing.secant_stiffness[0] == pytest.approx(stuck, rel=1e-12)
    assert swing.secant_stiffness[1] < stuck
    np.testing.assert_allclose(swing.damping(25.0), 2.0 * swing.damping(50.0), rtol=1e-15)
    # what the damper loses: pi c omega U^2
    lost = math.pi * np.asarray(swing.damping(50.0)) * 100.0 * math.pi * amplitude**2
    np.testing.assert_allclose(lost[1:], swing.loss_per_cycle[1:], rtol=1e-13)
    one = wk.FrictionDamping(BALL, Coulomb(MU), wk.Force(20.0), wk.Shift(1e-6)).solve()
    assert isinstance(one.loss_per_cycle, float)
    assert one.loss_per_cycle == pytest.approx(swing.loss_per_cycle[2], rel=1e-13)
    assert isinstance(one.damping(10.0), float)


def test_scaling():
    """Lengths times s, moduli times m: energies times m s^3, loss factors as they were."""
    s, m = 250.0, 1e-4
    bed = wk.Foundation(wk.Paraboloid(10e-3 * s), wk.HalfSpace.between(*[wk.Elastic(young=200e9 * m, poisson=0.3)] * 2))
    shift = np.array([2e-7, 1e-6])
    small = wk.FrictionDamping(BALL, Coulomb(MU), wk.Depth(2e-6), wk.Shift(shift)).solve()
    large = wk.FrictionDamping(bed, Coulomb(MU), wk.Depth(2e-6 * s), wk.Shift(shift * s)).solve()
    np.testing.assert_allclose(large.loss_per_cycle, small.loss_per_cycle * m * s**3, rtol=1e-11)
    np.testing.assert_allclose(large.loss_factor, small.loss_factor, rtol=1e-11)


def test_refusals():
    law = Coulomb(MU)
    for wrong in (Coulomb(0.0), Coulomb(math.inf), 0.3):
        with pytest.raises(wk.InvalidInput, match="positive, finite"):
            wk.FrictionDamping(BALL, wrong, wk.Force(1.0), wk.Shift(1e-6))
    with pytest.raises(wk.InvalidInput, match="one number"):
        wk.FrictionDamping(BALL, law, wk.Force([1.0, 2.0]), wk.Shift(1e-6))
    with pytest.raises(wk.InvalidInput, match="amplitude is Depth"):
        wk.FrictionDamping(BALL, law, wk.Force(1.0), wk.Depth(1e-6))
    with pytest.raises(wk.InvalidInput, match="zero or more"):
        wk.FrictionDamping(BALL, law, wk.Force(1.0), wk.Shift([1e-6, -1e-6]))
    with pytest.raises(wk.OutsideValidity, match="index 1 exceeds"):
        wk.FrictionDamping(BALL, law, wk.Force(1.0), wk.ShearForce([0.1, 0.36])).solve()
    with pytest.raises(wk.OutsideValidity, match="do not touch"):
        wk.FrictionDamping(BALL, law, wk.Depth(-1e-6), wk.Shift(1e-6)).solve()
    swing = wk.FrictionDamping(BALL, law, wk.Force(1.0), wk.Shift(1e-6)).solve()
    for wrong in (0.0, -1.0, math.inf, True):
        with pytest.raises(wk.InvalidInput, match="in Hz"):
            swing.damping(wrong)
