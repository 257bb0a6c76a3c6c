"""One strip of contact on layers: its depth or approach, the stresses in the layers, and what is stated of it."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.layered_approach import has_depth, layered_approach
from winkler.problems.line.layered_stress import LayerStress, layer_stresses
from winkler.problems.line.peak_pressure import is_sharp
from winkler.problems.line.stress import one_coefficient
from winkler.problems.line.strip import OfStrip
from winkler.values.errors import InvalidInput, OutsideValidity


class OnLayers(OfStrip, PerLoad[Q]):
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
