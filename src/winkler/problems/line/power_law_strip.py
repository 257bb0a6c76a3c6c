"""One strip of contact on bodies graded by a power of the depth: its depth, and what is stated of it."""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.numerics.types import ArrayLike, Quantity, shaped
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.references import Reference
from winkler.problems.line.stress import LineFields
from winkler.problems.line.strip import OfStrip
from winkler.problems.line.validity import shape_notes
from winkler.problems.normal.strong_parts import StrongPart
from winkler.validity import Assumption, Note, Standing

__all__ = ["OnPowerLaw"]

PALLOT = "A. E. Giannakopoulos, P. Pallot, J. Mech. Phys. Solids 48 (2000) 1597-1631"


class OnPowerLaw(OfStrip):
    """The part of a solution that a power law determines."""

    force_per_length: Quantity
    half_width: Quantity

    @property
    def depth(self) -> Quantity:
        """How far the bodies approach, counted from places far away [m], where the modulus grows with the depth."""
        bed: PowerLawLineFoundation = self.problem.bed
        force, a = np.ravel(self.force_per_length), np.ravel(self.half_width)
        loads = np.array([rim_load(bed, float(p), float(width)) for p, width in zip(force, a, strict=True)])
        return shaped(bed.depth(a, loads), np.shape(self.half_width))

    def approach(self, first: float | Reference | None = None, second: float | Reference | None = None) -> float:
        """Return the approach of places far away under one load [m], as `depth`.

        Parameters
        ----------
        first, second : None
            Places at a finite depth are not supported.

        Raises
        ------
        OutsideValidity
            If a place is given, or the modulus does not grow with the depth.
        """
        if first is not None or second is not None:
            raise OutsideValidity(
                "How far points inside a GradedHalfSpace move is not known to winkler; leave both out: the approach is "
                "counted from places far away."
            )
        bed: PowerLawLineFoundation = self.problem.bed
        a, edge_load = self._strip("approach")
        return float(bed.depth(np.array(a), np.array(edge_load)))

    def stresses(self, x: ArrayLike, z: ArrayLike, friction: float = 0.0) -> LineFields:
        """Refused: below the surface of a power law no field is known to winkler."""
        raise self._unknown_stresses()

    def greatest_stress(self, friction: float = 0.0, *, below: bool = True) -> Placed:
        """Refused, as `stresses`."""
        raise self._unknown_stresses()

    def part_stress(self, part: StrongPart, friction: float) -> Placed:
        """Refused, as `stresses`."""
        raise self._unknown_stresses()

    def dragged_notes(self, friction: float) -> tuple[Note, ...]:
        """Return how far the result can be trusted, as of `LineSolution.dragged_notes`."""
        bed: PowerLawLineFoundation = self.problem.bed
        response = Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Linear elastic bodies whose modulus follows one power of the depth, in plane strain under normal load: "
            "flat punches of all half-widths add up to the solution itself; the ends of a body of finite length are "
            "not included.",
            PALLOT,
        )
        range_of_law = (note for note in bed.medium.notes if note.standing is not Standing.EXACT)
        return (*range_of_law, *shape_notes(bed, float(np.max(self.half_width)), response))

    @staticmethod
    def _unknown_stresses() -> OutsideValidity:
        return OutsideValidity(
            "The stresses inside a GradedHalfSpace are not known to winkler; request the surface, or sample the "
            "grading by the layers of a CoatedHalfSpace in a LayeredLineFoundation."
        )
