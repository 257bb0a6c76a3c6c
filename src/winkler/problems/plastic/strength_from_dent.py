"""The strength of a metal from dents that known loads have left in it, or from how bodies rebound from it."""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.materials.hardening import Hardening
from winkler.media.halfspace import HalfSpace
from winkler.numerics.equations.roots import between
from winkler.numerics.types import Array, PerLoad, Q
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.plastic.first_loading import LEAST_STIFFNESS, first_loading, refuse_unknown
from winkler.problems.plastic.impact import PlasticImpact
from winkler.problems.plastic.indentation import PlasticIndentation, PlasticSolution, refuse_other_shapes
from winkler.problems.plastic.yielded_response import round_part
from winkler.values.checks.number_checks import POSITIVE_QUANTITY, NonNegative, PositiveNotTiny
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

STEP = 1e-4
"""Relative change of load and strength over which the dent is differentiated."""
NEXT_STRENGTH = 0.5
LEAST_STRENGTH = 1e-9
"""Part of Young's modulus below which no strength is sought."""
RADIUS_ERROR, DEPTH_ERROR, PAIR_ERROR, CONE_ERROR = 0.02, 0.01, 0.03, 0.02
"""What the law errs by: parts of the radius; of the depth, by which the residual depth errs, of one body and of two;
the restitution errs by as much as the latter, of a cone by the last."""
MOST_STEPS, LONGEST_STEP, SETTLED = 40, 0.5, 1e-10
"""Steps to the least squares of several loads, the longest and the last of them in the logarithm of the strength."""
LEAST_DEVIATION = 1e-6
"""Of the greatest standard deviation of several loads."""
HARDENS = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "A dent determines one strength. For a metal that hardens it is the flow stress at a strain of about 0.2 a/R "
    "(Tabor), not the initial yield stress.",
    "D. Tabor, The Hardness of Metals, Oxford University Press 1951",
)


@value
class Blow(PerLoad[Q]):
    """A body that strikes a surface in the normal direction with a given velocity.

    Parameters
    ----------
    mass : float
        m [kg] of the body; for two free bodies m1 m2 / (m1 + m2).
    velocity : float or ndarray
        v [m/s] of approach at first touch, positive.
    velocity_error : float, optional
        Its standard deviation [m/s]; zero by default.
    """

    __words__ = words(velocity_error=("u(v)", "m/s", "standard deviation of the velocity"))

    mass: PositiveNotTiny
    velocity: Annotated[Q, POSITIVE_QUANTITY]
    velocity_error: NonNegative = 0.0

    per_load: ClassVar[str] = "velocity"


@value
class Restitution(PerLoad[Q]):
    """A measured coefficient of restitution: rebound velocity over approach velocity.

    Parameters
    ----------
    restitution : float or ndarray
        e [-], positive.
    restitution_error : float, optional
        Its standard deviation [-]; zero by default.
    """

    __words__ = words(restitution_error=("u(e)", "", "standard deviation of the restitution"))

    restitution: Annotated[Q, POSITIVE_QUANTITY]
    restitution_error: NonNegative = 0.0

    per_load: ClassVar[str] = "restitution"


