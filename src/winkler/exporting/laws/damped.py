"""A body of revolution on a solid of springs and dashpots side by side (Kelvin, Voigt), as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.laws.normal import force_table, normal_notes
from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.foundation.bed import Bed
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.types import Array
from winkler.problems.particles.damped_step import step_damped
from winkler.problems.viscoelastic.march import elastic_like

MOTION = (
    StepNumber("depth", "m", "d at the end of the step, not positive without contact"),
    StepNumber("duration", "s", "of the step, at a steady rate; zero for the force at rest"),
)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive; it never pulls"),
    StepNumber("energy", "J", "elastic energy at this depth; for separated springs until they have recovered"),
    StepNumber("dissipation", "J", "heat since the beginning; never falls"),
)
STEPS, SEED = 60, 20261123
RECOVERY = (
    "Springs that have let go recover freely; that the body may catch them while it leaves more slowly than before is "
    "left out, and a surface that is touched again has recovered."
)


def damped_law(
    bed: Bed,
    series: RelaxationSeries,
    deepest: float,
    tolerance: float,
    notes: tuple[str, ...],
    inputs: tuple[str, ...],
) -> StepLaw:
    """Return the law of a contact whose solid relaxes by a dashpot alongside alone, up to a depth.

    Parameters
    ----------
    bed : Bed
    series : RelaxationSeries
        A modulus and a viscosity, no other terms.
    deepest : float
        [m].
    tolerance : float
        Error of the force at rest, over the greatest.
    notes, inputs : tuple of str
    """
    tables, error = force_table(elastic_like(bed), deepest, tolerance)
    rest = tuple(
        table if table.name == "depth" else table._replace(numbers=series.relaxed * table.numbers) for table in tables
    )
    delay = series.viscosity / series.relaxed
    own = LawTable("delay", "viscosity over modulus [s]", np.array([delay]))
    state = (StatePart("past", "depth before the step [m], heat so far [J]", np.zeros(2)),)
    return StepLaw(
        "A body of revolution on a solid of springs and dashpots side by side: it damps, and never pulls",
        step_damped, (*rest, own), state, MOTION, ANSWER, (*normal_notes(error), RECOVERY, *notes), inputs,
        _trial(deepest, delay),
    )  # fmt: skip


def _trial(deepest: float, delay: float) -> Array:
    """Return depths and durations: press, hold, leave fast and slowly, touch again."""
    rng = np.random.default_rng(SEED)
    depth = deepest * np.clip(0.4 + 0.5 * np.sin(np.linspace(0.0, 12.0, STEPS)) + 0.1 * rng.normal(size=STEPS), -0.5, 1)
    depth[20:23] = depth[20]
    return np.column_stack([depth, delay * rng.uniform(0.1, 3.0, STEPS)])
