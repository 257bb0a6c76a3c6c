r"""The Abel-type transforms of a half-space whose modulus follows a power of the depth, :math:`E \propto z^k`.

========  =============================================================================  ====================
theory    formula                                                                        function
========  =============================================================================  ====================
8.1       :math:`g(x) = x^{1-k}\int_0^x f'(r)\,(x^2-r^2)^{(k-1)/2}\,dr`                  `gap`
          its derivative                                                                 `gap_slope`
          :math:`\int_0^x x^k g = \frac1{1+k}\int_0^x f'(r)\,(x^2-r^2)^{(1+k)/2}\,dr`    `gap_integral`
          :math:`\frac{2\cos(k\pi/2)}\pi\int_0^r x^k u(x)\,(r^2-x^2)^{-(1+k)/2}\,dx`     `surface`
          :math:`-\frac1\pi\int_r^a u'(x)\,(x^2-r^2)^{(k-1)/2}\,dx` + edge               `graded_pressure`
========  =============================================================================  ====================

For k = 0 they are those of `winkler.numerics.transforms.abel`.  A jump j of the slope f' at b leaves in g' the
singularity
:math:`b\,j\,x^{-k}(x^2-b^2)^{(k-1)/2}`; with the strength b j that beds state for their kinks, the formulas here hold
for every k.  Every kernel is a power of a distance times something smooth: Gauss-Jacobi rules integrate that
(`numerics.powered`); near a singularity that lies just outside, the power itself is made the variable of integration.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.integrals.jacobi_quadrature import settled_power
from winkler.numerics.panels.abel_intervals import noise, pieces, root_difference
from winkler.numerics.types import Array, Curve

Kinks = Sequence[tuple[float, float]]


def share(function: np.ufunc, w: Array) -> Array:
    """Return function(w) / w, one at w = 0."""
    safe = np.where(w > 0.0, w, 1.0)
    return np.asarray(np.where(w > 0.0, function(safe) / safe, 1.0))


def first_above(low: float) -> float:
    """Return the place just above a kink: rounding must not carry a node across it."""
    return math.nextafter(low, math.inf) if low > 0.0 else 0.0


def right_cosine(k: float) -> float:
    """Return cos(k pi/2), exact to the last digit near k = 1."""
    return math.sin(0.5 * math.pi * (1.0 - abs(k)))


def half_beta(k: float) -> float:
    """Return the integral of cos^k over a right angle: g'(0) / f'(0)."""
    return 0.5 * math.sqrt(math.pi) * math.exp(math.lgamma(0.5 * (1.0 + k)) - math.lgamma(1.0 + 0.5 * k))


def _angular(function: Curve, edges: Sequence[float], k: float, power: float, x: Array, what: str) -> Array:
    """Integrate function(x cos w) sin(w)^power over w from 0 to a right angle; power is k, or k + 2."""
    total = np.zeros_like(x)
    for low, high in pieces(edges, float(np.max(x, initial=0.0))):
        (own,) = np.nonzero((x > low) & (x <= high))
        total[own] += _angular_own(function, low, high, k, power, x[own], what)
        (past,) = np.nonzero(x > high)
        if past.size:
            total[past] += _angular_past(function, low, high, k, power, x[past], what)
    return total


def _angular_own(function: Curve, low: float, high: float, k: float, power: float, x: Array, what: str) -> Array:
    """Integrate over the piece that holds x: w is the angle from x itself."""
    widest = np.arctan2(root_difference(x, low), low) if low > 0.0 else np.full(x.shape, 0.5 * np.pi)

    def integrand(node: Array, index: Array) -> Array:
        w = widest[index, None] * node
        r = np.clip(x[index, None] * np.cos(w), first_above(low), high)
        weight = (widest[index, None] * share(np.sin, w)) ** k * np.sin(w) ** (power - k)
        result: Array = np.multiply(function(r), weight * widest[index, None])
        # widest^k t^k (sin w / w)^k: the power of t is in the rule
        return result

    return settled_power(integrand, x.size, k, what, noise(x, low))


def _angular_past(function: Curve, low: float, high: float, k: float, power: float, x: Array, what: str) -> Array:
    """Integrate over a piece below x: s = w^(1+k) takes away the singularity that lies just beyond its end."""
    widest = np.arctan2(root_difference(x, low), low) if low > 0.0 else np.full(x.shape, 0.5 * np.pi)
    start, stop = np.arctan2(root_difference(x, high), high) ** (1.0 + k), widest ** (1.0 + k)

    def integrand(node: Array, index: Array) -> Array:
        span = (stop - start)[index, None]
        w = (start[index, None] + span * node) ** (1.0 / (1.0 + k))
        r = np.clip(x[index, None] * np.cos(w), first_above(low), high)
        weight = share(np.sin, w) ** k * np.sin(w) ** (power - k)
        result: Array = np.multiply(function(r), weight * span / (1.0 + k))
        return result

    return settled(integrand, x.size, what, noise(x, low))


def gap(slope: Curve, edges: Sequence[float], k: float, x: Array) -> Array:
    """Return g(x) [m] of a profile given by its slope, smooth between the `edges`.

    Parameters
    ----------
    slope
        f'(r) [-].
    edges
        Radii [m] where f is not smooth.
    k
        Exponent of the grading, above -1.
    x : ndarray, any shape
        Places on the line [m], not negative.
    """
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    result = np.zeros(x.shape)
    result[x > 0.0] = inner * _angular(slope, edges, k, k, inner, "g(x)")
    return result


def kink_slope(x: Array, b: float, k: float) -> Array:
    """Return x^-k (x^2 - b^2)^((k-1)/2), what a kink of unit strength at b > 0 leaves in g'; zero up to b."""
    above = x > b
    place = np.where(above, x, 2.0 * b)
    return np.asarray(np.where(above, place**-k * root_difference(place, b) ** (k - 1.0), 0.0))


