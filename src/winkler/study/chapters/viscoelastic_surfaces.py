"""Viscoelastic contacts, sheared, sliding or adhesive: laws of the edge, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import BACK, PLANE_FOUNDATION
from winkler.study.chapters.viscoelastic import (
    BED,
    DETACHMENT,
    FORCE,
    PLANE_KEPT,
    SPRINGS,
    relaxing_formulas,
)
from winkler.values.checks.contract import is_a

ALONG = Equation(
    "The tangential load of every spring is a hereditary integral of its displacement; normal and tangential moduli "
    "have one relaxation function, because Poisson's ratios are constant",
    r"q_x(x,t) = \int_0^t G^*(t-t')\,\frac{\partial u_t(x,t')}{\partial t'}\,\mathrm{d}t'",
)
SLIDES = Equation("It slides where this load reaches the friction limit", r"|q_x(x,t)| \le \mu\,q(x,t)")
SHIFTED = Equation("The spring forces add up to the tangential force", r"F_x(t) = 2\int_0^{a(t)} q_x(x,t)\,\mathrm{d}x")
LOSSES = Equation(
    "The work is stored, dissipated in the bodies, or dissipated by friction",
    r"\int F_N\,\mathrm{d}d + \int F_x\,\mathrm{d}u_x = U + W_b + W_f",
)
CYCLE_LOSSES = Equation(
    "In a periodic cycle the work is dissipated in the bodies or by friction",
    r"\oint F_N\,\mathrm{d}d + \oint F_x\,\mathrm{d}u_x = W_b + W_f",
)
AROUND = Equation(
    "In torsion the load is a hereditary integral of the angle; the spring slides at the bound that follows from the "
    "pressure at larger radii",
    r"q_\theta(x,t) = x\int_0^t 8\,G_t(t-t')\,\frac{\mathrm{d}\varphi}{\mathrm{d}t'}\,\mathrm{d}t', \quad "
    r"|q_\theta| \le 4\mu\,x\int_x^a \frac{p(r,t)\,\mathrm{d}r}{\sqrt{r^2-x^2}}",
)
TURNED = Equation("Torque of the spring forces", r"M_z(t) = 2\int_0^{a(t)} x\,q_\theta(x,t)\,\mathrm{d}x")
TWIST_LOSSES = Equation(
    "The work is stored, dissipated in the bodies, or dissipated by friction",
    r"\int F_N\,\mathrm{d}d + \int M_z\,\mathrm{d}\varphi = U + W_b + W_f",
)
PASSING_SPRINGS = Equation(
    "In the frame of the body, every spring is compressed from the leading edge on, and relaxes under the body",
    r"q(x) = \int_x^a E^*\left(\frac{x'-x}{v}\right)\,g'(x')\,\mathrm{d}x'",
)
BORNE_LOAD = Equation(
    "until it separates; the spring forces add up to the normal force", r"F_N = \int_{x_2}^a q(x)\,\mathrm{d}x"
)
RESISTANCE = Equation(
    "The front carries more load than the back, so the one-dimensional foundation resists the motion; the resistance "
    "of the body is lower by a three-dimensional correction",
    r"F_{x,1} = \int_{x_2}^a q(x)\,g'(x)\,\mathrm{d}x",
)
RELAXED = Equation(
    "The body is assumed fully relaxed; springs follow the profile up to the edge, where they are stretched",
    r"q(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad F_N = 2\int_0^a q\,\mathrm{d}x",
)
OPENING = Equation(
    "The speed of the contact edge follows from the energy release rate by the law of Gent and Schultz",
    r"\frac{c_N(a)\,(g(a)-d)^2}{2\pi a} = w_0\left[1+\left(\frac{|\dot{a}|}{v_0}\right)^n\right]",
)
SATURATING = Equation(
    "The edge speed follows from the energy release rate; at high speed the work of adhesion has a limit",
    r"\frac{c_N(a)\,(g(a)-d)^2}{2\pi a} = w(|\dot{a}|), \quad w(0) = w_0, \quad w(v_0) = \frac{w_0+w_\infty}{2}, "
    r"\quad w \to w_\infty",
)
MACHINE = Equation("while the drive of the machine moves", r"D(t) = d + \frac{F_N}{k_m}")
SPENT_WORK = Equation("Work of the machine that is not stored is dissipated", r"\int F_N\,\mathrm{d}D = U + W")


def _peeling_formulas(problem: Any) -> tuple[Equation, ...]:
    opening = SATURATING if is_a(problem.law, "winkler.laws.crack:SaturatingWork") else OPENING
    return (BACK if is_a(problem.bed, PLANE_FOUNDATION) else PLANE_KEPT, RELAXED, opening, MACHINE, SPENT_WORK)


VISCOELASTIC_SURFACES = Chapter(
    "bodies that relax",
    kinds={
        "law": {
            "rate_dependent_work": kind(
                "winkler.laws.crack:RateDependentWork",
                "maugis_barquins_1978",
                work="50 mJ/m^2",
                reference_speed="1 um/s",
                exponent=0.6,
            ),
            "saturating_work": kind(
                "winkler.laws.crack:SaturatingWork",
                work="50 mJ/m^2",
                fast_work="1 J/m^2",
                reference_speed="1 mm/s",
                exponent=0.5,
            ),
        },
    },
    answers={
        "sliding_resistance": answer(
            "winkler.problems.viscoelastic.sliding:SlidingResistance",
            question="What resistance does a ball meet when it rolls or slides over rubber, approximately?",
            page="chapters/viscoelastic.md#struck-rubbed-rolled-over-pulled-off",
            en="rolling resistance rubber hysteresis friction sliding on rubber tyre tire rolling loss hysteretic loss ball on rubber ploughing viscoelastic drag ploughing of rubber coefficient of rolling friction ball rolls on soft material ball on polymer drag drags hard wheel on soft polymer without friction hard tip ploughs through a soft surface rolling torque of a bearing drag torque",
            de="rollwiderstand gummi hysteresereibung reifen kugel auf gummi gleitwiderstand rollreibung rollreibungskoeffizient spitzen pflügen weiche oberfläche",
            fr="énergie perdue par un pneu en roulant perd énergie roule résistance au roulement caoutchouc frottement d'hystérésis pneu bille sur caoutchouc puissance perdue roue sol viscoélastique résistance au roulement d'une bille",
            headline=("coefficient", "shear_force", "depth"),
            bed=BED,
            normal={"kind": "force", "force": "1 N"},
            speed={"from": "0.1 mm/s", "to": "1 m/s", "count": 17, "spacing": "log"},
            picture=Caption(
                "sliding",
                "Resistance to sliding or rolling",
                "Resistance and coefficient of friction over the speed, and the springs at the speed of maximum "
                "resistance.",
            ),
            curves=(("speed", "coefficient"), ("speed", "shear_force"), ("speed", "depth")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(relaxing_formulas, PASSING_SPRINGS, BORNE_LOAD, RESISTANCE),
        ),
        "viscoelastic_adhesion": answer(
            "winkler.problems.viscoelastic.adhesion:ViscoelasticAdhesion",
            question="Which force pulls a body off sticky rubber, and how does it depend on speed?",
            page="chapters/viscoelastic.md#struck-rubbed-rolled-over-pulled-off",
            en="tack rubber sticky tape pressure sensitive adhesive psa peeling rate dependent adhesion gripper dwell time soft adhesive crack speed suction pad probe tack tack test probe tack kinetically controlled stamp transfer printing adhesive tape speed dependent pull rubber sticks more strongly when pulled quickly faster pull",
            de="klebrigkeit tack gummi klebeband haftklebstoff abziehgeschwindigkeit greifer kontaktzeit haftklebeband abzugskraft klebetest",
            fr="collant pégosité caoutchouc ruban adhésif pelage préhenseur vitesse temps de contact tenue d'un ruban pelage vitesse",
            headline=("lowest_force", "dissipation", "loss_per_cycle"),
            bed=BED,
            path={
                "kind": "program",
                "steps": [
                    {"kind": "start", "normal": {"kind": "depth", "depth": "5 um"}},
                    {
                        "kind": "ramp",
                        "normal": {"kind": "depth", "depth": "-25 um"},
                        "duration": "30 s",
                        "count": 60,
                    },
                ],
            },
            picture=Caption(
                "pulled_off",
                "Pull-off from rubber",
                "Force over machine travel, depth and contact radius over time, and contact edge speed.",
            ),
            curves=(("position", "force"), ("time", "radius"), ("time", "crack_speed")),
            pictured=PicturedContact.NONE,
            formulas=_peeling_formulas,
        ),
    },
    relaxing={
        "tangential": answer(
            "winkler.problems.friction.tangential:Tangential",
            headline=("dissipation", "shear_force", "shift", "stick_radius", "loss_per_cycle"),
            picture=Caption(
                "dragged",
                "The contact along its path",
                "Loop of the shear force; forces, energies and contact radius over time; springs and loads of a late "
                "contact, with separated springs that recover.",
            ),
            curves=(("shift", "shear_force"), ("time", "shear_force"), ("time", "dissipation")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(relaxing_formulas, SPRINGS, DETACHMENT, FORCE, ALONG, SLIDES, SHIFTED, LOSSES),
        ),
        "torsion": answer(
            "winkler.problems.friction.torsion:Torsion",
            headline=("dissipation", "torque", "angle", "stick_radius", "loss_per_cycle"),
            picture=Caption(
                "dragged",
                "The contact along its path",
                "Loop of the torque; torques, energies and contact radius over time; springs and loads of a late "
                "contact.",
            ),
            curves=(("angle", "torque"), ("time", "torque"), ("time", "dissipation")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(relaxing_formulas, SPRINGS, DETACHMENT, FORCE, AROUND, TURNED, TWIST_LOSSES),
        ),
        "friction_damping": answer(
            "winkler.problems.friction.damping:FrictionDamping",
            headline=("loss_per_cycle", "friction_loss", "bulk_loss", "loss_factor", "secant_stiffness", "shear_force"),
            picture=Caption("damping", "Damping by friction", "Energy loss and loss factor, and the largest loop."),
            pictured=PicturedContact.NONE,
            formulas=followed_by(relaxing_formulas, SPRINGS, FORCE, ALONG, SLIDES, SHIFTED, CYCLE_LOSSES),
        ),
        "bimodal_damping": answer(
            "winkler.problems.friction.bimodal_damping:BimodalDamping",
            headline=("loss_per_cycle", "friction_loss", "bulk_loss", "pressing_loss", "loss_stiffness"),
            picture=Caption("damping", "Damping by friction", "Energy dissipated in every closed cycle."),
            pictured=PicturedContact.NONE,
            formulas=followed_by(relaxing_formulas, SPRINGS, DETACHMENT, FORCE, ALONG, SLIDES, SHIFTED, CYCLE_LOSSES),
        ),
    },
)
