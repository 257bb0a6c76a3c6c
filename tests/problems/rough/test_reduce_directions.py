"""Springs of height maps along x and along y: Mindlin's stiffness of ellipses, and loops in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import EllipticOutline
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.surfaces.punched_grid import stuck_stiffness
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.reduce import reduce
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity

UNIT = HalfSpace(Elastic(1.0, 0.3))
COUNT = 95


def places(count=COUNT):
    x = (np.arange(count) - (count - 1) / 2) / count
    return x[:, None], x[None, :]


def curved(a, b, count=COUNT):
    """Return the map of a x^2 + b y^2."""
    x, y = places(count)
    return Topography(-a * x**2 - b * y**2, [1.0, 1.0])


@pytest.mark.parametrize("slenderness", [1.0, 0.5, 3.0])
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_ellipses_without_slip_are_as_stiff_as_mindlins(slenderness, poisson):
    """K_x/k = 1/(1 + 2 s (E*/G* - 1)) with elliptic integrals; pixels of 1/40 of the larger semi-axis."""
    medium = HalfSpace(Elastic(1.0, poisson))
    pixel = 1.0 / 40.0
    x = (np.arange(90) - 44.5) * pixel
    along, across = (1.0, slenderness) if slenderness <= 1.0 else (1.0 / slenderness, 1.0)
    touching = (x[:, None] / along) ** 2 + (x[None, :] / across) ** 2 < 1.0
    found = stuck_stiffness(touching, (pixel, pixel), compliance_of(medium))
    smooth = stuck_stiffness(touching, (pixel, pixel), compliance_of(HalfSpace(Elastic(1.0, 0.0))))
    share, softer = EllipticOutline(slenderness).shear_share, medium.modulus / medium.shear_modulus - 1.0
    # on bodies of Poisson's ratio zero both directions are as stiff as the normal one
    assert found[0] / smooth[0] == pytest.approx(1.0 / (1.0 + 2.0 * share * softer), rel=2e-3)
    assert found[1] / smooth[1] == pytest.approx(1.0 / (1.0 + 2.0 * (1.0 - share) * softer), rel=2e-3)


def test_oblong_pixels_and_turned_contacts_are_as_stiff():
    x = (np.arange(60) - 29.5) / 25.0
    y = (np.arange(120) - 59.5) / 50.0
    touching = x[:, None] ** 2 + (y[None, :] / 0.5) ** 2 < 1.0
    compliance = compliance_of(UNIT)
    one = stuck_stiffness(touching, (1 / 25, 1 / 50), compliance)
    two = stuck_stiffness(touching.T, (1 / 50, 1 / 25), compliance)
    assert one == pytest.approx(two[::-1], rel=1e-4)  # each to the square of the tolerance
    square = (np.arange(120) - 59.5) / 50.0
    fine = stuck_stiffness(square[:, None] ** 2 + (square[None, :] / 0.5) ** 2 < 1.0, (1 / 50, 1 / 50), compliance)
    assert one == pytest.approx(fine, rel=1e-2)


@pytest.mark.slow
def test_an_ellipse_sheared_along_both_axes_runs_as_its_own_springs():
    """Loops of `EllipticFoundation`, whose stiffnesses are elliptic integrals, on the springs of a map."""
    bed = reduce(curved(0.25, 0.75), UNIT, 0.04)
    own = wk.EllipticFoundation(CurvedBodies(2.0, 2.0 / 3.0), UNIT)
    shifts = 0.04 * 0.3 * np.array([0.0, 0.6, -0.3, 0.5])
    path = wk.Path([0.0, 1.0, 2.0, 3.0], wk.Depth(0.035), wk.Shift(shifts))
    for mapped, closed in ((bed, own), (bed.turned, own.turned)):
        found, expected = (wk.Tangential(b, wk.Coulomb(0.3), path).solve() for b in (mapped, closed))
        assert found.shear_force == pytest.approx(expected.shear_force, rel=5e-3)
        assert found.dissipation[1:] == pytest.approx(expected.dissipation[1:], rel=1e-2)
    assert bed.turned.turned == bed


def ratioed(along, across):
    """Return springs under a ball with given ratios along and across."""
    radii = np.geomspace(1e-3, 1.0, 61)
    return DirectionalBed(radii, 2.0 * radii, radii**2, ratios_along=along(radii), ratios_across=across(radii))


def test_the_stiffness_of_all_springs_is_that_of_the_contact():
    """The integral of 2 c_T up to a is K_x(a), also where the ratio changes with the radius."""
    bed = ratioed(lambda a: 0.8 + 0.1 * a, lambda a: 0.9 - 0.05 * a)
    x = (np.arange(20000) + 0.5) / 20000.0
    for stated, ratio in ((bed, 0.9), (bed.turned, 0.85)):
        assert 2.0 * np.mean(stated.tangential_stiffness(x)) == pytest.approx(2.0 * ratio, rel=1e-4)


def test_partial_slip_meets_the_stiffness_of_the_contact_that_sticks():
    """dF/du under rising shift is K_x of the radius of stick, and u = mu times the sum of dd/r since; all at mu F_N."""
    bed = ratioed(lambda a: 0.8 + 0.1 * a, lambda a: 0.9 + 0.0 * a)
    shifts = np.linspace(0.0, 0.5, 401)
    pushed = wk.Tangential(bed, wk.Coulomb(0.3), wk.Path(np.arange(401.0), wk.Depth(0.9), wk.Shift(shifts))).solve()
    slope = np.gradient(pushed.shear_force, shifts)[40:160]
    sticks = pushed.stick_radius[40:160]
    assert slope == pytest.approx(2.0 * sticks * (0.8 + 0.1 * sticks), rel=2e-2)
    assert pushed.shear_force[-1] == pytest.approx(0.3 * pushed.force[-1], rel=1e-5)  # the depths are summed
    assert pushed.force[-1] == pytest.approx(4.0 / 3.0 * 0.9**1.5, rel=1e-6)
    # d = a^2: the sum of 2 a da / (0.8 + 0.1 a) from the radius of stick on
    inner, outer = (20.0 * (a - 8.0 * np.log(0.8 + 0.1 * a)) for a in (sticks, np.sqrt(0.9)))
    assert shifts[40:160] == pytest.approx(0.3 * (outer - inner), rel=1e-4)


def test_springs_one_by_one_agree_with_those_by_their_gap():
    bed = ratioed(lambda a: 0.8 + 0.1 * a, lambda a: 0.9 + 0.0 * a)
    path = wk.Path(np.arange(5.0), wk.Depth([0.5, 0.9, 0.7, 0.8, 0.6]), wk.Shift([0.0, 0.1, -0.1, 0.05, 0.1]))
    one, two = (
        wk.Tangential(bed, wk.Coulomb(0.3), path).solve(),
        wk.Tangential(bed, wk.Coulomb(0.3), path, wk.Method.SPRINGS, 2000).solve(),
    )
    assert one.shear_force == pytest.approx(two.shear_force, abs=3e-4)
    assert one.dissipation == pytest.approx(two.dissipation, abs=3e-4)


def test_bodies_of_poissons_ratio_zero_need_no_solution():
    bed = reduce(curved(0.25, 0.75), HalfSpace(Elastic(1.0, 0.0)), 0.04)
    assert np.all(bed.ratios_along == 1.0)
    assert np.all(bed.ratios_across == 1.0)


def test_wrong_springs_and_paths_in_the_plane_are_refused():
    bed = ratioed(lambda a: 0.8 + 0.0 * a, lambda a: 0.9 + 0.0 * a)
    path = wk.Path([0.0, 1.0], wk.Depth(0.5), wk.Shift(np.array([[0.0, 0.0], [0.1, 0.1]])))
    with pytest.raises(OutsideValidity, match="along x and along y, by 12 %"):
        wk.Tangential(bed, wk.Coulomb(0.3), path)
    with pytest.raises(InvalidInput, match="give one of each for each radius"):
        DirectionalBed(bed.radii, bed.stiffnesses, bed.depths, ratios_along=np.ones(7), ratios_across=np.ones(7))
    even = ratioed(lambda a: 0.8 + 0.0 * a, lambda a: 0.8 + 0.0 * a)
    assert math.isfinite(wk.Tangential(even, wk.Coulomb(0.3), path).solve().shear_force[-1, 0])
