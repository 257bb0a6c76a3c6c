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
from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.panels.abel_intervals import Kinks, clear_of_underflow, noise, pieces, root_difference
from winkler.numerics.types import Array, Curve


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


NEGLIGIBLE_SHARE = 1e-2
"""Pieces whose share of the pressure is less than this part of the steepest u' are measured against that."""

Weight = Callable[[Array, Array], Array]


def _one(r: Array, x: Array) -> Array:
    return np.ones(np.broadcast_shapes(np.shape(r), np.shape(x)))


def pressure(
    slope: Curve, kinks: Kinks, edge: float, end: float, r: Array, weight: Weight = _one, known: float = 0.0
) -> Array:
    """Return T4 for unit modulus: the pressure under springs displaced by u(x), zero beyond `end`.

    Parameters
    ----------
    slope
        u'(x) [-], smooth between the `kinks`.
    kinks
        ``(x, strength)``: just above x the slope holds ``-strength / sqrt(x^2 - x_kink^2)``.
    edge
        u(end-) [m], the jump at the edge.
    end
        The radius a of the contact [m].
    r : ndarray, any shape
        Distance from the axis [m].
    weight
        Takes r and x of one shape, returns how much more than 1 / (pi sqrt(x^2 - r^2)) a flat punch of radius x and
        unit depth presses at r; one on a homogeneous half-space.
    known
        To which relative precision slope and weight are known: changes of that size count as settled.

    Returns
    -------
    ndarray
        p / E*; zero outside, infinite at an edge that jumps, at a kink, and at the apex of a cone.
    """
    r = np.asarray(r, dtype=float)
    flat = np.zeros(r.size)
    (inside,) = np.nonzero((r < end).ravel())
    radii = r.ravel()[inside]
    total = np.zeros(radii.shape)
    singular = [(b, strength) for b, strength in kinks if strength != 0.0 and 0.0 < b < end]
    open_ = np.all(radii[:, None] != np.array([b for b, _ in singular]), axis=1)
    near = 1e-9 * min([end] + [b for b, _ in kinks if b > 0.0])
    sample = np.abs(slope(np.linspace(0.0, end, 66)[1:-1]))
    steepest = float(np.max(sample[np.isfinite(sample)], initial=0.0))
    total[open_] = _tail(slope, kinks, end, np.maximum(radii[open_], near), steepest, weight, known)
    (axis,) = np.nonzero(radii < near)
    total[axis] += _towards_axis(slope, near, radii[axis], steepest)
    if edge != 0.0:
        total += edge * weight(radii, np.full(radii.shape, end)) / root_difference(np.asarray(end), radii)
    flat[inside] = total / math.pi
    for b, strength in [*singular, (end, edge)]:
        if strength != 0.0:
            flat[r.ravel() == b] = math.copysign(math.inf, strength)
    return flat.reshape(r.shape)


def _towards_axis(slope: Curve, near: float, r: Array, steepest: float) -> Array:
    """Return by how much the tail at r < near exceeds that at `near`; -u'(x) = c x^m so close to the axis.

    The tail of a power is a constant and ``c r^m k(m) / m`` with k(m) = -sqrt(pi) Gamma(1 - m/2) / Gamma((1 - m)/2).
    """
    there, farther = -np.asarray(slope(np.array([near, 100.0 * near])))
    if abs(there) <= 1e-9 * steepest or there * farther <= 0.0:  # smooth, up to rounding
        return np.zeros(r.shape)
    m = math.log(farther / there) / math.log(100.0)
    if m > 1.5:
        return np.zeros(r.shape)
    m = 0.0 if abs(m) < 1e-6 else m
    with np.errstate(divide="ignore"):
        fall = np.log(r / near)
    gain = np.expm1(m * fall) / m if m != 0.0 else fall
    factor = -math.sqrt(math.pi) * math.gamma(1.0 - 0.5 * m) / math.gamma(0.5 * (1.0 - m)) if m != 1.0 else 0.0
    return np.asarray(float(there) * factor * gain)


