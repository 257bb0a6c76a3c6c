r"""How far the surfaces stand apart beside a strip, by one integral over wider ones.

.. math:: h(x) = \frac2\pi\int_c^x w'(b)\,\mathrm{arcosh}\frac xb\,\mathrm db ,

from one place where w' is not smooth to the next; with :math:`b^2 = b_0^2 + y^2` above each, and y over its greatest
value a sine, both square roots at the ends are gone.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.transforms.abel_intervals import noise, root_difference
from winkler.numerics.types import Array

__all__ = ["distance_beside"]


def distance_beside(bed: LineFoundation, half_width: float, x: Array) -> Array:
    """Return the distance of the surfaces [m] beside a strip that no rim pins.

    Parameters
    ----------
    bed : LineFoundation
    half_width : float
        c [m].
    x : ndarray
        Places [m], not negative; zero is returned inside of the strip.
    """
    if half_width == 0.0:
        return np.asarray(bed.profile.height(x))
    places = np.ravel(x)
    total = np.zeros(places.size)
    marks = [half_width, *(b for b, _ in bed.kinks if b > half_width), math.inf]
    for low, high in pairwise(marks):
        (active,) = np.nonzero(places > low)
        if active.size:
            total[active] += _between(bed, low, high, places[active])
    return np.asarray(2.0 / math.pi * total.reshape(np.shape(x)))


def _between(bed: LineFoundation, low: float, high: float, x: Array) -> Array:
    span = root_difference(x, low)
    width = np.full(x.shape, 0.5 * math.pi)
    if high < math.inf:
        last = np.arctan2(root_difference(np.asarray(high), low), root_difference(x, high))
        width = np.where(x <= high, width, last)
    first = np.nextafter(low, math.inf)

    def integrand(node: Array, index: Array) -> Array:
        angle = width[index, None] * node
        reach = span[index, None]
        y, rest = reach * np.sin(angle), reach * np.cos(angle)
        b = np.clip(np.hypot(low, y), first, np.minimum(x[index, None], high))
        slope = bed.load_profile_slope(b.ravel()).reshape(b.shape)
        grown: Array = slope * np.arcsinh(rest / b) * (y / b) * rest * width[index, None]
        return grown

    return settled(integrand, x.size, "the distance beside a strip", noise(x, low))
