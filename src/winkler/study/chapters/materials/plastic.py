"""Round bodies that yield: problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import YIELDED, Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import STRONG, normal_formulas

UP = (5, 10, 20, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500)
"""Forces up to the greatest [N]."""

YIELDING = (
    Equation(
        "The deformation of each body fills a fraction s of the gap; p_el is the mean pressure without yielding",
        r"p_{el} = \frac{2E_i\,s_i}{\pi a^2}\int_0^a \left(g(a)-g(x)\right)\,\mathrm{d}x, \quad "
        r"E_i = \frac{E}{1-\nu^2}",
    ),
    Equation(
        "Beyond the onset of yield pressure and depth at the same contact radius are lower",
        r"p = p_{el}\,e^{-L(p_{el}/Y)}, \quad d = g(a)\left(\frac{s_1}{\Gamma_1}+\frac{s_2}{\Gamma_2}\right), \quad "
        r"F_N = \pi a^2 p",
    ),
    Equation(
        "Elastic recovery: the sum of those of an elastic contact and of a uniform pressure",
        r"q(x) = E^* d_e\left[\theta\left(1-\frac{g(x)}{g(a)}\right)"
        r"+(1-\theta)\sqrt{1-\frac{x^2}{a^2}}\right], \quad d_0 = d-d_e",
    ),
)

BOUNCING = (
    Equation(
        "The work of first loading equals the kinetic energy; the body rebounds with the recovered energy",
        r"\frac{m v^2}{2} = \int_0^{d_{max}} F_N\,\mathrm{d}d, \quad "
        r"e^2 = \frac{2}{m v^2}\int_{d_0}^{d_{max}} F_N\,\mathrm{d}d",
    ),
)

PLASTIC = Chapter(
    "metals that yield",
    kinds={
        "load": {
            "blow": kind(
                "winkler.problems.plastic.strength_from_dent:Blow",
                problem="strength_from_dent",
                mass="4.1 g",
                velocity="2 m/s",
            ),
            "restitution": kind(
                "winkler.problems.plastic.strength_from_dent:Restitution",
                problem="strength_from_dent",
                beside={"load": {"kind": "blow"}, "dent_error": "0 um"},
                restitution=0.65,
                restitution_error=0.01,
            ),
        },
    },
    answers={
        "plastic_indentation": answer(
            "winkler.problems.plastic.indentation:PlasticIndentation",
            unstressed=YIELDED,
            question="Which dent does a ball, a cone or a tip leave in a metal, and under which force?",
            page="chapters/metals.md",
            key="dent",
            en="dent depth brinelling true brinelling residual depth elastic-plastic contact elastoplastic contact fully plastic contact plastic indentation of metal brinell hardness ball indentation springback of a dent permanent dent depth pile-up sink-in unloading after yield reloading mean pressure three times yield full plasticity overload of a raceway handling damage denting hardness three times yield constraint factor metal asperities flatten plastically",
            de="eindruck tiefe bleibender eindruck brinellhärte kugeleindruck plastischer kontakt elastisch-plastischer kontakt vollplastisch eindringtiefe metall rückfederung delle dellentiefe entlastung nach dem fliessen",
            fr="empreinte profondeur empreinte permanente dureté brinell contact élastoplastique contact plastique métal retour élastique plasticité totale décharge",
            headline=("residual_depth", "largest_radius", "dissipation"),
            says={"residual_depth": "a dent {residual_depth} deep is left"},
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
            path={"kind": "force", "force": [f"{force} N" for force in (*UP, *reversed(UP[:-1]), 0)]},
            picture=Caption(
                "dent",
                "The contact along its path, and the dent",
                "Force and contact radius over the depth during loading and unloading (dotted: onset of yield); the "
                "surface under the maximum load and after it.",
            ),
            curves=(("depth", "force"), ("depth", "radius")),
            pictured=PicturedContact.NONE,  # an elastic contact bears pressures that a metal does not
            formulas=followed_by(normal_formulas, *YIELDING),
        ),
        "dent_limit": answer(
            "winkler.problems.plastic.dent_limit:DentLimit",
            "johnson_1985",
            unstressed=YIELDED,
            question="Which load leaves a dent of a given depth?",
            page="chapters/metals.md#the-load-that-a-dent-allows",
            en="load that leaves a dent of a given depth dent of a ten-thousandth of the ball diameter allowed permanent deformation of rolling element and raceway load for an allowed residual dent",
            de="last für einen zulässigen bleibenden eindruck ein zehntausendstel des kugeldurchmessers",
            fr="charge pour une empreinte permanente admissible dix-millième du diamètre de la bille",
            headline=("force", "elastic_peak_pressure", "mean_pressure", "radius"),
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
            residual_depth="1 um",
            picture=Caption(
                "dent_limit",
                "The load that leaves the dent",
                "Force and contact radius over the depth during loading and unloading, and the residual dent.",
            ),
            pictured=PicturedContact.NONE,
            formulas=followed_by(normal_formulas, *YIELDING),
        ),
        "strength_from_dent": answer(
            "winkler.problems.plastic.strength_from_dent:StrengthFromDent",
            "johnson_1985",
            unstressed=YIELDED,
            question="Which strength does a metal have, from dents of known loads or from rebounds of balls?",
            page="chapters/metals.md#the-strength-that-a-dent-tells",
            en="strength from a dent yield strength from the diameter of an indentation strength from ball indentation test meyer hardness yield strength from hardness strength from restitution strength from rebound dynamic strength from drop tests",
            de="festigkeit aus einem eindruck streckgrenze aus der härte meyerhärte festigkeit aus der stosszahl",
            fr="limite d'élasticité d'après une empreinte dureté meyer résistance d'après le rebond",
            headline=("strength", "strength_error", "law_error", "hardness"),
            bed={"kind": "foundation", "medium": {"kind": "half_space"}},
            load={"kind": "force", "force": "1 kN"},
            dent={"kind": "radius", "radius": "0.5 mm"},
            dent_error="5 um",
            picture=Caption(
                "dent_strength",
                "The dent and the strength that follows from it",
                "Force and contact radius over the depth of a body with this strength, and its dent.",
            ),
            pictured=PicturedContact.NONE,
            formulas=followed_by(normal_formulas, *YIELDING),
        ),
        "plastic_impact": answer(
            "winkler.problems.plastic.impact:PlasticImpact",
            unstressed=YIELDED,
            question="How does a ball bounce off a metal that yields, and which dent does it leave?",
            page="chapters/metals.md#struck",
            key="metal",
            en="restitution of metals restitution map dent of a dropped ball steel ball dropped on steel plate inelastic impact energy lost by plastic deformation yield velocity dynamic hardness rebound hardness leeb shore scleroscope peening dent drop height of a ball that dents",
            de="stosszahl von metall plastischer stoss rückprallhärte fallende kugel delle fliessgeschwindigkeit",
            fr="restitution des métaux choc plastique dureté par rebond bille tombante empreinte vitesse de plastification",
            headline=("restitution", "residual_depth", "duration"),
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
            mass="33 g",
            velocity=["5 mm/s", "10 mm/s", "20 mm/s", "50 mm/s", "0.1 m/s", "0.2 m/s", "0.5 m/s", "1 m/s"],
            picture=Caption(
                "metal_impact",
                "Restitution and dents",
                "Restitution, dent and contact time over the velocity (dotted: onset of yield); for one velocity "
                "force and contact radius over the depth, and the dent.",
            ),
            curves=(("velocity", "restitution"), ("velocity", "residual_depth")),
            pictured=PicturedContact.NONE,  # as above
            formulas=followed_by(normal_formulas, *YIELDING, *BOUNCING),
        ),
    },
)
