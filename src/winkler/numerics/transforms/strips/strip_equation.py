r"""The pressure on a strip of a layered body: a correction of the half-plane's pressure, in its modes.

Let a half-plane of the uppermost layer carry the pressure with the transform :math:`E^*G(k)` under some profile.  The
layers below move its surface by :math:`\frac2{\pi}\int_0^\infty\frac Mk\,\hat p\cos kx\,\mathrm dk/E^*` besides.  With
the correction :math:`\sum\beta_n p_n` of `winkler.numerics.transforms.strips.strip_modes`, and :math:`s_n = (-1)^n`,
the surface follows the profile if

.. math:: \beta_m + 4m\sum_n s_ms_nA_{mn}\beta_n = -4m\,s_m\int_0^\infty\frac Mk J_{2m}(ka)\,G\,\mathrm dk ,
          \qquad A_{mn} = \int_0^\infty\frac Mk J_{2m}J_{2n}\,\mathrm dk , \qquad m \ge 1 .

:math:`\beta_0` bears what a flat punch bears: it is the one with which the pressure vanishes at the edge,
:math:`\sum\beta_n=0`.  M is analytic and dies out like :math:`e^{-2kh}`, so that the modes converge geometrically, also
where the pressure of the half-plane is infinite at a tip or a kink.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import (
    DECAY_SPAN,
    NODES,
    WaveResponse,
    has_tail,
    in_own_lengths,
    on_axis,
    wave_numbers,
)
from winkler.numerics.transforms.strips.strip_modes import bessel_rows, far_sides, signs
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

FIRST_WAVE_NUMBER = 0.5
"""First panel of wave numbers, in units of 1 / span."""
LARGEST_PHASE = 12.0
"""Largest phase of a wave across the whole strip over one panel of the quadrature."""
LEAST_PHASE, PHASE_PER_MODE, LOCAL_PHASE = 400.0, 24.0, 8000.0
"""Largest wave number times length up to which waves are summed where M falls like 1 / xi: for modes, which meet their
average beyond several times their order, and for places."""
LEAST_ARGUMENT, WIDEST_ARGUMENT, FARTHEST = 2.0**-24, 16.0, 2.0**16
"""First and widest panel of arguments ka where M falls like 1 / xi, and the end of those whose average counts."""
LEAST_OCTAVE = -60
FEWEST_MODES, MOST_MODES = 20, 384
TAIL = 4
"""Modes at the end that must have vanished."""
VANISHED = 3e-14
"""The same, over the largest, on a layer as thick as the strip is wide: rounding grows with a / h."""
TAIL_IN_LOAD, TAIL_AT_EDGE = 1000.0, 2e-2
"""The same, times their number, where M falls like 1 / xi: over the precision of M, and of a flat punch."""
EDGE_TOLERANCE, LAST_EDGE_CHANGE, EDGES_PER_OCTAVE = 1e-6, 1e-3, 12
"""Of what flat punches bear at their edges, where M falls like 1 / xi: by how much twice as many modes change it, and
320 modes, which are left with a tenth of that; and half-widths at which it is found."""
LEAST_SHARE = 0.1
"""What the layers add need be no more precise than this part of the half-plane's load."""
ENTRIES_PER_BLOCK = 3_000_000


class Waves(NamedTuple):
    """Wave numbers [1/m] and quadrature weights times M / k.

    Parameters
    ----------
    k, weights : ndarray, (n,)
    shorter, shares : ndarray, (m,)
        The same of waves so short that products of two of them count by their average over the phase; none where M
        dies out like an exponential.
    """

    k: Array
    weights: Array
    shorter: Array
    shares: Array


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


class PunchModes(NamedTuple):
    """Flat punches of several half-widths.

    Parameters
    ----------
    settled
        Whether there were enough modes.
    edge
        Sum of the modes of a punch that bears a load of one ``(a,)``.
    adjoint
        What a wave of the half-plane's pressure, times M / k, adds to the load of a contact, times `edge` ``(a, k)``.
    """

    settled: bool
    edge: Array
    adjoint: Array


Equation = Callable[[int], tuple[Array, Array]]
"""A of the equation of several strips ``(a, m, n)``, and its right-hand side ``(a, n)``, of so many modes."""
Transforms = Callable[[Array, Array], Array]
"""G [m] of the half-plane's pressures under half-widths ``(a,)`` at wave numbers ``(k,)``: ``(a, k)``."""


class Strips(NamedTuple):
    """Strips whose equation is known.

    Parameters
    ----------
    half_width
        a [m] ``(a,)``.
    borne
        About what half-planes bear, a load over E* [m] ``(a,)``.
    equation
        Takes a number of modes.
    """

    half_width: Array
    borne: Array
    equation: Equation


