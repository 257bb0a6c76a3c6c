r"""The temperature of a surface under a band of heat that is endless along y and moves along x.

In a body that moves at V past a steady flux q(s) per area,

.. math:: \lambda T(x) = \frac1\pi\int_{-a}^a q(s)\,\mathrm e^{z} K_0(|z|)\,\mathrm ds , \qquad
          z = \frac{V}{2\kappa}(x-s) ,

with Bessel's function K0 (Jaeger): a wake behind the band, and almost nothing ahead of it.  At rest there is no steady
temperature; in the limit of high speed heat flows into the depth alone,

.. math:: \lambda T(x) = \sqrt{\frac{\kappa}{\pi V}}\int_{-a}^x\frac{q(s)}{\sqrt{x-s}}\,\mathrm ds .

With :math:`s = a\sin\varphi` the flux of a contact is smooth at its edges.  The integral is cut at the place itself,
where the kernel has its logarithm, at distances from it that grow by a factor from the length of diffusion on, and at
the kinks of the flux; the double-exponential rule takes each piece.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.numerics.integrals.quadrature import growing, tanh_sinh
from winkler.numerics.types import Array, Curve
from winkler.values.value import value

FAST = math.inf
"""The wave number of the limit of high speed, in which lambda T is counted times the root of V / kappa."""
NODES = 81
LENGTH_RATIO = 4.0
"""Ratio of the lengths of consecutive pieces beside a place."""
KINK_CLEARANCE = 1e-13
"""Angle from a kink within which the flux, infinite there, is taken at this distance."""
FIRST_PLACES = 25
REFINEMENTS = 5
BETWEEN = 9
"""Places across the two intervals beside the warmest one, in each refinement."""
SMALL = 0.1
"""Argument up to which the integral of the kernel is summed, and not taken from its closed form."""
EPSILON = 1e-300


@value
class BandPeak:
    """The greatest temperature under a band of heat, and its place.

    Parameters
    ----------
    height : float
        Conductivity times temperature [W/m].
    x : float
        Coordinates [m].
    """

    height: float
    x: float


@value
class BandSource:
    """A flux of heat on a strip, 1 W per length in all.

    Parameters
    ----------
    half_width : float
        a [m].
    joints : tuple of float
        Angles from 0 to below pi/2 at which the flux is not smooth.
    flux : Curve
        The flux times a cos(angle) [W/m], at angles of which the sine is x/a; the same on both sides.
    sharp : bool
        Whether the flux grows without bound towards a rim.
    """

    half_width: float
    joints: tuple[float, ...]
    flux: Curve
    sharp: bool = False

    def surface(self, wave: float, x: Array) -> Array:
        """Return lambda T [W/m] on the surface.

        Parameters
        ----------
        wave : float
            V / kappa [1/m], not zero; negative if the body moves against x; `FAST` for the limit, where the result is
            counted times the root of wave [W/m^(3/2)].
        x : ndarray
            Places [m].
        """
        forth = math.copysign(1.0, wave)
        places = forth * np.ravel(np.asarray(x, dtype=float))
        found = np.array([self._at(abs(wave), float(place)) for place in places])
        return found.reshape(np.shape(x))

    def peak(self, wave: float) -> BandPeak:
        """Return the greatest lambda T, and its place; `wave` as of `surface`."""
        forth = math.copysign(1.0, wave)
        best = warmest_of_band(lambda x: self.surface(abs(wave), x), self.half_width)
        return BandPeak(best.height, forth * best.x)

    def fast(self) -> float:
        """Return what the greatest lambda T times the root of V / kappa tends to in fast motion [W/m^(3/2)].

        Infinite at a rim.
        """
        return math.inf if self.sharp else self.peak(FAST).height

    def mean(self, wave: float) -> float:
        """Return the mean of lambda T over the strip [W/m]; `wave` as of `surface`, but finite."""
        a, wave = self.half_width, abs(wave)
        layers = growing(2.0 / wave, 2.0 * a, LENGTH_RATIO)
        angle, share, _ = self.pieces(0.0, math.nan, [_angle(1.0 - layer / a) for layer in layers])
        ahead, behind = 1.0 - np.sin(angle), 1.0 + np.sin(angle)
        ahead = np.where(np.sin(angle) > 0.5, 2.0 * np.sin(0.25 * math.pi - 0.5 * angle) ** 2, ahead)
        half = 0.5 * wave * a
        whole = (
            _downstream(half * ahead) + _upstream(half * behind) + _downstream(half * behind) + _upstream(half * ahead)
        )  # places s and -s together
        return float(np.sum(self.flux_at(angle) * whole * share)) / (math.pi * wave * a)

    def _at(self, wave: float, x: float) -> float:
        from scipy.special import k0e

        a = self.half_width
        inside = abs(x) <= a
        at = math.asin(x / a) if inside else math.nan
        lengths = [] if wave == FAST else growing(2.0 / wave, 2.0 * a, LENGTH_RATIO)
        if not inside:
            lengths += growing(abs(x) - a, 2.0 * a, LENGTH_RATIO)
        marks = [_angle((x + sign * length) / a) for length in lengths for sign in (1.0, -1.0)]
        angle, share, off = self.pieces(-0.5 * math.pi, at, marks)
        behind = -2.0 * a * np.cos(at + 0.5 * off) * np.sin(0.5 * off) if inside else x - a * np.sin(angle)
        distance = np.maximum(np.abs(behind), EPSILON)
        if wave == FAST:
            kernel = np.where(behind > 0.0, np.sqrt(math.pi / distance), 0.0)
        else:
            kernel = k0e(0.5 * wave * distance)
            ahead = behind < 0.0
            kernel[ahead] *= np.exp(-wave * distance[ahead])
        return float(np.sum(self.flux_at(np.abs(angle)) * kernel * share)) / math.pi

    def pieces(self, low: float, at: float, marks: list[float]) -> tuple[Array, Array, Array]:
        """Return angles from `low` to pi/2, their weights, and how far they lie beyond the angle `at` (nan if none).

        Pieces end at the marks, and at the joints of the flux on both sides.
        """
        high, joints = 0.5 * math.pi, [sign * joint for joint in self.joints for sign in (1.0, -1.0)]
        known = [] if math.isnan(at) else [at]
        cuts = np.array(sorted({low, high, *known, *(mark for mark in (*marks, *joints) if low < mark < high)}))
        node, far, weight = tanh_sinh(NODES)
        start, end = cuts[:-1, None], cuts[1:, None]
        width = end - start
        angle = np.where(node < 0.5, start + width * node, end - width * far)
        off = np.where(node < 0.5, (start - at) + width * node, (end - at) - width * far)
        return angle.ravel(), (width * weight).ravel(), off.ravel()

    def flux_at(self, angle: Array) -> Array:
        """Return the flux at angles on either side of the middle."""
        for joint in self.joints:
            near = np.abs(angle - joint) < KINK_CLEARANCE
            angle = np.where(near, joint + np.where(angle >= joint, 1.0, -1.0) * KINK_CLEARANCE, angle)
        return np.asarray(self.flux(np.abs(angle)))


def warmest_of_band(surface: Curve, half_width: float) -> BandPeak:
    """Return where a surface that moves along +x past a band is warmest within the strip, and how warm.

    Parameters
    ----------
    surface : Curve
        Temperature at places x [m].
    half_width : float
        a [m].
    """
    angles = np.linspace(-0.5 * math.pi, 0.5 * math.pi, FIRST_PLACES)
    heights = surface(half_width * np.sin(angles))
    for _ in range(REFINEMENTS):
        best = int(np.argmax(heights))
        low, high = angles[max(best - 1, 0)], angles[min(best + 1, angles.size - 1)]
        angles = np.linspace(low, high, BETWEEN)
        heights = surface(half_width * np.sin(angles))
    best = min(max(int(np.argmax(heights)), 1), BETWEEN - 2)
    left, middle, right = heights[best - 1 : best + 2]
    bend = left - 2.0 * middle + right
    offset = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    if abs(offset) > 1.0:
        best = int(np.argmax(heights))
        return BandPeak(float(heights[best]), half_width * math.sin(angles[best]))
    angle = angles[best] + offset * (angles[1] - angles[0])
    return BandPeak(float(middle - 0.25 * (left - right) * offset), half_width * math.sin(angle))


def _angle(part: float) -> float:
    return math.asin(min(max(part, -1.0), 1.0))


def _downstream(z: Array) -> Array:
    """Return the integral of exp(t) K0(t) from 0 to z."""
    from scipy.special import k0e, k1e

    big = np.maximum(z, SMALL)
    return np.where(z < SMALL, _summed(z, lambda t: k0e(t)), big * (k0e(big) + k1e(big)) - 1.0)


def _upstream(z: Array) -> Array:
    """Return the integral of exp(-t) K0(t) from 0 to z."""
    from scipy.special import k0e, k1e

    big = np.maximum(z, SMALL)
    closed = 1.0 - big * np.exp(-2.0 * big) * (k1e(big) - k0e(big))
    return np.where(z < SMALL, _summed(z, lambda t: k0e(t) * np.exp(-2.0 * t)), closed)


def _summed(z: Array, kernel: Callable[[Array], Array]) -> Array:
    node, _, weight = tanh_sinh(NODES)
    z = np.minimum(z, SMALL)
    return np.asarray(z * (kernel(np.maximum(z[:, None] * node, EPSILON)) @ weight))
