r"""The pressure on a strip of a layered body: a correction of the half-plane's pressure, in its modes.

Let a half-plane of the uppermost layer carry the pressure with the transform :math:`E^*G(k)` under some profile.  The
layers below move its surface by :math:`\frac2{\pi}\int_0^\infty\frac Mk\,\hat p\cos kx\,\mathrm dk/E^*` besides.  With
the correction :math:`\sum\beta_n p_n` of `winkler.numerics.transforms.strip_modes`, and :math:`s_n = (-1)^n`, the
surface follows the profile if

.. math:: \beta_m + 4m\sum_n s_ms_nA_{mn}\beta_n = -4m\,s_m\int_0^\infty\frac Mk J_{2m}(ka)\,G\,\mathrm dk ,
          \qquad A_{mn} = \int_0^\infty\frac Mk J_{2m}J_{2n}\,\mathrm dk , \qquad m \ge 1 .

:math:`\beta_0` bears what a flat punch bears: it is the one with which the pressure vanishes at the edge,
:math:`\sum\beta_n=0`.  M is analytic and dies out like :math:`e^{-2kh}`, so that the modes converge geometrically, also
where the pressure of the half-plane is infinite at a tip or a kink.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.caching import cached_by_value
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, WaveResponse, in_own_lengths, wave_numbers
from winkler.numerics.transforms.strip_modes import bessel_rows, signs
from winkler.numerics.types import Array

__all__ = ["TAIL", "VANISHED", "StripResponse", "Transforms", "Waves", "settled_strips", "strip_responses", "waves"]

FIRST_WAVE_NUMBER = 0.5
"""First panel of wave numbers, in units of 1 / span."""
LARGEST_PHASE = 12.0
"""Largest phase of a wave across the whole strip over one panel of the quadrature."""
FEWEST_MODES, MOST_MODES = 20, 384
TAIL = 4
"""Modes at the end that must have vanished."""
VANISHED = 3e-14
"""The same, over the largest, on a layer as thick as the strip is wide: rounding grows with a / h."""
LEAST_SHARE = 0.1
"""What the layers add need be no more precise than this part of the half-plane's load."""
ENTRIES_PER_BLOCK = 3_000_000


class Waves(NamedTuple):
    """Wave numbers [1/m] and quadrature weights times M / k."""

    k: Array
    weights: Array


class StripResponse(NamedTuple):
    """What the layers add under strips of several half-widths, loads over E* [m] of the modes ``(a, n)``.

    Parameters
    ----------
    closing
        Correction whose edge is that of the half-plane's pressure.
    punch
        A flat punch that bears a load of one.
    """

    closing: Array
    punch: Array


Rows = Callable[[int], Array]
"""Transforms of so many modes of several strips at wave numbers: ``(a, n, k)``."""
Transforms = Callable[[Array, Array], Array]
"""G [m] of the half-plane's pressures under half-widths ``(a,)`` at wave numbers ``(k,)``: ``(a, k)``."""


@cached_by_value(64)
def waves(response: WaveResponse, octave: int) -> Waves:
    """Return the waves of a response for places and half-widths up to 2^octave of its own units of length [m]."""
    own, unit = in_own_lengths(response)
    k, weights = _own_waves(own, octave)
    return Waves(k / unit, weights)


@cached_by_value(64)
def _own_waves(own: WaveResponse, octave: int) -> Waves:
    widest = LARGEST_PHASE / (2.0 * own.length * 2.0**octave)
    k, weights = wave_numbers(FIRST_WAVE_NUMBER / own.span, widest, DECAY_SPAN / own.length)
    return Waves(k, weights * own.excess(k) / k)


def octaves(response: WaveResponse, extent: Array, least: int = 0) -> Array:
    """Return the octaves of `waves` for extents [m], none below `least`."""
    return np.maximum(np.ceil(np.log2(np.maximum(extent / response.length, 1e-300))), least).astype(int)


