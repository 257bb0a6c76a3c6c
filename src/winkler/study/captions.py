"""What the figures of a report are called, and what they show in one sentence."""

from __future__ import annotations

from winkler.problems.adhesive_cycle import AdhesiveCycleSolution
from winkler.problems.adhesive_shear import AdhesiveShearSolution
from winkler.problems.bimodal import BimodalDampingSolution
from winkler.problems.damping import FrictionDampingSolution
from winkler.problems.equilibrium import EquilibriumCurve
from winkler.problems.impact import ImpactSolution
from winkler.problems.impact_adhesive import AdhesiveImpactSolution
from winkler.problems.pull_off import PullOffSolution
from winkler.problems.relaxation import RelaxationDamperSolution
from winkler.problems.tangential import TangentialSolution
from winkler.problems.torsion import TorsionSolution

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
        "The equivalent plane profile over its springs",
        "Springs are compressed in the middle and stretched towards the edge, until they let go.",
    ),
    "line_load": (
        "The load of the springs",
        "q(x), the compression times the stiffness of the springs; where they pull, the area counts negative.",
    ),
    "pressure": (
        "The pressure",
        "p(r) of the three-dimensional contact, brought back from the springs; below zero the surfaces pull.",
    ),
    "force": (
        "Force over depth",
        "All states of equilibrium around this one, the point; on the solid part they are stable.",
    ),
}
"""The same for bodies that stick, where it differs."""

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
        "The contact along its path",
        "The loop of the shear force, forces and energies over time, and how the last contact sticks and slips.",
    ),
    TorsionSolution: (
        "torsion",
        "The contact along its path",
        "The loop of the torque, forces and energies over time, and how the last contact sticks and slips.",
    ),
    FrictionDampingSolution: ("damping", "What friction damps", "Loss, stiffness and loss factor over the amplitude."),
    BimodalDampingSolution: ("damping", "What friction damps", "Loss in every closed cycle of depth and shift."),
    RelaxationDamperSolution: ("damping", "What relaxation damps", "Damper and spring, as the depth oscillates."),
    ImpactSolution: ("impact", "The impact", "Forces, velocities, contact and energies over time."),
    AdhesiveImpactSolution: ("impact", "The impact", "Force, velocity, contact and energies over time."),
}
"""Answers that are curves -> the stem of the picture, its title, one sentence."""
