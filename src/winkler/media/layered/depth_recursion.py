r"""The decay of waves in a body graded in depth: compliances and tractions at each depth, to a stated tolerance.

The body is cut into cells no thicker than a part of their depth, across which E changes little; breaks of E are edges
of cells.  A cell replaced by c equal homogeneous layers, each with the moduli of its middle, errs by a series in
:math:`1/c^2`; four such ladders, c = 1, 2, 3, 4, carried side by side, give a result of eighth order in the
thickness.  With x = xi times the thickness of a layer, n, m, q = nu/(1-nu), (1-2nu)/(1-nu), 1/(1-nu), and
:math:`\alpha=\frac q2x\sinh x,\ \beta=\frac q2(x\cosh x-\sinh x)`, displacements times :math:`\xi` and tractions over
2 G, :math:`(U, W, T, S)`, at the upper face are those at the lower face times

.. math:: \begin{pmatrix}
          c+\alpha & -s-\beta & -2s-\beta & \alpha\\ ns+\beta & c-\alpha & -\alpha & \beta-ms\\
          -qs-\beta & \alpha & c+\alpha & -ns-\beta\\ -\alpha & \beta & s+\beta & c-\alpha \end{pmatrix},
          \qquad c, s = \cosh x, \sinh x .

Going up it grows with the field it carries, so that nothing cancels.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.materials.depth_grading import DepthGrading
from winkler.media.layered.across import across_above
from winkler.media.layered.blocks import times
from winkler.numerics.caching import cached_by_value
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import NotConverged

STEP_DIVISIONS = np.arange(1, 5)
EXTRAPOLATION_WEIGHTS = np.array([-1.0 / 360.0, 16.0 / 45.0, -729.0 / 280.0, 1024.0 / 315.0])
"""Of the ladders with c = 1, 2, 3, 4: what is left of the error is of order 1/c^8."""
LOWER_WEIGHTS = np.array([1.0 / 24.0, -16.0 / 15.0, 81.0 / 40.0, 0.0])
"""The same without the finest: the difference gives the error of this one, far above that of the other."""
COARSEST_CELL = 0.35
"""Thickness of a cell over its depth, and change of ln E across it, to begin with."""
REFINEMENT_RATIO = 0.65
MOST_CELLS = 3000
"""Besides one between any two breaks: what a table of many points costs, its author asks for."""
SAMPLED_WAVES = 48
SURFACE_DECAY = 18.0
"""A wave that starts at the surface is followed down to this depth over xi: the returning wave has decayed twice."""
INTERIOR_DECAY = 70.0
"""The same if the field at depth is requested: it has decayed once."""


class Mesh(NamedTuple):
    """Cells from the top, and what lies below them."""

    edges: Array
    shear: Array
    poisson: Array
    deep_shear: float
    deep_poisson: float


class CellState(NamedTuple):
    """At one edge, per unit pressure on the surface: displacements times xi [m/Pa m], tractions [-], ``(m,)`` each."""

    depth: float
    along: Array
    lift: Array
    shear: Array
    axial: Array


def surface_depth(grading: DepthGrading) -> float:
    """Return the depth [m] over which the surface alone matters."""
    return min([grading.finest, *grading.breaks[:1]])


@cached_by_value(128)
def mesh(grading: DepthGrading, tolerance: float, shortest: float, depths: tuple[float, ...] = ()) -> Mesh:
    """Return cells so fine that the compliance of the surface errs by less than a part `tolerance`.

    Parameters
    ----------
    given : DepthGrading
        A value.
    tolerance : float
        Relative.
    shortest : float
        The inverse of the largest wave number of interest [m].
    depths : tuple of float
        Where an edge is wanted [m], besides.

    Raises
    ------
    NotConverged
        If 3000 cells more than breaks would be needed.
    """
    reach = grading.settled_at(0.1 * tolerance)
    part = COARSEST_CELL
    xi = np.geomspace(1e-3 / reach, 1.0 / shortest, SAMPLED_WAVES)
    while True:
        cells = _cells(grading, _edges(grading, reach, part, shortest, depths), reach)
        ladders = _through_cells(cells, xi, SURFACE_DECAY)[0][2]
        error = float(np.max(np.abs((LOWER_WEIGHTS @ ladders) / (EXTRAPOLATION_WEIGHTS @ ladders) - 1.0)))
        if error <= tolerance:
            return cells
        part *= REFINEMENT_RATIO


def _edges(grading: DepthGrading, reach: float, part: float, shortest: float, depths: tuple[float, ...]) -> Array:
    fixed = np.unique([0.0, *(z for z in (*grading.breaks, *depths) if 0.0 < z < reach), reach])
    low, high = fixed[:-1], fixed[1:]
    done: list[Array] = []
    count = 0
    while low.size:
        z = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, 5)
        # a break is an edge: what lies just above it decides
        z[:, -1] = np.nextafter(z[:, -1], 0.0)
        change = np.sum(np.abs(np.diff(np.log(grading.young_at(z)), axis=1)), axis=1)
        change += 4.0 * np.sum(np.abs(np.diff(grading.poisson_at(z), axis=1)), axis=1)
        good = (change <= part) & (high - low <= part * (low + shortest))
        done.append(low[good])
        middle = 0.5 * (low[~good] + high[~good])
        low, high = np.concatenate([low[~good], middle]), np.concatenate([middle, high[~good]])
        count += int(np.count_nonzero(good))
        if count + low.size > MOST_CELLS + fixed.size:
            raise NotConverged(
                f"DepthGradedHalfSpace: more than {MOST_CELLS + fixed.size} cells would be needed for the tolerance; "
                "request less, or smooth the grading."
            )
    return np.append(np.sort(np.concatenate(done)), reach)


def _cells(grading: DepthGrading, edges: Array, reach: float) -> Mesh:
    """Return the moduli of all layers ``(cells, c, place from below)``; missing ones are those of a middle."""
    place = np.minimum(np.arange(4), STEP_DIVISIONS[:, None] - 1)
    z = edges[1:, None, None] - np.diff(edges)[:, None, None] * (place + 0.5) / STEP_DIVISIONS[:, None]
    young, poisson = grading.young_at(z), grading.poisson_at(z)
    deep = np.array(reach * 1e3)
    low = float(grading.poisson_at(deep))
    return Mesh(edges, young / (2.0 * (1.0 + poisson)), poisson, float(grading.young_at(deep)) / (2.0 + 2.0 * low), low)


def _started(shear: float, poisson: float) -> Array:
    """Return Y of a homogeneous half-space ``(3, 1, 1)``: along, mixed, normal."""
    normal = -(1.0 - poisson) / shear
    return np.array([normal, (0.5 - poisson) / shear, normal])[:, None, None]


def _step(y: ComplexArray, x: ComplexArray, shear: Array, poisson: Array) -> tuple[ComplexArray, ComplexArray]:
    """Return Y at the upper face of layers, and the tractions below per traction above ``(4, ...)``."""
    twice, q = 2.0 * shear, 1.0 / (1.0 - poisson)
    along, mixed, normal = twice * y
    grown = np.exp(x)
    shrunk = 1.0 / grown
    c, s = 0.5 * (grown + shrunk), 0.5 * (grown - shrunk)
    alpha, beta = (0.5 * q) * x * s, (0.5 * q) * (x * c - s)
    own, high, low, both = q * s, c + alpha, c - alpha, s + beta
    n = poisson * own
    bent, rotated, pulled, last = n + beta, own + beta, beta - own + 2.0 * n, both + s
    # displacements and tractions at the upper face, per traction at the lower face
    u0, u1 = high * along - both * mixed - last, high * mixed - both * normal + alpha
    w0, w1 = bent * along + low * mixed - alpha, bent * mixed + low * normal + pulled
    t0, t1 = alpha * mixed - rotated * along + high, alpha * normal - rotated * mixed - bent
    s0, s1 = beta * mixed - alpha * along + both, beta * normal - alpha * mixed + low
    scale = 1.0 / (t0 * s1 - t1 * s0)
    decay = np.array([s1 * scale, -t1 * scale, -s0 * scale, t0 * scale])
    upper = np.array([u0 * decay[0] + u1 * decay[2], u0 * decay[1] + u1 * decay[3], w0 * decay[1] + w1 * decay[3]])
    return upper / twice, decay


def _started_across(shear: float, _: float) -> Array:
    """Return the same of waves across ``(1, 1, 1)``."""
    return np.array([[[1.0 / shear]]])


def _step_across(y: ComplexArray, fall: ComplexArray, shear: Array, _: Array) -> tuple[ComplexArray, ComplexArray]:
    """Return Y across at the upper face of layers, by tanh(x); no tractions below are asked for."""
    return across_above(y, shear, fall), fall


def _through_cells(
    cells: Mesh, xi: ComplexArray, decay_limit: float, *, keep: bool = False, across: bool = False
) -> tuple[ComplexArray, list[ComplexArray]]:
    """Return Y at the surface, by every ladder ``(3, 4, m)``; if requested, Y and decay of every cell ``(7, 4, m)``.

    Y across the wave is one number ``(1, 4, m)``.
    """
    start, crossed = (_started_across, _step_across) if across else (_started, _step)
    real = np.real(xi)
    order = np.argsort(real)
    xi, real = xi[order], real[order]
    first = start(cells.deep_shear, cells.deep_poisson)
    y = np.zeros((len(first), 4, xi.size), dtype=xi.dtype) + first
    stored: list[ComplexArray] = []
    back = np.argsort(order)
    for cell in range(cells.edges.size - 2, -1, -1):
        top, bottom = cells.edges[cell], cells.edges[cell + 1]
        end = int(np.searchsorted(real, decay_limit / bottom))
        shear, poisson = cells.shear[cell, :, :, None], cells.poisson[cell, :, :, None]
        y[:, :, end:] = start(float(shear[0, 0, 0]), float(poisson[0, 0, 0]))
        x = (bottom - top) * xi[:end] / STEP_DIVISIONS[:, None]
        x = np.tanh(x) if across else x
        decay: ComplexArray | None = None
        for step in range(4):
            rows = slice(step, None)
            y[:, rows, :end], fall = crossed(y[:, rows, :end], x[rows], shear[rows, step], poisson[rows, step])
            if not keep:
                continue
            if decay is None:
                decay = np.zeros((4, 4, xi.size), dtype=xi.dtype)
                decay[:, :, :end] = fall
            else:
                decay[:, rows, :end] = times(tuple(decay[:, rows, :end]), tuple(fall))
        if decay is not None:
            stored.append(np.concatenate([y, decay])[:, :, back])
    return y[:, :, back], stored[::-1]


def surface_compliance(cells: Mesh, xi: ComplexArray) -> ComplexArray:
    """Return the compliance Y of the surface at real or complex wave numbers.

    Parameters
    ----------
    cells : Mesh
        The body.
    xi : ndarray, (m,)
        Wave numbers [1/m].

    Returns
    -------
    ndarray, (3, m)
        Entries along, mixed and normal of ``displacements = Y tractions / xi`` [1/Pa].
    """
    return np.asarray(np.einsum("c,kcm->km", EXTRAPOLATION_WEIGHTS, _through_cells(cells, xi, SURFACE_DECAY)[0]))


def surface_compliance_across(cells: Mesh, xi: ComplexArray) -> ComplexArray:
    """Return the same for displacements and tractions across the wave, in the plane of the surface ``(m,)``."""
    ladders = _through_cells(cells, xi, SURFACE_DECAY, across=True)[0][0]
    return np.asarray(EXTRAPOLATION_WEIGHTS @ ladders)


def states_with_depth(cells: Mesh, xi: Array) -> Iterator[CellState]:
    """Yield, edge by edge from the surface, what a pressure wave does; xi real, ``(m,)``."""
    y, stored = _through_cells(cells, xi, INTERIOR_DECAY, keep=True)
    shear, axial = np.zeros((4, xi.size)), np.full((4, xi.size), -1.0)
    deep = np.broadcast_to(_started(cells.deep_shear, cells.deep_poisson), y.shape)
    faces = [y, *(block[:3] for block in stored[1:]), deep]
    for depth, here, block in zip(cells.edges, faces, [None, *stored], strict=True):
        if block is not None:
            a, b, c, d = block[3:]
            shear, axial = a * shear + b * axial, c * shear + d * axial
        along, mixed, normal = here
        parts = (along * shear + mixed * axial, mixed * shear + normal * axial, shear, axial)
        yield CellState(float(depth), *(np.asarray(EXTRAPOLATION_WEIGHTS @ part) for part in parts))