class _HalfPlanes(NamedTuple):
    """Strips, what half-planes would bear under them, and by how much that grows with the half-width."""

    half_width: Array
    transforms: Transforms
    slopes: Array


@cached_by_value(64)
def waves(response: WaveResponse, octave: int) -> Waves:
    """Return the waves of a response for places and half-widths up to 2^octave of its own units of length [m]."""
    own, unit = in_own_lengths(response)
    found = _own_waves(own, octave)
    return Waves(found.k / unit, found.weights, found.shorter / unit, found.shares)


@cached_by_value(64)
def _own_waves(own: WaveResponse, octave: int) -> Waves:
    extent = own.smooth * 2.0**octave
    first, widest, last = FIRST_WAVE_NUMBER / own.span, LARGEST_PHASE / (2.0 * extent), DECAY_SPAN / own.length
    if not has_tail(own):
        k, weights = wave_numbers(first, widest, last)
        return Waves(k, weights * own.excess(k) / k, np.zeros(0), np.zeros(0))
    end = min(last, LOCAL_PHASE / extent)
    k, weights = wave_numbers(first, widest, end)
    whole = weights * excess_at(own, k) / k
    shorter, shares = (part[NODES:] for part in wave_numbers(0.5 * end, last, last))
    shares = shares * excess_at(own, shorter) * (1.0 - kept_share(shorter / end)) / shorter
    return Waves(k, whole * kept_share(k / end), shorter, shares)


def excess_at(response: WaveResponse, k: Array) -> Array:
    """Return M [-] at many real wave numbers ``(k,)`` [1/m]."""
    return on_axis(response, k) if has_tail(response) else response.excess(k)


def kept_share(ratio: Array) -> Array:
    """Return how much of a wave is summed, the rest is averaged: none at a ratio of one, all below a half."""
    from scipy.special import erfc

    return np.asarray(0.5 * erfc(16.0 * ratio - 12.0))


def octaves(response: WaveResponse, extent: Array, least: int = 0) -> Array:
    """Return the octaves of `waves` for extents [m], none below `least`; all where M falls like 1 / xi."""
    least = LEAST_OCTAVE if has_tail(response) else least
    return np.maximum(np.ceil(np.log2(np.maximum(extent / response.smooth, 1e-300))), least).astype(int)


def strip_responses(response: WaveResponse, half_width: Array, transforms: Transforms, slopes: Array) -> StripResponse:
    """Return corrections and flat punches of strips.

    Parameters
    ----------
    response : WaveResponse
    half_width : ndarray, (m,)
        a [m], positive.
    transforms
        The half-planes' pressures; they need not vanish at the edge.
    slopes : ndarray, (m,)
        By how much the loads of the half-planes over E* grow with the half-width [-].

    Raises
    ------
    NotConverged
        If 384 modes do not suffice: a sharp tip or kink on a layer hundreds of times thinner than the strip is wide.
    """
    groups = octaves(response, half_width, -1)
    parts: list[tuple[Array, Array, Array]] = []
    for octave in np.unique(groups):
        (members,) = np.nonzero(groups == octave)
        count = first_modes(int(octave))
        for some in chunks(members.size, _size(response, int(octave)) * count, ENTRIES_PER_BLOCK):
            chosen = members[some]
            pushed = _HalfPlanes(half_width[chosen], transforms, slopes[chosen])
            parts.append((chosen, *_settled(response, pushed, int(octave))))
    most = max((closing.shape[1] for _, closing, _ in parts), default=1)
    result = StripResponse(np.zeros((half_width.size, most)), np.zeros((half_width.size, most)))
    for chosen, closing, punch in parts:
        result.closing[chosen, : closing.shape[1]] = closing
        result.punch[chosen, : punch.shape[1]] = punch
    return result


def punch_edges(response: WaveResponse, half_width: Array) -> tuple[Array, Array]:
    """Return what flat punches that bear one bear at their edges where M falls like 1 / xi, and its slope [1/m].

    Raises
    ------
    NotConverged
        If 320 modes do not suffice for a part of 1e-4.
    """
    own, unit = in_own_lengths(response)
    cheb, groups, (edge, slope) = np.polynomial.chebyshev, octaves(response, half_width), np.empty((2, half_width.size))
    for octave in np.unique(groups):
        series, high = _edges_of(own, int(octave)), own.smooth * 2.0**octave
        place = 4.0 * half_width[groups == octave] / (unit * high) - 3.0
        edge[groups == octave] = cheb.chebval(place, series)
        slope[groups == octave] = 4.0 / (unit * high) * cheb.chebval(place, cheb.chebder(series))
    return edge, slope


