"""Solutions that hold the maps of their last state: the loads on the surface, stresses below, and yielding."""

from __future__ import annotations

from typing import Any

from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.problems.subsurface.loaded_history import LoadedMap
from winkler.problems.subsurface.map_yield import history_yield_notes
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.values.validity import Note

__all__ = ["LastMap"]


class LastMap(BelowSurface):
    """The part of a solution that follows from pressures and tractions of its last state.

    Its ``problem`` has a ``topography`` and a ``medium``, its ``last`` state a ``pressure`` and a ``traction``, and
    ``heaviest`` are states among which the greatest stress of the whole history is sought.
    """

    problem: Any
    last: Any
    heaviest: tuple[LoadedMap, ...]

    @property
    def surface_load(self) -> SurfaceLoad:
        """Pressures and tractions on the first body in the last state."""
        rough = self.problem.topography
        return SurfaceLoad.of_map(rough.lengths, self.last.pressure, self.last.traction, periodic=rough.periodic)

    @property
    def _medium(self) -> object:
        return self.problem.medium

    def _yield_notes(self, count: int) -> tuple[Note, ...]:
        """Return whether the bodies stay elastic in all of the states, and which of them strains them most."""
        rough = self.problem.topography
        return history_yield_notes(self.problem.medium, rough.lengths, self.heaviest, count, periodic=rough.periodic)
