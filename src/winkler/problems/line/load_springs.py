"""Springs whose depth is the force per length of a line contact: g = E* w, c_N = 1/E* on half-planes."""

from __future__ import annotations

import functools
from typing import cast

import numpy as np

from winkler.foundation.footprint import Footprint, footprint_of
from winkler.foundation.line_bed import LineBed
from winkler.media.medium import Medium
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged
from winkler.values.validity import Note
from winkler.values.value import value, words

WALL = 1e-2
"""Part of the reach that is left out before a vertical wall."""


@value
class LoadSprings:
    """Springs whose depth is the force per length of a line contact: g = E* w [N/m], c_N = s^2/E*.

    s is the tension at the edges of a flat punch over that on half-planes: one there.

    Parameters
    ----------
    line : LineFoundation or LayeredLineFoundation
    """

    __words__ = words(
        line=("", None, "the line contact that the springs represent"),
        certain=("", None, "whether every contact is known to be one strip"),
        rising=("", None, "whether the load profile is known to rise"),
    )

    line: LineBed

    def outline(self) -> LoadSprings:
        """Return those of the same profile on half-planes, which cost less."""
        return LoadSprings(self.line.half_plane)

    @property
    def medium(self) -> Medium:
        """That of the line contact."""
        return cast(Medium, self.line.medium)

    @property
    def footprint(self) -> Footprint:
        """That of the profile."""
        return footprint_of(self.line.profile)

    @property
    def reach(self) -> float:
        """Up to where w is known [m]: close to the end of a profile that ends in a vertical wall."""
        return _known_to(self.line)

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]."""
        return self.line.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]."""
        return self.line.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of w', times E*."""
        return tuple((b, self.line.medium.modulus * strength) for b, strength in self.line.kinks)

    @property
    def rising(self) -> bool:
        """Whether w is known to rise."""
        return self.line.profile.rising

    certain = rising
    """As `rising`."""

    @property
    def notes(self) -> tuple[Note, ...]:
        """Those of the shape."""
        return self.line.notes

    def height(self, r: Array) -> Array:
        """E* f(r)."""
        return np.asarray(self.line.medium.modulus * self.line.profile.height(r))

    def slope(self, r: Array) -> Array:
        """E* f'(r)."""
        return np.asarray(self.line.medium.modulus * self.line.slope(r))

    def gap(self, x: Array) -> Array:
        """E* w(x) [N/m]."""
        return np.asarray(self.line.medium.modulus * self.line.load_profile(x))

    def gap_slope(self, x: Array) -> Array:
        """E* w'(x) [Pa]."""
        return np.asarray(self.line.medium.modulus * self.line.load_profile_slope(x))

    def gap_load(self, radius: Array) -> Array:
        """2 times the integral of w [m^2]."""
        return abel.integral(
            lambda x: 2.0 * self.line.load_profile(x), [b for b, _ in self.kinks], np.asarray(radius, dtype=float)
        )

    def stiffness(self, radius: Array) -> Array:
        """2 a / E*, on half-planes: it scales searches and decides nothing."""
        return np.asarray(2.0 * np.asarray(radius) / self.line.medium.modulus)

    def normal_stiffness(self, x: Array) -> Array:
        """s^2 / E* [1/Pa]."""
        return np.asarray(self.line.edge_share(x) ** 2 / self.line.medium.modulus)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """2 s s' / E* [1/(Pa m)]."""
        return np.asarray(2.0 * self.line.edge_share(x) * self.line.edge_share_slope(x) / self.line.medium.modulus)

    def tangential_stiffness(self, x: Array) -> Array:
        """1 / G* [1/Pa]."""
        return 1.0 / cast(Medium, self.line.half_plane.medium).tangential_stiffness(x)


@functools.lru_cache(maxsize=64)
def _known_to(line: LineBed) -> float:
    if not np.isfinite(line.reach):
        return line.reach
    try:
        with np.errstate(all="ignore"):
            known = bool(np.isfinite(line.half_plane.load_profile(np.array([line.reach])))[0])
    except NotConverged:  # vertical there
        known = False
    return line.reach if known else line.reach * (1.0 - WALL)
