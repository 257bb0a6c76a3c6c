"""One strip of contact on layers: its depth or approach, the stresses in the layers, and what is stated of it."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from winkler.numerics.types import ArrayLike, PerLoad, Q, shaped
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.layered_approach import has_depth, layered_approach
from winkler.problems.line.layered_notes import layered_notes
from winkler.problems.line.layered_stress import LayerStress, greatest_in_part, layer_stresses, layered_fields
from winkler.problems.line.peak_pressure import is_sharp, rim_load
from winkler.problems.line.references import Reference
from winkler.problems.line.stress import LineFields, one_coefficient
from winkler.problems.line.strip import OfStrip, Stressed, Strip
from winkler.problems.normal.strong_parts import StrongPart
from winkler.problems.which_body import in_first_body
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note

__all__ = ["OnLayers", "StressedOnLayers"]


class StressedOnLayers(Stressed):
    """A solution whose stresses below the surface are those of layers."""

    def stresses(self, x: ArrayLike, z: ArrayLike, friction: float = 0.0) -> LineFields:
        """Return the stresses below the surface under one load, in the layers and what carries them.

        Parameters
        ----------
        x : array_like
            Places along the surface [m].
        z : array_like
            Depths [m]: not negative in the layered body, negative in the other, of which -0.0 is the surface.
            All in one of them.  A place on an interface belongs to the upper layer.
        friction : float
            Traction with which the body is dragged along x, in its own axes, over the pressure [-].

        Raises
        ------
        InvalidInput
            If the solution has more than one load, or the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or a place lies in a rigid body.
        """
        coefficient = one_coefficient(type(self).__name__, friction)
        contact = self._touching("stresses")
        depth = np.asarray(z, dtype=float)
        below = in_first_body(depth, type(self).__name__)
        across = np.asarray(x, dtype=float)
        return layered_fields(self._bed, contact, across, depth, below, friction=coefficient)

    def _touching(self, requested: str) -> Strip:
        strip = self._strip(requested)
        if strip.half_width == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        return strip


class OnLayers(StressedOnLayers, OfStrip, PerLoad[Q]):
    """The part of a solution that a layered body determines."""

    force_per_length: Q
    half_width: Q

    @property
    def depth(self) -> Q:
        """How far a rigid body sinks into layers on a rigid base [m]; elsewhere a line contact has no depth."""
        if not has_depth(self.problem.bed.medium):
            raise OutsideValidity(
                "A line contact has a depth only where a rigid base carries the layers under a rigid body; request "
                "approach(first, second), which is counted from stated places."
            )
        shape, solution = np.shape(self.half_width), cast(Any, self)
        each = [solution.at(index) for index in np.ndindex(shape)] if shape else [self]
        strips = [(one._bed, one._strip("depth")) for one in each]
        depths = [layered_approach(bed, strip.half_width, strip.edge_load, None, None) for bed, strip in strips]
        return shaped(np.array(depths).reshape(shape))

    def approach(self, first: float | Reference | None = None, second: float | Reference | None = None) -> float:
        """Return how far two points on the axis have come together under one load [m], one in each body.

        Parameters
        ----------
        first : float, optional
            Depth of the point in the body under the layers [m], counted from the surface; not needed where it is rigid.
        second : float, RollerCentre or PlateBase, optional
            Depth of the point in the other body [m], or a finite body; not needed where it is rigid.

        Raises
        ------
        InvalidInput
            If a reference is missing or lies in the layers; or if there are many loads.
        OutsideValidity
            If the strip is wider than a fifth of a finite body.
        """
        a, edge_load = self._strip("approach")
        return layered_approach(self._bed, a, edge_load, first, second)

    def layer_stresses(self, friction: float = 0.0) -> tuple[LayerStress, ...]:
        """Return the greatest stresses of each layer under one load, and of the body under them if it is elastic.

        Parameters
        ----------
        friction : float
            As of `stresses`.

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        OutsideValidity
            If there is no contact, or the stress is infinite below a sharp tip, kink or rim.
        """
        contact = self._touching("layer_stresses")
        if is_sharp(self._bed, *contact):
            raise OutsideValidity(
                "The stress below a sharp tip, kink or rim is infinite; round it off, or request places with stresses."
            )
        return layer_stresses(self._bed, contact, one_coefficient(type(self).__name__, friction))

    def greatest_stress(self, friction: float = 0.0, *, below: bool = True) -> Placed:
        """Return the greatest von Mises stress [Pa] of the layered body under one load, and its place x, z [m].

        Parameters
        ----------
        friction : float
            As of `stresses`.
        below : bool
            In the layered body; that of the other one is not sought.

        Raises
        ------
        InvalidInput, OutsideValidity
            As of `layer_stresses`.
        """
        if not below:
            raise InvalidInput("The greatest stress is sought in the layered body only: leave below at True.")
        worst = max(self.layer_stresses(friction), key=lambda one: one.von_mises)
        return Placed(worst.von_mises, worst.x, worst.z)

    def dragged_notes(self, friction: float) -> tuple[Note, ...]:
        """Return how far the result can be trusted, as of `LineSolution.dragged_notes`."""
        widest = int(np.argmax(self.force_per_length))
        force, a = (float(np.ravel(part)[widest]) for part in (self.force_per_length, self.half_width))
        return layered_notes(self._bed, a, rim_load(self._bed, force, a), friction)

    def part_stress(self, part: StrongPart, friction: float) -> Placed:
        """Return the greatest von Mises stress [Pa] of a part, as of `LineSolution.part_stress`."""
        return greatest_in_part(self._bed, self._strip("part_stress"), part, friction)
