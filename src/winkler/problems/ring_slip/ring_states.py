"""The load of the springs of a contact whose rings slide, and what such a contact is at one moment."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.torsion_bound import TwistBound, twist_bound
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.twisting.surface import traction_on
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.ring_slip.torsion_pieces import TurnedTwist, TwistMemory
from winkler.problems.round_march import RoundNormal
from winkler.values.value import value, words

BoundOf = Callable[[Bed, float, float, bool], TwistBound]
"""Returns the bound of bed, coefficient, widest radius [m], and whether the force is prescribed."""
FIRST_SEAM = 0.1
"""Part of the contact beyond which loads are not smooth where panels meet, if kernels have a logarithm."""


@value
class TwistedSprings:
    """The load q(x) = e(x) h(x) of the springs of a twisted contact; e = x on homogeneous half-spaces.

    Parameters
    ----------
    bed : Bed
        On a medium on which torsion is solved.
    coefficient : float
        mu [-].
    widest : float
        A contact radius that was never exceeded [m].
    forced : bool
        Whether the memory counts forces, not depths.
    memory : TwistMemory or TurnedTwist
        What the springs remember.
    """

    __words__ = words(
        widest=("", "m", "a contact radius that was never exceeded"),
        forced=("", None, "whether the memory counts forces, not depths"),
        edge=("h(a)", "Pa", "load over x at the edge of the contact"),
        coefficient=(r"\mu", "", "friction coefficient"),
        bound=("", None, "greatest load of each spring without slip"),
        kinks=("", None, "where the load over x is not smooth"),
    )

    bound_of: ClassVar[BoundOf] = staticmethod(twist_bound)

    bed: Bed
    coefficient: float
    widest: float
    forced: bool
    memory: TwistMemory | TurnedTwist

    @property
    def radius(self) -> float:
        """Of the contact, a [m]."""
        return self.memory.press.radius

    @property
    def edge(self) -> float:
        """h(a-) [Pa]; zero where the contact closes smoothly."""
        if self.radius == 0.0 or (self.radius < self.bed.rim and not self.bound.endless):
            return 0.0
        return float(self.value(np.array([self.radius]))[0])

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: just above x the slope of h holds -strength / sqrt(x^2 - x_kink^2)."""
        bends = {b: 0.0 for b, _ in self.bed.kinks if b < self.radius}
        if self.bound.logarithmic:
            ends = self.bound.panels.edges
            bends |= dict.fromkeys(ends[(ends > FIRST_SEAM * self.radius) & (ends < self.radius)].tolist(), 0.0)
        for piece in self.memory.pieces:
            if piece.low > 0.0:
                bends.setdefault(piece.low, 0.0)
            for b, strength in self.bed.kinks:
                if piece.low <= b < piece.high:
                    rate = float(self.bed.stiffness(np.array([b]))[0]) if self.forced else 1.0
                    bounded = piece.side if b < piece.bound.radius else 0.0
                    bends[b] = bounded * self.bound.onset(b, strength) - piece.entered * rate * strength
        return tuple(sorted(bends.items()))

    @property
    def bound(self) -> TwistBound:
        """What they bear at most."""
        return type(self).bound_of(self.bed, self.coefficient, self.widest, self.forced)

    def value(self, x: Array) -> Array:
        """h(x) [Pa] for 0 < x <= a."""
        return self._read(x, self.bound.panels.value)

    def slope(self, x: Array) -> Array:
        """h'(x) [Pa/m] for 0 < x < a."""
        return self._read(x, self.bound.panels.slope)

    def load(self, x: ArrayLike) -> Array:
        """q(x) [N/m], odd in x, zero outside the contact."""
        places = np.asarray(x, dtype=float)
        inside = (np.abs(places) <= self.radius) & (places != 0.0)
        where = np.where(inside, np.abs(places), 0.5 * self.radius)
        if self.radius == 0.0:
            return np.zeros(places.shape)
        lever = where
        if not isinstance(self.bed.medium, HomogeneousMedium):
            lever = np.sqrt(self.bound.panels.value(self.bound.weight, where))
        return np.where(inside, np.sign(places) * lever * self.value(where), 0.0)

    def _read(self, x: Array, reading: Callable[[Array, Array], Array]) -> Array:
        x = np.asarray(x, dtype=float)
        result = np.zeros(x.shape)
        pieces = self.memory.pieces
        which = np.searchsorted([piece.low for piece in pieces[1:]], x, side="right")
        for index, piece in enumerate(pieces):
            here = which == index
            if here.any():
                result[here] = reading(piece.values(self.bound), x[here])
        return result

    def traction(self, r: Array) -> Array:
        """Return the traction [Pa] at distances from the axis [m]; zero outside the contact."""
        return traction_on(self.bed.medium, self, r)


@value
class RingState(RoundNormal[float]):
    """A contact whose rings slide, at one moment.

    Parameters
    ----------
    nested : bool
        Whether all that slid in the step was one outer ring, and slid to one side: then the step is exact.
    springs : TwistedSprings
        Their load.
    """

    nested: bool
    springs: TwistedSprings

    @property
    def _pressed(self) -> PressedSprings:
        return PressedSprings(self.springs.bed, self.depth, self.radius)

    def traction(self, r: ArrayLike) -> Array:
        """Return the traction [Pa] along the motion, or around the axis; zero outside the contact.

        It has the sign of the shear force, or of the torque.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        r = np.asarray(r, dtype=float)
        return self.springs.traction(r) if self.radius > 0.0 else np.zeros(r.shape)
