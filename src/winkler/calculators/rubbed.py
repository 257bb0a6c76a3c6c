"""Calculators of contacts that are pressed and rubbed: pushed, twisted, shaken, rolled, heated, worn."""

from __future__ import annotations

from winkler.calculators import kernels
from winkler.calculators.calculator import AnswerNumber, Calculator, Slider
from winkler.calculators.parts import (
    ALIKE,
    BALL,
    COEFFICIENT,
    FORCE,
    FRICTION,
    POISSON,
    PRESSED,
    RADIUS,
    SHARE,
    YOUNG,
    contact_radius,
    metres,
)

__all__ = ["RUBBED_ONES"]

BODIES = (RADIUS, FORCE, YOUNG, POISSON, COEFFICIENT)
BETWEEN_ALIKE = (
    "Coulomb's friction between smooth bodies of one material, so that pressure and friction do not act on each other"
)
HELD = """
[problem.contact]
kind = "indentation"
"""
ONTO_PATH = """
[problem.path]
kind = "path"
time = ["0 s", "1 s"]
normal = { kind = "force", force = {force} }
"""

TANGENTIAL = Calculator(
    "tangential", "Tangential contact", "How far is a ball displaced before it slides?", "tangential",
    (*BODIES, SHARE),
    (
        metres("shift", "u_x", "shift of the bodies", "shift[-1]"),
        AnswerNumber("shear_force", "F_x", "shear force", "N", "N", "shear_force[-1]"),
        contact_radius("radius[-1]"),
        metres("stick_radius", "c", "radius of the stick zone", "stick_radius[-1]"),
    ),
    "share", "shift",
    f"{BETWEEN_ALIKE}; pushed for the first time, under a steady normal force.",
    "chapters/friction.html",
    BALL + ALIKE + FRICTION + ONTO_PATH + 'lateral = { kind = "shear_force", shear_force = ["0 N", {=shear_force}] }\n',
    kernels.tangential,
)  # fmt: skip
TORSION = Calculator(
    "torsion", "Torsion", "Which torque twists a ball, and how much of it still sticks?", "torsion",
    (*BODIES, SHARE._replace(symbol="M_z/M_max", words="part of the greatest torque")),
    (
        AnswerNumber("angle", "φ", "angle of twist", "mrad", "rad", "angle[-1]"),
        AnswerNumber("torque", "M_z", "torque", "N mm", "N m", "torque[-1]"),
        contact_radius("radius[-1]"),
        metres("stick_radius", "c", "radius of the stick zone", "stick_radius[-1]"),
        AnswerNumber("torque_limit", "M_max", "torque at which all would slide", "N mm", "N m", "torque_limit[-1]"),
    ),
    "share", "angle",
    "Coulomb's friction; twisted for the first time, under a steady normal force. A pressure and a twist do not act on "
    "each other, whatever the materials.",
    "chapters/friction.html",
    BALL + ALIKE + FRICTION + ONTO_PATH + 'lateral = { kind = "torque", torque = ["0 N m", {=torque}] }\n',
    kernels.torsion,
)  # fmt: skip
DAMPING = Calculator(
    "damping", "Damping by friction", "What does a joint lose in every cycle of vibration?", "friction_damping",
    (*BODIES, SHARE),
    (
        AnswerNumber("loss_per_cycle", "W", "energy lost in a cycle", "uJ", "J", "loss_per_cycle"),
        AnswerNumber("shear_force", "F_x", "amplitude of the shear force", "N", "N", "shear_force"),
        metres("shift", "u_x", "amplitude of the shift", "shift"),
        contact_radius("contact.radius"),
    ),
    "share", "loss_per_cycle",
    f"{BETWEEN_ALIKE}; slow beside the waves in the bodies, and before anything is worn.",
    "chapters/friction.html",
    BALL + ALIKE + FRICTION + """
[problem.normal]
kind = "force"
force = {force}

[problem.amplitude]
kind = "shear_force"
shear_force = {=shear_force}
""",
    kernels.damping,
)  # fmt: skip
ROLLING = Calculator(
    "rolling", "Rolling", "How much creepage does a wheel need to pull?", "line_rolling",
    (
        RADIUS._replace(words="radius of the cylinder", low=10.0, start=500.0),
        Slider("force", "P", "normal force per length", "N/mm", 1.0, 10_000.0, 500.0),
        YOUNG, POISSON, COEFFICIENT, SHARE._replace(symbol="Q/μP"),
    ),
    (
        AnswerNumber("creepage", "ξ", "creepage", "%", "", "longitudinal_creepage"),
        AnswerNumber("shear_force", "Q", "force per length along the surface", "N/mm", "N/m", "shear_force_per_length"),
        AnswerNumber("stick_share", "c/a", "part of the width that sticks", "", "", "stick_share"),
        metres("half_width", "a", "half-width of the contact", "contact.half_width"),
        AnswerNumber("peak_pressure", "p_0", "greatest pressure", "MPa", "Pa", "contact.peak_pressure"),
        AnswerNumber("loss", "W'", "loss per distance and length", "J/m^2", "J/m^2", "loss_per_area"),
    ),
    "share", "creepage",
    f"A cylinder in plane strain (Carter) that rolls steadily on a flat. {BETWEEN_ALIKE}.",
    "chapters/line-rolling.html",
    """
[problem.bed]
kind = "line_foundation"
profile = { kind = "paraboloid", curvature_radius = {curvature_radius} }
""" + ALIKE + FRICTION.replace("problem.law", "problem.friction") + """
[problem.drive]
kind = "line_shear_force"
shear_force_per_length = {=shear_force}

[problem.load]
kind = "line_force"
force_per_length = {force}
""",
    kernels.rolling,
)  # fmt: skip
CONDUCTIVITY = Slider("conductivity", "λ_1", "conductivity of the moving body", "W/(m K)", 0.1, 500.0, 45.0)
HEATING = Calculator(
    "heating", "Heat of friction", "How hot do sliding bodies get where they touch?", "friction_heating",
    (
        *BODIES,
        Slider("speed", "v", "sliding speed", "m/s", 0.001, 10.0, 1.0),
        CONDUCTIVITY,
        Slider("diffusivity", "κ_1", "thermal diffusivity of the moving body", "mm^2/s", 0.1, 200.0, 12.0),
        CONDUCTIVITY._replace(name="conductivity_2", symbol="λ_2", words="conductivity of the ball, at rest"),
    ),
    (
        AnswerNumber("temperature", "ΔT", "greatest rise of temperature", "K", "K", "first_max_temperature"),
        AnswerNumber("heat_rate", "Q", "heat of friction", "W", "W", "heat_rate"),
        AnswerNumber("first_share", "", "part that goes into the moving body", "", "", "first_share"),
        AnswerNumber("peclet", "Pe", "Peclet number v a / (2 κ)", "", "", "first_peclet"),
        contact_radius(),
    ),
    "speed", "temperature",
    "Steady sliding of smooth, thick bodies, whose greatest temperatures are equal (Blok); their own warming up, and "
    "changes of their material with it, come on top.",
    "chapters/heating.html",
    "first_speed = {speed}\n" + HELD + (BALL + ALIKE + PRESSED).replace("problem", "problem.contact") + FRICTION + """
[problem.conductors]
kind = "heat_conductors"
first = { kind = "thermal_conductor", conductivity = {conductivity}, diffusivity = {diffusivity} }
# at rest: its diffusivity does not matter in the steady state
second = { kind = "thermal_conductor", conductivity = {conductivity_2} }
""",
    kernels.heating,
)  # fmt: skip
WEAR = Calculator(
    "wear", "Wear by fretting", "In which shape does fretting wear end, and how much is lost?", "limiting_profile",
    (
        RADIUS,
        Slider("depth", "d", "indentation depth, which is constant", "um", 0.1, 100.0, 1.0),
        YOUNG, POISSON, COEFFICIENT, SHARE._replace(symbol="U/U_max", words="part of the shift at which all slides"),
    ),
    (
        AnswerNumber("worn_volume", "V", "volume worn in the end", "um^3", "m^3", "worn_volume"),
        metres("stick_radius", "c", "radius of what never slips", "stick_radius"),
        metres("radius", "a", "contact radius in the end", "radius"),
        AnswerNumber("force", "F_N", "normal force in the end", "N", "N", "force"),
        metres("shift", "U", "amplitude of the shift", "problem.amplitude.shift"),
    ),
    "share", "worn_volume",
    f"{BETWEEN_ALIKE}; the depth and the amplitude are constant, the stick zone does not wear, and the time does not "
    "matter.",
    "chapters/wear.html",
    BALL + ALIKE + FRICTION + """
[problem.normal]
kind = "depth"
depth = {depth}

[problem.amplitude]
kind = "shift"
shift = {=shift}
""",
    kernels.wear,
)  # fmt: skip
RUBBED_ONES = (TANGENTIAL, TORSION, DAMPING, ROLLING, HEATING, WEAR)
