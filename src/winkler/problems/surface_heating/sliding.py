r"""Temperature of two bodies that slide under a map of pressures and tractions.

The flux of heat is :math:`q = \tau_x\,(V_2-V_1)`, the traction with which the second body drags the first times the
velocity at which it slides over it.  Each body passes the contact at its own velocity along x, and both share the heat
so that their surfaces have one temperature wherever they touch (`winkler.numerics.surfaces.shared_heat`).
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array
from winkler.problems.heating.input_checks import RubbingBodies, peclet_numbers
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.problems.surface_heating.notes import surface_heating_notes
from winkler.problems.surface_heating.patch import HeatedPatch, half_length
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.values.checks.number_checks import Finite
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

__all__ = ["SurfaceFrictionHeating", "SurfaceFrictionHeatingSolution"]

FEWEST_PIXELS = 2


@value
class SurfaceFrictionHeating(RubbingBodies):
    """Two bodies that slide along x under a map of pressures and tractions, and warm up.

    Parameters
    ----------
    load : SurfaceLoad
        Pressures and tractions on the first body; mu p along x where the second one slides over it towards +x.
    conductors : HeatConductors
        How the bodies conduct heat: two thick bodies of ThermalConductor, a perfect touch between them.
    first_speed : float
        Velocity along x at which the surface of the first body passes the contact [m/s].
    second_speed : float, optional
        That of the second body; it rests unless given.
    first_bulk_temperature, second_bulk_temperature : float, optional
        Temperatures of the bodies far from the contact [K], counted from a common level; both zero unless given, so
        that temperatures are rises.

    Raises
    ------
    InvalidInput
        If a body does not conduct heat, the map is periodic or one pixel wide, nothing presses, tractions push the
        bodies on, or a number is not finite.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7

    Examples
    --------
    A square of 1 mm under 100 MPa, with a coefficient of friction of 0.2, on a body that moves at 1 m/s below it:

    >>> import numpy as np
    >>> from winkler.materials.conductor import ThermalConductor
    >>> pressure = np.full((32, 32), 100e6)
    >>> load = SurfaceLoad(pressure, [1e-3, 1e-3], x_traction=-0.2 * pressure)
    >>> steel = ThermalConductor(45.0, 12e-6)
    >>> warm = SurfaceFrictionHeating(load, HeatConductors(steel, steel), first_speed=1.0).solve()
    >>> round(warm.heat_rate, 9), round(warm.first_share, 2), round(warm.max_temperature)
    (20.0, 0.85, 44)
    """

    __words__ = words(
        load=("", None, "map of pressures and tractions on the surface of the first body"),
        first_bulk_temperature=("T_{1}", "K", "temperature of the first body far from the contact"),
        second_bulk_temperature=("T_{2}", "K", "temperature of the second body far from the contact"),
    )

    load: SurfaceLoad
    conductors: HeatConductors
    first_speed: Finite
    second_speed: Finite = 0.0
    first_bulk_temperature: Finite = 0.0
    second_bulk_temperature: Finite = 0.0

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset(
        (Assumption.CONDUCTION, Assumption.TEMPERATURE, Assumption.RESOLUTION)
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        load = self.load
        if load.periodic or min(load.pressure.shape) < FEWEST_PIXELS:
            raise InvalidInput(
                f"SurfaceFrictionHeating: the map has {load.pressure.shape[0]} x {load.pressure.shape[1]} pixels and "
                f"is {'repeated for ever' if load.periodic else 'finite'}; give one that stands alone, of at least two "
                "pixels in both directions."
            )
        if not np.any(load.pressure > 0.0):
            raise InvalidInput("SurfaceFrictionHeating: no pressure is positive, so nothing touches; give a load.")
        worst = float(np.min(self._flux))
        if worst < 0.0:
            raise InvalidInput(
                f"SurfaceFrictionHeating: the tractions would push the bodies on, with up to {-worst:.3g} W/m^2; they "
                "act on the first body and point to where the second one slides over it: change the sign of "
                "x_traction, or of the speeds."
            )

    @property
    def _flux(self) -> Array:
        load, sliding = self.load, self.second_speed - self.first_speed
        return np.asarray(np.where(load.pressure > 0.0, load.loads[1] * sliding, 0.0)) + 0.0

    @property
    def _bulk(self) -> tuple[float, float]:
        return self.first_bulk_temperature, self.second_bulk_temperature

    def solve(self) -> SurfaceFrictionHeatingSolution:
        """Return how warm the surfaces get.

        Raises
        ------
        OutsideValidity
            If a Peclet number is above 1e8.
        NotConverged
            If the temperatures of both surfaces are not made to agree.
        """
        load, speeds = self.load, (self.first_speed, self.second_speed)
        half = half_length(load.pressure > 0.0, load.pixel[0])
        owner = type(self).__name__
        peclets = peclet_numbers(owner, [half] * 2, [np.asarray(speed) for speed in speeds], self._bodies)
        patch = HeatedPatch.of(owner, load.pressure, load.places, self._bodies, speeds, self._bulk)
        state = patch.heated(self._flux)
        first, second = (float(peclet) for peclet in peclets)
        return SurfaceFrictionHeatingSolution(
            self, state.heat_rate, state.first_share, state.exchanged_heat_rate, state.max_temperature, state.x,
            state.y, state.mean_temperature, state.mismatch, state.grid_error, first, second, state,
        )  # fmt: skip


WORDED = ("x", "y", "mean_temperature", "mismatch", "grid_error")


@value
class SurfaceFrictionHeatingSolution:
    """The solution of a `SurfaceFrictionHeating`.

    Parameters
    ----------
    problem : SurfaceFrictionHeating
        The problem that was solved.
    heat_rate, first_share, exchanged_heat_rate, max_temperature, x, y, mean_temperature, mismatch, grid_error : float
        As in `SurfaceHeatState`.
    first_peclet, second_peclet : float
        Pe = V l / (2 kappa) of the bodies [-], with half the length l of the contact along x.
    last : SurfaceHeatState
        The maps of flux and temperatures.
    """

    __words__ = words(**{name: SurfaceHeatState.__words__[name] for name in WORDED})

    problem: SurfaceFrictionHeating
    heat_rate: float
    first_share: float
    exchanged_heat_rate: float
    max_temperature: float
    x: float
    y: float
    mean_temperature: float
    mismatch: float
    grid_error: float
    first_peclet: float
    second_peclet: float
    last: SurfaceHeatState

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        peclets = self.first_peclet, self.second_peclet
        return surface_heating_notes(self.last, self.max_temperature, self.grid_error, peclets, self.problem._bulk)
