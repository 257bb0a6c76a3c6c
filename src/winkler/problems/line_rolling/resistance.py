r"""A cylinder that rolls or slides without friction on bodies that relax: its strip of contact, and what resists it.

In front the bodies are stiffer than behind, where they have not yet come back: the strip reaches farther ahead of the
lowest point than behind it, and the moment of the pressure about it resists,

.. math:: 2\Bigl[C_0\,g(x) + \sum_k C_k\int_0^\infty \frac{e^{-s/v\lambda_k}}{v\lambda_k}\,g(x+s)\,\mathrm ds\Bigr]
          = \frac xR , \qquad g(x) = \frac1\pi\int\frac{p(s)}{x-s}\,\mathrm ds ,

.. math:: P = \int p\,\mathrm dx , \qquad Q = \int p\,\frac xR\,\mathrm dx ,

with the creep :math:`C(t)=C_0+\sum C_k(1-e^{-t/\lambda_k})` of 1/E* (`winkler.numerics.transforms.passing_strip`).

References
----------
S. C. Hunter, The rolling contact of a rigid cylinder with a viscoelastic half space, J. Appl. Mech. 28 (1961) 611-617,
doi:10.1115/1.3641792
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.loading.loads import HalfWidth
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array, ArrayLike, PerLoad, Q, like, shaped
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.assumptions.times import times_notes
from winkler.problems.line.pressing_load import OfWidth
from winkler.problems.line_rolling.passage import passage
from winkler.problems.line_rolling.pressed import OneLineLoad, refuse_unless_round
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import large_body_note, steepness_note
from winkler.problems.one_load import single
from winkler.values.checks.number_checks import POSITIVE_QUANTITY
from winkler.values.checks.place_checks import finite_places
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class LineRollingResistance(PerLoad[Q]):
    """A cylinder that rolls freely, or slides without friction, on viscoelastic bodies at a steady speed.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        A `Paraboloid` on a `ViscoelasticHalfSpace`, on layers of which at least one is viscoelastic, or on a
        poroelastic film. Moduli must be finite at short times, and not zero at long times.
    load : LineForce, HalfWidth or MeanPressure
        The steady load, one positive number; a half-width is half of the width from edge to edge.
    speed : float or ndarray
        Speed v [m/s] of the bodies relative to the contact, positive; the results have its shape.

    Raises
    ------
    InvalidInput
        If the profile is not round, the medium does not relax, flows or has a dashpot alongside, or a number is out of
        range.

    References
    ----------
    S. C. Hunter, J. Appl. Mech. 28 (1961) 611-617, doi:10.1115/1.3641792

    Examples
    --------
    A solid that relaxes to a tenth: its resistance is greatest where it passes the strip in about its relaxation time.

    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> solid = StandardSolid(relaxed_shear=1e6, shear=9e6, relaxation_time=1e-3)
    >>> bed = LineFoundation(Paraboloid(0.1), ViscoelasticHalfSpace(solid))
    >>> rolling = LineRollingResistance(bed, HalfWidth(1e-3), np.array([0.01, 0.1, 1.0, 10.0])).solve()
    >>> (1e3 * rolling.coefficient).round(4)
    array([0.8527, 5.7531, 9.9704, 2.2299])
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        load=("", None, "the normal load: a force per length, a half-width or a mean pressure"),
        speed=("v", "m/s", "speed with which the bodies pass the contact"),
    )

    bed: LineFoundation | LayeredLineFoundation
    load: OneLineLoad
    speed: Annotated[Q, POSITIVE_QUANTITY]

    references: ClassVar[tuple[str, ...]] = ("hunter_1961",)
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING

    def __post_init__(self) -> None:
        refuse_unless_round("LineRollingResistance", self.bed)
        medium: object = self.bed.medium
        if not offers(medium, RelaxingMedium):
            raise InvalidInput(
                f"LineRollingResistance: the bed stands on a {type(medium).__name__}; give LineFoundation(Paraboloid(R)"
                ", ViscoelasticHalfSpace(solid)) or a LayeredLineFoundation on layers that relax: an elastic body does "
                "not resist rolling."
            )
        if medium.in_proportion and (medium.creep.fluidity > 0.0 or medium.creep.glassy == 0.0):
            which = "creeps without limit" if medium.creep.fluidity > 0.0 else "resists a step of strain without bound"
            raise InvalidInput(
                f"LineRollingResistance: the solid {which}; give one with a relaxed and a glassy modulus, such as "
                "StandardSolid or Prony."
            )

    def solve(self) -> LineRollingResistanceSolution[Q]:
        """Return the contact strip and the rolling resistance at every speed.

        Raises
        ------
        OutsideValidity
            If the load does not press the bodies together.
        """
        given = next(getattr(self.load, item.name) for item in dataclasses.fields(self.load))
        if not float(given) > 0.0:
            raise OutsideValidity(
                f"LineRollingResistance: the load {float(given):.6g} does not press the bodies together; give a "
                "positive one."
            )
        speeds = np.ravel(np.asarray(self.speed, dtype=float)).tolist()
        rows = [passage(self.bed, self.load, speed) for speed in speeds]
        names = ("force_per_length", "half_width", "leading_edge", "trailing_edge", "shear_force_per_length")
        columns = {name: like(np.array([getattr(row, name) for row in rows]), self.speed) for name in names}
        return LineRollingResistanceSolution(self, self.speed, **columns)


