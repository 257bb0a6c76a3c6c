"""The functions that a case of the ledger may name: a closed list, each with its arguments and its quantity.

Coefficients that are no solution of a problem are compared by ``[function]``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from winkler.fitting.unloading.contact_reading import CalibratedArea, contact_reading, sample_young
from winkler.materials.elastic import Elastic
from winkler.problems.adhesion.tabor import maugis_parameter
from winkler.problems.rolling.kalker import creep_coefficients
from winkler.problems.rolling.linear_theory import linear_creep_coefficients
from winkler.problems.rough.persson import area_fraction

__all__ = ["FUNCTIONS", "Function"]


class Function(NamedTuple):
    """One line of the list."""

    call: Callable[..., Any]
    physics: str
    """The chapter of the ledger."""
    answer: str
    """The glossary entry of its value."""
    units: Mapping[str, str]
    """Every argument and its unit."""
    part: str = ""
    """Attribute of the result that is compared; empty if it is the number itself."""


READING_ARGUMENTS = {
    "stiffness": "N/m",
    "force": "N",
    "depth": "m",
    "c0": "",
    "c1": "m",
    "c2": "m^1.5",
    "c3": "m^1.75",
}
"""Stiffness, load and depth, and the area function of the tip."""


def _hardness(stiffness: float, force: float, depth: float, c0: float, c1: float, c2: float, c3: float) -> float:
    """Return the hardness [Pa] that `contact_reading` reads."""
    return contact_reading(stiffness, force, depth, CalibratedArea((c0, c1, c2, c3))).hardness


def _young(
    stiffness: float, force: float, depth: float, c0: float, c1: float, c2: float, c3: float, *, poisson: float,
    indenter_young: float, indenter_poisson: float,
) -> float:  # fmt: skip
    """Return Young's modulus [Pa] of the sample that `contact_reading` and `sample_young` read."""
    pair = contact_reading(stiffness, force, depth, CalibratedArea((c0, c1, c2, c3))).modulus
    return sample_young(pair, poisson, Elastic(indenter_young, indenter_poisson))


CREEP_ARGUMENTS = {"ratio": "", "poisson": ""}


def _linear(part: str) -> Function:
    """Return a coefficient of the linear theory of rolling."""
    return Function(linear_creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, part)


FUNCTIONS: dict[str, Function] = {
    "area_fraction": Function(
        area_fraction,
        "measured and rough surfaces",
        "area_fraction",
        {"pressure": "Pa", "modulus": "Pa", "rms_slope": ""},
    ),
    "contact_reading.hardness": Function(_hardness, "fits", "hardness", READING_ARGUMENTS),
    "contact_reading.young": Function(
        _young, "fits", "young", READING_ARGUMENTS | {"poisson": "", "indenter_young": "Pa", "indenter_poisson": ""}
    ),
    "creep_coefficients.lateral": Function(
        creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "lateral"
    ),
    "creep_coefficients.longitudinal": Function(
        creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "longitudinal"
    ),
    "creep_coefficients.spin": Function(creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "spin"),
    "linear_creep_coefficients.lateral": _linear("lateral"),
    "linear_creep_coefficients.longitudinal": _linear("longitudinal"),
    "linear_creep_coefficients.spin": _linear("spin"),
    "linear_creep_coefficients.turning": _linear("turning"),
    "maugis_parameter": Function(
        maugis_parameter,
        "adhesion",
        "maugis_parameter",
        {"curvature_radius": "m", "modulus": "Pa", "work": "J/m^2", "strength": "Pa"},
    ),
}
"""Name of a public function, with the attribute of its result -> its entry."""
