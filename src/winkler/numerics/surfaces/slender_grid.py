r"""The surface below a slender contact, on elements that are graded along it and equal across it.

Where E* is one, the force on an element times the displacement of another is

.. math:: S_{ij} = \frac1\pi\int_i\!\int_j\frac{\mathrm dA\,\mathrm dA'}{r} \approx
          \tfrac12\left(A_i\,u_{ij} + A_j\,u_{ji}\right) ,

with Love's displacement u_ij at the middle of element i under a unit pressure on element j, and what layers and
gradings add to it: symmetric, and of second order like either of the two.

Pressures are even across the contact.  Across, the product is a convolution, made by
fast cosine transforms; along, one small matrix for every wave number.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.integrals import love
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

SPREAD = 0.3
"""Elements that are spread evenly over those that are not."""
HALVINGS = 60
"""Of the interval in which an end of an element is sought."""


def graded(low: float, high: float, marks: Array, finest: Array, count: int) -> Array:
    """Return the ends of elements from `low` to `high` [m], small beside the marks, of smoothly changing sizes.

    Some of the elements are spread evenly, the others with their sizes in proportion to the distance from a mark.

    Parameters
    ----------
    low, high : float
        Ends [m].
    marks : ndarray
        Places [m] beside which elements are small.
    finest : ndarray
        Distances [m] from the marks from which on elements grow.
    count : int
        Of elements.
    """

    def graded_part(x: Array) -> Array:
        return np.asarray(np.sum(np.arcsinh((x[:, None] - marks) / finest), axis=1))

    first, last = graded_part(np.array([low, high]))
    numbers = np.linspace(0.0, 1.0 + SPREAD, count + 1)
    below, above = np.full(count + 1, low), np.full(count + 1, high)
    for _ in range(HALVINGS):
        x = 0.5 * (below + above)
        beyond = (graded_part(x) - first) / (last - first) + SPREAD * (x - low) / (high - low) > numbers
        below, above = np.where(beyond, below, x), np.where(beyond, x, above)
    ends = np.asarray(0.5 * (below + above))
    ends[0], ends[-1] = low, high
    return ends


class SlenderGrid(NamedTuple):
    """A slender grid and its response to pressures that are even across it.

    Parameters
    ----------
    edges
        Ends of the elements along it [m], ascending, (n + 1,).
    across
        Width of the elements across [m].
    rows
        How many elements there are across on either side of the middle.
    waves
        Transform of S across, (2 rows, n, n) [m^3].
    factors
        Inverse of the lower factor of S within each slice, (n, rows, rows).
    """

    edges: Array
    across: float
    rows: int
    waves: Array
    factors: Array

    @classmethod
    def of(cls, edges: Array, across: float, rows: int, layers: SurfaceBelow | None = None) -> SlenderGrid:
        """Return the grid.

        Parameters
        ----------
        edges, across, rows
            As of the grid.
        layers
            What differs from a homogeneous half-space, in the unit of length of the grid.

        Raises
        ------
        NotConverged
            If the response of the layers is not resolved, or not positive on these elements.
        OutsideValidity
            If the elements are too coarse for the layers.
        """
        middles, lengths = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
        y = (np.arange(2 * rows + 1) - 0.5) * across
        x = edges[:, None, None] - middles[:, None]
        # rows apart, at the middle, of the element
        pressed = np.diff(np.diff(love(x, y), axis=2), axis=0).transpose(2, 1, 0)
        moved = pressed / np.pi if layers is None else pressed / np.pi + layers.slices(edges, across, 2 * rows)
        weighted = moved * (across * lengths[:, None])
        mutual = 0.5 * (weighted + weighted.transpose(0, 2, 1))
        wrapped = np.concatenate([mutual, np.zeros((1, *mutual.shape[1:])), mutual[:0:-1]])
        waves = np.ascontiguousarray(np.fft.rfft(wrapped, axis=0).real[:-1])
        within, row = np.diagonal(mutual, axis1=1, axis2=2).T, np.arange(rows)
        block = within[:, np.abs(row[:, None] - row)] + within[:, row[:, None] + row + 1]
        try:
            return cls(edges, across, rows, waves, np.linalg.inv(np.linalg.cholesky(block)))
        except np.linalg.LinAlgError:
            raise NotConverged(
                "the elements do not resolve the layers below them; use more elements, or a thicker layer."
            ) from None

    @property
    def middles(self) -> Array:
        """Middles of the elements along the grid [m]."""
        return 0.5 * (self.edges[1:] + self.edges[:-1])

    @property
    def places_across(self) -> Array:
        """Middles of the elements on the positive side [m]."""
        return (np.arange(self.rows) + 0.5) * self.across

    @property
    def areas(self) -> Array:
        """Areas of the elements of each slice [m^2]."""
        return self.across * np.diff(self.edges)

    def displaced(self, pressures: Array) -> Array:
        """Return S p [m^3], of several fields (fields, n, rows) of pressures over E* on the positive side."""
        import scipy.fft

        waves = scipy.fft.dct(pressures, 2, 2 * self.rows, axis=-1).transpose(2, 1, 0)
        moved = scipy.fft.idct((self.waves @ waves).transpose(2, 1, 0), 2, axis=-1)
        return np.asarray(moved[..., : self.rows])

    def roughly_pressing(self, work: Array, bearing: Array) -> Array:
        """Return pressures that bear S p within each slice alone: the preconditioner.

        Parameters
        ----------
        work : ndarray
            S p [m^3], (fields, n, rows), zero where nothing bears.
        bearing : ndarray of bool
            Elements in contact, (n, rows), in each slice those up to some distance from the middle.
        """
        within = bearing[:, :, None]
        lower = np.where(within, self.factors @ work.transpose(1, 2, 0), 0.0)
        return np.asarray(np.where(within, self.factors.transpose(0, 2, 1) @ lower, 0.0).transpose(2, 0, 1))
