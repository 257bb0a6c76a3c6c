r"""The pressure under displaced springs on a half-space graded by a power law.

.. math:: p(r) = -\frac1\pi\int_r^a \frac{u'(x)\,\mathrm dx}{(x^2-r^2)^{(1-k)/2}}
          + \frac{u(a)}{\pi\,(a^2-r^2)^{(1-k)/2}}

in units of :math:`E^*/c_0^k`: flat punches, superposed.  A kink b of the profile leaves in u' the singularity
:math:`x^{-k}(x^2-b^2)^{(k-1)/2}`; for k > 0 the pressure there is finite.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.numerics.integrals.jacobi_quadrature import settled_power
from winkler.numerics.panels.abel_intervals import pieces, root_difference
from winkler.numerics.transforms.graded_abel import first_above, kink_slope, share
from winkler.numerics.types import Array, Curve

Kinks = Sequence[tuple[float, float]]


def pressure(slope: Curve, kinks: Kinks, edge: float, end: float, k: float, r: Array) -> Array:
    """Return the pressure under springs displaced by u(x), zero beyond `end`, in units of E* / c0^k.

    Parameters
    ----------
    slope
        u'(x) [-], smooth between the `kinks`.
    kinks
        ``(x, strength)``: just above x the slope holds ``-strength x^-k (x^2 - x_kink^2)^((k-1)/2)``.
    edge
        u(end-) [m], the jump at the edge.
    end
        The radius a of the contact [m].
    k
        Exponent of the grading, above -1, at most 1.
    r : ndarray, any shape
        Distance from the axis [m].

    Returns
    -------
    ndarray
        p c0^k / E* [m^k]; zero outside, infinite where it diverges: at an edge that jumps, at a kink if k <= 0, and
        perhaps at the axis.
    """
    r = np.asarray(r, dtype=float)
    flat = np.zeros(r.size)
    (inside,) = np.nonzero((r < end).ravel())
    radii = r.ravel()[inside]
    total = np.zeros(radii.shape)
    singular = [(b, strength) for b, strength in kinks if strength != 0.0 and 0.0 < b < end]
    on_kink = np.isin(radii, [b for b, _ in singular])
    near = 1e-9 * min([end] + [b for b, _ in kinks if b > 0.0])
    total[~on_kink] = _tail(slope, kinks, end, k, np.maximum(radii[~on_kink], near))
    (axis,) = np.nonzero(radii < near)
    total[axis] += _towards_axis(slope, near, k, radii[axis])
    for b, strength in singular:
        here = radii == b
        if here.any():
            total[here] = math.copysign(math.inf, strength) if k <= 0.0 else _at_kink(slope, kinks, end, k, b)
    if edge != 0.0:
        total += edge * root_difference(np.asarray(end), radii) ** (k - 1.0)
    flat[inside] = total / math.pi
    if edge != 0.0 and k < 1.0:
        flat[r.ravel() == end] = math.copysign(math.inf, edge)
    return flat.reshape(r.shape)


def _towards_axis(slope: Curve, near: float, k: float, r: Array) -> Array:
    """Return by how much the tail at r < near exceeds that at `near`; -u'(x) = c x^m so close to the axis.

    The tail of a power is a constant and ``c r^n K(n) / n`` with n = m + k and
    K(n) = -Gamma((1 + k)/2) Gamma(1 - n/2) / Gamma((1 - m)/2).
    """
    from scipy.special import rgamma

    there, farther = -np.asarray(slope(np.array([near, 100.0 * near])))
    if there == 0.0 or there * farther <= 0.0:
        return np.zeros(r.shape)
    m = math.log(farther / there) / math.log(100.0)
    m = round(m) if abs(m - round(m)) < 1e-6 else m
    n = m + k
    if n > 1.5:
        return np.zeros(r.shape)
    n = 0.0 if abs(n) < 1e-6 else n
    with np.errstate(divide="ignore"):
        fall = np.log(r / near)
    gain = np.expm1(n * fall) / n if n != 0.0 else fall
    factor = -math.gamma(0.5 * (1.0 + k)) * math.gamma(1.0 - 0.5 * n) * float(rgamma(0.5 * (1.0 - m)))
    return np.asarray(float(there) * near**k * factor * gain) if factor != 0.0 else np.zeros(r.shape)


def _tail(slope: Curve, kinks: Kinks, end: float, k: float, r: Array) -> Array:
    """Integrate -u'(x) (x^2 - r^2)^((k-1)/2) over x from r > 0 to `end`."""
    total = np.zeros_like(r)
    strengths = dict(kinks)
    for low, high in pieces([b for b, _ in kinks], end):
        top = min(high, end)
        # the piece that holds r starts at r; those beyond start at their kink, with its singularity
        (inside,) = np.nonzero((r >= low) & (r < top))
        (before,) = np.nonzero(r < low)
        for own, places in ((True, inside), (False, before)):
            if places.size:
                total[places] += _tail_piece(slope, low, top, strengths.get(low, 0.0), k, r[places], own)
    return total


