r"""A line contact on layers that relax each by a law of its own, or that liquid leaves: cells of pressure.

Each wave of pressure sinks by a sum of exponentials of its own (`winkler.numerics.transforms.wave_creep`), so that no
function of time stands for all strips.  Hats of pressure are carried along in the place of the line load of round
contacts, under the profile itself (`winkler.numerics.springs.coupled_cells`).  What strips wider than c bear follows
from the pressure,

.. math:: q(c) = 2\int_c^a\frac{x\,p(x)}{\sqrt{x^2-c^2}}\,\mathrm dx .
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.loading.loads import Force
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.springs.coupled_cells import STRIP_EDGE_SHIFT, CoupledCells
from winkler.numerics.types import Array
from winkler.problems.line.half_width import under_force
from winkler.problems.line_viscoelastic.layered_strips import elastic_line
from winkler.problems.line_viscoelastic.path import LineForcePath
from winkler.problems.line_viscoelastic.states import LineViscoelasticState
from winkler.problems.viscoelastic.layered_march import MarchedPoint
from winkler.problems.viscoelastic.layered_notes import COARSER_STEPS, changed_by, resolution_note
from winkler.problems.viscoelastic.layered_path import REACH_MARGIN, walked
from winkler.values.validity import Note

OWNER = "LineViscoelasticIndentation"
NODES = 6
"""Gauss-Legendre nodes on each half of a hat, of the mean height of a profile under it."""


def strips_along(
    bed: LayeredLineFoundation, path: LineForcePath, count: int, tolerance: float
) -> Iterator[LineViscoelasticState]:
    """Yield the state at every point of a path.

    Parameters
    ----------
    bed : LayeredLineFoundation
        On a medium `RelaxingByWaves`.
    path : LineForcePath
    count : int
        How many cells.
    tolerance : float
        Of the depth in one step, over the greatest one so far.
    """
    line = elastic_line(bed)
    most = np.array([float(np.max(path.across)) / line.medium.modulus])
    reach = REACH_MARGIN * float(under_force(line, most)[0])
    points = path.moments, path.across
    for cells, point in walked(
        OWNER, bed, points, Force(1.0), tolerance, lambda wide: strip_cells(bed, wide, count), reach
    ):
        yield _state(bed, cells, point)


def cells_notes(solution: Any) -> tuple[Note, ...]:
    """Return by how much half as many cells change half-width and pressure; nothing where there are no cells."""
    problem = solution.problem
    if not offers(problem.bed.medium, RelaxingByWaves) or problem.count < 4:
        return ()
    coarse = list(strips_along(problem.bed, problem.path, problem.count // 2, COARSER_STEPS * problem.tolerance))
    change = changed_by(np.array([state.half_width for state in coarse]), solution.half_width)
    if np.all(np.isfinite(solution.peak_pressure)):
        change = max(change, changed_by(np.array([state.peak_pressure for state in coarse]), solution.peak_pressure))
    return (resolution_note(problem.bed, "half-width or greatest pressure", change, float(solution.half_width.max())),)


def strip_cells(bed: LineBed, reach: float, count: int) -> CoupledCells:
    """Return cells of pressure up to a half-width [m], or up to the rim of the body."""
    medium: Any = bed.medium
    reach = min(reach, bed.rim)
    width = reach / (count + STRIP_EDGE_SHIFT)
    creep = medium.creep_of_waves(width, reach)
    node, weight = gauss_legendre(NODES)
    beside = np.concatenate([node - 1.0, 1.0 - node])
    places = width * np.abs(np.arange(count)[:, None] + 0.5 + beside)
    shape = bed.profile.height(places) @ np.tile(weight * node, 2)
    return CoupledCells(creep.strip_kernels(count, width), creep.times, width, shape, STRIP_EDGE_SHIFT)


def _state(bed: LayeredLineFoundation, cells: CoupledCells, point: MarchedPoint) -> LineViscoelasticState:
    """Return the state of cells; the creep of the surface's half-plane is that of the shortest waves."""
    medium: Any = bed.medium
    state = point.state
    creep = medium.creep_of_waves(cells.width, cells.width * cells.count)
    crept = creep.local[0] * state.load
    for compliance, remembered in zip(creep.local[1:], state.memory, strict=True):
        crept = crept + compliance * (state.load - cells.restored(remembered))
    edges = cells.width * np.arange(cells.count + 1)
    borne, sunk = (_by_wider(edges, load) for load in (state.load, crept))
    edge = 0.0
    return LineViscoelasticState(
        bed, point.time, state.force, state.radius, float(sunk[0]), edge, edges[:-1], borne, sunk
    )


def _by_wider(edges: Array, load: Array) -> Array:
    """Return what strips wider than the edges of cells bear ``(n,)``, of pressures in the middles of cells ``(n,)``."""
    ends = np.append(0.5 * (edges[1:] + edges[:-1]), edges[-1] + 0.5 * edges[1])
    slopes = np.diff(np.append(load, 0.0))
    x, c = ends[None, :], edges[:-1, None]
    far = np.maximum(x, c)
    root = np.sqrt((far - c) * (far + c))
    with np.errstate(divide="ignore", invalid="ignore"):
        risen = far * root - np.where(c > 0.0, c * c * np.log(far + root), 0.0)
    return np.asarray(-np.diff(risen, axis=1) @ (slopes / edges[1]))
