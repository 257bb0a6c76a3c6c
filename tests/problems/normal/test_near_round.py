"""Nearly round bodies, against exact ellipses, pyramids and a square by boundary elements, and themselves."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.near_round import NearlyRoundIndentation
from winkler.profiles.conical import Cone
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.sphere import Sphere
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

ONE = HalfSpace(Elastic(1.0, 0.0))
TURNS = np.arange(64) * 2.0 * np.pi / 64


def oval(a, b):
    """Return A x^2 + B y^2, direction after direction."""
    return tuple(Paraboloid(float(0.5 / (a * np.cos(t) ** 2 + b * np.sin(t) ** 2))) for t in TURNS)


def off_the_middle(faces, per_face):
    """Return the angles of directions from the middle of their face."""
    turns = (np.arange(faces * per_face) + 0.5) * 2.0 * np.pi / (faces * per_face)
    return (turns + np.pi / faces) % (2.0 * np.pi / faces) - np.pi / faces


def pyramid(faces, per_face=40):
    return tuple(Cone(half_angle=float(np.arctan(1.0 / np.cos(angle)))) for angle in off_the_middle(faces, per_face))


def test_round_bodies_are_the_round_contact():
    ball = Paraboloid(0.5)
    result = NearlyRoundIndentation((ball,) * 8, ONE, Depth([0.01, 0.02])).solve()
    exact = Indentation(Foundation(ball, ONE), Depth([0.01, 0.02])).solve()
    assert result.force == pytest.approx(exact.force, rel=1e-10)
    assert result.stiffness == pytest.approx(exact.stiffness, rel=1e-10)
    assert result.contour == pytest.approx(np.tile(np.reshape(exact.radius, (2, 1)), 8), rel=1e-10)


def _shape(a, b):
    from scipy.optimize import brentq
    from scipy.special import ellipe, ellipk

    return brentq(lambda m: (ellipe(m) / (1 - m) - ellipk(m)) / (ellipk(m) - ellipe(m)) - b / a, 1e-6, 1 - 1e-9)


@pytest.mark.parametrize(
    ("a", "b", "force", "axes"),
    [(0.45, 0.55, 2e-6, 2e-3), (0.4, 0.6, 2e-5, 6e-3), (0.25, 0.75, 1.1e-3, 0.1)],
)
def test_ellipses(a, b, force, axes):
    """Theory 1.3: of Hertz's ellipses F is met to 1e-6, 1.6e-5, 1e-3, and the axes to .1, .6 and 9 per cent."""
    from scipy.special import ellipe, ellipk

    m = _shape(a, b)
    radius = (ellipk(m) - ellipe(m)) / (m * a)  # a^3 = 3 F (K - E) / (2 pi E* m A), d = 3 F K / (2 pi E* a)
    wide = math.sqrt(radius / ellipk(m) * 0.01)
    exact = 2.0 * np.pi * 0.01 * wide / (3.0 * ellipk(m))
    result = NearlyRoundIndentation(oval(a, b), ONE, Depth(0.01)).solve()
    assert result.force == pytest.approx(exact, rel=force)
    assert result.force > exact  # Barber's extremum: from above
    assert np.max(result.contour) == pytest.approx(wide, rel=axes)
    assert np.min(result.contour) == pytest.approx(wide * math.sqrt(1.0 - m), rel=axes)


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("faces", "expected", "exact", "off"),
    [(3, 0.8480, 0.8824, 0.041), (4, 0.7243, 0.737617, 0.019), (6, 0.6694, 0.6733, 0.007)],
)
def test_pyramids(faces, expected, exact, off):
    """Theory 1.3: this theory's number, and boundary elements, from which it is that far."""
    result = NearlyRoundIndentation(pyramid(faces), ONE, Depth(0.01)).solve()
    assert result.force / 0.01**2 == pytest.approx(expected, rel=7e-4 if faces == 3 else 3e-4)
    assert result.force / 0.01**2 == pytest.approx(exact, rel=off)
    assert result.validity[-1].standing is Standing.APPROXIMATE


