r"""Sliding rings by `winkler.numerics.transforms.slip_tables` where kernels have a logarithm at zero distance.

The kernel is not summed at the nodes: the polynomials of each panel are integrated with it, up to the ends of the panel
and up to each of its nodes.  With the rows r(x) of the inverse of the equations that are cut at x,

.. math:: h(x)\,e(x) = q(x) + \sum_y r(x)_y \int_x^t K(y,s)\,q(s)\,\mathrm ds .

What is not smooth at the cut, :math:`(t-x)\ln(t-x)` times the strength of the logarithm, remains of the polynomials.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.numerics.panels.kink_panels import NODES_PER_PANEL, Stretches
from winkler.numerics.transforms.cosine_transform import WaveResponse, transform
from winkler.numerics.transforms.kernel_matrix import FAR_DISTANCE_RATIO, WIDEST_REGULAR_PANEL, graded_rule
from winkler.numerics.transforms.odd_response import parity
from winkler.numerics.types import Array


class RoundedSums:
    """The integrals of K(x, s) times the polynomials of each panel, at the nodes x.

    Parameters
    ----------
    panels : Stretches
        Without kinks: distances are integrated over x.
    response : WaveResponse
        Of which the kernel is the transform.
    """

    def __init__(self, panels: Stretches, response: WaveResponse) -> None:
        self.panels, n = panels, NODES_PER_PANEL
        self._response, self._sign = parity(response)
        self.x = panels.nodes.ravel()
        self._kernel = transform(self._response, 2.0 * float(self.x[-1]))
        self._apart = 0.5 * self._kernel(np.abs(self.x[:, None] - self.x))
        self._summed = 0.5 * self._sign * self._kernel(self.x[:, None] + self.x)
        self.whole: Array = (self._apart + self._summed) * panels.weights.ravel()
        """Over whole panels, ``(n, n)``."""
        for panel in range(panels.base.size):
            own, ends = slice(panel * n, (panel + 1) * n), panels.edges[panel : panel + 2]
            near = self._near(panel, self.x.size)
            if near.size == 0:
                continue
            weights = panels.weights[panel]
            self.whole[near, own] = self._summed[near, own] * weights + self._graded(near, panel, *ends.tolist())

    def part(self, panel: int) -> Array:
        """Return them over a panel up to each of its nodes: ``(nodes, rows up to its end, nodes)``."""
        n = NODES_PER_PANEL
        own, rows = slice(panel * n, (panel + 1) * n), (panel + 1) * n
        reach = self.panels.part(self.panels.nodes[panel], np.full(n, panel)) * self.panels.stretch[panel]
        parts = (self._apart + self._summed)[None, :rows, own] * reach[:, None, :]
        near, low = self._near(panel, rows), float(self.panels.edges[panel])
        for number, end in enumerate(self.panels.nodes[panel].tolist() if near.size else []):
            parts[number, near] = self._summed[near, own] * reach[number] + self._graded(near, panel, low, end)
        return np.asarray(parts)

    def _near(self, panel: int, rows: int) -> Array:
        low, high = self.panels.edges[panel : panel + 2].tolist()
        if high - low <= WIDEST_REGULAR_PANEL * self._response.length:
            return np.zeros(0, dtype=int)
        far = np.maximum(low - self.x[:rows], self.x[:rows] - high)
        return np.flatnonzero(far <= FAR_DISTANCE_RATIO * (high - low))

    def _graded(self, near: Array, panel: int, low: float, high: float) -> Array:
        place = self.x[near]
        distance, weights = graded_rule(place, low, high, self._response)
        at = np.clip(place[:, None] + distance, low, high)
        basis = self.panels.reading(at, np.full(at.shape, panel))
        return np.asarray(np.einsum("ij,ijk->ik", 0.5 * weights * self._kernel(np.abs(distance)), basis))


def _cuts(sums: RoundedSums) -> Iterator[tuple[Array, Array, Array, Array]]:
    """Yield, panel by panel, the parts, the inverse of the lower panels, what they reflect and the own inverses.

    The solution of the equations that are cut at node j of the panel is, of a right-hand side f,
    ``own = corner[j] @ (f_O - reflected @ f_L)`` and ``lower = inverse @ f_L - inverse @ part[j, :low] @ own``.
    """
    n = NODES_PER_PANEL
    inverse = np.zeros((0, 0))
    for panel in range(sums.panels.base.size):
        low, own = panel * n, slice(panel * n, (panel + 1) * n)
        part = sums.part(panel)
        reflected = sums.whole[own, :low] @ inverse
        schur = part[:, low:] - np.einsum("ol,jlk->jok", reflected, part[:, :low])
        yield part, inverse, reflected, np.linalg.inv(np.eye(n) + schur)
        corner = np.linalg.inv(np.eye(n) + sums.whole[own, own] - reflected @ sums.whole[:low, own])
        right = -inverse @ sums.whole[:low, own] @ corner
        inverse = np.block([[inverse - right @ reflected, right], [-corner @ reflected, corner]])


def rounded_loads(panels: Stretches, normal: WaveResponse) -> Iterator[tuple[slice, Array]]:
    """Yield, panel by panel of the radii of flat punches, phi at the nodes up to the end of the panel."""
    n = NODES_PER_PANEL
    for panel, (part, inverse, reflected, corner) in enumerate(_cuts(RoundedSums(panels, normal))):
        low = panel * n
        ones = np.ones(low)
        inside = (corner @ (1.0 - reflected @ ones)).T  # own nodes, radii
        lower = (inverse @ ones)[:, None] - inverse @ np.einsum("jlk,kj->lj", part[:, :low], inside)
        yield slice(low, low + n), np.vstack([lower, inside])


def rounded_slips(
    panels: Stretches, shear: WaveResponse, shape: Array, loads: Iterator[tuple[slice, Array]]
) -> tuple[Array, Array]:
    """Return h times e at the nodes under line loads q of all radii, ``(n, n)``, and e, ``(n,)``.

    Parameters
    ----------
    panels : Stretches
    shear : WaveResponse
        To a shear traction, or an `OddResponse` for a twist.
    shape : ndarray, (n,)
        The rigid motion at the nodes.
    loads : iterator
        q at the nodes up to the end of each panel, for the radii in it.
    """
    n, sums = NODES_PER_PANEL, RoundedSums(panels, shear)
    size = sums.x.size
    rows, parts, lever = np.zeros((size, size)), [], np.empty(size)
    for panel, (part, _, reflected, corner) in enumerate(_cuts(sums)):
        low, own = panel * n, slice(panel * n, (panel + 1) * n)
        mine = np.einsum("jjk->jk", corner)
        rows[own, own], rows[own, :low] = mine, -mine @ reflected
        lever[own] = rows[own, : own.stop] @ shape[: own.stop]
        parts.append(part)
    beyond = np.zeros((size, size))
    """Of polynomials on all panels above a node, and on its own one from the node on."""
    for panel, part in enumerate(parts):
        low, own = panel * n, slice(panel * n, (panel + 1) * n)
        known = rows[own, : own.stop]
        beyond[own, own.stop :] = known @ sums.whole[: own.stop, own.stop :]
        beyond[own, own] = known @ sums.whole[: own.stop, own] - np.einsum("jm,jmk->jk", known, part)
    found = np.zeros((size, size))
    for columns, load in loads:
        low, high = columns.start, columns.stop
        part = parts[low // n]
        found[:high, columns] = load + beyond[:high, :low] @ load[:low]
        # up to the radius: the whole of the last panel would be too much
        reached = rows[:high, :high] @ np.einsum("jmk,kj->mj", part, load[low:])
        found[:low, columns] += reached[:low]
        before = np.einsum("im,imk->ik", rows[columns, :high], part)
        found[columns, columns] += reached[low:] - before @ load[low:]
    return found, lever