def strip_responses(response: WaveResponse, half_width: Array, transforms: Transforms) -> StripResponse:
    """Return corrections and flat punches of strips.

    Parameters
    ----------
    response : WaveResponse
    half_width : ndarray, (m,)
        a [m], positive.
    transforms
        The half-planes' pressures; they need not vanish at the edge.

    Raises
    ------
    NotConverged
        If 384 modes do not suffice: a sharp tip or kink on a layer hundreds of times thinner than the strip is wide.
    """
    groups = octaves(response, half_width, -1)
    parts: list[tuple[Array, Array, Array]] = []
    for octave in np.unique(groups):
        found = waves(response, int(octave))
        (members,) = np.nonzero(groups == octave)
        count = _modes_of(int(octave))
        step = max(1, ENTRIES_PER_BLOCK // (found.k.size * count))
        for start in range(0, members.size, step):
            chosen = members[start : start + step]
            a = half_width[chosen]
            allowed = VANISHED * 2.0 ** (0.5 * octave)
            solved = settled_strips(_signed(a, found.k), found.weights, transforms(a, found.k), count, allowed)
            parts.append((chosen, *solved))
    most = max((closing.shape[1] for _, closing, _ in parts), default=1)
    result = StripResponse(np.zeros((half_width.size, most)), np.zeros((half_width.size, most)))
    for chosen, closing, punch in parts:
        result.closing[chosen, : closing.shape[1]] = closing
        result.punch[chosen, : punch.shape[1]] = punch
    return result


def _signed(half_width: Array, k: Array) -> Rows:
    """Return what gives the transforms of modes: (-1)^n J_2n(ka)."""

    def rows_of(count: int) -> Array:
        rows = np.moveaxis(bessel_rows(half_width[:, None] * k, count), 0, 1)
        rows *= signs(count)[:, None]
        return rows

    return rows_of


def _modes_of(octave: int) -> int:
    return FEWEST_MODES + 8 * max(octave, -1)


def settled_strips(
    rows_of: Rows, weights: Array, transforms: Array, count: int, vanished: float, most: int = MOST_MODES
) -> StripResponse:
    """Return corrections and flat punches of strips whose modes are known as waves.

    Parameters
    ----------
    rows_of
        Takes a number of modes, returns their transforms at the wave numbers ``(a, n, k)``.
    weights : ndarray, (k,)
        Of the quadrature, times M / k.
    transforms : ndarray, (a, k)
        G [m] of the half-planes' pressures.
    count : int
        Modes to begin with.
    vanished : float
        What the last modes may be, over the largest.
    most : int
        More modes are not tried, nor more than 384.

    Raises
    ------
    NotConverged
        If so many modes do not suffice.
    """
    while True:
        closing, punch = _solved(rows_of(count), weights, transforms)
        scale = np.maximum(np.max(np.abs(closing), axis=1), LEAST_SHARE * np.abs(transforms[:, 0]))
        if _vanished(closing, vanished * scale) and _vanished(punch, vanished * np.max(np.abs(punch), axis=1)):
            return StripResponse(closing, punch)
        if count >= min(most, MOST_MODES):
            raise NotConverged(
                f"The pressure on a strip is not resolved by {count} modes: the layer is too thin for it; round a "
                "sharp tip or kink off, press less, or give a thicker layer."
            )
        count = min(2 * count, most, MOST_MODES)


def _vanished(modes: Array, allowed: Array) -> bool:
    return bool(np.all(np.max(np.abs(modes[:, -TAIL:]), axis=1) <= allowed))


def _solved(rows: Array, weights: Array, transforms: Array) -> tuple[Array, Array]:
    weighted = rows * weights
    coupled = weighted @ np.swapaxes(rows, 1, 2)
    pressed = np.einsum("ank,ak->an", weighted, transforms)
    fourfold = 4.0 * np.arange(1, rows.shape[1])
    matrix = np.eye(fourfold.size) + fourfold[:, None] * coupled[:, 1:, 1:]
    sides = -fourfold[:, None] * np.stack([pressed[:, 1:], coupled[:, 1:, 0]], axis=2)
    own = np.linalg.solve(matrix, sides)
    first = np.ones((rows.shape[0], 1))
    punch = np.concatenate([first, own[..., 1]], axis=1)
    free = np.concatenate([0.0 * first, own[..., 0]], axis=1)
    edge = np.sum(free, axis=1) / np.sum(punch, axis=1)
    return free - edge[:, None] * punch, punch
