"""What is drawn over what, where an answer is a curve along a path or over time."""

from __future__ import annotations

from winkler.problems.adhesive import AdhesiveSolution
from winkler.problems.adhesive_cycle import AdhesiveCycleSolution
from winkler.problems.adhesive_shear import AdhesiveShearSolution
from winkler.problems.elastomer_friction import ElastomerFrictionSolution
from winkler.problems.elliptic_indentation import EllipticSolution
from winkler.problems.equilibrium import EquilibriumCurve
from winkler.problems.fretting_wear import FrettingSolution
from winkler.problems.heating_transient import TransientHeatingSolution
from winkler.problems.impact import ImpactSolution
from winkler.problems.impact_adhesive import AdhesiveImpactSolution
from winkler.problems.limiting_profile import LimitingSolution
from winkler.problems.near_round import NearlyRoundSolution
from winkler.problems.oscillating_rolling import OscillatingRollingSolution, RockingState
from winkler.problems.particle import ParticleSolution
from winkler.problems.pull_off import PullOffSolution
from winkler.problems.reduce import ReductionSolution
from winkler.problems.rolling import RollingSolution
from winkler.problems.rolling_start import RollingStartSolution, RollingState
from winkler.problems.rough_contact import RoughContactSolution
from winkler.problems.rough_indentation import RoughIndentationSolution
from winkler.problems.simplified_rolling import SimplifiedRollingSolution
from winkler.problems.sliding_wear import SlidingSolution
from winkler.problems.spring_states import SpringState
from winkler.problems.surface_conduction import SurfaceConductionSolution
from winkler.problems.surface_contact import SurfaceContactSolution
from winkler.problems.tangential import TangentialSolution
from winkler.problems.tangential_states import TangentialState
from winkler.problems.torsion import TorsionSolution
from winkler.problems.torsion_states import TorsionState
from winkler.problems.viscoelastic import ViscoelasticSolution
from winkler.problems.viscoelastic_adhesion import ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic_impact import ViscoelasticImpactSolution
from winkler.problems.viscoelastic_sliding import SlidingResistanceSolution
from winkler.problems.viscoelastic_tangential import ViscoelasticTangentialSolution
from winkler.problems.viscoelastic_tangential_states import ViscoelasticTangentialState
from winkler.problems.viscoelastic_tests import HarmonicSolution, StepSolution
from winkler.problems.wear_states import WearState

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
