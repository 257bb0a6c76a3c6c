"""Rolling line contacts: their loads, problems, and formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.line import ROLLER
from winkler.study.chapters.normal import MODULUS

__all__ = ["LINE_ROLLING"]

PRESSED = {"kind": "line_force", "force_per_length": "100 N/mm"}
CREEPAGES = {"kind": "creepages", "longitudinal": {"from": 0.0, "to": 0.004, "count": 25}}

HERTZ = Equation(
    "A cylinder is pressed to the half-width and pressure of Hertz",
    r"a = \sqrt{\frac{4PR}{\pi E^*}}, \quad p = p_0\,\sqrt{1-\frac{x^2}{a^2}}, \quad p_0 = \frac{2P}{\pi a}",
)
STICK = Equation(
    "It sticks from the leading edge a back to a − 2c, which the force per length determines, or the creepage",
    r"\frac{Q}{\mu P} = 1-\frac{c^2}{a^2}, \quad \xi = \frac{\mu\,(a-c)}{R}",
)
TRACTION = Equation(
    "The traction is that of sliding, less the second term in the zone of stick",
    r"q(x) = \mu p_0\,\left[\sqrt{1-\frac{x^2}{a^2}}-\frac{c}{a}\sqrt{1-\frac{(x-a+c)^2}{c^2}}\right]",
)
SLIP = Equation(
    "and behind it the surfaces slip, by parts of the speed of rolling",
    r"s(x) = \frac{\mu}{R}\sqrt{(x-a+c)^2-c^2}, \quad x < a-2c",
)

LINE_ROLLING = Chapter(
    "line contact",
    kinds={
        "line_lateral": {
            "line_shear_force": kind(
                "winkler.loading:LineShearForce", problem="line_rolling", shear_force_per_length="15 N/mm"
            ),
        },
    },
    answers={
        "line_rolling": answer(
            "winkler.problems.line_rolling.steady:LineRolling",
            "carter_1926",
            "johnson_1985",
            bed=ROLLER,
            drive=CREEPAGES,
            load=PRESSED,
            picture=Caption(
                "line_creep", "Rolling", "The force over the creepage, and the traction at the greatest of these."
            ),
            curves=(("longitudinal_creepage", "shear_force_per_length"), ("longitudinal_creepage", "stick_share")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, HERTZ, STICK, TRACTION, SLIP),
        ),
    },
)
