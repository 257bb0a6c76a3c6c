"""A body of revolution on one that relaxes, as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.laws.damped import damped_law
from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.loading.loads import Depth
from winkler.numerics.springs.relaxing_springs import STEP_NUMBERS
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.viscoelastic.impact import ViscoelasticImpact
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import SpringRow, elastic_like, relaxation_of
from winkler.problems.viscoelastic.relaxing_step import step_relaxing
from winkler.values.errors import InvalidInput

MOTION = (
    StepNumber("depth", "m", "d at the end of the step, not positive without contact"),
    StepNumber("duration", "s", "of the step, at a steady rate; zero for a sudden one"),
)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("radius", "m", "contact radius, zero without contact"),
    StepNumber("work", "J", "spent since the beginning"),
    StepNumber("stored_energy", "J", "of all springs, also of those that recover freely"),
    StepNumber("dissipation", "J", "lost in the dashpots since the beginning; never falls"),
    StepNumber(
        "ring", "-", "1 where the body touches around a dent: the contact is no disc, and the force is not known"
    ),
)
TABLES = (
    ("moduli", "moduli of the relaxing parts of E* [Pa]"),
    ("times", "their relaxation times [s]"),
    ("rates", "rates of free recovery [1/s]"),
    ("displaced", "what a displacement gives to each mode of it"),
    ("back", "what each memory gives to it [1/Pa]"),
    ("forth", "what each mode gives to the memories [Pa]"),
    ("modes", "what each mode stores [Pa]"),
)
STEPS, SEED = 60, 20260728
EXAMINED, SEEN = 500, 0.9
"""Depths at which springs are compared with the bed, and the part of their greatest error that these see."""


def relaxing_law(
    problem: ViscoelasticIndentation | ViscoelasticImpact, tolerance: float, count: int, inputs: tuple[str, ...]
) -> StepLaw:
    """Return the law of a contact with a viscoelastic body, up to the deepest point of the path of the problem.

    Raises
    ------
    InvalidInput
        If the solid has a dashpot alongside, and parts that relax besides.
    """
    series = relaxation_of("export", problem.bed)
    if series.viscosity > 0.0 and (series.moduli.size or not series.relaxed > 0.0):
        raise InvalidInput(
            "export: the solid has a dashpot alongside and relaxes besides; give a KelvinVoigt, or a StandardSolid or "
            "Prony series with a short time instead of the dashpot."
        )
    solution = problem.solve()
    deepest = float(np.max(solution.depth))
    if series.viscosity > 0.0:
        return damped_law(problem.bed, series, deepest, tolerance, tuple(map(str, solution.validity)), inputs)
    elastic = elastic_like(problem.bed)
    _, reach = at_depth(elastic, np.array([deepest]))
    row = SpringRow(elastic, Springs.of(elastic, float(reach[0]), count), series)
    solid = LawTable("solid", "E* after all relaxation [Pa], 0, greatest depth [m]", np.array([*row.law[:2], deepest]))
    law = (LawTable(name, meaning, np.asarray(part)) for (name, meaning), part in zip(TABLES, row.law[2:], strict=True))
    springs = (
        LawTable("gap", "g of the springs [m]", row.row[0]),
        LawTable("weight", "their stiffness where E* is 1 Pa [m]", row.row[1]),
        LawTable("position", "their places [m]", row.row[2]),
    )
    state = (
        StatePart("place", "displacement of the springs [m]", row.place),
        StatePart("memory", "memories of the springs, mode by mode", row.memory),
        StatePart("pressed", "whether each is pressed", row.pressed),
        StatePart("counts", "how many are pressed from the axis on, and have ever been", row.counts),
        StatePart("course", "depth [m], whether it last rose, rate [m/s]", np.array([0.0, 1.0, 0.0])),
        StatePart("past", "work and loss so far [J]", np.zeros(2)),
        StatePart("change", "work space", np.zeros(1)),
        StatePart("span", "work space", np.zeros(1)),
        StatePart("numbers", "work space", np.zeros((1, STEP_NUMBERS))),
    )
    notes = (
        f"Up to a depth of {deepest:.4g} m; beyond, the answer is not-a-number. {_error(elastic, deepest, count)}",
        *map(str, solution.validity),
    )
    title = "A body of revolution on a viscoelastic one: springs that relax, separate and recover"
    duration = float(np.median(series.times)) / 5.0
    return StepLaw(
        title, step_relaxing, (solid, *law, *springs), state, MOTION, ANSWER, notes, inputs, _trial(deepest, duration)
    )


def _error(bed: Bed, deepest: float, count: int) -> str:
    """Return how far springs in a row are from the bed, where nothing relaxes, in words."""
    depths = deepest * (np.arange(EXAMINED) + 1.0) / EXAMINED
    pressed = Indentation(bed, Depth(depths)).solve()
    force = np.asarray(pressed.force)
    springs = Springs.of(bed, float(np.max(pressed.radius)), count)
    worst = max(abs(springs.force(float(d)) - f) for d, f in zip(depths, force, strict=True))
    error = worst / (SEEN * float(force[-1]))
    return f"A sum over {count} springs: without relaxation the force is off by at most {error:.2g} of the greatest."


def _trial(deepest: float, duration: float) -> Array:
    """Return depths and durations: press, hold, let go, touch again, suddenly, too."""
    rng = np.random.default_rng(SEED)
    depth = deepest * np.clip(0.3 + 0.5 * np.sin(np.linspace(0.0, 12.0, STEPS)) + 0.2 * rng.normal(size=STEPS), -0.5, 1)
    spans = duration * rng.uniform(0.2, 3.0, STEPS)
    spans[::17] = 0.0
    return np.column_stack([depth, spans])
