"""Wavy and concave bodies: what is accepted is right, and what is refused is really not a disc.

The reference solution is `rings`: uniformly loaded rings and complementarity, which knows nothing of springs.
"""

from __future__ import annotations

import numpy as np
import pytest
from rings import press

import winkler as wk
from winkler.values.value import value

UNIT = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))

BODIES = {
    # profile, widest contact, how far the rings must reach
    "waves that g survives": (wk.Paraboloid(1.0) + wk.Wavy(5e-4, 0.2), 0.8, 1.0),
    "waves that open holes": (wk.Paraboloid(1.0) + wk.Wavy(1e-2, 0.2), 0.8, 1.0),
    "deep waves": (wk.Paraboloid(1.0) + wk.Wavy(2e-2, 0.3), 0.8, 1.2),
    "fine waves": (wk.Paraboloid(1.0) + wk.Wavy(2e-4, 0.06), 0.6, 0.75),
    "a sharpened tip": (wk.CappedParaboloid(1.0, 0.3, 0.2), 0.42, 0.6),
    "a tip sharpened a little": (wk.CappedParaboloid(1.0, 0.9, 0.2), 0.6, 0.75),
    "a wavy cone": (wk.Cone(1.3) + wk.Wavy(2e-3, 0.25), 0.5, 0.9),
    "a falling step of the slope": (
        wk.Formula("s*r - t*(r - b + sqrt((r - b)**2))/2", s=0.2, t=0.15, b=0.2, corners=(0.2,)),
        0.6,
        1.0,
    ),
    "waves alone": (wk.Wavy(0.05, 1.0), 0.4, 2.4),
    "a hill that falls back to zero": (wk.Formula("r**2/2*exp(-r**2/L**2)", reach=1.5, L=0.5), 0.4, 1.5),
    "a cusp": (wk.PowerLaw(0.3, 0.5) + wk.Paraboloid(1.0), 0.5, 0.7),
    "a worn tip": (wk.CappedParaboloid(0.3, 5.0, 0.2), 0.6, 0.75),
}


NEVER_DISCS = {"waves alone", "a hill that falls back to zero"}
NOT_ALWAYS_DISCS = NEVER_DISCS | {
    "waves that open holes",
    "deep waves",
    "a sharpened tip",
    "a falling step of the slope",
}


COSTLY = {"a hill that falls back to zero"}


@pytest.mark.few(4, slow=4)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long if name in COSTLY else ()) for name in BODIES]
)
def test_against_rings(name):
    profile, widest, reach = BODIES[name]
    bed = wk.Foundation(profile, UNIT)
    deepest = float(np.abs(profile.gap(np.array([widest])))[0])
    accepted = refused = 0
    for depth in np.geomspace(0.05, 1.0, 9) * deepest:
        reference = press(profile, float(depth), reach, 250)
        try:
            contact = wk.Indentation(bed, wk.Depth(depth)).solve()
        except wk.OutsideValidity:
            refused += 1
            assert not reference.is_disc, f"refused at {depth}, but it is a disc of {reference.radius}"
            continue
        accepted += 1
        assert reference.is_disc or not reference.clear, f"accepted at {depth}, but the patches are {reference.patches}"
        width = reference.edges[1]
        assert contact.radius == pytest.approx(reference.radius, abs=1.6 * width)
        rings = contact.radius / width
        assert contact.force == pytest.approx(reference.force, rel=2e-4 + 3.0 / rings**2)
        inside = (reference.middle > 0.1 * contact.radius) & (reference.middle < 0.8 * contact.radius)
        breaks = [b for b, _ in profile.kinks]
        inside &= np.all(np.abs(reference.middle[:, None] - [*breaks, -1.0]) > 4.0 * width, axis=1)
        if rings > 40 and depth > 0.5 * deepest:
            pressure = wk.restore(contact, reference.middle[inside]).pressure
            np.testing.assert_allclose(
                pressure, reference.pressure[inside], rtol=0.03, atol=0.01 * reference.pressure.max()
            )
    assert accepted + refused == 9
    assert (refused > 0) == (name in NOT_ALWAYS_DISCS)
    assert (accepted > 0) == (name not in NEVER_DISCS)


