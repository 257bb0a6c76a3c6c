"""Frictional heat: how bodies share it, what is computed, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Answer, Caption, Chapter, Formula, then
from winkler.study.chapters.friction import moved
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import pressed

__all__ = ["HEATING"]

STEEL = {"kind": "thermal_conductor", "conductivity": "45 W/(m K)", "diffusivity": "12 mm^2/s"}
STEELS: dict[str, Any] = {"kind": "heat_conductors", "first": STEEL, "second": STEEL}
COULOMB = {"kind": "coulomb", "coefficient": 0.3}
TWICE = [
    {"kind": "start", "normal": {"kind": "force", "force": "100 N"}},
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "1 um"}, "cycles": 2.0},
]

FLUX = Formula("Friction turns into heat where the bodies press", r"q(r) = \mu\,p(r)\,v, \quad Q = \mu\,F_N\,v")
AT_REST = Formula(
    "On a body that rests against the contact, temperature follows the flux as the surface follows the pressure",
    r"T(r) = \frac{1}{\pi\lambda}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
MOVING = Formula(
    "On a body that moves at the speed V the same sum goes over all directions, each with a line load of its own",
    r"T(x,y) = \frac{1}{2\pi\lambda}\int_{-\pi/2}^{\pi/2} "
    r"\left[q_1(s)-\int_s^a q_1(t)\,\frac{b}{2}\,D\left(\frac{b}{2}(t-s)\right)\,\mathrm{d}t\right]\,\mathrm{d}\theta",
)
LAG = Formula(
    "with the direction θ and the kernel",
    r"b = \frac{V}{\kappa}\,\cos\theta, \quad s = x\,\cos\theta+y\,\sin\theta, \quad D(z) = e^{-z}(I_0(z)-I_1(z))",
)
SHARE = Formula(
    "The bodies share the heat; T₁ and T₂ are what each would have of all of it, their greatest or their mean",
    r"\alpha = \frac{T_2}{T_1+T_2}, \quad \mathrm{Pe} = \frac{V\,a}{2\kappa}",
)
GROWN = Formula(
    "From the beginning on, waves of temperature have grown to a part that depends on their wave number k alone",
    r"T_k(t) = T_k(\infty)\,\mathrm{erf}\left(k\sqrt{\kappa t}\right)",
)
CYCLE = Formula(
    "In every cycle the surfaces turn so much into heat, f times a second",
    r"w(r) = \oint \tau\,\mathrm{d}s, \quad q(r) = f\,w(r), \quad Q = f\,W",
)
TOGETHER = Formula(
    "Both bodies rest against it and take the heat in proportion to their conductivities",
    r"T(r) = \frac{1}{\pi(\lambda_1+\lambda_2)}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)


def fretted(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas of a motion that is repeated, and of the heat that it makes."""
    return (*moved(problem.motion), CYCLE, TOGETHER)


HEATING = Chapter(
    "frictional heat",
    kinds={
        "partition": {
            "equal_maximum": kind("winkler.laws.heat:EqualMaximum", "blok_1963"),
            "equal_mean": kind("winkler.laws.heat:EqualMean", "jaeger_1942"),
            "fixed_share": kind("winkler.laws.heat:FixedShare", first_share=0.5),
        },
    },
    answers={
        "friction_heating": Answer(
            kind(
                "winkler.problems.heating.steady:FrictionHeating",
                law=COULOMB,
                load={"kind": "force", "force": "20 N"},
                conductors=STEELS,
                first_speed="1 m/s",
            ),
            picture=Caption(
                "heating",
                "How warm the bodies get",
                "The surface that moves faster past the contact, both surfaces along the middle, and the flash "
                "temperature over the speed; or, of many loads and speeds at once, over what was varied.",
            ),
            formulas=then(pressed, FLUX, AT_REST, MOVING, LAG, SHARE),
        ),
        "transient_heating": Answer(
            kind(
                "winkler.problems.heating.transient:TransientHeating",
                law=COULOMB,
                load={"kind": "force", "force": "20 N"},
                conductors=STEELS,
                speed="10 mm/s",
                time={"from": "10 us", "to": "1 s", "count": 16, "spacing": "log"},
            ),
            picture=Caption(
                "heating",
                "How the contact warms up",
                "The flash temperature over time, and the surface of the first body at some moments.",
            ),
            curves=(("time", "flash_temperature"), ("time", "first_share")),
            formulas=then(pressed, FLUX, AT_REST, GROWN, SHARE),
        ),
        "fretting_heat": Answer(
            kind(
                "winkler.problems.heating.fretting:FrettingHeat",
                motion={"kind": "tangential", "law": COULOMB, "path": {"kind": "program", "steps": TWICE}},
                frequency="100 Hz",
                conductors=STEELS,
            ),
            picture=Caption(
                "heating",
                "How warm the contact gets",
                "Where the heat of a cycle is released, and the mean temperature of the surfaces.",
            ),
            formulas=fretted,
        ),
    },
)
