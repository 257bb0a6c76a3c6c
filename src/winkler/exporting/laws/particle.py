"""Balls that yield or attract each other, with all their hysteresis, as laws for other programs."""

from __future__ import annotations

import math

import numpy as np

from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth
from winkler.loading.path import numbers_of
from winkler.numerics.types import Array
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.particles.elastic_plastic import ELASTIC, ENGINEERING, ElasticPlasticParticle
from winkler.problems.particles.elastic_plastic_springs import DEPTH_LIMIT, material_of
from winkler.problems.particles.particle_step import step_particle
from winkler.values.errors import InvalidInput

MOTION = (StepNumber("depth", "m", "d at the end of the step"),)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("radius", "m", "contact radius, zero without contact"),
    StepNumber("residual_depth", "m", "depth at which the unloaded particle would just touch"),
    StepNumber("energy", "J", "stored, less what closing the surfaces has gained"),
    StepNumber("dissipation", "J", "lost since the beginning, in yielding and in jumps of the edge"),
)
STEPS, SEED = 60, 20260727
PARABOLOID_SCALE = 1e6
"""A paraboloid is half an ellipse so many times wider: what is left of the difference is the inverse square of it."""
SHAPE_TOLERANCE = 1e-12
SLOWLY = "The step is slow: no inertia of the edge, no viscosity; between two depths the edge moves as it must."


def particle_law(problem: ElasticPlasticParticle, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of an elastic-plastic particle against a plane."""
    material = material_of(problem.curvature_radius, problem.solid)
    deepest = DEPTH_LIMIT * problem.curvature_radius
    numbers = (*material.particle(problem.work_closing, problem.work_opening), deepest)
    notes: tuple[str, ...] = (
        f"Up to a depth of {DEPTH_LIMIT:g} of the radius; beyond, the answer is not-a-number.",
        SLOWLY,
    )
    notes += (str(ELASTIC), *([str(ENGINEERING)] if math.isfinite(material.yield_depth) else []))
    reached = float(np.max(numbers_of(problem.path))) if isinstance(problem.path, Depth) else 0.1 * deepest
    most = min(max(reached, 2.0 * material.yield_depth if math.isfinite(material.yield_depth) else 0.0), deepest)
    return _law("An elastic-plastic, adhesive particle against a rigid plane", numbers, notes, inputs, most or deepest)


def adhesive_law(problem: AdhesiveCycle, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of a ball that attracts (Johnson, Kendall, Roberts), with hysteresis.

    Raises
    ------
    InvalidInput
        If the contact is no ball on a homogeneous half-space, or the attraction has a range.
    """
    if not isinstance(problem.law, ShortRange):
        raise InvalidInput(
            f"export: adhesion by {type(problem.law).__name__} has no steps for other programs; give ShortRange, or "
            "DerjaguinMullerToporov."
        )
    deepest = checked_depth(problem)
    radius, modulus = ball_of(problem.bed)
    wide = PARABOLOID_SCALE
    numbers = (
        radius, math.inf, modulus, 0.0, modulus, math.inf, 4.0 * radius * wide**2, radius * wide,
        problem.law.work_closing, problem.law.work_opening, deepest,
    )  # fmt: skip
    notes = (
        f"Up to a depth of {deepest:.4g} m; beyond, the answer is not-a-number.",
        SLOWLY,
        *map(str, problem.solve().validity),
    )
    title = "A ball that attracts, by Johnson, Kendall and Roberts, with hysteresis"
    return _law(title, numbers, notes, inputs, deepest)


def checked_depth(problem: AdhesiveCycle) -> float:
    """Return the greatest depth of the path [m]; refuse one that presses nothing."""
    known = isinstance(problem.path, Depth) and math.isinf(problem.machine_stiffness)
    deepest = float(np.max(numbers_of(problem.path) if known else problem.solve().depth))
    if not deepest > 0.0:
        raise InvalidInput(f"export: the path goes {deepest:g} m deep; give one that presses the bodies together.")
    return deepest


def ball_of(bed: Bed) -> tuple[float, float]:
    """Return R [m] and E* [Pa] of a bed with springs of a ball."""
    reach = min(bed.reach, bed.rim)
    unit = reach if math.isfinite(reach) else 1.0
    x = unit * np.array([0.1, 0.3, 0.5])
    curvature, modulus = bed.gap(x) / x**2, bed.normal_stiffness(x)
    alike = [np.ptp(part) <= SHAPE_TOLERANCE * np.max(part) for part in (curvature, modulus)]
    if not (all(alike) and np.min(curvature) > 0.0):
        raise InvalidInput(
            "export: laws with adhesion, or of every radius, are those of a ball on a homogeneous half-space, "
            "g = x^2/R and E* everywhere; give a Paraboloid on a HalfSpace."
        )
    return 1.0 / float(curvature[0]), float(modulus[0])


def _law(
    title: str, numbers: tuple[float, ...], notes: tuple[str, ...], inputs: tuple[str, ...], deepest: float
) -> StepLaw:
    meaning = (
        "R [m], yield strength, G [Pa], nu, E_c [Pa], depth of yield [m], A and b before it [m], works of closing and "
        "of opening [J/m^2], greatest depth [m]"
    )
    memory = "greatest depth, compression of the springs [m], angle of the edge, whether it touches, work so far [J]"
    tables, state = (
        (LawTable("law", meaning, np.array(numbers), falling=(8, 9)),),
        (StatePart("memory", memory, np.zeros(5)),),
    )
    return StepLaw(
        title, step_particle, tables, state,
        MOTION, ANSWER, notes, inputs, _trial(deepest),
    )  # fmt: skip


def _trial(deepest: float) -> Array:
    """Return depths that load, unload, tear off and touch again, ever deeper."""
    rng = np.random.default_rng(SEED)
    ever = np.linspace(0.2, 1.0, STEPS)
    return deepest * (ever * rng.uniform(-0.4, 1.0, STEPS))[:, np.newaxis]
