"""The gap between two bodies around a place of contact, along the normals of the lower body's profile."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.profile_pair.placing import PlacedBody, Placing

FINE_ARC = 4001
"""Places along a window's arc from which the pixels' are interpolated."""
MARGIN = 0.06
"""By which part of its size a window is wider than where the bodies overlap."""
LONGER = 1.5
"""Half-length along the track of a window that is not trimmed yet, over that of the overlap of a parabola."""
FIRST_PIXELS = 48
MERGED_ANGLE = 0.2
"""Places whose profile directions differ by less [rad] are solved in one window, if they are near each other."""
MERGED_GAP = 1.5
"""What counts as near: the distance between two overlaps over the sum of their widths."""


class Window(NamedTuple):
    """A part of the lower surface: between two places across the track, and two along it.

    Parameters
    ----------
    first, last
        Across [m].
    back, front
        Along [m].
    """

    first: float
    last: float
    back: float
    front: float


class GapMap(NamedTuple):
    """The gap over a window, pixel by pixel: along the track, and along the arc of the lower profile.

    Parameters
    ----------
    x : ndarray, (n,)
        Centres of the pixels along the track [m].
    y, z : ndarray, (m,)
        Places of the lower body's profile [m].
    normal : ndarray, (2, m)
        Directions out of the lower body there, across and up.
    pixel : tuple of float
        Along the track and along the arc [m].
    gap : ndarray, (n, m)
        Along the normals [m], negative where the undeformed bodies overlap; infinite beside the bodies.
    """

    x: Array
    y: Array
    z: Array
    normal: Array
    pixel: tuple[float, float]
    gap: Array

    @classmethod
    def of(cls, lower: PlacedBody, upper: PlacedBody, window: Window, count: tuple[int, int]) -> GapMap:
        """Return the gap with `count` pixels along and across."""
        fine = np.linspace(window.first, window.last, FINE_ARC)
        middle = 0.5 * (fine[1:] + fine[:-1])
        lengths = np.hypot(1.0, lower.profile.slope(np.stack([fine[:-1], middle, fine[1:]])))
        pieces = (fine[1] - fine[0]) / 6.0 * (lengths[0] + 4.0 * lengths[1] + lengths[2])
        arc = np.concatenate([[0.0], np.cumsum(pieces)])
        pixel = (window.front - window.back) / count[0], float(arc[-1]) / count[1]
        y = np.interp((np.arange(count[1]) + 0.5) * pixel[1], arc, fine)
        x = window.back + (np.arange(count[0]) + 0.5) * pixel[0]
        slope, z = lower.profile.slope(y), lower.profile.height(y)
        normal = np.stack([-slope, np.ones(y.shape)]) / np.hypot(1.0, slope)
        points = np.stack(np.broadcast_arrays(x[:, None], y, z))
        across = np.stack(np.broadcast_arrays(np.zeros((x.size, 1)), *normal))
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            gap = upper.distance(points, across)
            if math.isfinite(lower.radius):
                gap = gap - lower.distance(points, across)
        return cls(x, y, z, normal, pixel, np.where(np.isfinite(gap), gap, np.inf))


def windows(lower: PlacedBody, upper: PlacedBody, placing: Placing, drop: float) -> list[Window]:
    """Return the windows of the lower surface in which the bodies overlap.

    Parameters
    ----------
    lower, upper : PlacedBody
        In their places, the upper one let down.
    placing : Placing
        Before the upper body was let down.
    drop : float
        How far it was let down [m].
    """
    gap = np.where(np.isfinite(placing.gap), placing.gap - drop, np.inf)
    inside = np.flatnonzero(gap < 0.0)
    if inside.size == 0:
        return []
    runs = np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1)
    angle = np.arctan(lower.profile.slope(placing.y))
    merged: list[list[int]] = []
    for run in runs:
        ends = [max(int(run[0]) - 1, 0), min(int(run[-1]) + 1, placing.y.size - 1)]
        if merged and _near(merged[-1], ends, placing.y, angle):
            merged[-1][1] = ends[1]
        else:
            merged.append(ends)
    found = []
    for first, last in merged:
        part = slice(first, last + 1)
        bending, depth = placing.bending[part], np.maximum(-gap[part], 0.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            half = np.sqrt(2.0 * depth / bending)
        reach = LONGER * float(np.max(half[np.isfinite(half)]))
        along = placing.x[part][np.isfinite(half)]
        rough = Window(
            float(placing.y[first]), float(placing.y[last]), float(along.min()) - reach, float(along.max()) + reach
        )
        found.append(_trimmed(lower, upper, rough))
    return found


def _near(before: list[int], ends: list[int], y: Array, angle: Array) -> bool:
    widths = y[before[1]] - y[before[0]] + y[ends[1]] - y[ends[0]]
    turned = abs(angle[(before[0] + before[1]) // 2] - angle[(ends[0] + ends[1]) // 2])
    return bool(y[ends[0]] - y[before[1]] <= MERGED_GAP * widths and turned <= MERGED_ANGLE)


def _trimmed(lower: PlacedBody, upper: PlacedBody, rough: Window) -> Window:
    """Return the window around the overlap along the normals."""
    low, high = lower.profile.ends
    margin = MARGIN * (rough.last - rough.first)
    wide = rough._replace(first=max(rough.first - margin, low), last=min(rough.last + margin, high))
    coarse = GapMap.of(lower, upper, wide, (FIRST_PIXELS, FIRST_PIXELS))
    i, j = np.nonzero(coarse.gap < 0.0)
    if i.size == 0:
        return rough
    y = coarse.y
    edge = 1.0 + MARGIN * (j.max() - j.min() + 1)
    first = np.interp(j.min() - edge, np.arange(y.size), y, left=wide.first)
    last = np.interp(j.max() + edge, np.arange(y.size), y, right=wide.last)
    along = coarse.pixel[0] * (1.0 + MARGIN * (i.max() - i.min() + 1))
    return Window(float(first), float(last), float(coarse.x[i.min()]) - along, float(coarse.x[i.max()]) + along)
