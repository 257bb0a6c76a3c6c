"""Which problems are contact laws: those that another program can step through, by their kind."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.exporting.laws.attracted import attracted_law
from winkler.exporting.laws.balls import ball_law
from winkler.exporting.laws.normal import normal_law
from winkler.exporting.laws.particle import adhesive_law, particle_law
from winkler.exporting.laws.relaxing import relaxing_law
from winkler.exporting.laws.sheared import sheared_law
from winkler.exporting.laws.yielding import yielding_law
from winkler.exporting.step_law import StepLaw
from winkler.io.traces import inputs_of
from winkler.laws.adhesion import DerjaguinMullerToporov
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.friction.tangential import Tangential
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact
from winkler.problems.normal.elliptic import EllipticIndentation
from winkler.problems.normal.indentation import Indentation
from winkler.problems.particles.contact_law import ContactLaw, ContactLawSolution
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle
from winkler.problems.plastic.impact import PlasticImpact
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.viscoelastic.impact import ViscoelasticImpact
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.profiles.power import Paraboloid
from winkler.values.errors import InvalidInput

LAWS = {
    "Indentation": "normal force of a body of revolution, up to the deepest load",
    "ContactLaw": "the same, up to its depth and to its tolerance",
    "Tangential": "the same with friction in the plane, up to the deepest point of the path",
    "ElasticPlasticParticle": "a particle that yields and sticks, with all its hysteresis",
    "PlasticIndentation": "round bodies that yield: loading, unloading and reloading up to the maximum depth",
    "PlasticImpact": "the same, up to the deepest point of the fastest impact",
    "EllipticIndentation": "two bodies of unlike curvatures, up to the deepest load",
    "Impact": "a body of revolution that strikes; with friction if it moves along the surface",
    "AdhesiveCycle": "a ball with adhesion (JKR with hysteresis, or DMT), up to the deepest point of the path",
    "AdhesiveIndentation": "the same, up to its load",
    "AdhesiveImpact": "the same, up to the deepest point of the impact",
    "ViscoelasticIndentation": "a body of revolution on one that relaxes, up to the deepest point of the path",
    "ViscoelasticImpact": "the same, up to the deepest point of the impact",
    "Contacts": "two balls with friction, twist and rolling; in Python",
}
"""Problem -> what it is as a law."""


def law_of(problem: Any, *, tolerance: float, count: int) -> StepLaw:
    """Return the law of a problem.

    Parameters
    ----------
    problem
        One of `LAWS`.
    tolerance : float
        Error of a table, over the greatest force.
    count : int
        How many springs, where it does not state that itself.

    Raises
    ------
    InvalidInput
        If it is none of these; the message lists them.
    """
    inputs = _described(problem)
    problem = _with_path(problem)
    radius = ball_radius(getattr(problem, "bed", None))
    match problem:
        case Indentation():
            law = normal_law(problem.bed, _deepest(problem), tolerance, inputs)
        case EllipticIndentation():
            law, radius = normal_law(problem.bed, _deepest(problem), tolerance, inputs), math.nan
        case ContactLaw():
            law = normal_law(problem.bed, problem.deepest, problem.tolerance, inputs)
        case ContactLawSolution():
            return law_of(problem.problem, tolerance=tolerance, count=count)
        case Tangential():
            law = sheared_law(problem, tolerance, count, inputs)
        case ElasticPlasticParticle():
            law, radius = particle_law(problem, inputs), problem.curvature_radius
        case PlasticIndentation():
            law = yielding_law(problem, _deepest(problem), tolerance, inputs)
        case AdhesiveCycle(law=DerjaguinMullerToporov(work=work)):
            law = attracted_law(problem, work, tolerance, inputs)
        case AdhesiveCycle():
            law = adhesive_law(problem, inputs)
        case ViscoelasticIndentation() | ViscoelasticImpact():
            law = relaxing_law(problem, tolerance, count, inputs)
        case Contacts():
            law, radius = ball_law(problem, inputs), float(problem.curvature_radius[0])
        case _:
            known = "; ".join(f"{name} ({what})" for name, what in LAWS.items())
            raise InvalidInput(
                f"export: {type(problem).__name__} is no contact law for other programs; give one of: {known}."
            )
    return law._replace(curvature_radius=radius, against_plane=isinstance(problem, ElasticPlasticParticle))


def _with_path(problem: Any) -> Any:
    """Return a problem with one load, or an impact, as that of the path to its deepest point."""
    match problem:
        case AdhesiveIndentation() | AdhesiveImpact():
            path = Depth(np.array([_deepest(problem), 0.0]))
            return AdhesiveCycle(problem.bed, problem.law, path)
        case PlasticImpact(law=Coulomb(coefficient=0.0)):
            deepest = float(np.max(problem.solve().greatest_depth))
            return PlasticIndentation(problem.bed, Depth(np.array([deepest])))
        case Impact(lateral_velocity=0.0, angular_velocity=0.0):
            return Indentation(problem.bed, Depth(_deepest(problem)))
        case Impact():
            pressed = Path(np.array([0.0, 1.0]), Depth(np.array([0.0, _deepest(problem)])), Shift(np.zeros(2)))
            return Tangential(problem.bed, problem.law, pressed)
        case _:
            return problem


def _deepest(problem: Any) -> float:
    """Return the greatest depth of the solution [m]."""
    return float(np.max(problem.solve().depth))


def ball_radius(bed: Any) -> float:
    """Return R [m] of a bed under a paraboloid; not-a-number for another shape, or none."""
    profile = getattr(bed, "profile", None)
    return profile.curvature_radius if isinstance(profile, Paraboloid) else math.nan


def _described(problem: Any) -> tuple[str, ...]:
    """Return the inputs of a problem, one a line."""
    lines = []
    for name, (content, unit) in inputs_of(problem).items():
        text = ("infinite" if content == math.inf else repr(content)) if isinstance(content, float) else content
        lines.append(f"{name} = {text} {unit}".rstrip())
    return tuple(lines)
