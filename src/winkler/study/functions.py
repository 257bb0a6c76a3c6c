"""The functions that a case of the ledger may name: a closed list, each with what it takes and what it answers.

Coefficients and closed forms that no problem answers with have their numbers judged by ``[function]``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from winkler.problems.adhesion_model import maugis_parameter
from winkler.problems.kalker import creep_coefficients
from winkler.problems.persson import area_fraction
from winkler.reference import impact, rolling, wear

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
    "cap_radius": Function(wear.cap_radius, "wear", "radius", {"volume": "m^3", "curvature_radius": "m"}),
    "carter_creepage": Function(
        rolling.carter_creepage,
        "rolling",
        "longitudinal_creepage",
        {"coefficient": "", "half_width": "m", "curvature_radius": "m", "ratio": ""},
    ),
    "carter_stick_half_width": Function(
        rolling.carter_stick_half_width, "rolling", "stick_half_width", {"half_width": "m", "ratio": ""}
    ),
    "creep_coefficients.lateral": Function(creep_coefficients, "rolling", "creep_coefficient", KALKER, "lateral"),
    "creep_coefficients.longitudinal": Function(
        creep_coefficients, "rolling", "creep_coefficient", KALKER, "longitudinal"
    ),
    "creep_coefficients.spin": Function(creep_coefficients, "rolling", "creep_coefficient", KALKER, "spin"),
    "kuwabara_kono_restitution": Function(
        impact.kuwabara_kono_restitution, "bodies that relax", "restitution", {"time_ratio": ""}
    ),
    "maugis_parameter": Function(
        maugis_parameter,
        "adhesion",
        "maugis_parameter",
        {"curvature_radius": "m", "modulus": "Pa", "work": "J/m^2", "strength": "Pa"},
    ),
    "punch_bulge": Function(wear.punch_bulge, "wear", "height", {"pressure": "Pa", "radius": "m", "modulus": "Pa"}),
}
"""Name of a public function of winkler, or of a closed form of `winkler.reference`, and what there is to know of it."""
