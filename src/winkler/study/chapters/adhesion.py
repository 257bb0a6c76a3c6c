"""Adhesion: laws, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import TENSE, Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import bed_formulas
from winkler.values.checks.contract import is_a

APPROACH_AND_RETRACTION = [
    {"from": "-5 nm", "to": "5 nm", "count": 41},
    {"from": "5 nm", "to": "-5 nm", "count": 41},
]

STRETCHED_SPRINGS = Equation(
    "Springs of the stiffness c_N per length follow the profile up to the contact edge, where they are stretched",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad s = g(a) - d > 0",
)
GRIFFITH = Equation(
    "The edge is in equilibrium if the energy released when it recedes equals the work of adhesion of the opened "
    "surface",
    r"\frac{c_N(a)\,s^2}{2\pi a} = w, \quad s(a) = \sqrt{\frac{2\pi a w}{c_N(a)}}, \quad d(a) = g(a)-s(a)",
)
ADHESIVE_FORCE = Equation(
    "The sum of the spring forces is the normal force; depth and force follow for every contact radius",
    r"F_N(a) = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x, \quad k(a) = 2\int_0^a c_N\,\mathrm{d}x",
)
RING = Equation(
    "Around the contact, up to c, the surfaces attract each other with the stress of the law, which pulls the springs "
    "there by (written for a homogeneous solid)",
    r"u(x) = -\frac{2\sigma_0}{E^*}\sqrt{c^2-x^2}, \quad a < x < c, \quad "
    r"d = g(a) - \frac{2\sigma_0}{E^*}\sqrt{c^2-a^2}",
)
RING_END = Equation(
    "The cohesive zone ends where the gap equals the range of the attraction", r"h(c) = \frac{w}{\sigma_0}"
)
RINGED_FORCE = ADHESIVE_FORCE._replace(latex=r"F_N = 2\int_0^c c_N\,u\,\mathrm{d}x, \quad u(x) = d-g(x) \;\; (x < a)")
LONG_RANGE_FORCE = Equation(
    "Long-range attraction adds a tensile force without deformation; R is the radius of curvature at the apex",
    r"d = g(a), \quad F_N(a) = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x - 2\pi R w",
)
STABILITY = Equation(
    "Condition of stability with the machine stiffness k_m (zero for a dead load, infinite for fixed grips)",
    r"\frac{\mathrm{d}}{\mathrm{d}a}\left(d + \frac{F_N}{k_m}\right) > 0",
)
CYCLE_LOSS = Equation(
    "Between jumps the work of the machine is stored, except for the hysteresis of the work of adhesion; in a jump "
    "the decrease of the potential energy is dissipated",
    r"\mathrm{d}W = F_N\,\mathrm{d}D, \quad D = d + \frac{F_N}{k_m}",
)
SHEARED_EDGE = Equation(
    "Normal and tangential springs together release the surface energy; the contact shrinks under shear",
    r"c_N(a)\,s^2 + c_T(a)\,u_x^2 = 2\pi a w, \quad F_x = 2u_x\int_0^a c_T\,\mathrm{d}x",
)

DUGDALE = "winkler.laws.adhesion:Dugdale"
LONG_RANGE = "winkler.laws.adhesion:DerjaguinMullerToporov"


def adhesion_formulas(problem: Any, *more: Equation) -> tuple[Equation, ...]:
    """Return the formulas of springs, edge and force under the law of a problem."""
    if is_a(problem.law, DUGDALE):  # with a ring of attraction the fields follow differently
        return bed_formulas(problem.bed, (RING, RING_END, RINGED_FORCE, STABILITY, *more), ())
    springs = (LONG_RANGE_FORCE,) if is_a(problem.law, LONG_RANGE) else (STRETCHED_SPRINGS, GRIFFITH, ADHESIVE_FORCE)
    return bed_formulas(problem.bed, (*springs, STABILITY, *more))


def cycle_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a cycle, in which energy is lost."""
    return adhesion_formulas(problem, CYCLE_LOSS)


