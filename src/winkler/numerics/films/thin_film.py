r"""Flow of a thin film between two sides of a grid, by finite volumes.

A film of the width h conducts :math:`k=h^3` per length and width (in units of 1/(12 eta)), and

.. math:: \nabla\cdot(k\,\nabla p) = 0 .

Between the middles of two pixels their halves stand in series, so that the conductance of a face is the harmonic mean.
The flow then lies between those of the harmonic and of the arithmetic mean of all pixels, whatever the map.  Flows are
refined, not pressures: where wide places are joined by narrow ones, pressures differ by less than their rounding.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.films.joined import through
from winkler.numerics.types import Array

MOST_REFINEMENTS = 8
ENOUGH = 1e-15
"""What a pixel may gain or lose, over the whole flow."""


class FilmFlow(NamedTuple):
    """Flow of a thin film for the pressures one and zero at the first and the last side.

    Parameters
    ----------
    rate
        Flow in at the first side.
    imbalance
        Difference of the flows in and out, over their mean; zero if there is none.
    pressure
        In the middle of the pixels, (nx, ny); nan where nothing flows through.
    along, across
        Flow through each pixel along the first and the second direction, mean of its faces, (nx, ny).
    """

    rate: float
    imbalance: float
    pressure: Array
    along: Array
    across: Array


def _in_series(one: Array, other: Array) -> Array:
    """Return the harmonic mean of conductances; zero if one of them is."""
    total = one + other
    return np.asarray(2.0 * one * (other / np.where(total > 0.0, total, 1.0)))


def film_flow(conductance: Array, pixel: tuple[float, float], *, wraps: bool) -> FilmFlow:
    """Return the flow from the first to the last row.

    Parameters
    ----------
    conductance
        k of each pixel, (nx, ny), not negative.
    pixel
        (dx, dy).
    wraps
        Whether the last column joins the first one; otherwise nothing flows through the other two sides.
    """
    open_pixels = through(conductance > 0.0, wraps=wraps)
    nothing = np.zeros(conductance.shape)
    if not open_pixels.any():
        return FilmFlow(0.0, 0.0, np.full(conductance.shape, np.nan), nothing, nothing)
    unit = float(np.max(conductance[open_pixels]))
    k = np.where(open_pixels, conductance / unit, 0.0)
    ratio = pixel[1] / pixel[0]
    faces_along = ratio * np.concatenate((2.0 * k[:1], _in_series(k[:-1], k[1:]), 2.0 * k[-1:]))
    faces_across = _in_series(k, np.roll(k, -1, 1)) / ratio
    if not wraps:
        faces_across[:, -1] = 0.0
    solve = _solver(faces_along, faces_across, open_pixels)

    # the first side is at one, nothing else is known yet: what flows in is the first residual
    pressure, across = nothing.copy(), nothing.copy()
    along = np.zeros(faces_along.shape)
    along[0] = faces_along[0]
    for _ in range(MOST_REFINEMENTS):
        gained = np.where(open_pixels, along[:-1] - along[1:] + np.roll(across, 1, 1) - across, 0.0)
        rate = float(np.sum(along[-1]))
        if rate > 0.0 and float(np.max(np.abs(gained))) <= ENOUGH * rate:
            break
        more = solve(gained)
        pressure += more
        beside = np.zeros((1, more.shape[1]))
        along += faces_along * -np.diff(np.concatenate((beside, more, beside)), axis=0)
        across += faces_across * (more - np.roll(more, -1, 1))
    into, out = float(np.sum(along[0])), float(np.sum(along[-1]))
    return FilmFlow(
        unit * into,
        abs(into - out) / (0.5 * (into + out)),
        np.where(open_pixels, pressure, np.nan),
        0.5 * unit * (along[:-1] + along[1:]),
        0.5 * unit * (across + np.roll(across, 1, 1)),
    )


def _solver(faces_along: Array, faces_across: Array, open_pixels: Array):  # type: ignore[no-untyped-def]
    """Return a function that gives the pressures for what the pixels gain."""
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import splu

    place = np.full(open_pixels.shape, -1)
    count = int(np.count_nonzero(open_pixels))
    place[open_pixels] = np.arange(count)
    diagonal = faces_along[:-1] + faces_along[1:] + faces_across + np.roll(faces_across, 1, 1)
    rows, columns, entries = [place[open_pixels]], [place[open_pixels]], [diagonal[open_pixels]]
    for face, one, other in (
        (faces_along[1:-1], place[:-1], place[1:]),
        (faces_across, place, np.roll(place, -1, 1)),
    ):
        flows = face > 0.0
        for a, b in ((one, other), (other, one)):
            rows.append(a[flows])
            columns.append(b[flows])
            entries.append(-face[flows])
    matrix = csc_array((np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), shape=(count, count))
    # an M-matrix, whose elimination needs no pivots
    factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})

    def solve(gained: Array) -> Array:
        found = np.zeros(gained.shape)
        found[open_pixels] = factors.solve(gained[open_pixels])
        return found

    return solve
