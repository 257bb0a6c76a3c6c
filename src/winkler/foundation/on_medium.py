"""Springs that stand on a medium: their stiffness is the medium's, whatever profile presses them."""

from __future__ import annotations

from winkler.media.medium import Medium
from winkler.numerics.types import Array

__all__ = ["OnMedium"]


class OnMedium:
    """The part of a bed that its medium tells."""

    medium: Medium

    def stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return self.medium.punch_stiffness(radius)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) [Pa]."""
        return self.medium.normal_stiffness(x)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m]."""
        return self.medium.normal_stiffness_slope(x)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa]."""
        return self.medium.tangential_stiffness(x)
