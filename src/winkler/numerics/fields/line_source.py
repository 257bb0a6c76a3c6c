r"""The temperature of a surface under a round source of heat: at rest, moving, or just switched on.

A source is described by its line load q(x), the projection of its flux along any line in the surface (T5).  What the
body does to the flux of a plane wave, it does to every line load; the temperature is the mean over all directions (T3):

==================  ============================================================================================
at rest             q itself
moving at V         q_b of `numerics.moving_source`, b = V cos(theta) / kappa
on for the time t   :math:`q_t(s) = q(s) - \int q(x)\,\frac{2}{\pi^{3/2}}\frac{D(|s-x|/2\ell)}{|s-x|}\,dx`, Dawson's D,
                    :math:`\ell=\sqrt{\kappa t}`: the multiplier is :math:`\mathrm{erf}(k\ell)`
==================  ============================================================================================

The mean temperature of a disc under a round source of heat that moves, as one integral without cancellation.

The chord :math:`c(s)=\sqrt{1-s^2}` of the disc weighs the line load :math:`q_b` of each direction.  The factor of a
direction is the derivative of :math:`E(z)=e^{-z}I_0(z)`; integrated by parts, and over the directions first,

.. math:: \bar T = \frac2{\pi^2\lambda}\int_0^2 S(u)\,K\bigl(\tfrac{wu}2\bigr)\,\mathrm du , \qquad
          S(u) = -\frac{\mathrm d}{\mathrm du}\int_{-1}^{1-u}q(t)\,c(t+u)\,\mathrm dt , \qquad
          K(z) = \int_0^{\pi/2}E(z\cos\theta)\,\mathrm d\theta .

S is of the source alone, K of the motion alone, :math:`w = aV/\kappa`; K decays as :math:`z^{-1/2}`, and nothing is
subtracted however fast the body moves.  Lengths are counted in contact radii.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.fields.moving_source import spread_loads, surface_points
from winkler.numerics.fields.source_tables import cosine_rule, lag_table, powers, spread_table
from winkler.numerics.fields.warmest_place import LEAST_TEMPERATURE_GAIN, PeakTemperature, turned, warmest_place
from winkler.numerics.integrals.quadrature import gauss_legendre, growing, tanh_sinh
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.panels.cosine_pieces import cosine_places, place_on
from winkler.numerics.types import Array, Curve
from winkler.values.value import value

TOLERANCE = 1e-11
"""Of the line load, relative to its greatest value."""
TIME_NODES = 20
ROUGH_TOLERANCE = 1e-6
"""Of the greatest line load, to which circles are compared before the warmest are computed in full."""
CIRCLE_SAMPLES = 65
SEARCH_CIRCLES = 33
"""Circles on which the greatest temperature is sought where the flux does not fall from the axis on."""
FAST_PECLET = 1e6
"""V a / kappa at which the limit of fast sliding is taken: it is met to about 1e-6."""


@value
class LineSource:
    """A round source of heat, as its line load.

    Parameters
    ----------
    radius : float
        a [m].
    scale : float
        Greatest line load [W/m].
    joints : ndarray
        Where the line load is not smooth, from 0 to 1 [a].
    curve : Panels
        q over `scale`, as a function of j + u, where x lies on the j-th piece at the part (1 - cos(pi u))/2.
    sharp : bool
        Whether the flux grows without bound towards the edge.
    """

    radius: float
    scale: float
    joints: Array
    curve: Panels
    sharp: bool = False

    def load(self, x: Array) -> Array:
        """q(x) [W/m], zero outside."""
        part = np.abs(np.asarray(x, dtype=float)) / self.radius
        return np.where(part <= 1.0, self.scale * self.curve(cosine_places(part, self.joints)), 0.0)

    @functools.cached_property
    def table(self) -> tuple[Array, Array, Array]:
        """The line load as the kernels take it: joints, edges and powers of the panels."""
        return self.joints, self.curve.edges, powers(self.curve.coefficients)

    @property
    def heat(self) -> float:
        """The heat per time [W], the integral of the line load."""
        node, weight = cosine_rule(64)
        low, width = self.joints[:-1, None], np.diff(self.joints)[:, None]
        return 2.0 * float(np.sum(self.load(self.radius * (low + width * node)) * width * weight)) * self.radius

    @property
    def fading(self) -> bool:
        """Whether the flux is known to fall from the axis on.

        With w = -q'/x the flux is the integral of w over the half chord beyond r: it falls if w does, or grows by less
        than w(a) (r/a)^2.  That follows from q as a function of x^2.  The warmest place is then on the centre line,
        since what the kernel is folded with falls to both sides of it.
        """
        load = self.load(self.radius * np.sqrt(np.linspace(0.0, 1.0, CIRCLE_SAMPLES))) / self.scale
        last = (load[-2] - load[-1]) * (CIRCLE_SAMPLES - 1)
        bend = np.max(-np.diff(load, 2)) * (CIRCLE_SAMPLES - 1) ** 2
        return bool(load[-1] <= LEAST_TEMPERATURE_GAIN and 2.0 * bend <= last)

    @property
    def ball(self) -> LineSource:
        """The round source whose line load, stretched, is that of every direction: itself."""
        return self

    def half_length(self, angle: float) -> float:
        """Return how far the source reaches at an angle [rad] from its middle [m]."""
        return self.radius

    def narrow_directions(self, angle: float) -> list[float]:
        """Return directions near which line loads change fast, from that of the motion on, up to a quarter turn."""
        return []

    def half_width(self, angle: Array) -> Array:
        """Return half the width [m] of the line loads in directions [rad]."""
        return np.full(angle.shape, self.radius)

    def surface(self, wave: float, x: Array, y: Array, angle: float = 0.0) -> Array:
        """Return lambda T [W/m] on a body that moves past the source.

        Parameters
        ----------
        wave : float
            V / kappa [1/m]; negative if it moves backwards.
        x, y : ndarray
            Places [m], of one shape; the source is centred at 0.
        angle : float
            Of the motion to x [rad].
        """
        forth, (along, beside) = math.copysign(1.0, wave), turned(x, y, -angle)
        flat, across = (np.ascontiguousarray(np.ravel(place) / self.radius) for place in (forth * along, beside))
        result = np.empty(flat.size)
        surface_points(flat, across, abs(wave) * self.radius, (*self.table, *lag_table(), *cosine_rule()), result)
        return np.asarray(self.scale * result.reshape(np.shape(x)))

    def mean(self, wave: float, angle: float = 0.0) -> float:
        """Return the mean of lambda T over the disc [W/m], on a body that moves at whatever angle."""
        return disc_mean(abs(wave) * self.radius, self.joints, lambda part: self.load(self.radius * part))

    def peak(self, wave: float, angle: float = 0.0) -> PeakTemperature:
        """Return the greatest lambda T on a body that moves, and its place; parameters as of `surface`."""
        if wave == 0.0 and self.fading:
            return PeakTemperature(0.5 * float(self.load(np.zeros(1))[0]), 0.0, 0.0)
        along = functools.partial(self.surface, wave)
        return warmest_place(along, self.radius, self.fading, rests=wave == 0.0).turned(angle)

    def fast(self, angle: float = 0.0) -> float:
        """Return what the greatest lambda T times the root of V / kappa tends to in fast motion [W m^-3/2].

        Heat then only flows into the body: behind every point of the rim the temperature grows as over a plane under
        the flux that has passed, and the greatest on the centre line counts.  Infinite behind a sharp edge, where the
        flux, like an inverse square root, meets that of the lag.
        """
        if self.sharp:
            return math.inf
        return self.peak(FAST_PECLET / self.radius).height * math.sqrt(FAST_PECLET / self.radius)

    def risen(self, length: float, x: Array, y: Array | float = 0.0) -> Array:
        """Return lambda T [W/m] on a body at rest whose source has been on for a time.

        Parameters
        ----------
        length : float
            sqrt(kappa t) [m], positive.
        x, y : ndarray
            Places [m].
        """
        return self._around(np.hypot(x, y), lambda places: self.spread(length / self.radius, places))

    def risen_peak(self, length: float) -> float:
        """Return the greatest lambda T [W/m] within the contact, of `risen`.

        It is on the axis if the flux falls from there, else on the warmest of many circles.
        """
        if self.fading:
            return float(self.risen(length, np.zeros(1))[0])
        return self.warmest(length, self.radius * np.sin(np.linspace(0.0, 0.5 * np.pi, SEARCH_CIRCLES)))

    def warmest(self, length: float, r: Array) -> float:
        """Return the greatest lambda T [W/m] on circles r [m] within the contact; `length` as in `risen`.

        A table of q_t of a few digits shows which circles come near to it; only those are computed in full.
        """

        def spread(place: Array) -> Array:
            places = place_on(place, self.joints)
            return self.spread(length / self.radius, np.ravel(places)).reshape(places.shape) / self.scale

        table = fit_panels(spread, np.arange(self.joints.size, dtype=float), ROUGH_TOLERANCE)
        heights = self._around(r, lambda places: self.scale * table(cosine_places(places, self.joints)))
        close = heights >= np.max(heights) - 10.0 * ROUGH_TOLERANCE * self.scale
        return float(np.max(self.risen(length, np.ravel(r)[close])))

    def _around(self, r: Array, spread: Curve) -> Array:
        """Return the mean of q_t, given by `spread` at places in contact radii, over the circles r [m]."""
        r = np.asarray(r, dtype=float)
        part = np.ravel(r)[:, None] / self.radius
        node, weight = cosine_rule(TIME_NODES)
        ends = np.concatenate([self.joints[1:], [0.0]])  # the last is put at r itself
        with np.errstate(divide="ignore", invalid="ignore"):
            cuts = np.where(part > ends, np.arcsin(np.minimum(ends / np.maximum(part, ends), 1.0)), 0.5 * np.pi)
        cuts[:, -1] = 0.5 * np.pi
        cuts = np.concatenate([np.zeros(part.shape), cuts], axis=1)
        width = np.diff(cuts)[..., None]
        places = part[..., None] * np.sin(cuts[:, :-1, None] + width * node)
        # the axis is one place, and circles miss the pieces inside of them: every place once
        distinct, back = np.unique(np.where(width > 0.0, places, part[..., None]), return_inverse=True)
        loads = np.asarray(spread(distinct))[back].reshape(places.shape)
        return np.asarray(np.sum(loads * width * weight, axis=(1, 2)).reshape(r.shape) / np.pi)

    def risen_mean(self, length: float) -> float:
        """Return the mean of lambda T over the disc [W/m], at rest, on for the time t; `length` is sqrt(kappa t)."""
        node, weight = cosine_rule(TIME_NODES)
        low, width = self.joints[:-1, None], np.diff(self.joints)[:, None]
        places, shares = (low + width * node).ravel(), (width * weight).ravel()
        loads = self.spread(length / self.radius, places)
        return 2.0 * float(np.sum(np.sqrt(1.0 - places**2) * loads * shares)) / math.pi

    def spread(self, length: Array | float, s: Array) -> Array:
        """Return q_t [W/m] at places s >= 0, (n,), both in contact radii."""
        result = np.empty(s.size)
        lengths = np.ascontiguousarray(np.broadcast_to(length, s.shape), dtype=float)
        spread_loads(s, lengths, (*self.table, *spread_table(), *cosine_rule(TIME_NODES)), result)
        return self.scale * result


OUTER_NODES = 41
INNER_NODES = 49
"""Of the double-exponential rules over u and over t: 1e-10 of the mean together."""
TURN_NODES = 48
ASYMPTOTIC_LIMIT = 40.0
"""Beyond it K is its asymptotic series."""
ASYMPTOTIC_TERMS = 20
LENGTH_RATIO = 8.0
"""Ratio of the lengths of consecutive pieces that leave the length of diffusion."""
LEAST_SQUARE = 1e-300


def disc_mean(wave: float, joints: Array, load: Curve) -> float:
    """Return the mean of lambda T over the disc.

    Parameters
    ----------
    wave : float
        a V / kappa, not negative.
    joints : ndarray
        Where the line load is not smooth, from 0 to 1.
    load : Curve
        The line load q [any], at places from -1 to 1.
    """
    lengths = growing(1.0 / max(wave, 1.0), 2.0, LENGTH_RATIO)
    cuts = np.array(sorted({0.0, 2.0, *(1.0 - joints[:-1]), *(1.0 + joints[:-1]), *lengths}))
    node, far, weight = tanh_sinh(OUTER_NODES)
    width = np.diff(cuts)[:, None]
    u, left = (cuts[:-1, None] + width * node).ravel(), (2.0 - cuts[1:, None] + width * far).ravel()
    parts = _slopes(u, left, joints, load) * _turned(0.5 * wave * u) * (width * weight).ravel()
    return 2.0 / math.pi**2 * float(np.sum(parts))


def _slopes(u: Array, left: Array, joints: Array, load: Curve) -> Array:
    """Return S at u (n,), `left` short of 2, which is counted for itself as the last piece shrinks to nothing there."""
    (t, ahead, share), lag = before_chords_end(u, joints, INNER_NODES, left), u[:, None, None]
    slope = (t + lag) / np.sqrt(np.maximum(ahead * (1.0 + t + lag), LEAST_SQUARE))
    return np.asarray(np.sum(load(t.ravel()).reshape(t.shape) * slope * share, axis=(1, 2)))


def before_chords_end(
    u: Array, joints: Array, count: int, left: Array | float = math.inf
) -> tuple[Array, Array, Array]:
    """Return places t from -1 to 1 - u ``(n, pieces, count)``, how far the chord goes on behind them, and weights.

    Pieces end at the joints of a line load on both sides; the first one is no longer than what is `left`.
    """
    ends = np.array(sorted({-1.0, 1.0, *joints[:-1], *(-joints[:-1])}))
    cuts = np.minimum(ends, 1.0 - u[:, None])
    cuts[:, -1] = 1.0 - u
    node, far, weight = tanh_sinh(count)
    width = np.diff(cuts)[..., None]
    width[:, 0, 0] = np.minimum(width[:, 0, 0], left)
    ahead = (1.0 - u[:, None, None] - cuts[:, 1:, None]) + width * far
    return cuts[:, :-1, None] + width * node, ahead, width * weight


def _turned(z: Array) -> Array:
    """Return K(z)."""
    from scipy.special import i0e

    node, weight = gauss_legendre(TURN_NODES)
    near = i0e(np.minimum(z, ASYMPTOTIC_LIMIT)[:, None] * np.cos(0.5 * np.pi * node)) @ (0.5 * np.pi * weight)
    large = np.maximum(z, ASYMPTOTIC_LIMIT)
    return np.where(
        z < ASYMPTOTIC_LIMIT, near, np.polynomial.polynomial.polyval(1.0 / large, _series()) / np.sqrt(large)
    )


@functools.lru_cache(maxsize=1)
def _series() -> Array:
    """Return the coefficients of z^(1/2) K(z) in powers of 1/z, the residues of its Mellin transform."""
    from scipy.special import gammaln, rgamma

    k = np.arange(ASYMPTOTIC_TERMS)
    size = np.exp(gammaln(k + 0.5) - gammaln(k + 1.0)) * rgamma(0.75 - 0.5 * k) ** 2
    return np.asarray(0.5 * math.sqrt(math.pi) * (-1.0) ** k * size)
