"""Joints: bodies without Poisson's ratio, balls on layers against rings, loops in closed form, and repeated maps."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.surface_friction.joint_loops import loops_of_stiffness
from winkler.values.errors import InvalidInput, OutsideValidity

LAW = wk.Coulomb(0.3)
STIFF = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3), 0.1)], on=wk.Elastic(1.0, 0.4), second=wk.Elastic(3.0, 0.2))


def pair(poisson, young=2.0):
    body = wk.Elastic(young, poisson)
    return wk.HalfSpace.between(body, body)


def waves(count=48, *, periodic=True):
    """A map of five oblique waves."""
    x = np.arange(count) / count
    terms = ((1, 2, 0.1), (3, -1, 0.4), (4, 4, 0.2), (5, -6, 0.7), (6, 2, 0.9))
    rows = [np.cos(2 * np.pi * (k * x[:, None] + m * x + p)) / math.hypot(k, m) ** 1.5 for k, m, p in terms]
    return wk.Topography(0.01 * sum(rows), [1.0, 1.0], periodic=periodic)


def ball(count=64, side=0.9):
    x = (np.arange(count) - (count - 1) / 2) * side / count
    return wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), [side, side])


@pytest.mark.few(1)
@pytest.mark.parametrize("periodic", [False, True])
def test_without_poissons_ratio_a_rough_joint_is_as_stiff_along_as_across(periodic):
    joint = wk.JointStiffness(waves(periodic=periodic), pair(0.0), LAW, wk.Force(np.array([0.003, 0.01]))).solve()
    assert joint.ratio_x == pytest.approx(1.0, abs=1e-5)
    assert joint.ratio_y == pytest.approx(1.0, abs=1e-5)
    assert joint.disc_ratio == pytest.approx(1.0, rel=1e-14)
    # then tractions of a given force need not lean, and Ciavarella and Jaeger are right
    assert joint.shift_error < 5e-3
    assert joint.loss_error < 2e-2


@pytest.mark.few(1)
@pytest.mark.parametrize("force", [0.002, 0.05])
def test_a_ball_on_a_coating_is_as_stiff_as_rings(force):
    """Across and along, of the disc by the ring solvers; what turns with the angle is of the second order."""
    joint = wk.JointStiffness(ball(), STIFF, LAW, wk.Force(force), share=np.array([0.5])).solve()
    line = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), STIFF), wk.Force(force)).solve()
    assert joint.stiffness == pytest.approx(line.stiffness, rel=4e-3)
    assert joint.ratio_x == pytest.approx(joint.ratio_y, rel=1e-5)
    assert joint.ratio_x == pytest.approx(joint.disc_ratio, rel=2e-3)


@pytest.mark.slow
def test_thin_and_thick_coatings_are_their_solids():
    top, base, other = wk.Elastic(1.5, 0.3), wk.Elastic(1.0, 0.4), wk.Elastic(3.0, 0.2)
    rough, load, share = waves(24), wk.Force(0.01), np.array([0.5])

    def found(medium):
        return wk.JointStiffness(rough, medium, LAW, load, share=share).solve()

    for thickness, body in ((1e-4, base), (30.0, top)):
        coated = found(wk.CoatedHalfSpace([wk.Layer(top, thickness)], on=base, second=other))
        alone = found(wk.CoatedHalfSpace([wk.Layer(body, 1.0)], on=body, second=other))  # without coupling
        for name in ("stiffness", "stiffness_x", "stiffness_y", "shift_amplitude"):
            assert getattr(coated, name) == pytest.approx(getattr(alone, name), rel=4e-3), name


@pytest.mark.slow
def test_a_map_laid_beside_itself_is_the_same_joint():
    one, share = waves(32), np.array([0.3, 0.8])
    two = wk.Topography(np.tile(one.heights, (2, 1)), [2.0, 1.0], periodic=True)
    first, second = (
        wk.JointStiffness(rough, pair(0.3), LAW, wk.Force(force), share=share).solve()
        for rough, force in ((one, 0.01), (two, 0.02))
    )
    for name in ("areal_stiffness", "areal_stiffness_x", "areal_stiffness_y", "shift_amplitude"):
        assert getattr(second, name) == pytest.approx(getattr(first, name), rel=1e-4), name
    assert second.loss_per_cycle == pytest.approx(2.0 * first.loss_per_cycle, rel=1e-3)


def test_a_turned_map_is_a_turned_joint():
    rough = waves(32)
    turned = wk.Topography(rough.heights.T, [1.0, 1.0], periodic=True)
    load, share = wk.Force(0.005), np.array([0.5])
    first, second = (wk.JointStiffness(one, pair(0.4), LAW, load, share=share).solve() for one in (rough, turned))
    assert second.ratio_x == pytest.approx(first.ratio_y, rel=1e-6)
    assert second.ratio_y == pytest.approx(first.ratio_x, rel=1e-6)


@pytest.mark.parametrize("power", [1.0 / 3.0, 0.6])
def test_loops_of_a_power_law_are_in_closed_form(power):
    """K = c F^p: u is mu (F^(1-p) - (F - F_x/mu)^(1-p)) / (c (1-p)), the loss Masing's integral of it."""
    force, friction, share = np.geomspace(0.02, 2.0, 5), 0.4, np.array([0.1, 0.5, 0.98])
    rest, most = 1.0 - power, friction * 2.0
    found = loops_of_stiffness(force, 3.0 * force**power, friction, share)
    shift = friction / (3.0 * rest) * 2.0**rest * (1.0 - (1.0 - share) ** rest)
    inside = friction / (3.0 * rest) * 2.0**rest * most * (share - (1.0 - (1.0 - share) ** (rest + 1.0)) / (rest + 1.0))
    assert found.shift == pytest.approx(shift, rel=1e-11)
    assert found.loss == pytest.approx(4.0 * share * most * shift - 8.0 * inside, rel=1e-9)


