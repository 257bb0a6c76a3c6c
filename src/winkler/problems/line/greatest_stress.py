"""The greatest stress below a line contact, and its place."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import tensor
from winkler.media.interior.tensor import Tensor
from winkler.numerics.equations.highest import highest
from winkler.numerics.types import Array
from winkler.problems.line.stress import LineContact, LineFields, stresses
from winkler.profiles.power import Paraboloid

Measure = Callable[[LineFields], Array]
PLACES_BESIDE, DEPTHS = 10, 24
CLOSEST = 1e-4
"""Nearest places to a mark, and depth, over the half-width."""
WIDTHS_SEARCHED = 1.6
DEEPEST_SEARCHED = 2.5
"""How far from the middle and how deep the greatest stress is sought, in half-widths."""


class Placed(NamedTuple):
    """The greatest of a stress, and its place in the axes of the body."""

    value: float
    x: float
    z: float


def von_mises(fields: LineFields) -> Array:
    """Return the equivalent stress after von Mises [Pa]."""
    return fields.von_mises


@functools.cache
def in_strip(measure: tensor.Measure) -> Measure:
    """Return the measure of fields below a strip that compares the same as one of a tensor."""

    def compared(fields: LineFields) -> Array:
        none = np.zeros(fields.xx_stress.shape)
        return measure(Tensor(fields.xx_stress, fields.yy_stress, fields.zz_stress, none, fields.xz_stress, none))

    return compared


def greatest(contact: LineContact, measure: Measure) -> Placed:
    """Return the greatest of a stress and its place.

    Parameters
    ----------
    contact : LineContact
    measure
        Takes the fields, returns what is compared [Pa].
    """
    if contact.bed.hertzian:
        level = contact.bed.medium.modulus * contact.half_width / contact.bed.hertz_radius
        value, x, z = _of_cylinder(measure, contact.poisson, contact.friction)
        return Placed(level * value, contact.half_width * x, contact.half_width * z)
    return sought(contact, measure)


@functools.lru_cache(maxsize=256)
def _of_cylinder(measure: Measure, poisson: float, friction: float) -> Placed:
    """Return the greatest stress of a cylinder over E* a / R, and its place over a: all cylinders are similar."""
    bed = LineFoundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    return sought(LineContact(bed, 1.0, 0.0, poisson, friction), measure)


def sought(contact: LineContact, measure: Measure, *, shallowest: float = 0.0) -> Placed:
    """Return what `greatest` does, of any one contact: also of a cylinder that is not similar to all others.

    It begins at the depth `shallowest` [m], as below a sharp tip or rim.
    """
    x, z = _grid(contact)
    z = np.append(shallowest, z[z > shallowest])
    even = contact.friction == 0.0
    found = highest(
        lambda across, down: measure(stresses(contact, np.abs(across) if even else across, down)),
        [x, z],
        [(-math.inf, math.inf), (shallowest, math.inf)],
    )
    across, down = found.place
    return Placed(found.value, abs(across) if even else across, down)


def _grid(contact: LineContact) -> tuple[Array, Array]:
    """Return places and depths, dense towards the edge, the kinks and the surface."""
    a = contact.half_width
    beside = np.geomspace(CLOSEST, 1.0, PLACES_BESIDE)
    marks = np.array([0.0, a, *(b for b, _ in contact.bed.kinks if b < a)])
    x = np.unique(
        np.abs(np.concatenate([marks, *(mark + sign * a * beside for mark in marks for sign in (-1.0, 1.0))]))
    )
    x = x[x <= WIDTHS_SEARCHED * a]
    if contact.friction != 0.0:
        x = np.concatenate([-x[:0:-1], x])
    return x, np.append(0.0, a * np.geomspace(CLOSEST, DEEPEST_SEARCHED, DEPTHS))
