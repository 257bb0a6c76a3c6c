r"""Modes of the pressure on a strip from -a to a, their cosine transforms and what a half-plane does under them.

.. math:: p_n(x) = \frac{T_{2n}(x/a)}{\pi\sqrt{a^2-x^2}} , \qquad
          \int_{-a}^a p_n\cos kx\,\mathrm dx = (-1)^n J_{2n}(ka) .

Under it a half-plane (of the modulus E*) sinks inside by :math:`\frac2{\pi E^*}\frac{T_{2n}}{2n}`, beside the strip by
the same with :math:`\rho^{-2n}`, :math:`\rho = x/a + \sqrt{x^2/a^2-1}`, in the place of :math:`T_{2n}`; under the
first, a flat punch, by :math:`-\frac2{\pi E^*}\ln\rho`, counted from the punch.  The potential of
`winkler.numerics.fields.half_plane` is :math:`F = \rho^{-2n}/(\pi\sqrt{\zeta^2-a^2})` with the complex place
:math:`\zeta`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.types import Array, ComplexArray

LEAST_UPWARD = 2
NOTHING = 1e-17
MARGIN = 24
"""Angles beyond those that tell all orders apart."""
ENTRIES_PER_CHUNK = 1_000_000


def signs(count: int) -> Array:
    """Return (-1)^n, n = 0 ... count - 1."""
    return np.where(np.arange(count) % 2 == 0, 1.0, -1.0)


def bessel_rows(argument: Array, count: int) -> Array:
    r"""Return J_0, J_2, ... of `count` even orders ``(count, ...)``, to about 1e-15.

    By upward recurrence where the argument is larger than the highest order, elsewhere by the midpoint rule for
    :math:`J_{2n}(x) = \frac2\pi\int_0^{\pi/2}\cos(x\sin\theta)\cos 2n\theta\,\mathrm d\theta`, which errs by the first
    orders that it cannot tell apart.
    """
    flat = argument.ravel()
    rows = np.empty((count, flat.size))
    small = flat < max(2 * count - 2, LEAST_UPWARD)
    rows[:, small] = _by_angles(flat[small], count)
    rows[:, ~small] = _upward(flat[~small], count)
    return rows.reshape(count, *argument.shape)


def _upward(argument: Array, count: int) -> Array:
    from scipy.special import j0, j1

    rows = np.empty((count, argument.size))
    before, now = j0(argument), j1(argument)
    rows[0] = before
    twice = 2.0 / argument
    for order in range(1, 2 * count - 2):
        before, now = now, order * twice * now - before
        if order % 2 == 1:
            rows[(order + 1) // 2] = now
    return rows


def _by_angles(argument: Array, count: int) -> Array:
    from scipy.special import gammaln

    highest = max(2 * count, LEAST_UPWARD)
    points = (2 * highest + MARGIN) // 4 + math.ceil(2.0 * highest ** (1.0 / 3.0))
    angle = 0.5 * math.pi * (np.arange(points) + 0.5) / points
    orders = np.cos(2.0 * np.outer(np.arange(count), angle)) / points
    rows = np.empty((count, argument.size))
    for part in chunks(argument.size, points, ENTRIES_PER_CHUNK):
        rows[:, part] = orders @ np.cos(np.outer(np.sin(angle), argument[part]))
    twice = 2.0 * np.arange(1, count)
    least = 2.0 * np.exp((math.log(NOTHING) + gammaln(twice + 1.0)) / twice)  # (x/2)^m / m! is nothing below
    rows[1:][argument < least[:, None]] = 0.0
    return rows


def far_sides(argument: Array, order: Array) -> Array:
    r"""Return the sides of Bessel functions far out, by Debye's first terms.

    :math:`J_\nu(t) \approx \sqrt2\,(c\cos\tau - s\sin\tau)` with :math:`\tau = t - \nu\pi/2 - \pi/4`, so that
    the product of two whose orders differ by an even number has the average :math:`\pm(cc' + ss')` over the phase.

    Parameters
    ----------
    argument : ndarray, (k,)
        t [-], above the orders.
    order : ndarray, (n,)
        nu [-].

    Returns
    -------
    ndarray, (2, n, k)
        c and s [-].
    """
    ratio = order[:, None] / argument
    root = np.sqrt((1.0 - ratio) * (1.0 + ratio))
    # sqrt(t^2 - nu^2) - nu arccos(nu / t) - t + nu pi / 2
    lag = order[:, None] * np.arcsin(ratio) - argument * ratio**2 / (1.0 + root)
    return np.asarray(np.stack([np.cos(lag), np.sin(lag)]) / np.sqrt(math.pi * argument * root))


def pressure_of_modes(loads: Array, half_width: float, x: Array, edge: float) -> Array:
    """Return the pressure over E* [-] of modes that bear `loads` over E* [m] and together `edge`, zero outside."""
    away = np.abs(x)
    inside = away < half_width
    angle = _angle(away, half_width)
    # T_2n - 1 = -2 sin^2: nothing cancels at an edge that closes
    order = np.arange(loads.size).reshape(-1, *([1] * angle.ndim))
    smooth = np.tensordot(loads, np.sin(order * angle) ** 2, axes=1)
    found = (edge - 2.0 * smooth) / np.where(inside, np.sin(angle), 1.0)
    closed = np.where((away == half_width) & (edge != 0.0), np.copysign(np.inf, edge), 0.0)
    return np.asarray(np.where(inside, found / (np.pi * half_width), closed))


def along_surface(loads: Array, half_width: float, x: Array, edge: float) -> Array:
    """Return the real part of F over E* [-] on the surface, at x >= 0, of modes as of `pressure_of_modes`."""
    inside = x < half_width
    angle = _angle(x, half_width)
    order = np.arange(loads.size).reshape(-1, *([1] * angle.ndim))
    sine = np.where(inside & (angle > 0.0), np.sin(angle), 1.0)
    within = -np.tensordot(loads, np.sin(2.0 * order * angle), axes=1) / sine
    ratio = np.maximum(x / half_width, 1.0)
    root = np.sqrt((ratio - 1.0) * (ratio + 1.0))
    logarithm = np.log1p((ratio - 1.0) + root)
    smooth = np.tensordot(loads, np.expm1(-2.0 * order * logarithm), axes=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        beside = (smooth + edge) / root
    at_edge = -2.0 * float(loads @ np.arange(loads.size)) if edge == 0.0 else np.copysign(np.inf, edge)
    found = np.where(inside, within, np.where(root == 0.0, at_edge, beside))
    return np.asarray(found / (np.pi * half_width))


def _angle(away: Array, half_width: float) -> Array:
    """Return the angle with the cosine x/a, a right one in the middle; of one place at the edge outside."""
    beside = np.where(away < half_width, half_width - away, half_width)
    return 2.0 * np.arcsin(np.sqrt(0.5 * beside / half_width))


def lowered(loads: Array, half_width: float, x: Array) -> Array:
    """Return how much less a half-plane sinks at x >= a than at the edge [m], under modes of `loads` over E* [m]."""
    ratio = x / half_width
    root = np.sqrt((ratio - 1.0) * (ratio + 1.0))
    logarithm = np.log1p((ratio - 1.0) + root)
    order = np.arange(1, loads.size).reshape(-1, *([1] * logarithm.ndim))
    parts = -np.expm1(-2.0 * order * logarithm) / (2.0 * order)
    return np.asarray(2.0 / np.pi * (loads[0] * logarithm + np.tensordot(loads[1:], parts, axes=1)))


def potential_of_modes(loads: Array, half_width: float, zeta: ComplexArray) -> tuple[ComplexArray, ComplexArray]:
    """Return F [-] and its derivative [1/m] at places below the surface, of modes that bear `loads` over E* [m]."""
    root = np.sqrt(zeta - half_width) * np.sqrt(zeta + half_width)
    shrunk = (half_width / (zeta + root)) ** 2
    whole, grown = np.zeros_like(zeta), np.zeros_like(zeta)
    for load in loads[::-1]:  # Horner, with the derivative by the power beside it
        grown = grown * shrunk + whole
        whole = whole * shrunk + load
    # d shrunk / d zeta = -2 shrunk / root
    slope = -2.0 * shrunk * grown / root**2 - zeta * whole / root**3
    return whole / (np.pi * root), slope / np.pi
