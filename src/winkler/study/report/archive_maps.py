"""Maps in the archive: heights, pressure and distance over the pixels of a surface, in NetCDF only."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.study.batch.outcome import Outcome
from winkler.study.report.netcdf import netcdf_attributes
from winkler.values.vocabulary import Word, word

if TYPE_CHECKING:
    from winkler.profiles.rough.topography import Topography


MOST_MAPS = 256
"""Points of a sweep up to which maps are stored; of longer ones only numbers."""
SOLUTIONS_WITH_MAPS = (
    *("SurfaceContactSolution", "SurfaceConductionSolution", "SealSolution", "ThermalJointSolution"),
    *("TrueAreaSolution", "SurfaceConstrictionSolution", "SurfaceWearSolution"),
)
"""By name, as one name means one class: other studies do not load the problems of maps."""
MAP_QUANTITIES = ("pressure", "separation")


def add_maps(outcome: Outcome, dims: tuple[str, ...], variables: dict[str, Any], coords: dict[str, Any]) -> None:
    """Add the maps of the last load of every point that has some; nan where a map is smaller than others.

    Places are added where all points have the same pixels; of sweeps over more than 256 points no maps are stored.
    """
    contacts = [
        (point.index, *_contact(point.solution))
        for point in outcome.solved
        if point.answer_type.__name__ in SOLUTIONS_WITH_MAPS
    ]
    if not contacts or len(contacts) > MOST_MAPS:
        return
    from winkler.problems.rough.surface_states import SurfaceState
    from winkler.problems.surface_wear.states import SurfaceWearState
    from winkler.profiles.rough.topography import Topography

    maps = [item for _, item, _ in contacts]
    size = tuple(int(count) for count in np.max([item.heights.shape for item in maps], axis=0))
    owners = {"heights": Topography, **dict.fromkeys(MAP_QUANTITIES, SurfaceState)}
    if all(isinstance(state, SurfaceWearState) for _, _, state in contacts):
        owners["worn"] = SurfaceWearState
    for name, owner in owners.items():
        content = np.full((*outcome.shape, *size), np.nan)
        for index, item, state in contacts:
            part = item.heights if name == "heights" else getattr(state, name)
            content[index][: part.shape[0], : part.shape[1]] = part
        variables[name] = ((*dims, "x", "y"), content, netcdf_attributes(word(owner, name)))
    if all(item.heights.shape == size and np.array_equal(item.lengths, maps[0].lengths) for item in maps):
        for axis, name in enumerate("xy"):
            places = (np.arange(size[axis]) + 0.5) * maps[0].pixel[axis]
            entry = Word(name, "m", f"place of the pixels along {name}")
            coords[name] = ((name,), places, netcdf_attributes(entry))


def _contact(solution: Any) -> tuple[Topography, Any]:
    """Return the height map of a solution, before wear, and its last state."""
    if type(solution).__name__ == "SurfaceWearSolution":
        return solution.problem.contact.topography, solution.last
    contact = getattr(solution, "contact", solution)
    return contact.problem.topography, contact.last
