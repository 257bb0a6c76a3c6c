"""Heat of friction on contacts of any outline: maps that are given, that roll or that fret, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.heating import STEELS
from winkler.study.chapters.rough import ELEMENTS
from winkler.study.chapters.surface_friction import CERRUTI
from winkler.study.chapters.surface_rolling import COULOMB, PASSED, WHEEL
from winkler.values.checks.contract import is_a

PULLS = {
    "kind": "surface_rolling",
    "topography": {**WHEEL, "shape": [42, 35]},
    "medium": {"kind": "half_space", "second": {"kind": "elastic"}},
    "load": {"kind": "force", "force": "100 N"},
    "speed": "20 m/s",
    "drive": {
        "kind": "creepages",
        "longitudinal": {"from": 0.001, "to": 0.01, "count": 6, "spacing": "log"},
    },
}
ROLLING_FLUX = Equation(
    "Heat flux in the slip zone",
    r"q = V\,\tau\cdot s', \quad Q = \int q\,\mathrm{d}A = V\,(\xi F_x+\eta F_y+\varphi M_z)",
)
FRETTING_FLUX = Equation(
    "Mean heat flux of a cycle",
    r"q = f\,\oint\tau\cdot\mathrm{d}s, \quad Q = \int q\,\mathrm{d}A = f\,W",
)
SLIDING_FLUX = Equation("Heat flux due to friction", r"q = \tau_x\,(V_2-V_1), \quad Q = \int q\,\mathrm{d}A")
WARMED = Equation(
    "Each body moves past the contact; its temperature is a sum over pixels, each a moving source (Jaeger)",
    r"T_i(x,y) = T_i^\infty+\frac{1}{2\pi\lambda_i}\int \frac{q_i}{r}\,"
    r"e^{-\frac{1}{2\kappa_i}\left(|V_i|\,r-V_i\,(x-x')\right)}\,\mathrm{d}x'\mathrm{d}y'",
)
CONTINUOUS = Equation(
    "Both surfaces have the same temperature at each point of contact (Blok)",
    r"q_1+q_2 = q, \quad T_1 = T_2 \text{ where } p > 0",
)


def surface_heating_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a map that slides, that rolls or that frets."""
    if is_a(problem.contact, "winkler.problems.pressed_shape.surface_load:SurfaceLoad"):
        return (SLIDING_FLUX, WARMED, CONTINUOUS)
    if is_a(problem.contact, "winkler.problems.surface_friction.tangential:SurfaceTangential"):
        return (ELEMENTS, CERRUTI, COULOMB, FRETTING_FLUX, WARMED, CONTINUOUS)
    return (ELEMENTS, CERRUTI, PASSED, COULOMB, ROLLING_FLUX, WARMED, CONTINUOUS)


SURFACE_HEATING = Chapter(
    "frictional heat",
    kinds={},
    answers={
        "surface_friction_heating": answer(
            "winkler.problems.surface_heating.steady:SurfaceFrictionHeating",
            question="How hot does a contact of any outline get that slides under a map of pressures, rolls with creepage, or frets?",
            page="chapters/surfaces/surface-heating.md",
            en="temperature of a rough sliding contact map flash temperature hot spots pressure map brake disc hot spot asperity temperature "
            "temperature of rolling with creepage wheel rail heat traction martensite white etching layer wheel spin heat "
            "fretting temperature of a rough surface height map oscillating flat pin vibration heat",
            de="temperatur rauer gleitkontakt blitztemperatur heisse stellen druckkarte temperatur rollen schlupf rad schiene wärme martensit fretting raue fläche schwingend",
            fr="température contact glissant rugueux points chauds carte de pression température roulement pseudo-glissement roue rail chaleur fretting surface rugueuse va-et-vient",
            headline=("max_temperature", "heat_rate", "first_share", "mean_temperature", "x"),
            contact=PULLS,
            conductors=STEELS,
            picture=Caption(
                "surface_heating",
                "Temperatures of a contact that slides, rolls or frets",
                "Heat flux, temperature of the first body with its hottest point, and temperatures of both surfaces "
                "on the line through this point, under the last creepage.",
            ),
            curves=(("heat_rate", "max_temperature"), ("heat_rate", "mean_temperature")),
            pictured=PicturedContact.NONE,
            formulas=surface_heating_formulas,
        ),
    },
)
