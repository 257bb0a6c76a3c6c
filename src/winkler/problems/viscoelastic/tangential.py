r"""A viscoelastic contact that is pressed and moved along the surface, with friction: springs relax in both directions.

Every spring relaxes across and along the surface,

.. math:: q_z = \int E^*(t-t')\,\mathrm du_z(t'), \qquad q_x = \int G^*(t-t')\,\mathrm du_x(t'), \qquad
          |q_x|\le\mu q_z ,

moves with the body while it sticks, slides on its bound, and recovers freely in both directions once it has let go.
All the work is stored, lost to friction, or lost in the bodies.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.foundation.torsion_bound import twist_bound
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Depth, Shift
from winkler.loading.path import Path
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.media.twisting.kernels import twisted_medium
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.times import path_notes
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.ring_slip.push_bound import exact_ratio, layers_of_rings, push_bound
from winkler.problems.ring_slip.push_notes import push_note, tables_note
from winkler.problems.round_march import RoundSlip
from winkler.problems.row import Reached, follow
from winkler.problems.viscoelastic.dragged_cells import DragCells, ring_cells, spring_cells
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.layered_drag import DraggedLayers, LayeredDrag, dragged_layers, refuse_unknown_waves
from winkler.problems.viscoelastic.layered_path import is_layered
from winkler.problems.viscoelastic.march import SpringRow, elastic_like, refuse_rings, relaxation_of
from winkler.problems.viscoelastic.tangential_march import (
    DraggedRow,
    DraggedSprings,
    DragGoal,
    ErrorScales,
    shear_relaxation,
    twist_relaxation,
)
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class DraggedCells:
    """What a dragged viscoelastic contact has at one moment, of whatever motion; arrays by cell, ``(n,)``.

    Parameters
    ----------
    stick_radius : float
        Up to which all springs stick [m]: a where all do, zero where that on the axis slides.
    friction_loss, bulk_loss : float
        Lost since the beginning to friction, and in the dashpots of the bodies [J].
    position : ndarray, (n,)
        Places x of the springs [m].
    line_load, shear_load : ndarray, (n,)
        q_z and q_x [N/m].
    recess, displacement : ndarray, (n,)
        How far every spring is pressed in, and displaced along the surface [m], or has not yet recovered.
    sticking : ndarray, (n,)
        Which springs stick.
    """

    __words__ = words(displacement=("u_t", "m", "displacement of every spring along the surface"))

    stick_radius: float
    friction_loss: float
    bulk_loss: float
    position: Array
    line_load: Array
    shear_load: Array
    recess: Array
    displacement: Array
    sticking: Array


@value
class DraggedState(DraggedCells, RoundSlip[float]):
    """A dragged viscoelastic contact at one moment; its numbers are those of `RoundSlip` and `DraggedCells`."""

    __words__ = words(stored_energy=("U", "J", "energy stored in all springs, both directions"))


class Relaxed:
    """The part of a solution that has the two losses of bodies that relax."""

    problem: Any
    states: Any

    @property
    def friction_loss(self) -> Array:
        """Lost to friction since the beginning by bodies that relax [J], ``(steps,)``.

        Raises
        ------
        OutsideValidity
            If the bodies are elastic.
        """
        return self._known("friction_loss")

    @property
    def bulk_loss(self) -> Array:
        """Lost since the beginning in the dashpots of bodies that relax [J], ``(steps,)``.

        Raises
        ------
        OutsideValidity
            If the bodies are elastic.
        """
        return self._known("bulk_loss")

    def _known(self, name: str) -> Array:
        """Return a number that only rings, or only bodies that relax, have."""
        if not all(hasattr(state, name) for state in self.states):
            who = type(self.problem).__name__
            raise OutsideValidity(f"{who}: {name} is not known of this method and medium; leave it out.")
        return np.array([getattr(state, name) for state in self.states])


def pressed_alone(owner: str, bed: Bed, path: Path, count: int, tolerance: float) -> ViscoelasticIndentation:
    """Return the contact without friction; refuse what is not followed along the surface.

    Raises
    ------
    InvalidInput
        If the medium does not relax by one function of time, or a force is tensile.
    OutsideValidity
        If what rings bear, or the ratio of the stiffnesses, is not known.
    """
    if is_layered(owner, bed, count):
        refuse_unknown_waves(bed, twisted=owner == "Torsion")
        return ViscoelasticIndentation(bed, Path(path.time, path.normal), count, tolerance)
    relaxation_of(owner, bed)
    if owner == "Torsion":
        twisted_medium(elastic_like(bed).medium)
    return ViscoelasticIndentation(bed, Path(path.time, path.normal), count, tolerance)


def dragged_states(bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float) -> Iterator[DraggedState]:
    """Yield the state at every point of a path, as of `dragged`."""
    if is_layered("Tangential", bed):
        for layers, cells in dragged_layers("Tangential", bed, law, path, count, tolerance):
            yield DraggedState(shift=cells.motion, shear_force=cells.load, **layered_columns(layers, cells))
        return
    for row, reached in dragged("Tangential", bed, law, path, count, tolerance):
        state = reached.state
        yield DraggedState(shift=state.shift, shear_force=state.shear_force, **columns(row, reached))


def dragged(
    owner: str, bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float
) -> Iterator[tuple[DraggedRow, Reached[DraggedSprings]]]:
    """Yield the row and where it is at every point of a path.

    Before the first point of the path nothing has happened; what is not zero there comes suddenly, the normal load
    first.

    Parameters
    ----------
    owner : str
        Kind of problem.
    bed : Bed
    law : Coulomb
    path : Path
    count : int
        How many springs; the error falls with its square, or with itself where the load does not vanish at the edge:
        where nothing slides, or with a dashpot alongside.
    tolerance : float
        Error of a step: of the shear force over what friction can bear, of the energy lost to friction over that force
        times the greatest shift, and of depth and shift under prescribed forces over the greatest ones.

    Raises
    ------
    OutsideValidity
        If the body is pressed beyond what is known of its profile, is moved suddenly against a dashpot, friction does
        not bear a prescribed shear force, or the contact is no disc: at that step, the states before it have been
        yielded.
    NotConverged
        If no step is short enough.
    """
    row = dragged_row(owner, bed, law, path, count, tolerance)
    goals = map(DragGoal, path.time.tolist(), path.across.tolist(), path.along.tolist())
    for reached in follow(row, goals):
        refuse_rings(owner, np.array([reached.state.goal.time]), np.array([reached.state.ring]))
        yield row, reached


def columns(row: DraggedRow, reached: Reached[DraggedSprings]) -> dict[str, Any]:
    """Return what a state holds, by the names of its fields."""
    (state, work, lost), cells = reached, row.cells
    springs, slack = state.row, state.bounds - np.abs(state.loads)
    return {
        "time": state.goal.time,
        "depth": springs.depth,
        "force": state.force,
        "radius": state.radius,
        "work": work,
        "stored_energy": state.stored,
        "dissipation": lost,
        "stick_radius": stick_radius(cells.place, state.stuck, slack, state.radius),
        "friction_loss": state.friction,
        "bulk_loss": state.bulk,
        "position": cells.place,
        "line_load": cells.density * springs.loads()[cells.under],
        "shear_load": cells.lever * state.loads,
        "recess": springs.place[cells.under],
        "displacement": state.displaced * (cells.place if cells.motion == "Angle" else 1.0),
        "sticking": state.stuck,
    }


def layered_columns(row: LayeredDrag, cells: DraggedLayers) -> dict[str, Any]:
    """Return what a state of layers that relax each by a law of its own holds, by the names of its fields."""
    point, load = cells.pressed, cells.dragged.load
    time, depth, force, radius, work, _, lost = point.numbers()
    stuck, part = cells.slips == 0.0, 2.0 if row.twisted else 1.0
    return {
        "time": time,
        "depth": depth,
        "force": force,
        "radius": radius,
        "work": work + cells.work,
        "stored_energy": row.stored(cells),
        "dissipation": lost + cells.friction + cells.bulk,
        "stick_radius": stick_radius(row.place, stuck, cells.bounds - np.abs(load), radius),
        "friction_loss": cells.friction,
        "bulk_loss": lost + cells.bulk,
        "position": row.place,
        "line_load": point.state.load,
        "shear_load": part * load,
        "recess": row.cells.displacement(point.state),
        "displacement": row.along.displacement(cells.dragged) / part,
        "sticking": stuck,
    }


def dragged_row(
    owner: str,
    bed: Bed,
    law: Coulomb,
    path: Path,
    count: int,
    tolerance: float,
    course: Callable[[float], DragGoal] | None = None,
) -> DraggedRow:
    """Return the row before anything has happened, which knows what counts as little on this path.

    Parameters
    ----------
    owner, bed, law, path, count, tolerance
        As of `dragged`.
    course : callable, optional
        What is prescribed at a time, as of `DraggedRow`.
    """
    deepest = pressed_alone(owner, bed, path, count, tolerance)._deepest
    if deepest == 0.0:
        raise OutsideValidity(f"{owner}: the bodies never touch along this path; press them.")
    elastic = elastic_like(bed)
    reach = float(at_depth(elastic, np.array([deepest]))[1][0])
    springs = Springs.of(elastic, reach, count)
    normal, (cells, shear) = relaxation_of(owner, bed), _cells(owner, bed, springs, count)
    by_depth, by_shift = isinstance(path.normal, Depth), isinstance(path.lateral, Shift | Angle)
    # the greatest stiffness of the springs: glassy, or as they are within the time that the path takes
    quick = 1.0 / max(float(path.time[-1] - path.time[0]), 1e-300)
    hard, stiff = (
        series.glassy if math.isfinite(series.glassy) else float(abs(series.dynamic(np.array(quick))))
        for series in (normal, shear)
    )
    pressed = springs.force(deepest)
    force = hard * pressed if by_depth else float(np.max(path.across))
    along = float(np.max(np.abs(path.along), initial=0.0))
    whole = stiff * float(np.sum(cells.weights))
    slide_ = along if by_shift else along / whole
    rubbed = force * float(cells.weights @ cells.bounds(np.maximum(deepest - springs.gap, 0.0))) / pressed
    borne = min(law.coefficient * rubbed, whole * slide_) if law.coefficient > 0.0 else 0.0
    borne = borne if borne > 0.0 else rubbed
    slide_ = slide_ if slide_ > 0.0 else deepest * rubbed / force
    little = tolerance
    scales = ErrorScales(little * deepest, little * slide_, little * borne, little * borne * slide_, force)
    row = SpringRow(elastic, springs, normal)
    return DraggedRow(row, cells, shear, law.coefficient, by_depth, by_shift, scales, course)


def _cells(owner: str, bed: Bed, springs: Springs, count: int) -> tuple[DragCells, RelaxationSeries]:
    """Return what is dragged, and by which function it relaxes."""
    elastic, medium, reach = elastic_like(bed), bed.medium, float(springs.position[-1])
    if owner == "Torsion":
        body = twisted_medium(elastic.medium)
        if isinstance(medium, ViscoelasticHalfSpace):
            series = twist_relaxation(medium)
        else:
            series = relaxation_of(owner, bed).scaled(8.0 * body.torsional_modulus)
        return ring_cells(twist_bound(elastic, 1.0, reach, False), springs, count), series
    if isinstance(medium, ViscoelasticHalfSpace):
        return spring_cells(elastic, springs), shear_relaxation(medium, bed.footprint.shear_share)
    layers, series = layers_of_rings(elastic), relaxation_of(owner, bed)
    if layers is not None:
        return ring_cells(push_bound(elastic, 1.0, reach, False), springs, count), series.scaled(layers.shear_modulus)
    ratio = exact_ratio(owner, elastic, reach)
    return spring_cells(elastic, springs), series.scaled(ratio)


def stick_radius(position: Array, stuck: Array, slack: Array, radius: float) -> float:
    """Return up to where all springs stick [m].

    Parameters
    ----------
    position : ndarray, (n,)
        Places of the springs [m].
    stuck : ndarray, (n,)
        Which of them stick.
    slack : ndarray, (n,)
        What they could bear more than they do; it vanishes in a straight line at the edge.
    radius : float
        a [m].
    """
    moving = np.flatnonzero(~stuck)
    first = int(moving[0]) if moving.size else position.size
    if first == 0 or position[first - 1] >= radius:
        return radius if first else 0.0
    edge = 0.5 * (position[first - 1] + position[min(first, position.size - 1)])
    if first > 1 and math.isfinite(slack[first - 2]) and slack[first - 2] > slack[first - 1]:
        fall = (slack[first - 2] - slack[first - 1]) / (position[first - 1] - position[first - 2])
        edge = min(position[first - 1] + slack[first - 1] / fall, position[min(first, position.size - 1)])
    return float(min(edge, radius))


def dragged_notes(bed: Bed, law: Coulomb, time: Array, depth: Array, radius: Array) -> tuple[Note, ...]:
    """Return how far a path of states can be trusted.

    Parameters
    ----------
    bed : Bed
    law : Coulomb
    time, depth, radius : ndarray, (steps,)
        t [s], d [m], a [m].
    """
    elastic, widest = elastic_like(bed), float(np.max(radius))
    if is_layered("validity", bed):
        slip: tuple[Note, ...] = (LAYERED,)
    elif layers_of_rings(elastic) is None:
        slip = (CATTANEO,)
    else:
        slip = push_note(elastic, widest), *tables_note(push_bound(elastic, 1.0, widest, False))
    return (
        *bed.notes,
        *slip,
        sticking_note(bed.medium, law.coefficient),
        *direction_notes(bed),
        *path_notes(bed.medium, time),
        *contact_notes(elastic, depth, radius),
        *relaxing_yield(bed.medium),
    )


LAYERED = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are assumed parallel to the motion, and both directions independent (Cattaneo-Mindlin). Each "
    "element along the radius sticks or slips at the end of every step. For very fast and very slow motion the layers "
    "are elastic. Compared with annular elements on these elastic layers, shear forces and torques differ by at most "
    "0.15 % of their maximum, frictional losses by at most 1.2 %.",
    "tests/problems/viscoelastic/test_dragged_layers.py",
)
CATTANEO = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are assumed parallel to the motion, and both directions independent (Cattaneo-Mindlin). Slip of "
    "each spring is decided at the end of every step.",
    "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973",
)