@value
class StrengthFromDent:
    r"""The strength of a metal from dents of known loads, or from rebounds.

    It is the strength at which `PlasticIndentation` leaves this dent, or `PlasticImpact` has this restitution. For one
    measurement it is exact; for several it is a least-squares fit, weighted by their errors. Errors are propagated to
    first order, for one dent of radius r

    .. math:: u^2(\ln Y) = \left(\frac{\partial\ln Y}{\partial\ln F}\frac{u(F)}{F}\right)^2
              + \left(\frac{\partial\ln Y}{\partial\ln r}\frac{u(r)}{r}\right)^2 .

    Parameters
    ----------
    bed : Foundation
        As in `PlasticIndentation`.  The strength of the first body is computed: an `Elastic` without a strength, or a
        solid that hardens.  The second one may be rigid, elastic, or have a strength of its own.
    load : Force or Blow
        The maximum loads [N], or the impacts, each on a new place of the body; one or several.
    dent : Radius, Depth or Restitution
        The residual dent of each load: its radius in the plane of its rim, or its depth [m]. The depth is the
        permanent approach of the bodies, `residual_depth` of a `PlasticIndentation`.  For impacts the restitution [-]
        is also possible.
    force_error, dent_error : float, optional
        Standard deviations of forces [N] and of radii or depths of dents [m]; zero by default.  For impacts and
        restitutions give the deviations in `Blow` and `Restitution`.

    Raises
    ------
    InvalidInput
        As in `PlasticIndentation`. If the first body already has a strength, or loads and dents are not equally many
        positive numbers. If a static force is combined with a restitution, or an error is given without its quantity.

    References
    ----------
    D. Tabor, The Hardness of Metals, Oxford University Press 1951 (the radius of a dent is that of the contact which
    has made it, for its rim hardly moves while it is released); K. L. Johnson, Contact Mechanics, Cambridge University
    Press 1985, chapter 6 and section 11.5, doi:10.1017/CBO9781139171731

    Examples
    --------
    >>> from winkler.materials.elastic import RIGID
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=210e9, poisson=0.3)
    >>> ball = Foundation(Paraboloid(5e-3), HalfSpace(steel, RIGID))
    >>> found = StrengthFromDent(ball, Force(1000.0), Radius(0.36e-3), dent_error=5e-6).solve()
    >>> bool(0.9e9 < found.strength < 1.1e9), bool(found.strength_error < 0.05 * found.strength)
    (True, True)
    >>> blows, seen = Blow(4.1e-3, [0.5, 2.0]), Restitution([0.80, 0.66], restitution_error=0.01)
    >>> bool(0.9e9 < StrengthFromDent(ball, blows, seen).solve().strength < 1.2e9)
    True
    """

    __words__ = words(
        load=("", None, "maximum loads, or impacts"),
        dent=("", None, "radius or depth of the dent that each has left, or its restitution"),
        force_error=("u(F)", "N", "standard deviation of the force"),
        dent_error=("u(r)", "m", "standard deviation of radius or depth of the dent"),
    )

    bed: Bed
    load: Force | Blow
    dent: Radius | Depth | Restitution
    force_error: NonNegative = 0.0
    dent_error: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED
    needs_round: ClassVar[str] = "the radius of a dent"

    def __post_init__(self) -> None:
        owner = type(self).__name__
        loads, sizes = self._loads, self._sizes
        for name, numbers in (("load", loads), ("dent", sizes)):
            if not numbers.size or not np.all(numbers > 0.0):
                raise InvalidInput(f"{owner}: the {name} is {numbers}; give positive numbers.")
        if loads.shape != sizes.shape or loads.ndim > 1:
            raise InvalidInput(
                f"{owner}: the loads have the shape {loads.shape}, what they have left {sizes.shape}; give one dent or "
                "restitution for each load, in one row."
            )
        if isinstance(self.load, Force) and isinstance(self.dent, Restitution):
            raise InvalidInput(f"{owner}: a force has no restitution; give Blow(mass, velocity), or the dent.")
        for error, given, place, whose in (
            ("force_error", isinstance(self.load, Blow), "velocity_error of the Blow", "a blow"),
            ("dent_error", isinstance(self.dent, Restitution), "restitution_error of the Restitution", "a restitution"),
        ):
            if given and getattr(self, error):
                raise InvalidInput(f"{owner}: {error} is that of no {whose.split()[1]}; give the {place}.")
        medium = self.bed.medium if isinstance(self.bed, Foundation) else None
        if isinstance(medium, HalfSpace):
            if not isinstance(medium.first, Elastic):
                raise InvalidInput(
                    f"{owner}: the first body is a {type(medium.first).__name__}; it is the one whose strength is "
                    "sought: give Elastic(young, poisson)."
                )
            if medium.first.strength < math.inf:
                raise InvalidInput(
                    f"{owner}: the first body has a strength, {medium.first.strength:.6g} Pa, which is what is "
                    "sought; leave it out."
                )
            refuse_unknown(owner, self._bed(medium.first.young / LEAST_STIFFNESS))
        else:
            refuse_unknown(owner, self.bed)

    @property
    def _loads(self) -> Array:
        """Forces [N], or velocities [m/s]."""
        return np.asarray(self.load.force if isinstance(self.load, Force) else self.load.velocity, dtype=float)

    @property
    def _sizes(self) -> Array:
        """Radii or depths of the dents [m], or restitutions [-]."""
        match self.dent:
            case Radius(radius=size) | Depth(depth=size) | Restitution(restitution=size):
                return np.asarray(size, dtype=float)

    @property
    def _errors(self) -> tuple[float, float]:
        """Standard deviations of loads and of what they have left."""
        return (
            self.load.velocity_error if isinstance(self.load, Blow) else self.force_error,
            self.dent.restitution_error if isinstance(self.dent, Restitution) else self.dent_error,
        )

    def _bed(self, strength: float) -> Foundation:
        """Return the bed whose first body has a strength [Pa]."""
        bed, medium = self.bed, self.bed.medium
        assert isinstance(bed, Foundation)
        assert isinstance(medium, HalfSpace)
        assert isinstance(medium.first, Elastic)
        if isinstance(medium.first, Hardening):
            first: Elastic = dataclasses.replace(medium.first, strength=strength)
        else:  # also one that takes its numbers from a table of materials
            first = Elastic(medium.first.young, medium.first.poisson, strength)
        return dataclasses.replace(bed, medium=dataclasses.replace(medium, first=first))

    def _left(self, strength: float, loads: Array) -> tuple[Array, Array, Array, Array]:
        """Return what loads `(n,)` leave, and depth, radius [m] and force [N] at their height."""
        bed = self._bed(strength)
        if isinstance(self.load, Blow):
            struck = PlasticImpact(bed, self.load.mass, loads).solve()
            residual, seen = struck.residual_depth, struck.restitution
            depth, radius, force = struck.greatest_depth, struck.largest_radius, struck.greatest_force
        else:
            state, _ = first_loading(bed).at_level(loads, by_force=True)
            refuse_other_shapes(type(self).__name__, bed, state.radius)
            depth, radius, force, residual = state.depth, state.radius, state.force, state.depth - state.recovery
            seen = residual
        return (radius if isinstance(self.dent, Radius) else residual if isinstance(self.dent, Depth) else seen,
                depth, radius, force)  # fmt: skip

    def _softer(self, strength: float) -> float:
        """Return by how much a body of a strength seems softer than measured; two where the loads are out of reach."""
        sizes = np.atleast_1d(self._sizes)
        try:
            seen = self._left(strength, np.atleast_1d(self._loads))[0]
        except OutsideValidity:
            if strength * LEAST_STIFFNESS >= self.bed.medium.first.young:  # type: ignore[attr-defined]
                raise
            return 2.0
        change = 1.0 - seen / sizes if isinstance(self.dent, Restitution) else np.minimum(seen / sizes, 2.0) - 1.0
        return float(np.mean(change))

    def solve(self) -> StrengthFromDentSolution:
        """Return the strength with its standard error.

        Raises
        ------
        OutsideValidity
            If the contact would be as large without yielding, so that the dent determines no strength. If no strength
            leaves so large a dent. As in `PlasticIndentation.steps` and `PlasticImpact.solve`.
        NotConverged
            If the least squares of several loads are not found.
        """
        loads, sizes = np.atleast_1d(self._loads), np.atleast_1d(self._sizes)
        young = self.bed.medium.first.young  # type: ignore[attr-defined]
        high = young / LEAST_STIFFNESS
        rebounds = isinstance(self.dent, Restitution)
        if self._softer(high) >= 0.0:
            what = "restitution" if rebounds else "radius" if isinstance(self.dent, Radius) else "depth"
            least = float(np.max(self._left(high, loads)[0]))
            shown = f"{float(np.max(sizes)):.6g}" + ("" if rebounds else " m")
            raise OutsideValidity(
                f"StrengthFromDent: a first body with a strength of a fiftieth of its Young's modulus, {high:.4g} Pa, "
                + (
                    f"rebounds with {least:.6g} already; a restitution of {shown} determines no strength: give faster "
                    "blows, or check mass, moduli and units."
                    if rebounds
                    else f"has a dent or a contact of {least:.6g} m already under this load; a {what} of {shown} "
                    "determines no strength: give a greater dent, a lesser load, or check moduli and units."
                )
            )
        low = high
        while self._softer(low := NEXT_STRENGTH * low) < 0.0:
            if low < LEAST_STRENGTH * young:
                raise OutsideValidity(
                    f"StrengthFromDent: down to a strength of {low:.4g} Pa no body is as soft as "
                    + ("these restitutions" if rebounds else f"a dent of {float(np.max(sizes)):.6g} m")
                    + " would have it; check loads, dents and units."
                )
        place = between(
            lambda where: self._softer(math.exp(where)), math.log(low), math.log(low / NEXT_STRENGTH), relative=1e-12
        )
        if sizes.size > 1:
            place = self._least_squares(place)
        return self._solution(math.exp(place))

    def _slopes(self, strength: float) -> tuple[Array, Array]:
        """Return the changes of what loads leave by the logarithms of strength and load."""
        loads = np.atleast_1d(self._loads)
        pairs = (
            ((strength * (1.0 + STEP), loads), (strength * (1.0 - STEP), loads)),
            ((strength, loads * (1.0 + STEP)), (strength, loads * (1.0 - STEP))),
        )
        first, second = ((self._left(*more)[0] - self._left(*less)[0]) / (2.0 * STEP) for more, less in pairs)
        return first, second

    def _deviations(self, by_load: Array) -> Array:
        """Return the standard deviations of what is measured less what is predicted; ones if no error is given."""
        of_load, of_dent = self._errors
        total = np.hypot(by_load * of_load / np.atleast_1d(self._loads), of_dent)
        if np.any(total > 0.0):  # a load that depends on nothing tells nothing
            return np.asarray(np.maximum(total, LEAST_DEVIATION * np.max(total)))
        return np.ones_like(total) if isinstance(self.dent, Restitution) else np.atleast_1d(self._sizes)

    def _least_squares(self, place: float) -> float:
        """Return the logarithm of the strength that leaves the least squares, from one near by."""
        loads, sizes = np.atleast_1d(self._loads), np.atleast_1d(self._sizes)
        for _ in range(MOST_STEPS):
            by_strength, by_load = self._slopes(math.exp(place))
            weights = self._deviations(by_load) ** -2
            missed = sizes - self._left(math.exp(place), loads)[0]
            step = float(np.sum(weights * by_strength * missed) / np.sum(weights * by_strength**2))
            place += min(max(step, -LONGEST_STEP), LONGEST_STEP)
            if abs(step) < SETTLED:
                return place
        raise NotConverged(
            f"StrengthFromDent: the strength of {sizes.size} loads has not settled after {MOST_STEPS} steps; check "
            "loads, dents and units, or use fewer."
        )

    def _solution(self, strength: float) -> StrengthFromDentSolution:
        loads, sizes = np.atleast_1d(self._loads), np.atleast_1d(self._sizes)
        by_strength, by_load = self._slopes(strength)
        seen, depth, radius, force = self._left(strength, loads)
        deviations = self._deviations(by_load)
        weights = by_strength / deviations**2
        information = float(np.sum(weights * by_strength))
        of_dent = float(np.sum(weights * seen)) / information
        of_load = -float(np.sum(weights * by_load)) / information
        measured, scatter = 0.0, 0.0
        if any(self._errors):
            measured = information**-0.5
        if sizes.size > 1:
            scatter = math.sqrt(float(np.sum(((sizes - seen) / deviations) ** 2)) / (sizes.size - 1))
            measured = measured or scatter * information**-0.5
        pair = isinstance(self.bed.medium.second, Elastic)  # type: ignore[attr-defined]
        error = PAIR_ERROR if pair else DEPTH_ERROR
        if isinstance(self.dent, Radius):
            of_law = RADIUS_ERROR * seen
        elif isinstance(self.dent, Depth):
            of_law = error * depth
        else:
            blunt = round_part(first_loading(self._bed(strength)).exponent(radius))
            of_law = np.where(blunt < 1.0, max(error, CONE_ERROR), error)
        law = abs(float(np.sum(weights * of_law)) / information)
        most = int(np.argmax(loads))
        residual = depth[most] - first_loading(self._bed(strength)).at(radius[[most]]).recovery[0]
        misfit = scatter if any(self._errors) else 0.0
        return StrengthFromDentSolution(
            self, strength, strength * measured, strength * law, of_load, of_dent, misfit,
            float(force[most] / (np.pi * radius[most] ** 2)), float(radius[most]), float(residual), float(depth[most]),
            float(force[most]),
        )  # fmt: skip


