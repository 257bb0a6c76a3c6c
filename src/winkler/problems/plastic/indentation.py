r"""A round body pressed into metal, or metal into it: loaded, let go, and loaded again.

Beyond the greatest load so far the bodies yield along their curve of first loading
(`winkler.problems.plastic.first_loading`).  Below it they are elastic, on the dent that this load has left
(`winkler.problems.plastic.dent`): the old load brings back the old depth, and from there the curve goes on.  So a state
depends on the greatest load so far and the load now alone, and no step is too long.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.footprint import EllipticOutline
from winkler.foundation.foundation import Foundation
from winkler.foundation.on_medium import UnderProfile
from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.materials.hardening import Hardening
from winkler.numerics.types import Array, PerLoad, Q
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, PRESSED
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.normal.validity import contact_notes, shape_notes
from winkler.problems.plastic.first_loading import FirstLoading, first_loading, refuse_unknown, stored_energy
from winkler.problems.plastic.release import Release
from winkler.problems.plastic.yielded_response import round_part
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, chapter 6, doi:10.1017/CBO9781139171731"
LAW = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "Plastic deformation follows tables fitted to finite elements (small strains, no hardening, no friction). In "
    "their range the error of force and radius is about 2 %. The error of the residual depth is 0.01 of the "
    "maximum depth, or 0.015 if both bodies yield. Reverse yielding on unloading is neglected. Up to a tenth of the "
    "dissipated energy may remain in the bodies as residual stress.",
    "finite elements of this package; " + JOHNSON,
    0.02,
)
HARDENED = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "A body hardens: its strength is the flow stress at a representative strain. Compared with finite elements of "
    "balls and cones that were not used in the fit, the force differs by at most 2.5 % (balls). The residual "
    "depth differs by at most 0.015 of the depth for balls and 0.02 for cones.",
    "finite elements of this package; D. Tabor, The Hardness of Metals, Oxford University Press 1951",
    0.025,
)
BETWEEN = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "The contact edge lies where the profile is neither a paraboloid nor a cone. The tables of both are "
    "interpolated with the local exponent of the profile. No finite elements have tested this.",
    "finite elements of this package, of paraboloids and cones only",
)
FULLY_PLASTIC = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "The load exceeds the range of the finite elements. The range ends at a/R = 45 Y/E* for balls and at a slope "
    "of 20 Y/E* for cones. Beyond it the mean pressure is continued to three times the strength. For cones the "
    "force at a given depth differed by 6 % at a slope of 35 Y/E*, and by 18 % at 136 Y/E*.",
    "S. Dj. Mesarovic, N. A. Fleck, Proc. R. Soc. Lond. A 455 (1999) 2707-2728, doi:10.1098/rspa.1999.0423; finite "
    "elements of L. Lu and others, Proc. Natl. Acad. Sci. 117 (2020) 7052-7062, doi:10.1073/pnas.1922210117",
    0.18,
)
SLENDEREST = 21.0
"""Greatest ratio of the semi-axes of an ellipse of which there are finite elements."""
LARGE_FROM = 0.05
"""Contact radius over that of the body from which a note states what the shape of the bodies costs."""
LARGE_ERROR = 0.4
"""Of 1 - cos(pi a/R), the part of the force by which a flattened ball bears less: Jackson and Green have 0.92/2.84."""
BLUNT_SHARES = 0.02, 0.98
"""Parts of a paraboloid between which a profile counts as neither one nor a cone."""
LEAST_EXPONENT, GREATEST_EXPONENT = 0.9, 2.3
"""Local exponents of a profile for which the tables of a cone and of a paraboloid are taken."""


@value
class PlasticIndentation:
    """A round body pressed against another one; at least one body yields.

    Parameters
    ----------
    bed : Foundation or EllipticFoundation
        A profile without a flat end over a `HalfSpace`; at least one body has a strength. Within the contact the
        profile may not be much blunter than a paraboloid or sharper than a cone.  Or bodies with two curvatures each
        over one.  Or over a `CoatedHalfSpace`, a `SlidingFilm` or a `StackedHalfSpace` whose layers or bodies have
        strengths: up to the load at which one of them yields.
    path : Depth or Force
        Depths [m] or loads [N], in sequence, ``(steps,)``.

    Raises
    ------
    InvalidInput
        If no body has a strength, a strength is above a fiftieth of Young's modulus, the medium is another one, the
        profile has a flat end, or the path is not a one-dimensional array.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, chapter 6, doi:10.1017/CBO9781139171731

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=210e9, poisson=0.3, strength=1e9)
    >>> bed = Foundation(Paraboloid(5e-3), HalfSpace(steel))
    >>> pressed = PlasticIndentation(bed, Force([2000.0, 0.0])).solve()
    >>> bool(pressed.residual_depth[0] > 0.0), bool(pressed.depth[1] == pressed.residual_depth[1])
    (True, True)
    """

    bed: Bed
    path: Depth | Force

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | BALANCED
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        owner = type(self).__name__
        levels = numbers_of(self.path)
        if levels.ndim != 1:
            raise InvalidInput(
                f"{owner}: the path has the shape {levels.shape}; give its points one after the other in one row."
            )
        refuse_unknown(owner, self.bed, layers=True)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return int(numbers_of(self.path).size)

    @property
    def _loading(self) -> FirstLoading:
        """The curve of first loading."""
        assert isinstance(self.bed, UnderProfile)
        return first_loading(self.bed)

    @property
    def yield_depth(self) -> float:
        """Depth at the onset of yield [m]; zero for a sharp tip, infinite without yield."""
        return self._loading.at_onset(by_force=False)

    @property
    def yield_force(self) -> float:
        """Force at the onset of yield [N]; zero for a sharp tip, infinite without yield."""
        return self._loading.at_onset(by_force=True)

    def steps(self) -> Iterator[PlasticState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If a load is tensile, exceeds the reach of the profile, or leads to a part much blunter than a paraboloid
            or sharper than a cone. If a layered body yields.
        """
        table = _states(self)
        for row in zip(*table, strict=True):
            yield PlasticState(*(float(number) for number in row))

    def gathered(self, states: Iterable[PlasticState]) -> PlasticSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(PlasticSolution, self, states)

    def solve(self) -> PlasticSolution:
        """Return the whole path.

        Returns
        -------
        PlasticSolution

        Raises
        ------
        OutsideValidity
            As `steps`.
        """
        made: Any = PlasticSolution
        solution: PlasticSolution = made(*_states(self), self)
        return solution


