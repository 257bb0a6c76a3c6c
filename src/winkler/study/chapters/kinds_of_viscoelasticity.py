"""Kinds of viscoelastic contacts: solids that relax, how temperature changes them, and what is asked of them."""

from __future__ import annotations

from winkler.study.chapters.kind import Kind, kind

__all__ = ["VISCOELASTICITY"]

RUBBER = {"kind": "standard_solid", "relaxed_shear": "1 MPa", "shear": "3 MPa", "relaxation_time": "0.1 s"}
FILM = {"kind": "elastic", "young": "2.98 MPa", "poisson": 0.49}
BED = {"kind": "foundation", "medium": {"kind": "viscoelastic_half_space"}}
DECADES = {"from": "1 ms", "to": "10 s", "count": 33, "spacing": "log"}
IN_AND_OUT = [
    {"kind": "start", "normal": {"kind": "depth", "depth": "0 um"}},
    {"kind": "ramp", "normal": {"kind": "depth", "depth": "100 um"}, "duration": "0.1 s", "count": 20},
    {"kind": "hold", "duration": "0.2 s", "count": 10},
    {"kind": "ramp", "normal": {"kind": "depth", "depth": "0 um"}, "duration": "0.1 s", "count": 20},
]
DRAGGED = [
    *IN_AND_OUT[:2],
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "50 um"}, "frequency": "5 Hz", "count": 16},
    *IN_AND_OUT[2:],
]