@value
class StrengthFromDentSolution:
    """The solution of `StrengthFromDent`.

    Parameters
    ----------
    problem : StrengthFromDent
        The problem that was solved.
    strength : float
        Y [Pa]: the initial yield stress if a hardening law is given, otherwise the flow stress at the strain of the
        dent.
    strength_error : float
        Its standard deviation by those of loads and dents [Pa], to first order; of several loads without errors by
        their scatter.
    law_error : float
        Contribution of the model error to the error of the strength [Pa]. The model error is 2 % of a radius, or 0.01
        of the depth under load (0.03 for two deformable bodies). For a restitution it is 0.01 (0.03; for cones at least
        0.02).
    of_load, of_dent : float
        Sensitivities d ln Y / d ln F (or by velocity) and d ln Y / d ln r (or by restitution) [-], with all other
        measured quantities constant. For several loads, all change by the same factor.
    misfit : float
        Root mean square deviation of several loads over their stated errors [-]: about one if one strength explains all
        of them. Zero for a single load, or without stated errors.
    hardness : float
        Meyer's hardness: force over the projected area of the dent [Pa]. This value and those below are for the
        maximum load.
    radius, residual_depth : float
        Radius and depth of the dent [m]; for a single dent one of them is the given value.
    depth, greatest_force : float
        Depth [m] and force [N] under load.
    """

    __words__ = words(
        strength_error=("u(Y)", "Pa", "standard deviation of the strength, by those of loads and dents"),
        law_error=(r"\delta Y", "Pa", "error of the strength that the law of yielding may add"),
        of_load=("", "", "relative change of the strength by that of force or velocity"),
        of_dent=("", "", "relative change of the strength by that of dent or restitution"),
        misfit=("", "", "what several loads miss over their stated errors"),
        released=("", None, "the contact under the load and after unloading"),
        hardness=("H_M", "Pa", "force over the area of the dent in its plane, Meyer's hardness"),
    )

    problem: StrengthFromDent
    strength: float
    strength_error: float
    law_error: float
    of_load: float
    of_dent: float
    misfit: float
    hardness: float
    radius: float
    residual_depth: float
    depth: float
    greatest_force: float

    @property
    def released(self) -> PlasticSolution:
        """The contact of a body with this strength, under the maximum load and after unloading."""
        path = Force(np.array([self.greatest_force, 0.0]))
        return PlasticIndentation(self.problem._bed(self.strength), path).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        if isinstance(problem.load, Blow):
            fastest = float(np.max(problem.load.velocity))
            law = PlasticImpact(problem._bed(self.strength), problem.load.mass, fastest).solve().validity
        else:
            law = self.released.validity
        hardens = isinstance(problem.bed.medium.first, Hardening)  # type: ignore[attr-defined]
        return law if hardens else (*law, HARDENS)
