"""The limiting profile of fretting: Popov's closed form, brute force, and the digits of the theory sheet."""

import math

import mpmath
import numpy as np
import pytest

import winkler as wk

BALL, DEPTH, MU = 1.0, 0.01, 0.5
A0 = math.sqrt(BALL * DEPTH)
MEDIUM = wk.HalfSpace(wk.Elastic(young=1.0, poisson=0.3))
BED = wk.Foundation(wk.Paraboloid(BALL), MEDIUM)


def swing(core, medium=MEDIUM, gap=lambda x: x**2 / BALL):
    """Return the amplitude that leaves a core of this radius."""
    return wk.Shift(MU * medium.modulus / medium.shear_modulus * (DEPTH - gap(core)))


def limit(core, **changes):
    given = {"bed": BED, "law": wk.Coulomb(MU), "normal": wk.Depth(DEPTH), "amplitude": swing(core)} | changes
    return wk.LimitingProfile(**given).solve()


@pytest.mark.parametrize(
    ("core", "radius", "volume", "force"),
    [
        (0.2, 1.346365, 2.055188, 0.394667),
        (0.5, 1.229791, 0.759299, 0.916667),
        (0.8, 1.096897, 0.0900483, 1.258667),
        (0.95, 1.024811, 0.00302666, 1.328417),
    ],
)
def test_a_ball_ends_as_in_popov(core, radius, volume, force):
    result = limit(core * A0)
    assert result.stick_radius == pytest.approx(core * A0, rel=1e-12)
    assert result.radius / A0 == pytest.approx(radius, abs=6e-7)
    assert result.worn_volume / (A0**2 * DEPTH) == pytest.approx(volume, rel=1e-6)
    assert result.force / (MEDIUM.modulus * A0 * DEPTH) == pytest.approx(force, abs=6e-7)


def test_the_shape_is_the_integral_of_popov():
    core = 0.5 * A0
    result = limit(core)
    for r in (0.051, 0.08, 0.12):
        kernel = mpmath.quad(lambda x, r=r: x**2 / mpmath.sqrt(r**2 - x**2), [0, core])
        expected = 2 / math.pi * (float(kernel) / BALL + DEPTH * math.acos(core / r))
        assert result.height(np.array([r]))[0] == pytest.approx(expected, rel=1e-10)
    unworn = np.array([0.0, 0.02, 0.0499, result.radius * 1.01])
    np.testing.assert_array_equal(result.height(unworn), BED.height(unworn))


def test_the_pressure_of_the_core_adds_up_to_its_force():
    result = limit(0.5 * A0)
    c = result.stick_radius
    # r = c sin(w) takes away the inverse root at the edge
    nodes, weights = np.polynomial.legendre.leggauss(60)
    w = 0.25 * np.pi * (nodes + 1.0)
    r = c * np.sin(w)
    total = 0.25 * np.pi * np.sum(weights * 2.0 * np.pi * r * result.pressure(r) * c * np.cos(w))
    assert total == pytest.approx(result.force, rel=1e-8)
    assert result.pressure(np.array([c * 1.001]))[0] == 0.0
    assert result.worn_depth < DEPTH


def test_with_a_vanishing_core_the_contact_ends_where_the_ball_is_as_high_as_the_depth():
    assert limit(1e-3 * A0).radius == pytest.approx(math.sqrt(2.0) * A0, rel=1e-3)


def test_a_coating_of_the_same_solid_changes_nothing():
    solid = wk.Elastic(young=1.0, poisson=0.3)
    coated = wk.Foundation(wk.Paraboloid(BALL), wk.CoatedHalfSpace([wk.Layer(solid, thickness=0.05)], on=solid))
    one, other = limit(0.5 * A0), limit(0.5 * A0, bed=coated)
    assert other.radius == pytest.approx(one.radius, rel=1e-6)
    assert other.force == pytest.approx(one.force, rel=1e-6)


def test_where_all_or_nothing_slips_there_is_no_limit():
    with pytest.raises(wk.OutsideValidity, match="everything slips"):
        limit(0.0, amplitude=wk.Shift(1.0))
    with pytest.raises(wk.OutsideValidity, match="nothing slips"):
        limit(0.0, bed=wk.Foundation(wk.FlatPunch(0.1), MEDIUM), amplitude=wk.Shift(1e-6))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"normal": wk.Force(1.0)}, "steady force"),
        ({"amplitude": wk.ShearForce(1.0)}, "give Shift"),
        ({"amplitude": wk.Shift(0.0)}, "one positive number"),
        ({"law": wk.Coulomb(0.0)}, "positive, finite"),
        ({"bed": 3}, "give Foundation"),
    ],
)
def test_wrong_arguments_are_refused(changes, message):
    with pytest.raises(wk.InvalidInput, match=message):
        limit(0.5 * A0, **changes)
