"""What is drawn over what, where an answer is a curve along a path or over time."""

from __future__ import annotations

from winkler.problems.adhesive import AdhesiveSolution
from winkler.problems.adhesive_cycle import AdhesiveCycleSolution
from winkler.problems.adhesive_shear import AdhesiveShearSolution
from winkler.problems.equilibrium import EquilibriumCurve
from winkler.problems.impact import ImpactSolution
from winkler.problems.impact_adhesive import AdhesiveImpactSolution
from winkler.problems.particle import ParticleSolution
from winkler.problems.pull_off import PullOffSolution
from winkler.problems.spring_states import SpringState
from winkler.problems.tangential import TangentialSolution
from winkler.problems.tangential_states import TangentialState
from winkler.problems.torsion import TorsionSolution
from winkler.problems.torsion_states import TorsionState

__all__ = ["ALONG", "LOOPS", "MARCHED", "STICKING"]

MARCHED = (TangentialState, SpringState, TorsionState)
"""What a load of an answer is that marched along a path."""
LOOPS: dict[type, tuple[tuple[str, str], ...]] = {
    TangentialSolution: (
        ("shift", "shear_force"),
        ("shift_x", "shear_force_x"),
        ("shift_y", "shear_force_y"),
        ("time", "dissipation"),
    ),
    TorsionSolution: (("angle", "torque"), ("time", "dissipation")),
    ImpactSolution: (("time", "force"), ("time", "shear_force"), ("time", "angular_velocity")),
    AdhesiveImpactSolution: (("time", "force"), ("time", "velocity")),
    ParticleSolution: (("depth", "force"),),
}
"""Answers along a path or over time: what is drawn over what, for a sweep."""
ALONG = ("shift", "depth")
"""What many answers to one question are drawn over: the first of these that was answered."""

STICKING = (AdhesiveSolution, AdhesiveCycleSolution, AdhesiveShearSolution, EquilibriumCurve, PullOffSolution)
