"""The medium under a bed that was measured: a stiffness, and a clear refusal of everything else."""

from __future__ import annotations

from typing import Any

from winkler.errors import OutsideValidity
from winkler.foundation.bed import Bed
from winkler.media.medium import Displacement
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
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

    def _other_gap(self, *_: Any, **__: Any) -> Any:
        """Refused."""
        raise self._unknown("gap of another body")

    def _pressure(self, *_: Any, **__: Any) -> Any:
        """Refused."""
        raise self._unknown("pressure")

    gap = gap_slope = gap_load = kinks = _other_gap
    punch_pressure = punch_facts = pressure = _pressure

    @property
    def notes(self) -> tuple[Note, ...]:
        """As the bed."""
        return self.bed.notes

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return self.bed.stiffness(radius)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) [Pa]."""
        return self.bed.normal_stiffness(x)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m]."""
        return self.bed.normal_stiffness_slope(x)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa]."""
        return self.bed.tangential_stiffness(x)

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """Refused."""
        raise self._unknown("displacement of the surface")

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Refused."""
        raise self._unknown("stress below the surface")
