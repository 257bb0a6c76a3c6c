"""The contract of a bed: the springs of a problem as functions of x, without a grid."""

from __future__ import annotations

from typing import Protocol, cast

import numpy as np

from winkler.foundation.footprint import Footprint
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.values.checks.contract import offered
from winkler.values.validity import Note
from winkler.values.value import value


@offered("a bed, such as Foundation(profile, medium)")
class Bed(Protocol):
    """The contract of a foundation, written for its implementer.

    Lengths [m], x >= 0 (everything is even in x); arrays in, arrays of the same shape out.
    """

    def __hash__(self) -> int:
        """Beds are values: equal content, equal hash."""

    @property
    def medium(self) -> Medium:
        """The transforms between springs and body."""

    @property
    def footprint(self) -> Footprint:
        """The outline of the contact: problems that need a disc are refused on a bed without one."""

    @property
    def reach(self) -> float:
        """The greatest x for which the bed is defined [m]."""

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]; infinite if nowhere."""

    @property
    def size(self) -> float:
        """Radius of the body [m]; infinite if unknown."""

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: just above x, g' holds strength / sqrt(x^2 - x_kink^2), or as `Medium.kinks` states."""

    @property
    def rising(self) -> bool:
        """Whether the body, on a homogeneous half-space, is known to have a g that never falls."""

    @property
    def certain(self) -> bool:
        """Whether every contact is known to be one disc, so that none need be checked."""

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about shape and medium."""

    def height(self, r: Array) -> Array:
        """f(r) [m], the body of revolution that stands above the bed."""

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""

    def gap_load(self, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""

    def stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) [Pa]."""

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m], for x > 0."""

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa]."""


def slipping_springs(bed: Bed) -> Bed:
    """Return the springs that slide as a bed does: its own, unless it has others (`DirectionalBed.sheared`)."""
    return cast(Bed, getattr(bed, "sheared", bed))


def slipping_depth(bed: Bed, depth: Array, radius: Array) -> Array:
    """Return the depths [m] of the slipping springs of a bed at its own depths and radii."""
    springs = slipping_springs(bed)
    return depth if springs is bed else np.where(radius > 0.0, springs.gap(radius), np.minimum(depth, 0.0))


def measured_radii(bed: Bed) -> Array:
    """Return the radii at which a bed was measured [m], where its splines bend; empty of others."""
    return np.asarray(getattr(bed, "radii", ()), dtype=float)


@value
class PressedSprings:
    """The springs of a bed pressed to a depth: u(x) = d - g(x) up to the contact radius, nothing outside.

    Parameters
    ----------
    bed : Bed
    depth : float
        d [m].
    radius : float
        a [m].
    """

    bed: Bed
    depth: float
    radius: float

    @property
    def touching(self) -> float:
        """The radius of the area in which the surfaces touch [m]."""
        return self.radius

    @property
    def blunted(self) -> PressedSprings:
        """The same springs, as fields below the surface take them: without detail too fine to matter there."""
        return self

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` within the contact."""
        return tuple((b, strength) for b, strength in self.bed.kinks if b < self.radius)

    @property
    def edge(self) -> float:
        """u(a-) [m]; exactly zero where the contact closes smoothly."""
        if self.radius < self.bed.rim:
            return 0.0
        return float(self.depth - self.bed.gap(np.array([self.radius]))[0])

    def value(self, x: Array) -> Array:
        """u(x) [m]."""
        return self.depth - self.bed.gap(x)

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        return -self.bed.gap_slope(x)


@value
class StretchedSprings(PressedSprings):
    """Springs that end stretched: u(x) = d - g(x) up to the contact radius, with a jump there."""

    @property
    def edge(self) -> float:
        """u(a-) [m], negative where the edge pulls."""
        return float(self.depth - self.bed.gap(np.array([self.radius]))[0])
