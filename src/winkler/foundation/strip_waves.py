r"""The pressure of a half-plane as waves: what the layers below a line contact feel.

Where the profile is smooth, :math:`f = \sum c_{2n}T_{2n}(x/a)`, the pressure is a sum of the modes of
`winkler.numerics.transforms.strips.strip_modes`, which bear

.. math:: -\pi n\,c_{2n}E^* \quad (n\ge1) , \qquad \pi E^*\sum n\,c_{2n} \quad (n=0) .

Elsewhere (a tip, a kink, a power) the flat punches of all half-widths c give
:math:`G(k) = \int_0^a w'(c)\,J_0(kc)\,\mathrm dc`, with :math:`c^2 = b^2 + (e^2-b^2)\sin^2\theta` from one kink b to
the next e.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.numerics.chunks import chunks, wave_sums
from winkler.numerics.integrals.quadrature import panel_nodes
from winkler.numerics.transforms.strips.strip_modes import bessel_rows, signs
from winkler.numerics.types import Array, Curve
from winkler.values.errors import OutsideValidity

SAMPLES = 64, 256
"""Places at which a profile is read; more where it is wavy."""
TAIL = 8
ENTRIES = 3_000_000
VANISHED = 1e-13
"""Last coefficients of a smooth profile, over the largest."""
ROUNDING = 3e-15
NODES = 24
PANEL_PHASE = 12.0
FIRST_PANELS = 0.25 ** np.arange(20.0, 0.0, -1.0)
"""Ends of the panels towards the middle, where w' may be a power."""
MOST_PAIRS = 2e7
"""More pairs of flat punches and wave numbers than this are refused."""


def smooth_modes(bed: LineFoundation, half_width: Array) -> Array | None:
    """Return the loads over E* [m] of the modes under strips of `half_width` ``(a, n)``; None if f is not smooth.

    Parameters
    ----------
    bed : LineFoundation
        On the half-plane.
    half_width : ndarray, (a,)
        [m], positive.
    """
    if any(b < float(np.max(half_width)) for b, _ in bed.profile.kinks):
        return None
    for count in SAMPLES:
        angle = 0.5 * math.pi * (np.arange(count) + 0.5) / count
        height = bed.profile.height(half_width[:, None] * np.cos(angle))
        order = np.arange(1, count)
        series = 2.0 / count * height @ np.cos(2.0 * np.outer(angle, order))
        largest = np.max(np.abs(series), axis=1, keepdims=True)
        if np.all(np.abs(series[:, -TAIL:]) <= VANISHED * largest):
            break
    else:
        return None
    series = np.where(np.abs(series) > ROUNDING * largest, series, 0.0)
    pushed = math.pi * order * series
    return np.concatenate([np.sum(pushed, axis=1, keepdims=True), -pushed], axis=1)


def transforms(bed: LineFoundation, half_width: Array, k: Array) -> Array:
    """Return G [m] at wave numbers k [1/m] under strips of `half_width` [m] ``(a, k)``."""
    modes = smooth_modes(bed, half_width)
    if modes is not None:
        used = 1 + int(np.max(np.nonzero(np.any(modes != 0.0, axis=0))[0], initial=0))
        pushed, found = modes[:, :used] * signs(used), np.empty((half_width.size, k.size))
        for part in chunks(half_width.size, used * k.size, ENTRIES):
            found[part] = np.einsum("an,nak->ak", pushed[part], bessel_rows(half_width[part, None] * k, used))
        return found
    from scipy.special import j0

    result = np.empty((half_width.size, k.size))
    for place, a in enumerate(half_width):
        widths, loads = punches(bed, float(a), float(k[-1]))
        if widths.size * k.size > MOST_PAIRS:
            raise OutsideValidity(
                f"A strip of the half-width {a:.6g} m is too wide for the uppermost layer under a profile with a tip, "
                "a kink or a fractional power; press less, give a thicker layer, or a smooth profile."
            )
        result[place] = wave_sums(j0, k, widths, loads)
    return result


def averages(bed: LineFoundation, half_width: Array) -> Array:
    """Return the mean of f(x) over the strip, weighted like the pressure of a flat punch [m]."""
    return np.array([_mean(bed.profile.height, _edges(bed, float(a)), float(a)) for a in half_width])


def _edges(bed: LineFoundation, half_width: float) -> list[float]:
    return [0.0, *(b for b, _ in bed.profile.kinks if 0.0 < b < half_width), half_width]


def _mean(height: Curve, edges: list[float], half_width: float) -> float:
    angles = [math.asin(edge / half_width) for edge in edges]
    ends = np.concatenate([angles[1] * np.append(0.0, FIRST_PANELS), np.array(angles[1:])])
    angle, weight = panel_nodes(ends, NODES)
    return float(np.sum(height(half_width * np.sin(angle)) * weight) * 2.0 / math.pi)


def punches(bed: LineFoundation, half_width: float, largest: float) -> tuple[Array, Array]:
    """Return half-widths [m] of flat punches, and their loads over E* [m], for waves up to `largest` [1/m]."""
    edges = _edges(bed, half_width)
    widths, loads = [], []
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        count = math.ceil(max(2.0, 0.5 * math.pi * largest * math.sqrt((high - low) * (high + low)) / PANEL_PHASE))
        ends = np.linspace(0.0, 1.0, count + 1)
        if low == 0.0:
            ends = np.unique(np.concatenate([ends, FIRST_PANELS * ends[1]]))
        angle, weight = panel_nodes(0.5 * math.pi * ends, NODES)
        across = (high - low) * (high + low)
        c = np.sqrt(low * low + across * np.sin(angle) ** 2)
        share = across * np.sin(angle) * np.cos(angle) / c * weight
        first = np.nextafter(low, np.inf) if low > 0.0 else 0.0
        widths.append(c)
        loads.append(bed.load_profile_slope(np.clip(c, first, high)) * share)
    return np.concatenate(widths), np.concatenate(loads)
