"""Roots between known signs, for many brackets at once.

Chandrupatla's method: inverse quadratic interpolation where it can be trusted, bisection where it cannot, so that a
bracket is never lost.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.numerics.types import Array

MOST_ITERATIONS = 200
ROOT_TOLERANCE = 2.0 * np.finfo(float).eps


def between(function: Callable[[Array, Array], Array], low: Array, high: Array) -> Array:
    """Return a root of every function between `low` and `high`, to the rounding of its place.

    Parameters
    ----------
    function
        Takes places ``(m,)`` and the indices ``(m,)`` of the brackets they belong to; returns values ``(m,)``.
    low, high : ndarray, (n,)
        The function has different signs at both ends, or is zero at one of them.

    Returns
    -------
    ndarray, (n,)

    References
    ----------
    T. R. Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149

    Examples
    --------
    >>> import numpy as np
    >>> between(lambda x, index: x * x - np.array([2.0, 3.0])[index], np.zeros(2), np.full(2, 2.0)).round(12)
    array([1.41421356, 1.73205081])
    """
    every = np.arange(low.size)
    b, a = np.array(low, dtype=float), np.array(high, dtype=float)
    result = np.empty(low.size)
    fb, fa = function(b, every), function(a, every)
    c, fc, share = b.copy(), fb.copy(), np.full(low.size, 0.5)
    waiting = every
    for _ in range(MOST_ITERATIONS):
        better = np.abs(fb) < np.abs(fa)
        best = np.where(better, b, a)
        width = np.abs(b - a)
        part = ROOT_TOLERANCE * np.abs(best) / np.where(width > 0.0, width, 1.0)
        settled = (part >= 0.5) | (width == 0.0) | (np.where(better, fb, fa) == 0.0)
        result[waiting[settled]] = best[settled]
        left = ~settled
        if not left.any():
            break
        waiting = waiting[left]
        a, b, c, fa, fb, fc, share, part = (each[left] for each in (a, b, c, fa, fb, fc, share, part))
        t = a + np.clip(share, part, 1.0 - part) * (b - a)
        ft = function(t, waiting)
        same = np.sign(ft) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = t, ft
        share = _share(a, b, c, fa, fb, fc)
    else:
        result[waiting] = a
    return result


def _share(a: Array, b: Array, c: Array, fa: Array, fb: Array, fc: Array) -> Array:
    """Return the next trial, as a part of the distance from a to b."""
    with np.errstate(all="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        trusted = (phi * phi < xi) & ((1.0 - phi) ** 2 < 1.0 - xi)
        quadratic = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
    return np.where(trusted & np.isfinite(quadratic), quadratic, 0.5)
