r"""Sudden steps of a signal among noise that may be slow.

At each point two straight lines through w neighbours on either side are extrapolated to the middle; their gap

.. math:: g_i = \frac{1}{w}\sum_{k=0}^{w-1} c_k\,(y_{i+k} - y_{i-1-k}), \qquad c_k = 1 - \frac{3w(2k-w+1)}{w^2-1},

vanishes for straight lines, kinks at i and parabolas.  Its own scatter along the signal, for each w, is the noise, so
that slow noise counts.  A candidate is a step if a cubic with a step describes its neighbourhood far better than a
cubic with a kink or with a ramp.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.events.record import MAD_TO_SIGMA
from winkler.fitting.curves.medians import median
from winkler.numerics.types import Array

WIDTHS = (3, 6, 12, 24)
"""Numbers w of neighbours on each side."""
FEWEST_WIDTHS = 6
"""Least length of a signal in w."""
LEAST_RATIO = 6.0
"""Least gap over its noise."""
LEAST_SHARE = 1e-3
"""Least gap relative to the range of the signal."""
LOCAL_WIDTHS = 16
"""Neighbourhood, in w, in which the local noise is read."""
LEAST_GAIN_OF_KINK, LEAST_GAIN_OF_RAMP = 30.0, 5.0
"""Least chi-square by which a step is better than a kink, and than a ramp."""
RAMP_SHARE = 0.5
"""Length of a ramp that is no step, in w."""
MOST_STEPS = 200


class Step(NamedTuple):
    """A step between the points `place` - 1 and `place`: its size, and the standard error of that."""

    place: int
    size: float
    error: float

    @property
    def ratio(self) -> float:
        """Size over error."""
        return abs(self.size) / self.error if self.error > 0.0 else math.inf


def found_steps(signal: Array, sign: float = 1.0) -> tuple[Step, ...]:
    """Return the sudden steps of a signal up (`sign` = 1) or down (-1), in their order.

    Parameters
    ----------
    signal : ndarray, (n,)
    sign : float
    """
    span = float(np.ptp(signal)) if signal.size else 0.0
    if not span > 0.0:
        return ()
    candidates: list[tuple[float, int, int, float, float]] = []
    for width in WIDTHS:
        if signal.size < FEWEST_WIDTHS * width:
            break
        gaps = _gaps(signal, width)
        whole = MAD_TO_SIGMA * median(np.abs(gaps))
        high = sign * gaps > max(LEAST_RATIO * whole, LEAST_SHARE * span)
        places = np.flatnonzero(high)
        if not places.size:
            continue
        noise = np.full(gaps.shape, whole)
        noise[places] = _noise(gaps, width, places, whole)
        high[places] = sign * gaps[places] > LEAST_RATIO * noise[places]
        for place in _peaks(np.where(high, sign * gaps, 0.0), width):
            error = max(float(noise[place]), 1e-12 * span)
            candidates.append((sign * gaps[place] / error, place + width, width, float(gaps[place]), error))
    kept: list[tuple[int, int, Step]] = []
    for _, index, width, gap, error in sorted(candidates, reverse=True):
        if len(kept) == MOST_STEPS or any(abs(index - other) < max(width, wide) for other, wide, _ in kept):
            continue
        if _is_sudden(signal, index, width):
            kept.append((index, width, Step(index, gap, error)))
    return tuple(sorted((step for _, _, step in kept), key=lambda step: step.place))


def _gaps(signal: Array, width: int) -> Array:
    """Return the gaps ``(n - 2 w + 1,)``; the first is that between the points w - 1 and w."""
    k = np.arange(width)
    half = 1.0 / width - 6.0 * (k - 0.5 * (width - 1.0)) / (width**2 - 1.0)
    kernel = np.concatenate([-half[::-1], half])
    gaps: Array = np.correlate(signal - signal[0], kernel, mode="valid")
    return gaps


def _noise(gaps: Array, width: int, places: Array, whole: float) -> Array:
    """Return the standard deviation of gaps at places: that of all, or of the neighbourhood if it is greater."""
    sizes, reach = np.abs(gaps), LOCAL_WIDTHS * width
    centres = np.arange(0, gaps.size, width)
    beside = places // width
    needed = np.unique(np.minimum(np.concatenate([beside, beside + 1]), centres.size - 1))
    inner = needed[(centres[needed] >= reach) & (centres[needed] + reach < gaps.size)]
    local = np.zeros(centres.size)
    if inner.size:
        windows = np.lib.stride_tricks.sliding_window_view(sizes, 2 * reach + 1)
        local[inner] = np.median(windows[centres[inner] - reach], axis=1)
    for index in np.setdiff1d(needed, inner).tolist():
        local[index] = median(sizes[max(index * width - reach, 0) : index * width + reach + 1])
    return np.asarray(np.maximum(whole, MAD_TO_SIGMA * np.interp(places, centres, local)))


def _peaks(heights: Array, width: int) -> list[int]:
    """Return the highest places of the separate parts above zero, and within each part one per `width`."""
    result: list[int] = []
    above = np.flatnonzero(heights > 0.0)
    for part in np.split(above, np.flatnonzero(np.diff(above) > 1) + 1):
        left = list(part[np.argsort(heights[part])[::-1]])
        while left:
            best = int(left[0])
            result.append(best)
            left = [place for place in left if abs(int(place) - best) >= 2 * width]
    return result


def _is_sudden(signal: Array, index: int, width: int) -> bool:
    """Return whether a cubic with a step leaves much less than a cubic with a kink, or with a ramp, nearby."""
    reach = max(2 * width, 8)
    first, last = max(index - reach, 0), min(index + reach, signal.size)
    x = np.arange(first, last) - (index - 0.5)
    y = signal[first:last] - signal[first:last].mean()
    cubic = np.stack([np.ones(x.size), x, x**2, x**3], axis=1) / float(reach) ** np.arange(4)
    step = _left(cubic, y, (x > 0.0).astype(float))
    shifts = np.linspace(-width, width, 9)
    kinks = [np.maximum(x - shift, 0.0) for shift in shifts]
    length = max(RAMP_SHARE * width, 2.5)
    ramp = np.clip(x / length + 0.5, 0.0, 1.0)
    kink = min(_left(cubic, y, part) for part in kinks)
    gain_of_kink = _gain(kink, step, x.size) > LEAST_GAIN_OF_KINK
    return gain_of_kink and _gain(_left(cubic, y, ramp), step, x.size) > LEAST_GAIN_OF_RAMP


def _gain(other: float, step: float, count: int) -> float:
    """Return the chi-square by which a step is better."""
    return (other - step) / step * max(count - 5, 1) if step > 0.0 else math.inf


def _left(columns: Array, y: Array, extra: Array) -> float:
    """Return the sum of squares that columns and an extra one leave."""
    orthogonal, _ = np.linalg.qr(np.column_stack([columns, extra]))
    left = y - orthogonal @ (orthogonal.T @ y)
    return float(left @ left) + 1e-24 * float(y @ y)
