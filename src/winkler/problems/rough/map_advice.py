"""Whether bodies under a height map yield, and which stiff layers its boundary elements solve."""

from __future__ import annotations

from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.mapped_medium import MappedMedium
from winkler.problems.rough.surface_notes import border_notes
from winkler.problems.subsurface.map_yield import map_yield_notes
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.validity import Note

__all__ = ["last_load_notes", "plate_advice"]

CONVERGING_CONTRAST = 300.0
"""Of Young's moduli, up to which all of 96 contacts of rough maps of 96 x 96 pixels were solved."""


def plate_advice(medium: MappedMedium) -> str:
    """Return what to do where pressures under a stiff layer are not found; nothing without one."""
    if not isinstance(medium, CoatedHalfSpace):
        return ""
    solids = [layer.solid.young for layer in medium.layers]
    solids += [medium.on.young] if isinstance(medium.on, Elastic) else []
    ratio = max((solids[i] / min(solids[i + 1 :]) for i in range(len(solids) - 1)), default=1.0)
    if ratio <= CONVERGING_CONTRAST:
        return ""
    return (
        f" A layer {ratio:.3g} times as stiff as what lies below bends like a plate between single pixels: of rough "
        f"maps contrasts up to {CONVERGING_CONTRAST:g} are solved, higher ones where the layer is thicker than the "
        "waves of the map are long, or the map is smooth."
    )


def last_load_notes(medium: MappedMedium, load: SurfaceLoad) -> tuple[Note, ...]:
    """Return what the border bears, and whether bodies stay elastic; of layers with a strength, that it is unknown."""
    border = border_notes(load.pressure, load.periodic)
    if isinstance(medium, HomogeneousMedium):
        return (*border, *map_yield_notes(medium, load))
    return (*border, *unknown_yield(medium, "the stresses below a height map are not computed in layers"))
