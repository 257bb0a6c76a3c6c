"""A body of revolution that is pushed with friction, in the plane, as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.laws.normal import force_table, normal_notes
from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import EllipticOutline
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import coefficient_of, sticking_note
from winkler.problems.friction.spring_states import spring_notes
from winkler.problems.friction.tangential import Tangential
from winkler.problems.normal.indentation import Indentation
from winkler.problems.particles.sheared_step import step_sheared
from winkler.values.errors import InvalidInput

MOTION = (
    StepNumber("depth", "m", "d at the end of the step, not positive without contact"),
    StepNumber("motion_x", "m", "by which the bodies move along the surface in the step", True),
    StepNumber("motion_y", "m", "the same across", True),
)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("stiffness", "N/m", "dF/dd"),
    StepNumber("shear_x", "N", "shear force that moves the bodies along the motion"),
    StepNumber("shear_y", "N", "the same across"),
    StepNumber("energy", "J", "elastic energy of pressing"),
    StepNumber("stored_energy", "J", "elastic energy of the springs along the surface"),
    StepNumber("dissipation", "J", "heat since the beginning; never falls"),
)
STEPS, SEED = 60, 20260726


def sheared_law(problem: Tangential, tolerance: float, count: int, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of a contact with friction, up to the deepest point of the path of the problem.

    Parameters
    ----------
    problem : Tangential
    tolerance : float
        Error of the normal force, over the greatest.
    count : int
        How many springs.
    inputs : tuple of str

    Raises
    ------
    InvalidInput
        If the contact is no disc, or the friction a law of one's own.
    """
    bed, friction = problem.bed, problem.law
    if isinstance(bed.footprint, EllipticOutline) or isinstance(bed, DirectionalBed):
        raise InvalidInput("export: this contact yields differently along and across; export a contact that is a disc.")
    if not isinstance(friction, Coulomb | StaticKinetic):
        raise InvalidInput(
            f"export: friction by {type(friction).__name__} is a function of Python; give Coulomb or StaticKinetic."
        )
    pressed = problem.normal
    deepest = float(np.max(pressed.depth))
    tables, error = force_table(bed, deepest, tolerance)
    springs = Springs.of(bed, float(np.max(pressed.radius)), count)
    match friction:
        case StaticKinetic(static, kinetic):
            hold = static / kinetic
        case _:
            hold, kinetic = 1.0, friction.coefficient
    slopes = np.cumsum(springs.stiffness)
    own = (
        LawTable("gap", "g of the springs [m]", springs.gap),
        LawTable("shear", "tangential stiffness of the springs [N/m]", springs.tangential_stiffness),
        LawTable(
            "slope", "how far a slipping spring is displaced over its compression", kinetic / springs.mindlin_ratio
        ),
        LawTable("hold", "static over kinetic friction", np.array([hold])),
        LawTable("corners", "force when each spring just touches [N]", _corners(springs, slopes)),
        LawTable("slopes", "stiffness from there on [N/m]", slopes),
    )
    n = springs.gap.size
    state = (
        StatePart("displaced", "springs along the surface [m]", np.zeros((2, n))),
        StatePart("slips", "whether each slips", np.zeros(n, dtype=bool)),
        StatePart("past", "the springs' depth before the step [m], heat so far [J]", np.zeros(2)),
        StatePart("bound", "work space", np.zeros((2, n))),
        StatePart("ends", "work space", np.zeros(2)),
        StatePart("shift", "work space", np.zeros((2, 2))),
        StatePart("borne", "work space", np.zeros((1, 2))),
        StatePart("stored", "work space", np.zeros(1)),
        StatePart("lost", "work space", np.zeros(1)),
    )
    notes = (
        *normal_notes(error),
        *map(str, Indentation(bed, Depth(deepest)).solve().validity),
        str(sticking_note(bed.medium, coefficient_of(friction))),
        *map(str, spring_notes(springs, friction, in_plane=True)),
    )
    title = "A contact of a body of revolution with friction: springs that stick and slip in the plane"
    most = kinetic / float(np.min(springs.mindlin_ratio)) * deepest
    return StepLaw(title, step_sheared, (*tables, *own), state, MOTION, ANSWER, notes, inputs, _trial(deepest, most))


def _corners(springs: Springs, slopes: Array) -> Array:
    """Return the normal force when every spring just touches [N]."""
    return np.concatenate([[0.0], np.cumsum(slopes[:-1] * np.diff(springs.gap))])


def _trial(deepest: float, most: float) -> Array:
    """Return motions that stick, slip, part and touch again."""
    rng = np.random.default_rng(SEED)
    depth = deepest * np.clip(0.5 + 0.6 * np.cumsum(rng.normal(scale=0.25, size=STEPS)), -0.2, 1.0)
    depth[20:25] = depth[20]
    return np.column_stack([depth, rng.normal(scale=0.4 * most, size=(STEPS, 2))])
