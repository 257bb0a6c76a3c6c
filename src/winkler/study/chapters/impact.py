"""Impact: problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.adhesion import adhesion_formulas
from winkler.study.chapters.answer import TENSE, Caption, Chapter, Equation, answer, followed_by
from winkler.study.chapters.friction import tangential_formulas

EQUATION_OF_MOTION = Equation("The force stops the body and accelerates it back", r"m\,\ddot{d} = -F_N")
TANGENTIAL_MOTION = Equation(
    "and the tangential force changes sliding velocity and spin",
    r"m\,\dot{v}_x = -F_x, \quad I\,\dot{\omega} = \ell\,F_x, \quad \dot{u}_x = v_x - \omega\,\ell",
)


def impact_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of an impact; along the surface too, for oblique impact."""
    return followed_by(
        tangential_formulas, EQUATION_OF_MOTION, *((TANGENTIAL_MOTION,) if problem.sliding_velocity else ())
    )(problem)


IMPACT = Chapter(
    "friction and impacts",
    kinds={},
    answers={
        "impact": answer(
            "winkler.problems.impact.impact:Impact",
            question="How does a ball bounce, also at an angle and with spin?",
            page="chapters/friction.md#striking",
            key="bounce",
            en="ball bounces grains particles collide impact collision bounce rebound restitution drop test coefficient of restitution ball drop hit strike contact time oblique spin tennis golf shot peening granular dem collide how hard does it hit shock ping pong hertz theory of impact duration of contact dropped ball measured contact time inelastic collision elastic collision billiard ball side spin cushion hail marble seed bearing dropped hammer newton cradle particle wall collision rotation collision time step granular flow billiards",
            de="stoss aufprall stosszahl kontaktzeit prallen springen rückprall kollision schlag fallversuch abprallen restitutionskoeffizient kontaktdauer springt die kugel kugel springt hagel billard fällt fallende herunterfallen",
            fr="bille rebondit sur une plaque choc impact rebond coefficient de restitution collision temps de contact chute percussion coefficient de restitution d'une bille durée de contact percussion billard grêle",
            headline=("restitution", "duration", "dissipation"),
            beyond="plastic_impact",
            says={"restitution": "the coefficient of restitution is {restitution}; the contact lasts {duration}"},
            mass="33 g",
            velocity="1 m/s",
            lateral_velocity="0.5 m/s",
            inertia="1.3e-6 kg m^2",
            lever="10 mm",
            picture=Caption("impact", "The impact", "Forces, velocities, contact and energies over time."),
            curves=(("time", "force"), ("time", "shear_force"), ("time", "angular_velocity")),
            contact_shown="the contact at its greatest depth, without friction",
            formulas=impact_formulas,
        ),
        "adhesive_impact": answer(
            "winkler.problems.impact.adhesive_impact:AdhesiveImpact",
            unstressed=TENSE,
            question="Does a sticky grain bounce or stay?",
            page="chapters/friction.md",
            en="grains particles collide sticky particle impact capture dust sticks aerosol critical velocity sticking powder coating cold spray adhesion bounce filter critical sticking velocity aerosol deposition bounce-off cohesive grains restitution capture efficiency of a filter fibre toner deposit cohesion of particles agglomeration pollen leaf spore grain sticking",
            de="klebendes teilchen aufprall staub haftet grenzgeschwindigkeit aerosol pulver stoss mit adhäsion staubhaftung anhaften",
            fr="impact collant particule poussière capture vitesse critique aérosol particules cohésives dépôt",
            headline=("restitution", "duration", "dissipation"),
            says={"restitution": "the coefficient of restitution is {restitution}; the contact lasts {duration}"},
            law={"kind": "short_range", "work": "50 mJ/m^2"},
            mass="33 g",
            velocity="1 mm/s",
            picture=Caption("impact", "The impact", "Force, velocity, contact and energies over time."),
            curves=(("time", "force"), ("time", "velocity")),
            contact_shown="the contact at its greatest depth, without the attraction",
            formulas=followed_by(adhesion_formulas, EQUATION_OF_MOTION),
        ),
    },
)
