r"""Abel-type transforms between a body of revolution and its line of springs.

======  ================================================================  =======================
name    formula                                                           function
======  ================================================================  =======================
T1      :math:`g(x) = x\int_0^x f'(r)\,(x^2-r^2)^{-1/2}\,dr`              `gap`
T1'     its derivative, with the kinks' inverse square roots              `gap_slope`
T7      :math:`\int_0^x g = \int_0^x f\,r\,(x^2-r^2)^{-1/2}\,dr`          `gap_integral`
T2, T3  :math:`\frac2\pi\int_0^r u(x)\,(r^2-x^2)^{-1/2}\,dx`              `surface`
T4      :math:`-\frac1\pi\int_r^a u'(x)\,(x^2-r^2)^{-1/2}\,dx` + edge     `pressure`
T5      :math:`2\int_x^a r\,p(r)\,(r^2-x^2)^{-1/2}\,dr`                   `line_load`
======  ================================================================  =======================

Each integral is split at the points where the integrand is not smooth and mapped so that what is left is
analytic: :math:`r = x\sin\theta` removes the kernel's singularity, :math:`y=\sqrt{x^2-b^2}` the square root that
a kink at b leaves in g.  Gauss-Legendre rules then converge geometrically; they are doubled until the result
settles (`numerics.settling`): analytic pieces are good to about 1e-13, and nothing worse than 1e-9 is handed out.
At a small distance e above a kink b the rounding of x alone costs b/e units in the last place of what the kink adds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.transforms.abel_intervals import Kinks, clear_of_underflow, noise, pieces, root_difference
from winkler.numerics.transforms.spring_loads import line_load, pressure
from winkler.numerics.types import Array, Curve

__all__ = ["gap", "gap_integral", "gap_slope", "integral", "line_load", "pressure", "root_difference", "surface"]


def _angular(function: Curve, edges: Sequence[float], x: Array, what: str, against: Array | float = 0.0) -> Array:
    """Integrate function(r) / sqrt(x^2 - r^2) over r from 0 to x, for every x > 0."""
    total, least = np.zeros_like(x), np.broadcast_to(against, x.shape)
    for low, high in pieces(edges, float(np.max(x, initial=0.0))):
        (active,) = np.nonzero(x > low)
        total[active] += _angular_piece(function, low, high, x[active], what, least[active])
    return total


def _angle_to(high: float, x: Array) -> Array:
    """Return arcsin(high / x), a right angle where high is not reached."""
    if high == math.inf:
        return np.full(x.shape, 0.5 * np.pi)
    return np.where(x <= high, 0.5 * np.pi, np.arctan2(high, root_difference(x, high)))


def _angular_piece(function: Curve, low: float, high: float, x: Array, what: str, least: Array) -> Array:
    start = np.arctan2(low, root_difference(x, low))
    width = _angle_to(high, x) - start
    first = np.nextafter(low, math.inf) if low > 0.0 else 0.0  # rounding must not carry r across a kink

    def integrand(node: Array, index: Array) -> Array:
        angle = start[index, None] + width[index, None] * node
        r = np.clip(x[index, None] * np.sin(angle), first, high)
        slope = function(r)
        with np.errstate(over="ignore"):  # an infinite sum settles nothing, and is refused
            result: Array = np.multiply(slope, width[index, None])
        return result

    return settled(integrand, x.size, what, noise(np.minimum(x, high), low), least)


def _on(x: Array, result: Array, inner: Array) -> Array:
    """Scatter `inner`, known where x > 0, into `result` of the shape of x."""
    result[x > 0.0] = inner
    return result


def gap(slope: Curve, edges: Sequence[float], x: Array, against: Array | float = 0.0) -> Array:
    """Return g(x), the transform T1 of a profile given by its slope.

    Parameters
    ----------
    slope
        f'(r) [-], smooth between the `edges`.
    edges
        Radii [m] where f is not smooth.
    x : ndarray, any shape
        Places on the line [m], not negative.
    against : ndarray of the shape of x, or float, optional
        What the result will be added to [m]: it need not be exact beyond the rounding of that.

    Returns
    -------
    ndarray of the shape of x
        g(x) [m].

    Raises
    ------
    NotConverged
        If the integrals do not settle: f is not smooth between the edges.
    """
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    least = np.abs(np.broadcast_to(against, x.shape)[x > 0.0]) / inner
    return _on(x, np.zeros(x.shape), inner * _angular(slope, edges, inner, "g(x)", least))


def gap_slope(slope: Curve, curvature: Curve, kinks: Kinks, x: Array, against: Array | float = 0.0) -> Array:
    """Return g'(x), from f', f'' and the jumps of f' at the kinks.

    Above each kink b with a jump j of the slope, g' carries ``b j / sqrt(x^2 - b^2)``.  `against` is what the result
    will be added to [-].
    """
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    least = np.abs(np.broadcast_to(against, x.shape)[x > 0.0])
    result = _angular(lambda r: slope(r) + r * curvature(r), [b for b, _ in kinks], inner, "g'(x)", least)
    for b, jump in kinks:
        above = inner > b
        result[above] += b * jump / root_difference(inner[above], b)
    return _on(x, np.full(x.shape, 0.5 * math.pi * float(slope(np.zeros(1))[0])), result)


def gap_integral(height: Curve, edges: Sequence[float], x: Array) -> Array:
    """Return the integral of g from 0 to x, by T7: no derivative of f is needed.

    Its derivative is g: the integral form of T1 for noisy heights.
    """
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    return _on(x, np.zeros(x.shape), _angular(lambda r: height(r) * r, edges, inner, "integral of g"))


def surface(function: Curve, edges: Sequence[float], r: Array, end: float = math.inf) -> Array:
    """Return (2/pi) times the integral of function(x) / sqrt(r^2 - x^2) from 0 to min(r, end): T2 and T3.

    With g it gives the profile f(r) back; with the springs' displacement, zero beyond `end`, the displacement of
    the surface.  `edges` are the places where `function` starts a new square root, as g does above a kink.
    """
    r = clear_of_underflow(r)
    inner = r[r > 0.0]
    total = np.zeros_like(inner)
    for low, high in pieces(edges, min(end, float(np.max(inner, initial=0.0)))):
        (active,) = np.nonzero(inner > low)
        total[active] += _surface_piece(function, low, min(high, end), inner[active])
    at_axis = np.full(r.shape, 0.5 * math.pi * float(function(np.zeros(1))[0]))
    return np.asarray((2.0 / math.pi) * _on(r, at_axis, total))


def _surface_piece(function: Curve, low: float, top: float, r: Array) -> Array:
    # y = sqrt(x^2 - low^2) = span sin(angle): the square root above the kink and the kernel's are both gone
    span = root_difference(r, low)
    width = np.full(r.shape, 0.5 * np.pi)
    if top < math.inf:
        last = np.arctan2(root_difference(np.asarray(top), low), root_difference(r, top))
        width = np.where(r <= top, width, last)

    def integrand(node: Array, index: Array) -> Array:
        y = span[index, None] * np.sin(width[index, None] * node)
        x = np.minimum(np.hypot(low, y), r[index, None])
        result: Array = np.multiply(function(x), (y / x) * width[index, None])
        return result

    return settled(integrand, r.size, "surface transform", _noise_below(function, low, top, r))


def _noise_below(function: Curve, low: float, top: float, r: Array) -> Array | None:
    """Return the rounding of places, and that of a function which is a small difference close to its end."""
    places = noise(np.minimum(r, top), low)
    if places is None or top == math.inf:
        return places
    whole, here = np.abs(function(np.array([0.0, 0.5 * (low + top)])))
    lost = np.finfo(float).eps * whole
    return np.asarray(places + (lost / here if here > lost else 1.0))


def integral(function: Curve, edges: Sequence[float], end: Array) -> Array:
    """Return the integral of `function` from 0 to every `end`; just above an edge it may start a square root."""
    end = clear_of_underflow(end)
    ends = end[end > 0.0]
    total = np.zeros_like(ends)
    for low, high in pieces(edges, float(np.max(ends, initial=0.0))):
        (active,) = np.nonzero(ends > low)
        total[active] += _integral_piece(function, low, np.minimum(ends[active], high))
    return _on(end, np.zeros(end.shape), total)


def _integral_piece(function: Curve, low: float, top: Array) -> Array:
    span = root_difference(top, low)

    def integrand(node: Array, index: Array) -> Array:
        y = span[index, None] * node
        x = np.minimum(np.hypot(low, y), top[index, None])
        result: Array = np.multiply(function(x), (y / x) * span[index, None])
        return result

    return settled(integrand, top.size, "integral along the springs", noise(top, low))
