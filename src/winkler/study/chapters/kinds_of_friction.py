"""Kinds of contacts that are moved along the surface, or struck: friction, lateral loads, paths, and what is asked."""

from __future__ import annotations

from winkler.io.tables.path_table import read_path
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading import Angle, ShearForce, Shift, Torque
from winkler.path import Path
from winkler.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start
from winkler.problems.friction.bimodal_damping import BimodalDamping
from winkler.problems.friction.damping import FrictionDamping
from winkler.problems.friction.relaxation_damping import RelaxationDamper
from winkler.problems.friction.tangential import Tangential
from winkler.problems.friction.torsion import Torsion
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle
from winkler.program import Program
from winkler.study.chapters.kind import Kind, kind

__all__ = ["FRICTION"]

PRESSED = {"kind": "start", "normal": {"kind": "force", "force": "100 N"}}
TO_AND_FRO = [
    PRESSED,
    {"kind": "ramp", "normal": {"kind": "force", "force": "200 N"}, "duration": "1 s"},
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "0.5 um"}, "cycles": 2.0},
    {"kind": "hold", "duration": "1 s"},
]
TWIST = [
    {**PRESSED, "lateral": {"kind": "angle", "angle": "0 rad"}},
    {"kind": "oscillate", "lateral": {"kind": "angle", "angle": "2 mrad"}, "cycles": 1.25},
]

FRICTION: dict[str, dict[str, Kind]] = {
    "law": {
        "coulomb": kind(Coulomb, coefficient=0.3),
        "static_kinetic": kind(StaticKinetic, problem="tangential", static_coefficient=0.4, kinetic_coefficient=0.3),
    },
    "lateral": {
        "shift": kind(Shift, problem="adhesive_shear", shift="1 nm"),
        "shear_force": kind(ShearForce, problem="adhesive_shear", shear_force="1 mN"),
        "angle": kind(Angle, problem="torsion", angle="1 mrad"),
        "torque": kind(Torque, problem="torsion", torque="1 mN m"),
    },
    "problem": {
        "tangential": kind(Tangential, path={"kind": "program", "steps": TO_AND_FRO}),
        "torsion": kind(Torsion, path={"kind": "program", "steps": TWIST}),
        "elastic_plastic_particle": kind(
            ElasticPlasticParticle,
            curvature_radius="1 mm",
            solid={"kind": "elastic", "young": "1 GPa", "poisson": 0.3, "strength": "20 MPa"},
            path={"kind": "depth", "depth": ["20 um", "40 um", "0 um"]},
        ),
        "friction_damping": kind(
            FrictionDamping,
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
        ),
        "bimodal_damping": kind(
            BimodalDamping,
            depth="3 um",
            depth_amplitude="1 um",
            shift_amplitude="0.5 um",
            phase="90 deg",
        ),
        "relaxation_damper": kind(RelaxationDamper, depth="3 um", depth_amplitude="1 um", frequency="100 Hz"),
        "impact": kind(
            Impact,
            mass="33 g",
            velocity="1 m/s",
            lateral_velocity="0.5 m/s",
            inertia="1.3e-6 kg m^2",
            lever="10 mm",
        ),
        "adhesive_impact": kind(
            AdhesiveImpact,
            law={"kind": "short_range", "work": "50 mJ/m^2"},
            mass="33 g",
            velocity="1 mm/s",
        ),
    },
    "path": {
        "path": kind(
            Path,
            reader=read_path,
            time=["0 s", "1 s", "2 s"],
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shift", "shift": ["0 um", "0.5 um", "-0.5 um"]},
        ),
        "program": kind(Program, steps=TO_AND_FRO),
    },
    "step": {
        "start": kind(Start, normal={"kind": "force", "force": "100 N"}),
        "ramp": kind(Ramp, normal={"kind": "force", "force": "200 N"}),
        "hold": kind(Hold),
        "oscillate": kind(Oscillate, lateral={"kind": "shift", "shift": "0.5 um"}),
        "circle": kind(
            Circle,
            within=[PRESSED, {"kind": "circle", "lateral": {"kind": "shift", "shift": "0.5 um"}}],
            lateral={"kind": "shift", "shift": "0.5 um"},
        ),
        "follow": kind(Follow, within=[PRESSED, {"kind": "follow", "path": {"kind": "path"}, "cycles": 2}]),
    },
}
"""Slot -> kind -> class."""
