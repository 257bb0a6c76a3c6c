r"""A viscoelastic contact that is pressed and moved along the surface, with friction: springs relax in both directions.

Every spring relaxes across and along the surface,

.. math:: q_z = \int E^*(t-t')\,\mathrm du_z(t'), \qquad q_x = \int G^*(t-t')\,\mathrm du_x(t'), \qquad
          |q_x|\le\mu q_z ,

moves with the body while it sticks, slides on its bound, and recovers freely in both directions once it has let go.
All the work is stored, lost to friction, or lost in the bodies.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.times import path_notes
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.round_march import RoundSlip
from winkler.problems.row import follow
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import SpringRow, elastic_like, refuse_rings, relaxation_of
from winkler.problems.viscoelastic.tangential_march import DraggedRow, DragGoal, ErrorScales, shear_relaxation
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["DraggedState", "dragged_notes", "dragged_states", "pressed_alone", "stick_radius"]


@value
class DraggedState(RoundSlip[float]):
    """A dragged viscoelastic contact at one moment; its numbers are those of `RoundSlip`.

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

    __words__ = words(
        stored_energy=("U", "J", "energy stored in all springs, both directions"),
        displacement=("u_t", "m", "displacement of every spring along the surface"),
    )

    stick_radius: float
    friction_loss: float
    bulk_loss: float
    position: Array
    line_load: Array
    shear_load: Array
    recess: Array
    displacement: Array
    sticking: Array


def pressed_alone(bed: Bed, path: Path, count: int, tolerance: float) -> ViscoelasticIndentation:
    """Return the contact without friction; refuse what is not followed along the surface.

    Raises
    ------
    InvalidInput
        If the medium is no viscoelastic half-space, or a force is tensile.
    """
    if not isinstance(bed.medium, ViscoelasticHalfSpace):
        raise InvalidInput(
            f"Tangential: the bed stands on a {type(bed.medium).__name__}, and slip of bodies that relax is followed "
            "by one ratio of tangential to normal stiffness and one relaxation, which homogeneous bodies have; give "
            "Foundation(profile, ViscoelasticHalfSpace(solid))."
        )
    return ViscoelasticIndentation(bed, Path(path.time, path.normal), count, tolerance)


def dragged_states(bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float) -> Iterator[DraggedState]:
    """Yield the state at every point of a path.

    Before the first point of the path nothing has happened; what is not zero there comes suddenly, the normal load
    first.

    Parameters
    ----------
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
    row = _row(bed, law, path, count, tolerance)
    density = row.row.springs.density(row.row.bed)
    goals = map(DragGoal, path.time.tolist(), path.across.tolist(), path.along.tolist())
    for state, work, lost in follow(row, goals):
        time, springs = state.goal.time, state.row
        refuse_rings("Tangential", np.array([time]), np.array([state.ring]))
        place = springs.springs.position
        slack = state.bounds - np.abs(state.loads)
        yield DraggedState(
            time, springs.depth, state.force, state.radius, state.shift, state.shear_force, work, state.stored, lost,
            stick_radius(place, state.stuck, slack, state.radius), state.friction, state.bulk, place,
            density * springs.loads(), density * state.loads, springs.place, state.displaced, state.stuck,
        )  # fmt: skip


def _row(bed: Bed, law: Coulomb, path: Path, count: int, tolerance: float) -> DraggedRow:
    """Return the row before anything has happened, which knows what counts as little on this path."""
    deepest = pressed_alone(bed, path, count, tolerance)._deepest
    if deepest == 0.0:
        raise OutsideValidity("Tangential: the bodies never touch along this path; press them.")
    elastic, medium = elastic_like(bed), bed.medium
    assert isinstance(medium, ViscoelasticHalfSpace)
    _, reach = at_depth(elastic, np.array([deepest]))
    springs = Springs.of(elastic, float(reach[0]), count)
    normal, shear = relaxation_of("", bed), shear_relaxation(medium, bed.footprint.shear_share)
    by_depth, by_shift = isinstance(path.normal, Depth), isinstance(path.lateral, Shift)
    # the greatest stiffness of the springs: glassy, or as they are within the time that the path takes
    quick = 1.0 / max(float(path.time[-1] - path.time[0]), 1e-300)
    hard, stiff = (
        series.glassy if math.isfinite(series.glassy) else float(abs(series.dynamic(np.array(quick))))
        for series in (normal, shear)
    )
    force = hard * springs.force(deepest) if by_depth else float(np.max(path.across))
    along = float(np.max(np.abs(path.along), initial=0.0))
    whole = stiff * float(np.sum(springs.stiffness))
    slide_ = along if by_shift else along / whole
    borne = min(law.coefficient * force, whole * slide_) if law.coefficient > 0.0 else 0.0
    borne = borne if borne > 0.0 else force
    slide_ = slide_ if slide_ > 0.0 else deepest
    little = tolerance
    scales = ErrorScales(little * deepest, little * slide_, little * borne, little * borne * slide_, force)
    return DraggedRow(SpringRow(elastic, springs, normal), shear, law.coefficient, by_depth, by_shift, scales)


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
    return (
        *bed.notes,
        CATTANEO,
        sticking_note(bed.medium, law.coefficient),
        *direction_notes(bed),
        *path_notes(bed, time),
        *contact_notes(elastic_like(bed), depth, radius),
        *relaxing_yield(bed.medium),
    )


CATTANEO = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are taken parallel to the motion and the directions as independent (Cattaneo-Mindlin); "
    "sliding is decided spring by spring at the end of every step.",
    "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973",
)