@value
class LineRollingResistanceSolution(OfWidth[Q]):
    """The solution of a `LineRollingResistance`; every quantity has the shape of the speed.

    Parameters
    ----------
    problem : LineRollingResistance
        The problem that was solved.
    speed : float or ndarray
        v [m/s].
    force_per_length, half_width : float or ndarray
        P [N/m], and half of the width from edge to edge [m].
    leading_edge, trailing_edge : float or ndarray
        Ends of the contact [m], from the lowest point of the cylinder. The trailing edge is usually negative. It is
        positive only if the solid relaxes by orders of magnitude and, like a liquid, has crept completely before the
        lowest point.
    shear_force_per_length : float or ndarray
        Q [N/m] that resists the motion.
    """

    __words__ = words(
        trailing_edge=("x_2", "m", "where the contact ends, negative behind the lowest point"),
        coefficient=("f", "", "resistance over normal force"),
    )

    problem: LineRollingResistance[Q]
    speed: Q
    force_per_length: Q
    half_width: Q
    leading_edge: Q
    trailing_edge: Q
    shear_force_per_length: Q

    per_load: ClassVar[str] = "half_width"

    @property
    def coefficient(self) -> Q:
        """Q / P [-], the coefficient of rolling resistance."""
        return shaped(np.asarray(self.shear_force_per_length) / np.asarray(self.force_per_length))

    @property
    def peak_pressure(self) -> Q:
        """The maximum pressure [Pa]."""
        pairs = zip(np.ravel(self.half_width), np.ravel(self.speed), strict=True)
        peaks = [
            passage(self.problem.bed, HalfWidth(float(width)), float(speed)).peak_pressure for width, speed in pairs
        ]
        return shaped(np.array(peaks), np.shape(self.half_width))

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure at one speed [Pa], zero outside of the contact.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m], from the lowest point of the cylinder, which moves towards +x.

        Raises
        ------
        InvalidInput
            If the solution has more than one speed.
        """
        width = single(self.half_width, "pressure")
        places = finite_places("LineRollingResistanceSolution.pressure", "x", x)
        return passage(self.problem.bed, HalfWidth(width), float(self.speed)).pressure(places)

    def at(self, index: int | tuple[int, ...]) -> LineRollingResistanceSolution[float]:
        """Return the solution at one speed of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such speed.
        """
        try:
            speed = float(np.asarray(self.speed)[index])
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.at: there is no speed {index!r} in a solution of shape {np.shape(self.speed)}."
            ) from None
        return LineRollingResistance(self.problem.bed, self.problem.load, speed).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        times = 2.0 * np.ravel(self.half_width) / np.ravel(self.speed)
        widest = max(float(np.max(np.abs(edge))) for edge in (self.leading_edge, self.trailing_edge))
        return (
            *bed.notes,
            *((HUNTER,) if isinstance(bed, LineFoundation) else (_on_layers(bed), EXAMINED)),
            steepness_note(widest / bed.size),
            large_body_note(widest / bed.size, strip=True),
            *times_notes(bed.medium, float(np.min(times)), float(np.max(times))),
            *relaxing_yield(bed.medium),
        )


def _on_layers(bed: LayeredLineFoundation) -> Note:
    """Return what is assumed of layers that the contact passes."""
    medium: Any = bed.medium
    source = next(note.source for note in reversed(medium.notes) if note.assumption is Assumption.RESPONSE)
    return Note(
        Assumption.RESPONSE,
        bed.layered_body.in_plane[0],
        f"{medium.described} in plane strain, at a steady speed, without friction and inertia. Each wavelength of "
        "the pressure acts with the frequency at which it passes. Both bodies pass the contact with this speed.",
        source,
    )


EXAMINED = Note(
    Assumption.SINGLE_CONTACT,
    Standing.APPROXIMATE,
    "The pressure was checked: no tension inside the strip. It was not checked whether layers bulge and "
    "touch beside the strip.",
    "a-posteriori check of the pressure, at sampled places",
)
HUNTER = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Linear viscoelastic half-planes in plane strain with constant Poisson's ratios, at a steady speed, without "
    "friction and inertia. Both bodies pass the contact with this speed.",
    "S. C. Hunter, J. Appl. Mech. 28 (1961) 611-617, doi:10.1115/1.3641792",
)
