"""Bodies that strike a surface: what is computed, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.adhesion import stuck
from winkler.study.chapters.answer import Answer, Caption, Chapter, Formula, then
from winkler.study.chapters.friction import moved
from winkler.study.chapters.kind import kind

__all__ = ["IMPACT", "STRUCK"]

STRUCK = Formula("The force stops the body and throws it back", r"m\,\ddot{d} = -F_N")
THROWN = Formula(
    "and along the surface it slows the body and turns it",
    r"m\,\dot{v}_x = -F_x, \quad I\,\dot{\omega} = \ell\,F_x, \quad \dot{u}_x = v_x - \omega\,\ell",
)


def thrown(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas of an impact; along the surface too, if the bodies meet askew."""
    return then(moved, STRUCK, *((THROWN,) if problem.sliding_velocity else ()))(problem)


IMPACT = Chapter(
    "friction and impacts",
    kinds={},
    answers={
        "impact": Answer(
            kind(
                "winkler.problems.impact.impact:Impact",
                mass="33 g",
                velocity="1 m/s",
                lateral_velocity="0.5 m/s",
                inertia="1.3e-6 kg m^2",
                lever="10 mm",
            ),
            picture=Caption("impact", "The impact", "Forces, velocities, contact and energies over time."),
            curves=(("time", "force"), ("time", "shear_force"), ("time", "angular_velocity")),
            contact_shown="the contact at its greatest depth, its springs along the surface left out",
            formulas=thrown,
        ),
        "adhesive_impact": Answer(
            kind(
                "winkler.problems.impact.adhesive_impact:AdhesiveImpact",
                law={"kind": "short_range", "work": "50 mJ/m^2"},
                mass="33 g",
                velocity="1 mm/s",
            ),
            picture=Caption("impact", "The impact", "Force, velocity, contact and energies over time."),
            curves=(("time", "force"), ("time", "velocity")),
            contact_shown="the contact at its greatest depth, without the attraction",
            formulas=then(stuck, STRUCK),
        ),
    },
)
