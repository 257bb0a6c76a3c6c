"""Electric contacts of height maps: the problem, rough bodies, and formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.conduction import KOHLRAUSCH, PLATING
from winkler.study.chapters.kind import kind
from winkler.study.chapters.rough import ELEMENTS, STAMP
from winkler.values.checks.contract import is_a

GOLD: dict[str, Any] = {"kind": "electrical_conductor", "resistivity": "22 nohm m"}
BRONZE: dict[str, Any] = {"kind": "electrical_conductor", "resistivity": "110 nohm m"}
PLATED: dict[str, Any] = {"kind": "plated", "plating": GOLD, "thickness": "2 um", "on": BRONZE}
RIVET: dict[str, Any] = {
    "kind": "rough_profile",
    "topography": {
        "kind": "random_topography",
        "lengths": ["0.1 mm", "0.1 mm"],
        "shape": [64, 64],
        "spectrum": {
            "kind": "self_affine",
            "hurst": 0.8,
            "rms_height": "50 nm",
            "longest": "50 um",
            "shortest": "8 um",
        },
        "seed": 1,
    },
    "profile": {"kind": "paraboloid", "curvature_radius": "2 mm"},
}
PRESSED: dict[str, Any] = {
    "kind": "surface_contact",
    "topography": RIVET,
    "hardness": "1 GPa",
    "load": {"kind": "force", "force": ["0.1 N", "1 N"]},
}

SPOTS = Equation(
    "All pixels in contact have the same voltage between the bodies, which drops in constrictions and film",
    r"V = \frac{\rho_1+\rho_2}{2}\,G\,J+\sigma_f\,J, \quad I = \int J\,\mathrm{d}A",
)
PARTS = Equation(
    "The resistance is the sum of both constriction resistances and of the film resistance over the contact area",
    r"R = R_1+R_2+\frac{\sigma_f}{A}",
)
SOFT = Equation("Voltage at which a metal softens or melts", r"V_s = 2\sqrt{L\,(T_s^2-T_0^2)} \quad (V_f = 0)")
FLOW = Equation("Pressures do not exceed the hardness; in the plastic limit the contact area is", r"A = \frac{F_N}{H}")


def spot_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of the electric contact of a map."""
    bodies = (problem.conductors.first, problem.conductors.second)
    plated = any(is_a(body, "winkler.materials.conducting_body:Plated") for body in bodies)
    flows = problem.contact.hardness < float("inf")
    return (
        ELEMENTS,
        *((FLOW,) if flows else ()),
        SPOTS,
        *((PLATING,) if plated else ()),
        PARTS,
        KOHLRAUSCH,
        SOFT,
    )


SURFACE_CURRENT = Chapter(
    "current through surfaces",
    kinds={
        "topography": {
            "rough_profile": kind(
                "winkler.profiles.rough.rough_profile:RoughProfile",
                problem="surface_contact",
                topography={**STAMP, "lengths": ["1 mm", "1 mm"], "seed": 1},
            ),
        },
    },
    answers={
        "surface_constriction": answer(
            "winkler.problems.surface_current.constriction:SurfaceConstriction",
            question="What is the resistance of a rough contact that is plated, tarnished or partly plastic, and which current softens or melts it?",
            page="chapters/surfaces/surface-current.md",
            en="contact resistance of rough plated surfaces connector plating current through spots tin gold plate rough electrical terminal crimp",
            de="kontaktwiderstand rau beschichtet stecker verzinnt vergoldet strom crimp",
            fr="résistance de contact surface rugueuse plaquée connecteur étamé doré sertissage",
            headline=("resistance", "voltage", "max_temperature", "softening_current"),
            contact=PRESSED,
            conductors={"kind": "electrical_conductors", "first": PLATED, "second": PLATED},
            drive={"kind": "current", "current": "2 A"},
            softening_temperature="373 K",
            melting_temperature="1336 K",
            picture=Caption(
                "spots",
                "Spots of contact and their resistance",
                "Pressures of the spots under the last load; for many loads the parts of the resistance, the maximum "
                "temperature, and the softening and melting currents over the force.",
            ),
            curves=(
                ("force", "resistance"),
                ("force", "max_temperature"),
                ("force", "softening_current"),
                ("force", "patch_count"),
            ),
            pictured=PicturedContact.NONE,
            formulas=spot_formulas,
        ),
    },
)