@pytest.mark.parametrize(("depth", "width"), [(0.3, 2.2e-3), (0.47, 5.8e-4), (1.0, 3.2e-5), (2.0, 8e-7)])
def test_a_thin_hole_is_detected(depth, width):
    """Where the slope drops the pressure falls logarithmically: a hole far narrower than any sampling."""
    profile = wk.CappedParaboloid(1.0, 0.3, 0.2)
    with pytest.raises(wk.OutsideValidity, match=r"would need tension at r = 0\.[12]\d* m: the true contact has a gap"):
        wk.Indentation(wk.Foundation(profile, UNIT), wk.Depth(depth)).solve()
    # rings that crowd at the kink find the hole as well
    edges = 0.2 + np.concatenate([[-0.2], -np.geomspace(0.19, 1e-9, 200), [0.0], np.geomspace(1e-9, 1.4, 220)])
    reference = press(profile, depth, edges=tuple(edges))
    assert len(reference.patches) == 2
    hole = reference.edges[reference.patches[0][1] + 1], reference.edges[reference.patches[1][0]]
    assert hole[0] <= 0.2 <= hole[1]
    assert hole[1] - hole[0] == pytest.approx(width, rel=0.2)


def test_loads_between_two_discs():
    """On growing depth the disc grows, then a ring forms outside, then all is one disc again: the middle is refused."""
    profile = wk.Paraboloid(1.0) + wk.Wavy(4e-3, 0.2)
    bed = wk.Foundation(profile, UNIT)
    depths = np.linspace(0.016, 0.03, 13)
    states = []
    for depth in depths:
        reference = press(profile, float(depth), 0.4, 300)
        try:
            contact = wk.Indentation(bed, wk.Depth(depth)).solve()
        except wk.OutsideValidity as error:
            states.append("hole" if "tension" in str(error) else "ring")
            assert not reference.is_disc
        else:
            states.append("disc")
            assert reference.is_disc or not reference.clear
    first, last = states.index("ring"), len(states) - 1 - states[::-1].index("hole")
    assert states == ["disc"] * first + states[first : last + 1] + ["disc"] * (len(states) - last - 1)
    assert "disc" not in states[first : last + 1]
    # forces and radii between are refused, too, outside they agree
    below = wk.Indentation(bed, wk.Depth(depths[first - 1])).solve()
    above = wk.Indentation(bed, wk.Depth(depths[last + 1])).solve()
    for contact in (below, above):
        assert wk.Indentation(bed, wk.Force(contact.force)).solve().depth == pytest.approx(contact.depth, rel=1e-11)
        assert wk.Indentation(bed, wk.Radius(contact.radius)).solve().force == pytest.approx(contact.force, rel=1e-11)
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Force(0.5 * (below.force + above.force))).solve()
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Radius(0.5 * (below.radius + above.radius))).solve()


def test_the_refused_load_of_an_array_is_named():
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(4e-3, 0.2), UNIT)
    with pytest.raises(wk.OutsideValidity, match="load at index 1"):
        wk.Indentation(bed, wk.Depth(np.array([0.01, 0.0218531, 0.1]))).solve()
    with pytest.raises(wk.OutsideValidity, match="load at index 2"):
        wk.Indentation(bed, wk.Force(np.array([1e-4, 0.1, 2.7e-3]))).solve()
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Radius(np.array([0.05, 0.15]))).solve()


@pytest.mark.parametrize("ratio", [3.5, 20.0, 1e3])
def test_a_second_touch_far_away_is_detected(ratio):
    """Waves alone come back to the height of the apex one wavelength away, however small the contact."""
    bed = wk.Foundation(wk.Wavy(0.05, 1.0), UNIT)
    depth = float(bed.gap(np.array([1.0 / ratio]))[0])
    with pytest.raises(wk.OutsideValidity, match="overlap outside the contact"):
        wk.Indentation(bed, wk.Depth(depth)).solve()
    with pytest.raises(wk.OutsideValidity, match="overlap outside the contact"):
        wk.Indentation(bed, wk.Radius(1.0 / ratio)).solve()


@value
class Bump(wk.Shape):
    """A paraboloid that comes down again in a narrow valley, 4.5e-5 above the apex, at r = 3."""

    def height(self, r):
        return 0.5 * r**2 * (1.0 - 0.99999 * np.exp(-(((r - 3.0) / 0.1) ** 2)))

    def slope(self, r):
        dip = 0.99999 * np.exp(-(((r - 3.0) / 0.1) ** 2))
        return r * (1.0 - dip) + r**2 * dip * (r - 3.0) / 0.01

    def curvature(self, r):
        dip = 0.99999 * np.exp(-(((r - 3.0) / 0.1) ** 2))
        fall = dip * (r - 3.0) / 0.01
        return 1.0 - dip + 4.0 * r * fall + r**2 * (dip / 0.01 - 2.0 * fall * (r - 3.0) / 0.01)


