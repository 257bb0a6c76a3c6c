"""What the figures of a report are called, and what they show in one sentence."""

from __future__ import annotations

from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution
from winkler.problems.conduction.bounds import ConductanceBoundsSolution
from winkler.problems.conduction.constriction import ConstrictionSolution
from winkler.problems.conduction.joule_heating import JouleHeatingSolution
from winkler.problems.conduction.spots import SpotClusterSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.heating.fretting import FrettingHeatSolution
from winkler.problems.heating.steady import FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeatingSolution
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.near_round import NearlyRoundSolution
from winkler.problems.particles.elastic_plastic import ParticleSolution
from winkler.problems.rolling.oscillating import OscillatingRollingSolution
from winkler.problems.rolling.simplified_theory import SimplifiedRollingSolution
from winkler.problems.rolling.start import RollingStartSolution
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
from winkler.problems.wear.fretting import FrettingSolution
from winkler.problems.wear.limiting_profile import LimitingSolution
from winkler.problems.wear.sliding import SlidingSolution

__all__ = ["CAPTIONS", "SHOWN_WHOLE", "STUCK"]

CAPTIONS = {
    "shape": (
        "The body in three dimensions",
        "Cut open, in the dent it makes; the contact is ringed in red, and the darker, the higher the pressure.",
    ),
    "medium": (
        "The medium",
        "How the solid changes with the depth, or what was measured, and how stiff that makes the springs.",
    ),
    "springs": (
        "The equivalent plane profile over its springs",
        "Every spring under g(x) − d is compressed on its own; nothing else has to be solved.",
    ),
    "line_load": (
        "The load of the springs",
        "q(x), the compression times the stiffness of the springs; the area below it is the force.",
    ),
    "pressure": ("The pressure", "p(r) of the three-dimensional contact, brought back from the springs."),
    "displacement": (
        "The surface",
        "Displacement of the surface inside and outside the contact, and the distance of the surfaces.",
    ),
    "stress": (
        "The stress below the surface",
        "Equivalent stress after von Mises; where it is greatest, yielding begins.",
    ),
    "force": ("Force over depth", "F(d) from first touch to this load, the point."),
}
"""Picture of the method -> its title, and one sentence."""

STUCK = {
    "springs": (
        CAPTIONS["springs"][0],
        "Springs are compressed in the middle and stretched towards the edge, until they let go.",
    ),
    "line_load": (
        CAPTIONS["line_load"][0],
        "q(x), the compression times the stiffness of the springs; where they pull, the area counts negative.",
    ),
    "pressure": (
        CAPTIONS["pressure"][0],
        "p(r) of the three-dimensional contact, brought back from the springs; below zero the surfaces pull.",
    ),
    "force": (
        CAPTIONS["force"][0],
        "All states of equilibrium around this one, the point; on the solid part they are stable.",
    ),
}
"""The same for bodies that stick, where it differs."""

ALONG = "The contact along its path"
STICKING = "forces and energies over time, and how the last contact sticks and slips."
LINES = "Spectrum, depth and stiffness, shaded where eight of ten lines lie; the contact area is Persson's."

