"""The contour of a nearly round contact: its radius in every direction, found from the springs of each."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.bracketing import between
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth
from winkler.profiles.profile import Profile
from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["Directions"]

MOST_ITERATIONS = 60
FORCE_TOLERANCE = 1e-13
DOUBLINGS = 60
END_MARGIN = 1e-12
LEAST_RATIO = 1e-9
"""Over the radius where g(a) = d, where a contour is no longer sought."""


class Directions:
    """The springs of all directions, those of equal profiles once."""

    def __init__(self, profiles: tuple[Profile, ...], medium: HomogeneousMedium) -> None:
        indices: dict[Profile, int] = {}
        self.which = np.array([indices.setdefault(profile, len(indices)) for profile in profiles])
        self.beds = [Foundation(profile, medium) for profile in indices]  # type: ignore[arg-type]
        self.rims = np.array([bed.rim for bed in self.beds])[self.which]
        # where a profile ends without a rim its g may be infinite
        self.ends = np.array([min(bed.rim, bed.reach * (1.0 - END_MARGIN)) for bed in self.beds])[self.which]
        self.twice = 2.0 * medium.modulus

    def shallow(self, forces: Array) -> float:
        """Return a depth [m] where a search for these forces [N] may begin."""
        bed = self.beds[0]
        length = 0.01 * float(np.min(self.ends))
        if not math.isfinite(length):
            most = float(np.max(forces))
            length = rough_root(lambda a: bed.stiffness(a) * bed.gap(a) - bed.gap_load(a), most)
        place = np.array([length])
        return max(*(float(bed.gap(place)[0]) for bed in self.beds), 1e-6 * length)

    def pressed(self, depths: Array) -> tuple[Array, Array, Array]:
        """Return forces [N], stiffnesses [N/m] (m,) and contours [m] (m, n) at depths (m,)."""
        with np.errstate(divide="ignore", invalid="ignore"):  # next to where a profile ends
            return self._settled(depths)

    def _settled(self, depths: Array) -> tuple[Array, Array, Array]:
        touching = np.stack([at_depth(bed, depths)[1] for bed in self.beds], axis=1)[:, self.which]
        low = self._lows(depths, touching)
        radii = touching
        level = self._level(radii, depths)
        for _ in range(MOST_ITERATIONS):
            radii = self._contour(level, depths, low, touching)
            new = self._level(radii, depths)
            if np.all(np.abs(new - level) <= FORCE_TOLERANCE * np.abs(new)):
                mean = np.mean(radii, axis=1)
                return self.twice * new, self.twice * np.mean(radii**2, axis=1) / mean, radii
            level = new
        raise NotConverged(f"NearlyRoundIndentation: at the depth {depths[0]:.6g} m the force does not settle.")

    def _level(self, radii: Array, depths: Array) -> Array:
        """Return F / (2 E*) [m^2] of contours."""
        depth, every = np.broadcast_to(depths[:, None], radii.shape).ravel(), np.arange(radii.size)
        pressed = self._pressed(radii.ravel(), depth, every).reshape(radii.shape)
        return np.asarray(np.mean(radii * pressed, axis=1) / np.mean(radii, axis=1))

    def _bed_values(self, word: str, radii: Array, index: Array) -> Array:
        """Return a quantity of the bed of every direction at radii (k,), those at `index` of all (m n,)."""
        which, rows = self.which[index % self.which.size], np.empty(radii.size)
        for number, bed in enumerate(self.beds):
            here = which == number
            if here.any():
                rows[here] = getattr(bed, word)(radii[here])
        return rows

    def _pressed(self, radii: Array, depth: Array, index: Array) -> Array:
        """Return I, the integral of d - g up to the contour [m^2]."""
        return np.asarray(depth * radii - self._bed_values("gap_load", radii, index) / self.twice)

    def _balance(self, radii: Array, depth: Array, index: Array) -> Array:
        """Return I + a (d - g(a)), which falls where the contour may lie."""
        return np.asarray(self._pressed(radii, depth, index) + radii * (depth - self._bed_values("gap", radii, index)))

    def _lows(self, depths: Array, touching: Array) -> Array:
        """Return the radii from which on the balance falls; the rim where it never does."""
        depth = np.repeat(depths, self.which.size)

        def steepness(logarithm: Array, index: Array) -> Array:
            a = np.exp(logarithm)
            spring = depth[index] - self._bed_values("gap", a, index)
            return np.asarray(2.0 * spring - a * self._bed_values("gap_slope", a, index))

        high = np.log(touching).ravel()
        rising = steepness(high, np.arange(high.size)) >= 0.0
        log_radius = high.copy()
        places = np.flatnonzero(~rising)
        log_radius[places] = between(
            lambda at, index: steepness(at, places[index]), high[places] + math.log(LEAST_RATIO), high[places]
        )
        return np.asarray(np.exp(log_radius).reshape(touching.shape))

    def _contour(self, level: Array, depths: Array, low: Array, touching: Array) -> Array:
        """Return where the balance is `level` in every direction; the rim where it is more."""
        count = self.which.size
        depth, wanted = np.repeat(depths, count), np.repeat(level, count)

        def missing(logarithm: Array, index: Array) -> Array:
            return np.asarray(self._balance(np.exp(logarithm), depth[index], index) - wanted[index])

        bottom, top = np.log(low).ravel(), np.log(touching).ravel()
        every, end = np.arange(bottom.size), np.log(np.tile(self.ends, depths.size))
        bad = missing(bottom, every) < -FORCE_TOLERANCE * wanted
        if bad.any():
            raise OutsideValidity(
                f"NearlyRoundIndentation: at the depth {depth[bad][0]:.6g} m there is no contour, the body is too far "
                "from round; use SurfaceContact."
            )
        above = every[missing(top, every) > 0.0]
        for _ in range(DOUBLINGS):
            above = above[top[above] < end[above]]
            if not above.size:
                break
            top[above] = np.minimum(top[above] + math.log(2.0), end[above])
            above = above[missing(top[above], above) > 0.0]
        pinned = missing(top, every) >= 0.0
        short = pinned & (np.tile(self.rims, depths.size) > np.exp(top))
        if short.any():
            raise OutsideValidity(
                f"NearlyRoundIndentation: the depth {depth[short][0]:.6g} m leads beyond the reach of the profile in "
                f"direction {np.flatnonzero(short)[0] % count}; press less."
            )
        free = every[~pinned]
        log_radius = top.copy()
        log_radius[free] = between(lambda at, index: missing(at, free[index]), np.minimum(bottom, top)[free], top[free])
        return np.asarray(np.exp(log_radius).reshape(low.shape))