@cached_by_value(64)
def _edges_of(own: WaveResponse, octave: int) -> Array:
    """Return the edges of punches of an octave of half-widths as a Chebyshev series.

    Modes fall like n^-3: of what is missing twice as many leave a fourth.
    """
    nodes = np.polynomial.chebyshev.chebpts1(EDGES_PER_OCTAVE)
    half_width = own.smooth * 2.0**octave * 0.25 * (3.0 + nodes)

    def nothing(a: Array, k: Array) -> Array:
        return np.zeros((a.size, k.size))

    def summed(count: int) -> Array:
        strips = _HalfPlanes(half_width, nothing, np.zeros(half_width.size))
        return np.asarray(np.sum(_solved(*_averaged(own, strips, count))[1], axis=1))

    count = 2 * FEWEST_MODES
    coarse, before = summed(count), np.full(half_width.size, np.inf)
    while 2 * count <= MOST_MODES:
        fine = summed(2 * count)
        found = fine + (fine - coarse) / 3.0
        change = float(np.max(np.abs(found / before - 1.0)))
        if change <= (EDGE_TOLERANCE if 4 * count <= MOST_MODES else LAST_EDGE_CHANGE):
            return np.asarray(np.polynomial.chebyshev.chebfit(nodes, found, EDGES_PER_OCTAVE - 1))
        count, coarse, before = 2 * count, fine, found
    raise NotConverged(
        f"The edges of a flat strip {2.0**octave:.3g} times as wide as the length over which moduli change are not "
        f"resolved by {count} modes: press less."
    )


def settled_strips(
    strips: Strips,
    count: int,
    rounding: float,
    most: int = MOST_MODES,
    falling: tuple[float, float] = (0.0, 0.0),
) -> StripResponse:
    """Return corrections and flat punches of strips, with as many modes as they need.

    Parameters
    ----------
    strips : Strips
    count : int
        Modes to begin with.
    rounding : float
        What the last modes may be, over the largest.
    most : int
        More modes are not tried, nor more than 384.
    falling : tuple of float
        The same times the number of modes, of corrections and of flat punches, where modes fall like powers.

    Raises
    ------
    NotConverged
        If so many modes do not suffice.
    """
    most = min(most, MOST_MODES)
    while True:
        closing, punch = _solved(*strips.equation(count))
        scale = np.maximum(np.max(np.abs(closing), axis=1), LEAST_SHARE * strips.borne)
        # modes fall geometrically, or like n^-5 and n^-3: then what is missing is about count / 2 last ones
        allowed, ends = (max(rounding, part / count) for part in falling)
        if _vanished(closing, allowed * scale) and _vanished(punch, ends * np.max(np.abs(punch), axis=1)):
            return StripResponse(closing, punch)
        if count >= most:
            raise NotConverged(
                f"The pressure on a strip of the half-width {float(np.max(strips.half_width)):.6g} m is not resolved "
                f"by {count} modes: the layer is too thin for it; round a sharp tip or kink off, press less, or give "
                "a thicker layer."
            )
        count = min(2 * count, most)


def first_modes(octave: int) -> int:
    """Return with how many modes an octave of half-widths is tried."""
    return FEWEST_MODES + 8 * max(octave, -1)


def punch_modes(found: Waves, half_width: Array, count: int, octave: int) -> PunchModes:
    """Return flat punches of half-widths [m] ``(a,)`` of an octave, with so many modes."""
    rows = _rows_at(found.k, half_width, count)
    coupled = (rows * found.weights) @ np.swapaxes(rows, 1, 2)
    fourfold = 4.0 * np.arange(1, count)
    matrix = np.eye(count - 1) + fourfold[:, None] * coupled[:, 1:, 1:]
    own = np.linalg.solve(matrix, -fourfold[:, None] * coupled[:, 1:, :1])[..., 0]
    punch = np.concatenate([np.ones((half_width.size, 1)), own], axis=1)
    adding = np.linalg.solve(np.swapaxes(matrix, 1, 2), np.ones((half_width.size, count - 1, 1)))[..., 0]
    allowed = VANISHED * 2.0 ** (0.5 * octave) * np.max(np.abs(punch), axis=1)
    adjoint = np.einsum("an,ank->ak", fourfold * adding, rows[:, 1:])
    return PunchModes(_vanished(punch, allowed), np.sum(punch, axis=1), adjoint)


def _size(response: WaveResponse, octave: int) -> int:
    return 1 if has_tail(response) else waves(response, octave).k.size


