"""Round bodies that yield: problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.normal import STRONG, normal_formulas

__all__ = ["PLASTIC", "YIELDING"]

UP = (5, 10, 20, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500)
"""Forces up to the greatest [N]."""

YIELDING = (
    Equation(
        "Each body stands against a share s of the gap; p_el is what it would bear if it stayed elastic",
        r"p_{el} = \frac{2E_i\,s_i}{\pi a^2}\int_0^a \left(g(a)-g(x)\right)\,\mathrm{d}x, \quad "
        r"E_i = \frac{E}{1-\nu^2}",
    ),
    Equation(
        "Beyond the onset of yield it bears less, and reaches the same radius with less depth",
        r"p = p_{el}\,e^{-L(p_{el}/Y)}, \quad d = g(a)\left(\frac{s_1}{\Gamma_1}+\frac{s_2}{\Gamma_2}\right), \quad "
        r"F_N = \pi a^2 p",
    ),
    Equation(
        "The springs that come back are those of the elastic contact and of an even pressure",
        r"q(x) = E^* d_e\left[\theta\left(1-\frac{g(x)}{g(a)}\right)"
        r"+(1-\theta)\sqrt{1-\frac{x^2}{a^2}}\right], \quad d_0 = d-d_e",
    ),
)

PLASTIC = Chapter(
    "metals that yield",
    kinds={},
    answers={
        "plastic_indentation": answer(
            "winkler.problems.plastic.indentation:PlasticIndentation",
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
                "Force and contact radius over the depth, pressed in and let go, dotted where yield begins; the "
                "surface under the greatest load and after it.",
            ),
            curves=(("depth", "force"), ("depth", "radius")),
            pictured=PicturedContact.NONE,  # an elastic contact bears pressures that a metal does not
            formulas=followed_by(normal_formulas, *YIELDING),
        ),
    },
)
