r"""The surface displacement of an axisymmetric pressure by direct superposition of point forces.

A point force F moves the surface of a half-space at the distance s by u = F/(pi E* s); a pressure therefore by

.. math:: u(r) = \frac{1}{\pi E^*}\iint\frac{p}{s}\,\mathrm dA
               = \frac{4}{\pi E^*}\int_0^a \frac{p(s)\,s}{r+s}\,K\!\left(\frac{4rs}{(r+s)^2}\right)\mathrm ds ,

the inner integral being the potential of a ring (K with the parameter m).  This is how contact problems were solved
before there was a reduction of dimensionality [1]_; it uses no springs, and so it is an independent check of them.

With s = a cos(eta) a pressure that ends like (a^2 - s^2)^edge is a smooth function of eta times
eta^(2 edge + 1).  The interval is cut at r and at every other place where the integrand is not smooth, and
Gauss' panels shrink geometrically towards each cut; distances to the cut are carried exactly, so that the
logarithm of the ring at s = r costs no digits.

References
----------
.. [1] J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris (1885); K. L. Johnson, Contact Mechanics,
   Cambridge University Press (1985), chapter 3, doi:10.1017/CBO9781139171731.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from scipy.special import ellipkm1, roots_jacobi

from winkler.numerics.types import Array, ArrayLike, Curve

NODES_PER_PANEL = 20
"""Gauss points of a panel: with RATIO an error of about 1e-16 for a logarithm at the end of the row."""
PANEL_RATIO = 0.2
PANEL_COUNT = 24
"""Panels towards a cut; the last one is RATIO^23 = 1e-16 of the first."""
RIM_DISTANCE = 3.0e-6
"""Closer to the edge than this eta (s/a > 1 - 5e-12) the pressure follows its power law: there rounding of s would
spoil a pressure that is infinite at the edge."""


def point_force_displacement(force: ArrayLike, distance: ArrayLike, *, modulus: float) -> Array:
    """Return the normal displacement of the surface [m] at a distance from a point force.

    Parameters
    ----------
    force : array_like
        F [N].
    distance : array_like
        From the point force, along the surface [m].
    modulus : float
        E* [Pa].
    """
    distance = np.asarray(distance, dtype=float)
    return np.asarray(np.asarray(force, dtype=float) / (np.pi * modulus * distance))


def _towards_zero(length: float, power: float) -> tuple[Array, Array]:
    """Return nodes t in (0, length) and weights (of dt) of panels that shrink towards t = 0, where t^power."""
    ends = length * PANEL_RATIO ** np.arange(PANEL_COUNT)
    node, weight = np.polynomial.legendre.leggauss(NODES_PER_PANEL)
    wide = 0.5 * ends[:-1] * (1.0 - PANEL_RATIO)
    t = (0.5 * ends[:-1] * (1.0 + PANEL_RATIO))[:, None] + wide[:, None] * node
    first, last = roots_jacobi(NODES_PER_PANEL, 0.0, power)
    inner = 0.5 * (1.0 + first)
    tiny = ends[-1] * inner
    nodes = np.concatenate([t.ravel(), tiny])
    return nodes, np.concatenate([(wide[:, None] * weight).ravel(), ends[-1] * last * (1.0 + first) ** -power / 2.0])


def _angle(s: Array, radius: float) -> Array:
    """Return eta with s = a cos(eta), accurate near the edge too."""
    return np.asarray(2.0 * np.arcsin(np.sqrt(np.clip((radius - s) / (2.0 * radius), 0.0, 1.0))))


def _panels(radius: float, r: float, breaks: Sequence[float], edge: float) -> tuple[Array, Array, Array]:
    """Return eta, weights (of d eta) and the distances s - r of the nodes of all panels."""
    home = 0.0 if r >= radius else float(_angle(np.array(r), radius)) if r > 1e-15 * radius else 0.5 * np.pi
    inner = [float(_angle(np.array(item), radius)) for item in breaks if 0.0 < item < radius]
    cuts = np.unique([0.0, home, *inner, 0.5 * np.pi])
    etas, weights, gaps = [], [], []
    for low, high in itertools.pairwise(cuts):
        half = 0.5 * (high - low)
        for cut, sign in ((low, 1.0), (high, -1.0)):
            t, weight = _towards_zero(half, 2.0 * edge + 1.0 if cut == 0.0 else 0.0)
            eta = cut + sign * t
            if r >= radius:
                gap = -(r - radius) - 2.0 * radius * np.sin(0.5 * eta) ** 2
            else:
                away = -sign * t if cut == home else home - eta
                gap = 2.0 * radius * np.sin(0.5 * (eta + home)) * np.sin(0.5 * away)
            etas.append(eta)
            weights.append(weight)
            gaps.append(gap)
    return np.concatenate(etas), np.concatenate(weights), np.concatenate(gaps)


def _density(pressure: Curve, eta: Array, radius: float, edge: float) -> Array:
    """Return p(s) s times ds/d(eta), following the power law of the edge where s cannot be distinguished from a."""
    s = radius * np.cos(np.maximum(eta, RIM_DISTANCE))
    # what eta is after s was rounded: the smooth factor of the pressure is evaluated exactly where it was computed
    exact = _angle(s, radius)
    smooth = np.asarray(pressure(s), dtype=float) * np.sin(exact) ** (-2.0 * edge)
    return np.asarray(smooth * np.sin(eta) ** (2.0 * edge + 1.0) * radius**2 * np.cos(eta))


def displacement(
    pressure: Curve,
    radius: float,
    r: ArrayLike,
    modulus: float,
    *,
    edge: float = -0.5,
    breaks: Sequence[float] = (),
) -> Array:
    """Return the surface displacement u(r) [m] of a pressure on a disc, by superposed point forces.

    Parameters
    ----------
    pressure : callable
        p(s) [Pa] for an array of s with 0 < s < a; zero beyond a.  It may be infinite (integrably) at the axis,
        at the edge and at `breaks`.
    radius : float
        Radius of the loaded disc a [m].
    r : array_like
        Distance from the axis [m], inside or outside.
    modulus : float
        E* [Pa].
    edge : float, optional
        Exponent [-] of the pressure at the edge, p ~ (a^2 - s^2)^edge, above -1.  The default -1/2 suits flat
        punches, and as the half-integers share one expansion in eta, also Hertz's +1/2 and a uniform pressure.
    breaks : sequence of float, optional
        Radii [m] inside the disc where the pressure is not smooth.

    Returns
    -------
    ndarray
        u [m], shape of `r`, accurate to about 1e-12 where `edge` is that of the pressure, to 1e-10 otherwise.

    Examples
    --------
    Hertz's pressure with E* = R = a = 1 moves the centre by d = a^2/R:

    >>> u = displacement(lambda s: 2.0 / np.pi * np.sqrt(1.0 - s**2), 1.0, [0.0, 0.5], 1.0)
    >>> print(u.round(10))
    [1.    0.875]
    """
    places = np.asarray(r, dtype=float)
    result = np.empty(places.size)
    for index, place in enumerate(places.ravel()):
        eta, weight, gap = _panels(radius, float(place), breaks, edge)
        total = 2.0 * place + gap  # r + s
        ring = ellipkm1(np.maximum((gap / total) ** 2, np.finfo(float).tiny)) / total
        result[index] = np.dot(weight, _density(pressure, eta, radius, edge) * ring)
    return np.asarray(4.0 / (np.pi * modulus) * result.reshape(places.shape))
