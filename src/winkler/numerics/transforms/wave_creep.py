r"""Creep of a surface that differs from wave to wave: sums of exponentials with common times.

A load that varies like :math:`\cos\xi x` and is put on at once sinks by

.. math:: c(\xi,t) = c_0(\xi) + \sum_m c_m(\xi)\,\big(1-e^{-t/\lambda_m}\big) .

The true retardation times depend on :math:`\xi`, but lie between the shortest relaxation time and the longest
retardation time of the solids.  :math:`e^{-t/\lambda}` is an analytic function of :math:`\ln\lambda`: times spaced
evenly in the logarithm stand for all those between them, with an error that falls exponentially with their spacing.
The :math:`c_m` of one wave may have any sign.  They are a linear fit to the compliance at imaginary frequencies, the
same for all waves.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from winkler.numerics.integrals.quadrature import gauss_legendre, growing, panel_nodes
from winkler.numerics.panels.chebyshev import fit_nodes, panels_from
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.transforms.cosine_transform import wave_numbers
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import NotConverged

SPACING = 0.3
"""Of the logarithms of the times."""
MARGIN = 4
"""Times beyond the shortest and the longest one."""
FREQUENCIES_PER_TIME = 4
REACH_OF_FREQUENCIES = 50.0
"""Frequencies go up to this many over the shortest time, and down to one over so many of the longest."""
LIMIT_WEIGHT = 100.0
"""Of what is left after all time, against that of one frequency."""
CUTOFF = 1e-10
"""Singular values below this part of the largest one are left out of the fit."""
LARGEST_ERROR = 1e-5
"""A fit that is wrong by more than this part is refused."""
NODES = 16
"""Gauss-Legendre nodes on a panel of wave numbers."""
TURNS = 16
"""Of the shortest wave that cells resolve, up to which waves are summed one by one."""
FOURTH_POWER = np.array([1.0, -4.0, 6.0, -4.0, 1.0]) / 16.0
"""Of cos((j + k) x), k = -2 to 2, in sin^4(x/2) cos(j x)."""
FAR = 16
"""Distance of two hats from which on their moments give the mean of a logarithm, to 1e-13."""
FAR_LOGARITHM = np.array([1.0 / 6.0, 3.0 / 40.0, 17.0 / 252.0, 31.0 / 360.0])
"""Moments of the distance of places under two hats, over the power of each."""
SLOPE_STEP = 1e-3
"""Of a difference quotient, relative."""
CHECKED_WAVES = 5
"""Every fifth wave is checked."""

Compliance = Callable[[ComplexArray, Array], ComplexArray]
"""c(s, xi) [1/Pa], ``(S, m)``, of s [1/s] ``(S,)`` on the imaginary axis, from 0 to i inf, and xi [1/m] ``(m,)``."""


class WaveCreep(NamedTuple):
    """The coefficients of all waves.

    Parameters
    ----------
    times : ndarray, (M,)
        lambda_m [s], ascending.
    local : ndarray, (1 + M,)
        c_0, c_1, ... of the shortest waves [1/Pa].
    edges : ndarray, (panels + 1,)
        Of panels of wave numbers [1/m].
    series : ndarray, (degree + 1, panels, 1 + M)
        What is added to each of them, in Chebyshev polynomials on every panel; zero beyond the last edge.
    error : float
        Greatest error of c, relative to c of that wave and frequency, between the frequencies of the fit [-].
    """

    times: Array
    local: Array
    edges: Array
    series: Array
    error: float

    def plus(self, creep: CreepSeries) -> WaveCreep:
        """Return the creep of a pair whose second body is a half-space, which sinks alike under all waves."""
        times = np.concatenate([self.times, creep.times])
        order = np.append(0, 1 + np.argsort(times, kind="stable"))
        local = np.append(self.local, creep.compliances)[order]
        local[0] += creep.glassy
        series = np.pad(self.series, ((0, 0), (0, 0), (0, creep.times.size)))
        return self._replace(times=np.sort(times), local=local, series=np.ascontiguousarray(series[:, :, order]))

    def kernels(self, count: int, width: float) -> Array:
        """Return how the load of a hat moves hats at distances 0, width, ..., ``(1 + M, 2 count)``.

        A hat is one in its middle and zero one width [m] away: the double integral of c with two hats [m/Pa].
        """
        total = self._summed(np.arange(2 * count), count, width, self._varying)
        total[:, 0] += self.local * (2.0 / 3.0 * width)
        total[:, 1] += self.local * (width / 6.0)
        return total

    def strip_kernels(self, count: int, width: float) -> Array:
        """Return how hats of pressure move a plane surface, as `kernels` do a line load [m^2/Pa].

        Each moves it more than at a distance of 2 count widths from its middle: a wave of pressure sinks by 2 c / xi,
        which has no bound as xi falls.
        """
        along = np.arange(2 * count + 1)
        total = self._summed(along, count, width, lambda xi: self._varying(xi) * (2.0 / xi))
        total -= np.outer(self.local, width**2 * (2.0 / math.pi) * _logarithms(along))
        return np.asarray(total[:, :-1] - total[:, -1:])

    def _summed(self, along: Array, count: int, width: float, varying: Callable[[Array], Array]) -> Array:
        """Return the integral of what varies with the waves at distances `along` in widths."""
        lowest, last = float(self.edges[1]), float(self.edges[-1])
        stride = 2.0 * math.pi / (4 * count * width)
        start, total = 0.0, np.zeros((self.local.size, along.size))
        if lowest < stride:  # else the waves do not vary over the first steps
            start = min(lowest * 2.0 ** math.ceil(math.log2(stride / lowest)), last)
            xi, weights = wave_numbers(lowest, start, start)
            total += _weighted(varying(xi), xi, weights, width) @ np.cos(np.outer(xi, width * along))
        # from there on panels of one width, which all cells at their distances meet in steps of a whole turn's part
        end = min(last, start + TURNS * 4 * count * stride)
        panels = math.ceil((end - start) / stride)
        for node, weight in zip(*gauss_legendre(NODES), strict=True):
            first = start + node * stride
            xi = first + stride * np.arange(panels)
            parts = _weighted(varying(xi), xi, np.where(xi < end, weight * stride, 0.0), width)
            folded = np.zeros((self.local.size, math.ceil(panels / (4 * count)) * 4 * count))
            folded[:, :panels] = parts
            summed = np.fft.fft(folded.reshape(self.local.size, -1, 4 * count).sum(axis=1), axis=1)
            turned = np.conj(summed[:, : along.size]) * np.exp(1j * first * width * along)
            total += turned.real
        if end < last:
            total += self._beyond(end, along, width, varying)
        return total

    def _beyond(self, end: float, along: Array, width: float, varying: Callable[[Array], Array]) -> Array:
        r"""Return what waves from xi = end on add, far shorter than the cells, ``(1 + M, distances)``.

        What multiplies :math:`\sin^4\tfrac x2\cos jx`, :math:`x=\xi h`, hardly changes over a turn: its mean is
        integrated, and of each wave :math:`\cos kx` two terms of the integration by parts are left.
        """

        def envelope(xi: Array) -> Array:
            return varying(xi) * (width**2 / math.pi * (2.0 / (xi * width)) ** 4)

        xi, weights = panel_nodes(np.append(end, self.edges[self.edges > end]), NODES)
        mean = envelope(xi) @ weights
        near = end * np.array([1.0 - SLOPE_STEP, 1.0, 1.0 + SLOPE_STEP])
        below, at, above = envelope(near).T
        turns = np.abs(along[:, None] + np.arange(-2, 3))
        some = np.maximum(turns, 1)
        shares = np.where(turns > 0, FOURTH_POWER, 0.0)
        sines, cosines = shares * np.sin(turns * end * width) / some, shares * np.cos(turns * end * width) / some**2
        return np.asarray(
            np.outer(mean, np.sum(FOURTH_POWER - shares, axis=1))
            - np.outer(at / width, np.sum(sines, axis=1))
            - np.outer((above - below) / (2.0 * SLOPE_STEP * end * width**2), np.sum(cosines, axis=1))
        )

    def after(self, xi: Array, time: Array) -> Array:
        """Return c(xi, t) [1/Pa] of waves [1/m] ``(m,)`` after times [s] ``(T,)``, ``(m, T)``."""
        parts = self.local[:, None] + np.where(xi < self.edges[-1], self._varying(np.minimum(xi, self.edges[-1])), 0.0)
        return np.asarray(parts[0][:, None] - parts[1:].T @ np.expm1(-time / self.times[:, None]))

    def _varying(self, xi: Array) -> Array:
        """Return what is added to the coefficients of the shortest waves, ``(1 + M, m)``."""
        panel = np.clip(np.searchsorted(self.edges, xi, side="right") - 1, 0, self.edges.size - 2)
        found = np.empty((self.local.size, xi.size))
        starts = np.flatnonzero(np.diff(panel, prepend=-1)).tolist()
        for start, end in itertools.pairwise([*starts, xi.size]):
            one = int(panel[start])
            low, high = self.edges[one : one + 2]
            terms = chebvander((2.0 * xi[start:end] - low - high) / (high - low), self.series.shape[0] - 1)
            np.matmul(self.series[:, one].T, terms.T, out=found[:, start:end])
        return found


def _weighted(varying: Array, xi: Array, weights: Array, width: float) -> Array:
    """Return coefficients times the weights and the square of the transform of a hat."""
    return varying * (weights / math.pi * width**2 * np.sinc(0.5 * xi * width / math.pi) ** 4)


def _logarithms(distance: Array) -> Array:
    """Return the mean of ln|x| between two hats of a width of one, whole numbers ``(n,)`` apart."""

    def risen(x: Array) -> Array:  # four times integrated
        return x**4 * (np.log(np.maximum(np.abs(x), 1e-9)) - 25.0 / 12.0) / 24.0

    steps = distance[:, None] + np.arange(-2.0, 3.0)
    near = risen(steps[:FAR]) @ (16.0 * FOURTH_POWER)
    square = np.maximum(distance[FAR:], 1.0) ** -2.0
    far = -0.5 * np.log(square) - square * np.polynomial.polynomial.polyval(square, FAR_LOGARITHM)
    return np.concatenate([near, far])


def fit_wave_creep(
    compliance: Compliance,
    share: Callable[[ComplexArray], Array],
    times: tuple[float, float],
    waves: tuple[float, float],
) -> WaveCreep:
    """Fit the creep of all waves.

    Parameters
    ----------
    compliance : callable
        c(s, xi) of the surface; infinite xi of the shortest waves.
    share : callable
        The smallest |J(s)| / J(0) of the solids, ``(S,)``: in proportion to it errors are weighed.
    times : (float, float)
        Between which the retardation times lie [s].
    waves : (float, float)
        c is a power series in xi below the first [1/m], and its limit from the second on.

    Raises
    ------
    NotConverged
        If the error is larger than 1e-5.
    """
    low, high = math.log(times[0]) - MARGIN * SPACING, math.log(times[1]) + MARGIN * SPACING
    kept = np.exp(np.linspace(low, high, math.ceil((high - low) / SPACING) + 1))
    ends = 1.0 / (REACH_OF_FREQUENCIES * kept[-1]), REACH_OF_FREQUENCIES / kept[0]
    grid = np.geomspace(*ends, 2 * FREQUENCIES_PER_TIME * kept.size + 1)
    fitted, checked = np.append(0.0, grid[::2]), grid[1::2]
    edges = np.array([0.0, *growing(waves[0], 2.0 * waves[1], 2.0)])
    nodes = fit_nodes(edges)
    xi = np.append(nodes.ravel(), np.inf)

    at_once = np.real(compliance(np.array([1j * np.inf]), xi)[0])
    weights = 1.0 / share(1j * fitted)
    weights[0] *= LIMIT_WEIGHT
    rows, wanted = _terms(fitted, kept), compliance(1j * fitted, xi) - at_once
    both = np.concatenate([weights, weights])[:, None]
    weighted = both * np.concatenate([rows.real, rows.imag])
    size = np.linalg.norm(weighted, axis=0)
    inverse = np.linalg.pinv(weighted / size, rcond=CUTOFF) / size[:, None]
    aim = both * np.concatenate([wanted.real, wanted.imag])
    found = inverse @ aim
    found += inverse @ (aim - weighted @ found)  # what rounding has taken where weights differ by decades

    part = slice(None, None, CHECKED_WAVES)
    true = compliance(1j * checked, xi[part])
    error = float(np.max(np.abs((at_once + _terms(checked, kept) @ found)[:, part] - true) / np.abs(true)))
    if not error <= LARGEST_ERROR:
        raise NotConverged(
            f"The creep of the layers is not a sum of exponentials to better than {error:.1e}, {LARGEST_ERROR:.0e} are "
            "needed; give solids whose moduli differ less between short and long times."
        )
    every = np.concatenate([at_once[None], found])
    varying = (every[:, :-1] - every[:, -1:]).reshape(-1, *nodes.shape)
    series = np.stack([panels_from(edges, part).coefficients for part in varying])
    return WaveCreep(kept, every[:, -1], edges, np.ascontiguousarray(series.transpose(2, 1, 0)), error)


def _terms(frequency: Array, times: Array) -> ComplexArray:
    """Return 1 / (1 + i omega lambda), ``(S, M)``."""
    return np.asarray(1.0 / (1.0 + 1j * frequency[:, None] * times))
