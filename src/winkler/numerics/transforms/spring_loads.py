r"""Between the springs and the pressure: T4, `pressure`, and T5, `line_load`, its inverse.

See `winkler.numerics.transforms.abel` for how the integrals are cut and mapped.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.transforms.abel_intervals import Kinks, noise, pieces, root_difference
from winkler.numerics.types import Array, Curve

__all__ = ["line_load", "pressure"]

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
