r"""A line contact of bodies that relax, under a force per length that grows, stays, falls and grows again.

While the strip widens the elastic solution holds with the load replaced by its hereditary integral (Lee and Radok),

.. math:: w(a(t)) = \ell(t) = \int C(t-t')\,\frac{\mathrm dP}{\mathrm dt'}\,\mathrm dt' .

In general q(c), what strips wider than c bear, follows from :math:`u(c,t)=\ell(t)-w(c)` as the load of a spring that
relaxes, lets go when it would pull, recovers freely, and is caught again: the row of springs of
`winkler.problems.viscoelastic`, with w in the place of g and the load that crept in the place of the depth.  The spring
in the middle bears P; that at the edge bears nothing, which is Ting's rule where the strip first becomes narrower.
"""

from __future__ import annotations

import functools
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.springs import Springs
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.line.approach import Place
from winkler.problems.line.half_width import grows, refuse_unless_strips, under_force
from winkler.problems.line.load_springs import LoadSprings
from winkler.problems.line_viscoelastic.crept_load import CreptLoad, Spacing
from winkler.problems.line_viscoelastic.layered_strips import elastic_line
from winkler.problems.line_viscoelastic.path import LineForcePath
from winkler.problems.line_viscoelastic.sinking import approach_of_strips
from winkler.problems.line_viscoelastic.states import LineViscoelasticState
from winkler.problems.line_viscoelastic.validity import relaxing_line_notes
from winkler.problems.line_viscoelastic.wave_strips import cells_notes, strips_along
from winkler.problems.one_load import OfPath
from winkler.problems.viscoelastic.layered_path import refuse_many
from winkler.problems.viscoelastic.march import SpringRow, refuse_rings
from winkler.values.checks.number_checks import Whole, affordable, between
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MOST_NUMBERS, RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

NO_LOAD = 1e-12
"""Part of the greatest force per length below which there is none."""
PLACES_INSIDE = np.linspace(0.0, 0.98, 25)
PULL = 2e-3
"""Places at which it is examined whether layers pull, over the half-width, and what is rounding of the springs."""
UNBALANCED = 0.1
"""Error of the load of a dashpot alongside, over the greatest force and the root of the tolerance."""


