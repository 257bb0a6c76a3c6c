"""Maps to keep: heights, pressure and distance over the pixels of a surface, in NetCDF alone."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.topography import Topography
from winkler.study.batch.outcome import Outcome
from winkler.study.report.netcdf import netcdf_attributes
from winkler.vocabulary import Word, word

__all__ = ["add_maps"]

MOST_MAPS = 256
"""Of so many points maps are kept; longer sweeps keep their numbers alone."""
HELD = (SurfaceContactSolution, SurfaceConductionSolution)
KEPT = ("pressure", "separation")


def add_maps(outcome: Outcome, dims: tuple[str, ...], variables: dict[str, Any], coords: dict[str, Any]) -> None:
    """Add the maps of the last load of every point that has some; nan where a map is smaller than others.

    Places are added where all points have the same pixels; sweeps over more than 256 points keep no maps.
    """
    there = [(point.index, _contact(point.solution)) for point in outcome.solved if point.answer_type in HELD]
    if not there or len(there) > MOST_MAPS:
        return
    maps = [contact.problem.topography for _, contact in there]
    size = tuple(int(most) for most in np.max([item.heights.shape for item in maps], axis=0))
    owners = {"heights": Topography, **dict.fromkeys(KEPT, SurfaceState)}
    for name, owner in owners.items():
        content = np.full((*outcome.shape, *size), np.nan)
        for (index, contact), item in zip(there, maps, strict=True):
            part = item.heights if name == "heights" else getattr(contact.last, name)
            content[index][: part.shape[0], : part.shape[1]] = part
        variables[name] = ((*dims, "x", "y"), content, netcdf_attributes(word(owner, name)))
    if all(item.heights.shape == size and np.array_equal(item.lengths, maps[0].lengths) for item in maps):
        for axis, name in enumerate("xy"):
            places = (np.arange(size[axis]) + 0.5) * maps[0].pixel[axis]
            told = Word(name, "m", f"place of the pixels along {name}")
            coords[name] = ((name,), places, netcdf_attributes(told))


def _contact(solution: SurfaceContactSolution | SurfaceConductionSolution) -> SurfaceContactSolution:
    """Return the contact of a height map that an answer holds."""
    return solution.contact if isinstance(solution, SurfaceConductionSolution) else solution