SHOWN_WHOLE: dict[type, tuple[str, str, str]] = {
    EquilibriumCurve: (
        "equilibria",
        "All states of equilibrium",
        "Solid where they are stable; the arrows are jumps from the ends of the stable branches.",
    ),
    AdhesiveCycleSolution: (
        "cycle",
        "Approach and retraction",
        "The contact follows the states of equilibrium and jumps, along the arrows, where it loses its hold.",
    ),
    AdhesiveShearSolution: (
        "shear",
        "The contact gives way as it is sheared",
        "Up to the shift at which no contact radius holds any more.",
    ),
    PullOffSolution: ("pull_off", "Where the contact comes apart", "Among all states of equilibrium, the point."),
    TangentialSolution: (
        "tangential",
        ALONG,
        f"The loop of the shear force, {STICKING}",
    ),
    TorsionSolution: (
        "torsion",
        ALONG,
        f"The loop of the torque, {STICKING}",
    ),
    FrictionDampingSolution: ("damping", "What friction damps", "Loss, stiffness and loss factor over the amplitude."),
    BimodalDampingSolution: ("damping", "What friction damps", "Loss in every closed cycle of depth and shift."),
    RelaxationDamperSolution: ("damping", "What relaxation damps", "Damper and spring, as the depth oscillates."),
    ImpactSolution: ("impact", "The impact", "Forces, velocities, contact and energies over time."),
    ConstrictionSolution: (
        "contact_resistance",
        "The contact resistance",
        "Over the force, and what makes it: the narrow contact, a film, the length of rods.",
    ),
    ThermalConstrictionSolution: (
        "heat",
        "Heat through the contact",
        "Temperature around the contact, heat flux over the surface, and the resistance over the force.",
    ),
    JouleHeatingSolution: (
        "joule",
        "How hot a current makes the contact",
        "Temperature around the contact, current density over the surface, and what other voltages would heat.",
    ),
    SpotClusterSolution: (
        "spots",
        "The spots",
        "Which spots carry more current than others of their size, and what stands in the way of all.",
    ),
    ConductanceBoundsSolution: (
        "bounds",
        "Between two smooth bodies",
        "The force curve of the rough body lies in the shaded band; it cannot be steeper or flatter than the lines.",
    ),
    ParticleSolution: (
        "particle",
        "The particle along its path",
        "Force and contact radius over the depth, pressed in and let go; dotted where yield begins.",
    ),
    AdhesiveImpactSolution: ("impact", "The impact", "Force, velocity, contact and energies over time."),
    ViscoelasticSolution: (
        "relaxing",
        ALONG,
        "Force, depth, contact radius and energies; springs and pressure of a late contact, with the springs that have "
        "let go and recover on their own.",
    ),
    FrictionHeatingSolution: (
        "heating",
        "How warm the bodies get",
        "The surface that moves faster past the contact, both surfaces along the middle, and the flash temperature "
        "over the speed; or, of many loads and speeds at once, over what was varied.",
    ),
    TransientHeatingSolution: (
        "heating",
        "How the contact warms up",
        "The flash temperature over time, and the surface of the first body at some moments.",
    ),
    FrettingHeatSolution: (
        "heating",
        "How warm the contact gets",
        "Where the heat of a cycle is released, and the mean temperature of the surfaces.",
    ),
    StepSolution: ("step", "After the step", "How the body sinks under its force, or how the force falls, over time."),
    HarmonicSolution: (
        "harmonic",
        "A small oscillation",
        "Force in phase with the motion and a quarter of a turn ahead of it, and the ratio of both.",
    ),
    ViscoelasticTangentialSolution: (
        "dragged",
        ALONG,
        "The loop of the shear force, forces, energies and the contact over time; springs and their loads of a late "
        "contact, with those that have let go and recover.",
    ),
    ViscoelasticAdhesionSolution: (
        "pulled_off",
        "Pulled off rubber",
        "Force over the way of the machine, depth and contact over time, and how fast the edge opens.",
    ),
    SlidingResistanceSolution: (
        "sliding",
        "What sliding or rolling costs",
        "Resistance and coefficient of friction over the speed, and the springs under the body where it is greatest.",
    ),
    ViscoelasticImpactSolution: ("impact", "The impact", "Force, velocity, depth and contact until the body leaves."),
    RollingSolution: ("creep", "Rolling", "The creep force, and what the springs bear at the greatest of these."),
    SimplifiedRollingSolution: (
        "creep",
        "Rolling",
        "The creep force; of the greatest of these the traction over the contact, and where it sticks and slides.",
    ),
    RollingStartSolution: ("start", "From rest to rolling", "The force on the way, and the springs at some places."),
    OscillatingRollingSolution: (
        "rocking",
        "Rocking to and fro",
        "The shift over the cycles, the springs after some of them, and the limit of shakedown.",
    ),
    FrettingSolution: (
        "fretting",
        "Worn by fretting",
        "Profiles, worn depth and pressure after some of the cycles; contact, core, volume and load over them.",
    ),
    SlidingSolution: (
        "sliding",
        "Worn by sliding",
        "Profiles, worn depth and pressure after some distances; contact, volume and mean pressure over them.",
    ),
    SurfaceContactSolution: (
        "contact",
        "Where the surfaces touch",
        "Contact, pressure and distance under the last load, by boundary elements; of many loads also force, stiffness "
        "and contact area.",
    ),
    SurfaceConductionSolution: (
        "conductance",
        "Stiffness, conductance and contact area over the load",
        "By boundary elements and by lines of springs with the same power spectrum; shaded grey between Barber's "
        "bounds, which no surface of this height can leave.",
    ),
    ReductionSolution: (
        "reduction",
        "Springs in place of the surface",
        "The points were computed by boundary elements; the springs bear the same forces.",
    ),
    RoughContactSolution: (
        "lines",
        "Rough lines of springs",
        LINES,
    ),
    RoughIndentationSolution: (
        "lines",
        "Rough lines of springs under the body",
        LINES,
    ),
    NearlyRoundSolution: ("contour", "The contact", "Its contour, computed in the directions of the points."),
    EllipticSolution: ("ellipse", "The contact", "Pressure over the ellipse; of many loads force and semi-axes."),
    ElastomerFrictionSolution: (
        "friction",
        "Friction of the rough surface on the elastomer",
        "A trend with the velocity, no prediction; beside it the spectrum whose waves are felt.",
    ),
    LimitingSolution: (
        "limit",
        "Where wear ends",
        "The profile in the end, what was worn off, and the pressure, which only the core bears then.",
    ),
}
"""Answers that are curves -> the stem of the picture, its title, one sentence."""