def _states(problem: PlasticIndentation) -> tuple[Array, ...]:
    """Return the numbers of `PlasticPress` along a path, each ``(steps,)``."""
    levels, by_force = numbers_of(problem.path), isinstance(problem.path, Force)
    if by_force and np.any(levels < 0.0):
        where = int(np.flatnonzero(levels < 0.0)[0])
        raise OutsideValidity(
            f"At index {where} of the path the force of {levels[where]:.6g} N is tensile; without adhesion bodies can "
            "only be pressed together: give a force of zero or more."
        )
    curve = problem._loading
    greatest, group = np.unique(np.maximum.accumulate(np.maximum(levels, 0.0)), return_inverse=True)
    state, spent = curve.at_level(greatest, by_force=by_force)
    if not curve.where:
        refuse_other_shapes("PlasticIndentation", problem.bed, state.radius)
    left, stored = state.depth - state.recovery, curve.stored(state)
    edge = curve.edge(state.radius) - state.depth
    depth, force, radius, energy = (part[group] for part in (state.depth, state.force, state.radius, stored))
    yielded, again = state.radius > curve.onset, levels < greatest[group]
    for dented in (False, True):
        here = np.flatnonzero(again & (yielded[group] == dented))
        if not here.size:
            continue
        index, now = group[here], levels[here] if by_force else levels[here] - left[group[here]]
        if dented:
            release = Release(curve.bed, state)
            d, a = release.at(now, index, by_force=by_force)
            borne, given = release.force(d, a, index), release.energy(d, a, index)
        else:
            d, a = (at_force if by_force else at_depth)(curve.bed, now)
            borne = np.where(a > 0.0, curve.bed.stiffness(a) * d - curve.bed.gap_load(a), 0.0)
            given = stored_energy(curve.bed, d, a)
        depth[here] = d + left[index] if by_force else levels[here]
        force[here], radius[here], energy[here] = levels[here] if by_force else borne, a, given
    lost = np.where(yielded, np.maximum(spent - stored, 0.0), 0.0)
    edge = np.where(state.radius > 0.0, edge, 0.0)
    area = curve.bed.footprint.area(radius)
    return depth, force, radius, area, left[group], state.radius[group], edge[group], energy, lost[group]


