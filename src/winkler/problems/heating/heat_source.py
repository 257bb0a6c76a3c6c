r"""The heat of friction as a source: its flux is the pressure times friction coefficient and sliding speed.

Where the bodies are homogeneous, the line load of the flux is the springs' displacement, up to a factor; in layers and
graded bodies, which conduct heat as if they were homogeneous, it is the projection T5 of the pressure.  Of bodies of
two curvatures it is that of Hertz' ellipse, or on layers and gradings the map of the pressure that pixels found.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.loading.path import load_number
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.round_source import line_source, projected
from winkler.numerics.types import Array
from winkler.problems.heating.pressed_source import PressedSource
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.indentation import IndentationSolution

HeatedContact = IndentationSolution | EllipticSolution
"""A contact that heats up: round, or of two curvatures."""
PointSource = LineSource | EllipticSource | PressedSource
"""Where 1 W enters it."""


@functools.lru_cache(maxsize=256)
def heat_source(pressed: PressedSprings) -> LineSource:
    """Return the source of 1 W that belongs to a pressed bed.

    Raises
    ------
    OutsideValidity
        If the pressure is not known in this medium.
    NotConverged
        If the shape is too rough.
    """
    joints = [b for b, _ in pressed.kinks]
    if isinstance(pressed.bed.medium, HomogeneousMedium):
        raw = line_source(lambda x: np.maximum(pressed.value(x), 0.0), joints, pressed.radius)
    else:

        def pressure(r: Array) -> Array:
            return pressed.bed.medium.pressure(pressed, r)

        raw = projected(pressure, joints, pressed.radius)
    return LineSource(raw.radius, raw.scale / raw.heat, raw.joints, raw.curve, sharp=pressed.edge > 0.0)


def half_lengths(contact: HeatedContact, angle: float) -> Array:
    """Return half the length of the contact at an angle [rad] to x, through its middle [m], under every load."""
    if isinstance(contact, IndentationSolution):
        return np.asarray(contact.radius)
    a, b = (np.asarray(axis) for axis in (contact.longitudinal_semi_axis, contact.lateral_semi_axis))
    reach = np.hypot(b * math.cos(angle), a * math.sin(angle))
    return np.where(reach > 0.0, a * b / np.where(reach > 0.0, reach, 1.0), 0.0)


def heat_sources(contact: HeatedContact) -> list[PointSource | None]:
    """Return the source of every load; None where there is no contact."""
    if isinstance(contact, IndentationSolution):
        loads = np.shape(contact.radius)
        ones = (contact.at(index) if loads else contact for index in np.ndindex(loads))
        return [heat_source(one.pressed) if float(one.radius) > 0.0 else None for one in ones]
    problem = contact.problem
    axes = zip(np.ravel(contact.longitudinal_semi_axis), np.ravel(contact.lateral_semi_axis), strict=True)
    if isinstance(problem.medium, HomogeneousMedium):
        return [EllipticSource(float(a), float(b)) if a > 0.0 else None for a, b in axes]
    bodies, medium, given = problem.bodies.together, problem.medium, type(problem.load)
    return [
        PressedSource(bodies, medium, given(float(load))) if a > 0.0 else None
        for (a, _), load in zip(axes, np.ravel(load_number(problem.load)), strict=True)
    ]
