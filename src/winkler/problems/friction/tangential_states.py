"""What a sheared contact is at one point of its path, and how far that can be trusted."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings, slipping_springs
from winkler.foundation.sheared import ShearedSprings
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.numerics.types import Array, Quantity
from winkler.problems.assumptions.coupling import coefficient_of, sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.friction.pushed import PushedState
from winkler.problems.friction.sheared_springs import sheared_by_pieces
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.spring_states import SpringLaw, SpringState, spring_notes
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction, slid_depth
from winkler.problems.round_march import RoundSlip
from winkler.problems.row import CURVED_STEP_TOLERANCE
from winkler.problems.viscoelastic.tangential import DraggedState
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

MINDLIN = (
    "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973; J. Jaeger, Arch. Appl. Mech. 65 (1995) "
    "478-487, doi:10.1007/BF00835661"
)
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sect. 7.2, doi:10.1017/CBO9781139171731"
LEAST_ANGLE = 1e-9
"""Angle [degrees] that is rounding."""


@value
class TangentialState(RoundSlip[float]):
    """The contact at one point of the path; its numbers are those of `RoundSlip`.

    Parameters
    ----------
    bed : Bed
        The springs.
    law : Coulomb
        Law of friction.
    mindlin_ratio : float
        c_T/c_N [-], the same for all springs.
    memory : SlipMemory
        What the springs remember.
    """

    __words__ = words(sliding=("", None, "whether all springs in contact slide"))

    bed: Bed
    law: Coulomb
    mindlin_ratio: float
    memory: SlipMemory

    @property
    def stick_radius(self) -> float:
        """Radius c within which nothing slides [m]; a where all sticks, zero where all slides."""
        return float(_stick_radii(self.bed, np.array([self.memory.stick_gap]), self.memory.depth, self.radius)[0])

    @property
    def sliding(self) -> bool:
        """Whether the bodies slide: every spring in contact does."""
        return self.radius > 0.0 and self.memory.stick_gap == 0.0

    @property
    def pressed(self) -> PressedSprings:
        """The springs' displacement across the surface."""
        return PressedSprings(self.bed, self.depth, self.radius)

    @property
    def sheared(self) -> ShearedSprings:
        """The springs' displacement along the surface, as a sum of earlier contacts: fields are restored from it."""
        memory = self.memory
        bed = slipping_springs(self.bed)
        return sheared_by_pieces(bed, memory.depth, self.shift, memory.edges, memory.left, memory.right)


def stick_radii(bed: Bed, states: Sequence[TangentialState | SpringState | PushedState | DraggedState]) -> Array:
    """Return the stick radii of many states of one bed [m], (steps,)."""
    ours = [state for state in states if isinstance(state, TangentialState)]
    if len(ours) < len(states):
        return np.array([state.stick_radius for state in states])
    gaps, depths, radii = (
        np.array(column) for column in zip(*((s.memory.stick_gap, s.memory.depth, s.radius) for s in ours), strict=True)
    )
    return _stick_radii(bed, gaps, depths, radii)


def _stick_radii(bed: Bed, gaps: Array, depth: Quantity, radius: Quantity) -> Array:
    """Return where springs of given gaps stand [m], within contacts of given depth and radius; zero for no gap."""
    inner = (gaps > 0.0) & (gaps < depth)
    distinct, where = np.unique(np.where(inner, gaps, 0.0), return_inverse=True)
    return np.where(inner, at_depth(slipping_springs(bed), distinct)[1][where], np.where(gaps > 0.0, radius, 0.0))


def friction_notes(
    bed: Bed,
    law: SpringLaw,
    depth: Array,
    force: Array,
    shear_force: Array,
    radius: Array,
    last: TangentialState | SpringState,
) -> tuple[Note, ...]:
    """Return how far a sheared contact can be trusted.

    Parameters
    ----------
    bed : Bed
    law : Coulomb, StaticKinetic or OwnLaw
    depth, force, shear_force, radius : ndarray, (steps,)
        [m], [N], [N], [m]; the shear force also in the plane, ``(steps, 2)``.
    last : TangentialState or SpringState
        The last state of the path.
    """
    rubbing = _rubbing(law, depth, force, shear_force)
    notes = [*indentation_notes(bed, depth, radius, rubbing), sticking_note(bed.medium, coefficient_of(law))]
    notes += direction_notes(bed)
    if isinstance(last, SpringState):
        notes += spring_notes(last.springs, law, in_plane=np.ndim(last.shift) == 1)
    else:
        notes.append(EXACT)
    medium = bed.medium
    if isinstance(medium, HalfSpace):
        poisson = max(body.poisson for body in (medium.first, medium.second) if isinstance(body, Elastic))
        notes += _deviation_notes(poisson, "Poisson's ratio")
    elif isinstance(medium, HomogeneousMedium):
        poisson = 2.0 - 4.0 * medium.torsional_modulus / medium.shear_modulus
        notes += _deviation_notes(poisson, "an effective Poisson's ratio 2 - 4 G_t/G* =")
    return tuple(notes)


def _deviation_notes(poisson: float, name: str) -> list[Note]:
    """Return how far slip deviates from the shear force; nothing where waves along and across it are equally stiff."""
    angle = np.degrees(abs(poisson / (4.0 - 2.0 * poisson)))
    if angle < LEAST_ANGLE:
        return []
    statement = (
        f"Slip is assumed parallel to the shear force. With {name} {poisson:.3g} the true direction deviates by "
        f"up to about {angle:.2g} degrees. The error of the forces is of second order in this angle."
    )
    return [Note(Assumption.SLIP, Standing.ASYMPTOTIC, statement, JOHNSON)]


def _rubbing(law: SpringLaw, depth: Array, force: Array, shear_force: Array) -> SurfaceFriction:
    match law:
        case Coulomb(coefficient):
            most = kinetic = coefficient
        case StaticKinetic(static, kinetic):
            most = static
        case _:
            return SurfaceFriction(math.inf)
    return SurfaceFriction(most, slid_depth(kinetic, depth, force, shear_force), kinetic)


EXACT = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "One direction of motion: springs of equal gap stick and slip together. Every history of depth and "
    "displacement is solved within rounding under the Cattaneo-Mindlin assumption (tractions parallel to the "
    "motion). If a prescribed force curves the path between two points, the springs are followed within "
    f"{CURVED_STEP_TOLERANCE:.0e} of the maximum displacement.",
    MINDLIN,
)
