"""What the border of a height map bears, and whether the bodies under it yield."""

from __future__ import annotations

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.surface_notes import border_notes
from winkler.problems.subsurface.map_yield import map_yield_notes
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.values.validity import Note

__all__ = ["last_load_notes"]


def last_load_notes(medium: MappedMedium, load: SurfaceLoad) -> tuple[Note, ...]:
    """Return what the border bears, and whether bodies stay elastic; of layers with a strength, that it is unknown."""
    border = border_notes(load.pressure, load.periodic)
    if isinstance(medium, HomogeneousMedium):
        return (*border, *map_yield_notes(medium, load))
    return (*border, *unknown_yield(medium, "the stresses below a height map are not computed in layers"))
