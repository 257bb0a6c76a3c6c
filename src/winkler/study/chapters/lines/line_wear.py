"""Wear of line contacts: problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import WORN_SHAPE, Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.lines.line import LOAD, LOAD_PROFILE, PRESSURE, ROLLER
from winkler.study.chapters.normal import MODULUS

STEEL = {"kind": "elastic"}
STEEL_ON_STEEL = {**ROLLER, "medium": {"kind": "half_space", "first": STEEL, "second": STEEL}}
PRESSED = {"kind": "line_force", "force_per_length": "100 N/mm"}
SWING = {"kind": "line_shear_force", "shear_force_per_length": "15 N/mm"}

STUCK = Equation(
    "Under an oscillating shear force Q the stick zone is the contact under the load γ; wear does not change it",
    r"\gamma = P - \frac{Q}{\mu} = E^*\,w(c)",
)
SLIP = Equation(
    "Outside, the slip is μ times the gap of this narrower contact",
    r"s(x) = \frac{2\mu}{\pi}\,x\int_c^{x}\frac{w(b)-w(c)}{b\,\sqrt{x^2-b^2}}\,\mathrm{d}b",
)
FRETTING_RATE = Equation(
    "Each cycle every point slips four times this distance; worn depth is proportional to pressure (Archard)",
    r"\frac{\mathrm{d}f}{\mathrm{d}n} = 4\,\kappa\,p(x)\,s(x)",
)
SLIDING_RATE = Equation(
    "In sliding, the worn depth is proportional to pressure and sliding distance (Archard's law)",
    r"\frac{\mathrm{d}f}{\mathrm{d}s} = \kappa\,p(x)",
)
LAST_PRESSURE = Equation(
    "Finally the stick zone carries the whole load, the additional load like a flat punch",
    r"p_\infty(x) = p(x;\gamma)+\frac{Q/\mu}{\pi\,\sqrt{c^2-x^2}}",
)
LAST_SHAPE = Equation(
    "and the final worn depth follows with the gap h outside the narrower contact",
    r"\Delta f_\infty(x) = \frac{2\,Q}{\pi\mu E^*}\,\mathrm{arcosh}\frac{x}{c}-h(x;\gamma)",
)

LINE_WEAR = Chapter(
    "line contact",
    kinds={},
    answers={
        "line_fretting_wear": answer(
            "winkler.problems.wear.line_fretting:LineFrettingWear",
            "archard_1953",
            "ciavarella_hills_1999",
            unstressed=WORN_SHAPE,
            question="How does a fretting cylinder, spline or tube wear?",
            page="chapters/line-wear.md",
            en="fretting wear cylinder spline worn line contact tube support steam generator tube wear key spline tooth fretting key joint rope strand tube against support",
            de="fretting verschleiss zylinder passfeder keilwelle linienkontakt reibverschleiss vielkeil keilwelle zyklen schwingungsreibung",
            fr="usure par fretting cylindre cannelures contact linéique tube cannelures clavette",
            headline=("worn_depth", "worn_volume_per_length", "stick_half_width", "cycles"),
            says={"worn_depth": "the wear is {worn_depth} deep"},
            bed=STEEL_ON_STEEL,
            normal=PRESSED,
            amplitude=SWING,
            cycles=[0.0, 1e4, 1e5, 3e5, 1e6],
            count=100,
            tolerance=1e-3,
            picture=Caption(
                "line_fretting",
                "Worn by fretting",
                "Profiles, worn depth, pressure; contact, stick zone, wear volume and energy over the cycles.",
            ),
            curves=(("cycles", "worn_volume_per_length"), ("cycles", "half_width"), ("cycles", "worn_depth")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, LOAD_PROFILE, LOAD, PRESSURE, STUCK, SLIP, FRETTING_RATE),
        ),
        "line_sliding_wear": answer(
            "winkler.problems.wear.line_sliding:LineSlidingWear",
            "archard_1953",
            unstressed=WORN_SHAPE,
            question="How does a sliding roller, block or blade wear?",
            page="chapters/line-wear.md#sliding",
            en="roller wears block on ring wear cam wear piston ring wear cylinder sliding wear archard line blade",
            de="verschleiss block auf ring zylinder gleiten nocken kolbenring linienkontakt",
            fr="usure bloc sur anneau cylindre glissant segment came archard",
            headline=("worn_depth", "worn_volume_per_length", "mean_pressure", "distance"),
            says={"worn_depth": "the wear is {worn_depth} deep"},
            bed=STEEL_ON_STEEL,
            normal=PRESSED,
            distance=["0 m", "0.1 m", "0.3 m", "1 m"],
            count=100,
            tolerance=1e-3,
            picture=Caption(
                "line_sliding",
                "Worn by sliding",
                "Profiles, worn depth, pressure; contact, wear volume and mean pressure over the distance.",
            ),
            curves=(
                ("distance", "worn_volume_per_length"),
                ("distance", "half_width"),
                ("distance", "mean_pressure"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, LOAD_PROFILE, LOAD, PRESSURE, SLIDING_RATE),
        ),
        "line_limiting_profile": answer(
            "winkler.problems.wear.line_limiting_profile:LineLimitingProfile",
            "ciavarella_hills_1999",
            "popov_2014",
            unstressed=WORN_SHAPE,
            question="Which shape does a fretting line contact have in the end?",
            page="chapters/line-wear.md",
            en="final worn shape line contact end of fretting cylinder steady worn profile spline form after long fretting",
            de="endform grenzprofil verschlissen zylinder linienkontakt endzustand",
            fr="forme finale usée cylindre profil limite fretting",
            headline=("worn_depth", "worn_volume_per_length", "stick_half_width"),
            says={"worn_depth": "the wear is {worn_depth} deep in the end"},
            bed=STEEL_ON_STEEL,
            normal=PRESSED,
            amplitude=SWING,
            picture=Caption(
                "line_limit",
                "Where wear ends",
                "Final profile, worn depth, and final pressure, which acts in the stick zone only.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, LOAD_PROFILE, LOAD, PRESSURE, STUCK, LAST_PRESSURE, LAST_SHAPE),
        ),
    },
)
