"""Radii of two bodies together: the Hessian of their distance, hollow bodies, pairs that touch in no point."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

import winkler as wk


@pytest.mark.parametrize("angle", [0.0, 0.3, 0.5 * math.pi, 1.2, 2.5, -0.7])
@pytest.mark.parametrize(
    "radii", [((0.01, 0.02), (0.03, -0.05)), ((math.inf, 0.01), (math.inf, 0.03)), ((1.0, 1.0), (2.0, 3.0))]
)
def test_principal_curvatures_of_the_distance(radii, angle):
    """The eigenvalues of the sum of both curvature tensors, and the direction of the first one."""
    turned = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    first, second = (np.diag([1.0 / radius for radius in pair]) for pair in radii)
    tensor = first + turned @ second @ turned.T
    if np.min(np.linalg.eigvalsh(tensor)) < 1e-12:
        with pytest.raises(wk.InvalidInput, match="do not touch in a point"):
            wk.CurvedBodies.of(*radii, angle)
        return
    found, turn = wk.CurvedBodies.of(*radii, angle), wk.CurvedBodies.turn(*radii, angle)
    assert abs(turn) <= 0.25 * math.pi
    for direction, radius in (
        (turn, found.longitudinal_curvature_radius),
        (turn + 0.5 * math.pi, found.lateral_curvature_radius),
    ):
        along = np.array([math.cos(direction), math.sin(direction)])
        assert tensor @ along == pytest.approx(along / radius, rel=1e-10, abs=1e-10 * np.max(tensor))


def test_raceways():
    """Harris: a ball in a groove of 0.52 times its diameter; the sum of curvatures is that of the four radii."""
    ball, groove, ring = 6e-3, 0.52 * 12e-3, 20e-3
    inner = wk.CurvedBodies.of((ball, ball), (ring, -groove))
    outer = wk.CurvedBodies.of((ball, ball), (-(ring + 2.0 * ball), -groove))
    assert 1.0 / inner.longitudinal_curvature_radius == pytest.approx(1.0 / ball + 1.0 / ring)
    assert 1.0 / outer.longitudinal_curvature_radius == pytest.approx(1.0 / ball - 1.0 / (ring + 2.0 * ball))
    assert inner.lateral_curvature_radius == pytest.approx(1.0 / (1.0 / ball - 1.0 / groove))
    assert wk.CurvedBodies.turn((ball, ball), (ring, -groove)) == 0.0


def test_pair():
    """A pair by its radii is the bodies together, in all that problems use."""
    pair, together = (
        wk.CurvedPair(6e-3, 6e-3, 20e-3, -6.24e-3, 0.2),
        wk.CurvedBodies.of((6e-3, 6e-3), (20e-3, -6.24e-3), 0.2),
    )
    assert pair.together == together
    for name in ("longitudinal_curvature_radius", "lateral_curvature_radius", "slenderness", "equivalent_radius"):
        assert getattr(pair, name) == getattr(together, name)
    medium = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, 1e9))
    found, expected = (wk.EllipticIndentation(each, medium, wk.Force(10.0)).solve() for each in (pair, together))
    assert (found.depth, found.lateral_semi_axis) == (expected.depth, expected.lateral_semi_axis)
    assert found.problem.bed.bodies == together
    assert wk.EllipticYieldOnset(pair, medium).solve().force == wk.EllipticYieldOnset(together, medium).solve().force
    beds = wk.EllipticFoundation(pair, medium), wk.EllipticFoundation(together, medium)
    for first, second in (beds, tuple(bed.turned for bed in beds)):
        assert first.tangential_stiffness(np.ones(1)) == second.tangential_stiffness(np.ones(1))
        assert first.notes == second.notes
    friction, creepage = wk.Coulomb(0.3), wk.Creepage(1e-3)
    rolled = [
        wk.SimplifiedRolling(each, medium, friction, creepage, wk.Force(10.0)).solve() for each in (pair, together)
    ]
    assert rolled[0].longitudinal_force == rolled[1].longitudinal_force
    assert rolled[0].validity == rolled[1].validity
    with pytest.raises(wk.InvalidInput, match="do not touch in a point"):
        wk.CurvedPair(6e-3, 6e-3, 20e-3, -6e-3)


def test_slopes_of_each_body():
    """A ball in a groove hardly wider than itself touches on much of its radius; the radii together hide that."""
    medium = wk.HalfSpace.between(wk.Elastic(210e9, 0.3))

    def note(bodies):
        notes = wk.EllipticIndentation(bodies, medium, wk.Force(500.0)).solve().validity
        return next(each for each in notes if each.assumption is wk.Assumption.SMALL_SLOPES)

    straight, turned = wk.CurvedPair(5e-3, 5e-3, 26e-3, -5.2e-3), wk.CurvedPair(26e-3, -5.2e-3, 5e-3, 5e-3, 0.4)
    for pair in (straight, turned):
        assert pair.steepest_slope(1e-4, 1e-3) == pytest.approx(0.2, rel=1e-12)
        assert note(pair).standing is wk.Standing.APPROXIMATE
    assert note(straight.together).standing is wk.Standing.APPROXIMATE
    assert "For a ball in a groove the slope of the bodies would be up to 0.212" in note(straight.together).statement
    crossed = wk.CurvedPair(20e-3, math.inf, math.inf, 10e-3)
    assert {note(crossed).standing, note(crossed.together).standing} == {wk.Standing.ASYMPTOTIC}
    across = wk.CurvedPair(math.inf, 1e-2, math.inf, 2e-2, 0.3)
    x, y = (np.array([math.cos(across.turn - t), math.sin(across.turn - t)]) for t in (0.0, -0.5 * math.pi))
    rim = np.linspace(0.0, 2.0 * math.pi, 4001)
    places = 3e-4 * np.cos(rim) * x[:, None] + 1e-4 * np.sin(rim) * y[:, None]
    own, normal = np.diag([0.0, 1e2]), np.array([-math.sin(0.3), math.cos(0.3)])
    other = 5e1 * np.outer(normal, normal)
    steepest = max(np.max(np.linalg.norm(tensor @ places, axis=0)) for tensor in (own, other, own + other))
    assert across.steepest_slope(3e-4, 1e-4) == pytest.approx(steepest, rel=1e-6)
    assert steepest == pytest.approx(across.together.steepest_slope(3e-4, 1e-4), rel=1e-6)
    assert across.turn == wk.CurvedBodies.turn((math.inf, 1e-2), (math.inf, 2e-2), 0.3)


def test_a_conforming_groove_is_narrower_by_a_quarter_of_the_square_of_its_slope():
    """Persson's groove of one solid, in the form of Ciavarella and Decuzzi.

    E1* dR/Q over b, the tangent of half the angle of contact, is 8/(pi angle^2) of Hertz where that is small.  The ball
    of the bearing among the examples has a slope of 0.225 under 500 N: its error lies between a hundredth and a tenth,
    as of what is approximate; up to 0.1 it is far below a hundredth.
    """

    def angle(hertz):
        load, low, high = 8.0 / (math.pi * hertz**2), 0.5 * hertz, hertz
        for _ in range(60):
            b2 = math.tan(0.25 * (low + high)) ** 2
            more = (2.0 - math.log1p(b2) - 2.0 * b2**2) / (math.pi * (1.0 + b2) * b2) > load
            low, high = (0.5 * (low + high), high) if more else (low, 0.5 * (low + high))
        return low

    for slope in (0.05, 0.1, 0.2247):
        assert 1.0 - angle(slope) / slope == pytest.approx(0.25 * slope**2, rel=0.1)
    assert 0.01 < 1.0 - angle(0.2247) / 0.2247 < 0.1
    assert 1.0 - angle(0.1) / 0.1 < 0.003


def test_slopes_beyond_the_theory():
    medium = wk.HalfSpace.between(wk.Elastic(1e6, 0.3))
    notes = wk.EllipticIndentation(wk.CurvedBodies(1e-3, 2e-3), medium, wk.Depth(2e-3)).solve().validity
    standing = next(each.standing for each in notes if each.assumption is wk.Assumption.SMALL_SLOPES)
    assert standing is wk.Standing.OUTSIDE


@pytest.mark.parametrize("groove", [6e-3, 5.9e-3])
def test_hollow_as_narrow_as_the_ball(groove):
    with pytest.raises(wk.InvalidInput, match="give a hollow wider than the body in it"):
        wk.CurvedBodies.of((6e-3, 6e-3), (20e-3, -groove))


@pytest.mark.parametrize("angle", [1e-2, 1e-4, 1e-6])
def test_cylinders_that_cross_at_a_small_angle(angle):
    """The curvatures add up to k1 + k2 and multiply to k1 k2 sin^2: the smaller one keeps its digits."""
    bodies = wk.CurvedBodies.of((math.inf, 0.01), (math.inf, 0.02), angle)
    with mpmath.workdps(40):
        whole, product = 150, 5000 * mpmath.sin(mpmath.mpf(angle)) ** 2
        smaller = 2 * product / (whole + mpmath.sqrt(whole**2 - 4 * product))
        assert bodies.longitudinal_curvature_radius == pytest.approx(float(1 / smaller), rel=1e-14)
        assert bodies.lateral_curvature_radius == pytest.approx(float(1 / (whole - smaller)), rel=1e-14)


def test_parallel_cylinders_touch_along_a_line():
    with pytest.raises(wk.InvalidInput, match="touch along a line to LineFoundation"):
        wk.CurvedPair(math.inf, 0.01, math.inf, 0.02)


def test_bad_radii():
    for radii in ((0.0, 1.0), (math.nan, 1.0), (1.0,), "ab", 1.0, (None, 1.0), ("1", "2")):
        with pytest.raises(wk.InvalidInput, match="two numbers other than zero"):
            wk.CurvedBodies.of(radii, (1.0, 1.0))
    for angle in (math.inf, "a", None):
        with pytest.raises(wk.InvalidInput, match="in radians"):
            wk.CurvedBodies.of((1.0, 1.0), (1.0, 1.0), angle)
