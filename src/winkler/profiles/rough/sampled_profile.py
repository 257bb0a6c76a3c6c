r"""A height map of a shape that is known everywhere: a profile of revolution, or curved bodies, on a grid of pixels."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.profile import Profile
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value

MOST_PIXELS_PER_SIDE = 2**13
"""Pixels along one side; more would not fit the memory of most machines."""


@value
class SampledProfile(Topography):
    """A non-periodic height map of a profile, sampled at the centres of the pixels; the apex is in its middle.

    Parameters
    ----------
    lengths : array_like, (2,)
        Lengths [m] of the map.
    profile : Profile or CurvedBodies
        f(r), or the two relative curvatures of bodies with an elliptic contact.
    shape : tuple of int, optional
        Pixels along both directions, (nx, ny); for odd numbers the apex is the centre of a pixel, and depths are
        counted from the apex.

    Raises
    ------
    InvalidInput
        If lengths or shape are out of range, or the profile is undefined or infinite on a part of the map.

    Examples
    --------
    >>> from winkler.profiles.power import Paraboloid
    >>> ball = SampledProfile([2e-3, 2e-3], Paraboloid(10e-3), (65, 65))
    >>> ball.shape, round(1e6 * float(ball.heights[32, 64]), 2)
    ((65, 65), -48.47)
    """

    heights: Array = dataclasses.field(init=False, repr=False, default_factory=lambda: np.zeros((2, 2)))
    periodic: bool = dataclasses.field(init=False, repr=False, default_factory=bool)
    tip_radius: float = dataclasses.field(init=False, repr=False, default=0.0)
    removed: str = dataclasses.field(init=False, repr=False, default="")
    reading: str = dataclasses.field(init=False, repr=False, default="")
    profile: Profile | CurvedBodies = dataclasses.field()
    shape: tuple[int, int] = (129, 129)

    def __post_init__(self) -> None:
        sides = self.shape if isinstance(self.shape, tuple | list) else ()
        whole = len(sides) == 2 and all(
            isinstance(n, int) and not isinstance(n, bool) and 2 <= n <= MOST_PIXELS_PER_SIDE for n in sides
        )
        if not whole:
            raise InvalidInput(
                f"SampledProfile: shape is {self.shape!r}; give two whole numbers from 2 to {MOST_PIXELS_PER_SIDE}."
            )
        if self.lengths.shape != (2,):
            raise InvalidInput(f"SampledProfile: lengths are {self.lengths!r}; give two positive lengths in m.")
        x, y = ((np.arange(n) - 0.5 * (n - 1)) * (length / n) for n, length in zip(sides, self.lengths, strict=True))
        try:
            rises = _rise(self.profile, x[:, None], y[None, :])
        except OutsideValidity as error:
            raise InvalidInput(f"SampledProfile: the map is wider than the profile is known: {error}") from None
        if not np.all(np.isfinite(rises)):
            raise InvalidInput(
                "SampledProfile: on some of the map the profile is infinitely high, as behind a wall, or not known; "
                "give smaller lengths."
            )
        made = Topography(0.0 - rises, self.lengths)
        object.__setattr__(self, "heights", made.heights)


def _rise(profile: Profile | CurvedBodies, x: Array, y: Array) -> Array:
    """Return the heights of a profile above its apex [m]."""
    if isinstance(profile, CurvedBodies):
        along, across = profile.longitudinal_curvature_radius, profile.lateral_curvature_radius
        return np.asarray(x**2 / (2.0 * along) + y**2 / (2.0 * across))
    r = np.hypot(x, y)
    return np.asarray(np.where(r <= profile.rim, profile.height(np.minimum(r, profile.rim)), np.inf), dtype=float)
