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

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms.cosine_transform import WaveResponse, has_tail
from winkler.numerics.transforms.grid_transforms import CutCell, GridTransforms, cuts_of
from winkler.numerics.types import Array

FEWEST_POINTS, MORE_POINTS, MOST_POINTS = 3, 12, 96
"""Gauss points of a cell; more of them in the middle, and where the kernel has a logarithm at the ends of a cell."""
MIDDLE, POINTS_IN_THE_MIDDLE = 2.0, 48.0
"""Cells that begin within so many lengths over which the kernel changes have so many points a length: the node in the
middle feels all of the fall of phi(x; x), and an error there is a peak of the pressure."""
POINTS_PER_LENGTH = 3.0
"""How many of them for each length over which the kernel changes."""


def _cell_rule(count: int, tail: bool) -> tuple[Array, Array]:
    """Return places of a cell from 0 to 1, and weights; dense at both ends where the kernel has a logarithm."""
    s, weights = gauss_legendre(count)
    return (s**3 * (10.0 - 15.0 * s + 6.0 * s * s), 30.0 * weights * (s * (1.0 - s)) ** 2) if tail else (s, weights)


class LayeredGrid(GridTransforms):
    """Matrices of the transforms on one grid; subclasses state the kernels.

    Parameters
    ----------
    plain : GridTransforms
        Those of a homogeneous half-space.
    response : WaveResponse
        Of the medium, to a pressure or to shear.
    """

    def __init__(self, plain: GridTransforms, response: WaveResponse) -> None:
        nodes = plain.nodes
        super().__init__(nodes)
        self.plain, self.in_the_middle = plain, plain.in_the_middle
        self.borders, self.areas = plain.borders, plain.areas
        self.edge = self.edges(response, nodes)
        points, weights, starts = self._points(response)
        inner = self.held(response, points, nodes) * weights
        held = self._by_hats(inner, points, starts)
        self.held_away: Array = np.eye(nodes.size) - held
        """What takes a transform h to phi(x; x) g(x), lower triangular ``(n, n)``."""
        self.gap = (plain.gap - held @ plain.gap) / self.edge[:, None]
        outer = self.spread(response, nodes, points) * (self.edges(response, points) * weights)
        self._spread = self._by_hats(outer, points, starts)
        widths = np.diff(nodes)
        self._near, self._held_near = (np.add.reduceat(each, starts, axis=1) / widths for each in (outer, inner))
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

    def _points(self, response: WaveResponse) -> tuple[Array, Array, Array]:
        """Return places in all cells, ascending, their weights [m], and where each cell begins among them."""
        widths, tail = np.diff(self.nodes), has_tail(response)
        middle = self.nodes[:-1] < MIDDLE * response.smooth
        wanted = np.ceil(np.where(middle, POINTS_IN_THE_MIDDLE, POINTS_PER_LENGTH) * widths / response.smooth)
        least = np.where(middle | tail, MORE_POINTS, FEWEST_POINTS)
        counts = np.clip(wanted, least, MOST_POINTS).astype(int)
        rules = [_cell_rule(count, tail) for count in counts.tolist()]
        places = [start + width * s for start, width, (s, _) in zip(self.nodes, widths, rules, strict=False)]
        weights = [width * share for width, (_, share) in zip(widths, rules, strict=True)]
        return np.concatenate(places), np.concatenate(weights), np.append(0, np.cumsum(counts)[:-1])

    def _by_hats(self, samples: Array, points: Array, starts: Array) -> Array:
        """Return sums of samples ``(n, points)`` times functions that are one at one node and zero at all others."""
        cell = np.searchsorted(starts, np.arange(points.size), side="right") - 1
        later = (points**2 - self.squares[cell]) / self.widths[cell]
        matrix = np.zeros((self.nodes.size, self.nodes.size))
        matrix[:, :-1] += np.add.reduceat(samples * (1.0 - later), starts, axis=1)
        matrix[:, 1:] += np.add.reduceat(samples * later, starts, axis=1)
        return matrix

    def _alike(self, values: Array, cuts: list[CutCell]) -> tuple[Array, list[CutCell], Array]:
        """Return the springs without layers that press alike: those of which the positive part counts, and the rest."""
        rest, alike = self._spread @ np.maximum(values, 0.0) + self.missed_load(cuts), []
        scaled = self.edge * values
        for cut in cuts_of(self.squares, scaled):
            # the rest stands still where no spring is pressed, and reaches beyond no edge
            rise, wide = rest.item(cut.cell + 1) - rest.item(cut.cell), cut.grown(cut.start, cut.place, cut.stop)
            slope, by_nodes = rise / wide if wide > 0.0 else 0.0, rise / (cut.stop - cut.start)
            alike.append(cut._replace(slope=cut.slope - slope, cut_slope=cut.cut_slope - by_nodes))
        return scaled, alike, rest

    def line_load(self, values: Array, cuts: list[CutCell]) -> Array:
        """Return q [m] at the nodes: the springs without layers that press as springs values+ do on them."""
        return np.asarray(self.own @ np.maximum(values, 0.0) - self.missed_load(cuts))

    def missed_load(self, cuts: list[CutCell]) -> Array:
        """Return what springs outside give each other in cells of a cut [m], beyond what nodes alone do."""
        return np.asarray(self._near[:, [cut.cell for cut in cuts]] @ self.plain.missed(cuts))

    def missed_hold(self, cuts: list[CutCell]) -> Array:
        """Return what a transform gives those farther out in cells of a cut [m], beyond what nodes alone do."""
        return np.asarray(self._held_near[:, [cut.cell for cut in cuts]] @ self.plain.missed(cuts))

    def borne(self, values: Array, cuts: list[CutCell]) -> Array:
        """As `GridTransforms.borne`, over E* of the uppermost layer."""
        scaled, alike, rest = self._alike(values, cuts)
        slopes = np.diff(np.maximum(scaled, 0.0) - rest) / self.widths
        slopes[[cut.cell for cut in alike]] = 0.0
        return self.plain.borne_by(slopes, alike, max(scaled.item(-1), 0.0))

    def integral(self, values: Array, cuts: list[CutCell]) -> float:
        """As `GridTransforms.integral`, as the pressures have it."""
        scaled, alike, rest = self._alike(values, cuts)
        return self.plain.integral(scaled, alike) - float(self.plain.force @ rest)

    def means(self, squares: Array, values: Array) -> Array:
        """As `GridTransforms.means`: nothing of a volume is lost."""
        return self.plain.means(squares, values)
