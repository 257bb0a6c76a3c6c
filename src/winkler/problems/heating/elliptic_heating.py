r"""Flash temperature of an elliptic contact whose bodies slide in any direction.

The flux is :math:`\mu\,p\,v` with the pressure of Hertz' ellipse and the speed of sliding
:math:`v=|\vec V_1-\vec V_2|`.  Temperature is a mean of line loads over all directions, each changed by the motion of
the surface in closed form (`winkler.numerics.fields.elliptic_source`); the two bodies share the heat.  On layers and
gradings the pressure is that of pixels (`winkler.problems.heating.pressed_source`).
"""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.laws.friction import Overcome
from winkler.laws.heat import EqualMaximum, HeatPartition
from winkler.loading.loads import Depth, Force
from winkler.loading.path import load_number
from winkler.media.conduction.conductors import HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.types import PerLoad, Q, Quantity, shaped
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import HEATED
from winkler.problems.heating.elliptic_sharing import estimated_ellipse, estimated_pressed, shared_ellipse_temperatures
from winkler.problems.heating.heated_ellipse import HeatedEllipse, Turn, half_length, sliding_line
from winkler.problems.heating.input_checks import RubbingBodies, peclet_numbers
from winkler.problems.heating.one_result import one_problem, one_result
from winkler.problems.heating.pressed_source import PressedSource
from winkler.problems.heating.validity import heating_notes
from winkler.problems.normal.elliptic import IN_LAYERS, EllipticIndentation, EllipticSolution
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.one_load import single
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import CurvedBodies
from winkler.values.checks.number_checks import FINITE_QUANTITY, Advice
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["EllipticFrictionHeating", "EllipticFrictionHeatingSolution"]

BY_PIXELS = Note(
    Assumption.RESOLUTION,
    Standing.ASYMPTOTIC,
    "The heat follows the pressure of pixels: where closed forms are known, equal layers and round contacts, greatest "
    "temperatures were within 5e-4 of them and means within 2e-3, at Peclet numbers up to 1e7.",
    "comparison with EllipticFrictionHeating on half-spaces and FrictionHeating on layers",
)


