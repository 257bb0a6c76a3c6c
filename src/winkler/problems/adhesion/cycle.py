r"""Approach and retraction of an adhesive contact: snap-in, pull-off, every jump between, and the energy they cost.

The machine moves slowly.  The edge of the contact advances or recedes while Griffith's balance lets it, rests between
closing and opening, and where it loses its hold it runs on to the next radius that holds it.  Between jumps

.. math:: \mathrm dW = F\,\mathrm dD = \mathrm d\bigl(U - w_\mathrm{c}\pi a^2 + \tfrac12 F^2/k_\mathrm{m}\bigr)
          + (w_\mathrm{o}-w_\mathrm{c})\,2\pi a\,(-\mathrm da)_{\text{receding}} ,

in a jump the total potential falls at a constant position D (or force), and what it falls by is lost.  The result
depends on the turning points of the path alone, not on how many points lie between them.

What moves the edge of a contact whose attraction has a range, when the machine is in control.

One curve of equilibrium leads from apart through the approach, in which the surfaces attract each other without
touching, into the contact; a machine whose far end stands at :math:`D = d + F/k_\mathrm{m}` follows it where D rises
and jumps where it turns.  Before touch, Maugis' constant stress :math:`\sigma_0` pulls over a disc of the radius c,

.. math:: d = f(c) - \frac{4\sigma_0c}{\pi E^*} - \frac{w}{\sigma_0}, \qquad F = -\pi\sigma_0c^2 ,

and DMT's pull comes up at first touch.  Along the curve the stored energy, surfaces included, grows by F dd.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import AdhesionLaw, DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.turning import Leap, Slopes
from winkler.numerics.panels.chebyshev import fit_panels, stationary
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, Curve
from winkler.problems.adhesion.cycle_states import AdhesiveJump, AdhesiveState, EdgeState
from winkler.problems.adhesion.edge import AdhesiveEdge, DeadLoad, LoadingMachine, adhesive_edge, last_radius
from winkler.problems.adhesion.edge_states import EdgeStates, force_of, force_under, stored_energy
from winkler.problems.adhesion.expected_radius import expected_radius
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.layered_states import DiscOnLayers, LayeredStates
from winkler.problems.adhesion.maugis import CohesiveStates
from winkler.problems.adhesion.stability import branches
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ADHESIVE, BALANCED
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.solve_contact import end_of
from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

JUMP_ROUNDING = 1e-10
"""Part of the energies that meet in a jump by which their difference may come out negative."""


MACHINE_STIFFNESS_RANGE = POSITIVE_OR_INFINITE._replace(
    demand="it must be positive{unit}, infinite for fixed grips; for a dead load give the path as Force([...])"
)


@value
class AdhesiveCycle:
    """Quasi-static approach and retraction of an adhesive contact along a path.

    The bodies are apart at the beginning and first approach up to the first point of the path.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : ShortRange, Dugdale or DerjaguinMullerToporov
        ShortRange(work), or with hysteresis ShortRange(work_closing=..., work_opening=...), on elastic media. Dugdale
        is supported on homogeneous half-spaces and on layers. Under laws with a finite range the bodies attract each
        other before contact.
    path : Depth or Force
        Positions of the drive of the machine [m], or dead loads [N], in sequence, ``(steps,)``.  A dead load below the
        pull-off force ends the path, because no equilibrium exists.
    machine_stiffness : float, optional
        Stiffness k_m [N/m] between drive and contact, such as that of a cantilever; infinite for fixed grips.

    Raises
    ------
    InvalidInput
        If the path is not a one-dimensional array, the law is not a law of adhesion, or a machine stiffness is given
        with dead loads.

    References
    ----------
    K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313, doi:10.1098/rspa.1971.0141;
    P. R. Guduru, J. Mech. Phys. Solids 55 (2007) 445-472, doi:10.1016/j.jmps.2006.09.007

    Examples
    --------
    In units of (w^5 R^4 / E*^2)^(1/3) a ball that is pressed on under fixed grips and pulled off loses 7.0922.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    >>> cycle = AdhesiveCycle(bed, ShortRange(1e-3), Depth([0.1, -0.1])).solve()
    >>> round(float(cycle.dissipation[-1]) / 1e-5, 6), [jump.snap_in for jump in cycle.jumps]
    (7.092196, [True, False])
    """

    bed: Bed
    law: AdhesionLaw
    path: Depth | Force
    machine_stiffness: Annotated[float, MACHINE_STIFFNESS_RANGE] = math.inf

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "johnson_kendall_roberts_1971", "guduru_2007")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | BALANCED
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def __post_init__(self) -> None:
        shape = numbers_of(self.path).shape
        if len(shape) != 1:
            raise InvalidInput(
                f"AdhesiveCycle: the path has the shape {shape}; give its points one after the other in one row."
            )
        if isinstance(self.path, Force) and math.isfinite(self.machine_stiffness):
            raise InvalidInput(
                f"AdhesiveCycle: under prescribed forces the machine's stiffness ({self.machine_stiffness:g} N/m) "
                "plays no part; leave it out, or prescribe positions as Depth([...])."
            )

    @property
    def _control(self) -> LoadingMachine | DeadLoad:
        return LoadingMachine(1.0 / self.machine_stiffness) if isinstance(self.path, Depth) else DeadLoad()

    @property
    def _edge(self) -> AdhesiveEdge | RangedEdge:
        """The curves that the edge obeys along this path."""
        highest = float(np.max(numbers_of(self.path)))
        if isinstance(self.law, ShortRange):
            return adhesive_edge(self.bed, self.law, self._control, highest)
        return ranged_edge(self.bed, self.law, self._control, highest)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return int(numbers_of(self.path).size)

    def steps(self) -> Iterator[AdhesiveState[float]]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If the contact grows beyond the known range of the profile, a dead load pulls it off, or it is not a disc.
            The error is raised at that step, after all earlier states.
        NotConverged
            If the profile is too rough.
        """
        edge, levels = self._edge, numbers_of(self.path)
        place, lost, wasted = edge.apart(), 0.0, 0.0
        for run, rising in _runs(levels):
            targets = levels[run.start : run.stop]
            places, leaps = (edge.closing.rise if rising else edge.opening.fall)(place, targets)
            depths, forces, radii = edge.state(places, targets)
            for i, index in enumerate(run):
                _refuse(edge, index, levels[index], places[i])
                here = [leap for leap in leaps if leap.aim == i]
                jumps = tuple(_jump(edge, leap) for leap in here)
                if not rising:
                    spent = edge.hysteresis(place, places[i])
                    crept = spent - sum(edge.hysteresis(leap.start, leap.end) for leap in here)
                    wasted, lost = wasted + spent, lost + max(crept, 0.0)
                lost += sum(jump.loss for jump in jumps)
                place = float(places[i])
                position = levels[index] if isinstance(edge.control, LoadingMachine) else depths[i]
                yield AdhesiveState(position, depths[i], forces[i], radii[i], lost, wasted, jumps)

    def gathered(self, states: Iterable[AdhesiveState[float]]) -> AdhesiveCycleSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        every = list(states)
        jumps = tuple(jump for state in every for jump in state.jumps)
        return gather(AdhesiveCycleSolution, self, every, jumps=jumps)

    def solve(self) -> AdhesiveCycleSolution:
        """Return the whole path.

        Returns
        -------
        AdhesiveCycleSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class AdhesiveCycleSolution(AdhesiveState[Array], Looped):
    """The solution of an `AdhesiveCycle`, point by point; its numbers are those of `AdhesiveState`.

    Parameters
    ----------
    problem : AdhesiveCycle
        The problem that was solved.
    """

    __words__ = words(
        work=("W", "J", "what the machine has spent since the beginning"),
        energy=("U", "J", "energy of bodies, machine and surfaces"),
    )

    problem: AdhesiveCycle

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((numbers_of(self.problem.path),), self.position, self.force, self.dissipation)

    @property
    def energy(self) -> Array:
        """Energy of bodies, machine and surfaces, minus that gained on closing [J], ``(steps,)``."""
        inner = self.problem._edge.energy(self.depth, self.force, self.radius)
        return np.asarray(inner + 0.5 * self.force**2 / self.problem.machine_stiffness)

    @property
    def work(self) -> Array:
        """Work of the machine or the dead load since the beginning: the integral of F dD [J], ``(steps,)``.

        Over a path that begins and ends without contact it is the work of the cycle, equal to the dissipated energy.
        """
        return np.asarray(self.energy + self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted; notes that depend on the contact are for the widest contact."""
        problem = self.problem
        return (
            *adhesive_notes(problem.bed, problem.law, self.depth, self.radius),
            Note(
                Assumption.EQUILIBRIUM,
                Standing.EXACT,
                f"The edge moves slowly except in {len(self.jumps)} jumps. In a jump the whole released energy is "
                "dissipated (vibrations, sound): the edge stops at the next stable radius.",
                "Griffith's balance at every limit of stability",
            ),
            *self._cycle_notes,
        )


