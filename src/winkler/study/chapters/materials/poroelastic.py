"""Poroelastic relaxation: the problem, and its formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer

__all__ = ["POROELASTIC"]

FIRST = Equation(
    "At first the liquid stays, and the body is incompressible; F₁ is the force at a modulus of one",
    r"F_0 = 4G\,F_1(d)",
)
LAST = Equation("At last the network bears the force alone", r"F_\infty = \frac{F_0}{2(1-\nu)}")
SHARE = Equation(
    "In between, the liquid diffuses out of the contact, sealed below the indenter and drained beside it",
    r"F_N(t) = F_\infty + (F_0-F_\infty)\,g(\tau,\nu), \quad \tau = \frac{D\,t}{a^2}",
)
DIFFUSION = Equation(
    "with the diffusivity from the permeability k and the viscosity of the liquid",
    r"D = \frac{2(1-\nu)}{1-2\nu}\,\frac{G\,k}{\eta}",
)

POROELASTIC = Chapter(
    "bodies that relax",
    kinds={},
    answers={
        "poroelastic_relaxation": answer(
            "winkler.problems.poroelastic.held:PoroelasticRelaxation",
            headline=("relaxation_time", "first_force", "last_force"),
            profile={"kind": "paraboloid", "curvature_radius": "1 mm"},
            shear="5 kPa",
            poisson=0.3,
            diffusivity="1e-9 m^2/s",
            depth="20 um",
            time={"from": "0.1 s", "to": "1000 s", "count": 33, "spacing": "log"},
            picture=Caption(
                "poroelastic",
                "The force over time",
                "Force from that of the incompressible body to that of the drained one.",
            ),
            curves=(("time", "force"),),
            pictured=PicturedContact.NONE,
            formulas=(FIRST, LAST, SHARE, DIFFUSION),
        ),
    },
)
