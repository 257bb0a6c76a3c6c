"""What the contact of plates needs of a grid."""

from __future__ import annotations

from typing import Any, Protocol


class RespondingGrid(Protocol):
    """A surface on a grid, as `winkler.numerics.surfaces.surface_grid.SurfaceGrid` is one."""

    @property
    def shape(self) -> tuple[int, int]:
        """(nx, ny), pixels."""

    @property
    def padded(self) -> tuple[int, int]:
        """Size of the transform: that of the grid if it is periodic."""

    def displaced(self, pressure: Any) -> Any:
        """Return displacements under pressures, (nx, ny)."""