def _runs(levels: Array) -> Iterator[tuple[range, bool]]:
    """Yield the stretches over which the levels rise or fall, beginning with a rise; equal levels go on as before."""
    start, rising = 0, True
    for index in range(1, len(levels)):
        reversed_ = levels[index] < levels[index - 1] if rising else levels[index] > levels[index - 1]
        if reversed_:
            yield range(start, index), rising
            start, rising = index, not rising
    yield range(start, len(levels)), rising


def _jump(edge: AdhesiveEdge | RangedEdge, leap: Leap) -> AdhesiveJump:
    level = np.full(2, leap.level)
    depth, force, radius = edge.state(np.array([leap.start, leap.end]), level)
    inner, outer = edge.energy(depth, force, radius), edge.control.energy(depth, force)
    loss = float(inner[0] - inner[1] + outer[0] - outer[1])
    size = float(np.max(np.abs(inner)) + np.max(np.abs(outer)))
    if loss < -JUMP_ROUNDING * size:
        raise OutsideValidity(
            f"At a depth of {depth[0]:.6g} m the edge would have to run from {radius[0]:.6g} m to {radius[1]:.6g} "
            f"m, though that costs {-loss:.3g} J. A ring of the body touches there first, and the contact is not "
            "a disc: give a flatter wave, a softer body or more work of adhesion."
        )
    position = level if isinstance(edge.control, LoadingMachine) else depth
    before, after = (EdgeState(position[i], depth[i], force[i], radius[i]) for i in range(2))
    return AdhesiveJump(before, after, max(loss, 0.0))


