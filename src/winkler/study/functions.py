"""The functions that a case of the ledger may name: a closed list, each with what it takes and what it answers.

Coefficients that no problem answers with have their numbers judged by ``[function]``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from winkler.problems.adhesion_model import maugis_parameter
from winkler.problems.kalker import creep_coefficients
from winkler.problems.persson import area_fraction

__all__ = ["FUNCTIONS", "Function"]


class Function(NamedTuple):
    """One line of the list."""

    call: Callable[..., Any]
    physics: str
    """The chapter of the ledger."""
    answer: str
    """The word of the glossary for what is answered."""
    units: Mapping[str, str]
    """Every argument and its unit."""
    part: str = ""
    """Which attribute of the result is meant; empty if it is the number itself."""


KALKER = {"ratio": "", "poisson": ""}

FUNCTIONS: dict[str, Function] = {
    "area_fraction": Function(
        area_fraction,
        "measured and rough surfaces",
        "area_fraction",
        {"pressure": "Pa", "modulus": "Pa", "rms_slope": ""},
    ),
    "creep_coefficients.lateral": Function(creep_coefficients, "rolling", "creep_coefficient", KALKER, "lateral"),
    "creep_coefficients.longitudinal": Function(
        creep_coefficients, "rolling", "creep_coefficient", KALKER, "longitudinal"
    ),
    "creep_coefficients.spin": Function(creep_coefficients, "rolling", "creep_coefficient", KALKER, "spin"),
    "maugis_parameter": Function(
        maugis_parameter,
        "adhesion",
        "maugis_parameter",
        {"curvature_radius": "m", "modulus": "Pa", "work": "J/m^2", "strength": "Pa"},
    ),
}
"""Name of a public function, with the attribute of its answer that is meant, and what there is to know of it."""
