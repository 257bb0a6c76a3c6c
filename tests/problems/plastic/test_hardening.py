"""Metals that harden, against closed laws of hardness."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk
from winkler.values.errors import InvalidInput

RADIUS = 5e-3
FORCES = np.array([5.0, 50.0, 300.0, 3000.0, 1000.0, 0.0])


def pressed(solid, forces=FORCES, other=None):
    medium = wk.HalfSpace(solid) if other is None else wk.HalfSpace(solid, other)
    return wk.PlasticIndentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(forces)).solve()


def test_what_does_not_harden_is_perfectly_plastic():
    plain = pressed(wk.Elastic(210e9, 0.3, 1e9))
    for solid, close in (
        (wk.PowerHardening(210e9, 0.3, 1e9, exponent=0.0), 1e-12),
        (wk.LinearHardening(210e9, 0.3, 1e9, plastic_modulus=1.0), 1e-8),
    ):
        hard = pressed(solid)
        for name in ("depth", "radius", "residual_depth", "energy", "dissipation"):
            np.testing.assert_allclose(getattr(hard, name), getattr(plain, name), rtol=close, atol=1e-30)
        assert any(note.error == 0.025 for note in hard.validity)
    assert not any(note.error == 0.025 for note in plain.validity)


def test_yielding_begins_where_it_would_without_hardening_and_nothing_jumps():
    soft, hard = wk.Elastic(210e9, 0.3, 1e9), wk.PowerHardening(210e9, 0.3, 1e9, exponent=0.3)
    onset = wk.YieldOnset(wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(soft))).solve()
    solved = pressed(hard, np.array([1.0 - 1e-5, 1.0, 1.0 + 1e-5]) * onset.force)
    assert solved.problem.yield_force == pytest.approx(onset.force, rel=1e-9)
    np.testing.assert_allclose(
        np.diff(solved.force) / np.diff(solved.depth), 2 * 210e9 / 0.91 * onset.radius, rtol=1e-4
    )
    assert solved.residual_depth[0] == 0.0


def test_the_more_it_hardens_the_more_it_bears():
    exponents = (0.0, 0.1, 0.2, 0.3, 0.4)
    solved = [pressed(wk.PowerHardening(210e9, 0.3, 0.5e9, exponent=n), np.array([1000.0])) for n in exponents]
    for name in ("mean_pressure",):
        assert np.all(np.diff([getattr(one, name)[0] for one in solved]) > 0.0)
    for name in ("depth", "radius", "residual_depth", "dissipation", "edge_height"):
        assert np.all(np.diff([getattr(one, name)[0] for one in solved]) < 0.0)


@pytest.mark.parametrize("exponent", [0.1, 0.2, 0.3, 0.4])
def test_deep_dents_follow_the_laws_of_meyer_and_tabor(exponent):
    """F ~ a^(2 + n), and a mean pressure of 2.8 times the flow stress at a strain of 0.2 a/R (Tabor 1951)."""
    solid = wk.PowerHardening(210e9, 0.3, 2e6, exponent=exponent)
    solved = pressed(solid, np.geomspace(200.0, 400.0, 5))
    power = np.diff(np.log(solved.force)) / np.diff(np.log(solved.radius))
    np.testing.assert_allclose(power, 2.0 + exponent, atol=0.02)
    stress = solid.flow_stress(0.2 * solved.radius / RADIUS)
    np.testing.assert_allclose(solved.mean_pressure / stress, 2.8, rtol=0.16)


def test_energy_closes_and_two_alike_bodies_are_two_halves():
    solid = wk.LinearHardening(210e9, 0.3, 0.5e9, plastic_modulus=4e9)
    forces = np.concatenate([1000.0 * np.linspace(0.0, 1.0, 300) ** 2, 1000.0 * np.linspace(1.0, 0.0, 300) ** 2])
    solved = pressed(solid, forces)
    work = np.concatenate([[0.0], np.cumsum(np.diff(solved.depth) * 0.5 * (forces[1:] + forces[:-1]))])
    np.testing.assert_allclose(solved.work, work, rtol=2e-5, atol=2e-5 * np.max(work))
    pair = pressed(solid, other=solid)
    half = wk.PlasticIndentation(wk.Foundation(wk.Paraboloid(2.0 * RADIUS), wk.HalfSpace(solid)), wk.Force(FORCES))
    np.testing.assert_allclose(pair.depth, 2.0 * half.solve().depth, rtol=1e-9)


@pytest.mark.parametrize("profile", [wk.Cone(1.3), wk.Paraboloid(RADIUS), wk.Hyperboloid(1e-4, 1.2)])
def test_the_order_of_bodies_that_harden_does_not_matter(profile):
    """In either order, and with a body that yields without hardening, or not at all."""
    one = wk.PowerHardening(210e9, 0.3, 0.3e9, exponent=0.2)
    for other in (
        wk.LinearHardening(70e9, 0.33, 0.1e9, plastic_modulus=1e9),
        wk.Elastic(120e9, 0.34, 0.2e9),
        wk.Elastic(120e9, 0.34),
    ):
        both, turned = (
            wk.PlasticIndentation(wk.Foundation(profile, wk.HalfSpace(*bodies)), wk.Force(FORCES)).solve()
            for bodies in ((one, other), (other, one))
        )
        for name in ("depth", "radius", "residual_depth", "dissipation"):
            np.testing.assert_allclose(getattr(both, name), getattr(turned, name), rtol=1e-10, atol=1e-30)


def test_under_a_cone_each_of_two_bodies_is_pressed_by_its_share_of_the_slope():
    """A part of the gap of a cone is a cone: pressures of one body alone, which do not depend on the load."""
    one, other = wk.PowerHardening(210e9, 0.3, 0.3e9, exponent=0.2), wk.Elastic(120e9, 0.34, 0.2e9)
    slope = 0.3

    def alone(solid, share):
        bed = wk.Foundation(wk.Cone(math.pi / 2.0 - math.atan(share * slope)), wk.HalfSpace(solid))
        return float(wk.PlasticIndentation(bed, wk.Force([1.0])).solve().mean_pressure[0])

    share = brentq(lambda part: alone(one, part) - alone(other, 1.0 - part), 0.01, 0.99, rtol=1e-13)
    bed = wk.Foundation(wk.Cone(math.pi / 2.0 - math.atan(slope)), wk.HalfSpace(one, other))
    pair = wk.PlasticIndentation(bed, wk.Force([1.0, 30.0])).solve()
    np.testing.assert_allclose(pair.mean_pressure, alone(one, share), rtol=1e-9)


def test_it_is_the_same_at_every_size():
    one = pressed(wk.PowerHardening(210e9, 0.3, 0.5e9, exponent=0.25), np.array([500.0]))
    bed = wk.Foundation(wk.Paraboloid(RADIUS * 1e-3), wk.HalfSpace(wk.PowerHardening(210e3, 0.3, 0.5e3, exponent=0.25)))
    other = wk.PlasticIndentation(bed, wk.Force([500.0 * 1e-12])).solve()
    assert other.depth[0] == pytest.approx(1e-3 * one.depth[0], rel=1e-9)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: wk.PowerHardening(210e9, 0.3, 1e9, exponent=-0.1), "from 0 to 0.5"),
        (lambda: wk.PowerHardening(210e9, 0.3, 1e9, exponent=0.7), "from 0 to 0.5"),
        (lambda: wk.LinearHardening(210e9, 0.3, 1e9, plastic_modulus=-1e9), "plastic_modulus"),
        (
            lambda: wk.ElasticPlasticParticle(1e-3, wk.PowerHardening(1e9, 0.3, 2e7, exponent=0.2), wk.Depth([1e-5])),
            "does not harden",
        ),
    ],
)
def test_what_it_cannot_do_it_says(make, says):
    with pytest.raises(InvalidInput, match=says):
        make()


def test_a_wide_contact_states_what_its_shape_costs():
    """R. L. Jackson, I. Green, J. Tribol. 127 (2005) 343-354: the pressure of a flattened ball falls from 2.84 S."""
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3, 1e9)))
    for force in (1e3, 3e3, 1e4, 3e4):
        solved = wk.PlasticIndentation(bed, wk.Force([force])).solve()
        wide = solved.radius[0] / RADIUS
        stated = [note.error for note in solved.validity if "flattened" in note.statement]
        assert len(stated) == (wide > 0.05)
        if stated:
            missing = 0.92 / 2.84 * (1.0 - math.cos(math.pi * wide))
            assert missing < stated[0] < 1.4 * missing
