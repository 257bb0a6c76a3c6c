"""A sheared line contact at one point of its path: traction, slip and stresses."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.checks.place_checks import common_places, finite_places
from winkler.errors import OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Coulomb
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.stress import LineContact, LineFields, poisson_of, stresses
from winkler.problems.line_friction.strips import EarlierStrip, half_widths, slipped, strips_of, traction
from winkler.problems.which_body import in_first_body
from winkler.values import value, words

__all__ = ["LineTangentialState"]


@value
class LineTangentialState:
    """A sheared line contact at one point of its path.

    Parameters
    ----------
    bed : LineFoundation
        Profile and bodies.
    law : Coulomb
        Friction.
    force_per_length, half_width : float
        P [N/m], a [m].
    shear_force_per_length, bulk_stress : float
        Q [N/m] along x on the first body; stress along x in it far from the contact [Pa].
    slip_shift : float
        By how much the second body is shifted along x beyond what Q causes where the present strip sticks [m]: by slip,
        and because the strip was narrower before.
    dissipation_per_length : float
        Energy lost since the beginning, per length [J/m].
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

    bed: LineFoundation
    law: Coulomb
    force_per_length: float
    half_width: float
    shear_force_per_length: float
    bulk_stress: float
    slip_shift: float
    dissipation_per_length: float
    lean: float
    memory: SlipMemory

    @property
    def stick_half_width(self) -> float:
        """Half-width c of the strip that does not slip [m]: a where all sticks, zero where all slides."""
        gap = self.memory.stick_gap
        if self.sliding or self.half_width == 0.0:
            return 0.0
        return min(float(half_widths(self.bed, np.array([gap]))[0]), self.half_width)

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

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure [Pa] at places x [m], zero outside of the contact."""
        x = finite_places("LineTangentialState.pressure", "x", x)
        if self.half_width == 0.0:
            return np.zeros(x.shape)
        return self.bed.pressure(x, self.half_width, rim_load(self.bed, self.force_per_length, self.half_width))

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

    def stresses(self, x: ArrayLike, z: ArrayLike) -> LineFields:
        """Return the stresses below the surface: of pressure and traction, and in the first body the bulk stress.

        Parameters
        ----------
        x : array_like
            Places along the surface [m].
        z : array_like
            Depths [m]: not negative in the first body, negative in the second, of which -0.0 is the surface.
            All in one of them.

        Raises
        ------
        InvalidInput
            If the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or the body is rigid.
        """
        along, depth = common_places("LineTangentialState.stresses", x=x, z=z)
        below = in_first_body(depth, "LineTangentialState")
        if self.half_width == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        poisson, deep = poisson_of(self.bed.medium, below), np.abs(depth)
        on_rim = rim_load(self.bed, self.force_per_length, self.half_width)
        fields = stresses(LineContact(self.bed, self.half_width, on_rim, poisson, 0.0), along, deep)
        bulk = self.bulk_stress if below else 0.0
        rows = [fields.xx_stress + bulk, fields.yy_stress + poisson * bulk, fields.zz_stress, fields.xz_stress]
        for strip in self.strips:
            if strip.factor != 0.0 and strip.half_width > 0.0:
                drag = strip.factor if below else -strip.factor
                contact = LineContact(self.bed, strip.half_width, strip.rim_load, poisson, drag, pressed=0.0)
                part = stresses(contact, along - strip.middle, deep)
                added = (part.xx_stress, part.yy_stress, part.zz_stress, part.xz_stress)
                rows = [row + more for row, more in zip(rows, added, strict=True)]
        return dataclasses.replace(LineFields(along, deep, *rows), z=depth)
