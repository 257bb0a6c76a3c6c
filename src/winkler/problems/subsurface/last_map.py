"""Solutions that hold the maps of their last state: the loads on the surface, stresses below, and yielding."""

from __future__ import annotations

from typing import Any

from winkler.problems.normal.map_yield import greatest_share, map_yield_notes
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.problems.subsurface.loaded_history import LoadedMap
from winkler.values.validity import Note


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
        medium, rough = self.problem.medium, self.problem.topography
        loads = [
            SurfaceLoad.of_map(rough.lengths, each.pressure, each.traction, periodic=rough.periodic)
            for each in self.heaviest
        ]
        if not loads:
            return ()
        shares = [greatest_share(medium, load) if len(loads) > 1 else 0.0 for load in loads]
        worst = shares.index(max(shares))
        when = ""
        if count > 1:
            when = (
                f", in state {self.heaviest[worst].index + 1} of {count}, the worst of those under the greatest "
                "pressure, traction or shear force"
            )
        return map_yield_notes(medium, loads[worst], when)
