r"""An approximate inverse of the response of some pixels to each other, whatever layers lie below.

The response of an elastic surface is a Green's function, of an operator of the first order on a half-space and of the
fourth where a stiff layer bends.  Given the displacements of the pixels around it, that of a pixel hardly depends on
pixels farther away.  Pixels are put in order from coarse to fine, and each is eliminated given only those before it
that are nearer than three times the distance between pixels of its level: a factor L of few numbers with
:math:`L L^T` near the inverse.

F. Schaefer, M. Katzfuss, H. Owhadi, SIAM J. Sci. Comput. 43 (2021) A2019-A2046, doi:10.1137/20M1336254
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.plates.near_columns import MOST_NEAR, fill_columns
from winkler.numerics.plates.responding_grid import RespondingGrid
from winkler.numerics.types import Array


def kernel_of(grid: RespondingGrid) -> Array:
    """Return the displacement of all pixels under a unit pressure on the one at (0, 0), positive everywhere."""
    one = np.zeros(grid.shape)
    one[0, 0] = 1.0
    kernel = np.ascontiguousarray(grid.displaced(one), dtype=float)
    lowest = float(np.min(kernel))
    # of a periodic surface at rest in the mean; with the same everywhere added it has an inverse
    return kernel - 2.0 * lowest if lowest <= 0.0 else kernel


class ScreenedInverse:
    """About the pressures that displace some pixels in a wanted way.

    Parameters
    ----------
    kernel : ndarray, (nx, ny)
        As of `kernel_of`.
    there : ndarray, (nx, ny)
        The pixels, at least one.
    periodic : bool
        Whether the surface is repeated.
    """

    def __init__(self, kernel: Array, there: Array, periodic: bool) -> None:
        from scipy.sparse import csr_array

        x, y = np.nonzero(there)
        n = x.size
        members, counts = np.zeros((n, MOST_NEAR), dtype=np.int64), np.zeros(n, dtype=np.int64)
        values, room = np.zeros((n, MOST_NEAR)), np.zeros((MOST_NEAR, MOST_NEAR))
        rank, ranked, cell = np.full(n, n), 0, 1
        while cell < max(there.shape):
            cell *= 2
        stands = np.zeros(n, dtype=bool)
        while ranked < n:
            cells = tuple(-(-size // cell) for size in there.shape)
            table = np.full(cells, -1)
            off = (x % cell - cell // 2) ** 2 + (y % cell - cell // 2) ** 2
            # the last one written stays: the pixel that stands already, or the one nearest to the middle
            order = np.lexsort((-off, stands))
            table[x[order] // cell, y[order] // cell] = order
            fresh = table[table >= 0]
            fresh = fresh[~stands[fresh]]
            rank[fresh] = ranked + np.arange(fresh.size)
            stands[fresh] = True
            ranked += fresh.size
            fill_columns(fresh, x, y, rank, table, cell, kernel, periodic, members, values, counts, room)
            cell //= 2
        kept = np.arange(MOST_NEAR) < counts[:, None]
        ends = np.concatenate(([0], np.cumsum(counts)))
        self.rows = csr_array((values[kept], members[kept], ends), shape=(n, n))
        self.columns = self.rows.T.tocsr()

    def __call__(self, displacement: Array) -> Array:
        """Return pressures (n,) that displace the pixels by about these displacements (n,)."""
        return np.asarray(self.columns @ (self.rows @ displacement))
