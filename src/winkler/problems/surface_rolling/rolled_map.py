"""Solutions of maps that roll: stresses below them and yielding, where the medium is homogeneous."""

from __future__ import annotations

from winkler.media.halfspace import HomogeneousMedium
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.mapped_medium import homogeneous
from winkler.problems.subsurface.last_map import LastMap
from winkler.values.validity import Note

__all__ = ["RolledMap"]


class RolledMap(LastMap):
    """The part of a solution of rolling that follows from its maps."""

    @property
    def _medium(self) -> HomogeneousMedium:
        return homogeneous(type(self).__name__, "the stress below the surface", self.problem.medium)

    def _yield_notes(self, count: int) -> tuple[Note, ...]:
        """Return whether the bodies stay elastic; of layers that it is not known."""
        if isinstance(self.problem.medium, HomogeneousMedium):
            return super()._yield_notes(count)
        return unknown_yield(self.problem.medium, "the stresses below a height map are not computed in layers")
