"""The formulas behind the answers for contacts that conduct."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.footprint import Round
from winkler.materials.conducting_body import Plated, Rod
from winkler.media.halfspace import HomogeneousMedium
from winkler.problems.conduction.bounds import ConductanceBounds
from winkler.problems.conduction.constriction import Constriction
from winkler.problems.conduction.joule_heating import JouleHeating
from winkler.problems.conduction.spots import SpotCluster
from winkler.problems.conduction.thermal_constriction import ThermalConstriction
from winkler.study.chapters.formula import Formula

__all__ = ["OF_CONDUCTION", "conducted"]

ANALOGY = Formula(
    "Every spring in contact conducts alike, so conductance and stiffness are in proportion (after Barber)",
    r"\frac{1}{R_c} = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm{d}F_N}{\mathrm{d}d} = \frac{4a}{\rho_1+\rho_2}",
)
DISC = Formula(
    "Current squeezes through the disc of the contact (after Holm), whatever the elastic medium",
    r"R_c = \frac{\rho_1+\rho_2}{4a}",
)
HEAT = Formula(
    "Heat flows like a current, with temperature for voltage and λ for 1/ρ",
    r"Q = \frac{\Delta T}{R}, \quad R_c = \frac{1}{4a}\left(\frac{1}{\lambda_1}+\frac{1}{\lambda_2}\right)",
)
FILM = Formula(
    "A film lies in series, and spreads the current: the factor H goes from 1 to 32/(3π²) as it resists more",
    r"R = R_c\,H(\beta) + \frac{\sigma_f}{\pi a^2}, \quad \beta = \frac{2\sigma_f}{(\rho_1+\rho_2)\,a}",
)
ROD = Formula(
    "In a rod of the radius b current has less far to spread, and a length to go",
    r"R_1 = \frac{\rho_1}{4a}\,\psi\left(\frac{a}{b}\right) + \frac{\rho_1 l}{\pi b^2}, \quad "
    r"\psi = 1 - 1.40925\,\frac{a}{b} + \dots",
)
PLATING = Formula(
    "A plating of the thickness h answers every wave of current like a layer",
    r"1+M(\xi) = \frac{1+\kappa e^{-2\xi h}}{1-\kappa e^{-2\xi h}}, \quad "
    r"\kappa = \frac{\rho_{on}-\rho}{\rho_{on}+\rho}",
)
KOHLRAUSCH = Formula(
    "Temperature and voltage go together along every line of current, if λρ = LT (after Kohlrausch)",
    r"T_{max}^2 = T_0^2 + \frac{V^2}{4L} \quad (V_f = 0, \; V_1 = V_2)",
)
UNLIKE = Formula(
    "With a film, or where the voltages over both bodies differ, the contact itself has",
    r"T_c^2 = T_0^2 + \frac{2V_1V_2}{L}\left(\frac{1}{2}+\frac{V_f}{V_1+V_2}\right)",
)
HOT = Formula(
    "and the resistance grows along the line",
    r"I\,\frac{R_1}{\rho_1(T_0)} = \int_0^{V_1}\frac{\mathrm{d}\phi}{\rho_1(T(\phi))}",
)
CROWDED = Formula(
    "All spots have one voltage, and each adds to those of the others",
    r"V = \frac{\rho_1+\rho_2}{2\pi}\sum_j\int_{A_j}\frac{J(s)}{|r-s|}\,\mathrm{d}A",
)
GREENWOOD = Formula(
    "Greenwood's estimate takes currents in proportion to the radii",
    r"R_G = \frac{\rho_1+\rho_2}{4\sum a_i} + "
    r"\frac{\rho_1+\rho_2}{2\pi}\,\frac{\sum_{i\ne j}a_ia_j/s_{ij}}{(\sum a_i)^2}",
)
TANGENTS = Formula(
    "The force curve lies between that of the smooth body and the same moved by s; it is convex, so that its slope is "
    "bound by tangents (after Barber)",
    r"\max_{D<d_0}\frac{F-F_s(D)}{d_0+s-D} \le k \le \min_{D>d_0+s}\frac{F_s(D)-F}{D-d_0-s}",
)
PROPORTION = Formula("Conductance and stiffness are in proportion", r"\frac{1}{R} = \frac{2k}{E^*(\rho_1+\rho_2)}")


def conducted(problem: Constriction | ThermalConstriction | JouleHeating) -> tuple[Formula, ...]:
    """Return how the pressed contact conducts."""
    bodies = (problem.conductors.first, problem.conductors.second)
    homogeneous = not isinstance(problem.bed.footprint, Round) or isinstance(problem.bed.medium, HomogeneousMedium)
    found = [ANALOGY if homogeneous else DISC]
    if isinstance(problem, ThermalConstriction):
        filmed = problem.conductors.interface.area_resistance > 0.0
        found.append(HEAT)
    else:
        filmed = problem.conductors.film.area_resistance > 0.0
    found += [FILM] if filmed else []
    found += [ROD] if any(isinstance(body, Rod) for body in bodies) else []
    found += [PLATING] if any(isinstance(body, Plated) for body in bodies) else []
    found += [KOHLRAUSCH, UNLIKE, HOT] if isinstance(problem, JouleHeating) else []
    return tuple(found)


OF_CONDUCTION: dict[type, Callable[[Any], tuple[Formula, ...]]] = {
    SpotCluster: lambda problem: (CROWDED, GREENWOOD),
    ConductanceBounds: lambda problem: (TANGENTS, PROPORTION),
}
"""Problem -> its formulas, where no contact is solved for first."""
