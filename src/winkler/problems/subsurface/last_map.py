"""Solutions that hold the maps of their last state: the loads on the surface, stresses below, and yielding."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Quantity
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.problems.subsurface.map_yield import last_yield_notes
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.validity import Note

__all__ = ["LastMap"]

ROUNDING = 1e-9
"""Part of a force or pressure that is none."""


class LastMap(BelowSurface):
    """The part of a solution that follows from pressures and tractions of its last state.

    Its ``problem`` has a ``topography`` and a ``medium``, its ``last`` state a ``pressure`` and a ``traction``.
    """

    problem: Any
    last: Any

    @property
    def surface_load(self) -> SurfaceLoad:
        """Pressures and tractions on the first body in the last state."""
        rough = self.problem.topography
        return SurfaceLoad.of_map(rough.lengths, self.last.pressure, self.last.traction, periodic=rough.periodic)

    @property
    def _medium(self) -> object:
        return self.problem.medium

    def _yield_notes(self, *loads: Quantity) -> tuple[Note, ...]:
        """Return whether the last state stays elastic, and whether others bear more of one of these loads."""
        more = any(np.max(every) > (1.0 + ROUNDING) * every[-1] for every in (np.ravel(load) for load in loads))
        return last_yield_notes(self.problem.medium, self.surface_load, bool(more))
