"""Friction of line contacts: paths, problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.lines.line import LOAD, LOAD_PROFILE, PRESSURE, ROLLER
from winkler.study.chapters.normal import MODULUS
from winkler.study.chapters.viscoelastic import pair_formulas

TO_AND_FRO = ["0 N/mm", "20 N/mm", "-20 N/mm", "20 N/mm"]

SLIPPING = Equation(
    "In slip zones the traction is μ p; in the stick zone it is smaller by μ times that of a narrower contact",
    r"q(x) = \mu\left[p(x;P) - p(x;\gamma)\right], \quad Q = \mu\,(P-\gamma)",
)
HISTORY = Equation(
    "Along a path the traction is a sum of such pressures, one for each load reversal that still has an effect",
    r"q(x) = \sum_j B_j\,p(x;\gamma_j)",
)
AHEAD = Equation("and the slip is the sum of the gaps outside these contacts", r"s(x) = -\sum_j B_j\,h(x;\gamma_j)")
SHIFTED = Equation(
    "A bulk stress in phase with Q displaces these contacts of a cylinder by",
    r"e_j = R\,\frac{1-\nu_1^2}{E_1}\,\frac{\sigma_B}{Q}\,(P-\gamma_j)",
)
MARCHED = Equation(
    "For any other bulk stress the path is computed step by step; in the stick zone this quantity stays constant",
    r"s(x) = \delta - \frac{1-\nu_1^2}{E_1}\,\sigma_B\,x + \frac{2}{\pi E^*}\int q(\xi)\,\ln|x-\xi|\,\mathrm{d}\xi",
)
LOST = Equation(
    "Energy dissipated by friction per length",
    r"W_d = \frac{2}{\pi E^*}\int\!\!\int t\,\mathrm{d}(Q-t)\,\mathrm{d}\ln a(\gamma)",
)

CREPT_ALONG = Equation(
    "Relative tangential displacement of the surfaces, with the creep function C",
    r"s(x,t) = \delta(t) + \frac{2}{\pi}\int\ln|x-\xi|\int_0^t C(t-t')\,\frac{\partial q(\xi,t')}{\partial t'}\,"
    r"\mathrm{d}t'\,\mathrm{d}\xi",
)
SLIPS_ALONG = Equation("In the stick zone s is constant; in slip zones", r"|q(x,t)| = \mu\,p(x,t)")

LINE_FRICTION = Chapter(
    "line contact",
    kinds={
        "line_path": {
            "line_path": kind(
                "winkler.problems.line_friction.path:LinePath",
                problem="line_tangential",
                force_per_length="100 N/mm",
                shear_force_per_length=TO_AND_FRO,
                count=20,
            ),
        },
    },
    answers={
        "line_tangential": answer(
            "winkler.problems.line_friction.tangential:LineTangential",
            "johnson_1985",
            "cattaneo_1938",
            "jaeger_1995",
            "ciavarella_1998",
            "nowell_hills_1987",
            question="Where does a pressed cylinder slip when it is pushed back and forth, also under a bulk stress?",
            page="chapters/line-friction.md",
            en="fretting cylinder dovetail blade root fretting fatigue bulk stress tension cattaneo mindlin line contact stick slip shear roller partial slip press fit spline turbine blade root attachment fir tree dovetail joint lug interference shear on cylinder rope wires",
            de="reibkorrosion schwingreibverschleiss schwalbenschwanz schaufelfuss zylinder reibung haften gleiten teilschlupf linienkontakt presssitz turbinenschaufelfuss tannenbaum reibschluss schlupfwelle",
            fr="fretting cylindre queue d'aronde pied d'aube fatigue glissement partiel contact linéique frottement emmanchement aube de turbine attache",
            headline=(
                "dissipation_per_length",
                "stick_half_width",
                "shear_force_per_length",
                "slip_shift",
                "loss_per_cycle_per_length",
            ),
            bed={**ROLLER, "medium": {"kind": "half_space", "second": {"kind": "elastic"}}},
            picture=Caption(
                "line_tangential",
                "The contact along its path",
                "Loop of the shear force, and stick and slip of the last contact.",
            ),
            curves=(
                ("slip_shift", "shear_force_per_length"),
                ("shear_force_per_length", "stick_half_width"),
                ("shear_force_per_length", "dissipation_per_length"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, LOAD_PROFILE, LOAD, PRESSURE, SLIPPING, HISTORY, AHEAD, SHIFTED, MARCHED, LOST),
        ),
    },
    relaxing={
        "line_tangential": answer(
            "winkler.problems.line_friction.tangential:LineTangential",
            headline=(
                "dissipation_per_length",
                "stick_half_width",
                "shear_force_per_length",
                "slip_shift",
                "loss_per_cycle_per_length",
            ),
            picture=Caption(
                "line_tangential",
                "The contact along its path",
                "Loop of the shear force, and stick and slip of the last contact.",
            ),
            curves=(("slip_shift", "shear_force_per_length"), ("shear_force_per_length", "dissipation_per_length")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(pair_formulas, LOAD_PROFILE, CREPT_ALONG, SLIPS_ALONG),
        ),
    },
)
