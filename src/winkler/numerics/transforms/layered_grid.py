r"""The transforms of worn contacts on layers, on a grid: those of a homogeneous body, and what layers add to them.

A body whose transform on a homogeneous half-space is h has the springs' profile
:math:`g(x)\,\varphi(x;x) = h(x)-\int_0^x\rho(t;x)\,h(t)\,\mathrm dt`, and springs displaced by v press as those of a
homogeneous half-space do that are displaced by

.. math:: q(x) = \varphi(x;x)\,v_+(x) - \int_x^\infty\rho(x;t)\,\varphi(t;t)\,v_+(t)\,\mathrm dt

(`winkler.numerics.transforms.fredholm`; of strips
`winkler.numerics.transforms.strips.strip_punches`, with x/t beside h).
Both integrals are sums over Gauss points of functions that are straight in :math:`y=x^2` between nodes, times the exact
kernel; everything else is what the transforms of a homogeneous half-space do with h and q.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.grid_transforms import Cuts, GridTransforms
from winkler.numerics.types import Array

__all__ = ["LayeredGrid"]

FEWEST_POINTS, MOST_POINTS = 3, 48
"""Gauss points of a cell."""
POINTS_PER_LENGTH = 3.0
"""How many of them for each length over which the kernel changes."""


class LayeredGrid(GridTransforms):
    """Matrices of the transforms on one grid; subclasses state the kernels.

    Parameters
    ----------
    plain : GridTransforms
        Those of a homogeneous half-space.
    response : WaveResponse
        Of the medium, to a pressure or to shear.
    """

    fewest: int = FEWEST_POINTS
    """Gauss points of a narrow cell."""

    def __init__(self, plain: GridTransforms, response: WaveResponse) -> None:
        nodes = plain.nodes
        super().__init__(nodes)
        self.plain, self.in_the_middle = plain, plain.in_the_middle
        self.borders, self.areas = plain.borders, plain.areas
        self.edge = self.edges(response, nodes)
        points, weights = self._points(response)
        inner = self.held(response, points, nodes) * weights
        held = self._by_hats(inner, points)
        self.held_away: Array = np.eye(nodes.size) - held
        """What takes a transform h to phi(x; x) g(x), lower triangular ``(n, n)``."""
        self.gap = (plain.gap - held @ plain.gap) / self.edge[:, None]
        outer = self.spread(response, nodes, points) * (self.edges(response, points) * weights)
        self._spread = self._by_hats(outer, points)
        widths = np.diff(nodes)
        self._near, self._held_near = (
            each.reshape(nodes.size, widths.size, -1).sum(axis=2) / widths for each in (outer, inner)
        )
        self.own: Array = np.diag(self.edge) - self._spread
        """What takes springs to those that press alike without layers, upper triangular ``(n, n)``."""
        self.outside, self.force = plain.outside @ self.own, plain.force @ self.own
        self.rim_load = self.edge[-1] * plain.rim_load

    def edges(self, response: WaveResponse, x: Array) -> Array:
        """Return phi(x; x) [-] at places [m]."""
        raise NotImplementedError

    def held(self, response: WaveResponse, inner: Array, x: Array) -> Array:
        """Return what a transform at inner places ``(m,)`` takes from those at x ``(n,)``, [1/m] ``(n, m)``."""
        raise NotImplementedError

    def spread(self, response: WaveResponse, x: Array, outer: Array) -> Array:
        """Return rho(x; t) [1/m] of places x ``(n,)`` and outer ones t ``(m,)``, ``(n, m)``."""
        raise NotImplementedError

    def rule(self, response: WaveResponse, count: int) -> tuple[Array, Array]:
        """Return so many places of a cell from 0 to 1, and their weights."""
        return gauss_legendre(count)

    def _points(self, response: WaveResponse) -> tuple[Array, Array]:
        """Return Gauss points of all cells, ascending, and their weights [m]."""
        widths = np.diff(self.nodes)
        wanted = math.ceil(POINTS_PER_LENGTH * float(np.max(widths)) / response.smooth)
        places, weights = self.rule(response, min(max(wanted, self.fewest), MOST_POINTS))
        return (self.nodes[:-1, None] + widths[:, None] * places).ravel(), (widths[:, None] * weights).ravel()

    def _by_hats(self, samples: Array, points: Array) -> Array:
        """Return sums of samples ``(n, points)`` times functions that are one at one node and zero at all others."""
        cells = self.nodes.size - 1
        later = (points.reshape(cells, -1) ** 2 - self.squares[:-1, None]) / self.widths[:, None]
        by_cell = samples.reshape(self.nodes.size, cells, -1)
        matrix = np.zeros((self.nodes.size, self.nodes.size))
        matrix[:, :-1] += np.sum(by_cell * (1.0 - later), axis=2)
        matrix[:, 1:] += np.sum(by_cell * later, axis=2)
        return matrix

    def _alike(self, values: Array, cut: Cuts) -> tuple[Array, Cuts, Array]:
        """Return the springs without layers that press alike: those of which the positive part counts, and the rest."""
        rest = self._spread @ np.maximum(values, 0.0) + self.missed_load(cut)
        scaled = self.edge * values
        scaled_cut = Cuts(self.squares, scaled)
        # the rest stands still where no spring is pressed, and reaches beyond no edge
        rise, wide = np.diff(rest)[scaled_cut.cells], scaled_cut.last - scaled_cut.first
        scaled_cut.slope = scaled_cut.slope - np.divide(rise, wide, out=np.zeros(wide.size), where=wide > 0.0)
        scaled_cut.cut_slope = scaled_cut.cut_slope - rise / (scaled_cut.stop - scaled_cut.start)
        return scaled, scaled_cut, rest

    def line_load(self, values: Array, cut: Cuts) -> Array:
        """Return q [m] at the nodes: the springs without layers that press as springs values+ do on them."""
        return np.asarray(self.own @ np.maximum(values, 0.0) - self.missed_load(cut))

    def missed_load(self, cut: Cuts) -> Array:
        """Return what springs outside give each other in cells of a cut [m], beyond what nodes alone do."""
        return np.asarray(self._near[:, cut.cells] @ self.plain.missed(cut))

    def missed_hold(self, cut: Cuts) -> Array:
        """Return what a transform gives those farther out in cells of a cut [m], beyond what nodes alone do."""
        return np.asarray(self._held_near[:, cut.cells] @ self.plain.missed(cut))

    def borne(self, values: Array, cut: Cuts) -> Array:
        """As `GridTransforms.borne`, over E* of the uppermost layer."""
        scaled, scaled_cut, rest = self._alike(values, cut)
        beyond = np.append(self.plain.outside @ rest, 0.0)
        return np.asarray(self.plain.borne(scaled, scaled_cut) + np.diff(beyond) / self.areas)

    def integral(self, values: Array, cut: Cuts) -> float:
        """As `GridTransforms.integral`, as the pressures have it."""
        scaled, scaled_cut, rest = self._alike(values, cut)
        return self.plain.integral(scaled, scaled_cut) - float(self.plain.force @ rest)

    def means(self, squares: Array, values: Array) -> Array:
        """As `GridTransforms.means`: nothing of a volume is lost."""
        return self.plain.means(squares, values)
