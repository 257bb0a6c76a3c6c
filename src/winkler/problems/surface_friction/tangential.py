r"""A height map pressed and sheared along a path: stick, slip and sliding by boundary elements.

Tractions along the surface displace it (Cerruti), and are at most mu p; where they are, the surfaces slip along them.
Each step of the path is the minimum of an energy (`winkler.numerics.surfaces.sheared_surface`), and what the solver
leaves of that energy is stated with the result.  The outline of the contact does not matter, nor whether it is one spot
or many; the bodies may be similar or dissimilar.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.varying_friction import Slipped
from winkler.loading.loads import Angle, Depth, ShearForce, Torque
from winkler.loading.path import Path, numbers_of
from winkler.media.mapped import MappedMedium
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import RelaxingMedium, relaxes
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import BALANCED, MAPPED
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.row import follow
from winkler.problems.subsurface.last_map import LastMap
from winkler.problems.subsurface.loaded_history import LoadedMap, gathered_maps
from winkler.problems.subsurface.traction_frames import TractionFrame
from winkler.problems.surface_friction.march import MapGoal, MapRow
from winkler.problems.surface_friction.notes import surface_shear_notes
from winkler.problems.surface_friction.relaxing import course_of, relaxing_map_notes
from winkler.problems.surface_friction.state import MapSlip, SurfaceShearState
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, affordable, between
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MOST_NUMBERS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

HELD = Angle(0.0)
"""Bodies that do not turn."""


@value
class SurfaceTangential:
    """A height map pressed into an elastic or viscoelastic half-space and sheared, with friction.

    Parameters
    ----------
    topography : Topography
        Sum of the heights of both bodies, positive towards the other body; the medium is flat.  `SampledProfile` makes
        one of a ball, an ellipse or another profile.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, StackedHalfSpace or DepthGradedHalfSpace
        Both bodies.  For layers normal displacements due to tractions are neglected.  Viscoelastic half-spaces need
        one common relaxation function; layers may have one (RelaxingInProportion) or separate ones
        (ViscoelasticCoatedHalfSpace). The load history begins with the
        first point of the path; a first load that is not zero is applied in one step.
    law : Coulomb, LinearSlipWeakening or ExponentialSlipWeakening
        Law of friction; the coefficient of each pixel depends on its own slip distance.
    path : Path
        Depth or normal force, and shift, shear force, angle or torque, over time.  If a displacement or shear force
        has one component, the other is zero.
    twist : Angle or Torque, optional
        Relative rotation of the bodies in addition to a displacement or shear force, about the middle of the map,
        anticlockwise positive. One number, or one for each point of the path.  The default is no rotation.
    tolerance : float, optional
        Maximum `SurfaceShearState.misfit` at which stick and slip count as solved.

    Raises
    ------
    InvalidInput
        If heights are missing, the map is periodic and twisted, or the map is too large. If the numbers of the twist do
        not fit the path, or the path already contains a twist.  If half-spaces relax by more than one function of
        time, a dashpot stands alongside, or a liquid leaves a film.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9;
    R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973

    Examples
    --------
    A ball under 7/8 of the shear force at which it slides: half of the radius sticks, a quarter of the area.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> rubber = Elastic(young=1e6, poisson=0.0)
    >>> ball = SampledProfile([2e-3, 2e-3], Paraboloid(10e-3), (65, 65))
    >>> path = Path.through(Force(0.02), ShearForce([0.0, 0.875 * 0.3 * 0.02]))
    >>> pushed = SurfaceTangential(ball, HalfSpace.between(rubber, rubber), Coulomb(0.3), path).solve()
    >>> round(float(pushed.stick_share[-1]), 2)
    0.25
    """

    __words__ = words(twist=("", None, "how the bodies turn beside a shift or a shear force"))

    topography: Topography
    medium: Annotated[MappedMedium | RelaxingMedium, Advice("the boundary elements apply to no other")]
    law: Slipped
    path: Path
    twist: Angle | Torque = HELD
    tolerance: Annotated[float, between(1e-12, 1e-2)] = 1e-8

    references: ClassVar[tuple[str, ...]] = (
        "kalker_1990", "cattaneo_1938", "mindlin_1949", "spence_1975", "polonsky_keer_1999",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | BALANCED | {
        Assumption.UNCOUPLED, Assumption.SLIP, Assumption.KNOWN_TIMES,
    }  # fmt: skip

    def __post_init__(self) -> None:
        around = 1 if self.topography.periodic else 4  # what is not repeated is padded to twice its lengths
        course = self._course[1]
        terms = (
            course.moduli.size
            if isinstance(course, RelaxationSeries)
            else (1 + around) * len(course.rates.times if course.rates else ())
        )
        remembered = 3 * terms  # of each term of the relaxation; waves of all around of what has its own law
        pixels = (2 * around + remembered) * self.topography.heights.size
        affordable("SurfaceTangential", "pixels of two directions with their surroundings", pixels, MOST_NUMBERS)
        missing = self.topography.missing
        if missing:
            raise InvalidInput(
                f"SurfaceTangential: {missing} of {self.topography.heights.size} heights are missing; fill them with "
                "topography.filled(), or cut a complete part out with topography.cropped(...)."
            )
        if float(np.ptp(self.topography.heights)) == 0.0 and self.topography.periodic:
            raise InvalidInput(
                "SurfaceTangential: the periodic map is flat and touches everywhere at once; nothing to solve."
            )
        compliance_of(self._course[0])  # refuses bodies whose tractions are not known
        turns = isinstance(self.path.lateral, Angle | Torque)
        if turns and self.twist != HELD:
            raise InvalidInput(
                "SurfaceTangential: the path twists the bodies, and there is a twist beside it; leave the twist out, "
                "or give the path a Shift or a ShearForce."
            )
        count = self.path.time.size
        if np.shape(numbers_of(self.twist)) not in ((), (count,)):
            raise InvalidInput(
                f"SurfaceTangential: the twist has the shape {np.shape(numbers_of(self.twist))} for a path of {count} "
                "points; give one number, or one for each point."
            )
        if self.topography.periodic and (turns or isinstance(self.twist, Torque) or np.any(numbers_of(self.twist))):
            raise InvalidInput(
                "SurfaceTangential: a periodic map repeats without end and has no middle for a rotation; leave "
                "the twist out, or give a map that is not periodic."
            )

    @property
    def _course(self) -> tuple[MappedMedium, RelaxationSeries | RelaxingByWaves]:
        """The bodies as if they were elastic, and their course in time, as of `course_of`."""
        return course_of("SurfaceTangential", self.medium)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return int(self.path.time.size)

    def _motions(self) -> tuple[Array, Array]:
        """Return what is given of the motions along x, y and about the middle, (points, 3), and which by force."""
        lateral, count = self.path.lateral, self.path.time.size
        given, by_force = np.zeros((count, 3)), np.zeros(3, dtype=bool)
        if isinstance(lateral, Angle | Torque):
            given[:, 2], by_force[2] = numbers_of(lateral), isinstance(lateral, Torque)
            return given, by_force
        along = self.path.along
        given[:, : 1 if along.ndim == 1 else 2] = along.reshape(count, -1)
        given[:, 2] = numbers_of(self.twist)
        by_force[:2], by_force[2] = isinstance(lateral, ShearForce), isinstance(self.twist, Torque)
        return given, by_force

    def steps(self) -> Iterator[SurfaceShearState]:
        """Yield the contact at every point of the path.

        Raises
        ------
        OutsideValidity
            If a prescribed shear force exceeds the friction limit.
        NotConverged
            If stick and slip are not found to the tolerance.
        """
        given, by_force = self._motions()
        row = MapRow(self.topography, *self._course, self.law, by_force, self.tolerance)
        length = self.topography.pixel[0]
        motions = given / np.where(by_force, row.patch * np.array([1.0, 1.0, length]), np.array([length, length, 1.0]))
        across = self.path.across
        drives = (
            map(ByDepth, across.tolist())
            if isinstance(self.path.normal, Depth)
            else map(ByLoad, (across / row.patch).tolist())
        )
        yield from map(row.state, follow(row, map(MapGoal, self.path.time.tolist(), drives, motions)))

    def gathered(self, states: Iterable[SurfaceShearState]) -> SurfaceTangentialSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        found = gathered_maps(states, SurfaceTangentialSolution)
        return SurfaceTangentialSolution(problem=self, **found.columns, **found.maps)

    def solve(self) -> SurfaceTangentialSolution:
        """Return the contact along the whole path.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class SurfaceTangentialSolution(MapSlip[Array], Looped, LastMap):
    """The solution of a `SurfaceTangential` problem, point by point; its numbers are those of `MapSlip`.

    Parameters
    ----------
    problem : SurfaceTangential
        The problem that was solved.
    last : SurfaceShearState
        The contact at the end of the path, with its maps of pressure, traction and slip.
    heaviest : tuple of LoadedMap
        The states that are searched for the maximum stress of the whole path.
    frames : tuple of TractionFrame
        Contact, stick and slip zones of states along the history.
    """

    __words__ = words(
        heaviest=("", None, "states among which the greatest stress is sought"),
        frames=("", None, "what touches, sticks and slips in states along the history"),
    )

    problem: SurfaceTangential
    last: SurfaceShearState
    heaviest: tuple[LoadedMap, ...]
    frames: tuple[TractionFrame, ...]

    @property
    def shift_x(self) -> Array:
        """u_x [m], ``(points,)``."""
        return self.shift[:, 0]

    @property
    def shift_y(self) -> Array:
        """u_y [m], ``(points,)``."""
        return self.shift[:, 1]

    @property
    def shear_force_x(self) -> Array:
        """F_x [N], ``(points,)``."""
        return self.shear_force[:, 0]

    @property
    def shear_force_y(self) -> Array:
        """F_y [N], ``(points,)``."""
        return self.shear_force[:, 1]

    @property
    def _medium(self) -> MappedMedium:
        if relaxes(self.problem.medium):
            raise OutsideValidity(
                "SurfaceTangentialSolution: displacements and stresses below a height map on viscoelastic bodies are "
                "not implemented, its pressures and tractions are; give an elastic medium."
            )
        return self.problem._course[0]

    @property
    def _loop(self) -> PathLoop:
        stated = self.problem
        given, _ = stated._motions()
        pushed, turned = np.any(np.ptp(given[:, :2], axis=0) > 0.0), np.ptp(given[:, 2]) > 0.0
        motion, load = self.shift, self.shear_force
        if turned and pushed:  # three components, of which the third turns the far side of the map
            arm = stated.topography.lengths[0]
            motion, load = np.column_stack((motion, arm * self.angle)), np.column_stack((load, self.torque / arm))
        elif turned:
            motion, load = self.angle, self.torque
        return PathLoop((stated.path.across, given), motion, load, self.dissipation)

    @property
    def secant_stiffness(self) -> float:
        """Amplitude of the shear force over that of the shift in the last cycle of the path [N/m].

        Raises
        ------
        OutsideValidity
            If the path has no closed cycle, no displacement, changes its direction, or contains a rotation.
        """
        if self._loop.motion is self.angle:
            raise OutsideValidity(
                "SurfaceTangential: the cycle turns the bodies, so that its stiffness is a torque over an angle; read "
                "last_cycle.load / last_cycle.motion [N m/rad]."
            )
        return super().secant_stiffness

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: residuals, steps, border, slopes, pixels."""
        stated, touched = self.problem, self.area > 0.0
        if relaxes(stated.medium):
            yielded = relaxing_map_notes(stated.medium, self.time)
        else:
            yielded = self._yield_notes(self.time.size)
        blurred = float(np.max(self.area_error[touched] / self.area[touched], initial=0.0))
        notes = surface_shear_notes(
            stated.topography, stated._course[0], stated.law, blurred, self.force,
            self.penetration, self.misfit,
        )  # fmt: skip
        return (*notes, *yielded, *self._cycle_notes)
