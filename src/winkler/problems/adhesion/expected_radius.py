"""Order of magnitude of the radius of an adhesive contact, from the shape of the body alone.

A search that began anywhere would solve layered media for contacts a thousand times too wide, which takes them seconds,
and cohesive zones for rings too narrow for floating point.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.media.body_of import thickness_of
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates
from winkler.problems.normal.solve_contact import end_of

SEARCH_DECADES = np.arange(-12.0, 6.0, 0.25)
LEAST_RADIUS_RATIO = 1e-12
"""Both of the lengths of the body."""
LENGTH_SHARE = 0.05


def expected_radius(states: EdgeStates) -> float:
    """Return a radius [m], not beyond half of the body, where its slope first matters against the attraction."""
    bed = states.bed
    widest = 0.5 * min([end_of(bed), *(b for b, _ in bed.kinks if b > 0.0)])
    length, layers = min(widest, bed.size), thickness_of(bed.medium)
    if not isinstance(bed, Foundation) and min(length, layers) < math.inf:
        return LENGTH_SHARE * min(length, layers)
    narrow = LEAST_RADIUS_RATIO * next((part for part in (length, layers) if part < math.inf), 1.0)
    with np.errstate(all="ignore"):
        return _attracted(states, widest, length, narrow) if length < math.inf else _without_length(states, narrow)


def _attracted(states: EdgeStates, widest: float, length: float, narrow: float) -> float:
    """Return the first of many radii where the slope matters."""
    places = length * 10.0**SEARCH_DECADES
    places = places[places < widest]
    share = np.abs(states.bed.slope(places)) / _pulled(states, places, narrow)
    noticeable = share >= LENGTH_SHARE
    return float(places[np.argmax(noticeable)]) if noticeable.any() else min(float(places[-1]), LENGTH_SHARE * length)


def _pulled(states: EdgeStates, places: Array, narrow: float) -> Array:
    """Return stretch over radius, from that of a narrow contact, which depends on the uppermost layer alone."""
    pulled = float(states.scale(np.array([narrow]))[0])
    # without a range the stretch goes with the root of the radius, with one it stays
    return np.asarray(pulled * (np.ones(places.shape) if states.from_nothing() else np.sqrt(narrow / places)))


def _without_length(states: EdgeStates, narrow: float) -> float:
    """Return the radius of a body that has no length: the attraction brings it."""
    bed = states.bed
    if not states.from_nothing():
        return rough_root(lambda places: np.abs(bed.slope(places)) / _pulled(states, places, narrow), LENGTH_SHARE)
    touch = np.zeros(1)
    risen, pull = -float(states.depth(touch)[0]), float(states.load(touch)[0])
    if risen > 0.0:
        return rough_root(bed.height, risen)
    springs = float(bed.stiffness(np.array([narrow]))[0]) / narrow
    return (
        rough_root(lambda places: springs * places * bed.height(places), pull)
        if pull > 0.0
        else narrow / LEAST_RADIUS_RATIO
    )
