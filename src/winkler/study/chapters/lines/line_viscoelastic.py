"""Line contacts of bodies that relax: the path of their load, the problem, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.lines.line import LOAD_PROFILE, ROLLER
from winkler.study.chapters.viscoelastic import pair_formulas

RELAXING = {**ROLLER, "medium": {"kind": "viscoelastic_half_space"}}
ON_AND_OFF: dict[str, Any] = {
    "time": {"values": [0.0, 1.0, 2.0, 2.5], "unit": "s"},
    "force_per_length": {"values": [0.0, 1.0, 1.0, 0.0], "unit": "N/mm"},
    "count": 20,
}

CREPT = Equation(
    "Hereditary integral of the force per length",
    r"\ell(t) = \int_0^t C(t-t')\,\frac{\mathrm{d}P}{\mathrm{d}t'}\,\mathrm{d}t'",
)
GROWING = Equation("and while the strip widens (Lee and Radok)", r"w(a(t)) = \ell(t)")
RELAXED = Equation(
    "The load on strips wider than c relaxes like a spring, vanishes at the contact edge, and then recovers freely",
    r"q(c,t) = \int_0^t E^*(t-t')\,\frac{\partial u(c,t')}{\partial t'}\,\mathrm{d}t', \quad u = \ell(t)-w(c), \quad "
    r"q(a,t) = 0",
)
PRESSED = Equation(
    "The pressure is the sum over the strips",
    r"p(x,t) = -\frac{1}{\pi}\int_{|x|}^{a(t)} \frac{\partial q}{\partial c}\,\frac{\mathrm{d}c}{\sqrt{c^2-x^2}}",
)

LINE_VISCOELASTIC = Chapter(
    "bodies that relax",
    kinds={
        "line_force_path": {
            "line_force_path": kind(
                "winkler.problems.line_viscoelastic.path:LineForcePath",
                problem="line_viscoelastic_indentation",
                **ON_AND_OFF,
            ),
        },
    },
    answers={
        "line_viscoelastic_indentation": answer(
            "winkler.problems.line_viscoelastic.indentation:LineViscoelasticIndentation",
            "lee_radok_1960",
            "ting_1966",
            "jaeger_1995",
            question="How wide is the contact of a roller that is pressed on rubber, held and lifted again?",
            page="chapters/line-viscoelastic.md#pressed-held-and-lifted",
            en="rubber roller roll cover o-ring cylinder creeps polymer roller time dependent line contact printing roll sealing cord nip polyurethane wheel tyre press rubber-covered roll printing nip o-ring force over time caster wheel flat spot tyre flat",
            de="gummiwalze o-ring walzenbezug kriecht zylinder zeitabhängig kunststoffrolle walzenspalt rundschnur polyurethanrad gummierte walze druckwalze einfederung gummiwalze",
            fr="rouleau caoutchouc joint torique cylindre fluage viscoélastique linéique galet polymère roulette polyuréthane rouleau gommé",
            headline=("peak_pressure", "half_width", "force_per_length", "time"),
            bed=RELAXING,
            path={"kind": "line_force_path", **ON_AND_OFF},
            count=200,
            picture=Caption(
                "line_relaxing",
                "The contact along its path",
                "Force per length and half-width over time, and pressures at several times.",
            ),
            curves=(("time", "half_width"), ("time", "peak_pressure"), ("force_per_length", "half_width")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(pair_formulas, LOAD_PROFILE, CREPT, GROWING, RELAXED, PRESSED),
        ),
    },
)