def gap_slope(slope: Curve, curvature: Curve, kinks: Kinks, k: float, x: Array) -> Array:
    """Return g'(x) [-], from f', f'' and the jumps of f' at the kinks."""
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    total = _angular(lambda r: slope(r) + r * curvature(r), [b for b, _ in kinks], k, k, inner, "g'(x)")
    for b, jump in kinks:
        if jump != 0.0:
            total += b * jump * kink_slope(inner, b, k)
    result = np.full(x.shape, half_beta(k) * float(slope(np.zeros(1))[0]))
    result[x > 0.0] = total
    return result


def gap_integral(slope: Curve, edges: Sequence[float], k: float, x: Array) -> Array:
    """Return the integral of x^k g(x) from 0 to every x [m^(2+k)]."""
    x = np.asarray(x, dtype=float)
    inner = x[x > 0.0]
    result = np.zeros(x.shape)
    result[x > 0.0] = inner ** (k + 2.0) / (1.0 + k) * _angular(slope, edges, k, k + 2.0, inner, "integral of x^k g")
    return result


def surface(function: Curve, edges: Sequence[float], k: float, r: Array, end: float = math.inf) -> Array:
    """Return (2 cos(k pi/2) / pi) times the integral of x^k function(x) (r^2 - x^2)^(-(1+k)/2) from 0 to min(r, end).

    With g it gives the profile f(r) back; with the springs' displacement, zero beyond `end`, that of the surface.  Just
    above an edge the function may start like a power of the distance, down to the inverse one of g' above a kink.  In
    Gibson's limit k = 1 it is the function itself.
    """
    r = np.asarray(r, dtype=float)
    if k == 1.0:
        inside = r <= end
        return np.asarray(np.where(inside, function(np.where(inside, r, 0.0)), 0.0))
    inner = r[r > 0.0]
    total = np.zeros_like(inner)
    for low, high in pieces(edges, min(end, float(np.max(inner, initial=0.0)))):
        (active,) = np.nonzero(inner > low)
        total[active] += _near_low(function, low, min(high, end), k, inner[active])
        total[active] += _near_high(function, low, min(high, end), k, inner[active])
    result = np.full(r.shape, float(function(np.zeros(1))[0]))
    result[r > 0.0] = (2.0 / math.pi) * math.sin(0.5 * math.pi * (1.0 - k)) * total
    return result


def _middle(low: float, top: float, r: Array) -> Array:
    """Return y^2 = x^2 - low^2 in the middle of a piece that ends at min(top, r)."""
    last = np.minimum(r, top)
    return np.asarray(0.5 * (last - low) * (last + low))


def _near_low(function: Curve, low: float, top: float, k: float, r: Array) -> Array:
    # y = sqrt(x^2 - low^2) = Y t: x^k at the axis, or what starts at the kink like y^(k-1), is t^k times something
    widest, span = np.sqrt(_middle(low, top, r)), root_difference(r, low)

    def integrand(node: Array, index: Array) -> Array:
        y = widest[index, None] * node
        x = np.clip(np.hypot(low, y), first_above(low), np.minimum(r[index, None], top))
        kernel = (span[index, None] ** 2 - y * y) ** (-0.5 * (1.0 + k))
        whole = widest[index, None] ** (1.0 + k)
        weight = whole if low == 0.0 else whole * x ** (k - 1.0) * y ** (1.0 - k)
        result: Array = np.multiply(function(x), kernel * weight)
        return result

    return settled_power(integrand, r.size, k, "surface transform", noise(r, low))


def _near_high(function: Curve, low: float, top: float, k: float, r: Array) -> Array:
    # v = sqrt(r^2 - x^2): the kernel leaves v^-k, in the rule where the piece ends at r, else s = v^(1-k)
    widest = np.sqrt(root_difference(r, low) ** 2 - _middle(low, top, r))
    first = first_above(low)
    total = np.zeros_like(r)
    (own,) = np.nonzero(r <= top)
    (past,) = np.nonzero(r > top)

    def on_own(node: Array, index: Array) -> Array:
        place, wide = r[own][index, None], widest[own][index, None]
        v = wide * node
        x = np.clip(np.sqrt((place - v) * (place + v)), first, np.minimum(place, top))
        result: Array = np.multiply(function(x), x ** (k - 1.0) * wide ** (1.0 - k))
        return result

    if own.size:
        total[own] = settled_power(on_own, own.size, -k, "surface transform", noise(r[own], low))
    if past.size:
        start, stop = root_difference(r[past], top) ** (1.0 - k), widest[past] ** (1.0 - k)

        def beyond(node: Array, index: Array) -> Array:
            width, place = (stop - start)[index, None], r[past][index, None]
            v = (start[index, None] + width * node) ** (1.0 / (1.0 - k))
            x = np.clip(np.sqrt((place - v) * (place + v)), first, top)
            result: Array = np.multiply(function(x), x ** (k - 1.0) * width / (1.0 - k))
            return result

        total[past] = settled(beyond, past.size, "surface transform", noise(r[past], low))
    return total
