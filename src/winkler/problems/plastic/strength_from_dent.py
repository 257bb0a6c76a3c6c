"""The strength of a metal from a dent that a known load has left in it."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.materials.hardening import Hardening
from winkler.media.halfspace import HalfSpace
from winkler.numerics.equations.roots import between
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.plastic.first_loading import LEAST_STIFFNESS, first_loading, refuse_unknown
from winkler.problems.plastic.indentation import PlasticIndentation, PlasticSolution
from winkler.values.checks.number_checks import NonNegative
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["StrengthFromDent", "StrengthFromDentSolution"]

STEP = 1e-4
"""Relative change of force and strength over which the dent is differentiated."""
NEXT_STRENGTH = 0.5
LEAST_STRENGTH = 1e-9
"""Part of Young's modulus below which no strength is sought."""
RADIUS_ERROR, DEPTH_ERROR, PAIR_ERROR = 0.02, 0.01, 0.03
"""What the law errs by: parts of the radius; of the depth, by which the residual depth errs, of one body and of two."""
HARDENS = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "A dent tells one strength: of a metal that hardens it is the flow stress at a strain of about 0.2 a/R (Tabor), "
    "not where yielding begins.",
    "D. Tabor, The Hardness of Metals, Oxford University Press 1951",
)


@value
class StrengthFromDent:
    r"""Which strength has a metal in which a known load has left a dent?

    The strength is sought with which `PlasticIndentation` leaves this dent.  Errors of force and dent are carried on to
    first order,

    .. math:: u^2(\ln Y) = \left(\frac{\partial\ln Y}{\partial\ln F}\frac{u(F)}{F}\right)^2
              + \left(\frac{\partial\ln Y}{\partial\ln r}\frac{u(r)}{r}\right)^2 .

    Parameters
    ----------
    bed : Foundation
        As of `PlasticIndentation`.  The first body is the one whose strength is sought: an `Elastic` without one, or a
        solid that hardens.  The second one may be rigid, elastic, or have a strength of its own.
    force : Force
        The greatest load that the contact has borne [N], a single one.
    dent : Radius or Depth
        What the load has left: the radius of the dent in its plane, or its depth, by which the bodies have come nearer
        for good, `residual_depth` of a `PlasticIndentation` [m].
    force_error, dent_error : float, optional
        Standard deviations of force [N] and dent [m]; zero unless given.

    Raises
    ------
    InvalidInput
        As of `PlasticIndentation`; if the first body has a strength already; if force or dent is not a single positive
        number.

    References
    ----------
    D. Tabor, The Hardness of Metals, Oxford University Press 1951 (the radius of a dent is that of the contact which
    has made it, for its rim hardly moves while it is released); K. L. Johnson, Contact Mechanics, Cambridge University
    Press 1985, chapter 6, doi:10.1017/CBO9781139171731

    Examples
    --------
    >>> from winkler.materials.elastic import RIGID
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=210e9, poisson=0.3)
    >>> ball = Foundation(Paraboloid(5e-3), HalfSpace(steel, RIGID))
    >>> found = StrengthFromDent(ball, Force(1000.0), Radius(0.36e-3), dent_error=5e-6).solve()
    >>> bool(0.9e9 < found.strength < 1.1e9), bool(found.strength_error < 0.05 * found.strength)
    (True, True)
    """

    __words__ = words(
        force=("", None, "greatest load that the contact has borne"),
        dent=("", None, "radius or depth of the dent that it has left"),
        force_error=("u(F)", "N", "standard deviation of the force"),
        dent_error=("u(r)", "m", "standard deviation of radius or depth of the dent"),
    )

    bed: Bed
    force: Force
    dent: Radius | Depth
    force_error: NonNegative = 0.0
    dent_error: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED
    needs_round: ClassVar[str] = "yielding, whose laws are those of bodies of revolution,"

    def __post_init__(self) -> None:
        owner = type(self).__name__
        for name, number in (("force", self.force.force), ("dent", self._size)):
            if np.ndim(number) or not number > 0.0:
                raise InvalidInput(f"{owner}: the {name} is {number}; give a single, positive number.")
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
    def _size(self) -> Any:
        """Radius or depth of the dent [m]."""
        return self.dent.radius if isinstance(self.dent, Radius) else self.dent.depth

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

    def _dent(self, strength: float, force: float) -> float:
        """Return the radius or the depth [m] of the dent that a force leaves; infinite where it is out of reach."""
        bed = self._bed(strength)
        if force >= first_loading(bed).greatest_force:
            return math.inf
        state = next(PlasticIndentation(bed, Force(np.array([force]))).steps())
        return state.largest_radius if isinstance(self.dent, Radius) else state.residual_depth

    def solve(self) -> StrengthFromDentSolution:
        """Return the strength, and how certain it is.

        Raises
        ------
        OutsideValidity
            If the contact would be as large without yielding, so that the dent tells no strength; if no strength makes
            so large a dent; as of `PlasticIndentation.steps`.
        """
        force, dent = float(self.force.force), float(self._size)
        young = self.bed.medium.first.young  # type: ignore[attr-defined]
        high = young / LEAST_STIFFNESS
        least = self._dent(high, force)
        what = "radius" if isinstance(self.dent, Radius) else "depth"
        if dent <= least:
            raise OutsideValidity(
                f"StrengthFromDent: a first body with a strength of a fiftieth of its Young's modulus, {high:.4g} Pa, "
                f"has a dent or a contact of {least:.6g} m already under this force; a {what} of {dent:.6g} m tells no "
                "strength: give a greater dent, a lesser force, or check moduli and units."
            )
        low = high
        while self._dent(low := NEXT_STRENGTH * low, force) < dent:
            if low < LEAST_STRENGTH * young:
                raise OutsideValidity(
                    f"StrengthFromDent: down to a strength of {low:.4g} Pa no dent has a {what} of {dent:.6g} m under "
                    "this force; check force, dent and units."
                )

        def excess(place: float) -> float:
            return min(self._dent(math.exp(place), force) / dent, 2.0) - 1.0

        strength = math.exp(between(excess, math.log(low), math.log(low / NEXT_STRENGTH), relative=1e-12))
        by_strength, by_force = (
            (math.log(self._dent(*more)) - math.log(self._dent(*less))) / (2.0 * STEP)
            for more, less in (
                ((strength * (1.0 + STEP), force), (strength * (1.0 - STEP), force)),
                ((strength, force * (1.0 + STEP)), (strength, force * (1.0 - STEP))),
            )
        )
        of_dent, of_force = 1.0 / by_strength, -by_force / by_strength
        state = next(PlasticIndentation(self._bed(strength), Force(np.array([force]))).steps())
        measured = math.hypot(of_force * self.force_error / force, of_dent * self.dent_error / dent)
        if isinstance(self.dent, Radius):
            of_law = RADIUS_ERROR
        else:
            pair = isinstance(self.bed.medium.second, Elastic)  # type: ignore[attr-defined]
            of_law = (PAIR_ERROR if pair else DEPTH_ERROR) * state.depth / dent
        return StrengthFromDentSolution(
            self, strength, strength * measured, strength * abs(of_dent) * of_law, of_force, of_dent,
            force / (np.pi * state.largest_radius**2), state.largest_radius, state.residual_depth, state.depth,
        )  # fmt: skip


