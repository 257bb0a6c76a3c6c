r"""Gauss panels along a line whose functions have roots, kinks and logarithms at known places.

Between two kinks s < s' the variable is :math:`y=\sqrt{x^2-s^2}`: what rises like a square root above s is smooth in y,
and a logarithm or a pole at x = 0 is met by panels that double their length with the distance from it.  Values at the
nodes stand for the polynomial through them, panel by panel: it is evaluated, and integrated up to any place.
"""

from __future__ import annotations

import bisect
import functools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, Curve

NODES_PER_PANEL = 16
"""Nodes of each panel."""
HALVINGS = 24
"""How often the panels halve towards x = 0."""
MOST_HALVINGS = 10
"""How often a panel on which the given function is not smooth is halved."""
RESOLUTION_TOLERANCE = 1e-11
"""Part of the largest value that the last coefficients of a panel may have."""

HIT = 1e-40
"""Distance for which a place that is a node is taken: there the function is the value of the node."""

Indices = NDArray[np.intp]
LOCAL_NODES = 2.0 * gauss_legendre(NODES_PER_PANEL)[0] - 1.0
WEIGHTS = gauss_legendre(NODES_PER_PANEL)[1]
TO_COEFFICIENTS: Array = np.linalg.inv(np.polynomial.legendre.legvander(LOCAL_NODES, NODES_PER_PANEL - 1))
_APART = LOCAL_NODES[:, None] - LOCAL_NODES + np.eye(NODES_PER_PANEL)
BARYCENTRIC: Array = (-1.0) ** np.arange(NODES_PER_PANEL) / np.abs(np.prod(_APART, axis=1))
"""Weights of the polynomial through the nodes in its second barycentric form."""
DERIVATIVE: Array = np.pad(np.polynomial.legendre.legder(np.eye(NODES_PER_PANEL)).T, ((0, 0), (0, 1)))
"""Coefficients of the derivative, from the left."""
CLENSHAW = [(n, (2 * n + 1) / (n + 1), (n + 1) / (n + 2)) for n in range(NODES_PER_PANEL - 1, 0, -1)]
"""Number of a coefficient and factors of Clenshaw's recurrence for Legendre's polynomials, in turn."""