def _refuse(edge: AdhesiveEdge | RangedEdge, index: int, level: float, place: float) -> None:
    if place >= edge.closing.places[-1] and edge.bed.reach < edge.bed.rim:
        raise OutsideValidity(
            f"At index {index} of the path ({level:.6g}) the contact grows beyond the reach of the profile "
            f"({edge.bed.reach:.6g} m), where its shape is not known; reverse earlier or describe more of the "
            "body."
        )
    if isinstance(edge.control, DeadLoad) and level < 0.0 and place == edge.apart():
        raise OutsideValidity(
            f"At index {index} of the path the dead load of {level:.6g} N pulls the bodies apart. The lowest "
            f"force in equilibrium is {np.min(edge.opening.levels):.6g} N: stay above it once pressed on, or "
            "prescribe positions as Depth([...])."
        )


PANEL_TOLERANCE = 1e-12


class SuddenPull(NamedTuple):
    """DMT: at first touch the whole pull comes up at once.  The approach goes from -extent to touch, at 0."""

    pull: float

    def extent(self) -> float:
        """Length of the approach, in a coordinate of its own."""
        return 1.0

    def depth(self, place: Array) -> Array:
        """Zero."""
        return np.zeros(np.shape(place))

    def force(self, place: Array) -> Array:
        """From nothing to -pull [N]."""
        return -self.pull * (1.0 + np.asarray(place))

    def energy(self, force: Array) -> Array:
        """Nothing: the bodies do not move while it comes up."""
        return np.zeros(np.shape(force))


class DiscOfStress(NamedTuple):
    """Maugis: the constant stress over a disc, as long as the middle does not touch."""

    bed: Bed
    law: Dugdale
    modulus: float
    touch: float

    def extent(self) -> float:
        """The radius of the disc when its middle touches [m]."""
        return self.touch

    def _sink(self) -> float:
        """Return by how much the rim of the disc rises per radius [-]."""
        return 4.0 * self.law.strength / (math.pi * self.modulus)

    def depth(self, place: Array) -> Array:
        """d [m]."""
        c = np.maximum(np.asarray(place) + self.touch, 0.0)
        return np.asarray(self.bed.height(c) - self._sink() * c - self.law.range)

    def force(self, place: Array) -> Array:
        """F [N]."""
        return -math.pi * self.law.strength * (np.asarray(place) + self.touch) ** 2

    def energy(self, force: Array) -> Array:
        """The integral of F dd [J], by parts: F d - Int d dF, Int f c dc by quadrature."""
        c = np.sqrt(np.maximum(-np.asarray(force), 0.0) / (math.pi * self.law.strength))
        edges = [b for b, _ in self.bed.kinks]
        moment = abel.integral(lambda r: self.bed.height(r) * r, edges, c)
        raised = 2.0 * moment - self.bed.height(c) * c * c + self._sink() * c**3 / 3.0
        return np.asarray(math.pi * self.law.strength * raised)