def refuse_other_shapes(owner: str, bed: Bed, radius: Array) -> None:
    """Refuse contacts that end where the profile is much blunter than a paraboloid or sharper than a cone."""
    touching = radius[radius > 0.0]
    exponent = touching * bed.gap_slope(touching) / bed.gap(touching)
    bad = (exponent < LEAST_EXPONENT) | (exponent > GREATEST_EXPONENT)
    if np.any(bad):
        where = int(np.flatnonzero(bad)[0])
        raise OutsideValidity(
            f"{owner}: at a contact radius of {touching[where]:.4g} m the equivalent profile grows like the "
            f"power {exponent[where]:.3g} of the radius; yielding is known of cones, power 1, to paraboloids, power 2: "
            "give such a profile, or a load at which the contact does not end there."
        )


def _large(wide: float) -> Note:
    """Return the note on a contact radius over that of a ball [-] at which its shape counts."""
    error = LARGE_ERROR * (1.0 - math.cos(math.pi * min(wide, 1.0)))
    return Note(
        Assumption.SMALL_SLOPES,
        Standing.APPROXIMATE if error < 0.3 else Standing.OUTSIDE,
        f"The contact radius is {wide:.2g} times the radius of the ball, and the tables assume small slopes. At "
        f"this contact radius a flattened ball carries up to {100.0 * error:.2g} % less, and a dented plane more. "
        "At 0.2 times the radius of the ball the restitution is 2 to 4 % lower.",
        "finite elements of this package with large displacements; R. L. Jackson, I. Green, J. Tribol. 127 (2005) "
        "343-354, doi:10.1115/1.1866166",
        error,
    )


@value
class PlasticPress(PerLoad[Q]):
    """A contact that has yielded, at a moment, or at the points of its path.

    Parameters
    ----------
    depth, force, radius : float or ndarray, (steps,)
        d [m] since first touch, F_N [N], compression positive, and a [m], zero without contact; of an ellipse that of
        the disc as stiff as Hertz' ellipse of this area.
    area : float or ndarray, (steps,)
        Of the contact [m^2].
    residual_depth : float or ndarray, (steps,)
        d0 [m], at which the unloaded bodies would just touch.
    largest_radius : float or ndarray, (steps,)
        Of the contact under the greatest load so far [m]: the radius of the dent.
    edge_height : float or ndarray, (steps,)
        Of the edge of the contact above the original surfaces under the greatest load so far [m], of both bodies
        together: positive where they pile up, negative where they sink in; the mean around an ellipse.
    energy, dissipation : float or ndarray, (steps,)
        What unloading would give back, and what it would not [J]; a part of the latter stays as residual stress.
    """

    __words__ = words(
        energy=("U", "J", "energy that unloading would give back"),
        edge_height=(
            "h_e",
            "m",
            "height of the edge over the original surfaces, under the greatest load so far",
        ),
        work=("W", "J", "what was spent since the beginning"),
    )

    depth: Q
    force: Q
    radius: Q
    area: Q
    residual_depth: Q
    largest_radius: Q
    edge_height: Q
    energy: Q
    dissipation: Q

    @property
    def mean_pressure(self) -> Q:
        """Force over area [Pa]; zero without contact."""
        area = np.asarray(self.area)
        mean = np.where(area > 0.0, self.force / np.where(area > 0.0, area, 1.0), 0.0)
        return mean if mean.ndim else float(mean)  # type: ignore[return-value]

    @property
    def work(self) -> Q:
        """What was spent since the beginning, the integral of the force over the depth [J]."""
        return self.energy + self.dissipation  # type: ignore[return-value,operator]