class Stretches:
    """Panels with `NODES_PER_PANEL` nodes each.

    Parameters
    ----------
    base, low, high : ndarray, (panels,)
        s, and the ends of the panel in y [m].
    """

    def __init__(self, base: Array, low: Array, high: Array) -> None:
        self.base, self.low, self.high = base, low, high
        self.half = 0.5 * (high - low)
        y = 0.5 * (low + high)[:, None] + self.half[:, None] * LOCAL_NODES
        self.nodes: Array = np.hypot(base[:, None], y)
        self.stretch: Array = y / self.nodes
        """dx/dy at the nodes."""
        self.weights: Array = 2.0 * self.half[:, None] * WEIGHTS * self.stretch
        """Of an integral over x."""
        self.edges: Array = np.append(np.hypot(base, low), np.hypot(base[-1], high[-1]))
        """Ends of the panels [m], ``(panels + 1,)``."""
        self._inner = self.edges[1:-1]

    def panel(self, x: Array) -> Indices:
        """Return the panel in which each x lies."""
        return np.asarray(self._inner.searchsorted(x, side="right"))

    def _local(self, x: Array, panel: Indices) -> Array:
        base = self.base[panel]
        y = np.sqrt(np.maximum((x - base) * (x + base), 0.0))
        return np.asarray(np.minimum(np.maximum((y - self.low[panel]) / self.half[panel] - 1.0, -1.0), 1.0))

    def reading(self, x: Array, panel: Indices) -> Array:
        """Return weights ``(..., COUNT)`` that read a function at x in these panels from its values at the nodes."""
        return _read_at(self._local(x, panel))

    def value(self, values: Array, x: Array) -> Array:
        """Return, at places x, a function given at the nodes ``(panels, COUNT)``."""
        panel = self.panel(x)
        return np.asarray(np.sum(self.reading(x, panel) * values[panel], axis=-1))

    def at(self, values: Array, place: float) -> Array:
        """Return, at one place, a function given at the nodes ``(..., panels, COUNT)``: ``(...)``."""
        panel, weights = self._weights_at(place)
        return np.asarray(values[..., panel, :] @ weights)

    @functools.lru_cache(maxsize=64)  # noqa: B019 - as `sample`
    def _weights_at(self, place: float) -> tuple[int, Array]:
        at = np.array([place])
        panel = self.panel(at)
        return int(panel[0]), self.reading(at, panel)[0]

    def reader(self, values: Array) -> Callable[[float], float]:
        """Return a function given at the nodes ``(panels, COUNT)``, for one place at a time."""
        fits: dict[int, list[float]] = {}
        edges, last, ends = self._numbers

        def value(x: float) -> float:
            k = min(max(bisect.bisect_right(edges, x) - 1, 0), last)
            if k not in fits:
                fits[k] = (TO_COEFFICIENTS @ values[k]).tolist()
            (s, low, half), fit = ends[k], fits[k]
            at = (math.sqrt(max((x - s) * (x + s), 0.0)) - low) / half - 1.0
            at, after, total = min(max(at, -1.0), 1.0), 0.0, 0.0
            for n, ahead, back in CLENSHAW:
                total, after = fit[n] + ahead * at * total - back * after, total
            return fit[0] + at * total - 0.5 * after

        return value

    @functools.cached_property
    def _numbers(self) -> tuple[list[float], int, list[list[float]]]:
        """Ends of the panels, the number of the last, and base, lower end and half width of each."""
        return self.edges.tolist(), self.base.size - 1, np.stack([self.base, self.low, self.half], axis=1).tolist()

    def slope(self, values: Array, x: Array) -> Array:
        """Return the derivative by x, at places x > 0, of a function given at the nodes ``(panels, COUNT)``."""
        panel = self.panel(x)
        fits = (values @ TO_COEFFICIENTS.T)[panel]
        steep = np.einsum("...k,kj->...j", fits, DERIVATIVE)
        rise = np.sum(np.polynomial.legendre.legvander(self._local(x, panel), NODES_PER_PANEL - 1) * steep, axis=-1)
        y = np.sqrt(np.maximum((x - self.base[panel]) * (x + self.base[panel]), 0.0))
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(rise / self.half[panel] * (x / y))

    def part(self, x: Array, panel: Indices) -> Array:
        """Return weights ``(..., COUNT)`` of the integral over y from the lower end of the panel to x."""
        far = self._local(x, panel) + 1.0
        rises = far[..., None] * (WEIGHTS @ _read_at(0.5 * (LOCAL_NODES + 1.0) * far[..., None] - 1.0))
        return np.asarray(rises * self.half[panel][..., None])

    def integral(self, values: Array, ends: Array) -> Array:
        """Return the integrals over x from zero to `ends` of a function given at the nodes ``(panels, COUNT)``."""
        up_to = self.antiderivative(values)
        return np.reshape([up_to(end) for end in np.asarray(ends).ravel().tolist()], np.shape(ends))

    def antiderivative(self, values: Array) -> Callable[[float], float]:
        """Return the integral over x from zero on of a function given at the nodes, for one end at a time."""
        whole = [0.0, *np.cumsum((self.weights * values).sum(1)).tolist()]

        @functools.cache
        def up_to(end: float) -> float:
            panel, part = self._up_to(end)
            return float(whole[panel] + part @ values[panel])

        return up_to

    @functools.lru_cache(maxsize=64)  # noqa: B019 - as `sample`
    def _up_to(self, end: float) -> tuple[int, Array]:
        """Return the panel of a place, and weights ``(COUNT,)`` of the integral over x from its lower end on."""
        place = np.array([end])
        panel = self.panel(place)
        return int(panel[0]), self.part(place, panel)[0] * self.stretch[panel[0]]

    @functools.lru_cache(maxsize=64)  # noqa: B019 - stretches are few, and kept by what is cached by value
    def sample(self, low: float, high: float) -> Sample:
        """Return places between `low` and `high`, `NODES_PER_PANEL` in every panel that lies there or partly there."""
        ends = np.array([low, high])
        first, last = self.panel(ends).tolist()
        if last > first and high <= self.edges[last]:
            last -= 1
        rows = np.arange(first, last + 1)
        x, weights = self.nodes[rows], self.weights[rows]
        readings: list[tuple[int, Array]] = []
        for row in sorted({first, last}):
            left, right = max(low, float(self.edges[row])), min(high, float(self.edges[row + 1]))
            if left > self.edges[row] or right < self.edges[row + 1]:
                s = float(self.base[row])
                start, end = (math.sqrt(max((place - s) * (place + s), 0.0)) for place in (left, right))
                y = 0.5 * (start + end) + 0.5 * (end - start) * LOCAL_NODES
                x[row - first] = np.hypot(s, y)
                weights[row - first] = (end - start) * WEIGHTS * y / x[row - first]
                readings.append((row - first, self.reading(x[row - first], np.full(NODES_PER_PANEL, row))))
        return Sample(x, weights, first, tuple(readings))


