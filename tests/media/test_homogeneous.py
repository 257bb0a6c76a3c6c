"""Homogeneous half-spaces: effective moduli, symmetry, limits, refusals."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.media.halfspace import HomogeneousMedium
from winkler.values.value import value

STEEL, RUBBER = wk.Elastic(210e9, 0.3), wk.Elastic(1e6, 0.5)


def test_effective_moduli():
    """1/E* = sum (1 - nu^2)/E; 1/G* = sum (2 - nu)/(4 G)."""
    pair = wk.HalfSpace.between(STEEL, wk.Elastic(70e9, 0.33))
    assert pair.modulus == pytest.approx(1.0 / (0.91 / 210e9 + (1.0 - 0.33**2) / 70e9), rel=1e-15)
    shear = 1.0 / (1.7 / (4.0 * 210e9 / 2.6) + 1.67 / (4.0 * 70e9 / 2.66))
    assert pair.shear_modulus == pytest.approx(shear, rel=1e-15)


@pytest.mark.parametrize("poisson", [-0.9, 0.0, 0.3, 0.5])
def test_mindlins_ratio(poisson):
    """G*/E* = 2 (1 - nu)/(2 - nu) for one elastic body; E* = 2 G/(1 - nu)."""
    medium = wk.HalfSpace.between(wk.Elastic(1.0, poisson))
    assert medium.shear_modulus / medium.modulus == pytest.approx(2.0 * (1.0 - poisson) / (2.0 - poisson), rel=1e-14)
    assert medium.modulus == pytest.approx(2.0 * wk.Elastic(1.0, poisson).shear / (1.0 - poisson), rel=1e-14)
    equal = wk.HalfSpace.between(wk.Elastic(1.0, poisson), wk.Elastic(1.0, poisson))
    assert equal.modulus == pytest.approx(0.5 * medium.modulus, rel=1e-15)


def test_swapping_the_bodies_changes_nothing_but_a_sign():
    one, other = wk.HalfSpace.between(STEEL, RUBBER), wk.HalfSpace.between(RUBBER, STEEL)
    assert one.modulus == other.modulus
    assert one.shear_modulus == other.shear_modulus
    assert one.mismatch == pytest.approx(-other.mismatch)
    assert one != other


def test_the_rigid_limit():
    almost = wk.HalfSpace.between(RUBBER, wk.Elastic(1e24, 0.3))
    rigid = wk.HalfSpace.between(RUBBER)
    assert almost.modulus == pytest.approx(rigid.modulus, rel=1e-15)
    assert almost.shear_modulus == pytest.approx(rigid.shear_modulus, rel=1e-15)
    assert wk.HalfSpace(RUBBER) == wk.HalfSpace.between(RUBBER, wk.Rigid())
    assert wk.HalfSpace(wk.Rigid(), RUBBER).modulus == rigid.modulus


def test_dundurs():
    """beta = [(1 - 2 nu1)/G1 - (1 - 2 nu2)/G2] / (2 [(1 - nu1)/G1 + (1 - nu2)/G2])."""
    g1, g2 = STEEL.shear, 70e9 / 2.66
    beta = 0.5 * (0.4 / g1 - 0.34 / g2) / (0.7 / g1 + 0.67 / g2)
    assert wk.HalfSpace.between(STEEL, wk.Elastic(70e9, 0.33)).mismatch == pytest.approx(beta, rel=1e-14)
    assert wk.HalfSpace.between(STEEL, STEEL).mismatch == 0.0
    assert wk.HalfSpace.between(RUBBER).mismatch == 0.0
    assert wk.HalfSpace.between(wk.Elastic(1.0, 0.0)).mismatch == pytest.approx(0.5)
    assert wk.HalfSpace(wk.Rigid(), wk.Elastic(1.0, 0.0)).mismatch == pytest.approx(-0.5)


def test_springs_of_a_homogeneous_medium():
    medium = wk.HalfSpace.between(STEEL)
    x = np.array([[0.0, 1e-3]])
    np.testing.assert_array_equal(medium.normal_stiffness(x), np.full((1, 2), medium.modulus))
    np.testing.assert_array_equal(medium.tangential_stiffness(x), np.full((1, 2), medium.shear_modulus))
    np.testing.assert_allclose(medium.punch_stiffness(x), 2.0 * medium.modulus * x)
    profile = wk.Cone(1.2)
    np.testing.assert_array_equal(medium.gap(profile, x), profile.gap(x))
    np.testing.assert_allclose(medium.gap_load(profile, x), 2.0 * medium.modulus * profile.gap_integral(x))


def test_strengths():
    strong = wk.Elastic(1.0, 0.3, strength=2.0)
    assert wk.HalfSpace.between(strong).strengths == (2.0, math.inf)
    assert wk.HalfSpace.between(STEEL, strong).strengths == (math.inf, 2.0)


@pytest.mark.parametrize("bad", [None, 1.0, "steel", wk.TransverselyIsotropic(10.0, 4.0, 3.5, 12.0, 3.0)])
def test_what_is_no_body(bad):
    with pytest.raises(
        wk.InvalidInput, match=r"^HalfSpace: the first is a \w+; give Elastic\(young, poisson\) or Rigid\(\)\.$"
    ):
        wk.HalfSpace.between(bad)
    with pytest.raises(wk.InvalidInput, match=r"^HalfSpace: the second is a \w+"):
        wk.HalfSpace.between(STEEL, bad)


def test_two_rigid_bodies():
    with pytest.raises(wk.InvalidInput, match=r"^HalfSpace: both bodies are rigid; at least one must be Elastic"):
        wk.HalfSpace.between(wk.Rigid())
    with pytest.raises(wk.InvalidInput, match=r"^TransverselyIsotropicHalfSpace: both bodies are rigid"):
        wk.TransverselyIsotropicHalfSpace.between(wk.Rigid())


# ------------------------------------------------------------------------------------------- transversely isotropic


@pytest.mark.parametrize(
    ("stiffnesses", "modulus", "shear_modulus"),
    [
        ((10.0, 4.0, 3.5, 12.0, 3.0), 9.558861079, 7.110690701),
        ((5.0, 2.0, 2.2, 20.0, 1.2), 8.737080168, 3.324537596),
    ],
)
def test_numbers_of_the_theory_sheet(stiffnesses, modulus, shear_modulus):
    medium = wk.TransverselyIsotropicHalfSpace.between(wk.TransverselyIsotropic(*stiffnesses))
    assert medium.modulus == pytest.approx(modulus, rel=1e-9)
    assert medium.shear_modulus == pytest.approx(shear_modulus, rel=1e-9)


def surface_compliance(c11, c13, c33, c44):
    """1/E* from the plane problem itself: displacement of the surface under cos(x) pressure, at 30 digits.

    With u = A exp(-k z) sin x, w = B exp(-k z) cos x the equilibrium gives
    (c11 - c44 k^2)(c44 - c33 k^2) + (c13 + c44)^2 k^2 = 0.
    """
    with mp.workdps(40):
        c11, c13, c33, c44 = (mp.mpf(c) for c in (c11, c13, c33, c44))
        b = (c13 + c44) ** 2 - c11 * c33 - c44**2
        root = mp.sqrt(b**2 - 4 * c33 * c44 * c11 * c44)
        roots = [(-b + root) / (2 * c33 * c44), (-b - root) / (2 * c33 * c44)]
        k = [mp.sqrt(root) for root in roots]
        k = [value if mp.re(value) > 0 else -value for value in k]
        # (c11 - c44 k^2) A = (c13 + c44) k B up to sign: u' with sin, w with cos
        ratio = [(c13 + c44) * q / (c11 - c44 * q**2) for q in k]  # A/B
        # shear: c44 (-k A - B) = 0 summed; normal: c13 A - c33 k B = -1 (tension positive)
        shear = [-q * a - 1 for q, a in zip(k, ratio, strict=True)]
        normal = [c13 * a - c33 * q for q, a in zip(k, ratio, strict=True)]
        matrix = mp.matrix([[shear[0], shear[1]], [normal[0], normal[1]]])
        amplitude = mp.lu_solve(matrix, mp.matrix([0, -1]))
        return float(mp.re(amplitude[0] + amplitude[1]) / 2)  # w of a unit wave is 2/(E* k)


@pytest.mark.parametrize(
    "stiffnesses",
    [
        (10.0, 4.0, 3.5, 12.0, 3.0),
        (5.0, 2.0, 2.2, 20.0, 1.2),
        (20.0, 1.0, -2.0, 3.0, 4.0),
        (165e9, 31e9, 50e9, 62e9, 33e9),
    ],
)
def test_modulus_from_the_surface_wave(stiffnesses):
    """E* once more, by solving the equations of equilibrium under a cosine of pressure."""
    c11, _, c13, c33, c44 = stiffnesses
    medium = wk.TransverselyIsotropicHalfSpace.between(wk.TransverselyIsotropic(*stiffnesses))
    assert 1.0 / medium.modulus == pytest.approx(surface_compliance(c11, c13, c33, c44), rel=1e-9)


@pytest.mark.parametrize("poisson", [0.0, 0.2, 0.3, 0.45])
def test_the_isotropic_limit(poisson):
    young = 3.0
    lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    shear = young / (2.0 * (1.0 + poisson))
    solid = wk.TransverselyIsotropic(lame + 2.0 * shear, lame, lame, lame + 2.0 * shear, shear)
    medium, twin = wk.TransverselyIsotropicHalfSpace.between(solid), wk.HalfSpace.between(wk.Elastic(young, poisson))
    assert medium.modulus == pytest.approx(twin.modulus, rel=1e-13)
    assert medium.shear_modulus == pytest.approx(twin.shear_modulus, rel=1e-13)


def test_pairs_add_their_compliances():
    wood, steel = wk.TransverselyIsotropic(10.0, 4.0, 3.5, 12.0, 3.0), wk.Elastic(7.0, 0.3)
    pair = wk.TransverselyIsotropicHalfSpace.between(wood, steel)
    swapped = wk.TransverselyIsotropicHalfSpace.between(steel, wood)
    alone = wk.TransverselyIsotropicHalfSpace.between(wood)
    assert 1.0 / pair.modulus == pytest.approx(1.0 / alone.modulus + 0.91 / 7.0, rel=1e-14)
    assert pair.modulus == swapped.modulus
    assert pair.shear_modulus == swapped.shear_modulus
    with pytest.raises(wk.InvalidInput, match="TransverselyIsotropicHalfSpace: the second is a float"):
        wk.TransverselyIsotropicHalfSpace.between(wood, 1.0)


def test_a_sphere_on_graphite_is_hertz_with_another_modulus():
    graphite = wk.TransverselyIsotropicHalfSpace.between(wk.TransverselyIsotropic(1060e9, 180e9, 15e9, 36.5e9, 4.5e9))
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-6), graphite), wk.Force(1e-6)).solve()
    assert contact.radius == pytest.approx((0.75 * 1e-6 * 1e-6 / graphite.modulus) ** (1.0 / 3.0), rel=1e-14)
    assert any("transversely isotropic" in note.statement for note in contact.validity)


@value
class Moduli(HomogeneousMedium):
    """A medium of a user's own, as in docs/extending.md: two moduli, and no bodies."""

    modulus: float = 1.0
    shear_modulus: float = 2.0
    notes = ()


def test_a_modulus_that_a_medium_does_not_state_is_asked_for_in_one_sentence():
    bed = wk.LineFoundation(wk.Paraboloid(1.0), Moduli())
    path = wk.LinePath(1.0, [0.0, 0.1])
    with pytest.raises(wk.OutsideValidity, match="Moduli states no bodies .* `along_modulus`"):
        wk.LineTangential(bed, wk.Coulomb(0.5), path)
    with pytest.raises(wk.OutsideValidity, match="`torsional_modulus`"):
        _ = Moduli().torsional_modulus
    assert wk.LineIndentation(bed, wk.LineForce(1.0)).solve().half_width > 0.0
