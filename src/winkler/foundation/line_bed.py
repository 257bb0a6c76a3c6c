"""What the beds of line contacts share: a two-dimensional profile, and the loads that it bears on its bodies."""

from __future__ import annotations

from typing import ClassVar, Protocol

import numpy as np

from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.validity import Note

__all__ = ["LineBed", "PressedPair"]


PLACES_BESIDE = 513
"""Places at which the slope of the distance beside a strip is added up."""


class PressedPair(Protocol):
    """The bodies of a line contact."""

    @property
    def modulus(self) -> float:
        """E* of both surfaces [Pa]."""
        ...


class LineBed:
    """A profile symmetric in x, endless along y, pressed on two bodies; in plane strain."""

    profile: Profile
    medium: PressedPair

    search_step: ClassVar[float] = 32.0
    """Factor between the half-widths that are tried before a search begins."""

    punches_push: ClassVar[bool] = True
    """Whether flat punches nowhere pull, and leave the surface beside them below: no contact whose load grows parts."""

    @property
    def reach(self) -> float:
        """Up to where the profile is known [m]."""
        return self.profile.reach

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]; infinite if nowhere."""
        return self.profile.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]; infinite if unknown."""
        return self.profile.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: just above x, w' holds strength / sqrt(a^2 - x^2)."""
        return tuple((b, b * jump) for b, jump in self.profile.kinks)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about the shape."""
        return self.profile.notes

    @property
    def flat(self) -> float:
        """Half-width of the flat middle [m]: the contact opens with it."""
        end, flat = min(self.reach, self.rim), 0.0
        for b in (*(b for b, _ in self.profile.kinks if b < end), end):
            if not np.isfinite(b) or float(self.profile.height(np.array([b]))[0]) != 0.0:
                break
            flat = b
        return flat

    @property
    def trial(self) -> float:
        """Distance of the edge from the flat middle at which a search begins [m]; infinite if the load decides."""
        return np.inf

    @property
    def single(self) -> bool:
        """Whether every contact is known to be one strip."""
        return self.profile.rising

    def slope(self, x: Array) -> Array:
        """f'(x) [-]."""
        return self.profile.slope(x)

    def load_profile(self, half_width: Array) -> Array:
        """Return the load per length over E* [m]."""
        raise NotImplementedError

    def load_profile_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [-]."""
        raise NotImplementedError

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa]: zero outside, infinite at a rim, a kink and a sharp tip.

        Parameters
        ----------
        x : ndarray
            Places on the surface [m], on either side.
        half_width : float
            a [m].
        rim_load : float
            Load per length over E* that the edge bears beyond `load_profile` [m]: at a rim, or negative where adhesion
            pulls.
        """
        raise NotImplementedError

    def opening(self, x: Array, half_width: float) -> Array:
        """Return the slope h'(x) [-] of the distance of the surfaces at x > a."""
        raise NotImplementedError

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F(x) [Pa] of `winkler.numerics.fields.half_plane` on the surface, at x >= 0."""
        raise NotImplementedError

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return F [Pa] and F' [Pa/m] below the surface, at x >= 0."""
        raise NotImplementedError

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, zero inside."""
        if half_width == 0.0:
            return np.asarray(self.profile.height(x))
        edges = [half_width, *(b for b, _ in self.kinks if b > half_width)]

        def opening(x: Array) -> Array:
            beyond = np.maximum(x, np.nextafter(half_width, np.inf))
            return np.where(x > half_width, self.opening(beyond, half_width), 0.0)

        beside = np.maximum(x, half_width)
        logarithm = np.log1p((beside - half_width + abel.root_difference(beside, half_width)) / half_width)
        return np.asarray(abel.integral(opening, edges, x) - 2.0 / np.pi * rim_load * logarithm)

    def examined(self, half_width: Array) -> Array:
        """Return those of many half-widths, ascending [m], whose contacts are to be examined: all."""
        return half_width

    def gaps(self, half_width: float, end: float) -> tuple[Array, Array]:
        """Return places beside a strip up to `end` [m], and a measure of the distance of the surfaces there."""
        x = np.linspace(half_width, end, PLACES_BESIDE)[1:-1]
        if not half_width < x[0]:
            return x, np.zeros(x.size)
        return x, np.cumsum(self.opening(x, half_width))