def _read_at(at: Array) -> Array:
    """Return weights ``(..., COUNT)`` of the values at the nodes, at places from -1 to 1 of a panel."""
    away = at[..., None] - LOCAL_NODES
    if not away.all():
        away = np.where(away == 0.0, HIT, away)
    parts = BARYCENTRIC / away
    return np.asarray(parts / parts.sum(-1, keepdims=True))


class Sample(NamedTuple):
    """Places x and weights ``(pieces, COUNT)`` of an integral over a part of the panels."""

    x: Array
    weights: Array
    first: int
    readings: tuple[tuple[int, Array], ...]

    def read(self, values: Array) -> Array:
        """Return, at these places, the function, or each of several, that has these values at the nodes."""
        result = values[..., self.first : self.first + self.x.shape[0], :].copy()
        for row, reading in self.readings:
            result[..., row, :] = values[..., self.first + row, :] @ reading.T
        return result


def stretches(
    function: Curve,
    kinks: Sequence[float],
    end: float,
    widest: float = math.inf,
    precision: float = 0.0,
    halvings: int = HALVINGS,
) -> Stretches:
    """Return panels from zero to `end` on which function(x) dx/dy is a polynomial as far as rounding lets it be.

    Parameters
    ----------
    function
        Smooth in y between the kinks.
    kinks : sequence of float
        Where the function is not smooth [m].
    end : float
        [m], positive.
    widest : float
        Width [m] beyond which a panel is halved.
    precision : float
        How smooth the function is, relative to its largest value.
    halvings : int
        How often panels halve towards x = 0.
    """
    starts = [0.0, *sorted({b for b in kinks if 0.0 < b < end})]
    panels = [
        (s, *part)
        for s, top in zip(starts, [*starts[1:], end], strict=True)
        for low, high in _graded(s, top, halvings)
        for part in _parted(s, low, high, widest)
    ]
    done: list[tuple[float, float, float]] = []
    for _ in range(MOST_HALVINGS):
        if not panels:
            break
        tried = Stretches(*np.array(panels).T)
        values = function(tried.nodes) * tried.stretch
        tails = np.abs(values @ TO_COEFFICIENTS[-2:].T).max(axis=1)
        scale = float(np.max(np.abs(values)))
        good = (tails <= max(RESOLUTION_TOLERANCE, precision) * scale) | (tried.low + tried.base == 0.0)
        done += [panel for panel, fine in zip(panels, good, strict=True) if fine]
        middles = 0.5 * (tried.low + tried.high)
        panels = [
            half
            for (s, low, high), middle, fine in zip(panels, middles, good, strict=True)
            if not fine
            for half in ((s, low, float(middle)), (s, float(middle), high))
        ]
    return Stretches(*np.array(sorted(done + panels)).T)


def _parted(s: float, low: float, high: float, widest: float) -> list[tuple[float, float]]:
    """Return a panel, in y, in equal parts that are narrow enough."""
    count = max(1, math.ceil((math.hypot(s, high) - math.hypot(s, low)) / widest))
    cuts = [low + (high - low) * part / count for part in range(count)] + [high]
    return list(zip(cuts[:-1], cuts[1:], strict=True))


def _graded(s: float, top: float, halvings: int) -> list[tuple[float, float]]:
    """Return the ends in y of the panels between two kinks."""
    if s == 0.0:
        cuts = [0.0, *(top * 0.5**k for k in range(halvings, 0, -1)), top]
    else:
        most = math.sqrt((top - s) * (top + s))
        cuts = [0.0, *(0.5 * s * 2.0**k for k in range(HALVINGS) if 0.5 * s * 2.0**k < 0.75 * most), most]
    return list(zip(cuts[:-1], cuts[1:], strict=True))
