"""Wear of height maps: its problem and formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import WORN_SHAPE, Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.maps.pressed_maps import PRESSED
from winkler.study.chapters.rough import ELEMENTS, STAMP

SLID = {
    **PRESSED,
    "topography": {**STAMP, "shape": [32, 32], "seed": 1},
    "load": {"kind": "force", "force": "100 N"},
}

WORN = Equation("Worn depth of every pixel (Archard)", r"\frac{\mathrm{d}h}{\mathrm{d}s} = \kappa\,p(x,y)")
STAGE = Equation(
    "In each stage of a step the worn depth of a pixel is proportional to its pressure at the end of the stage",
    r"w_1 = w + \gamma\,\kappa\,p_1\,\Delta s, \quad \gamma = 1-\frac{1}{\sqrt{2}}",
)
BALANCE = Equation(
    "The total wear is the wear rate times the integral of the force over the distance",
    r"V = \kappa\int F_N\,\mathrm{d}s",
)

SURFACE_WEAR = Chapter(
    "wear of surfaces",
    kinds={},
    answers={
        "surface_wear": answer(
            "winkler.problems.surface_wear.wear:SurfaceWear",
            unstressed=WORN_SHAPE,
            question="How does a measured or rough surface run in while it slides?",
            page="chapters/surfaces/surface-wear.md",
            en="running-in wear of rough surface worn map smoothing polishing topography after wear asperity wear cylinder liner mild wear roughness evolution plateau honing honed liner run-in surfaces mating asperities flatten while running in",
            de="einlauf verschleiss raue oberfläche glätten polieren rauheit nach verschleiss honen plateauhonen einlaufen",
            fr="rodage usure surface rugueuse polissage évolution de la rugosité rodage honage",
            headline=("worn_volume", "worn_depth", "rms_height", "area", "peak_pressure"),
            says={"worn_volume": "{worn_volume} are worn off, {worn_depth} deep"},
            contact=SLID,
            distance=["0 m", "0.01 m", "0.05 m", "0.2 m"],
            picture=Caption(
                "running_in",
                "The surface runs in",
                "Heights before and after wear, worn depth, pressures at the first and the last distance; contact "
                "area, pressures, heights and wear volume over the sliding distance.",
            ),
            curves=(
                ("distance", "worn_volume"),
                ("distance", "rms_height"),
                ("distance", "area"),
                ("distance", "peak_pressure"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, WORN, STAGE, BALANCE),
        ),
    },
)
