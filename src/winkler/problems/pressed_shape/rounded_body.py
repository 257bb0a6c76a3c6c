"""A body that is given by profiles along directions around its axis, as a surface."""

from __future__ import annotations

import math

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.types import Array
from winkler.problems.pressed_shape.pressed_map import PressedMap
from winkler.profiles.profile import Profile
from winkler.values.errors import OutsideValidity

BEYOND = 10.0
"""Gap beyond the reach of the profiles over the greatest height within it: nothing touches there."""
FIRST_REACH = 0.01
"""Part of the reach of a profile at which the size of the contact is first guessed."""


class RoundedBody:
    """The surface between profiles along equally spaced directions: a periodic cubic spline in the angle.

    Parameters
    ----------
    profiles : tuple of Profile
        From the direction of x on.
    """

    def __init__(self, profiles: tuple[Profile, ...]) -> None:
        indices: dict[Profile, int] = {}
        self.which = np.array([indices.setdefault(profile, len(indices)) for profile in profiles])
        self.profiles = tuple(indices)
        self.angles = 2.0 * math.pi * np.arange(self.which.size) / self.which.size
        self.reach = min(profile.reach for profile in self.profiles)
        turns = np.eye(self.which.size)
        before, after = np.roll(turns, 1, axis=0), np.roll(turns, -1, axis=0)
        # curvatures of the spline, of one step: those before, here and after, 1 : 4 : 1, are six times the bend
        self._bending = np.linalg.solve(before + 4.0 * turns + after, 6.0 * (before - 2.0 * turns + after))

    def gap(self, x: Array, y: Array) -> Array:
        """Return the height at places x (nx, 1) and y (1, ny) [m]."""
        r, angle = np.hypot(x, y), np.arctan2(y, x) % (2.0 * math.pi)
        there = r <= self.reach
        radii, steps = r[there], angle[there] * (self.which.size / (2.0 * math.pi))
        heights = np.stack([profile.height(radii) for profile in self.profiles])[self.which]
        bends = self._bending @ heights
        first = np.floor(steps).astype(int) % self.which.size
        ahead = steps - np.floor(steps)
        both = np.stack([first, (first + 1) % self.which.size])
        low, high = np.take_along_axis(heights, both, axis=0)
        bend, bend_ahead = np.take_along_axis(bends, both, axis=0)
        rest = 1.0 - ahead
        found = np.full(r.shape, math.nan)
        found[there] = rest * low + ahead * high + ((rest**3 - rest) * bend + (ahead**3 - ahead) * bend_ahead) / 6.0
        return np.where(there, found, BEYOND * (float(np.max(found[there])) + float(np.max(r))))

    def start(self, load: Force | Depth, modulus: float) -> float:
        """Return a radius [m] of the order of that of the contact under a load, on a half-space of E* [Pa]."""

        def reached(r: Array) -> Array:
            height = np.mean([profile.height(np.minimum(r, self.reach)) for profile in self.profiles], axis=0)
            return np.asarray(2.0 * modulus * r * height if isinstance(load, Force) else height)

        target = float(load.force) if isinstance(load, Force) else float(load.depth)
        found = rough_root(reached, target)
        return found if math.isfinite(found) and 0.0 < found < self.reach else FIRST_REACH * min(self.reach, 1e300)

    def refuse_beyond(self, contour: Array, pressed: PressedMap) -> None:
        """Refuse a contact that is wider [m] than a profile is known, unless that one ends in a rim.

        Raises
        ------
        OutsideValidity
            If it is.
        """
        ends = np.array([profile.reach if profile.rim > profile.reach else math.inf for profile in self.profiles])
        wide = np.flatnonzero(contour >= ends[self.which] - max(pressed.pixel))
        if wide.size:
            raise OutsideValidity(
                f"NearlyRoundIndentation: the depth {pressed.depth:.6g} m leads beyond the reach of the profile in "
                f"direction {wide[0]}; press less."
            )
