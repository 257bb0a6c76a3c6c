r"""A viscoelastic contact that is pressed and twisted, with friction: the cells of a twist relax as they are dragged.

What sticks bears :math:`q(x,t) = x\int 8\,G_t(t-t')\,\mathrm d\varphi(t')`; what slides bears what the pressure of all
rings farther out allows, as in elastic bodies (`winkler.problems.viscoelastic.dragged_cells`).  The row is that of
`winkler.problems.viscoelastic.tangential`, with the angle in the place of the shift.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import twist_bound
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.numerics.types import Array
from winkler.problems.assumptions.times import path_notes
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.ring_slip.twisted_layers import twisted_layer_notes
from winkler.problems.round_march import RoundTwist
from winkler.problems.viscoelastic.layered_drag import dragged_layers
from winkler.problems.viscoelastic.layered_path import is_layered
from winkler.problems.viscoelastic.march import elastic_like
from winkler.problems.viscoelastic.tangential import DraggedCells, columns, dragged, layered_columns
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class DraggedTwist(DraggedCells, RoundTwist[float]):
    """A twisted viscoelastic contact at one moment; its numbers are those of `RoundTwist` and `DraggedCells`.

    Parameters
    ----------
    nested : bool
        Whether all that slides at this moment is one outer ring, and slides to one side.
    """

    __words__ = words(stored_energy=("U", "J", "energy stored in all springs, across and around"))

    nested: bool


def dragged_twists(bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float) -> Iterator[DraggedTwist]:
    """Yield the state at every point of a path, as of `winkler.problems.viscoelastic.tangential.dragged`."""
    if is_layered("Torsion", bed):
        for layers, cells in dragged_layers("Torsion", bed, law, path, count, tolerance):
            limit, nested = float(layers.weights @ cells.bounds), _outer(cells.bounds, cells.slips)
            own = layered_columns(layers, cells)
            yield DraggedTwist(angle=cells.motion, torque=cells.load, torque_limit=limit, nested=nested, **own)
        return
    for row, reached in dragged("Torsion", bed, law, path, count, tolerance):
        state = reached.state
        yield DraggedTwist(
            angle=state.shift,
            torque=state.shear_force,
            torque_limit=float(row.cells.weights @ state.bounds),
            nested=_outer(state.bounds, np.where(state.stuck, 0.0, np.sign(state.loads))),
            **columns(row, reached),
        )


def _outer(bounds: Array, slips: Array) -> bool:
    """Return whether what slides is one outer ring, and slides to one side: -1, 0 or 1 of each cell ``(n,)``."""
    touching = bounds > 0.0
    sliding = touching & (slips != 0.0)
    outer = np.flatnonzero(touching)[-int(np.sum(sliding)) :] if np.any(sliding) else np.zeros(0, dtype=int)
    return bool(np.all(sliding[outer])) and np.unique(slips[sliding]).size < 2


def dragged_twist_notes(bed: Bed, states: Sequence[DraggedTwist]) -> tuple[Note, ...]:
    """Return how far the states of a path can be trusted.

    Parameters
    ----------
    bed : Bed
    states : sequence of DraggedTwist
    """
    time, depth, radius = (np.array([getattr(state, word) for state in states]) for word in ("time", "depth", "radius"))
    nested = all(state.nested for state in states)
    layers = is_layered("validity", bed)
    alike = "" if layers else ", and all bodies have one common relaxation function"
    statement = (
        f"Torsion of a round contact and its normal load are uncoupled{alike}. For small rotations the springs are "
        "equal to the three-dimensional solution, as long as the slip zone is an outer annulus. This "
        + ("is the case at every point of the path" if nested else "is not the case at every point of the path")
        + f". Slip of each of the {states[-1].position.size} springs is decided at the end of every step."
    )
    elastic, widest = elastic_like(bed), float(np.max(radius))
    return (
        *bed.notes,
        Note(Assumption.SLIP, Standing.ASYMPTOTIC if nested else Standing.APPROXIMATE, statement, JAEGER),
        *(() if layers else twisted_layer_notes(elastic, widest, twist_bound(elastic, 1.0, widest, False))),
        *path_notes(bed.medium, time),
        *contact_notes(elastic, depth, radius),
        *relaxing_yield(bed.medium),
    )


JAEGER = "J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"
