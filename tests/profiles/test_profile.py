"""A shape of one's own: height, slope and curvature are enough, the transforms follow."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_judge import assert_starts_at_zero, assert_transforms

import winkler as wk
from winkler.profiles.pieces import PowerPieces
from winkler.values import value


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
class Stairs(PowerPieces):
    """Truncated powers up to the fourth, some falling."""

    starts: tuple[float, ...]
    weights: tuple[float, ...]

    @property
    def terms(self):
        return tuple((b, m, c) for m, (b, c) in enumerate(zip(self.starts, self.weights, strict=True)))


def test_truncated_powers_of_any_order():
    starts, weights = (0.1, 0.0, 0.7, 0.3, 0.0), (0.5, 2.0, -1.0, 3.0, 0.4)
    shape = Stairs(starts, weights)
    slope = lambda r: mp.fsum(  # noqa: E731
        mp.mpf(c) * r**m for m, (b, c) in enumerate(zip(starts, weights, strict=True)) if r > b or b == 0.0
    )
    x = np.array([0.05, 0.15, 0.5, 0.9, 3.0])
    assert_transforms(shape, slope, x, (0.1, 0.3, 0.7))
    assert [b for b, _ in shape.kinks] == [0.1, 0.3, 0.7]
    np.testing.assert_allclose([jump for _, jump in shape.kinks], [0.5, 3.0 * 0.3**3, -(0.7**2)], rtol=1e-15)
    assert not shape.rising
