r"""Wear in closed form: the limiting profile of a fretting ball, the even punch, the worn cap.

A ball :math:`f=r^2/2R` pressed to d, of which the core :math:`r<c` sticks, ends as [1]_

.. math:: f_\infty(r) = \frac1{\pi R}\Big[r^2\arcsin\frac cr - c\sqrt{r^2-c^2}\Big] + \frac{2d}\pi\arccos\frac cr
          \qquad (c<r) , \qquad F_\infty = 2E^*\Big(dc-\frac{c^3}{3R}\Big) .

A flat punch under the even pressure p stands :math:`\frac{4pb}{\pi E^*}(\frac\pi2-1)` lower in its middle than at its
rim; a ball worn to the radius a has lost the cap :math:`\pi a^4/4R`.

References
----------
.. [1] V. L. Popov, Analytic solution for the limiting shape of profiles due to fretting wear, Sci. Rep. 4 (2014) 3749,
   doi:10.1038/srep03749.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def limiting_height(r: ArrayLike, *, core: float, depth: float, curvature_radius: float) -> Array:
    """Return the limiting profile of a ball beyond its core [m].

    Parameters
    ----------
    r : array_like
        Distances from the axis [m], not within the core.
    core, depth, curvature_radius : float
        c, d, R [m].
    """
    r = np.asarray(r, dtype=float)
    remaining = r * r * np.arcsin(core / r) - core * np.sqrt((r - core) * (r + core))
    return np.asarray(remaining / (math.pi * curvature_radius) + 2.0 * depth / math.pi * np.arccos(core / r))


def limiting_force(*, core: float, depth: float, curvature_radius: float, modulus: float) -> float:
    """Return the force that the core of a ball bears in the end [N]; lengths [m], modulus E* [Pa]."""
    return 2.0 * modulus * (depth * core - core**3 / (3.0 * curvature_radius))


def punch_bulge(*, pressure: float, radius: float, modulus: float) -> float:
    """Return how much more a flat punch is worn at its rim than in its middle [m], under an even pressure [Pa]."""
    return 4.0 * pressure * radius / (math.pi * modulus) * (0.5 * math.pi - 1.0)


def cap_radius(volume: float, curvature_radius: float) -> float:
    """Return the radius [m] of the cap of a volume [m^3] that was worn off a ball."""
    return float((4.0 * curvature_radius * volume / math.pi) ** 0.25)