@value
class LineViscoelasticIndentation:
    """A cylinder, wedge or other two-dimensional body pressed on viscoelastic bodies, in plane strain.

    The load history begins with the first point of the path. A first force that is not zero is applied in one step.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        Profile and bodies: on a `ViscoelasticHalfSpace`, on `RelaxingInProportion` layers, on layers with separate
        relaxation functions, or on a `PoroelasticFilm`. Poisson's ratios of solids are constant.
    path : LineForcePath
        Force per length over time.
    count : int, optional
        Number of springs, or cells on layers with separate relaxation functions; the error falls with its square.
    tolerance : float, optional
        Error of the creep load between two times, over its maximum value.  For layers with separate relaxation
        functions it is the error of the pressure in a step; the effective tolerance is at least 0.1 / count^2.

    Raises
    ------
    InvalidInput
        If the bodies do not relax, or a number is out of range.
    OutsideValidity
        If a body is graded with depth.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020; T. C. T. Ting, J. Appl. Mech. 33
    (1966) 845-854, doi:10.1115/1.3625192

    Examples
    --------
    A rigid cylinder on a Maxwell fluid with E* = 1 and tau = 1: a^2 = 4 R P (1 + t/tau) / (pi E*).

    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> fluid = ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=1.0))
    >>> bed = LineFoundation(Paraboloid(1.0), fluid)
    >>> creeping = LineViscoelasticIndentation(bed, LineForcePath([0.0, 3.0], 1e-4 * np.pi)).solve()
    >>> creeping.half_width.round(9)
    array([0.02, 0.04])
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        path=("", None, "the force per length over time"),
        count=("n", None, "how many springs"),
        tolerance=("", None, "error of the load that crept between two moments, over its greatest value"),
    )

    bed: LineFoundation | LayeredLineFoundation
    path: LineForcePath
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 500
    tolerance: Annotated[float, between(1e-10, 0.1)] = 1e-6

    references: ClassVar[tuple[str, ...]] = ("lee_radok_1960", "ting_1966", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING

    def __post_init__(self) -> None:
        medium: object = self.bed.medium
        if not offers(medium, RelaxingMedium):
            raise InvalidInput(
                f"LineViscoelasticIndentation: the bed stands on a {type(medium).__name__}; give "
                "LineFoundation(profile, ViscoelasticHalfSpace(solid)), LayeredLineFoundation(profile, "
                "RelaxingInProportion(medium, solid, shear)) or on a ViscoelasticCoatedHalfSpace(layers, on), or "
                "LineIndentation for bodies that do not relax."
            )
        if isinstance(self.bed, LayeredLineFoundation):
            self.bed.refuse_grading(
                "LineViscoelasticIndentation: strips relax on half-planes and on layers; in the place of the grading"
            )
        if offers(medium, RelaxingByWaves):
            refuse_many("LineViscoelasticIndentation", self.bed, self.count)
        affordable("LineViscoelasticIndentation", "numbers", self.total * self.count, MOST_NUMBERS)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.moments.size

    def steps(self) -> Iterator[LineViscoelasticState]:
        """Yield the state at every point of the path, just after a sudden step at this point.

        Raises
        ------
        OutsideValidity
            If the bodies are never pressed, or the load exceeds the known range of the profile. If the contact is not a
            single strip, or the bodies touch beside a dent.
        """
        medium: Any = self.bed.medium
        times, forces = self.path.moments, self.path.across
        most = float(np.max(forces))
        if most == 0.0:
            raise OutsideValidity(
                "LineViscoelasticIndentation: the force per length is zero all the time; press the bodies together."
            )
        if offers(medium, RelaxingByWaves):
            assert isinstance(self.bed, LayeredLineFoundation)
            yield from strips_along(self.bed, self.path, self.count, self.tolerance)
            return
        parts, deepest = self._crept(medium)
        line = elastic_line(self.bed)
        modulus = line.medium.modulus
        widest = float(under_force(line, np.array([deepest / modulus]))[0])
        if not (line.profile.rising or grows(line, widest)):
            raise OutsideValidity(
                "LineViscoelasticIndentation: below its greatest load the profile lets the load fall again, so that "
                "the contact is no strip that grows steadily; give a smoother profile or a smaller load."
            )
        if not line.single:
            refuse_unless_strips(line, np.array([widest]))
        row = SpringRow(LoadSprings(line), _springs(line, widest, self.count), medium.relaxation)
        ends = np.array([levels[-1] for _, levels in parts])
        before = np.maximum.accumulate([np.max(levels) for _, levels in parts])
        unbound = np.where(ends >= before, under_force(line, ends / modulus), 0.0)  # on ground that was never touched
        for time, force, fresh, (spans, levels) in zip(
            times.tolist(), forces.tolist(), unbound.tolist(), parts, strict=True
        ):
            done = row.march(np.diff(levels, prepend=row.depth), spans)
            if force > NO_LOAD * most:
                refuse_rings("LineViscoelasticIndentation", np.array([time]), np.any(done.ring, keepdims=True))
            yield self._state(
                row, modulus, time, force if force > NO_LOAD * most else 0.0, fresh or float(done.radius[-1])
            )

    def _state(
        self, row: SpringRow, modulus: float, time: float, force: float, half_width: float
    ) -> LineViscoelasticState:
        """Return the state in which the middle spring bears the force; what it lacks all that are pressed lack."""
        loads, place, depth = row.loads(), row.place / modulus, row.depth / modulus
        if force == 0.0:
            return LineViscoelasticState(
                self.bed, time, 0.0, 0.0, depth, 0.0, row.springs.position, np.zeros(place.size), place
            )
        missing = force - float(loads[0])
        borne = np.where(row.pressed, np.maximum(loads + missing, 0.0), 0.0)
        rate, edge_load = float(row.motion[2]), 0.0
        if half_width >= self.bed.rim:
            edge_load = float(borne[-1])
        elif rate > 0.0:
            edge_load = row.series.viscosity * rate
            edge_load = min(max(edge_load + missing, 0.0), force) if edge_load > 0.0 else 0.0
        elif row.series.viscosity > 0.0:  # a dashpot bears the rate itself, not its mean
            half_width = _edge(row.springs, borne, half_width)
        position = row.springs.position
        state = LineViscoelasticState(self.bed, time, force, half_width, depth, edge_load, position, borne, place)
        if isinstance(self.bed, LayeredLineFoundation):
            _refuse_pulling(state)
        return state

    def _crept(self, medium: RelaxingMedium) -> tuple[list[tuple[Array, Array]], float]:
        """Return spans [s] and levels [m] of the load that crept up to every point, and its greatest level."""
        most = float(np.max(self.path.across))
        greatest = max(float(levels[-1]) for _, levels in self._levels(medium, None))
        rough = UNBALANCED * np.sqrt(self.tolerance) * most
        spacing = Spacing(self.tolerance * greatest, medium.relaxation.viscosity, rough)
        parts = list(self._levels(medium, spacing))
        affordable("LineViscoelasticIndentation", "moments", sum(levels.size for _, levels in parts), MOST_NUMBERS)
        return parts, max(float(np.max(levels)) for _, levels in parts)

    def _levels(self, medium: RelaxingMedium, spacing: Spacing | None) -> Iterator[tuple[Array, Array]]:
        crept, times, forces = CreptLoad(medium.creep), self.path.moments.tolist(), self.path.across.tolist()
        for i, force in enumerate(forces):
            if i and times[i] > times[i - 1]:
                moments, levels = crept.ramp(force, times[i] - times[i - 1], spacing)
                yield np.diff(moments, prepend=0.0), levels
            else:
                crept.jump(force)
                yield np.zeros(1), np.array([crept.present()])

    def gathered(self, states: Iterable[LineViscoelasticState]) -> LineViscoelasticSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(LineViscoelasticSolution, self, states)

    def solve(self) -> LineViscoelasticSolution:
        """Return the contact along the whole path.

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())


