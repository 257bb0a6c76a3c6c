"""Springs that stand on a medium: their stiffness is the medium's; under a profile it gives their gap, too."""

from __future__ import annotations

import dataclasses
from typing import Self

from winkler.foundation.footprint import Footprint, footprint_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values.validity import Note


class OnMedium:
    """The part of a bed that its medium determines."""

    medium: Medium

    def with_medium(self, medium: Medium) -> Self:
        """Return the same bed on another medium."""
        return dataclasses.replace(self, medium=medium)  # type: ignore[type-var]

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


class OfShape(OnMedium):
    """The part of a bed that the extent of a shape determines: of a body, or of a plane profile."""

    @property
    def _shape(self) -> Profile:
        raise NotImplementedError

    @property
    def footprint(self) -> Footprint:
        """That of the shape: a disc, unless the shape stands for another outline."""
        return footprint_of(self._shape)

    @property
    def reach(self) -> float:
        """The greatest x for which the bed is defined [m]."""
        return self._shape.reach

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]."""
        return self._shape.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]."""
        return self._shape.size

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about shape and medium."""
        return (*self.medium.notes, *self._shape.notes)


class UnderProfile(OfShape):
    """The part of a bed that a profile determines together with the medium."""

    profile: Profile

    @property
    def _shape(self) -> Profile:
        return self.profile

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` where g is not smooth, as the medium states."""
        return self.medium.kinks(self.profile)

    @property
    def rising(self) -> bool:
        """Whether the body, on a homogeneous half-space, is known to have a g that never falls."""
        return self.profile.rising

    @property
    def certain(self) -> bool:
        """Whether every contact is known to be one disc: on a homogeneous half-space a g that never falls suffices."""
        return isinstance(self.medium, HomogeneousMedium) and self.profile.rising

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self.profile.height(r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self.profile.slope(r)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.medium.gap(self.profile, x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.medium.gap_slope(self.profile, x)

    def gap_load(self, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""
        return self.medium.gap_load(self.profile, radius)
