"""Particles: problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import YIELDED, Caption, Chapter, Equation, answer

HALF_ELLIPSE = Equation(
    "Springs of the stiffness E_c per length stand under half an ellipse (after Zunker and Kamrin)",
    r"g(x) = \frac{A}{2}\left(1-\sqrt{1-\frac{x^2}{b^2}}\right), \quad E_c = \frac{E}{1-\nu^2}",
)
YIELD = Equation(
    "While the particle is elastic, the ellipse is that of a ball; yield begins when the mean pressure reaches",
    r"A = 4R, \quad b = R, \quad p_Y(d) = Y\left(1.75\,e^{-4.4\,d/R}+1\right)",
)
SHAPED_PARTICLE = Equation(
    "Afterwards the ellipse depends on the maximum previous depth D; d_Y is the depth at the onset of yield",
    r"b^2 = 2DR-D^2+d_Y^2-d_YR, \quad A = \frac{4\,p_Y(D)\,b}{E_c}",
)
ADHESIVE_EDGE = Equation(
    "The sum of the spring forces is the normal force; d_e is the effective depth at the edge due to adhesion",
    r"F_N = E_c\int_{-a}^{a}\left(d_e-g(x)\right)\,\mathrm{d}x, \quad g(a)-d_e = \sqrt{\frac{2\pi a w}{E_c}}",
)

PARTICLES = Chapter(
    "friction and impacts",
    kinds={},
    answers={
        "elastic_plastic_particle": answer(
            "winkler.problems.particles.elastic_plastic:ElasticPlasticParticle",
            unstressed=YIELDED,
            question="Which force does a grain of powder carry that yields and sticks?",
            page="chapters/friction.md",
            en="grains particles collide thornton ning plastic particle powder dem metal particle yielding ball plastic indentation crush elastoplastic restitution plastic thornton walton braun hysteretic granule inelastic collision of metal grains eepa model luding edinburgh walton-braun compaction tablet granule yields flowability caking plastic grain contact law cohesion agglomeration",
            de="plastisches teilchen pulver elastisch-plastisch kugel fliesst partikel granulat pressen von pulver tablettieren",
            fr="particule plastique poudre élastoplastique bille granulaire compaction comprimé",
            headline=("residual_depth", "yield_depth", "dissipation", "loss_per_cycle"),
            says={"residual_depth": "a dent {residual_depth} deep is left"},
            curvature_radius="1 mm",
            solid={"kind": "elastic", "young": "1 GPa", "poisson": 0.3, "strength": "20 MPa"},
            path={"kind": "depth", "depth": ["20 um", "40 um", "0 um"]},
            picture=Caption(
                "particle",
                "The particle along its path",
                "Force and contact radius over the depth during loading and unloading (dotted: onset of yield).",
            ),
            curves=(("depth", "force"),),
            formulas=(HALF_ELLIPSE, YIELD, SHAPED_PARTICLE, ADHESIVE_EDGE),
        ),
    },
)
