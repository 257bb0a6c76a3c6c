"""The formulas behind the answers for contacts that roll."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.foundation.plane import PlaneFoundation
from winkler.problems.rolling.calibration import Kalker
from winkler.problems.rolling.oscillating import OscillatingRolling
from winkler.problems.rolling.simplified_theory import SimplifiedRolling
from winkler.problems.rolling.start import RollingStart
from winkler.problems.rolling.steady import Rolling
from winkler.profiles.ellipse import CurvedBodies
from winkler.study.chapters.formula import Formula

__all__ = ["OF_ROLLING"]

PLANE = Formula(
    "The shape f(r) becomes the equivalent plane profile",
    r"g(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
BACK = Formula(
    "The plane profile g(x) was given; the body that belongs to it is",
    r"f(r) = \frac{2}{\pi}\int_0^r \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
SPRINGS = Formula("Springs are compressed by d − g(x)", r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a")
KALKER = Formula(
    "Along the surface they are as stiff as Kalker's creep coefficients of a circle want them",
    r"\kappa_x = \frac{1}{2}c_{11}G, \quad \kappa_y = \frac{1}{2}c_{22}G",
)
RAW = Formula("Along the surface they have the stiffness of a contact at rest", r"\kappa_x = \kappa_y = G^*")
DRIVEN = Formula(
    "A spring that sticks gains load for every distance rolled", r"\kappa = \sqrt{(\kappa_x\xi)^2+(\kappa_y\eta)^2}"
)
ROLLED = Formula(
    "It enters unstrained at the leading edge and bears no more than friction allows",
    r"q_x(x) = \min\left[\mu\,q_z(y) + \kappa\,(y-x)\right], \quad x \le y < a, \quad q_x(a) = 0",
)
CREEP = Formula("Their sum is the creep force", r"F_x = \int_{-a}^a q_x(x)\,\mathrm{d}x")
CARRIED = Formula(
    "From one place to the next every spring keeps what it bears, gains its part, and is cut back to what it can bear",
    r"\left|q_x(x,X)\right| \le \mu\,q_z(x)",
)
LIMIT = Formula(
    "What springs that never leave the contact can bear all the time is the limit of shakedown",
    r"F_{lim} = 2\int_W^a \mu\,q_z(x)\,\mathrm{d}x",
)
HERTZ = Formula(
    "Curvatures and load give the ellipse of Hertz, its larger semi-axis α and the smaller one β",
    r"\frac{1}{R_\alpha} = \frac{F_N}{\pi E^*\alpha^3}\,R_D(0,1-m,1), \quad m = 1-\frac{\beta^2}{\alpha^2}",
)
TABLE = Formula(
    "Every point of the contact is a spring; flexibilities follow from Kalker's coefficients",
    r"L_1 = \frac{8a}{3c_{11}G}, \quad L_2 = \frac{8a}{3c_{22}G}, \quad L_3 = \frac{\pi a\sqrt{a/b}}{4c_{23}G}",
)
STRIPS = Formula(
    "A particle that sticks gains traction on its way from the leading edge",
    r"-\frac{\partial\tau_x}{\partial x} = \frac{\xi}{L_1}-\frac{\varphi y}{L_3}, \quad "
    r"-\frac{\partial\tau_y}{\partial x} = \frac{\eta}{L_2}+\frac{\varphi x}{L_3}",
)
BOUND = Formula(
    "up to a bound, beyond which it slides",
    r"\tau \le \mu\,\frac{2F_N}{\pi ab}\left(1-\frac{x^2}{a^2}-\frac{y^2}{b^2}\right)",
)


def _springs(problem: Any) -> tuple[Formula, ...]:
    plane = BACK if isinstance(problem.bed, PlaneFoundation) else PLANE
    return (plane, SPRINGS, KALKER if isinstance(problem.calibration, Kalker) else RAW)


def _rolled(problem: Any) -> tuple[Formula, ...]:
    return (*_springs(problem), DRIVEN, ROLLED, CREEP)


def _begun(problem: Any) -> tuple[Formula, ...]:
    return (*_springs(problem), DRIVEN, CARRIED, CREEP)


def _rocked(problem: Any) -> tuple[Formula, ...]:
    return (*_springs(problem), CARRIED, LIMIT)


def _simplified(problem: Any) -> tuple[Formula, ...]:
    hertz = (HERTZ,) if isinstance(problem.footprint, CurvedBodies) else ()
    return (*hertz, TABLE, STRIPS, BOUND)


OF_ROLLING: dict[type, Callable[[Any], tuple[Formula, ...]]] = {
    Rolling: _rolled,
    RollingStart: _begun,
    OscillatingRolling: _rocked,
    SimplifiedRolling: _simplified,
}
"""Problem -> what returns its formulas."""
