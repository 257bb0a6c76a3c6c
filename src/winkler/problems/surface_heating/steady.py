r"""Temperature of a contact of any outline that slides, or that rolls with creepage.

The flux of heat is the traction times the velocity of slip: :math:`q = \tau_x\,(V_2-V_1)` of bodies that slide along x,
:math:`q = \boldsymbol\tau\cdot\mathbf s'\,V` in every pixel that slips while the bodies roll
(`winkler.problems.surface_rolling.steady`).  Each body passes the contact at its own velocity along x; bodies that roll
both pass at the speed V towards -x, as the theory of small creepages has it.  They share the heat so that their
surfaces have one temperature wherever they touch (`winkler.numerics.surfaces.shared_heat`).
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import HEATED, MAPPED
from winkler.problems.heating.input_checks import RubbingBodies, peclet_numbers
from winkler.problems.heating.validity import oscillation_notes, swing_of
from winkler.problems.last_cycle import CLOSED, cycle_ends
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.problems.surface_heating.notes import passing_note, slip_zone_note, surface_heating_notes
from winkler.problems.surface_heating.patch import HeatedPatch, half_length
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.problems.surface_rolling.steady import SurfaceRolling, SurfaceRollingSolution
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Finite, NonNegative
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FEWEST_PIXELS = 2
NAMED = ("x", "y", "mean_temperature", "mismatch", "grid_error")
APART = ("problem", "contact", "first_peclet", "second_peclet", "last")
"""Fields of a solution that are no numbers of its creepages."""


def _passes(contact: SurfaceRolling | SurfaceLoad | SurfaceTangential) -> bool:
    return not isinstance(contact, SurfaceRolling) or contact.speed > 0.0


@value
class SurfaceFrictionHeating(RubbingBodies, PerLoad[Q]):
    """Heating of bodies that slide along x, roll with creepage, or fret, in contact on a pixel map.

    Parameters
    ----------
    contact : SurfaceLoad, SurfaceRolling or SurfaceTangential
        Pressures and tractions on the first body: mu p along x if the second body slides over it towards +x. Or a
        rolling problem with one or more creepages. Or a path that ends with a closed cycle, repeated without end: two
        cycles of an oscillation, as the first one differs; temperatures are then means over a cycle.
    conductors : HeatConductors
        Thermal conductors of the bodies: two thick bodies of ThermalConductor, in perfect thermal contact.
    first_speed, second_speed : float, optional
        Velocities along x at which the surfaces pass the contact [m/s], for a SurfaceLoad; by default the bodies are at
        rest.  Bodies that roll have the speed of their SurfaceRolling; those that fret are at rest.
    first_bulk_temperature, second_bulk_temperature : float, optional
        Temperatures of the bodies far from the contact [K], relative to a common level. With the default of zero all
        temperatures are rises.
    frequency : float, optional
        Of the cycle of a SurfaceTangential [Hz]; the times of its path are not used.

    Raises
    ------
    InvalidInput
        If a body does not conduct heat, the map is periodic or one pixel wide, or there is no pressure. If tractions
        drive the bodies, a number is not finite, the rolling speed is zero, or rolling bodies have other speeds. If a
        SurfaceTangential has no frequency, or its path does not end with a cycle, or another contact has a frequency.
    OutsideValidity
        If the bodies of a SurfaceTangential are viscoelastic.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7; M. Ertz, K. Knothe, Wear 253 (2002) 498-508

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

    A wheel that slips by 0.5 % at 30 m/s:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.rolling.creepage import Creepage
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> steel = HalfSpace.between(Elastic(210e9, 0.28), Elastic(210e9, 0.28))
    >>> wheel = SampledProfile([16e-3, 14e-3], CurvedBodies(0.46, 0.3), (48, 42))
    >>> rolling = SurfaceRolling(wheel, steel, Force(80e3), Coulomb(0.3), Creepage(longitudinal=5e-3), speed=30.0)
    >>> conductor = ThermalConductor.of(conductivity=50.0, density=7850.0, heat_capacity=450.0)
    >>> warm = SurfaceFrictionHeating(rolling, HeatConductors(conductor, conductor)).solve()
    >>> round(warm.heat_rate / 1e3, 1), round(warm.first_share, 6), warm.x < 0.0
    (3.6, 0.5, True)

    A ball that is pushed to and fro by a micrometre, a hundred times a second:

    >>> from winkler.loading.path import Path
    >>> from winkler.profiles.power import Paraboloid
    >>> ball = SampledProfile([0.5e-3, 0.5e-3], Paraboloid(10e-3), (32, 32))
    >>> path = Path.oscillation(force=100.0, amplitude=1e-6, cycles=2, count=20)
    >>> fretted = SurfaceTangential(ball, steel, Coulomb(0.5), path)
    >>> warm = SurfaceFrictionHeating(fretted, HeatConductors(conductor, conductor), frequency=100.0).solve()
    >>> round(warm.heat_rate / (100.0 * warm.contact.loss_per_cycle), 9)
    1.0
    """

    __words__ = words(
        contact=("", None, "map of pressures and tractions, or problem of the map that rolls or frets"),
        speeds=("V", "m/s", "velocities of both surfaces along x past the contact"),
        places=("", "m", "middles of the pixels along x and along y"),
        first_bulk_temperature=("T_{1}", "K", "temperature of the first body far from the contact"),
        second_bulk_temperature=("T_{2}", "K", "temperature of the second body far from the contact"),
    )

    contact: Annotated[
        SurfaceLoad | SurfaceRolling[Q] | SurfaceTangential,
        Condition(_passes, "give SurfaceRolling a speed in m/s: heat depends on it"),
    ]
    conductors: HeatConductors
    first_speed: Finite = 0.0
    second_speed: Finite = 0.0
    first_bulk_temperature: Finite = 0.0
    second_bulk_temperature: Finite = 0.0
    frequency: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "kalker_1990")
    assumptions: ClassVar[frozenset[Assumption]] = (
        HEATED | MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        contact = self.contact
        frets = isinstance(contact, SurfaceTangential)
        if frets != (self.frequency > 0.0):
            raise InvalidInput(
                f"SurfaceFrictionHeating: the contact is a {type(contact).__name__} and the frequency "
                f"{self.frequency:g} Hz; "
                + ("give the cycles per second, in Hz." if frets else "only SurfaceTangential has one: leave it out.")
            )
        rough = contact if isinstance(contact, SurfaceLoad) else contact.topography
        shape = (rough.pressure if isinstance(rough, SurfaceLoad) else rough.heights).shape
        if rough.periodic or min(shape) < FEWEST_PIXELS:
            raise InvalidInput(
                f"SurfaceFrictionHeating: the map has {shape[0]} x {shape[1]} pixels and is "
                f"{'periodic' if rough.periodic else 'finite'}; give one that is not periodic, of at least "
                "two pixels in both directions."
            )
        if not isinstance(contact, SurfaceLoad):
            if self.first_speed or self.second_speed:
                known = "fret are at rest"
                if isinstance(contact, SurfaceRolling):
                    known = f"roll pass at the speed of SurfaceRolling, {contact.speed:g} m/s"
                raise InvalidInput(
                    f"SurfaceFrictionHeating: first_speed is {self.first_speed:g} m/s and second_speed "
                    f"{self.second_speed:g} m/s, but bodies that {known}; leave both out."
                )
            if isinstance(contact, SurfaceTangential) and _ends(contact) is None:
                raise InvalidInput(
                    "SurfaceFrictionHeating: the path of the contact does not come back to loads that it had, in the "
                    "same direction; let it end with a closed cycle, as two cycles of an oscillation do."
                )
            return
        if not np.any(contact.pressure > 0.0):
            raise InvalidInput("SurfaceFrictionHeating: no pressure is positive, so nothing touches; give a load.")
        worst = float(np.min(self._dragged(contact)))
        if worst < 0.0:
            raise InvalidInput(
                f"SurfaceFrictionHeating: the tractions would push the bodies on, with up to {-worst:.3g} W/m^2; they "
                "act on the first body and point to where the second one slides over it: change the sign of "
                "x_traction, or of the speeds."
            )

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every creepage."""
        return self.contact.total if isinstance(self.contact, SurfaceRolling) else 1

    @property
    def speeds(self) -> tuple[float, float]:
        """Velocities along x [m/s] at which the surfaces pass the contact; for rolling bodies the rolling speed."""
        if isinstance(self.contact, SurfaceRolling):
            return -self.contact.speed, -self.contact.speed
        return self.first_speed, self.second_speed

    @property
    def places(self) -> tuple[Array, Array]:
        """Centres of the pixels along x and along y [m]; of height maps relative to the middle of the map."""
        if isinstance(self.contact, SurfaceLoad):
            return self.contact.places
        rough = self.contact.topography
        x, y = ((np.arange(n) - 0.5 * (n - 1)) * step for n, step in zip(rough.heights.shape, rough.pixel, strict=True))
        return x, y

    @property
    def _bulk(self) -> tuple[float, float]:
        return self.first_bulk_temperature, self.second_bulk_temperature

    def _dragged(self, load: SurfaceLoad) -> Array:
        """Return what friction of sliding turns into heat [W/m^2]."""
        sliding = self.second_speed - self.first_speed
        return np.asarray(np.where(load.pressure > 0.0, load.loads[1] * sliding, 0.0)) + 0.0

    def _heats(self) -> Iterator[tuple[Array, Array, dict[str, Any]]]:
        """Yield pressure [Pa] and heat of friction [W/m^2], with the contact of every creepage, or its path."""
        match self.contact:
            case SurfaceLoad():
                yield self.contact.pressure, self._dragged(self.contact), {}
            case SurfaceRolling():
                for rolled in self.contact.steps():
                    yield rolled.pressure, self.contact.speed * _lost(rolled), {"rolled": rolled}
            case SurfaceTangential():
                pressure, lost, march = _cycle(self.contact)
                yield pressure, self.frequency * lost, {"march": march}

    def steps(self) -> Iterator[SurfaceHeatState]:
        """Yield the temperatures, for rolling bodies at every creepage.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of a map that rolls, or a Peclet number is above 1e8. If nothing slips
            in the last cycle of a path, or this cycle is not closed.
        NotConverged
            If the iteration for stick and slip or for the temperatures does not converge.
        """
        patch: HeatedPatch | None = None
        touching = np.zeros(0, dtype=bool)
        for pressure, flux, contact in self._heats():
            if patch is None or not np.array_equal(pressure > 0.0, touching):
                touching = pressure > 0.0
                self._peclets(pressure)
                owner = type(self).__name__
                patch = HeatedPatch.of(owner, pressure, self.places, self._bodies, self.speeds, self._bulk)
            yield dataclasses.replace(patch.heated(flux), **contact)

    def gathered(self, states: Iterable[SurfaceHeatState]) -> SurfaceFrictionHeatingSolution[Q]:
        """Return the solution made of these states, of all creepages or of the first ones."""
        reached = list(states)
        contact: SurfaceRollingSolution[Q] | SurfaceLoad | SurfaceTangentialSolution | None = reached[-1].march
        problem, shape = self, ()
        if isinstance(self.contact, SurfaceRolling):
            contact = self.contact.gathered([state.rolled for state in reached if state.rolled is not None])
            problem, shape = dataclasses.replace(self, contact=contact.problem), np.shape(contact.force)
        elif isinstance(self.contact, SurfaceLoad):
            contact = self.contact
        assert contact is not None
        names = [field.name for field in dataclasses.fields(SurfaceFrictionHeatingSolution) if field.name not in APART]
        rows = {name: np.array([getattr(state, name) for state in reached]) for name in names}
        columns: dict[str, Q] = {name: shaped(row, shape) for name, row in rows.items()}
        last = reached[-1]
        first, second = self._peclets(last.pressure)
        return SurfaceFrictionHeatingSolution(
            problem, contact, **columns, first_peclet=first, second_peclet=second, last=last
        )

    def solve(self) -> SurfaceFrictionHeatingSolution[Q]:
        """Return the temperatures of the surfaces.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())

    def _peclets(self, pressure: Array) -> tuple[float, float]:
        x, _ = self.places
        half = half_length(pressure > 0.0, float((x[-1] - x[0]) / (x.size - 1)))
        speeds = [np.asarray(speed) for speed in self.speeds]
        first, second = peclet_numbers(type(self).__name__, [half] * 2, speeds, self._bodies)
        return float(first), float(second)


def _ends(contact: SurfaceTangential) -> tuple[int, int] | None:
    return cycle_ends((contact.path.across, contact._motions()[0]))


def _cycle(contact: SurfaceTangential) -> tuple[Array, Array, SurfaceTangentialSolution]:
    """Return the greatest pressures of the last cycle [Pa], its loss per area [J/m^2], and the whole path."""
    begin, _ = _ends(contact) or (0, 0)
    pressure, lost = np.zeros((2, *contact.topography.heights.shape))

    def watched() -> Iterator[SurfaceShearState]:
        for index, state in enumerate(contact.steps()):
            if index == begin:
                lost[:] = -state.friction_work
            if index >= begin:
                np.maximum(pressure, state.pressure, out=pressure)
            yield state

    march = contact.gathered(watched())
    lost += march.last.friction_work
    if not np.any(lost > 0.0):
        raise OutsideValidity(
            "SurfaceFrictionHeating: nothing slips in the last cycle of the path, so there is no heat; increase the "
            "amplitude, or reduce the load."
        )
    gap = march.last_cycle.gap
    if gap > CLOSED:
        raise OutsideValidity(
            f"SurfaceFrictionHeating: the last cycle of the path ends {gap:.2g} of its range from its beginning, so "
            "that it would not repeat itself; append cycles, as with cycles=2."
        )
    return pressure, lost, march


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


@value
class SurfaceFrictionHeatingSolution(PerLoad[Q]):
    """The solution of a `SurfaceFrictionHeating`; of bodies that roll, quantities have the shape of the creepage.

    Parameters
    ----------
    problem : SurfaceFrictionHeating
        The problem that was solved.
    contact : SurfaceLoad, SurfaceRollingSolution or SurfaceTangentialSolution
        The map, or the contact that rolls or frets with its forces.
    heat_rate, first_share, exchanged_heat_rate, max_temperature, mean_temperature, mismatch, grid_error
        As in `SurfaceHeatState`, float or ndarray.
    x, y : float or ndarray
        Place of the maximum temperature [m].
    first_peclet, second_peclet : float
        Pe = V l / (2 kappa) of the bodies [-], with half the length l of the contact along x.
    last : SurfaceHeatState
        The maps of flux and temperatures, under the last creepage.
    """

    __words__ = words(
        **{name: SurfaceHeatState.__words__[name] for name in NAMED},
        creep_power=("", "W", "creepages times forces and moment times speed"),
    )

    problem: SurfaceFrictionHeating[Q]
    contact: SurfaceLoad | SurfaceRollingSolution[Q] | SurfaceTangentialSolution
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
        """Frictional power [W]: forces and moment times creepages and speed; for sliding bodies traction times
        velocity; for fretting bodies the loss per cycle times the frequency.

        It equals `heat_rate` within the error of the pixels.
        """
        if isinstance(self.contact, SurfaceLoad):
            return self.heat_rate
        if isinstance(self.contact, SurfaceTangentialSolution):
            return shaped(np.asarray(self.problem.frequency * self.contact.loss_per_cycle))
        return shaped(self.contact.problem.speed * np.asarray(self.contact.loss_per_distance))

    @property
    def swing(self) -> float:
        """Estimate of the maximum temperature amplitude about the mean of fretting bodies [K]; zero of others."""
        if not isinstance(self.contact, SurfaceTangentialSolution):
            return 0.0
        rise, stated = float(np.max(self.max_temperature)) - min(self.problem._bulk), self.problem
        return swing_of(stated._bodies, stated.frequency, float(np.max(self.last.flux)), rise)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        peclets = self.first_peclet, self.second_peclet
        hottest = self.max_temperature + self.swing
        heat = surface_heating_notes(self.last, hottest, self.grid_error, peclets, self.problem._bulk)
        if isinstance(self.contact, SurfaceTangentialSolution):
            radius = math.sqrt(float(np.max(self.contact.area)) / math.pi)
            strokes = (*np.ptp(self.contact.shift, axis=0) / radius, np.ptp(self.contact.angle))
            stroke = 0.5 * float(max(strokes))
            swings = oscillation_notes(self.problem._bodies, self.problem.frequency, self.swing, stroke)
            return (*self.contact.validity, slip_zone_note(self.last), *swings, *heat)
        if isinstance(self.contact, SurfaceLoad) or self.last.rolled is None:
            return heat
        return (*self.contact.validity, passing_note(self.last.rolled), *heat)
