r"""Adhesion of short range on any bed: Griffith's balance at the edge of the contact, explicit in its radius.

The last springs are stretched by :math:`\ell`, and the energy that is released when the edge recedes equals the work of
adhesion :math:`w` there:

.. math:: \mathcal G = \frac{k'(a)\,\ell^2}{4\pi a} = w, \qquad \ell(a) = \sqrt{\frac{4\pi a\,w}{k'(a)}}, \qquad
          d = g(a)-\ell(a), \qquad F = k(a)\,d - \int_0^a k'(x)\,g(x)\,\mathrm dx .

Along these states :math:`F' = k\,d' - k'\,\ell`.  Everything is exact for one round contact, whatever the profile and
the medium, with :math:`k'(x) = 2c_N(x)`.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array

LEAST_RADIUS = 1e-150
"""Stands for a radius of zero [m], where springs of a graded medium have no stiffness; its square is a number."""


def stretch(bed: Bed, work: float, radius: Array) -> Array:
    """Return how far the springs at the edge are stretched when it is about to recede.

    Parameters
    ----------
    bed : Bed
    work : float
        Work of adhesion [J/m^2].
    radius : ndarray
        Contact radii a [m].

    Returns
    -------
    ndarray
        l(a) = sqrt(2 pi a w / c_N(a)) [m], positive.
    """
    a = np.maximum(np.asarray(radius, dtype=float), LEAST_RADIUS)
    return np.asarray(np.sqrt(2.0 * np.pi * work * (a / bed.normal_stiffness(a))))


def depth_of(bed: Bed, work: float, radius: Array) -> Array:
    """Return d(a) = g(a) - l(a) [m]."""
    return np.asarray(bed.gap(radius) - stretch(bed, work, radius))


def force_at(bed: Bed, depth: Array, radius: Array) -> Array:
    """Return the force of the springs up to a radius at a depth, in equilibrium or not: F = k d - gap load [N]."""
    return np.asarray(bed.stiffness(radius) * depth - bed.gap_load(radius))


def energy_release_rate(bed: Bed, depth: Array, radius: Array) -> Array:
    """Return G = c_N(a) (d - g(a))^2 / (2 pi a), per area that opens at fixed depth [J/m^2]; zero without contact."""
    a = np.maximum(np.asarray(radius, dtype=float), LEAST_RADIUS)
    stretched = np.where(np.asarray(radius) > 0.0, depth - bed.gap(radius), 0.0)
    return np.asarray(bed.normal_stiffness(a) / a * stretched**2 / (2.0 * np.pi))
