"""The numbers of a contact: those that a solution declares, those of the contact inside it, and what follows from both.

The area follows from the radius of a round contact, mean pressure and share from the area, nominal pressure and leak
per width from the sides of a height map.  A solution that declares one of them itself keeps its own.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.study.batch.outcome import SolvedPoint, answers_of
from winkler.study.batch.points import sides_of_map
from winkler.values.errors import OutsideValidity
from winkler.values.vocabulary import GLOSSARY, Word, word

__all__ = ["CALLED", "WORDS", "numbers_inside", "numbers_of_contact"]

CALLED: Mapping[str, str] = MappingProxyType(
    {
        "peak_pressure": "greatest pressure p0",
        "mean_pressure": "mean pressure",
        "nominal_pressure": "nominal pressure",
        "force": "force",
        "force_per_length": "force per length",
        "radius": "contact radius",
        "half_width": "half-width",
        "longitudinal_semi_axis": "longitudinal semi-axis",
        "lateral_semi_axis": "lateral semi-axis",
        "contact_length": "length in contact",
        "area": "contact area",
        "contact_share": "share in contact",
        "depth": "approach",
        "residual_depth": "depth of the dent",
        "max_shear": "greatest shear stress",
        "orthogonal_shear": "greatest shear along the surface",
        "von_mises": "greatest von Mises stress",
        "yield_force": "load at which it yields",
        "yield_depth": "approach at which it yields",
        "yield_velocity": "velocity at which it yields",
        "yield_factor": "times its load at which it yields",
        "loss_per_cycle": "loss per cycle",
        "loss_per_cycle_per_length": "loss per cycle and length",
        "loss_per_distance": "loss per distance",
        "secant_stiffness": "secant stiffness",
        "loss_factor": "loss factor",
        "leak_per_width": "leak per width",
    }
)
"""Answer of a solution -> what the summary of a contact calls it, in the order of its rows."""
WORDS: Mapping[str, Word] = MappingProxyType(
    {
        **{name: GLOSSARY[name] for name in ("area", "mean_pressure", "nominal_pressure")},
        "contact_share": Word("A/A_0", "", "part of the surface that is in contact"),
        "leak_per_width": Word("Q/w", "m^2/s", "leak rate over the width of the seal"),
    }
)
"""What the numbers mean that follow from others."""
FORCES = ("force", "force_per_length")


def numbers_of_contact(point: SolvedPoint) -> dict[str, Array]:
    """Return the numbers of a point along its loads, and what follows from its radius, area and map.

    Parameters
    ----------
    point
        A solved point.
    """
    found: dict[str, Array] = dict(point.readable)
    found |= {name: content for name, content in _following(found, point.problem).items() if name not in found}
    return found


def numbers_inside(solution: Any, contact: Any) -> dict[str, tuple[Word, float]]:
    """Return the numbers of the contact that a solution holds, or that its pictures show, of its last load.

    Parameters
    ----------
    solution
        Of one load or many.
    contact
        The contact of the pictures, or None.
    """
    inside = getattr(solution, "contact", None) if contact is None else contact
    if inside is None or inside is solution:
        return {}
    answers = {name: np.atleast_1d(content) for name, content in answers_of(inside).items() if name in CALLED}
    following = _following(answers, getattr(inside, "problem", None))
    words = {name: WORDS[name] for name in following} | {name: word(type(inside), name) for name in answers}
    numbers = following | answers
    return {name: (words[name], float(content[-1])) for name, content in numbers.items() if content.size}


def _following(found: Mapping[str, Array], problem: Any) -> dict[str, Array]:
    """Return what follows from numbers of a contact."""
    given, more = dict(found), {}
    if "area" not in given and {"force", "radius"} <= given.keys() and (outline := _outline(problem)) is not None:
        with contextlib.suppress(OutsideValidity):  # a pyramid, whose outline is not known
            more["area"] = given["area"] = np.asarray(outline.area(np.asarray(given["radius"])))
    if {"area", "force"} <= given.keys():
        with np.errstate(invalid="ignore", divide="ignore"):
            more["mean_pressure"] = np.where(given["area"] > 0.0, given["force"] / given["area"], 0.0)
    sides = sides_of_map(problem)
    if sides.size:
        whole = float(np.prod(sides))
        more |= {"nominal_pressure": given["force"] / whole} if "force" in given else {}
        more |= {"contact_share": given["area"] / whole} if "area" in given else {}
        more |= {"leak_per_width": given["leak_rate"] / sides[1]} if "leak_rate" in given else {}
    return more


def _outline(problem: Any) -> Any:
    """Return the outline of a round contact by its bed; None where a problem has none."""
    return getattr(getattr(problem, "bed", None), "footprint", None)