def _settled(response: WaveResponse, pushed: _HalfPlanes, octave: int) -> StripResponse:
    borne = np.abs(pushed.transforms(pushed.half_width, np.zeros(1))[:, 0])
    first, rounding = first_modes(octave), VANISHED * 2.0 ** (0.5 * octave)
    if has_tail(response):
        strips = Strips(pushed.half_width, borne, lambda count: _averaged(response, pushed, count))
        return settled_strips(strips, first, rounding, falling=(TAIL_IN_LOAD * response.precision, TAIL_AT_EDGE))
    found = waves(response, octave)
    pressed = pushed.transforms(pushed.half_width, found.k)

    def equation(count: int) -> tuple[Array, Array]:
        return summed(_rows_at(found.k, pushed.half_width, count), found.weights, pressed)

    return settled_strips(Strips(pushed.half_width, borne, equation), first, rounding)


def _vanished(modes: Array, allowed: Array) -> bool:
    return bool(np.all(np.max(np.abs(modes[:, -TAIL:]), axis=1) <= allowed))


class _Rows(NamedTuple):
    """Modes at arguments ka, with the weights of a quadrature over them: as they are, and averaged over the phase."""

    argument: Array
    weights: Array
    rows: Array
    far: Array
    shares: Array
    sides: Array
    closing: Array


@cached_by_value(8)
def _rows_of(count: int) -> _Rows:
    end = max(LEAST_PHASE, PHASE_PER_MODE * count)
    argument, weights = wave_numbers(LEAST_ARGUMENT, WIDEST_ARGUMENT, end)
    rows = signs(count)[:, None] * bessel_rows(argument, count)
    far, shares = (part[NODES:] for part in wave_numbers(0.5 * end, math.inf, FARTHEST * end))  # from half of the end
    sides = far_sides(far, 2.0 * np.arange(count))
    # the pressure of a half-plane that closes with the slope w' has there the waves w' J_1(ka) / k
    cosine, sine = far_sides(far, np.ones(1))[:, 0]
    return _Rows(
        argument,
        weights * kept_share(argument / end) / argument,
        rows,
        far,
        shares * (1.0 - kept_share(far / end)) / far,
        np.concatenate(list(sides), axis=1),
        np.concatenate([sine, -cosine]) / np.concatenate([far, far]),
    )


def _averaged(response: WaveResponse, pushed: _HalfPlanes, count: int) -> tuple[Array, Array]:
    """Return A and the right-hand side of the equation where M falls like 1 / xi: by modes at the same arguments ka."""
    table = _rows_of(count)
    coupled, pressed = np.empty((pushed.half_width.size, count, count)), np.empty((pushed.half_width.size, count))
    for place, a in enumerate(pushed.half_width):
        k = table.argument / a
        weighted = table.rows * (table.weights * excess_at(response, k))
        far = table.shares * excess_at(response, table.far / a)
        averaged = table.sides * np.concatenate([far, far])
        coupled[place] = weighted @ table.rows.T + averaged @ table.sides.T
        pressed[place] = weighted @ pushed.transforms(np.array([a]), k)[0]
        pressed[place] += (a * pushed.slopes[place]) * (averaged @ table.closing)
    return coupled, pressed


def summed(rows: Array, weights: Array, transforms: Array) -> tuple[Array, Array]:
    """Return the same as a sum over waves, where M dies out like an exponential.

    Parameters
    ----------
    rows : ndarray, (a, n, k)
        Transforms of modes, with their signs s_n.
    weights : ndarray, (k,)
        Of the sum, times M / k.
    transforms : ndarray, (a, k)
        G [m] of the half-planes' pressures.
    """
    weighted = rows * weights
    return weighted @ np.swapaxes(rows, 1, 2), np.einsum("ank,ak->an", weighted, transforms)


def _rows_at(k: Array, half_width: Array, count: int) -> Array:
    """Return s_n J_2n(ka) ``(a, n, k)``."""
    rows = np.moveaxis(bessel_rows(half_width[:, None] * k, count), 0, 1)
    rows *= signs(count)[:, None]
    return rows


def _solved(coupled: Array, pressed: Array) -> tuple[Array, Array]:
    size, count = pressed.shape
    fourfold = 4.0 * np.arange(1, count)
    matrix = np.eye(count - 1) + fourfold[:, None] * coupled[:, 1:, 1:]
    right = -fourfold[:, None] * np.stack([pressed[:, 1:], coupled[:, 1:, 0]], axis=2)
    own = np.linalg.solve(matrix, right)
    punch = np.concatenate([np.ones((size, 1)), own[..., 1]], axis=1)
    free = np.concatenate([np.zeros((size, 1)), own[..., 0]], axis=1)
    edge = np.sum(free, axis=1) / np.sum(punch, axis=1)
    return free - edge[:, None] * punch, punch
