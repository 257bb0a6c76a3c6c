"""Onset of yield against Johnson's numbers, scaling, and where there is no solution."""

from __future__ import annotations

import math
import re

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

E, Y, R = 210e9, 1.2e9, 10e-3


def bed(profile, poisson=0.3, strength=Y, second=None):
    first = wk.Elastic(E, poisson, strength=strength)
    return wk.Foundation(profile, wk.HalfSpace.between(first, second or wk.Rigid()))


def axis_peak(poisson):
    """Largest von Mises stress on the axis of a Hertz contact over p0, and its depth over a (Huber)."""
    nu = mp.mpf(poisson)

    def stress(z):
        axial = -1 / (1 + z**2)
        radial = -(1 + nu) * (1 - z * mp.atan(1 / z)) + 1 / (2 * (1 + z**2))
        return abs(axial - radial)

    place = mp.findroot(lambda z: mp.diff(stress, z), mp.mpf("0.45"))
    return float(stress(place)), float(place)


@pytest.mark.parametrize("poisson", [0.1, 0.25, 0.3, 0.4, 0.5])
def test_hertz(poisson):
    """p0 = Y / (largest von Mises stress per p0), on the axis."""
    onset = wk.YieldOnset(bed(wk.Paraboloid(R), poisson)).solve()
    peak, depth = axis_peak(poisson)
    modulus = E / (1.0 - poisson**2)
    p0 = 2.0 * modulus * onset.radius / (math.pi * R)
    assert p0 == pytest.approx(Y / peak, rel=1e-8)
    assert onset.force == pytest.approx(math.pi**3 * R**2 / (6.0 * modulus**2) * (Y / peak) ** 3, rel=1e-8)
    assert onset.depth == pytest.approx(onset.radius**2 / R, rel=1e-12)
    assert onset.r == pytest.approx(0.0, abs=1e-4 * onset.radius)
    assert onset.z == pytest.approx(depth * onset.radius, rel=1e-3)


def test_johnson():
    """nu = 0.3: max tau = 0.310 p0 at 0.48 a, so p0 = 1.60 Y and F = 21.2 R^2 Y^3/E*^2."""
    onset = wk.YieldOnset(bed(wk.Paraboloid(R))).solve()
    modulus = E / 0.91
    p0 = 2.0 * modulus * onset.radius / (math.pi * R)
    assert p0 / Y == pytest.approx(1.60, abs=0.02)
    assert p0 / Y == pytest.approx(0.5 / 0.310020502, rel=1e-7)
    assert onset.z / onset.radius == pytest.approx(0.4808644853, rel=1e-4)
    assert onset.force == pytest.approx(21.2 * R**2 * Y**3 / modulus**2, rel=0.05)
    assert any("von Mises" in note.statement for note in onset.validity)


@pytest.mark.slow
def test_the_stress_there_is_the_strength():
    """Found independently: restore the fields at the load of the onset."""
    for profile in (wk.Sphere(1e-3), wk.RoundedCone(1e-4, 1.45), wk.RoundedPunch(1e-3, 1e-2), wk.PowerLaw(1e4, 3.0)):
        onset = wk.YieldOnset(bed(profile)).solve()
        contact = wk.Indentation(bed(profile), wk.Force(onset.force)).solve()
        peak = wk.peak_stress(contact)
        assert peak.von_mises == pytest.approx(Y, rel=1e-6)
        grid = wk.restore(
            contact, *np.meshgrid(np.linspace(0.0, 1.3, 40), np.linspace(0.02, 1.5, 40)) * np.array(contact.radius)
        )
        assert grid.von_mises.max() <= Y * (1.0 + 1e-9)
        assert grid.von_mises.max() > 0.9 * Y


def test_the_weaker_body_yields_and_its_side_is_stated():
    """Equal bodies but for the strength: the second one, at z < 0; then the first."""
    weak, strong = wk.Elastic(E, 0.3, strength=Y), wk.Elastic(E, 0.3, strength=2.0 * Y)
    below = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(weak, strong))).solve()
    above = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(strong, weak))).solve()
    assert below.z > 0.0 > above.z
    assert below.force == pytest.approx(above.force, rel=1e-9)
    only = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(E, 0.3), weak))).solve()
    assert only.z < 0.0
    assert only.force == pytest.approx(above.force, rel=1e-9)


@pytest.mark.parametrize("factor", [1e-3, 10.0])
def test_scaling(factor):
    """Lengths times s: F times s^2; moduli and strength times m: F times m."""
    base = wk.YieldOnset(bed(wk.Paraboloid(R))).solve()
    longer = wk.YieldOnset(bed(wk.Paraboloid(factor * R))).solve()
    assert longer.force == pytest.approx(factor**2 * base.force, rel=1e-8)
    stiffer = wk.HalfSpace.between(wk.Elastic(factor * E, 0.3, strength=factor * Y))
    assert wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), stiffer)).solve().force == pytest.approx(
        factor * base.force, rel=1e-8
    )


@pytest.mark.parametrize(
    ("profile", "why"),
    [
        (wk.Cone(1.3), "the apex is pointed"),
        (wk.PowerLaw(1.0, 0.7), "the apex is pointed"),
        (wk.TruncatedCone(1.3, 1e-3), "the slope of the profile jumps"),
        (wk.FlatPunch(1e-3), "the rim is sharp"),
    ],
)
def test_sharp_bodies_yield_at_once(profile, why):
    with pytest.raises(
        wk.OutsideValidity,
        match=rf"^YieldOnset: {why}, so the stress is infinite there and yielding "
        r"begins at the first touch; give a rounded profile\.$",
    ):
        wk.YieldOnset(bed(profile)).solve()
    contact = wk.Indentation(bed(profile), wk.Depth(1e-6)).solve()
    assert all(note.statement for note in contact.validity)


