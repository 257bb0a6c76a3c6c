r"""Temperature of a contact of any outline that rolls with creepage.

The flux of heat is the traction times the velocity of slip, :math:`q = \boldsymbol\tau\cdot\mathbf s'\,V`, in every
pixel that slips (`winkler.problems.surface_rolling.steady`).  Both bodies pass the contact at the speed V towards -x,
as the theory of small creepages has it, and share the heat so that their surfaces have one temperature wherever they
touch (`winkler.numerics.surfaces.shared_heat`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import HEATED, MAPPED
from winkler.problems.heating.input_checks import RubbingBodies, peclet_numbers
from winkler.problems.surface_heating.notes import JAEGER, surface_heating_notes
from winkler.problems.surface_heating.patch import HeatedPatch, half_length
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.problems.surface_rolling.steady import SurfaceRolling, SurfaceRollingSolution
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Finite
from winkler.values.validity import Assumption, Note, standing_of
from winkler.values.value import value, words

__all__ = ["SurfaceRollingHeating", "SurfaceRollingHeatingSolution"]

NAMED = ("x", "y", "mean_temperature", "mismatch", "grid_error")
SMALL_CREEPAGE, LARGE_CREEPAGE = 0.01, 0.25
"""Change of a share up to which the speeds of both bodies count as one, and beyond which they do not."""
APART = ("problem", "contact", "first_peclet", "second_peclet", "last")
"""Fields of a solution that are no numbers of its creepages."""


def _rolls_on(rolling: SurfaceRolling) -> bool:
    return rolling.speed > 0.0


@value
class SurfaceRollingHeating(RubbingBodies, PerLoad[Q]):
    """A height map that rolls with creepage and warms up.

    Parameters
    ----------
    rolling : SurfaceRolling
        The problem of rolling, with one creepage or many.
    conductors : HeatConductors
        How the bodies conduct heat: two thick bodies of ThermalConductor, a perfect touch between them.
    first_bulk_temperature, second_bulk_temperature : float, optional
        Temperatures of the bodies far from the contact [K], counted from a common level; both zero unless given, so
        that temperatures are rises.

    Raises
    ------
    InvalidInput
        If a body does not conduct heat, a temperature is not finite or the speed of rolling is zero.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7; M. Ertz, K. Knothe, Wear 253 (2002) 498-508

    Examples
    --------
    A wheel that slips by 0.5 % at 30 m/s:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.rolling.creepage import Creepage
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> steel = HalfSpace.between(Elastic(210e9, 0.28), Elastic(210e9, 0.28))
    >>> wheel = SampledProfile([16e-3, 14e-3], CurvedBodies(0.46, 0.3), (48, 42))
    >>> rolling = SurfaceRolling(wheel, steel, Force(80e3), Coulomb(0.3), Creepage(longitudinal=5e-3), speed=30.0)
    >>> conductor = ThermalConductor.of(conductivity=50.0, density=7850.0, heat_capacity=450.0)
    >>> warm = SurfaceRollingHeating(rolling, HeatConductors(conductor, conductor)).solve()
    >>> round(warm.heat_rate / 1e3, 1), round(warm.first_share, 6), warm.x < 0.0
    (3.6, 0.5, True)
    """

    __words__ = words(
        rolling=("", None, "problem of the map that rolls"),
        first_bulk_temperature=("T_{1}", "K", "temperature of the first body far from the contact"),
        second_bulk_temperature=("T_{2}", "K", "temperature of the second body far from the contact"),
    )

    rolling: Annotated[
        SurfaceRolling[Q], Condition(_rolls_on, "give SurfaceRolling a speed in m/s: heat depends on it")
    ]
    conductors: HeatConductors
    first_bulk_temperature: Finite = 0.0
    second_bulk_temperature: Finite = 0.0

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "kalker_1990")
    assumptions: ClassVar[frozenset[Assumption]] = (
        HEATED | MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}
    )

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every creepage."""
        return self.rolling.total

    @property
    def _bulk(self) -> tuple[float, float]:
        return self.first_bulk_temperature, self.second_bulk_temperature

    def steps(self) -> Iterator[SurfaceHeatState]:
        """Yield the temperatures under every creepage.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of the map, or a Peclet number is above 1e8.
        NotConverged
            If stick and slip are not found, or temperatures that agree.
        """
        patch: HeatedPatch | None = None
        touching = np.zeros(0, dtype=bool)
        for rolled in self.rolling.steps():
            if patch is None or not np.array_equal(rolled.pressure > 0.0, touching):
                touching = rolled.pressure > 0.0
                self._peclets(rolled.pressure)
                velocity, places = -self.rolling.speed, _middles(self.rolling)
                patch = HeatedPatch.of(
                    "SurfaceRollingHeating", rolled.pressure, places, self._bodies, (velocity, velocity), self._bulk
                )
            yield dataclasses.replace(patch.heated(self.rolling.speed * _lost(rolled)), rolled=rolled)

    def gathered(self, states: Iterable[SurfaceHeatState]) -> SurfaceRollingHeatingSolution[Q]:
        """Return the solution made of these states, of all creepages or of the first ones."""
        reached = list(states)
        contact = self.rolling.gathered([state.rolled for state in reached if state.rolled is not None])
        shape = np.shape(contact.force)
        names = [field.name for field in dataclasses.fields(SurfaceRollingHeatingSolution) if field.name not in APART]
        rows = {name: np.array([getattr(state, name) for state in reached]) for name in names}
        columns: dict[str, Q] = {name: shaped(row, shape) for name, row in rows.items()}
        problem = dataclasses.replace(self, rolling=contact.problem)
        last = reached[-1]
        first, second = self._peclets(last.pressure)
        return SurfaceRollingHeatingSolution(
            problem, contact, **columns, first_peclet=first, second_peclet=second, last=last
        )

    def solve(self) -> SurfaceRollingHeatingSolution[Q]:
        """Return how warm the surfaces get.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())

    def _peclets(self, pressure: Array) -> tuple[float, float]:
        half = half_length(pressure > 0.0, self.rolling.topography.pixel[0])
        speeds = [np.asarray(self.rolling.speed)] * 2
        first, second = peclet_numbers("SurfaceRollingHeating", [half] * 2, speeds, self._bodies)
        return float(first), float(second)


def _lost(rolled: SurfaceRollingState) -> Array:
    """Return what slip turns into heat, per area and distance rolled [J/m^3].

    Material slips from the middle of one pixel to that of the next behind it, under the mean of both tractions: so
    summed up, elasticity loses nothing.  Either pixel takes a half of the heat.  What comes in brings no traction; what
    goes out slips as in the last pixel.
    """
    touching, q = rolled.pressure > 0.0, rolled.traction
    ahead, comes, goes = np.zeros_like(q), touching.copy(), touching.copy()
    ahead[:, :-1] = q[:, 1:]
    comes[:-1] &= ~touching[1:]
    goes[1:] &= ~touching[:-1]
    lost = np.maximum(np.sum(0.5 * (q + ahead) * rolled.creep, axis=0), 0.0)
    passed = np.zeros_like(lost)
    passed[1:] = lost[:-1]
    leaving = np.maximum(np.sum(0.5 * q * rolled.creep, axis=0), 0.0)
    return np.asarray(0.5 * (lost + np.where(touching, passed, 0.0)) + 0.5 * lost * comes + leaving * goes)


def _middles(rolling: SurfaceRolling) -> tuple[Array, Array]:
    """Return the middles of the pixels of a map [m], counted from its middle."""
    rough = rolling.topography
    x, y = ((np.arange(n) - 0.5 * (n - 1)) * step for n, step in zip(rough.heights.shape, rough.pixel, strict=True))
    return x, y


@value
class SurfaceRollingHeatingSolution(PerLoad[Q]):
    """The solution of a `SurfaceRollingHeating`; quantities have the shape of the creepage.

    Parameters
    ----------
    problem : SurfaceRollingHeating
        The problem that was solved.
    contact : SurfaceRollingSolution
        The contact that rolls, with its forces.
    heat_rate, first_share, exchanged_heat_rate, max_temperature, mean_temperature, mismatch, grid_error
        As in `SurfaceHeatState`, float or ndarray.
    x, y : float or ndarray
        Place of the greatest temperature [m], from the middle of the map.
    first_peclet, second_peclet : float
        Pe = V l / (2 kappa) of the bodies [-], with half the length l of the contact along x.
    last : SurfaceHeatState
        The maps of flux and temperatures under the last creepage.
    """

    __words__ = words(
        **{name: SurfaceHeatState.__words__[name] for name in NAMED},
        creep_power=("", "W", "creepages times forces and moment times speed"),
    )

    problem: SurfaceRollingHeating[Q]
    contact: SurfaceRollingSolution[Q]
    heat_rate: Q
    first_share: Q
    exchanged_heat_rate: Q
    max_temperature: Q
    x: Q
    y: Q
    mean_temperature: Q
    mismatch: Q
    grid_error: Q
    first_peclet: float
    second_peclet: float
    last: SurfaceHeatState

    @property
    def creep_power(self) -> Q:
        """What the creepages take [W], forces and moment times speed: `heat_rate`, up to the error of the pixels."""
        return shaped(self.problem.rolling.speed * np.asarray(self.contact.loss_per_distance))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        creepage = float(np.max(np.abs(self.last.rolled.creep))) if self.last.rolled is not None else 0.0
        motion = Note(
            Assumption.CONDUCTION,
            standing_of(0.25 * creepage, SMALL_CREEPAGE, LARGE_CREEPAGE),
            f"Both bodies pass at the speed of rolling; with a slip of {creepage:.2g} of it the share of either may "
            f"differ by {25.0 * creepage:.2g} per cent.",
            JAEGER,
            0.25 * creepage,
        )
        heat = surface_heating_notes(
            self.last,
            self.max_temperature,
            self.grid_error,
            (self.first_peclet, self.second_peclet),
            self.problem._bulk,
        )
        return (*self.contact.validity, motion, *heat)
