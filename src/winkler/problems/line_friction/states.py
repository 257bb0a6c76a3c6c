"""A sheared line contact at one point of its path: traction, slip and stresses."""

from __future__ import annotations

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Coulomb
from winkler.numerics.types import Array, ArrayLike, ComplexArray
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.line.half_width import under_force
from winkler.problems.line.stress import Strip, potential_of
from winkler.problems.line_friction.sheared_strip import ShearedStrip
from winkler.problems.line_friction.strips import EarlierStrip, slipped, strips_of, traction
from winkler.values.checks.place_checks import finite_places
from winkler.values.value import value, words


@value
class LineTangentialState(ShearedStrip):
    """A sheared line contact at one point of its path; its numbers are those of `LineSlip`.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies.
    law : Coulomb
        Law of friction.
    lean : float
        Shift of an earlier contact's middle over the load per length over E* that it lacks [-], by the bulk stress.
    memory : SlipMemory
        What the strips remember: load per length over E* [m] instead of gap and displacement.
    """

    __words__ = words(
        lean=(r"\lambda", "", "shift of an earlier contact over the load that it lacks, by the bulk stress"),
        strips=("", None, "earlier contacts whose pressures add up to the traction"),
        sliding=("", None, "whether all of the contact slides"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    law: Coulomb
    lean: float
    memory: SlipMemory

    @property
    def stick_half_width(self) -> float:
        """Half-width c of the strip that does not slip [m]: a where all sticks, zero where all slides."""
        gap = self.memory.stick_gap
        if self.sliding or self.half_width == 0.0:
            return 0.0
        return min(float(under_force(self.bed, np.array([gap]))[0]), self.half_width)

    @property
    def stick_middle(self) -> float:
        """Where the middle of the strip that does not slip is [m]; aside under a bulk stress."""
        return 0.0 if self.sliding else self.lean * (self.memory.depth - self.memory.stick_gap)

    @property
    def sliding(self) -> bool:
        """Whether all of the contact slides."""
        return self.half_width > 0.0 and self.memory.stick_gap == 0.0

    @property
    def strips(self) -> tuple[EarlierStrip, ...]:
        """The earlier contacts whose pressures add up to the traction."""
        return strips_of(self.bed, self.memory, self.lean) if self.half_width > 0.0 else ()

    def traction(self, x: ArrayLike) -> Array:
        """Return the traction q [Pa] along x on the first body.

        Parameters
        ----------
        x : array_like
            Places on the surface [m].
        """
        return traction(self.bed, self.strips, finite_places("LineTangentialState.traction", "x", x))

    def slip(self, x: ArrayLike) -> Array:
        """Return how far the second body is ahead of the first at places of the contact [m].

        It is counted against the middle of the strip that sticks, or that stuck last where all slides.  Differences
        between two points of the path are what has slipped, at places that touched in the meantime; what came into
        contact later brings with it how far it was ahead then.

        Parameters
        ----------
        x : array_like
            Places on the surface [m]; not a number outside of the contact.
        """
        x = finite_places("LineTangentialState.slip", "x", x)
        inside = np.abs(x) <= self.half_width
        ahead = np.full(x.shape, np.nan)
        ahead[inside] = slipped(self.bed, self.strips, x[inside])
        return ahead

    def _dragged(self, x: Array, deep: Array, pressed: ComplexArray) -> ComplexArray | None:
        parts = [
            strip.factor * potential_of(self.bed, Strip(strip.half_width, strip.rim_load), x - strip.middle, deep)
            for strip in self.strips
            if strip.factor != 0.0 and strip.half_width > 0.0
        ]
        return np.asarray(sum(parts[1:], parts[0])) if parts else None