VISCOELASTICITY: dict[str, dict[str, Kind]] = {
    "solid": {
        "standard_solid": kind(
            "winkler.materials.spring_and_dashpot:StandardSolid",
            relaxed_shear="1 MPa",
            shear="3 MPa",
            relaxation_time="0.1 s",
        ),
        "maxwell": kind("winkler.materials.spring_and_dashpot:Maxwell", shear="3 MPa", relaxation_time="0.1 s"),
        "kelvin_voigt": kind("winkler.materials.spring_and_dashpot:KelvinVoigt", shear="1 MPa", viscosity="0.1 MPa s"),
        "prony": kind(
            "winkler.materials.viscoelastic:Prony",
            relaxed_shear="1 MPa",
            shears=["2 MPa", "0.5 MPa", "0.5 MPa"],
            relaxation_times=["10 ms", "0.1 s", "1 s"],
        ),
        "generalised_kelvin": kind(
            "winkler.materials.viscoelastic:GeneralisedKelvin",
            glassy_compliance="0.25 1/MPa",
            compliances=["0.5 1/MPa", "0.25 1/MPa"],
            retardation_times=["50 ms", "0.5 s"],
        ),
        "power_law_solid": kind(
            "winkler.materials.fractional:PowerLawSolid",
            "bagley_torvik_1983",
            shear="2 MPa",
            time_scale="1 s",
            exponent=0.2,
            shortest="0.1 ms",
            longest="100 s",
        ),
        "fractional_zener": kind(
            "winkler.materials.fractional:FractionalZener",
            "bagley_torvik_1983",
            relaxed_shear="1 MPa",
            shear="3 MPa",
            relaxation_time="0.1 s",
            exponent=0.5,
            shortest="0.1 ms",
            longest="100 s",
        ),
        "relaxation_data": kind(
            "winkler.materials.relaxation_data:RelaxationData",
            reader="winkler.io.tables.relaxation_table:read_relaxation",
            time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"],
            shear=["3.6 MPa", "2.9 MPa", "1.9 MPa", "1.3 MPa", "1.1 MPa"],
        ),
        "creep_data": kind(
            "winkler.materials.relaxation_data:CreepData",
            reader="winkler.io.tables.relaxation_table:read_creep",
            time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"],
            compliance=["0.28 1/MPa", "0.34 1/MPa", "0.52 1/MPa", "0.76 1/MPa", "0.9 1/MPa"],
        ),
        "dynamic_data": kind(
            "winkler.materials.relaxation_data:DynamicData",
            reader="winkler.io.tables.relaxation_table:read_dynamic",
            angular_frequency=["0.1 rad/s", "1 rad/s", "10 rad/s", "100 rad/s", "1000 rad/s"],
            storage_shear=["1.1 MPa", "1.3 MPa", "1.9 MPa", "2.9 MPa", "3.6 MPa"],
            loss_shear=["0.1 MPa", "0.25 MPa", "0.5 MPa", "0.5 MPa", "0.25 MPa"],
        ),
        "at_temperature": kind(
            "winkler.materials.at_temperature:AtTemperature",
            solid=RUBBER,
            law={"kind": "williams_landel_ferry"},
            temperature="40 degC",
        ),
    },
    "law": {
        "williams_landel_ferry": kind(
            "winkler.materials.temperature:WilliamsLandelFerry",
            "williams_landel_ferry_1955",
            problem="viscoelastic_indentation",
            reference_temperature="25 degC",
            first_constant=8.86,
            second_constant="101.6 K",
        ),
        "rate_dependent_work": kind(
            "winkler.laws.crack:RateDependentWork",
            "maugis_barquins_1978",
            work="50 mJ/m^2",
            reference_speed="1 um/s",
            exponent=0.6,
        ),
        "saturating_work": kind(
            "winkler.laws.crack:SaturatingWork",
            work="50 mJ/m^2",
            fast_work="1 J/m^2",
            reference_speed="1 mm/s",
            exponent=0.5,
        ),
        "arrhenius": kind(
            "winkler.materials.temperature:Arrhenius",
            problem="viscoelastic_indentation",
            reference_temperature="25 degC",
            activation_energy="80 kJ/mol",
        ),
    },
    "medium": {
        "viscoelastic_half_space": kind(
            "winkler.media.relaxing.viscoelastic:ViscoelasticHalfSpace",
            "lee_radok_1960",
            problem="viscoelastic_indentation",
            first=RUBBER,
        ),
        "relaxing_in_proportion": kind(
            "winkler.media.relaxing.proportional:RelaxingInProportion",
            "lee_radok_1960",
            problem="viscoelastic_indentation",
            medium={
                "kind": "coated_half_space",
                "layers": [{"kind": "layer", "solid": FILM, "thickness": "1 mm"}],
                "on": {"kind": "rigid"},
            },
            solid=RUBBER,
            shear="1 MPa",
        ),
    },
    "problem": {
        "viscoelastic_indentation": kind(
            "winkler.problems.viscoelastic.indentation:ViscoelasticIndentation",
            bed=BED,
            path={"kind": "program", "steps": IN_AND_OUT},
            count=200,
        ),
        "creep_test": kind(
            "winkler.problems.viscoelastic.material_tests:CreepTest", bed=BED, force="1 N", time=DECADES
        ),
        "relaxation_test": kind(
            "winkler.problems.viscoelastic.material_tests:RelaxationTest", bed=BED, depth="100 um", time=DECADES
        ),
        "harmonic_indentation": kind(
            "winkler.problems.viscoelastic.material_tests:HarmonicIndentation",
            bed=BED,
            normal={"kind": "depth", "depth": "100 um"},
            angular_frequency={"from": "0.1 rad/s", "to": "1000 rad/s", "count": 33, "spacing": "log"},
        ),
        "viscoelastic_tangential": kind(
            "winkler.problems.viscoelastic.tangential:ViscoelasticTangential",
            bed=BED,
            path={"kind": "program", "steps": DRAGGED},
            count=100,
        ),
        "sliding_resistance": kind(
            "winkler.problems.viscoelastic.sliding:SlidingResistance",
            bed=BED,
            normal={"kind": "force", "force": "1 N"},
            speed={"from": "0.1 mm/s", "to": "1 m/s", "count": 17, "spacing": "log"},
        ),
        "viscoelastic_adhesion": kind(
            "winkler.problems.viscoelastic.adhesion:ViscoelasticAdhesion",
            bed=BED,
            path={
                "kind": "program",
                "steps": [
                    {"kind": "start", "normal": {"kind": "depth", "depth": "5 um"}},
                    {"kind": "ramp", "normal": {"kind": "depth", "depth": "-25 um"}, "duration": "30 s", "count": 60},
                ],
            },
        ),
        "viscoelastic_impact": kind(
            "winkler.problems.viscoelastic.impact:ViscoelasticImpact",
            bed=BED,
            mass="30 g",
            velocity="1 m/s",
            count=100,
            tolerance=1e-3,
        ),
    },
}
"""Slot -> kind -> class."""
