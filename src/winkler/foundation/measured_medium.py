"""The medium under a bed that was measured: a stiffness, and a clear refusal of everything else."""

from __future__ import annotations

from winkler.errors import OutsideValidity
from winkler.foundation.bed import Bed
from winkler.media.medium import Displacement, PunchFacts
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.validity import Note
from winkler.values import value

__all__ = ["MeasuredMedium"]


@value
class MeasuredMedium:
    """The medium under a `MeasuredBed`: its stiffness is known, nothing else; requesting more raises the reason.

    Parameters
    ----------
    bed : Bed
        What was measured.
    """

    bed: Bed

    def _unknown(self, what: str) -> OutsideValidity:
        return OutsideValidity(
            f"MeasuredBed: the {what} cannot be restored from measured stiffness and depth, since neither the body nor "
            "the medium is known; give Foundation(profile, medium) for fields."
        )

    @property
    def notes(self) -> tuple[Note, ...]:
        """As the bed."""
        return self.bed.notes

    def gap(self, profile: Profile, x: Array) -> Array:
        """Refused."""
        raise self._unknown("gap of another body")

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """Refused."""
        raise self._unknown("gap of another body")

    def gap_load(self, profile: Profile, radius: Array) -> Array:
        """Refused."""
        raise self._unknown("gap of another body")

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """Refused."""
        raise self._unknown("gap of another body")

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return self.bed.stiffness(radius)

    def punch_pressure(self, r: Array, radius: Array) -> Array:
        """Refused."""
        raise self._unknown("pressure")

    def punch_facts(self, radius: float) -> PunchFacts:
        """Refused."""
        raise self._unknown("pressure")

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) [Pa]."""
        return self.bed.normal_stiffness(x)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m]."""
        return self.bed.normal_stiffness_slope(x)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa]."""
        return self.bed.tangential_stiffness(x)

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """Refused."""
        raise self._unknown("pressure")

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """Refused."""
        raise self._unknown("displacement of the surface")

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Refused."""
        raise self._unknown("stress below the surface")