@value
class StrengthFromDentSolution:
    """The solution of `StrengthFromDent`.

    Parameters
    ----------
    problem : StrengthFromDent
        The problem that was solved.
    strength : float
        Y [Pa]; where yielding begins if the solid is one that hardens, else the flow stress at the strain of the dent.
    strength_error : float
        Its standard deviation by those of force and dent [Pa], to first order.
    law_error : float
        What the law may add: its own error of 2 % of a radius, or of 0.01 of the depth under load (0.03 of two
        deformable bodies), carried on to the strength [Pa].
    of_force, of_dent : float
        d ln Y / d ln F and d ln Y / d ln r [-], with the other measured quantity unchanged.
    hardness : float
        Force over the area of the dent in its plane [Pa], Meyer's hardness.
    radius, residual_depth : float
        Radius and depth of the dent [m]; one of them is that given.
    depth : float
        Under load [m].
    """

    __words__ = words(
        strength_error=("u(Y)", "Pa", "standard deviation of the strength, by those of force and dent"),
        law_error=(r"\delta Y", "Pa", "error of the strength that the law of yielding may add"),
        of_force=("", "", "relative change of the strength by that of the force"),
        of_dent=("", "", "relative change of the strength by that of the dent"),
        released=("", None, "the contact under the load, and let go"),
        hardness=("H_M", "Pa", "force over the area of the dent in its plane, Meyer's hardness"),
    )

    problem: StrengthFromDent
    strength: float
    strength_error: float
    law_error: float
    of_force: float
    of_dent: float
    hardness: float
    radius: float
    residual_depth: float
    depth: float

    @property
    def released(self) -> PlasticSolution:
        """The contact of a body with this strength under the load, and let go."""
        force = float(self.problem.force.force)
        return PlasticIndentation(self.problem._bed(self.strength), Force(np.array([force, 0.0]))).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        law = self.released.validity
        return law if isinstance(self.problem.bed.medium.first, Hardening) else (*law, HARDENS)  # type: ignore[attr-defined]
