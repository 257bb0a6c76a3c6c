"""What a twisted contact is at one moment, and the load of its springs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import TwistBound, twist_bound
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.twist_field import TwistBelow, twist_below
from winkler.media.layered.wave_constants import twist_constants
from winkler.media.twisting.surface import traction_on, turning_on
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.ring_slip.torsion_pieces import TurnedTwist, TwistMemory, pieces_of
from winkler.problems.round_march import RoundTwist
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

__all__ = ["TorsionState", "TwistedSprings"]

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
        bound=("", None, "friction limit of the springs"),
        kinks=("", None, "where the load over x is not smooth"),
    )

    bed: Bed
    coefficient: float
    widest: float
    forced: bool
    memory: TwistMemory | TurnedTwist

    @property
    def radius(self) -> float:
        """Of the contact, a [m]."""
        return self.memory.radius

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
        for piece in pieces_of(self.memory):
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
        return twist_bound(self.bed, self.coefficient, self.widest, self.forced)

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
        inner = self.memory.record.edges[1:-1]
        which = np.searchsorted(inner, x, side="right")
        for index, piece in enumerate(pieces_of(self.memory)):
            here = which == index
            if here.any():
                result[here] = reading(piece.values(self.bound), x[here])
        return result


@value
class TorsionState(RoundTwist[float]):
    """A twisted contact at one moment; its numbers are those of `RoundTwist`.

    Parameters
    ----------
    nested : bool
        Whether all that slid in the step was one outer ring, and slid to one side: then the step is exact.
    springs : TwistedSprings
        Their load.
    """

    nested: bool
    springs: TwistedSprings

    def line_load(self, x: ArrayLike) -> Array:
        """Return the load of the springs q(x) [N/m], odd in x.

        Parameters
        ----------
        x : array_like
            [m].
        """
        return self.springs.load(x)

    def traction(self, r: ArrayLike) -> Array:
        """Return the traction tau_theta(r) [Pa], of the sign of the torque; zero outside the contact.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        return traction_on(self.springs.bed.medium, self.springs, np.asarray(r, dtype=float))

    def turning(self, r: ArrayLike) -> Array:
        """Return the displacement u_theta(r) of the surface [m], the sum over both bodies.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        return turning_on(self.springs.bed.medium, self.springs, np.asarray(r, dtype=float))

    def below(self, r: ArrayLike, z: ArrayLike) -> TwistBelow:
        """Return displacement and shear stresses inside the bodies.

        Parameters
        ----------
        r, z : array_like
            Distance from the axis, and depth below the surface [m]: positive in the first body, negative in the second.

        Returns
        -------
        TwistBelow
            In the common shape of r and z, with z from the surface into the first body throughout; a positive torque
            turns the first body forwards and the second one back.

        Raises
        ------
        InvalidInput
            If a place lies on the surface.
        OutsideValidity
            If the body there is rigid, or layered or graded.
        """
        places, depths = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
        parts = np.zeros((3, *places.shape))
        medium = self.springs.bed.medium
        if not isinstance(medium, HomogeneousMedium):
            raise OutsideValidity(
                f"The stresses of a twist inside a {type(medium).__name__} are not known; request the traction of the "
                "state, state.traction(r), or give a homogeneous half-space."
            )
        for sign, body in ((1.0, "first"), (-1.0, "second")):
            here = sign * depths >= 0.0 if sign > 0.0 else depths < 0.0
            if here.any():
                modulus, stretch = twist_constants(getattr(medium, body))
                parts[:, here] = twist_below(self.springs, places[here], np.abs(depths[here]), modulus, stretch)
        # the second body is rotated in the opposite sense; there z, and with it tau_theta-z, counts from its own
        # surface
        parts[0] *= np.where(depths < 0.0, -1.0, 1.0)
        parts[2] *= np.where(depths < 0.0, -1.0, 1.0)
        return TwistBelow(*parts)