def shear_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a sheared contact."""
    if is_a(problem.law, DUGDALE, LONG_RANGE):
        return adhesion_formulas(problem)
    return bed_formulas(problem.bed, (STRETCHED_SPRINGS, SHEARED_EDGE, ADHESIVE_FORCE))


ADHESION = Chapter(
    "adhesion",
    kinds={
        "law": {
            "short_range": kind(
                "winkler.laws.adhesion:ShortRange",
                "johnson_kendall_roberts_1971",
                en="jkr johnson kendall roberts short-range attraction",
                de="jkr",
                fr="jkr",
                problem="adhesive_indentation",
                work="50 mJ/m^2",
            ),
            "dugdale": kind(
                "winkler.laws.adhesion:Dugdale",
                "maugis_1992",
                en="maugis cohesive zone constant attraction strength range of attraction",
                de="maugis kohäsivzone",
                fr="maugis zone cohésive",
                problem="adhesive_indentation",
                work="50 mJ/m^2",
                strength="1 MPa",
            ),
            "derjaguin_muller_toporov": kind(
                "winkler.laws.adhesion:DerjaguinMullerToporov", "derjaguin_1975", work="50 mJ/m^2"
            ),
        },
    },
    answers={
        "adhesive_indentation": answer(
            "winkler.problems.adhesion.indentation:AdhesiveIndentation",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "maugis_1992",
            unstressed=TENSE,
            question="How deep does a sticky body sink in, and how large is its contact?",
            page="chapters/adhesion.md",
            key="adhesion",
            en="stiction stickyness sticking cling grip of a gecko mems stiction release micro device jkr dmt maugis dugdale adhesion sticky bead afm pull-off work of adhesion surface energy van der waals glue tabor parameter does it stick tacky stickiness colloid probe kendall gecko wet particle sticking snap johnson kendall roberts derjaguin muller toporov jkr convention work of adhesion contact printing particle on wall toner electrostatic no wafer wring gauge block fuller tabor lens sticks transition jkr dmt spatula hair pad wall climbing stamp how to implement jkr cohesion particles",
            de="adhäsion haftung jkr dmt klebt haftkraft oberflächenenergie klebrig haftet es van der waals abziehkraft johnson kendall roberts staubhaftung haftkraft oberflächenenergie",
            fr="collage coller colle adhésion collant jkr dmt énergie de surface force d'adhérence est-ce que ça colle van der waals adhérence collage johnson kendall roberts énergie d'adhésion",
            headline=("force", "depth", "radius", "stiffness"),
            pictured=PicturedContact.EDGE,
            formulas=adhesion_formulas,
        ),
        "pull_off": answer(
            "winkler.problems.adhesion.pull_off:PullOff",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            unstressed=TENSE,
            question="Which force pulls a sticky body off?",
            page="chapters/adhesion.md",
            en="peel a sphere off a surface stiction unstick pull off force separation detachment how strong does it stick adhesive strength peel tear off debonding lift-off detach critical force retract curve minimum snap-off break a bead off adhesion force tear loose remove a particle removal force",
            de="abreisskraft abzugskraft ablösen abziehen haftkraft wie stark haftet trennen abheben pull-off-kraft losreissen abreissen löst sich",
            fr="force d'arrachement décollement détachement force de séparation arracher force d'adhérence décolle arracher bille décolle",
            event="at which the contact separates",
            headline=("force", "depth", "radius"),
            says={"force": "the contact pulls off at {force:size}"},
            picture=Caption("pull_off", "Where the contact separates", "Among all states of equilibrium, the point."),
            pictured=PicturedContact.EDGE,
            contact_shown="the contact just before it separates",
            formulas=adhesion_formulas,
        ),
        "equilibrium": answer(
            "winkler.problems.adhesion.equilibrium:Equilibrium",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            unstressed=TENSE,
            question="Which equilibria does a sticky contact have, and which of them are stable?",
            page="chapters/adhesion.md#pulling-off",
            en="stability branches unstable equilibrium jump into contact snap-in stable curve of adhesion",
            de="gleichgewicht stabilität instabil sprung in den kontakt zweige",
            fr="équilibre stabilité instable saut au contact branches",
            reach="10 um",
            count=200,
            picture=Caption(
                "equilibria",
                "All states of equilibrium",
                "Solid where they are stable; the arrows are jumps from the ends of the stable branches.",
            ),
            pictured=PicturedContact.EDGE,
            contact_shown="the widest stable contact of the curve",
            compared=("force", "radius"),
            formulas=adhesion_formulas,
        ),
        "adhesive_cycle": answer(
            "winkler.problems.adhesion.cycle:AdhesiveCycle",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            unstressed=TENSE,
            question="Where does a sticky tip snap in and off, and how much energy is lost on the way?",
            page="chapters/adhesion.md#pulling-off",
            en="approach and retract force-distance curve snap-in pull-off hysteresis loading unloading cantilever adhesion hysteresis loss of sticking energy afm force curve simulated snap-off distance loading and unloading differ adhesive hysteresis loop energy lost in approach and retract",
            de="annähern und zurückziehen kraft-abstands-kurve hysterese einschnappen adhäsionshysterese zyklus",
            fr="approche et retrait courbe de force hystérésis d'adhésion cycle saut cantilever",
            headline=("dissipation", "hysteresis"),
            says={"dissipation": "the path dissipates {dissipation} in jumps"},
            path={"kind": "depth", "depth": APPROACH_AND_RETRACTION},
            picture=Caption(
                "cycle",
                "Approach and retraction",
                "The contact follows the states of equilibrium, and jumps along the arrows where it becomes unstable.",
            ),
            pictured=PicturedContact.EDGE,
            contact_shown="the widest contact of the cycle",
            compared=("force", "radius"),
            formulas=cycle_formulas,
        ),
        "adhesive_shear": answer(
            "winkler.problems.adhesion.shear:AdhesiveShear",
            "popov_hess_2015",
            "savkoor_briggs_1977",
            unstressed=TENSE,
            question="How much does a sticky contact shrink when it is sheared, approximately?",
            page="chapters/adhesion.md#sheared-without-slip",
            en="adhesion under shear sheared bead savkoor briggs friction of sticky contact peeling by shear gecko toe pushing a sticky particle sideways",
            de="adhäsion unter schub scherung klebende kugel seitlich geckos",
            fr="adhésion sous cisaillement bille collante cisaillée",
            headline=("shear_force", "shift", "force", "depth", "radius"),
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shear_force", "shear_force": "1 mN"},
            picture=Caption(
                "shear",
                "The contact shrinks as it is sheared",
                "The curve ends at the tangential displacement beyond which no equilibrium exists.",
            ),
            pictured=PicturedContact.EDGE,
            contact_shown="the contact under the last load, without friction",
            formulas=shear_formulas,
        ),
    },
)
