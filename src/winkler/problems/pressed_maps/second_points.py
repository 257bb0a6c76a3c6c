"""A pressed map measured under each load, and again on its second points, four times: what differs is left as error."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

import numpy as np

from winkler.loading.loads import Force
from winkler.numerics.types import Array, Q, Quantity
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

Measured = TypeVar("Measured")
FEWEST_PIXELS = 8
"""Along a side, so that four are left."""


def measured(
    contact: SurfaceContact[Q], measure: Callable[[SurfaceState], Measured]
) -> tuple[SurfaceContactSolution[Q], list[Measured]]:
    """Return the solution of a contact, and what was measured of its maps under each load, of which the last is kept.

    Raises
    ------
    NotConverged
        If a contact is not solved to its tolerance.
    """
    found: list[Measured] = []

    def watched() -> Iterator[SurfaceState]:
        for state in contact.steps():
            found.append(measure(state))
            yield state

    return contact.gathered(watched()), found


def refuse_without_second_points(owner: str, contact: SurfaceContact) -> None:
    """Raise if a map has no second grid.

    Raises
    ------
    InvalidInput
        If the map has fewer than eight pixels along a side, or is periodic and has an odd number of them.
    """
    shape = contact.topography.heights.shape
    if min(shape) < FEWEST_PIXELS:
        raise InvalidInput(
            f"{owner}: the map has {shape[0]} x {shape[1]} pixels; its error is estimated on every second point, give "
            f"{FEWEST_PIXELS} or more along each side."
        )
    if contact.topography.periodic and (shape[0] % 2 or shape[1] % 2):
        raise InvalidInput(
            f"{owner}: every second point of a periodic map of {shape[0]} x {shape[1]} pixels is not periodic; give "
            "even numbers of pixels."
        )


def on_second_points(contact: SurfaceContact, force: Quantity) -> tuple[SurfaceContact, ...]:
    """Return the four contacts of every second point of a map, under the forces found on all of them.

    Raises
    ------
    InvalidInput
        If these points are flat.
    """
    rough = contact.topography
    maps = [rough.heights[row::2, column::2] for row in (0, 1) for column in (0, 1)]
    if rough.periodic and min(float(np.ptp(heights)) for heights in maps) == 0.0:
        raise InvalidInput(
            "Topography: every second height of the periodic map is the same, its roughness is one pixel wide; give a "
            "map whose shortest waves are four pixels and longer."
        )
    return tuple(
        dataclasses.replace(
            contact,
            topography=Topography(heights, 2.0 * np.array(rough.pixel) * heights.shape, rough.periodic),
            load=Force(force),
        )
        for heights in maps
    )


def spread(whole: Quantity, second: Iterable[Quantity]) -> Array:
    """Return the greatest difference among the results of a map and of its second points, in the shape of the load.

    One of these maps may agree with the whole one by chance.
    """
    return np.asarray(np.ptp(np.stack([np.asarray(whole), *map(np.asarray, second)]), axis=0))