@value
class EllipticFrictionHeating(RubbingBodies, PerLoad[Q]):
    """Two bodies of two curvatures each that slide on each other, or roll and slide, and warm up.

    Parameters
    ----------
    bodies : CurvedBodies or CurvedPair
        R_x and R_y, or the radii of each body; x is that of both together.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies: under Hertz's pressure on homogeneous ones, else under that of the pixels of `EllipticIndentation`.
    law : Coulomb
        Friction, with a finite coefficient.
    load : Force or Depth
        The normal load, which may be an array.
    conductors : HeatConductors
        How the bodies conduct heat: two thick bodies of ThermalConductor, a perfect touch between them; elastic layers
        conduct like what is below them.
    first_speed, second_speed : float or ndarray, optional
        Speeds [m/s] at which the surface of either body moves past the contact; the second one rests unless given.
        Arrays broadcast with each other and with the load.
    first_direction, second_direction : float, optional
        Angles of the velocities to x [rad], at most one turn; 0, along x, unless given.  The bodies slide with the
        difference of the velocities.
    partition : EqualMaximum, EqualMean or FixedShare, optional
        How the bodies share the heat; Blok's rule, EqualMaximum(), unless given.

    Raises
    ------
    InvalidInput
        If the law is not Coulomb's with a finite coefficient, a conductor or partition is none, a number is not
        finite, speeds and load do not broadcast, or a second body at rest has a direction.

    References
    ----------
    J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224; H. Blok, Wear 6 (1963) 483-494,
    doi:10.1016/0043-1648(63)90283-7

    Examples
    --------
    An ellipse slides along its short and along its long axis:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> elastic, steel = Elastic(210e9, 0.3), ThermalConductor(45.0, 12e-6)
    >>> medium, pair = HalfSpace.between(elastic, elastic), HeatConductors(steel, steel)
    >>> slender = CurvedBodies(5e-3, 40e-3)
    >>> for direction in (0.0, math.pi / 2):
    ...     slides = EllipticFrictionHeating(
    ...         slender, medium, Coulomb(0.1), Force(200.0), pair, first_speed=2.0, first_direction=direction
    ...     ).solve()
    ...     print(round(slides.first_peclet, 2), round(slides.flash_temperature, 1))
    10.54 192.8
    41.18 295.6
    """

    __words__ = words(
        bodies=("", None, "curvature radii of the bodies along x and y"),
        first_direction=(r"\psi_1", "rad", "angle of the first body's velocity to x"),
        second_direction=(r"\psi_2", "rad", "angle of the second body's velocity to x"),
    )

    bodies: CurvedBodies | CurvedPair
    medium: Annotated[MappedMedium, Advice("neither Hertz's ellipse nor the boundary elements apply to another")]
    law: Overcome
    load: Force[Q] | Depth[Q]
    conductors: HeatConductors
    first_speed: Annotated[Q | float, FINITE_QUANTITY]
    second_speed: Annotated[Q | float, FINITE_QUANTITY] = 0.0
    first_direction: Turn = 0.0
    second_direction: Turn = 0.0
    partition: HeatPartition = EqualMaximum()

    references: ClassVar[tuple[str, ...]] = ("jaeger_1942", "blok_1963", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = HEATED

    def __post_init__(self) -> None:
        super().__post_init__()
        shapes = [np.shape(each) for each in (load_number(self.load), self.first_speed, self.second_speed)]
        try:
            np.broadcast_shapes(*shapes)
        except ValueError:
            raise InvalidInput(
                f"EllipticFrictionHeating: load, first_speed and second_speed have the shapes {shapes[0]}, {shapes[1]} "
                f"and {shapes[2]}, which do not broadcast; give arrays of one shape, or single numbers."
            ) from None
        if self.second_direction and not np.any(self.second_speed):
            raise InvalidInput(
                f"EllipticFrictionHeating: second_direction is {self.second_direction:g} rad and second_speed is zero: "
                "a body at rest has no direction; give second_speed, or leave second_direction out."
            )

    @property
    def _directions(self) -> tuple[float, float]:
        """Angles of both velocities to x [rad]."""
        return self.first_direction, self.second_direction

    def _source(
        self, contact: EllipticSolution[Q], shape: tuple[int, ...], place: tuple[int, ...]
    ) -> EllipticSource | PressedSource | None:
        """Return where the heat enters at a place of results of this shape, none without contact."""
        columns = contact.longitudinal_semi_axis, contact.lateral_semi_axis, load_number(self.load)
        a, b, load = (float(np.broadcast_to(each, shape)[place]) for each in columns)
        if a == 0.0:
            return None
        if isinstance(self.medium, HomogeneousMedium):
            return EllipticSource(a, b)
        return PressedSource(self.bodies.together, self.medium, type(self.load)(load))  # type: ignore[arg-type]

    def solve(self) -> EllipticFrictionHeatingSolution[Q]:
        """Return how warm the bodies get.

        Raises
        ------
        OutsideValidity
            If `EllipticIndentation` refuses the load, or a Peclet number is above 1e8.
        NotConverged
            If the pressures of the pixels are not found.
        """
        contact = EllipticIndentation(self.bodies, self.medium, self.load).solve()
        speeds = self.first_speed, self.second_speed
        shape = np.broadcast_shapes(np.shape(contact.force), *map(np.shape, speeds))
        first, second = (np.broadcast_to(np.asarray(each, dtype=float), shape) for each in speeds)
        pressed = contact.longitudinal_semi_axis, contact.lateral_semi_axis, contact.force
        a, b, force = (np.broadcast_to(each, shape) for each in pressed)
        touches = a > 0.0
        lengths = [
            np.where(touches, half_length(np.where(touches, a, 1.0), np.where(touches, b, 1.0), direction), 0.0)
            for direction in self._directions
        ]
        peclets = [
            peclet_numbers("EllipticFrictionHeating", length, [speed], (body,))[0]  # type: ignore[arg-type]
            for length, speed, body in zip(lengths, (first, second), self._bodies, strict=True)
        ]
        table = np.zeros((5, *shape))
        for place in np.ndindex(shape):
            source, pair = self._source(contact, shape, place), (float(first[place]), float(second[place]))
            found = shared_ellipse_temperatures(source, self._bodies, self.partition, pair, self._directions)
            table[(slice(None), *place)] = found
        between = self.first_direction - self.second_direction
        sliding = np.hypot(first * math.cos(between) - second, first * math.sin(between))
        heat = self.law.coefficient * force * sliding
        columns: list[Q] = [shaped(each) for each in (heat, table[0], *peclets, *(table[1:] * heat))]
        return EllipticFrictionHeatingSolution(self, contact, *columns)


@value
class EllipticFrictionHeatingSolution(PerLoad[Q]):
    """The solution of an `EllipticFrictionHeating`; each quantity has the common shape of load and speeds.

    Temperatures are rises above that of the bodies far away.

    Parameters
    ----------
    problem : EllipticFrictionHeating
        The problem that was solved.
    contact : EllipticSolution
        The contact, of the shape of the load.
    heat_rate : float or ndarray
        Q = mu F v, the heat of friction per time [W].
    first_share : float or ndarray
        Part of it that goes into the first body [-]; without contact the fixed one, or that of bodies at rest, their
        conductivities against each other.
    first_peclet, second_peclet : float or ndarray
        Pe = V l / (2 kappa) of either body, with half the length l of the ellipse along its motion [-].
    first_max_temperature, second_max_temperature : float or ndarray
        Greatest temperature of either surface within the contact [K].
    first_mean_temperature, second_mean_temperature : float or ndarray
        Mean temperature of either surface over the contact [K].
    """

    __words__ = words(
        first=("1", None, "the first body with its temperature"),
        second=("2", None, "the second body with its temperature"),
    )

    problem: EllipticFrictionHeating[Q]
    contact: EllipticSolution[Q]
    heat_rate: Q
    first_share: Q
    first_peclet: Q
    second_peclet: Q
    first_max_temperature: Q
    second_max_temperature: Q
    first_mean_temperature: Q
    second_mean_temperature: Q

    per_load: ClassVar[str] = "heat_rate"

    @property
    def flash_temperature(self) -> Q:
        """The greatest temperature of the contact, that of the warmer body [K]."""
        return shaped(np.maximum(self.first_max_temperature, self.second_max_temperature))

    @property
    def stationary_temperature(self) -> Q:
        """What the rule of slow sliding gives for the flash temperature [K]: both bodies as if at rest."""
        return self._estimate(0.0, 0.0)

    @property
    def fast_temperature(self) -> Q:
        """What the flash temperature tends to when all that moves does so fast [K]; a body at rest stays at rest."""
        return self._estimate(self.first_peclet, self.second_peclet)

    def _estimate(self, *peclets: Quantity) -> Q:
        contact, problem = self.contact, self.problem
        if not isinstance(problem.medium, HomogeneousMedium):
            return self._estimate_by_pixels(*peclets)
        axes = np.broadcast_arrays(contact.longitudinal_semi_axis, contact.lateral_semi_axis, self.heat_rate)[:2]
        warm = axes[0] > 0.0
        unit = problem.bodies.semi_axes(1.0, 1.0)
        along, across = (np.where(warm, axis, other) for axis, other in zip(axes, unit, strict=True))
        first, second = (np.broadcast_to(peclet, np.shape(self.heat_rate)) for peclet in peclets)
        bodies, directions = problem._bodies, problem._directions
        found = estimated_ellipse((along, across), bodies, problem.partition, (first, second), directions)
        return shaped(np.where(warm, found * self.heat_rate, 0.0))

    def _estimate_by_pixels(self, *peclets: Quantity) -> Q:
        problem, shape = self.problem, np.shape(self.heat_rate)
        rates = [
            np.where(peclet, np.abs(speed), 0.0)
            for peclet, speed in zip(peclets, (problem.first_speed, problem.second_speed), strict=True)
        ]
        first, second = (np.broadcast_to(rate, shape) for rate in rates)
        found = np.zeros(shape)
        for place in np.ndindex(shape):
            source = problem._source(self.contact, shape, place)
            if isinstance(source, PressedSource):
                speeds = float(first[place]), float(second[place])
                found[place] = estimated_pressed(
                    source, problem._bodies, problem.partition, speeds, problem._directions
                )
        return shaped(found * self.heat_rate)

    @property
    def overestimate(self) -> Q:
        """By how much the rule of slow sliding exceeds the flash temperature, relative to that [-]."""
        flash = np.asarray(self.flash_temperature)
        warm = flash > 0.0
        return shaped(np.where(warm, self.stationary_temperature / np.where(warm, flash, 1.0) - 1.0, 0.0))

    @property
    def first(self) -> HeatedEllipse:
        """The first body with its temperature field; of one load and speed, not of an array."""
        return self._body(0)

    @property
    def second(self) -> HeatedEllipse:
        """The second body with its temperature field; of one load and speed, not of an array."""
        return self._body(1)

    def _body(self, which: int) -> HeatedEllipse:
        heat, problem = single(self.heat_rate, "temperature field"), self.problem
        share = self.first_share if which == 0 else 1.0 - self.first_share
        speed = (problem.first_speed, problem.second_speed)[which]
        axes = float(self.contact.longitudinal_semi_axis), float(self.contact.lateral_semi_axis)
        source = problem._source(self.contact, (), ())
        return HeatedEllipse(
            problem._bodies[which], float(speed), problem._directions[which], float(share) * heat, *axes, source
        )

    def at(self, index: int | tuple[int, ...]) -> EllipticFrictionHeatingSolution[float]:
        """Return the solution of one load and speed of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is none.
        """
        shape = np.shape(self.heat_rate)
        place, columns = one_result(self, index)
        kind: type[Any] = type(self.problem.load)
        load = kind(float(np.broadcast_to(load_number(self.problem.load), shape)[place]))
        problem = one_problem(self.problem, shape, place, load=load)
        contact = EllipticIndentation(problem.bodies, problem.medium, problem.load).solve()
        return EllipticFrictionHeatingSolution(problem, contact, **columns)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        pairs = (
            (np.asarray(self.first_peclet), np.asarray(self.second_peclet)),
            (np.asarray(self.first_max_temperature), np.asarray(self.second_max_temperature)),
            (np.asarray(self.first_mean_temperature), np.asarray(self.second_mean_temperature)),
        )
        problem, contact, friction = self.problem, self.contact, self.problem.law.coefficient
        angle = sliding_line((problem.first_speed, problem.second_speed), problem._directions)
        axes = contact.longitudinal_semi_axis, contact.lateral_semi_axis
        if isinstance(problem.medium, HomogeneousMedium):
            yields = ellipse_yield_notes(problem.medium, axes, contact.force, friction, angle)
        else:
            yields = (*unknown_yield(problem.medium, IN_LAYERS), BY_PIXELS)
        return (
            *(note for note in contact.validity if note.assumption is not Assumption.ELASTIC),
            *yields,
            sliding_note(problem.medium, friction),  # type: ignore[arg-type]
            *heating_notes(*pairs, np.asarray(self.overestimate), problem.partition),
        )
