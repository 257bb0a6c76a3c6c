r"""The fields of a twisted contact: traction, displacement of the surface, and stresses below it.

Springs with the load :math:`q(x) = x\,h(x)` stand for the body of revolution

.. math:: \tau(r) = -\frac1{2\pi}\frac{\mathrm d}{\mathrm dr}\int_r^a\frac{q\,\mathrm dx}{\sqrt{x^2-r^2}}
          = \frac r{2\pi}\Big[\frac{h(a)}{\sqrt{a^2-r^2}} - \int_r^a\frac{h'(x)\,\mathrm dx}{\sqrt{x^2-r^2}}\Big],\qquad
          u_\theta(r) = \frac1{2\pi G\,r}\int_0^{\min(r,a)}\frac{x\,q\,\mathrm dx}{\sqrt{r^2-x^2}} ,

and below the surface, with :math:`\zeta=z+it` and :math:`\rho=\sqrt{r^2+\zeta^2}`,

.. math:: u_\theta = \frac1{2\pi G\,r}\int_0^a q\,\mathrm{Im}\frac\zeta\rho\,\mathrm dt ,\qquad
          \tau_{\theta z} = \frac r{2\pi}\int_0^a q\,\mathrm{Im}\frac1{\rho^3}\,\mathrm dt .

These are sums over rigidly twisted discs of all radii b (:math:`q=x` up to b), whose fields are closed forms.
Twist and normal load do not act on each other, whatever the bodies.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from winkler.media.medium import Displacement
from winkler.numerics.integrals.bisected_quadrature import refined
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, Curve
from winkler.values.errors import InvalidInput

SERIES_DISTANCE = 0.02
"""Nearer to the axis than this part of the distance from the disc's edge, series replace differences."""
TOLERANCE = 1e-11
"""Of the sum over discs."""
ROUNDING_RATIO = 1e-11
"""A slope that changes the load by no more than this part of it is rounding."""
SAMPLES = 33
RESOLVED = 100.0
"""Changes of the load that are so many times its rounding are known to a hundredth."""
HALVINGS, HALVED = 40, 0.05
"""Places towards the axis at which a slope is examined; by how much it may miss half of that at the last one."""


class Twisted(Displacement, Protocol):
    """The load h(x) = q(x)/x [Pa] of twisted springs as if it were a displacement; `value` is given for x > 0 only."""


class TwistBelow(NamedTuple):
    """Displacement [m] and shear stresses [Pa] in one body."""

    hoop_displacement: Array
    axial_twist_stress: Array
    radial_twist_stress: Array


def twist_traction(twisted: Twisted, r: Array) -> Array:
    """Return the traction tau_theta(r) [Pa] with which the twisting body drags the other one; zero outside.

    Parameters
    ----------
    twisted : Twisted
    r : ndarray
        Distance from the axis [m], not negative.
    """
    r = np.asarray(r, dtype=float)
    if twisted.radius == 0.0:
        return np.zeros(r.shape)
    place = np.where(r > 0.0, r, 1.0)
    traction = abel.pressure(clean_slope(twisted), twisted.kinks, twisted.edge, twisted.radius, place)
    return np.where(r > 0.0, 0.5 * r * traction, 0.0)


def clean_slope(twisted: Twisted, rounding: float = ROUNDING_RATIO) -> Curve:
    """Return h'(x) [Pa/m] without rounding where h is even: no rule of integration resolves that near the axis.

    What changes h by less than `rounding` of it is left out, or where h is smooth near the axis a line through it.
    """
    size = float(np.max(np.abs(twisted.value(np.linspace(0.0, twisted.radius, SAMPLES)[1:]))))
    near, rate = _towards_axis(twisted, RESOLVED * rounding * size)

    def slope(x: Array) -> Array:
        slopes = twisted.slope(x)
        kept = np.where(np.abs(slopes) * x <= rounding * size, 0.0, slopes)
        return np.asarray(np.where(x < near, rate * x, kept))

    return slope


def _towards_axis(twisted: Twisted, least: float) -> tuple[float, float]:
    """Return up to where h'(x) is proportional to x, but for changes of h that are less than some, and its rate.

    Both are zero where h is not seen to be smooth at the axis: where nothing is that much, or the slope does not halve
    with the distance.
    """
    x = min([twisted.radius, *(b for b, _ in twisted.kinks if b > 0.0)]) * 0.5 ** np.arange(1.0, HALVINGS)
    slopes = twisted.slope(x)
    seen = int(np.argmin(np.abs(slopes) * x > least))  # the first place where it is less, from outside
    if seen < 2 or not abs(2.0 * slopes[seen - 1] / slopes[seen - 2] - 1.0) < HALVED:
        return 0.0, 0.0
    return float(x[seen - 1]), float(slopes[seen - 1] / x[seen - 1])


