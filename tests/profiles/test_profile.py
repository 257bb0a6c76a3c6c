"""A shape of one's own: height, slope and curvature are enough, the transforms follow."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_starts_at_zero, assert_transforms

import winkler as wk
from winkler.profiles.pieces import PowerPieces
from winkler.values.value import value


@value
class Catenary(wk.Shape):
    """f = L (cosh(r/L) - 1), with a ring of slope beyond a radius."""

    length: float
    ring: float
    jump: float

    @property
    def kinks(self):
        return ((self.ring, self.jump),)

    def height(self, r):
        return 2.0 * self.length * np.sinh(0.5 * r / self.length) ** 2 + self.jump * np.maximum(r - self.ring, 0.0)

    def slope(self, r):
        return np.sinh(r / self.length) + np.where(r > self.ring, self.jump, 0.0)

    def curvature(self, r):
        return np.cosh(r / self.length) / self.length


X = np.array([1e-3, 0.2, 0.5, 0.5 + 1e-9, 0.7, 2.0])


@pytest.mark.few(1)
@pytest.mark.parametrize("jump", [0.0, 0.3])
def test_transforms_follow_from_the_slope(jump):
    shape = Catenary(0.8, 0.5, jump)
    slope = lambda r: mp.sinh(r / mp.mpf(0.8)) + (mp.mpf(jump) if r > 0.5 else 0)  # noqa: E731
    assert_transforms(shape, slope, X, (0.5,))
    assert_starts_at_zero(shape)


def test_it_is_a_profile_like_any_other():
    bed = wk.Foundation(Catenary(0.8, 0.5, 0.3) + wk.Paraboloid(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    contact = wk.Indentation(bed, wk.Radius(0.7)).solve()
    assert wk.Indentation(bed, wk.Force(contact.force)).solve().radius == pytest.approx(0.7, rel=1e-12)


def test_the_whole_contract_has_defaults():
    bare = wk.Shape()
    assert bare.reach == bare.rim == bare.size == math.inf
    assert bare.kinks == ()
    assert bare.notes == ()
    assert bare.rising is False
    for word in ("height", "slope", "curvature"):
        with pytest.raises(NotImplementedError, match=rf"Shape must give {word}\(r\)"):
            getattr(bare, word)(np.zeros(1))


@value
class TruncatedPowers(PowerPieces):
    """Truncated powers up to the fourth, some falling."""

    starts: tuple[float, ...]
    weights: tuple[float, ...]

    @property
    def terms(self):
        return tuple((b, m, c) for m, (b, c) in enumerate(zip(self.starts, self.weights, strict=True)))


@pytest.mark.slow
def test_truncated_powers_of_any_order():
    starts, weights = (0.1, 0.0, 0.7, 0.3, 0.0), (0.5, 2.0, -1.0, 3.0, 0.4)
    shape = TruncatedPowers(starts, weights)
    slope = lambda r: mp.fsum(  # noqa: E731
        mp.mpf(c) * r**m for m, (b, c) in enumerate(zip(starts, weights, strict=True)) if r > b or b == 0.0
    )
    x = np.array([0.05, 0.15, 0.5, 0.9, 3.0])
    assert_transforms(shape, slope, x, (0.1, 0.3, 0.7))
    assert [b for b, _ in shape.kinks] == [0.1, 0.3, 0.7]
    np.testing.assert_allclose([jump for _, jump in shape.kinks], [0.5, 3.0 * 0.3**3, -(0.7**2)], rtol=1e-15)
    assert not shape.rising


KINKED = [
    wk.TruncatedCone(1.1, 0.5),
    wk.RoundedCone(0.7, 1.1),
    wk.SpheroConical(0.7, 1.1),
    wk.RoundedPunch(0.4, 0.7),
    wk.TruncatedParaboloid(0.7, 0.4),
    wk.CappedParaboloid(0.7, 2.0, 0.4),
    wk.CappedParaboloid(0.7, 0.2, 0.4),
    wk.TruncatedCone(1.1, 0.5) + wk.CappedParaboloid(0.7, 2.0, 0.4),
    wk.Formula("r**2/2 + q*(r - b + sqrt((r - b)**2))/2", q=0.3, b=0.4, corners=(0.4,)),
]


@pytest.mark.parametrize("profile", KINKED)
def test_the_jump_at_every_kink(profile):
    """`kinks` agree with f', and g' diverges above as b j/sqrt(x^2 - b^2)."""
    assert profile.kinks
    for b, jump in profile.kinks:
        below, above = profile.slope(b * np.array([1.0 - 1e-9, 1.0 + 1e-9]))
        assert above - below == pytest.approx(jump, abs=1e-7)
        x = b * (1.0 + 1e-12)
        steep = float((profile.gap_slope(np.array([x])) - profile.gap_slope(np.array([b])))[0])
        assert steep * math.sqrt((x - b) * (x + b)) == pytest.approx(b * jump, rel=1e-4, abs=1e-5)


@pytest.mark.parametrize("profile", KINKED)
def test_blunter_bodies_need_more_force(profile):
    """With anything added to the height, the force at a given depth is less, whatever is added."""
    medium = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
    if not profile.rising:
        return
    for more in (wk.Paraboloid(2.0), wk.Cone(1.4), wk.TruncatedCone(1.0, 0.3), wk.PowerLaw(0.3, 0.7)):
        depths = np.array([0.01, 0.1, 0.4])
        blunt, sharp = (
            wk.Indentation(wk.Foundation(p, medium), wk.Depth(depths)).solve().force for p in (profile, profile + more)
        )
        assert np.all(blunt >= sharp * (1.0 - 1e-12))
        assert blunt[-1] > sharp[-1]