@functools.lru_cache(maxsize=8)
def _springs(line: LineFoundation | LayeredLineFoundation, widest: float, count: int) -> Springs:
    """Return the springs of an elastic line, kept: on layers they take longer than what is done with them."""
    return Springs.of(LoadSprings(line), widest, count)


def _refuse_pulling(state: LineViscoelasticState) -> None:
    """Refuse a strip that is pulled inside."""
    pressure = state.pressure(state.half_width * PLACES_INSIDE)
    if np.min(pressure) < -PULL * np.max(pressure):
        raise OutsideValidity(
            f"LineViscoelasticIndentation: at {state.time:.6g} s the layers are pulled inside the strip, so that the "
            "contact is no single one; end the path before."
        )


def _edge(springs: Springs, borne: Array, half_width: float) -> float:
    """Return the half-width at which the loads of a strip that becomes narrower come to nothing [m]."""
    last = int(np.count_nonzero(borne > 0.0)) - 1
    if last < 1 or not borne[last - 1] > borne[last]:
        return half_width
    gap, squared = springs.gap, springs.position**2
    if last + 1 == gap.size:
        return half_width
    reach = borne[last] * (gap[last] - gap[last - 1]) / (borne[last - 1] - borne[last])
    part = min(reach / (gap[last + 1] - gap[last]), 1.0)
    return float(np.sqrt(squared[last] + part * (squared[last + 1] - squared[last])))


@value
class LineViscoelasticSolution(OfPath[LineViscoelasticState]):
    """The solution of a `LineViscoelasticIndentation`, point by point of its path; all arrays ``(points,)``.

    Parameters
    ----------
    problem : LineViscoelasticIndentation
        The problem that was solved.
    time : ndarray
        [s].
    force_per_length, half_width : ndarray
        P [N/m], a [m], zero without contact.
    crept_load : ndarray
        Hereditary integral of creep function and force per length [m]; it equals w(a) while the strip grows.  For
        layers with separate relaxation functions, the creep function is that of the uppermost layer.
    mean_pressure, peak_pressure : ndarray
        P / (2 a) and the maximum pressure [Pa]; the latter infinite at a sharp tip, kink or rim.
    states : tuple of LineViscoelasticState
        The states themselves, which have pressures and the approach.
    """

    problem: LineViscoelasticIndentation
    time: Array
    force_per_length: Array
    half_width: Array
    crept_load: Array
    mean_pressure: Array
    peak_pressure: Array
    states: tuple[LineViscoelasticState, ...]

    def approach(self, first: Place = None, second: Place = None) -> Array:
        """Return the approach of two points on the axis since the beginning [m], one in each body.

        Parameters
        ----------
        first, second : float, RollerCentre or PlateBase
            Depths of the reference points below the surfaces of half-planes or layers [m], or finite bodies. Not needed
            in a rigid body, and below layers on a rigid base.

        Raises
        ------
        InvalidInput
            If a reference point is missing: the approach of a line contact depends on the reference points.
        OutsideValidity
            If the strip is wider than a fifth of a finite body, or bodies or layers relax, and not in proportion.
        """
        bed, states = self.problem.bed, self.states
        borne, sunk = (np.array([getattr(state, name) for state in states]) for name in ("line_load", "recess"))
        strips = states[0].position, borne, sunk
        return approach_of_strips(bed, float(np.max(self.half_width)), strips, (first, second))

    def work_per_length(self, first: Place = None, second: Place = None) -> Array:
        """Return the work since the beginning, per length [J/m]: the integral of P over the approach.

        Force and approach are assumed linear between the points of the path; the error is of second order in the step.
        Over a closed cycle it is the energy dissipated in the material between the two points.

        Parameters
        ----------
        first, second : float, RollerCentre or PlateBase
            As in `approach`, with the same errors. The dissipated energy depends on the amount of material between the
            points.
        """
        nearer, force = self.approach(first, second), self.force_per_length
        steps = np.diff(nearer, prepend=0.0) * 0.5 * (force + np.append(0.0, force[:-1]))
        return np.asarray(np.cumsum(steps))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, size of the body, times of the solid."""
        notes = relaxing_line_notes(self.problem.bed, self.time, float(np.max(self.half_width)))
        return (*notes, *cells_notes(self))
