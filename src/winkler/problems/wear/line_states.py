"""What a worn line contact is after some cycles or some distance."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.numerics.types import Array
from winkler.problems.wear.states import WornState
from winkler.values.value import value, words


@value
class LineWearState(WornState):
    """A line contact that has worn by sliding.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies before wear.
    elapsed : float
        How far wear has come: cycles, or distance slid [m].
    jump : float
        How far the next jump of the march would go, as `elapsed`.
    places : ndarray, (n,)
        x [m] of the nodes, from the middle on; the other side is the same.
    first_worn, second_worn : ndarray, (n,)
        What the first and the second body have lost there [m].
    force_per_length, half_width : float
        P [N/m], a [m].
    pressure : ndarray, (n,)
        p [Pa], the mean over a strip about each node.
    """

    __words__ = words(
        moment=("", None, "from where the march goes on"),
        places=("x_i", "m", "distances from the middle"),
        nodes=("x_i", "m", "distances from the middle"),
        edge=("a", "m", "half-width"),
        removed=("V'", "m^2", "what both bodies have lost, per length of the line"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    elapsed: float
    jump: float
    places: Array
    first_worn: Array
    second_worn: Array
    force_per_length: float
    half_width: float
    pressure: Array

    @property
    def nodes(self) -> Array:
        """As `places`."""
        return self.places

    @property
    def edge(self) -> float:
        """As `half_width`."""
        return self.half_width

    @property
    def _load(self) -> float:
        return self.force_per_length

    def _stiffness(self, medium: Any) -> float:
        """Return the load per length over E* at the half-width on a medium, times its E* [N/m]."""
        whole: Any = self.bed
        bed = dataclasses.replace(whole, medium=medium)
        return float(bed.medium.modulus * bed.load_profile(np.array([self.half_width]))[0])

    @property
    def mean_pressure(self) -> float:
        """P / (2 a) [Pa]; zero without contact."""
        return self.force_per_length / (2.0 * self.half_width) if self.half_width > 0.0 else 0.0

    @property
    def worn_volume_per_length(self) -> float:
        """What both bodies have lost, per length of the line [m^2]."""
        return self._removed(self.worn)

    @property
    def first_volume_per_length(self) -> float:
        """What the first body has lost, per length of the line [m^2]."""
        return self._removed(self.first_worn)

    @property
    def second_volume_per_length(self) -> float:
        """What the second body has lost, per length of the line [m^2]."""
        return self._removed(self.second_worn)


@value
class LineFrettingState(LineWearState):
    """A line contact that has worn by fretting.

    Parameters
    ----------
    shear_force_per_length : float
        Amplitude Q of the shear force per length [N/m].
    stick_half_width : float
        c [m]: nothing slips inside; a if nothing slips at all.
    slip : ndarray, (n,)
        Amplitude of the slip at the nodes [m].
    dissipation_per_length : float
        Dissipated energy per cycle and length [J/m].
    """

    __words__ = words(
        shear_force_per_length=("Q", "N/m", "amplitude of the shear force per length"),
        slip=("s", "m", "amplitude of the slip"),
        dissipation_per_length=("W_d", "J/m", "energy per length lost in every cycle"),
    )

    shear_force_per_length: float
    stick_half_width: float
    slip: Array
    dissipation_per_length: float