def test_a_narrow_bump_far_away():
    """At 30 contact radii, 3 % wide: where the other body must not hit it."""
    bed = wk.Foundation(Bump(), UNIT)
    assert wk.Indentation(bed, wk.Depth(2e-5)).solve().force == pytest.approx(4.0 / 3.0 * (2e-5) ** 1.5, rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match=r"overlap outside the contact, at r = [23]\.\d+ m"):
        wk.Indentation(bed, wk.Depth(1e-2)).solve()


# --------------------------------------------------------------------------------------------------- pinned contacts


def test_a_pinned_disc_is_checked_too():
    """Full contact of a wavy end face: refused while the troughs still gape, right afterwards."""
    cap = wk.Wavy(0.01, 0.5)
    profile = wk.CappedCylinder(1.0, cap)
    bed = wk.Foundation(profile, UNIT)
    reached = set()
    for depth in np.linspace(0.02, 0.4, 8):
        reference = press(cap, float(depth), 1.0, 250)
        try:
            contact = wk.Indentation(bed, wk.Depth(depth)).solve()
        except wk.OutsideValidity:
            reached.add("refused")
            assert not reference.is_disc
            continue
        reached.add("accepted")
        assert reference.is_disc or not reference.clear
        assert contact.radius == 1.0
        assert contact.force == pytest.approx(reference.force, rel=6e-3)
        again = wk.Indentation(bed, wk.Force(contact.force)).solve()
        assert again.depth == pytest.approx(contact.depth, rel=1e-12)
        assert again.radius == 1.0
    assert reached == {"accepted", "refused"}
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Force(0.02)).solve()


def test_beyond_the_reach_of_a_wavy_profile():
    profile = wk.Formula("r**2/(2*R) + h*(1 - cos(k*r))", reach=0.5, R=1.0, h=1e-4, k=30.0)
    bed = wk.Foundation(profile, UNIT)
    deepest = float(bed.gap(np.array([0.5]))[0])
    assert wk.Indentation(bed, wk.Depth(0.99 * deepest)).solve().radius < 0.5
    for load in (wk.Depth(1.2 * deepest), wk.Force(10.0), wk.Radius(0.6)):
        with pytest.raises(wk.OutsideValidity, match="beyond the reach of the profile"):
            wk.Indentation(bed, load).solve()


# ------------------------------------------------------------------------------------------- so many waves, so rough


def test_more_waves_than_can_be_resolved():
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(5e-6, 1e-3), UNIT)
    with pytest.raises(wk.OutsideValidity, match="turns more than 400 times"):
        wk.Indentation(bed, wk.Depth(0.25)).solve()


@pytest.mark.parametrize("wavelength", [0.64 / 4096, 0.64 / 2048, 0.32 / 4096])
def test_waves_in_step_with_the_sampling_are_not_overlooked(wavelength):
    """Every sample of g' falls on the same phase of the wave; the solution may fail, never be wrong."""
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(1e-6, wavelength), UNIT)
    with pytest.raises(wk.WinklerError):
        wk.Indentation(bed, wk.Depth(0.25)).solve()


def test_twenty_waves_are_restored():
    """A fine wave that never opens: pressure oscillates about Hertz and keeps its total."""
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(2e-5, 0.025), UNIT)
    contact = wk.Indentation(bed, wk.Radius(0.5)).solve()
    r = (np.arange(400) + 0.5) / 400.0 * 0.5
    pressure = wk.restore(contact, r).pressure
    assert pressure.min() > 0.0
    assert 2.0 * np.pi * np.sum(pressure * r) * 0.5 / 400.0 == pytest.approx(contact.force, rel=1e-3)
    hertz = 2.0 / np.pi * np.sqrt(0.25 - r**2)
    assert 0.005 < np.max(np.abs(pressure - hertz)) / hertz[0] < 1.0


@pytest.mark.slow
def test_measured_waves_are_checked_alike():
    r = np.linspace(0.0, 1.0, 200)
    profile = wk.Measured(r, r**2 / 2.0 + 4e-3 * (1.0 - np.cos(10.0 * np.pi * r)))
    bed = wk.Foundation(profile, UNIT)
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Depth(0.0218531)).solve()
    twin = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(4e-3, 0.2), UNIT)
    for depth in (0.01, 0.05, 0.2):
        expected = wk.Indentation(twin, wk.Depth(depth)).solve().force
        assert wk.Indentation(bed, wk.Depth(depth)).solve().force == pytest.approx(expected, rel=1e-5)
