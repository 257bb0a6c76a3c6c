r"""Stresses in an elastic half-space under a given map of pressures and tractions.

The stresses of every pixel are in closed form (`winkler.media.interior.rectangle`); their sum is that of the map, as
far as its pixels resolve it.
"""

from __future__ import annotations

import math
from typing import ClassVar

from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.normal.map_yield import greatest_stress, map_yield_notes
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words

LOVE = "A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009"
FINE, COARSE = 0.01, 0.2
"""Change of the greatest stress from pixels of twice the size up to which they count as fine, and as coarse."""


@value
class MapStress:
    """Stresses in a body under a given map of pressures and tractions, and their maximum.

    Parameters
    ----------
    load : SurfaceLoad
        The pressures and tractions on the body.
    solid : Elastic
        The body, a half-space.

    References
    ----------
    A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009

    Examples
    --------
    Below the middle of a square of 2 mm under 100 MPa, as deep as a quarter of its side:

    >>> import numpy as np
    >>> square = SurfaceLoad(np.full((8, 8), 100e6), [2e-3, 2e-3])
    >>> solution = MapStress(square, Elastic(210e9, 0.3)).solve()
    >>> round(float(solution.stresses(1e-3, 1e-3, 0.5e-3).zz_stress) / 1e6, 2)
    -92.99
    """

    load: SurfaceLoad
    solid: Elastic

    __words__ = words(
        load=("", None, "map of pressures and tractions on the surface"),
        solid=("", None, "what the body is made of"),
    )

    references: ClassVar[tuple[str, ...]] = ("love_1929", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED

    def solve(self) -> MapStressSolution:
        """Return the maximum stress and its position; the solution also computes stresses elsewhere."""
        spot = greatest_stress(self.load, self.solid)
        coarse = greatest_stress(self.load.halved(), self.solid)
        return MapStressSolution(
            self, self.load.force, self.load.x_force, self.load.y_force, *spot, abs(coarse.value / spot.value - 1.0)
        )


@value
class MapStressSolution(BelowSurface):
    """The solution of `MapStress`.

    Parameters
    ----------
    problem : MapStress
        The problem that was solved.
    force, x_force, y_force : float
        Sums of the pressures and of the tractions [N].
    von_mises : float
        The maximum equivalent stress [Pa].
    x, y, z : float
        Its place [m].
    grid_error : float
        Relative change of the maximum stress from pixels of twice the size.
    """

    __words__ = words(
        x_force=("F_x", "N", "sum of the tractions along x"),
        y_force=("F_y", "N", "sum of the tractions along y"),
        x=("x", "m", "place along the surface"),
        z=("z", "m", "depth below the surface"),
        grid_error=("", "", "change of the greatest stress from pixels of twice the size"),
        yield_factor=("", "", "factor on all loads under which yielding begins"),
    )

    problem: MapStress
    force: float
    x_force: float
    y_force: float
    von_mises: float
    x: float
    y: float
    z: float
    grid_error: float

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures and tractions on the body."""
        return self.problem.load

    @property
    def _medium(self) -> HalfSpace:
        return HalfSpace(self.problem.solid)

    @property
    def yield_factor(self) -> float:
        """Factor of all loads at which yielding begins [-]; infinite if the body has no strength."""
        return self.problem.solid.strength / self.von_mises if self.von_mises > 0.0 else math.inf

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: pixels, yield."""
        percent = 100.0 * self.grid_error
        place = "on the surface" if self.z == 0.0 else f"{self.z:.3g} m below the surface"
        return (
            Note(
                Assumption.RESPONSE,
                Standing.EXACT,
                "Closed form for a homogeneous, linear elastic half-space under loads that are constant in each pixel.",
                LOVE,
            ),
            Note(
                Assumption.RESOLUTION,
                standing_of(self.grid_error, FINE, COARSE),
                f"The maximum stress is {place}. With pixels of twice the size it changes by {percent:.2g} per "
                "cent. Above a depth of half a pixel the steps between pixels are visible.",
                "comparison of two grids",
                self.grid_error,
            ),
            *map_yield_notes(self._medium, self.problem.load),
        )
