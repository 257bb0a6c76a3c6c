"""Kinds of viscoelastic bodies: solids, laws of temperature, media."""

from __future__ import annotations

from winkler.study.chapters.answer import Kinds
from winkler.study.chapters.kind import kind

__all__ = ["RELAXING_BODIES"]

RUBBER = {"kind": "standard_solid", "relaxed_shear": "1 MPa", "shear": "3 MPa", "relaxation_time": "0.1 s"}
FILM = {"kind": "elastic", "young": "2.98 MPa", "poisson": 0.49}

RELAXING_BODIES: Kinds = {
    "solid": {
        "standard_solid": kind(
            "winkler.materials.spring_and_dashpot:StandardSolid",
            en="standard linear solid zener model three parameter",
            de="zener modell",
            fr="solide de zener",
            relaxed_shear="1 MPa",
            shear="3 MPa",
            relaxation_time="0.1 s",
        ),
        "maxwell": kind(
            "winkler.materials.spring_and_dashpot:Maxwell",
            en="maxwell material spring and dashpot in series",
            de="",
            fr="",
            shear="3 MPa",
            relaxation_time="0.1 s",
        ),
        "kelvin_voigt": kind(
            "winkler.materials.spring_and_dashpot:KelvinVoigt",
            en="kelvin-voigt spring and dashpot in parallel",
            de="",
            fr="",
            shear="1 MPa",
            viscosity="0.1 MPa s",
        ),
        "prony": kind(
            "winkler.materials.viscoelastic:Prony",
            en="prony series maxwell-wiechert generalised maxwell relaxation terms",
            de="prony reihe",
            fr="série de prony",
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
            en="springpot power-law rheology power law of cells weak power law",
            de="potenzgesetz rheologie",
            fr="rhéologie en loi de puissance",
            shear="2 MPa",
            time_scale="1 s",
            exponent=0.2,
            shortest="0.1 ms",
            longest="100 s",
        ),
        "fractional_zener": kind(
            "winkler.materials.fractional:FractionalZener",
            "bagley_torvik_1983",
            en="springpot fractional derivative fractional calculus viscoelasticity",
            de="fraktional",
            fr="fractionnaire",
            relaxed_shear="1 MPa",
            shear="3 MPa",
            relaxation_time="0.1 s",
            exponent=0.5,
            shortest="0.1 ms",
            longest="100 s",
        ),
        "relaxation_data": kind(
            "winkler.materials.relaxation_data:RelaxationData",
            en="relaxation modulus data table measured relaxation",
            de="relaxationsdaten",
            fr="données de relaxation",
            reader="winkler.io.tables.relaxation_table:read_relaxation",
            time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"],
            shear=["3.6 MPa", "2.9 MPa", "1.9 MPa", "1.3 MPa", "1.1 MPa"],
        ),
        "creep_data": kind(
            "winkler.materials.relaxation_data:CreepData",
            en="creep compliance data table",
            de="kriechdaten",
            fr="données de fluage",
            reader="winkler.io.tables.relaxation_table:read_creep",
            time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"],
            compliance=["0.28 1/MPa", "0.34 1/MPa", "0.52 1/MPa", "0.76 1/MPa", "0.9 1/MPa"],
        ),
        "dynamic_data": kind(
            "winkler.materials.relaxation_data:DynamicData",
            en="storage and loss modulus data table dma file",
            de="dma daten",
            fr="données dynamiques",
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
            en="wlf shift factor glass transition",
            de="",
            fr="",
            problem="viscoelastic_indentation",
            reference_temperature="25 degC",
            first_constant=8.86,
            second_constant="101.6 K",
        ),
        "arrhenius": kind(
            "winkler.materials.temperature:Arrhenius",
            problem="viscoelastic_indentation",
            reference_temperature="25 degC",
            activation_energy="80 kJ/mol",
        ),
    },
    "layer": {
        "viscoelastic_layer": kind(
            "winkler.materials.relaxing_layer:ViscoelasticLayer",
            problem="relaxation_test",
            solid=RUBBER,
            thickness="1 mm",
        ),
    },
    "medium": {
        "viscoelastic_half_space": kind(
            "winkler.media.relaxing.viscoelastic:ViscoelasticHalfSpace",
            "lee_radok_1960",
            en="polymer rubber elastomer relaxing prony material viscous solid",
            de="viskoelastischer körper gummi elastomer prony",
            fr="solide viscoélastique élastomère caoutchouc prony",
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
        "viscoelastic_coated_half_space": kind(
            "winkler.media.relaxing.layered:ViscoelasticCoatedHalfSpace",
            "lee_radok_1960",
            "barber_1974",
            en="polymer film rubber coating soft layer on glass viscoelastic layer paint",
            de="polymerschicht gummischicht viskoelastische beschichtung",
            fr="couche polymère revêtement viscoélastique film de caoutchouc",
            problem="relaxation_test",
            layers=[{"kind": "viscoelastic_layer", "solid": RUBBER, "thickness": "1 mm"}],
            on={"kind": "elastic", "young": "3 GPa", "poisson": 0.35},
        ),
        "poroelastic_film": kind(
            "winkler.media.relaxing.poroelastic:PoroelasticFilm",
            "biot_1941",
            "mcnamee_gibson_1960",
            en="hydrogel layer cartilage wet film biphasic layer contact lens cartilage layer biphasic layer",
            de="hydrogelschicht knorpelschicht",
            fr="couche d'hydrogel cartilage",
            problem="relaxation_test",
            shear="5 kPa",
            poisson=0.3,
            diffusivity="1e-9 m^2/s",
            thickness="1 mm",
        ),
    },
}
