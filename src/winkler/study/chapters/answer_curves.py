"""What is drawn over what, where an answer is a curve along a path or over time."""

from __future__ import annotations

from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution
from winkler.problems.friction.spring_states import SpringState
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.tangential_states import TangentialState
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.friction.torsion_states import TorsionState
from winkler.problems.heating.transient import TransientHeatingSolution
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.near_round import NearlyRoundSolution
from winkler.problems.particles.elastic_plastic import ParticleSolution
from winkler.problems.rolling.oscillating import OscillatingRollingSolution, RockingState
from winkler.problems.rolling.simplified_theory import SimplifiedRollingSolution
from winkler.problems.rolling.start import RollingStartSolution, RollingState
from winkler.problems.rolling.steady import RollingSolution
from winkler.problems.rough.elastomer_friction import ElastomerFrictionSolution
from winkler.problems.rough.line_contact import RoughContactSolution
from winkler.problems.rough.line_indentation import RoughIndentationSolution
from winkler.problems.rough.reduce import ReductionSolution
from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic.impact import ViscoelasticImpactSolution
from winkler.problems.viscoelastic.indentation import ViscoelasticSolution
from winkler.problems.viscoelastic.material_tests import HarmonicSolution, StepSolution
from winkler.problems.viscoelastic.sliding import SlidingResistanceSolution
from winkler.problems.viscoelastic.tangential import ViscoelasticTangentialSolution
from winkler.problems.viscoelastic.tangential_states import ViscoelasticTangentialState
from winkler.problems.wear.fretting import FrettingSolution
from winkler.problems.wear.limiting_profile import LimitingSolution
from winkler.problems.wear.sliding import SlidingSolution
from winkler.problems.wear.states import WearState

__all__ = ["ALONG", "LOOPS", "MARCHED", "STICKING", "WITHOUT_CONTACT"]

MARCHED = (
    TangentialState,
    SpringState,
    TorsionState,
    ViscoelasticTangentialState,
    RollingState,
    RockingState,
    WearState,
)
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
    ViscoelasticSolution: (("depth", "force"), ("time", "force"), ("time", "depth"), ("time", "dissipation")),
    TransientHeatingSolution: (("time", "flash_temperature"), ("time", "first_share")),
    StepSolution: (("time", "depth"), ("time", "radius"), ("time", "force")),
    HarmonicSolution: tuple(
        ("angular_frequency", name) for name in ("storage_stiffness", "loss_stiffness", "loss_tangent")
    ),
    ViscoelasticTangentialSolution: (("shift", "shear_force"), ("time", "shear_force"), ("time", "dissipation")),
    ViscoelasticAdhesionSolution: (("position", "force"), ("time", "radius"), ("time", "crack_speed")),
    SlidingResistanceSolution: (("speed", "coefficient"), ("speed", "shear_force"), ("speed", "depth")),
    ViscoelasticImpactSolution: (("depth", "force"), ("time", "force"), ("time", "velocity")),
    RollingSolution: (
        ("longitudinal_creepage", "longitudinal_force"),
        ("lateral_creepage", "lateral_force"),
        ("longitudinal_creepage", "stick_share"),
    ),
    SimplifiedRollingSolution: (
        ("longitudinal_creepage", "longitudinal_force"),
        ("lateral_creepage", "lateral_force"),
        ("spin_creepage", "lateral_force"),
    ),
    RollingStartSolution: (("distance", "shear_force"), ("distance", "stick_share")),
    OscillatingRollingSolution: (("cycle", "shift"),),
    FrettingSolution: (("cycles", "worn_volume"), ("cycles", "stick_radius"), ("cycles", "force"), ("cycles", "depth")),
    SlidingSolution: (("distance", "worn_volume"), ("distance", "radius"), ("distance", "mean_pressure")),
    SurfaceContactSolution: (("depth", "force"), ("force", "stiffness"), ("force", "area"), ("force", "mean_gap")),
    SurfaceConductionSolution: (("force", "stiffness"), ("force", "conductance"), ("force", "resistance")),
    ReductionSolution: (("depth", "force"), ("depth", "stiffness")),
    RoughContactSolution: (("depth", "force"), ("force", "stiffness"), ("force", "area"), ("force", "mean_gap")),
    RoughIndentationSolution: (("depth", "force"), ("force", "stiffness"), ("force", "area")),
    NearlyRoundSolution: (("depth", "force"),),
    ElastomerFrictionSolution: (("velocity", "coefficient"),),
    EllipticSolution: (
        ("depth", "force"),
        ("depth", "longitudinal_semi_axis"),
        ("depth", "lateral_semi_axis"),
    ),
}
"""Answers along a path or over time: what is drawn over what, for a sweep."""
ALONG = ("shift", "depth")
"""What many answers to one question are drawn over: the first of these that was answered."""

STICKING = (AdhesiveSolution, AdhesiveCycleSolution, AdhesiveShearSolution, EquilibriumCurve, PullOffSolution)

WITHOUT_CONTACT = (
    ViscoelasticSolution,
    StepSolution,
    HarmonicSolution,
    ViscoelasticImpactSolution,
    ViscoelasticTangentialSolution,
    SlidingResistanceSolution,
    ViscoelasticAdhesionSolution,
    SimplifiedRollingSolution,
    FrettingSolution,
    SlidingSolution,
    LimitingSolution,
    SurfaceContactSolution,
    SurfaceConductionSolution,
    ReductionSolution,
    RoughContactSolution,
    RoughIndentationSolution,
    NearlyRoundSolution,
    EllipticSolution,
    ElastomerFrictionSolution,
)
"""Answers of which no single elastic contact can be shown: their own pictures hold all."""