def _regular(slope: Curve, x: Array, low: float, strength: float, k: float) -> Array:
    """Return -u'(x) less the singular part that the kink at `low` gives it, at the same rounded x."""
    regular = -np.asarray(slope(x))
    return regular - strength * kink_slope(x, low, k) if strength != 0.0 else regular


def _tail_piece(slope: Curve, low: float, top: float, strength: float, k: float, r: Array, own: bool) -> Array:
    # y = sqrt(x^2 - low^2) = scale cosh(w) (own: r >= low) or scale sinh(w) (r < low); one of kernel and kink is then
    # (scale sinh w)^(k-1): its w^k is in the rule, however close r is to the kink
    first = first_above(low)
    r = np.maximum(r, first) if own else r
    scale = root_difference(r, low) if own else root_difference(np.asarray(low), r)
    reach = np.arcsinh(root_difference(np.asarray(top), r if own else low) / scale)
    whole = reach ** (1.0 + k)

    def integrand(node: Array, index: Array) -> Array:
        size = scale[index, None]
        w = reach[index, None] * node
        y = size * (np.cosh(w) if own else np.sinh(w))
        x = np.clip(np.hypot(low, y), first, top)
        regular = _regular(slope, x, low, strength, k) * y / x
        sinh = size * share(np.sinh, w)  # (scale sinh w)^k dw = sinh^k w^k dw
        weight = whole[index, None]
        if own:
            kink = strength * x ** (-k - 1.0) * y**k if strength != 0.0 else 0.0
            return np.asarray((regular + kink) * sinh**k * weight)
        kernel = (size * np.cosh(w)) ** k
        kink = strength * x ** (-k - 1.0) * sinh**k if strength != 0.0 else 0.0
        return np.asarray((regular * np.where(w > 0.0, w, 1.0) ** -k + kink) * kernel * weight)

    return settled_power(integrand, r.size, k, "pressure")


def _at_kink(slope: Curve, kinks: Kinks, end: float, k: float, b: float) -> float:
    """Return the tail at a kink itself, finite for k > 0: kernel and kink are both (x^2 - b^2)^((k-1)/2)."""
    top = min([x for x, _ in kinks if x > b] + [end])
    strength = dict(kinks)[b]
    widest = root_difference(np.asarray(top), b)

    def integrand(node: Array, index: Array) -> Array:
        y = widest * node ** (0.5 / k)
        x = np.clip(np.hypot(b, y), first_above(b), top)
        both = strength * x ** (-k - 1.0) + _regular(slope, x, b, strength, k) * y ** (1.0 - k) / x
        return np.asarray(both * widest ** (2.0 * k) / (2.0 * k) * np.ones((index.size, 1)))

    beyond = [(x, jump) for x, jump in kinks if b < x < end]
    rest = 0.0
    for (low, jump), (high, _) in pairwise([*beyond, (end, 0.0)]):
        rest += float(_tail_piece(slope, low, high, jump, k, np.array([b]), False)[0])
    return float(settled(integrand, 1, "pressure")[0]) + rest
