"""Cylinders that roll on bodies graded with depth: independent numbers, limits, layers, energy, refinement, ghosts."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from graded_ghost import Ghost
from rolling_of_layers import RollingOnGrading, free_creepage_on_grading
from slip_of_gradings import compliance

import winkler as wk
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.problems.line_rolling.rolled_strip import creepage_error, loss_error, rolled_strip

MU, NU = 0.4, 0.3
YOUNG = 1.0 - NU**2
"""E* = 1 of the surface under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)
CASES = [(contrast, a) for contrast in (0.1, 10.0) for a in (0.3, 3.0, 10.0)]


def graded(contrast, scale=1.0, second=None, tolerance=1e-6):
    grading = wk.ExponentialGrading(YOUNG, contrast * YOUNG, depth_scale=scale, poisson=NU)
    return LayeredLineFoundation(CYLINDER, wk.DepthGradedHalfSpace(grading, second or wk.Rigid(), tolerance=tolerance))


def young(contrast):
    return lambda z: YOUNG * (contrast + (1.0 - contrast) * np.exp(-z))


def rolled(bed, a, used, mu=MU, coupled=False):
    """Under this share of what friction bears."""
    load = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
    drive = wk.LineShearForce(np.asarray(used) * mu * load)
    return wk.LineRolling(bed, wk.Coulomb(mu), drive, wk.HalfWidth(a), coupled=coupled).solve()


@functools.cache
def by_equations(contrast, a):
    return RollingOnGrading(young(contrast), NU, 25.0, a, 0.6 * a, 480 if contrast * a > 3.0 else 120)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_a_cylinder_rolls_as_singular_integral_equations_say(contrast, a):
    """Creepage and stick, steadily and after some widths without what the pressure drags, which they leave out."""
    expected, bed = by_equations(contrast, a), graded(contrast)
    close = 2e-3 if contrast * a > 3.0 else 3e-4
    found = rolled(bed, a, expected.force / expected.load)
    assert found.longitudinal_creepage == pytest.approx(MU * expected.creepage, rel=close)
    assert found.stick_share == pytest.approx(0.6, abs=3e-3)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(LayeredLineFoundation, "drawn", lambda self, x, half_width: np.zeros(x.shape))
        pull = wk.LineShearForce(MU * expected.force)
        begun = wk.LineRollingStart(bed, wk.Coulomb(MU), pull, wk.HalfWidth(a), distance=8.0 * a, points=1).solve()
    assert begun.longitudinal_creepage[-1] == pytest.approx(MU * expected.creepage, rel=4e-3)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("contrast", "a"), CASES[:5])
def test_free_cylinders_creep_as_the_coupling_of_the_grading_says(contrast, a):
    """With hardly any friction, steadily and after some widths: half of the load slips to either side.

    Not a wide strip on a stiff depth, at whose edges the equations lose digits of the pressure.
    """
    expected = free_creepage_on_grading(young(contrast), NU, 25.0, a, 480 if contrast * a > 3.0 else 120)
    bed = graded(contrast)
    assert rolled(bed, a, 0.0, 1e-4, coupled=True).longitudinal_creepage == pytest.approx(expected, rel=3e-3)
    begun = wk.LineRollingStart(
        bed, wk.Coulomb(1e-4), wk.LineShearForce(0.0), wk.HalfWidth(a), distance=6.0 * a, points=1
    )
    assert begun.solve().longitudinal_creepage[-1] == pytest.approx(expected, rel=6e-3)


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_waves_are_those_of_the_equation_of_riccati(contrast):
    """Under pressures, under shear along them, and what pressures draw along, of which the sign counts."""
    bed, short = graded(contrast), 2.0 * YOUNG / young(contrast)(0.0)
    xi = np.array([0.03, 0.3, 1.0, 3.0, 30.0])
    found = np.array([compliance(young(contrast), NU, 25.0, k) for k in xi]) / short
    mismatch = 0.5 * (1.0 - 2.0 * NU) / (1.0 - NU)
    for name, i, j, level, sign in (
        ("", 1, 1, 1.0, -1.0),
        ("along_", 0, 0, 1.0, -1.0),
        ("coupling_", 0, 1, mismatch, 1),
    ):
        ours = getattr(bed.medium, f"{name}response").excess(xi)
        np.testing.assert_allclose(ours, sign * found[:, i, j] - level, atol=3e-6)


@pytest.mark.parametrize("coupled", [False, True])
def test_a_body_that_does_not_change_rolls_as_a_half_plane(coupled):
    other = wk.Elastic(0.5, 0.1)
    plain = wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(YOUNG, NU), other))
    ours, half = (rolled(bed, 2.0, [0.3, -0.8], coupled=coupled) for bed in (graded(1.0, second=other), plain))
    close = 1e-8 if coupled else 5e-5
    np.testing.assert_allclose(ours.longitudinal_creepage, half.longitudinal_creepage, rtol=close)
    np.testing.assert_allclose(ours.loss_per_area, half.loss_per_area, rtol=close)


@pytest.mark.slow
def test_the_depth_is_felt_and_decides_under_a_thin_grading():
    """At a = 3 depth scales; what differs from the half-plane of the deep body falls with the depth scale."""

    def creepage(bed):
        return rolled(bed, 1.0, 0.5).longitudinal_creepage

    assert creepage(graded(0.1, 1.0 / 3.0)) < 0.7 * creepage(graded(0.5, 1.0 / 3.0))
    base = MU * (1.0 - np.sqrt(0.5))
    away = [abs(creepage(graded(0.8, scale)) / base - 1.0) for scale in (0.04, 0.02, 0.01)]
    assert away[2] < 0.7 * away[1] < 0.5 * away[0] < 0.05


@pytest.mark.few(1, slow=1)
@pytest.mark.parametrize(("coupled", "used"), [(False, 0.5), (True, 0.5), (True, -0.5)])
def test_what_gradings_lose_is_what_drives_them(coupled, used):
    """The creepage times the force, and the moment of the pressure."""
    found = rolled(graded(0.1), 3.0, used, coupled=coupled)
    (strip,) = found.strips
    moment = 3.0 * np.trapezoid(strip.pressure * strip.x, strip.x)
    assert strip.loss == pytest.approx(strip.creepage * strip.force + moment, rel=1e-4)
    assert strip.loss == pytest.approx(strip.creepage * strip.force + moment, abs=loss_error(strip, 3.0))


@pytest.mark.slow
@pytest.mark.parametrize("coupled", [False, True])
def test_the_stated_error_holds_against_finer_elements(coupled):
    bed = graded(0.2, second=wk.Elastic(2.0, 0.1))
    force = 0.4 * MU * float(bed.load_profile(np.array([2.0]))[0]) / 2.0
    strip, finer = (rolled_strip(bed, 2.0, MU, force=force, coupled=coupled, count=count) for count in (400, 800))
    assert abs(strip.creepage - finer.creepage) * 4.0 / 3.0 <= creepage_error(strip) * abs(finer.creepage)
    assert abs(strip.loss - finer.loss) * 4.0 / 3.0 <= loss_error(strip, 2.0)


@pytest.mark.slow
def test_a_grading_of_no_family_rolls_with_the_same_numbers():
    known = graded(10.0)
    ghost = LayeredLineFoundation(CYLINDER, Ghost(known.medium))
    creepages = [rolled(bed, 1.0, 0.5, coupled=True).longitudinal_creepage for bed in (known, ghost)]
    assert creepages[0] == creepages[1]
