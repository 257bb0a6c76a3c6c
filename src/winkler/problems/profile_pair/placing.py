r"""Two bodies of given profiles in space: distances between their surfaces, and where they first touch.

A body is its profile z(s), swept along x or revolved about an axis along s: with the radius R of the place z = 0 its
surface is, in its own axes a along, s across and c up,

.. math:: c = z(s) \quad\text{or}\quad c = \pm\left(\sqrt{(R\pm z(s))^2-a^2}-R\right) ,

with the axis below (+) the lower body and above (-) the upper one.  The axes of the lower body are those of the track;
those of the upper one are turned by yaw and roll about the place s = 0, z = 0 of its profile.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.sections.cross_profile import CrossProfile

NEWTON_STEPS = 8
"""Of the search for a surface along a line."""
ROUNDING = 1e-15
"""Step of it over the width of the profile that is rounding."""
LINES = 2001
"""Vertical planes across the track among which the nearest places are sought."""
ZOOMS, ZOOM_LINES = 3, 41
"""Finer planes around the nearest one, and how many at a time."""
NEAREST, FARTHEST, NEAR_LINES = 1e-7, 1e-2, 200
"""Further planes on either side of the nearest one: their distances from it over the width, and how many."""
STEPS_ALONG = 6
"""Of the search along the track for the place where the bodies are nearest in one of these planes."""
STENCIL = 1e-3
"""Distance of the three places of a parabola along the track over the radius of the body."""


class PlacedBody(NamedTuple):
    """One body in space.

    Parameters
    ----------
    profile
        Its surface across.
    radius
        Of revolution at z = 0 [m]; infinite for a straight body.
    up
        +1 if its axis lies below its surface, -1 if above.
    place
        Of the profile's zero, along, across and up [m].
    axes
        Rows: its directions a, s and c.
    """

    profile: CrossProfile
    radius: float
    up: float
    place: Array
    axes: Array

    def raised(self, height: float) -> PlacedBody:
        """Return the body moved up [m]."""
        return self._replace(place=self.place + np.array([0.0, 0.0, height]))

    def own(self, points: Array) -> Array:
        """Return places (3, ...) in the axes of the body."""
        away = points - self.place.reshape(3, *(1,) * (points.ndim - 1))
        return np.asarray(np.einsum("ij,j...->i...", self.axes, away))

    def height(self, a: Array, s: Array) -> tuple[Array, Array, Array]:
        """Return c of the surface, and its slopes along a and s; not a number beyond the profile."""
        z, slope = self.profile.height(s), self.profile.slope(s)
        if math.isinf(self.radius):
            return z, np.zeros(z.shape), slope
        r = self.radius + self.up * z
        root = np.sqrt(np.where(np.abs(a) < r, r * r - a * a, np.nan))
        c = self.up * (self.up * z * (r + self.radius) - a * a) / (root + self.radius)
        return c, -self.up * a / root, slope * r / root

    def distance(self, points: Array, direction: Array) -> Array:
        """Return how far the surface is from places (3, ...) along a direction (3, ...) [m].

        Not a number where the body ends.
        """
        start, turned = self.own(points), np.einsum("ij,j...->i...", self.axes, direction)
        if math.isinf(self.radius) and not np.any(turned[:2]):
            return np.asarray((self.height(start[0], start[1])[0] - start[2]) / turned[2])
        t, size = np.zeros(start.shape[1:]), self.profile.ends[1] - self.profile.ends[0]
        for _ in range(NEWTON_STEPS):
            a, s, c = start + t * turned
            height, along, across = self.height(a, s)
            step = (height - c) / (turned[2] - along * turned[0] - across * turned[1])
            t = t + step
            if not np.any(np.abs(step) > ROUNDING * size):
                break
        return np.asarray(t)


def lower_body(profile: CrossProfile, radius: float) -> PlacedBody:
    """Return the lower body, in the axes of the track."""
    return PlacedBody(profile, radius, 1.0, np.zeros(3), np.eye(3))


def upper_body(profile: CrossProfile, radius: float, lateral: float, yaw: float, roll: float) -> PlacedBody:
    """Return the upper body at the height zero.

    Parameters
    ----------
    profile, radius
        As of `PlacedBody`.
    lateral : float
        Where its profile's zero stands across the track [m].
    yaw, roll : float
        Turns [rad]: of its direction along towards +y, and of its side at +y downwards.
    """
    c, s, p, q = math.cos(yaw), math.sin(yaw), math.cos(roll), math.sin(roll)
    axes = np.array([[c, s, 0.0], [-s * p, c * p, -q], [-s * q, c * q, p]])
    return PlacedBody(profile, radius, -1.0, np.array([0.0, lateral, 0.0]), axes)


class Placing(NamedTuple):
    """The distances of two bodies across the track.

    Parameters
    ----------
    y : ndarray, (n,)
        Across the track [m].
    x : ndarray, (n,)
        Where along the track the bodies are nearest there [m].
    gap : ndarray, (n,)
        Height of the upper surface over the lower one there [m]; not a number beside the bodies.
    bending : ndarray, (n,)
        Second derivative of the gap along the track [1/m].
    """

    y: Array
    x: Array
    gap: Array
    bending: Array

    @classmethod
    def of(cls, lower: PlacedBody, upper: PlacedBody) -> Placing:
        """Return the distances of two bodies."""
        low, high = lower.profile.ends
        ends = upper.profile.ends
        corners = sorted(float(upper.place[1]) + float(upper.axes[1, 1]) * end for end in ends)
        y = np.linspace(max(low, corners[0]), min(high, corners[1]), LINES)
        found = cls._on(lower, upper, y)
        if not np.any(np.isfinite(found.gap)):
            return found
        span, spacing = float(y[-1] - y[0]), float(y[1] - y[0])
        place = float(y[np.nanargmin(found.gap)])
        for _ in range(ZOOMS):
            near = np.clip(place + spacing * np.linspace(-1.0, 1.0, ZOOM_LINES), y[0], y[-1])
            gap = cls._on(lower, upper, near).gap
            place = float(near[np.nanargmin(gap)]) if np.any(np.isfinite(gap)) else place
            spacing *= 4.0 / ZOOM_LINES
        away = span * np.geomspace(NEAREST, FARTHEST, NEAR_LINES)
        near = np.concatenate([place - away[::-1], [place], place + away])
        return cls._on(lower, upper, np.unique(np.concatenate([y, near[(near > y[0]) & (near < y[-1])]])))

    @classmethod
    def _on(cls, lower: PlacedBody, upper: PlacedBody, y: Array) -> Placing:
        """Return the distances in planes at y."""
        radii = [body.radius for body in (lower, upper) if math.isfinite(body.radius)]
        ends = upper.profile.ends
        step = STENCIL * (min(radii) if radii else ends[1] - ends[0])
        x = np.zeros(y.shape)
        for _ in range(STEPS_ALONG):
            before, here, after = (_vertical(lower, upper, x + part, y) for part in (-step, 0.0, step))
            bending = (before - 2.0 * here + after) / step**2
            change = np.where(bending > 0.0, -0.5 * (after - before) / step / bending, 0.0)
            x = np.where(np.isfinite(change), x + change, x)
        return cls(y, x, _vertical(lower, upper, x, y), bending)


def _vertical(lower: PlacedBody, upper: PlacedBody, x: Array, y: Array) -> Array:
    """Return the height of the upper surface over the lower one [m]."""
    points = np.stack([x, y, np.zeros(x.shape)])
    up = np.zeros(points.shape)
    up[2] = 1.0
    return upper.distance(points, up) - lower.distance(points, up)