class RangedEdge(NamedTuple):
    """The curve of equilibrium, cut at its turning points; places below zero are those of the approach.

    Parameters
    ----------
    bed : Bed
    states : EdgeStates
        Of the contact.
    approach : SuddenPull, DiscOfStress or DiscOnLayers
    control : LoadingMachine or DeadLoad
    closing, opening : Slopes
        What must be prescribed, over the places: the same for an edge that advances and one that recedes.
    """

    bed: Bed
    states: EdgeStates
    approach: SuddenPull | DiscOfStress | DiscOnLayers
    control: LoadingMachine | DeadLoad
    closing: Slopes
    opening: Slopes

    def apart(self) -> float:
        """Return the place of bodies that do not attract each other."""
        return -self.approach.extent()

    def state(self, place: Array, level: Array) -> tuple[Array, Array, Array]:
        """Return d [m], F [N] and a [m] at places and what is prescribed."""
        radius = np.maximum(place, 0.0)
        depth = self.control.depth(self.bed.stiffness(radius), self.states.load(radius), level)
        force = force_under(self.states, depth, radius)
        touching = place > 0.0
        nowhere = place <= self.apart()
        before = np.minimum(place, 0.0)
        depth = np.where(touching, depth, self.approach.depth(before))
        force = np.where(touching, force, self.approach.force(before))
        first_attracted = float(self.approach.depth(np.array([self.apart()]))[0])
        free = level if isinstance(self.control, LoadingMachine) else np.full(np.shape(level), first_attracted)
        return np.where(nowhere, free, depth), np.where(nowhere, 0.0, force), radius

    def energy(self, depth: Array, force: Array, radius: Array) -> Array:
        """Return the energy of bodies and surfaces [J]; zero apart."""
        whole = _stored(self.states, radius)
        # an edge that a rim holds moves on along a straight line
        held = 0.5 * (force + force_of(self.states, radius)) * (depth - self.states.depth(radius))
        return np.where(radius > 0.0, whole + held, self.approach.energy(force))

    def hysteresis(self, start: float, end: float) -> float:
        """Return nothing: closing and opening cost the same [J]."""
        return 0.0


def ranged_edge(
    bed: Bed, law: Dugdale | DerjaguinMullerToporov, control: LoadingMachine | DeadLoad, highest: float
) -> RangedEdge:
    """Return the curve that the edge obeys, up to where `highest` is prescribed.

    Raises
    ------
    OutsideValidity
        If the law does not hold for the bed, or nothing is known of the approach.
    """
    states = states_of(bed, law)
    approach = _approach(bed, law, states)

    def level(place: Array) -> Array:
        radius, before = np.maximum(place, 0.0), np.minimum(place, 0.0)
        closed = control.level(states.depth(radius), force_of(states, radius))
        return np.asarray(np.where(place > 0.0, closed, control.level(approach.depth(before), approach.force(before))))

    high = last_radius(level, max(highest, 0.0), expected_radius(states), end_of(bed))
    limits = [limit for branch in branches(states, control.stiffness, high) for limit in branch]
    places = np.unique([*_turns(level, bed, approach.extent()), 0.0, *limits, high])
    curve = Slopes(level, places, level(places))
    return RangedEdge(bed, states, approach, control, curve, curve)


def _approach(
    bed: Bed, law: Dugdale | DerjaguinMullerToporov, states: EdgeStates
) -> SuddenPull | DiscOfStress | DiscOnLayers:
    if isinstance(law, DerjaguinMullerToporov):
        return SuddenPull(-float(force_of(states, np.zeros(1))[0]))
    if isinstance(states, LayeredStates) and bed.rising:
        return DiscOnLayers(states, states.touch())
    if not isinstance(bed.medium, HomogeneousMedium) or not bed.rising:
        raise OutsideValidity(
            "AdhesiveCycle: how bodies attract each other before they touch is known for Dugdale's law on homogeneous "
            "half-spaces and on layers, and for profiles that rise up to their end; use ShortRange(work), or "
            "Equilibrium and PullOff, which begin at touch."
        )
    modulus = bed.medium.modulus
    # at touch the middle of the disc has risen by 2 sigma c / E*
    length = float(-states.depth(np.zeros(1))[0]) * modulus / (2.0 * law.strength)
    return DiscOfStress(bed, law, modulus, length)


def _stored(states: EdgeStates, radius: Array) -> Array:
    """Return what bodies and surfaces store in equilibrium [J]: the integral of F dd from apart on."""
    if isinstance(states, CohesiveStates | LayeredStates):
        return states.energy(radius)
    depth = states.depth(radius)
    pull = force_of(states, np.zeros(1))
    return np.asarray(stored_energy(states.bed, depth, radius) + pull * depth)


def _turns(level: Curve, bed: Bed, length: float) -> list[float]:
    """Return where the approach begins and turns."""
    edges = np.unique([-length, *(b - length for b, _ in bed.kinks if 0.0 < b < length), 0.0])
    size = float(np.max(np.abs(level(edges))))
    panels = fit_panels(lambda p: level(p.ravel()).reshape(p.shape), edges, PANEL_TOLERANCE * size)
    return [-length, *stationary(panels).tolist(), *edges[1:-1].tolist()]