@value
class PlasticState(PlasticPress[float]):
    """A contact that yields at one point of its path; its numbers are those of `PlasticPress`."""


@value
class PlasticSolution(PlasticPress[Array], Looped):
    """The solution of a `PlasticIndentation`, point by point; its numbers are those of `PlasticPress`.

    Parameters
    ----------
    problem : PlasticIndentation
        The problem that was solved.
    """

    __words__ = words(dented=("", None, "bed on which the contact is elastic after the path"))

    problem: PlasticIndentation

    @property
    def yield_depth(self) -> float:
        """Yield depth, as in the problem [m]."""
        return self.problem.yield_depth

    @property
    def yield_force(self) -> float:
        """As in the problem [N]."""
        return self.problem.yield_force

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((numbers_of(self.problem.path),), self.depth, self.force, self.dissipation)

    @property
    def dented(self) -> Foundation:
        """The elastic foundation after the path, valid up to the maximum load so far.

        Its depths are counted from `residual_depth`.
        """
        curve = self.problem._loading
        by_force = isinstance(self.problem.path, Force)
        greatest = np.array([max(float(np.max(numbers_of(self.problem.path), initial=0.0)), 0.0)])
        state, _ = curve.at_level(greatest, by_force=by_force)
        return curve.springs("PlasticSolution", state, 0)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        widest = float(np.max(self.largest_radius, initial=0.0))
        return (*law_notes(self.problem._loading, widest), *self._cycle_notes)


def _layers_note(loading: FirstLoading) -> Note:
    """Return up to which load layers are followed."""
    return Note(
        Assumption.RESPONSE,
        Standing.ASYMPTOTIC,
        f"The layers are elastic up to {loading.at_onset(by_force=True):.4g} N. At this load {loading.where}. Up "
        "to this load no dent remains; greater loads are not supported.",
        "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582",
    )


def _ellipse_note(outline: EllipticOutline) -> Note:
    """Return what the tables of a ball mean for an ellipse."""
    ratio = max(outline.slenderness, 1.0 / outline.slenderness)
    return Note(
        Assumption.SHAPE,
        Standing.APPROXIMATE if ratio <= SLENDEREST else Standing.OUTSIDE,
        "The tables are those of balls, scaled to the yield onset of the ellipse (b/a = "
        f"{outline.slenderness:.4g}). Compared with finite elements up to b/a = {SLENDEREST:g} and 27 times the "
        "force of first yield, the depth differs by at most 2 %, the area by 4 %, the residual depth by 0.03 of "
        "the depth.",
        "finite elements of this package",
        0.04,
    )


def law_notes(loading: FirstLoading, widest: float) -> tuple[Note, ...]:
    """Return how far the law can be trusted up to a contact radius [m]."""
    bed, yields = loading.bed, widest > loading.onset
    if loading.where:
        at = np.array([widest])
        return (*bed.notes, *contact_notes(bed, bed.gap(at), at), _layers_note(loading))
    notes = [note for note in bed.notes if not (yields and note.assumption is Assumption.RESPONSE)]
    if widest > 0.0:
        notes += shape_notes(bed, widest)
    if yields:
        notes.append(LAW)
        if isinstance(outline := bed.footprint, EllipticOutline):
            notes.append(_ellipse_note(outline))
        if any(isinstance(body.solid, Hardening) for body in (loading.first, loading.second)):
            notes.append(HARDENED)
        least, most = BLUNT_SHARES
        ball = float(round_part(loading.exponent(np.array([widest])))[0])
        if least < ball < most:
            notes.append(BETWEEN)
        if ball > least and (wide := float(abs(bed.slope(np.array([widest]))[0]))) > LARGE_FROM:
            notes.append(_large(wide))
        if loading.beyond_tables(widest):
            notes.append(FULLY_PLASTIC)
    return tuple(notes)
