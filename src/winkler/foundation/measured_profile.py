"""The plane profile of a measured bed, to be pressed into something else, such as a viscoelastic half-space."""

from __future__ import annotations

from winkler.foundation.footprint import Footprint
from winkler.foundation.measured import MeasuredBed
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.values.validity import Note
from winkler.values.value import value


@value
class MeasuredPlaneProfile(Shape):
    """The g(x) of a measured bed as a profile, for `PlaneFoundation`.

    Parameters
    ----------
    bed : MeasuredBed
        Springs whose radii are those of a homogeneous half-space: then g does not depend on its modulus.
    """

    bed: MeasuredBed

    @property
    def footprint(self) -> Footprint:
        """As the bed."""
        return self.bed.footprint

    @property
    def reach(self) -> float:
        """The greatest radius that is known [m]."""
        return self.bed.reach

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The points of the bed."""
        return self.bed.kinks

    @property
    def rising(self) -> bool:
        """As the bed."""
        return self.bed.rising

    @property
    def notes(self) -> tuple[Note, ...]:
        """As the bed."""
        return self.bed.notes

    def height(self, r: Array) -> Array:
        """g [m]."""
        return self.bed.gap(r)

    def slope(self, r: Array) -> Array:
        """g' [-]."""
        return self.bed.gap_slope(r)

    def curvature(self, r: Array) -> Array:
        """g'' [1/m], for positive radii."""
        return self.bed.gap_bend(r)
