"""The catalogue: every kind that a study file may name, and the class behind it.

One line makes a class known to study files, ``winkler show``, ``winkler new``, ``winkler cite`` and the tests: its
keys, units and meanings are read from the class and the glossary.  The line also carries an example (values as a
study file writes them; for a part that is left out, the first kind of its slot is taken) and the BibTeX keys of the
papers that the class stands on.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.io.bed_table import read_bed
from winkler.io.grading_table import read_grading
from winkler.io.path_table import read_path
from winkler.io.profile_table import read_profile
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading import Angle, Depth, Force, Radius, ShearForce, Shift, Torque
from winkler.materials.depth_grading import (
    DepthGrading,
    ExponentialGrading,
    SigmoidalGrading,
    TabulatedGrading,
)
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.coated import CoatedHalfSpace
from winkler.media.depth_graded import DepthGradedHalfSpace
from winkler.media.graded import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.medium import Medium
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.path import Path
from winkler.path_steps import Circle, Follow, Hold, Kept, Oscillate, Ramp, Start
from winkler.problems.adhesive import AdhesiveIndentation
from winkler.problems.adhesive_cycle import AdhesiveCycle
from winkler.problems.adhesive_shear import AdhesiveShear
from winkler.problems.bimodal import BimodalDamping
from winkler.problems.damping import FrictionDamping
from winkler.problems.equilibrium import Equilibrium
from winkler.problems.impact import Impact
from winkler.problems.impact_adhesive import AdhesiveImpact
from winkler.problems.indentation import Indentation
from winkler.problems.particle import ElasticPlasticParticle
from winkler.problems.pull_off import PullOff
from winkler.problems.relaxation import RelaxationDamper
from winkler.problems.spring_states import OwnLaw
from winkler.problems.tangential import Tangential
from winkler.problems.torsion import Torsion
from winkler.problems.yielding import YieldOnset
from winkler.profiles.area import AreaFunction
from winkler.profiles.composite import Sum
from winkler.profiles.conical import (
    Berkovich,
    Cone,
    CubeCorner,
    RoundedCone,
    SpheroConical,
    TruncatedCone,
    Vickers,
)
from winkler.profiles.designed import Designed
from winkler.profiles.flat import CappedCylinder, Cylinder, FlatPunch
from winkler.profiles.formula import Formula
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Profile
from winkler.profiles.rounded import CappedParaboloid, RoundedPunch, TruncatedParaboloid
from winkler.profiles.sphere import Ellipsoid, Hyperboloid, Sphere
from winkler.profiles.wavy import Wavy
from winkler.program import Program

__all__ = ["CATALOGUE", "REFUSED", "SLOTS", "UNWRITTEN", "Kind", "kind_of", "kinds", "slot_of"]


class Kind(NamedTuple):
    """One line of the catalogue."""

    cls: type
    example: dict[str, Any]
    cites: tuple[str, ...] = ()
    reader: Callable[..., Any] | None = None
    """Reads the value from the file that the key ``file`` names, in place of the other keys; its keyword-only
    arguments are keys that go with the file."""
    within: dict[str, Any] | list[dict[str, Any]] | None = None
    """What an example study puts in its place, with the kind inside, where the kind alone would have no answer."""
    problem: str = ""
    """Which problem an example study asks, where the first that has a place for the kind would refuse it."""


def _kind(
    cls: type,
    *cites: str,
    reader: Callable[..., Any] | None = None,
    within: dict[str, Any] | list[dict[str, Any]] | None = None,
    problem: str = "",
    **example: Any,
) -> Kind:
    return Kind(cls, example, cites, reader, within, problem)


WAVY_BALL = {
    "kind": "sum",
    "parts": [
        {"kind": "paraboloid", "curvature_radius": "10 mm"},
        {"kind": "wavy", "amplitude": "0.1 um", "wavelength": "1 mm"},
    ],
}
"""A wave alone touches again at its next trough; on a ball it does not."""
THERE_AND_BACK = [
    {"from": "-5 nm", "to": "5 nm", "count": 41},
    {"from": "5 nm", "to": "-5 nm", "count": 41},
]
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
STRONG = {"first": {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "700 MPa"}}

CATALOGUE: dict[str, dict[str, Kind]] = {
    "profile": {
        "sphere": _kind(Sphere, "hertz_1882", "popov_hess_2015", curvature_radius="10 mm"),
        "paraboloid": _kind(Paraboloid, "hertz_1882", curvature_radius="10 mm"),
        "power_law": _kind(PowerLaw, "galin_1946", "sneddon_1965", coefficient="1e6 m^-3", exponent=4.0),
        "cone": _kind(Cone, "love_1939", "sneddon_1965", half_angle="70.3 deg"),
        "ellipsoid": _kind(Ellipsoid, "popov_hess_willert_2019", radial_semi_axis="10 mm", axial_semi_axis="5 mm"),
        "hyperboloid": _kind(Hyperboloid, "popov_hess_willert_2019", curvature_radius="1 mm", half_angle="70 deg"),
        "flat_punch": _kind(FlatPunch, "boussinesq_1885", "sneddon_1965", radius="1 mm"),
        "rounded_punch": _kind(RoundedPunch, "ciavarella_1998", flat_radius="0.5 mm", edge_radius="1 mm"),
        "truncated_cone": _kind(TruncatedCone, "briscoe_1994", half_angle="80 deg", flat_radius="0.1 mm"),
        "truncated_paraboloid": _kind(
            TruncatedParaboloid, "maugis_barquins_1983", curvature_radius="10 mm", flat_radius="0.2 mm"
        ),
        "capped_paraboloid": _kind(
            CappedParaboloid,
            "maugis_barquins_1983",
            curvature_radius="10 mm",
            cap_curvature_radius="20 mm",
            cap_radius="0.1 mm",
        ),
        "rounded_cone": _kind(RoundedCone, "maugis_barquins_1983", curvature_radius="1 mm", half_angle="70.3 deg"),
        "sphero_conical": _kind(SpheroConical, "briscoe_1994", curvature_radius="1 mm", half_angle="60 deg"),
        "berkovich": _kind(Berkovich, "oliver_pharr_1992"),
        "vickers": _kind(Vickers, "oliver_pharr_1992"),
        "cube_corner": _kind(CubeCorner, "oliver_pharr_1992"),
        "area_function": _kind(AreaFunction, "oliver_pharr_1992", coefficients=["24.5", "2 um", "3e-6 m^1.5"]),
        "capped_cylinder": _kind(
            CappedCylinder,
            "popov_hess_willert_2019",
            radius="0.2 mm",
            cap={"kind": "sphere", "curvature_radius": "10 mm"},
        ),
        "wavy": _kind(Wavy, "guduru_2007", within=WAVY_BALL, amplitude="0.1 um", wavelength="1 mm"),
        "sum": _kind(Sum, "guduru_2007", parts=WAVY_BALL["parts"]),
        "formula": _kind(Formula, "popov_hess_2015", expression="r**2/(2*R) + r**4/(8*R**3)", constants={"R": "10 mm"}),
        "measured": _kind(
            Measured,
            "popov_hess_2015",
            reader=read_profile,
            radii={"from": "0 mm", "to": "1 mm", "count": 6},
            heights=["0 um", "2 um", "8 um", "18 um", "32 um", "50 um"],
        ),
        "designed": _kind(
            Designed,
            "popov_hess_2015",
            edges=["0 mm", "0.5 mm", "1 mm"],
            slopes=[[0.025, 0.025], [0.075, 0.025]],
            tolerance=1e-10,
        ),
    },
    "solid": {
        "elastic": _kind(Elastic, young="210 GPa", poisson=0.3),
        "rigid": _kind(Rigid),
        "transversely_isotropic": _kind(
            TransverselyIsotropic, c11="162 GPa", c12="92 GPa", c13="69 GPa", c33="181 GPa", c44="47 GPa"
        ),
        "power_law_graded": _kind(
            PowerLawGraded, "booker_1985", young="220 GPa", depth_scale="1 mm", exponent=0.15, poisson=0.25
        ),
    },
    "medium": {
        "half_space": _kind(HalfSpace, "johnson_1985"),
        "transversely_isotropic_half_space": _kind(TransverselyIsotropicHalfSpace, "elliott_1949"),
        "graded_half_space": _kind(GradedHalfSpace, "booker_1985", "giannakopoulos_suresh_1997", "hess_2016"),
        "coated_half_space": _kind(CoatedHalfSpace, "barber_1974", "hayes_1972", "hess_2023"),
        "depth_graded_half_space": _kind(DepthGradedHalfSpace, "barber_1974", "hess_2023", tolerance=1e-2),
    },
    "layer": {
        "layer": _kind(Layer, solid={"kind": "elastic", "young": "450 GPa", "poisson": 0.25}, thickness="50 um"),
    },
    "grading": {
        "exponential_grading": _kind(
            ExponentialGrading, surface_young="380 GPa", deep_young="210 GPa", depth_scale="0.2 mm", poisson=0.3
        ),
        "sigmoidal_grading": _kind(
            SigmoidalGrading,
            surface_young="380 GPa",
            deep_young="210 GPa",
            transition_depth="0.2 mm",
            transition_width="0.1 mm",
            poisson=0.3,
        ),
        "tabulated_grading": _kind(
            TabulatedGrading,
            reader=read_grading,
            depths=["0 mm", "0.1 mm", "0.3 mm", "0.6 mm"],
            youngs=["380 GPa", "340 GPa", "240 GPa", "210 GPa"],
            poissons=[0.24, 0.26, 0.29, 0.3],
        ),
    },
    "bed": {
        "foundation": _kind(Foundation, "popov_hess_2015"),
        "plane_foundation": _kind(PlaneFoundation, "popov_hess_2015"),
        "measured_bed": _kind(
            MeasuredBed,
            "barber_1974",
            reader=read_bed,
            radii={"from": "0.05 mm", "to": "0.3 mm", "count": 6},
            stiffnesses={"from": "11.5 MN/m", "to": "69 MN/m", "count": 6},
            depths=["0.25 um", "1 um", "2.25 um", "4 um", "6.25 um", "9 um"],
        ),
    },
    "law": {
        "short_range": _kind(ShortRange, "johnson_kendall_roberts_1971", work="50 mJ/m^2"),
        "dugdale": _kind(Dugdale, "maugis_1992", work="50 mJ/m^2", strength="1 MPa"),
        "derjaguin_muller_toporov": _kind(DerjaguinMullerToporov, "derjaguin_1975", work="50 mJ/m^2"),
        "coulomb": _kind(Coulomb, coefficient=0.3),
        "static_kinetic": _kind(StaticKinetic, problem="tangential", static_coefficient=0.4, kinetic_coefficient=0.3),
    },
    "load": {
        "force": _kind(Force, force="100 N"),
        "depth": _kind(Depth, depth="5 um"),
        "radius": _kind(Radius, radius="0.1 mm"),
    },
    "lateral": {
        "shift": _kind(Shift, shift="1 nm"),
        "shear_force": _kind(ShearForce, shear_force="1 mN"),
        "angle": _kind(Angle, problem="torsion", angle="1 mrad"),
        "torque": _kind(Torque, problem="torsion", torque="1 mN m"),
    },
    "problem": {
        "indentation": _kind(Indentation, "popov_hess_2015", "galin_1946", "sneddon_1965", "jaeger_1995"),
        "yield_onset": _kind(
            YieldOnset,
            "johnson_1985",
            "popov_hess_2015",
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
        ),
        "adhesive_indentation": _kind(
            AdhesiveIndentation, "popov_hess_2015", "johnson_kendall_roberts_1971", "maugis_1992"
        ),
        "pull_off": _kind(PullOff, "popov_hess_2015", "johnson_kendall_roberts_1971"),
        "equilibrium": _kind(
            Equilibrium, "popov_hess_2015", "johnson_kendall_roberts_1971", "guduru_2007", reach="10 um", count=200
        ),
        "adhesive_cycle": _kind(
            AdhesiveCycle,
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            path={"kind": "depth", "depth": THERE_AND_BACK},
        ),
        "tangential": _kind(Tangential, path={"kind": "program", "steps": TO_AND_FRO}),
        "torsion": _kind(Torsion, path={"kind": "program", "steps": TWIST}),
        "elastic_plastic_particle": _kind(
            ElasticPlasticParticle,
            curvature_radius="1 mm",
            solid={"kind": "elastic", "young": "1 GPa", "poisson": 0.3, "strength": "20 MPa"},
            path={"kind": "depth", "depth": ["20 um", "40 um", "0 um"]},
        ),
        "adhesive_shear": _kind(
            AdhesiveShear,
            "popov_hess_2015",
            "savkoor_briggs_1977",
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shear_force", "shear_force": "1 mN"},
        ),
        "friction_damping": _kind(
            FrictionDamping,
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
        ),
        "bimodal_damping": _kind(
            BimodalDamping,
            depth="3 um",
            depth_amplitude="1 um",
            shift_amplitude="0.5 um",
            phase="90 deg",
        ),
        "relaxation_damper": _kind(RelaxationDamper, depth="3 um", depth_amplitude="1 um", frequency="100 Hz"),
        "impact": _kind(
            Impact,
            mass="33 g",
            velocity="1 m/s",
            lateral_velocity="0.5 m/s",
            inertia="1.3e-6 kg m^2",
            lever="10 mm",
        ),
        "adhesive_impact": _kind(
            AdhesiveImpact,
            law={"kind": "short_range", "work": "50 mJ/m^2"},
            mass="33 g",
            velocity="1 mm/s",
        ),
    },
    "path": {
        "path": _kind(
            Path,
            reader=read_path,
            time=["0 s", "1 s", "2 s"],
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shift", "shift": ["0 um", "0.5 um", "-0.5 um"]},
        ),
        "program": _kind(Program, steps=TO_AND_FRO),
    },
    "step": {
        "start": _kind(Start, normal={"kind": "force", "force": "100 N"}),
        "ramp": _kind(Ramp, normal={"kind": "force", "force": "200 N"}),
        "hold": _kind(Hold),
        "oscillate": _kind(Oscillate, lateral={"kind": "shift", "shift": "0.5 um"}),
        "circle": _kind(
            Circle,
            within=[PRESSED, {"kind": "circle", "lateral": {"kind": "shift", "shift": "0.5 um"}}],
            lateral={"kind": "shift", "shift": "0.5 um"},
        ),
        "follow": _kind(Follow, within=[PRESSED, {"kind": "follow", "path": {"kind": "path"}, "cycles": 2}]),
    },
}
"""Slot -> kind -> class; kinds are unique over all slots."""

SLOTS: dict[Any, str] = {Profile: "profile", Medium: "medium", Bed: "bed", DepthGrading: "grading"}
"""Protocol -> slot: what may stand where a class asks for this contract."""

UNWRITTEN: frozenset[Any] = frozenset({Kept, OwnLaw})
"""What a study file does not name where a class takes it: a load that stays, left out; a law that is a function."""

REFUSED: dict[str, type] = {"cylinder": Cylinder}
"""Kinds that people ask for and that cannot be answered; making one raises the reason."""


def kinds() -> dict[str, Kind]:
    """Return every kind of every slot by its name."""
    return {name: line for slot in CATALOGUE.values() for name, line in slot.items()}


def kind_of(cls: type) -> str:
    """Return the name of `cls` in study files; an empty string if the catalogue does not know it."""
    return next((name for name, line in kinds().items() if line.cls is cls), "")


def slot_of(name: str) -> str:
    """Return the slot that the kind `name` belongs to."""
    return next(slot for slot, known in CATALOGUE.items() if name in known)
