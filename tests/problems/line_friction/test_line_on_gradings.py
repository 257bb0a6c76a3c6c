"""Lines on bodies graded with depth: independent numbers, half-planes as limits, layers, ghosts, refusals."""

from __future__ import annotations

import numpy as np
import pytest
from graded_ghost import Ghost
from scipy.special import jv
from slip_of_gradings import SlippingOnGrading

import winkler as wk
from winkler.numerics.transforms.strips.strip_modes import far_sides

MU, NU = 0.4, 0.3
YOUNG = 1.0 - NU**2
"""E* = 1 of the surface under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)


def graded(contrast, scale=1.0, tolerance=1e-6):
    grading = wk.ExponentialGrading(YOUNG, contrast * YOUNG, depth_scale=scale, poisson=NU)
    return wk.LayeredLineFoundation(CYLINDER, wk.DepthGradedHalfSpace(grading, tolerance=tolerance))


def load(bed, a):
    return bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])


@pytest.mark.parametrize(
    ("contrast", "a", "expected"),
    [(0.1, 0.3, 0.0529467647), (0.1, 3.0, 1.7046551), (0.1, 10.0, 11.571585), (10.0, 0.3, 0.15770272)],
)
def test_loads_are_those_of_singular_integral_equations(contrast, a, expected):
    """By `SlippingOnGrading` with 60 and 120 places, extrapolated."""
    assert load(graded(contrast), a) == pytest.approx(expected, rel=2e-6)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_cylinder_slips_as_singular_integral_equations_say(contrast, a):
    """Force, stick and loss; the pressure follows a stiff depth closely at its edge, which costs places there."""
    wide = contrast * a > 3.0

    def young(z):
        return YOUNG * (contrast + (1.0 - contrast) * np.exp(-z))

    expected = SlippingOnGrading(young, NU, 25.0, a, 0.7 * a, 480 if wide else 120)
    bed = graded(contrast)
    assert load(bed, a) == pytest.approx(expected.load, rel=4e-4 if wide else 1e-5)
    found = wk.LineTangential(bed, wk.Coulomb(MU), wk.LinePath(load(bed, a), [0.0, MU * expected.shear])).solve()
    assert found.stick_half_width[-1] == pytest.approx(0.7 * a, rel=1e-3)
    assert found.dissipation_per_length[-1] == pytest.approx(MU**2 * expected.loss(), rel=6e-3 if wide else 2e-4)


@pytest.mark.slow
def test_the_base_is_felt_and_a_thin_grading_is_forgotten():
    """At a = 3 depth scales, and towards a half-plane of the deep body by as much as the grading is thick."""
    assert load(graded(0.1), 3.0) < 0.5 * load(graded(0.5), 3.0)
    deep = wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(10.0 * YOUNG, NU)))
    missing = [1.0 - load(graded(10.0, scale), 1.0) / load(deep, 1.0) for scale in (0.02, 0.01, 0.005)]
    falling = np.array(missing[1:]) / missing[:2]
    assert np.all((falling > 0.5) & (falling < 0.6))  # h, but for a logarithm
    assert falling[1] < falling[0]
    assert missing[-1] < 0.03


def test_a_body_that_does_not_change_is_a_half_plane():
    plain = wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(YOUNG, NU)))
    assert load(graded(1.0), 2.0) == pytest.approx(load(plain, 2.0), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_the_tolerance_bounds_what_a_line_bears(contrast):
    finest = load(graded(contrast, tolerance=1e-7), 1.0)
    for tolerance in (1e-2, 1e-4):
        assert abs(load(graded(contrast, tolerance=tolerance), 1.0) / finest - 1.0) < tolerance


def test_load_and_slope_belong_together():
    bed, step = graded(10.0), 1e-3
    slope = (load(bed, 1.0 + step) - load(bed, 1.0 - step)) / (2.0 * step)
    assert slope == pytest.approx(bed.medium.modulus * float(bed.load_profile_slope(np.array([1.0]))[0]), rel=1e-2)


@pytest.mark.slow
def test_the_approach_is_that_of_many_layers():
    """Of twice as many layers the error is a fourth; counted from a point below the grading."""
    bed, edges, found = graded(0.1), np.linspace(0.0, 14.0, 141), []
    for cuts in (edges[::2], edges):
        middles = 0.5 * (cuts[1:] + cuts[:-1])
        layers = [
            wk.Layer(wk.Elastic(float(bed.medium.grading.young_at(z)), NU), float(h))
            for z, h in zip(middles, np.diff(cuts), strict=True)
        ]
        stack = wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, wk.Elastic(0.1 * YOUNG, NU)))
        found.append(wk.LineIndentation(stack, wk.HalfWidth(3.0)).solve().approach(20.0))
    expected = wk.LineIndentation(bed, wk.HalfWidth(3.0)).solve().approach(20.0)
    assert (4.0 * found[1] - found[0]) / 3.0 == pytest.approx(expected, rel=1e-4)


def test_bessel_functions_far_out_meet_their_average():
    argument = 400.0 + np.pi * (np.arange(64) + 0.5) / 64.0
    cosine, sine = far_sides(np.array([400.0 + 0.5 * np.pi]), np.array([0.0, 10.0, 40.0]))[:, :, 0]
    for m, first in enumerate((0, 10, 40)):
        for n, second in enumerate((0, 10, 40)):
            mean = np.mean(jv(first, argument) * jv(second, argument)) * (-1.0) ** ((first + second) // 2)
            assert cosine[m] * cosine[n] + sine[m] * sine[n] == pytest.approx(mean, abs=3e-2 / (np.pi * 400.0))


@pytest.mark.slow
def test_a_grading_of_no_family_gives_the_same_numbers():
    known = graded(10.0)
    ghost = wk.LayeredLineFoundation(CYLINDER, Ghost(known.medium))
    contacts = [wk.LineIndentation(bed, wk.LineForce(0.3)).solve() for bed in (known, ghost)]
    assert contacts[0].half_width == contacts[1].half_width
    assert contacts[0].approach(20.0) == contacts[1].approach(20.0)
    for contact in contacts:
        with pytest.raises(wk.OutsideValidity, match="layers that follow it"):
            contact.stresses(0.0, 0.1)
        with pytest.raises(wk.OutsideValidity, match="approach"):
            _ = contact.depth


def test_a_grading_has_no_single_strength():
    with pytest.raises(wk.InvalidInput, match="strength"):
        wk.LineYieldOnset(graded(10.0), wk.Coulomb(0.1)).solve()
