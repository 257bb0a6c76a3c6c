"""Sections with two equal flanks: a profile to the left and right of its middle."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.area import AreaFunction
from winkler.profiles.profile import Profile
from winkler.profiles.sections.section import SIDE, Section
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput
from winkler.values.validity import Note
from winkler.values.value import value, words

LEAST_TIP = 1e-12
"""Slope beside the middle up to which there is no tip: that of a rounded crest, next to zero, is not quite zero."""


@value
class MirroredSection(Section):
    """A profile with two equal flanks, cut off vertically at a stated width.

    Parameters
    ----------
    profile : Profile
        Height at the distance of x from the middle, x = 0.
    width : float
        Width of the section [m]: the body ends at half of the width on each side, or at the rim of the profile.

    Raises
    ------
    InvalidInput
        If the profile is not known so far, or states cross-sections of a tip of revolution.
    """

    __words__ = words(width=("L", "m", "width of the section"))

    profile: Profile
    width: Positive

    def __post_init__(self) -> None:
        if isinstance(self.profile, AreaFunction):
            raise InvalidInput(
                "MirroredSection: an AreaFunction states the round cross-sections of a tip; give a shape."
            )
        if 0.5 * self.width > min(self.profile.reach, self.profile.rim):
            raise InvalidInput(
                f"MirroredSection: the profile ends at {min(self.profile.reach, self.profile.rim):.6g} m; give a width "
                "of at most twice of that."
            )

    @property
    def start(self) -> float:
        """Left end [m]."""
        return -0.5 * self.width

    @property
    def end(self) -> float:
        """Right end [m]."""
        return 0.5 * self.width

    @property
    def pads(self) -> tuple[tuple[float, float], ...]:
        """The range from end to end."""
        return ((self.start, self.end),)

    @property
    def breaks(self) -> tuple[tuple[float, float, float], ...]:
        """Those of the profile on either side, and a sharp tip."""
        found = []
        for place, jump in self.profile.kinks:
            if 0.0 < place < self.end:
                curved = getattr(self.profile, "curvature", None)
                sides = place * (1.0 + SIDE * np.array([-1.0, 1.0]))
                bend = float(np.diff(curved(sides))[0]) if curved is not None else 0.0
                found += [(place, jump, bend), (-place, jump, -bend)]
        tip = float(self.profile.slope(np.array([np.nextafter(0.0, 1.0)]))[0])
        if tip > LEAST_TIP:
            found.append((0.0, 2.0 * tip, 0.0))
        return tuple(sorted(found))

    @property
    def notes(self) -> tuple[Note, ...]:
        """Those of the profile."""
        return self.profile.notes

    def height(self, x: Array) -> Array:
        """The height [m], the same on both sides of x = 0."""
        return np.asarray(self.profile.height(np.abs(x)))

    def slope(self, x: Array) -> Array:
        """The slope of the height; it changes its sign at x = 0."""
        return np.asarray(np.where(np.asarray(x) < 0.0, -1.0, 1.0) * self.profile.slope(np.abs(x)))