def test_a_flat_square_is_pinned_at_its_rim():
    """k = 2 E* <a^2> / <a>, 1.5 per cent below the 1.15229 E* L of boundary elements (theory 1.3)."""
    square = tuple(FlatPunch(float(0.5 / np.cos(angle))) for angle in off_the_middle(4, 200))
    result = NearlyRoundIndentation(square, ONE, Force([0.1, 0.2])).solve()
    closed = 2.0 / math.pi / (4.0 / math.pi * math.log(1.0 + math.sqrt(2.0)) * 0.5)
    assert result.stiffness == pytest.approx([closed, closed], rel=1e-4)
    assert result.depth == pytest.approx(np.array([0.1, 0.2]) / closed, rel=1e-4)
    assert closed == pytest.approx(1.15229, rel=0.016)


@pytest.mark.parametrize("exponent", [1.0, 2.0, 3.0])
def test_small_deviations_to_first_order(exponent):
    """g_0' da = -dg - (1/a) int dg dx (theory 1.3): f = c r^n (1 + e cos 2 phi) has da = -e a (n + 2) / (n (n + 1))."""
    small = 1e-4
    body = tuple(PowerLaw(float(1.0 + small * np.cos(2.0 * t)), exponent) for t in TURNS)
    result = NearlyRoundIndentation(body, ONE, Depth(0.01)).solve()
    mean = float(np.mean(result.contour))
    wave = 2.0 * float(np.mean((result.contour / mean - 1.0) * np.cos(2.0 * TURNS))) / small
    assert wave == pytest.approx(-(exponent + 2.0) / (exponent * (exponent + 1.0)), rel=2e-4)
    smooth = Indentation(Foundation(PowerLaw(1.0, exponent), ONE), Depth(0.01)).solve()
    assert result.force == pytest.approx(smooth.force, rel=1e-7)  # the force deviates in second order only


def test_forces_scale_like_the_body():
    """f ~ r^n: F ~ d^(1 + 1/n), and the contour grows without changing its shape."""
    result = NearlyRoundIndentation(oval(0.3, 0.7), ONE, Depth([1e-4, 1e-2])).solve()
    assert result.force[1] / result.force[0] == pytest.approx(1e3, rel=1e-10)
    assert result.contour[1] / result.contour[0] == pytest.approx(10.0, rel=1e-10)


def test_the_stiffness_is_the_slope_of_the_force():
    body = oval(0.4, 0.6)
    forces = NearlyRoundIndentation(body, ONE, Depth([0.00999, 0.01001])).solve().force
    stiffness = NearlyRoundIndentation(body, ONE, Depth(0.01)).solve().stiffness
    assert (forces[1] - forces[0]) / 2e-5 == pytest.approx(stiffness, rel=1e-6)


def test_forces_and_depths_are_two_sides_of_one_curve():
    body = tuple(Sphere(radius) for radius in (1.1, 1.0, 0.9, 1.0) * 2)
    depths = np.array([[1e-5], [1e-2]])
    by_depth = NearlyRoundIndentation(body, ONE, Depth(depths)).solve()
    by_force = NearlyRoundIndentation(body, ONE, Force(by_depth.force)).solve()
    assert by_force.depth == pytest.approx(depths, rel=1e-10)
    assert by_force.contour == pytest.approx(by_depth.contour, rel=1e-7)
    assert by_force.contour.shape == (2, 1, 8)
    assert isinstance(NearlyRoundIndentation(body, ONE, Force(1e-3)).solve().depth, float)


def test_how_far_from_round_is_stated():
    for body, statements in ((oval(0.4, 0.6), "at most 0.1"), (pyramid(3, 12), "at most 4")):
        assert statements in NearlyRoundIndentation(body, ONE, Depth(0.01)).solve().validity[-1].statement


def test_what_is_far_from_round_is_refused():
    with pytest.raises(OutsideValidity, match="too far from round; use SurfaceContact"):
        NearlyRoundIndentation(oval(0.1, 0.9), ONE, Depth(0.01)).solve()
    with pytest.raises(OutsideValidity, match="leads beyond the reach"):
        NearlyRoundIndentation((Sphere(1.0),) * 4, ONE, Force(1e6)).solve()


@pytest.mark.parametrize(
    ("numbers", "sentence"),
    [
        ({"profiles": oval(0.4, 0.6)[:3]}, "at least four"),
        ({"medium": "steel"}, "medium is a str"),
        ({"load": Depth(-1.0)}, "positive Force or Depth"),
        ({"load": Radius(1.0)}, "positive Force or Depth"),
    ],
)
def test_wrong_questions_are_refused(numbers, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        NearlyRoundIndentation(**({"profiles": oval(0.4, 0.6), "medium": ONE, "load": Depth(0.01)} | numbers))
