r"""Rough bodies: between which bounds stiffness and conductance must lie, whatever the roughness looks like.

If the roughness stays between a smooth shape and the same shape raised by s, the force curve lies between two copies of
the smooth one, :math:`F_s(d-s)\le F(d)\le F_s(d)`.  Force curves are convex, so the slope at a given force F cannot
leave what the tangents to these copies allow (Barber): with :math:`F_s(d_0)=F`

.. math:: \max_{D<d_0}\frac{F-F_s(D)}{d_0+s-D} \;\le\; k \;\le\; \min_{D>d_0+s}\frac{F_s(D)-F}{D-d_0-s} .

Both are reached where the chord is a tangent, so they are stiffnesses of the smooth body in two other contacts.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Force
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.media.conduction.disc_resistance import BARBER
from winkler.media.halfspace import HomogeneousMedium
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.overlap import rises
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.values.checks.number_checks import NonNegative, Positive
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

HALVINGS = 200


@value
class ConductanceBounds:
    """Bounds of stiffness and conductance of a rough body pressed into another one.

    Parameters
    ----------
    bed : Bed
        The smooth body that touches the rough body from inside: Foundation or PlaneFoundation on a homogeneous medium.
    conductors : ElectricalConductors
        Conductors of the bodies; both must be thick, without platings or film.
    roughness : float
        Height from the lowest valley to the highest peak, both surfaces together [m], not negative.
    force : float
        F_N [N], positive.

    Raises
    ------
    InvalidInput
        If a number is outside its range, or an argument has the wrong type.
    OutsideValidity
        If the medium is not homogeneous, or there is a film, a plating or a rod.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.conductor import ElectricalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace.between(Elastic(1.0, 0.0)))
    >>> unit = ElectricalConductor(1.0)
    >>> bounds = ConductanceBounds(bed, ElectricalConductors(unit, unit), roughness=0.2, force=1.0).solve()
    >>> round(bounds.least_stiffness, 6), round(bounds.smooth_stiffness, 6), round(bounds.greatest_stiffness, 6)
    (1.076537, 1.817121, 2.843533)
    """

    bed: Bed
    conductors: ElectricalConductors
    roughness: NonNegative
    force: Positive

    references: ClassVar[tuple[str, ...]] = ("barber_2003",)
    assumptions: ClassVar[frozenset[Assumption]] = frozenset(
        (Assumption.RESPONSE, Assumption.ELASTIC, Assumption.RESOLUTION, Assumption.CONDUCTION)
    )
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not isinstance(getattr(self.bed, "medium", None), HomogeneousMedium):
            raise OutsideValidity(
                f"ConductanceBounds: on a {type(self.bed.medium).__name__} conductance is not proportional to "
                "stiffness; give a homogeneous medium."
            )
        self._conductance_of_stiffness()

    def _conductance_of_stiffness(self) -> float:
        medium: HomogeneousMedium = self.bed.medium  # type: ignore[assignment]
        return conductance_of_stiffness("ConductanceBounds", medium, self.conductors)

    def solve(self) -> ConductanceBoundsSolution:
        """Return the bounds.

        Returns
        -------
        ConductanceBoundsSolution

        Raises
        ------
        OutsideValidity
            If the upper bound leads beyond the reach of the profile, or the force curve of the smooth body is not
            convex.
        """
        bed, force, rough = self.bed, self.force, self.roughness
        smooth = Indentation(bed, Force(force)).solve()
        a0, d0 = float(smooth.radius), float(smooth.depth)
        k0 = float(smooth.stiffness)

        def at(a: float) -> tuple[float, float, float]:
            place = np.array([a])
            k = float(bed.stiffness(place)[0])
            d = float(bed.gap(place)[0])
            return d, k * d - float(bed.gap_load(place)[0]), k

        def below(a: float) -> float:
            d, f, k = at(a)
            return k * (d0 + rough - d) - (force - f)

        def above(a: float) -> float:
            d, f, k = at(a)
            return k * (d - d0 - rough) - (f - force)

        if rough == 0.0:
            return self._solution(k0, k0, k0)
        beyond = self._beyond(above, a0)
        if not rises(bed, beyond):
            raise OutsideValidity(
                "ConductanceBounds: the force curve of this body need not be convex, since its contact does not "
                "grow as one disc; give a smooth body that does."
            )
        # under a flat end both are searched at depth zero, where the chord from first touch is met
        return self._solution(at(_crossing(below, 0.0, a0))[2], k0, at(_crossing(above, a0, beyond))[2])

    def _beyond(self, above: Callable[[float], float], radius: float) -> float:
        """Return a radius beyond the tangent of the upper bound; the rim where the contact is pinned before it."""
        end = min(self.bed.reach, self.bed.rim)
        for _ in range(HALVINGS):
            radius = min(2.0 * radius, end)
            if above(radius) > 0.0:
                return radius
            if radius == end:
                break
        if end == self.bed.rim:
            return end  # from here on the curve is a straight line, which no tangent meets
        raise OutsideValidity(
            f"ConductanceBounds: the roughness {self.roughness:.4g} m requires contacts beyond {end:.4g} m, where the "
            "body ends; give a smaller roughness or force, or more of the shape."
        )

    def _solution(self, least: float, smooth: float, greatest: float) -> ConductanceBoundsSolution:
        factor = self._conductance_of_stiffness()
        stiffness = (least, smooth, greatest)
        return ConductanceBoundsSolution(self, *stiffness, *(factor * part for part in stiffness))


def _crossing(rising: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function that never falls passes zero."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if rising(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)


@value
class ConductanceBoundsSolution:
    """The solution of a `ConductanceBounds`.

    Parameters
    ----------
    problem : ConductanceBounds
        The problem that was solved.
    least_stiffness, smooth_stiffness, greatest_stiffness : float
        dF/dd [N/m]: lower bound, without roughness, upper bound.
    least_conductance, smooth_conductance, greatest_conductance : float
        The same for 1 / R [S].
    """

    problem: ConductanceBounds
    least_stiffness: float
    smooth_stiffness: float
    greatest_stiffness: float
    least_conductance: float
    smooth_conductance: float
    greatest_conductance: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the bounds can be trusted."""
        return (
            *self.problem.bed.medium.notes,
            *unknown_yield(self.problem.bed.medium, "the value depends on the shape of the roughness"),
            Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                "Rigorous bounds for elastic contact without friction or adhesion. They hold for every roughness "
                "between the two smooth shapes, if all spots are clean metal.",
                BARBER,
            ),
        )