@pytest.mark.slow
def test_the_drawn_loop_encloses_the_loss():
    joint = wk.JointStiffness(ball(48), pair(0.0), LAW, wk.Force(0.02), share=np.array([0.4, 0.9])).solve()
    for amplitude in range(2):
        shift, force = joint.slip_loop(amplitude, count=4001)
        assert shift[0] == pytest.approx(joint.spring_shift[amplitude], rel=1e-9)
        assert abs(np.trapezoid(force, shift)) == pytest.approx(joint.spring_loss[amplitude], rel=1e-3)
    assert joint.loss_factor == pytest.approx(
        joint.loss_per_cycle / (np.pi * joint.shift_amplitude * joint.shear_amplitude), rel=1e-14
    )
    assert joint.secant_stiffness[0] < joint.stiffness_x


def test_what_is_no_joint_is_refused():
    with pytest.raises(InvalidInput, match="with a positive, finite coefficient"):
        wk.JointStiffness(ball(), pair(0.3), wk.Coulomb(0.0), wk.Force(1.0))
    with pytest.raises(InvalidInput, match=r"share is 1.0 at index 1; give a row of numbers between 0.01 and 0.99"):
        wk.JointStiffness(ball(), pair(0.3), LAW, wk.Force(1.0), share=np.array([0.5, 1.0]))
    with pytest.raises(OutsideValidity, match="touches everywhere, and its two sides are one body"):
        wk.JointStiffness(waves(16), pair(0.3), LAW, wk.Force(10.0)).solve()
    gibson = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=1.0, exponent=1.0, poisson=0.5))
    with pytest.raises(OutsideValidity, match="its surface consists of independent springs"):
        wk.JointStiffness(ball(), gibson, LAW, wk.Force(0.01))


@pytest.mark.slow
def test_a_ball_on_a_power_law_is_as_stiff_along_the_surface_as_its_springs():
    graded = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=1.0, exponent=0.3, poisson=0.3))
    joint = wk.JointStiffness(ball(32), graded, LAW, wk.Force(0.02), share=np.array([0.5])).solve()
    assert joint.stiffness_x / joint.stiffness == pytest.approx(graded.shear_modulus / graded.modulus, rel=5e-3)


def test_layers_say_what_they_leave_out():
    joint = wk.JointStiffness(ball(32), STIFF, LAW, wk.Force(0.02), share=np.array([0.5])).solve()
    text = " ".join(str(note) for note in joint.validity)
    assert "Both effects are neglected (Goodman)" in text
    assert f"the dissipated energy by {100.0 * joint.loss_error:.2g} % of its maximum" in text
    assert np.isfinite(joint.loop.stresses(0.0, 0.0, 0.1).von_mises)
