"""The greatest stress below a line contact, and its place, sought on grids that close in on it."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.problems.line.stress import LineContact, LineFields, stresses
from winkler.profiles.power import Paraboloid

__all__ = ["Measure", "Placed", "greatest", "sought", "von_mises"]

Measure = Callable[[LineFields], Array]
PLACES_BESIDE, DEPTHS = 10, 24
CLOSEST = 1e-4
"""Nearest places to a mark, and depth, over the half-width."""
MOST_PEAKS = 3
"""Local maxima of the coarse grid from which the greatest is sought."""
NEIGHBOURS, FINE = 2, 13
"""Points kept on either side of the best one, points of the finer grid between them."""
FIRST_REFINEMENTS, REFINEMENTS = 5, 20
"""How often the grid is refined about each local maximum, and in all about the greatest."""
ROUNDING = 1e-14
POLISHING, POLISHED_SHARE = 9, 0.1
"""Nodes of the polynomial about the greatest stress, and its reach over the distance to the next singular place."""
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


def greatest(contact: LineContact, measure: Measure) -> Placed:
    """Return the greatest of a stress and its place, sought on grids that close in on it.

    Parameters
    ----------
    contact : LineContact
    measure
        Takes the fields, returns what is compared [Pa].
    """
    if isinstance(contact.bed.profile, Paraboloid):
        level = contact.bed.medium.modulus * contact.half_width / contact.bed.profile.curvature_radius
        value, x, z = _of_cylinder(measure, contact.poisson, contact.friction)
        return Placed(level * value, contact.half_width * x, contact.half_width * z)
    return sought(contact, measure)


@functools.lru_cache(maxsize=256)
def _of_cylinder(measure: Measure, poisson: float, friction: float) -> Placed:
    """Return the greatest stress of a cylinder over E* a / R, and its place over a: all cylinders are similar."""
    bed = LineFoundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    return sought(LineContact(bed, 1.0, 0.0, poisson, friction), measure)


def sought(contact: LineContact, measure: Measure) -> Placed:
    """Return what `greatest` does, of any one contact: also of a cylinder that is not similar to all others."""
    from scipy.ndimage import maximum_filter

    x, z = _grid(contact)
    coarse = measure(stresses(contact, x[:, None], z[None, :]))
    peaks = np.argwhere(coarse >= maximum_filter(coarse, size=3, mode="nearest"))
    highest = peaks[np.argsort(-coarse[tuple(peaks.T)], kind="stable")][:MOST_PEAKS]
    grids = [_refined(contact, measure, _around(x, i), _around(z, j), FIRST_REFINEMENTS) for i, j in highest]
    _, x, z = max(grids, key=lambda grid: grid[0].value)
    best, *_ = _refined(contact, measure, x, z, REFINEMENTS - FIRST_REFINEMENTS)
    for place in (best._replace(x=0.0), best._replace(z=0.0)):  # on the axis or the surface, up to rounding
        if float(measure(stresses(contact, np.array(place.x), np.array(place.z)))) >= (1.0 - ROUNDING) * best.value:
            best = place
    return _polished(contact, measure, best)


def _polished(contact: LineContact, measure: Measure, best: Placed) -> Placed:
    """Return the place with the digits that a value near its maximum does not show: where a polynomial is level."""
    marks = np.array([contact.half_width, *(b for b, _ in contact.bed.kinks)])
    near = float(np.min(np.abs(abs(best.x) - marks)))
    reach = POLISHED_SHARE * (best.z if best.z > 0.0 else near)
    free = np.array([best.x != 0.0 or contact.friction != 0.0, best.z > 0.0])
    if reach == 0.0 or not np.any(free):
        return best
    nodes = np.cos(np.pi * (np.arange(POLISHING) + 0.5) / POLISHING)
    fit = np.linalg.inv(chebyshev.chebvander(nodes, POLISHING - 1))
    across, down = best.x + reach * free[0] * nodes, best.z + reach * free[1] * nodes
    values = measure(stresses(contact, across[:, None], down[None, :]))
    surface = fit @ (values / best.value) @ fit.T
    first = [chebyshev.chebder(surface, axis=axis) for axis in (0, 1)]
    second = [[chebyshev.chebder(part, axis=axis) for axis in (0, 1)] for part in first]
    place = np.zeros(2)
    for _ in range(POLISHING):
        level = np.array([_at(part, place) for part in first])
        bend = np.array([[_at(part, place) for part in row] for row in second])[np.ix_(free, free)]
        if not np.all(np.linalg.eigvalsh(bend) < 0.0):
            return best
        place[free] -= np.linalg.solve(bend, level[free])
        if np.max(np.abs(place)) > 1.0:
            return best
    return best._replace(x=best.x + reach * float(place[0]), z=best.z + reach * float(place[1]))


def _at(series: Array, place: Array) -> float:
    return float(chebyshev.chebval2d(float(place[0]), float(place[1]), series))


def _around(places: Array, index: int) -> Array:
    """Return a finer grid about one of ascending places."""
    low, high = max(index - NEIGHBOURS, 0), min(index + NEIGHBOURS, places.size - 1)
    return np.linspace(places[low], places[high], FINE)


def _refined(contact: LineContact, measure: Measure, x: Array, z: Array, times: int) -> tuple[Placed, Array, Array]:
    """Return the greatest on ever finer grids, and the grid about it."""
    for _ in range(times):
        found = measure(stresses(contact, x[:, None], z[None, :]))
        i, j = (int(index) for index in np.unravel_index(np.argmax(found), found.shape))
        best = Placed(float(found[i, j]), float(x[i]), float(z[j]))
        x, z = _around(x, i), _around(z, j)
    return best, x, z


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