def _tail(slope: Curve, kinks: Kinks, end: float, r: Array, steepest: float, weight: Weight, known: float) -> Array:
    """Integrate -u'(x) weight(r, x) / sqrt(x^2 - r^2) over x from r > 0 to `end`."""
    total = np.zeros_like(r)
    strengths = dict(kinks)
    least = NEGLIGIBLE_SHARE * steepest
    for low, high in pieces([b for b, _ in kinks], end):
        top = min(high, end)
        # the piece that holds r starts at r; those beyond start at their kink, with its inverse square root
        (inside,) = np.nonzero((r >= low) & (r < top))
        (before,) = np.nonzero(r < low)
        for own, places in ((True, inside), (False, before)):
            strength = strengths.get(low, 0.0)
            total[places] += _tail_piece(slope, (low, top), strength, r[places], own, least, weight, known)
    return total


def _tail_piece(
    slope: Curve,
    piece: tuple[float, float],
    strength: float,
    r: Array,
    own: bool,
    least: float,
    weight: Weight,
    known: float,
) -> Array:
    # y = sqrt(x^2 - low^2) removes the square root of the kink below; y = scale cosh(w) (own: r >= low) or
    # scale sinh(w) (r < low) that of the kernel, dx / sqrt(x^2 - r^2) = y dw / x, however close r is to the kink
    low, top = piece
    first = np.nextafter(low, math.inf) if low > 0.0 else 0.0
    r = np.maximum(r, first) if own else r
    scale = root_difference(r, low) if own else root_difference(np.asarray(low), r)
    reach = np.arcsinh(root_difference(np.asarray(top), r if own else low) / scale)
    rise = np.cosh if own else np.sinh

    def integrand(node: Array, index: Array) -> Array:
        y = scale[index, None] * rise(reach[index, None] * node)
        x = np.clip(np.hypot(low, y), first, top)
        regular = -np.asarray(slope(x))
        if strength != 0.0:  # taken off at the same rounded x, so that the errors cancel
            regular = regular - strength / root_difference(x, low)
        rotated = weight(np.broadcast_to(r[index, None], x.shape), x)
        return np.asarray((strength + y * regular) / x * rotated * reach[index, None])

    rounding = noise(np.full(r.shape, top), low)
    rough = np.full(r.shape, known) if rounding is None else np.maximum(rounding, known)
    return settled(integrand, r.size, "pressure", rough, least)


def line_load(pressure: Curve, edges: Sequence[float], end: float, x: Array) -> Array:
    """Return q(x) = 2 times the integral of r p(r) / sqrt(r^2 - x^2) from x to `end`: T5.

    The pressure may rise or fall like (end^2 - r^2)^(+-1/2) at the edge, and diverge logarithmically at `edges`.
    """
    x = np.asarray(x, dtype=float)
    result = np.zeros(x.shape)
    inside = x < end
    places = x[inside]
    span = root_difference(np.asarray(end), places)
    total = np.zeros_like(places)
    for low, high in pieces(edges, end):
        top = min(high, end)
        (active,) = np.nonzero(places < top)
        total[active] += _line_load_piece(pressure, low, top, end, places[active], span[active])
    result[inside] = 2.0 * total
    return result


def _line_load_piece(pressure: Curve, low: float, top: float, end: float, x: Array, span: Array) -> Array:
    # y = sqrt(r^2 - x^2) = span sin(angle), dy = sqrt(end^2 - r^2) d(angle): the pressure's own root at the edge is
    # gone if both are taken at the same rounded r
    first = np.arcsin(np.minimum(root_difference(np.asarray(low), x) / span, 1.0))
    width = np.arcsin(np.minimum(root_difference(np.asarray(top), x) / span, 1.0)) - first
    first_r, last_r = np.nextafter(low, math.inf), np.nextafter(top, 0.0)

    def integrand(node: Array, index: Array) -> Array:
        angle = first[index, None] + width[index, None] * node
        r = np.clip(np.hypot(x[index, None], span[index, None] * np.sin(angle)), first_r, last_r)
        result: Array = np.multiply(pressure(r), root_difference(np.asarray(end), r) * width[index, None])
        return result

    return settled(integrand, x.size, "line load")