@pytest.mark.slow
def test_a_blunt_cusp_is_not_pointed():
    """f = c r^1.1: the pressure on the axis is finite, p(0) = E* kappa c n a^(n-1)/(pi (n-1)), and so is the onset."""
    onset = wk.YieldOnset(bed(wk.PowerLaw(0.01, 1.1))).solve()
    contact = wk.Indentation(bed(wk.PowerLaw(0.01, 1.1)), wk.Force(onset.force)).solve()
    assert wk.peak_stress(contact).von_mises == pytest.approx(Y, rel=1e-6)
    assert math.isfinite(wk.restore(contact, 0.0).pressure)


def test_a_profile_that_ends_before():
    r = np.linspace(0.0, 1e-5, 30)
    short = bed(wk.Measured(r, r**2 / (2.0 * R)))
    with pytest.raises(
        wk.OutsideValidity,
        match=r"within the profile's reach \(1e-05 m\) the largest von Mises stress "
        r"stays below 1.2e\+09 Pa; the body does not yield before",
    ):
        wk.YieldOnset(short).solve()
    notes = wk.Indentation(short, wk.Depth(1e-9)).solve().validity
    assert any("stays elastic" in note.statement for note in notes)


def test_a_rim_yields_when_it_is_reached():
    """Until the cap is in full contact all is elastic; at the rim the stress is then infinite."""
    cap, b = wk.Paraboloid(1.0), 1e-3
    pinned = bed(wk.CappedCylinder(b, cap))
    onset = wk.YieldOnset(pinned).solve()
    full = wk.Indentation(bed(cap), wk.Radius(b)).solve()
    assert (onset.radius, onset.r, onset.z) == (b, b, 0.0)
    assert onset.force == pytest.approx(full.force, rel=1e-12)
    before = wk.Indentation(pinned, wk.Force(0.9 * full.force)).solve()
    after = wk.Indentation(pinned, wk.Force(1.1 * full.force)).solve()
    assert any("stays elastic" in note.statement for note in before.validity)
    (sharp,) = (note for note in after.validity if "of the strength" in note.statement)
    assert sharp.statement.startswith("The rim is sharp, so the elastic stress is infinite there")
    assert sharp.standing is wk.Standing.APPROXIMATE


@pytest.mark.slow
def test_an_onset_where_the_contact_is_no_disc_is_refused():
    """Waves open a hole for radii between 0.1 and 0.17; strengths that are first reached there have no solution."""
    wavy = wk.Paraboloid(1.0) + wk.Wavy(4e-3, 0.2)

    def onset(strength):
        return wk.YieldOnset(bed_of(strength)).solve()

    def bed_of(strength):
        return wk.Foundation(wavy, wk.HalfSpace.between(wk.Elastic(1.0, 0.3, strength=strength)))

    with pytest.raises(wk.OutsideValidity, match=r"tension|overlap"):
        onset(0.118)
    for strength in (0.09, 0.1225):
        result = onset(strength)
        contact = wk.Indentation(bed_of(strength), wk.Radius(result.radius)).solve()
        assert wk.peak_stress(contact).von_mises == pytest.approx(strength, rel=1e-6)
        assert any(
            re.search(r"greatest (elastic )?stress is 1 (of|times)", note.statement) for note in contact.validity
        )
    contact = wk.Indentation(bed_of(0.118), wk.Radius(0.05)).solve()
    assert any("the contact stays elastic" in note.statement for note in contact.validity)


def test_what_must_be_given():
    with pytest.raises(wk.InvalidInput, match=r"no body has a strength; give Elastic\(young, poisson, strength=...\)"):
        wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(E, 0.3))))
    transverse = wk.TransverselyIsotropicHalfSpace.between(wk.TransverselyIsotropic(10.0, 4.0, 3.5, 12.0, 3.0))
    with pytest.raises(wk.InvalidInput, match="the medium is a TransverselyIsotropicHalfSpace; .* Give a HalfSpace"):
        wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), transverse))


@pytest.mark.few(1)
@pytest.mark.parametrize("shape", [wk.Sphere(1e-2), wk.AreaFunction((-math.pi, 2.0 * math.pi * 1e-2))])
@pytest.mark.parametrize(("young", "strength"), [(210e9, 1e20), (1e-20, 1e9)])
def test_a_strength_that_no_slope_reaches_is_refused(shape, young, strength):
    bed = wk.Foundation(shape, wk.HalfSpace(wk.Elastic(young, 0.3, strength=strength)))
    with pytest.raises(wk.OutsideValidity, match="below the strength, .*check the units"):
        wk.YieldOnset(bed).solve()


def test_a_strength_that_no_load_reaches_is_refused_on_a_plane_foundation():
    """The gap of a ball in the plane is finite at its equator; only its slope is not."""
    bed = wk.PlaneFoundation(wk.Sphere(4.8e-3), wk.HalfSpace(wk.Elastic(135e9, 0.42, strength=205e9)))
    with pytest.raises(wk.OutsideValidity, match="nearly vertical, .*below the strength, .*check the units"):
        wk.YieldOnset(bed).solve()
