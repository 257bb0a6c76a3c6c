"""Calculators of contacts that are pressed: elastic, graded, viscoelastic, sticky, rough, conducting."""

from __future__ import annotations

from winkler.calculators import kernels
from winkler.calculators.calculator import AnswerNumber, Calculator, Slider
from winkler.calculators.parts import ALIKE, BALL, FORCE, POISSON, PRESSED, RADIUS, YOUNG, contact_radius, metres

__all__ = ["PRESSED_ONES"]

DEPTH = metres("depth", "d", "indentation depth", "depth")
MEAN = AnswerNumber("mean_pressure", "p_m", "mean pressure", "MPa", "Pa", "mean_pressure")
STIFFNESS = AnswerNumber("stiffness", "k", "stiffness", "N/um", "N/m", "stiffness")
RESISTIVITY = Slider("resistivity", "ρ_1", "resistivity of the first body", "nohm m", 10.0, 1e4, 15.9)

NORMAL = Calculator(
    "normal", "Normal contact", "How deep, how wide and how hard does a ball press into another body?", "indentation",
    (
        RADIUS._replace(low=0.1),
        FORCE._replace(low=0.001, high=10_000.0),
        YOUNG._replace(name="young_1", symbol="E_1", words="Young's modulus of the ball", low=0.001),
        POISSON._replace(name="poisson_1", symbol="ν_1", words="Poisson's ratio of the ball"),
        YOUNG._replace(name="young_2", symbol="E_2", words="Young's modulus of the other body", low=0.001),
        POISSON._replace(name="poisson_2", symbol="ν_2", words="Poisson's ratio of the other body"),
    ),
    (
        DEPTH, contact_radius(),
        AnswerNumber("peak_pressure", "p_0", "greatest pressure", "MPa", "Pa", "peak_pressure"),
        MEAN, STIFFNESS,
    ),
    "force", "depth",
    "Elastic, smooth and without friction; the ball stands as a paraboloid, which needs a contact radius that is small "
    "beside R, and metals yield where the greatest pressure exceeds about 1.6 times their strength.",
    "method.html",
    BALL + """
[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = {young_1}, poisson = {poisson_1} }
second = { kind = "elastic", young = {young_2}, poisson = {poisson_2} }
""" + PRESSED,
    kernels.normal,
)  # fmt: skip
GRADED = Calculator(
    "graded", "Graded body", "What if the body gets stiffer with depth, as soil and graded ceramics do?", "indentation",
    (
        RADIUS._replace(words="radius of the rigid ball"), FORCE,
        Slider("young", "E_0", "Young's modulus at the depth c_0", "MPa", 1.0, 1e6, 100.0),
        Slider("depth_scale", "c_0", "depth at which it is E_0", "mm", 0.01, 1000.0, 10.0),
        Slider("exponent", "k", "exponent of E = E_0 (z/c_0)^k", "", 0.0, 0.9, 0.5, False),
        POISSON._replace(words="Poisson's ratio"),
    ),
    (DEPTH, contact_radius(), STIFFNESS, MEAN),
    "exponent", "depth",
    "The modulus vanishes at the surface and follows one power of the depth all the way; no friction, and a contact "
    "radius small beside R.",
    "chapters/graded.html",
    BALL + """
[problem.bed.medium]
kind = "graded_half_space"

[problem.bed.medium.first]
kind = "power_law_graded"
young = {young}
depth_scale = {depth_scale}
exponent = {exponent}
poisson = {poisson}
""" + PRESSED,
    kernels.graded,
)  # fmt: skip
VISCOELASTIC = Calculator(
    "viscoelastic", "Viscoelastic body", "A weight is put on rubber: how deep has it sunk after some time?",
    "creep_test",
    (
        RADIUS._replace(words="radius of the rigid ball"), FORCE._replace(low=0.001, high=100.0, start=1.0),
        Slider("relaxed_shear", "G_∞", "shear modulus when all has relaxed", "MPa", 0.01, 100.0, 1.0),
        Slider("shear", "G_1", "shear modulus that relaxes", "MPa", 0.01, 1000.0, 3.0),
        Slider("relaxation_time", "τ", "relaxation time", "s", 1e-3, 1000.0, 0.1),
        Slider("time", "t", "time since the force was put on", "s", 1e-3, 1000.0, 0.3),
    ),
    (
        metres("depth", "d", "indentation depth", "depth[0]"), contact_radius("radius[0]"),
    ),
    "time", "depth",
    "A standard linear solid that keeps its volume (ν = 0.5), a force that is put on at once and stays, no inertia, "
    "and a contact radius small beside R.",
    "chapters/viscoelastic.html",
    """force = {force}
time = [{time}]
""" + BALL + """
[problem.bed.medium]
kind = "viscoelastic_half_space"

[problem.bed.medium.first]
kind = "standard_solid"
relaxed_shear = {relaxed_shear}
shear = {shear}
relaxation_time = {relaxation_time}
""",
    kernels.viscoelastic,
)  # fmt: skip
ADHESION = Calculator(
    "adhesion", "Adhesion", "How large is the contact of a ball that sticks, and which force pulls it off?",
    "adhesive_indentation",
    (
        RADIUS._replace(unit="um", words="radius of the rigid ball", low=0.1, high=100_000.0, start=1000.0),
        Slider("young", "E", "Young's modulus", "MPa", 0.001, 100_000.0, 1.0),
        POISSON._replace(words="Poisson's ratio", start=0.5),
        Slider("work", "w", "work of adhesion", "mJ/m^2", 1.0, 10_000.0, 50.0),
        Slider("pull", "F/|F_A|", "force over the pull-off force; negative pulls", "", -0.99, 49.0, 0.0, False),
    ),
    (
        AnswerNumber("radius", "a", "contact radius", "um", "m", "radius"),
        DEPTH,
        AnswerNumber("force", "F_N", "normal force", "mN", "N", "force"),
        AnswerNumber("pull_off", "F_A", "pull-off force", "mN", "N", "pull_off.force"),
        metres("last_radius", "a_A", "contact radius when it parts", "pull_off.radius"),
    ),
    "pull", "radius",
    "Attraction without range (Johnson, Kendall and Roberts): right for soft, large or very sticky balls, with Tabor's "
    "parameter above about 5; under a dead weight.",
    "chapters/adhesion.html",
    BALL + """
[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = {young}, poisson = {poisson} }

[problem.law]
kind = "short_range"
work = {work}

[problem.load]
kind = "force"
force = {=force}
""",
    kernels.adhesion,
)  # fmt: skip
CONDUCTORS = """
[problem.conductors]
kind = "electrical_conductors"
first = { kind = "electrical_conductor", resistivity = {resistivity} }
"""
ROUGHNESS = Calculator(
    "roughness", "Roughness", "Between which bounds are conductance and stiffness of a rough contact?",
    "conductance_bounds",
    (
        RADIUS, FORCE, YOUNG, POISSON,
        Slider("roughness", "h", "height from valley to peak", "um", 0.1, 10.0, 1.0),
        RESISTIVITY._replace(symbol="ρ", words="resistivity of both bodies"),
    ),
    (
        AnswerNumber("least", "G_min", "least conductance", "S", "S", "least_conductance"),
        AnswerNumber("smooth", "G_0", "conductance without roughness", "S", "S", "smooth_conductance"),
        AnswerNumber("greatest", "G_max", "greatest conductance", "S", "S", "greatest_conductance"),
        AnswerNumber("least_stiffness", "k_min", "least stiffness", "N/um", "N/m", "least_stiffness"),
        AnswerNumber("smooth_stiffness", "k_0", "stiffness without roughness", "N/um", "N/m", "smooth_stiffness"),
        AnswerNumber("greatest_stiffness", "k_max", "greatest stiffness", "N/um", "N/m", "greatest_stiffness"),
    ),
    "roughness", "least",
    "Barber's bounds hold for elastic bodies with roughness of any shape between the two heights; where peaks yield, "
    "or a film covers them, they do not.",
    "chapters/rough.html",
    "roughness = {roughness}\nforce = {force}\n" + BALL + ALIKE + CONDUCTORS
    + 'second = { kind = "electrical_conductor", resistivity = {resistivity} }\n',
    kernels.roughness,
)  # fmt: skip
CONDUCTION = Calculator(
    "conduction", "Electrical contact", "Which resistance has a contact, from its narrow spot and from its film?",
    "constriction",
    (
        RADIUS._replace(low=0.1), FORCE._replace(low=0.001, start=1.0),
        YOUNG._replace(start=83.0), POISSON._replace(start=0.37), RESISTIVITY,
        RESISTIVITY._replace(name="resistivity_2", symbol="ρ_2", words="resistivity of the second body"),
        Slider("film", "σ_f", "resistance of the film times its area", "ohm m^2", 1e-14, 1e-7, 1e-13),
    ),
    (
        AnswerNumber("resistance", "R_c", "contact resistance", "mohm", "ohm", "resistance"),
        AnswerNumber("constriction", "R_s", "of it: constriction of both bodies", "mohm", "ohm", "constriction"),
        AnswerNumber("film_resistance", "R_f", "of it: film", "mohm", "ohm", "film_resistance"),
        contact_radius(), DEPTH,
    ),
    "force", "resistance",
    "Thick bodies, one round spot that is large beside the mean free path of electrons (about 0.04 µm), elastic; rough "
    "surfaces touch in many spots and resist more.",
    "chapters/conduction.html",
    BALL + ALIKE + CONDUCTORS
    + 'second = { kind = "electrical_conductor", resistivity = {resistivity_2} }\n'
    + 'film = { kind = "surface_film", area_resistance = {film} }\n' + PRESSED,
    kernels.conduction,
)  # fmt: skip
PRESSED_ONES = (NORMAL, GRADED, VISCOELASTIC, ADHESION, ROUGHNESS, CONDUCTION)
