"""A ball with attraction of long range that only adds to the force (DMT), as a law for other programs."""

from __future__ import annotations

import math

import numpy as np

from winkler.exporting.laws.normal import force_table, normal_notes
from winkler.exporting.laws.particle import ball_of, checked_depth
from winkler.exporting.step_law import LawTable, StepLaw, StepNumber
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.particles.table_step import step_attracted

MOTION = (StepNumber("depth", "m", "d at the end of the step, not positive without contact"),)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive; attraction included while the bodies touch"),
    StepNumber("stiffness", "N/m", "dF/dd"),
    StepNumber("energy", "J", "elastic energy less the work of the attraction, the integral of the force"),
)
SEED = 20260829


def attracted_law(problem: AdhesiveCycle, work: float, tolerance: float, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of Derjaguin, Muller and Toporov: F = F_Hertz - 2 pi R w while the bodies touch.

    Raises
    ------
    InvalidInput
        If the contact is no ball on a homogeneous half-space, or its depths are not stated.
    """
    deepest = checked_depth(problem)
    radius, _ = ball_of(problem.bed)
    tables, error = force_table(problem.bed, deepest, tolerance)
    strength = 2.0 * math.pi * radius * work
    pull = LawTable("pull", "attraction 2 pi R w while the bodies touch [N]", np.array([strength]), falling=(0,))
    notes = (*normal_notes(error), *map(str, problem.solve().validity))
    trial = deepest * np.append(np.random.default_rng(SEED).uniform(-0.1, 1.0, 40), [0.0, 1.0, 1e-6])
    title = "A ball with attraction of long range, by Derjaguin, Muller and Toporov: no hysteresis"
    return StepLaw(title, step_attracted, (*tables, pull), (), MOTION, ANSWER, notes, inputs, trial[:, np.newaxis])
