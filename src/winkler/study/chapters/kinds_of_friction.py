"""Kinds of contacts that are moved along the surface, or struck: friction, lateral loads, paths, and what is asked."""

from __future__ import annotations

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
        "coulomb": kind("winkler.laws.friction:Coulomb", coefficient=0.3),
        "static_kinetic": kind(
            "winkler.laws.friction:StaticKinetic", problem="tangential", static_coefficient=0.4, kinetic_coefficient=0.3
        ),
    },
    "lateral": {
        "shift": kind("winkler.loading:Shift", problem="adhesive_shear", shift="1 nm"),
        "shear_force": kind("winkler.loading:ShearForce", problem="adhesive_shear", shear_force="1 mN"),
        "angle": kind("winkler.loading:Angle", problem="torsion", angle="1 mrad"),
        "torque": kind("winkler.loading:Torque", problem="torsion", torque="1 mN m"),
    },
    "problem": {
        "tangential": kind(
            "winkler.problems.friction.tangential:Tangential", path={"kind": "program", "steps": TO_AND_FRO}
        ),
        "torsion": kind("winkler.problems.friction.torsion:Torsion", path={"kind": "program", "steps": TWIST}),
        "elastic_plastic_particle": kind(
            "winkler.problems.particles.elastic_plastic:ElasticPlasticParticle",
            curvature_radius="1 mm",
            solid={"kind": "elastic", "young": "1 GPa", "poisson": 0.3, "strength": "20 MPa"},
            path={"kind": "depth", "depth": ["20 um", "40 um", "0 um"]},
        ),
        "friction_damping": kind(
            "winkler.problems.friction.damping:FrictionDamping",
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
        ),
        "bimodal_damping": kind(
            "winkler.problems.friction.bimodal_damping:BimodalDamping",
            depth="3 um",
            depth_amplitude="1 um",
            shift_amplitude="0.5 um",
            phase="90 deg",
        ),
        "relaxation_damper": kind(
            "winkler.problems.friction.relaxation_damping:RelaxationDamper",
            depth="3 um",
            depth_amplitude="1 um",
            frequency="100 Hz",
        ),
        "impact": kind(
            "winkler.problems.impact.impact:Impact",
            mass="33 g",
            velocity="1 m/s",
            lateral_velocity="0.5 m/s",
            inertia="1.3e-6 kg m^2",
            lever="10 mm",
        ),
        "adhesive_impact": kind(
            "winkler.problems.impact.adhesive_impact:AdhesiveImpact",
            law={"kind": "short_range", "work": "50 mJ/m^2"},
            mass="33 g",
            velocity="1 mm/s",
        ),
    },
    "path": {
        "path": kind(
            "winkler.path:Path",
            reader="winkler.io.tables.path_table:read_path",
            time=["0 s", "1 s", "2 s"],
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shift", "shift": ["0 um", "0.5 um", "-0.5 um"]},
        ),
        "program": kind("winkler.program:Program", steps=TO_AND_FRO),
    },
    "step": {
        "start": kind("winkler.path_steps:Start", normal={"kind": "force", "force": "100 N"}),
        "ramp": kind("winkler.path_steps:Ramp", normal={"kind": "force", "force": "200 N"}),
        "hold": kind("winkler.path_steps:Hold"),
        "oscillate": kind("winkler.path_steps:Oscillate", lateral={"kind": "shift", "shift": "0.5 um"}),
        "circle": kind(
            "winkler.path_steps:Circle",
            within=[PRESSED, {"kind": "circle", "lateral": {"kind": "shift", "shift": "0.5 um"}}],
            lateral={"kind": "shift", "shift": "0.5 um"},
        ),
        "follow": kind(
            "winkler.path_steps:Follow", within=[PRESSED, {"kind": "follow", "path": {"kind": "path"}, "cycles": 2}]
        ),
    },
}
"""Slot -> kind -> class."""