def twist_displacement(twisted: Twisted, r: Array, modulus: float) -> Array:
    """Return the displacement u_theta(r) of the surface [m], inside and outside the contact.

    Parameters
    ----------
    twisted : Twisted
    r : ndarray
        Distance from the axis [m], not negative.
    modulus : float
        G of one body, or G_t of the pair for the sum over both [Pa].
    """
    r = np.asarray(r, dtype=float)
    if twisted.radius == 0.0:
        return np.zeros(r.shape)
    edges = [b for b, _ in twisted.kinks]
    place = np.where(r > 0.0, r, 1.0)
    moment = abel.surface(lambda x: x * x * twisted.value(x), edges, place, twisted.radius)
    return np.where(r > 0.0, moment / (4.0 * modulus * place), 0.0)


def twist_below(twisted: Twisted, r: Array, z: Array, modulus: float, stretch: float = 1.0) -> TwistBelow:
    """Return displacement and stresses inside a body.

    Parameters
    ----------
    twisted : Twisted
    r, z : ndarray
        Distance from the axis and depth below the surface [m], broadcast; r not negative, z positive.
    modulus, stretch : float
        As `winkler.media.layered.wave_constants.twist_constants` of the body.

    Returns
    -------
    TwistBelow
        u_theta, tau_theta-z (which is -tau where z = 0) and tau_r-theta.

    Raises
    ------
    InvalidInput
        If a place does not lie below the surface.
    """
    r, z = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
    if np.any(z <= 0.0) or np.any(r < 0.0):
        raise InvalidInput("twist_below: r must not be negative and z positive; use the surface's own fields there.")
    if twisted.radius == 0.0 or r.size == 0:
        return TwistBelow(*np.zeros((3, *r.shape)))
    flat_r, flat_z = r.ravel(), z.ravel() * stretch
    a = twisted.radius
    cuts = [0.0, *(b for b, _ in twisted.kinks if 0.0 < b < a), a]
    # In the variable v of t = low + width (v^2 (3 - 2 v)) roots at either end of a panel do no harm
    places = np.arange(len(cuts) + 0.0)
    low, width = np.array(cuts[:-1]), np.diff(cuts)
    parts = np.zeros((3, flat_r.size))
    for part in range(3):

        def integrand(v: Array, index: Array, part: int = part) -> Array:
            piece = np.minimum(v.astype(int), low.size - 1)
            s = v - piece
            t = low[piece] + width[piece] * s * s * (3.0 - 2.0 * s)
            inside = (t > low[piece]) & (t < low[piece] + width[piece])
            t = np.where(inside, t, low[piece] + 0.5 * width[piece])
            change = -twisted.slope(t) * width[piece] * 6.0 * s * (1.0 - s)
            return np.where(inside, change * _disc(flat_r[index], flat_z[index], t)[part], 0.0)

        total = refined(integrand, places[: len(cuts)], np.full(flat_r.size, TOLERANCE), "field of a twist")
        parts[part] = total + twisted.edge * _disc(flat_r, flat_z, np.full(flat_r.size, a))[part]
    displacement, axial, radial = parts.reshape(3, *r.shape)
    return TwistBelow(displacement / modulus, axial, radial * stretch)


def _disc(r: Array, z: Array, b: Array) -> tuple[Array, Array, Array]:
    """Return G u_theta, tau_theta-z and tau_r-theta of a disc of radius b with q = x."""
    zeta = z + 1j * b
    rho = np.sqrt(r * r + zeta * zeta)
    small = r < SERIES_DISTANCE * np.abs(zeta)
    safe = np.where(small, 1.0, r)
    with np.errstate(all="ignore"):
        traction = (-b * rho.real + 0.5 * (zeta * rho).imag + 0.5 * safe**2 * np.log(zeta + rho).imag) / safe
        axial = (rho.imag - b * (zeta / rho).real) / safe
        # r d/dr of u/r; the derivative of the bracket above is r arg(zeta + rho) - b r Re(1/rho)
        radial = np.log(zeta + rho).imag - b * (1.0 / rho).real - 2.0 * traction / safe
    series = _near(r, z, b) if small.any() else (traction, axial, radial)
    parts = [np.where(small, *each) / (2.0 * np.pi) for each in zip(series, (traction, axial, radial), strict=True)]
    return parts[0], parts[1], parts[2]


def _near(r: Array, z: Array, b: Array) -> tuple[Array, Array, Array]:
    """Return the same, without the factor, near the axis: in powers of r / |zeta|."""
    zeta = z + 1j * b

    def power(n: int) -> Array:
        """Return the imaginary part of the integral of t zeta^-n dt from 0 to b; at its start zeta = z is real."""
        first = np.log(zeta) if n == 2 else zeta ** (2 - n) / (2 - n)
        return np.asarray((z * zeta ** (1 - n) / (1 - n) - first).imag)

    # zeta/rho = sum of c_k (r/zeta)^(2k), rho^-3 = sum of d_k r^(2k) zeta^(-2k-3)
    traction, axial, radial = np.zeros((3, *np.shape(r)))
    c, d = 1.0, 1.0
    for k in range(9):
        if k > 0:
            traction += c * r ** (2 * k - 1) * power(2 * k)
            radial += (2 * k - 2) * c * r ** (2 * k - 2) * power(2 * k)
        axial += d * r ** (2 * k + 1) * power(2 * k + 3)
        c *= -(0.5 + k) / (k + 1.0)
        d *= -(1.5 + k) / (k + 1.0)
    return traction, axial, radial
