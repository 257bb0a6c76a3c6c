r"""What a layered surface moves beyond a homogeneous one, at the distance r from a point force and under a disc.

The compliance :math:`\frac{2}{E^*\xi}(1+M(\xi))` adds to Boussinesq's displacement the kernel

.. math:: k(r) = \frac1\pi\int_0^\infty M(\xi)\,J_0(\xi r)\,\mathrm d\xi = \frac1\pi\int_0^{\pi/2}C(r\sin\theta)\,
          \mathrm d\theta , \qquad
          Q(r) = \int_0^r k\,r'\,\mathrm dr' = \frac{r^2}\pi\int_0^{\pi/2}C(r\sin\theta)\cos^2\theta\,\mathrm d\theta ,

C the cosine transform of M (`winkler.numerics.transforms.cosine_transform`), which is smooth octave by octave; so are
both functions, kept as Chebyshev polynomials.  Nothing oscillates, however far.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms.cosine_transform import LEAST_RESPONSE, WaveResponse, transform
from winkler.numerics.types import Array

NODES = 32
"""Of the quadrature, in every octave of sin theta."""
TOLERANCE_RATIO = 10.0
"""Error of r k and of Q / r, over the precision of M: what the transform C leaves."""


class RadialKernel(NamedTuple):
    """k and Q of a response, in its own unit of length.

    Parameters
    ----------
    length : float
        On which both are smooth near r = 0.
    point, disc : Panels
        w k and w Q / r^2 as functions of r, w the hypotenuse of r and `length`.
    """

    length: float
    point: Panels
    disc: Panels

    def at(self, r: Array) -> Array:
        """Return k(r)."""
        return np.asarray(self.point(r) / np.hypot(r, self.length))

    def within(self, r: Array) -> Array:
        """Return Q(r), the integral of k r from 0 to r."""
        return np.asarray(r * r * self.disc(r) / np.hypot(r, self.length))


@cached_by_value(64)
def radial_kernel(response: WaveResponse, octave: int) -> RadialKernel:
    """Return k and Q up to r = `length` times two to the power of `octave`; cached by value.

    Parameters
    ----------
    response : WaveResponse
        M, in its own unit of length.
    octave : int
        Not negative.

    Raises
    ------
    NotConverged
        If C is not resolved: the contrasts are too large.
    """
    sines, shares = _angles(octave)
    found = _summed(response, octave, sines, (shares, shares * (1.0 - sines) * (1.0 + sines)))
    return RadialKernel(response.length, *found)


@cached_by_value(64)
def turning_kernel(response: WaveResponse, octave: int) -> RadialKernel:
    r"""Return the same with J_2 in the place of J_0: what turns with twice the angle of a traction.

    .. math:: k_2(r) = \frac1\pi\int_0^\infty M(\xi)\,J_2(\xi r)\,\mathrm d\xi
                     = \frac1\pi\int_0^{\pi/2}C(r\sin\theta)\cos2\theta\,\mathrm d\theta .

    Its integral over a disc is zero, and not known here.

    Parameters
    ----------
    response, octave
        As of `radial_kernel`.

    Raises
    ------
    NotConverged
        As `radial_kernel`.
    """
    sines, shares = _angles(octave)
    (point,) = _summed(response, octave, sines, (shares * (1.0 - 2.0 * sines**2),))
    return RadialKernel(response.length, point, point)


def _angles(octave: int) -> tuple[Array, Array]:
    """Return sines of theta and weights over pi: octaves of the sine below 1/2 by Gauss' rule, the rest in theta."""
    node, weight = gauss_legendre(NODES)
    starts = np.concatenate(([0.0], 0.5 ** np.arange(octave + 1, 0, -1)))
    sines, shares = panel_nodes(starts, NODES)
    angle, rest = math.pi / 6.0 + math.pi / 3.0 * node, math.pi / 3.0 * weight
    return np.append(sines, np.sin(angle)), np.append(shares / np.sqrt(1.0 - sines**2), rest) / math.pi


def _summed(response: WaveResponse, octave: int, sines: Array, weights: tuple[Array, ...]) -> list[Panels]:
    """Return the hypotenuse of r and the length, times the sums of C(r sin theta) with these weights."""
    length = response.length
    edges = length * np.concatenate(([0.0], 2.0 ** np.arange(octave + 1)))
    curve = transform(response, float(edges[-1]))
    size = float(np.max(np.abs(response.excess(np.concatenate(([1e-3 / response.span], 1.0 / edges[1:]))))))
    tolerance = TOLERANCE_RATIO * response.precision * (size + LEAST_RESPONSE)

    def along(r: Array, share: Array) -> Array:
        return np.asarray(np.hypot(r, length) * (curve(r[..., None] * sines) @ share))

    return [fit_panels(functools.partial(along, share=share), edges, tolerance) for share in weights]
