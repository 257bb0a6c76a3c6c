"""The elastic contact beside an answer: greatest pressure, greatest von Mises stress and its depth, load of yield.

Stresses are those of the contact that is pressed without friction.  Three forms are known: springs of round contacts,
the ellipse of Hertz by its semi-axes, and strips by load per length and half-width.  A strip whose half-width is not
that of the elastic one under its load (worn, viscoelastic, adhesive) has none here.
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.line import LineFoundation
from winkler.loading.loads import HalfWidth, LineForce
from winkler.media.halfspace import HalfSpace
from winkler.problems.line.indentation import LineIndentation
from winkler.problems.normal.elliptic_stress import greatest_under_ellipse
from winkler.problems.normal.greatest_stress import greatest_stress
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.strong_parts import StrongPart, solid_parts
from winkler.problems.normal.yielding import YieldOnset, onset_of_part
from winkler.profiles.power import Paraboloid
from winkler.study.batch.outcome import SolvedPoint
from winkler.study.report.headline.shown_contact import stressed_contact
from winkler.values.errors import WinklerError

__all__ = ["ElasticState", "elastic_state"]

SAME_WIDTH = 1e-6
"""Relative difference of half-widths up to which a strip is the elastic one."""


class ElasticState(NamedTuple):
    """The elastic contact of an answer.

    Parameters
    ----------
    peak_pressure
        [Pa]; infinite at a sharp edge or apex.
    von_mises
        Greatest von Mises stress [Pa], outside a tenth of the contact radius around a sharp place.
    depth
        How far below the surface [m].
    body
        In which body or layer.
    sharp
        Why the stress is infinite somewhere; empty where it is not.
    strength
        Of that body [Pa]; infinite where none was given.
    yield_load
        Load at which that body yields; not a number where it is not known.
    unit
        Of the load: N, or N/m of a strip.
    """

    peak_pressure: float
    von_mises: float
    depth: float
    body: str
    sharp: str
    strength: float
    yield_load: float
    unit: str


def elastic_state(point: SolvedPoint) -> ElasticState | None:
    """Return the elastic contact that the pictures of a point show; None where there is none, or it is not known.

    Parameters
    ----------
    point
        A solved point.
    """
    try:
        contact = stressed_contact(point)
        if isinstance(contact, IndentationSolution):
            return _round(contact)
        problem = getattr(contact, "problem", point.problem)
        return _ellipse(contact, problem) or _strip(contact, problem)
    except WinklerError:  # the contact is sound, its stresses are not known
        return None


def _nearest(found: list[tuple[StrongPart, Any]]) -> tuple[StrongPart, Any]:
    """Return the part that is nearest to its strength; of parts without one, the most stressed."""
    return max(found, key=lambda one: (one[1].value / one[0].solid.strength, one[1].value))


def _round(contact: IndentationSolution) -> ElasticState | None:
    pressed = contact.pressed
    parts = solid_parts(pressed.bed.medium)
    if type(pressed) is not PressedSprings or not parts or pressed.radius <= 0.0:
        return None
    part, place = _nearest([(part, greatest_stress(pressed, _alike(parts, part, pressed))) for part in parts])
    peak = float(np.max(contact.peak_pressure))
    onset = _onset(pressed.bed, part, place.sharp) if part.solid.strength < math.inf else math.nan
    return ElasticState(peak, place.value, place.z, part.name, place.sharp, part.solid.strength, onset, "N")


def _alike(parts: tuple[StrongPart, ...], part: StrongPart, pressed: PressedSprings) -> StrongPart:
    """Return the first part with the same stresses: in half-spaces they depend on Poisson's ratio alone."""
    if not isinstance(pressed.bed.medium, HalfSpace):
        return part
    return next(one for one in parts if one.solid.poisson == part.solid.poisson)


@functools.lru_cache(maxsize=64)
def _onset(bed: Any, part: StrongPart, sharp: str) -> float:
    """Return the force at which the part nearest to its strength yields [N]; not a number where that is not known."""
    try:
        return 0.0 if sharp else onset_of_part(YieldOnset(bed), 1, part).force
    except WinklerError:
        return math.nan


def _strip(solution: Any, problem: Any) -> ElasticState | None:
    bed = getattr(problem, "bed", None)
    half_width, force = (getattr(solution, name, None) for name in ("half_width", "force_per_length"))
    if type(bed) is not LineFoundation or not isinstance(bed.medium, HalfSpace) or half_width is None:
        return None
    widths = np.ravel(half_width)
    forces = widths if force is None else np.resize(force, widths.shape)
    widest = int(np.argmax(forces))
    width = float(widths[widest])
    given = HalfWidth(width) if force is None else LineForce(float(forces[widest]))
    elastic = LineIndentation(bed, given).solve()
    if not width > 0.0 or not math.isclose(float(elastic.half_width), width, rel_tol=SAME_WIDTH):
        return None
    found = [(part, elastic.greatest_stress(below=part.first)) for part in solid_parts(bed.medium)]
    part, place = _nearest(found)
    onset = math.nan
    if part.solid.strength < math.inf and isinstance(bed.profile, Paraboloid):
        onset = float(elastic.force_per_length) * (part.solid.strength / place.value) ** 2  # all cylinders are similar
    peak = float(elastic.peak_pressure)
    return ElasticState(peak, place.value, abs(place.z), part.name, "", part.solid.strength, onset, "N/m")


def _ellipse(solution: Any, problem: Any) -> ElasticState | None:
    axes = [getattr(solution, name, None) for name in ("longitudinal_semi_axis", "lateral_semi_axis", "peak_pressure")]
    medium = getattr(problem, "medium", None)
    if any(axis is None for axis in axes) or not isinstance(medium, HalfSpace):
        return None
    first, second, peak = (float(axis) for axis in axes)  # type: ignore[arg-type]
    slenderness = min(first, second) / max(first, second)
    found = [(part, greatest_under_ellipse(slenderness, part.solid.poisson)) for part in solid_parts(medium)]
    part, place = _nearest(found)
    stress = place.value * peak
    force = 2.0 / 3.0 * math.pi * first * second * peak
    onset = force * (part.solid.strength / stress) ** 3 if part.solid.strength < math.inf else math.nan
    below = place.depth * min(first, second)
    return ElasticState(peak, stress, below, part.name, "", part.solid.strength, onset, "N")
