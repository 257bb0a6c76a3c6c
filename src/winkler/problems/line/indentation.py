r"""Line contact without friction: a two-dimensional body pressed on a half-plane by a force per length.

.. math:: P = E^* w(a) , \qquad p(x) = \frac{E^*}\pi\int_{|x|}^a\frac{w'(c)}{\sqrt{c^2-x^2}}\,\mathrm dc , \qquad
          p_m = \frac P{2a} .

The surface of a half-plane sinks without bound under a force per length: there is a depth only against a stated
reference.
"""

from __future__ import annotations

import dataclasses
from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.loading import HalfWidth, LineForce, MeanPressure
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, ArrayLike, Quantity, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.approach import approach
from winkler.problems.line.greatest_stress import Placed, greatest, von_mises
from winkler.problems.line.half_width import refuse_unless_strips, under_force, under_mean_pressure, widest_allowed
from winkler.problems.line.peak_pressure import peak_pressure, rim_load
from winkler.problems.line.statement import line_contact_notes
from winkler.problems.line.stress import LineContact, LineFields, poisson_of, stresses
from winkler.problems.one_load import single
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["LineIndentation", "LineSolution"]


@value
class LineIndentation:
    """A cylinder, a wedge or another two-dimensional body pressed on a half-plane, in plane strain.

    Parameters
    ----------
    bed : LineFoundation
        Profile and bodies.
    load : LineForce, HalfWidth or MeanPressure
        What is prescribed; its value may be an array, the results then have its shape.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2 and 5.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    A steel roller of 10 mm radius under 100 N/mm.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> roller = LineIndentation(bed, LineForce(100e3)).solve()
    >>> round(roller.half_width * 1e6, 3), round(roller.peak_pressure / 1e6, 3)  # micrometres, MPa
    (105.046, 606.037)
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        load=("", None, "what is prescribed: a force per length, a half-width or a mean pressure"),
    )

    bed: LineFoundation
    load: LineForce | HalfWidth | MeanPressure

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def solve(self) -> LineSolution:
        """Return force per length and half-width.

        Raises
        ------
        OutsideValidity
            If the load is tensile or leads beyond the reach of the profile, or the bodies touch in several strips.
        InvalidInput
            If a mean pressure does not determine the contact.
        """
        bed, modulus = self.bed, self.bed.medium.modulus
        given = _given(self.load)
        flat = np.atleast_1d(np.asarray(given, dtype=float)).ravel()
        if np.any(flat < 0.0):
            raise OutsideValidity(
                f"LineIndentation: the load {float(np.min(flat)):.6g} is tensile; without adhesion bodies can only be "
                "pressed together: give zero or more."
            )
        if isinstance(self.load, HalfWidth):
            widest_allowed(bed, flat)
            half_width = flat.copy()
            force = modulus * bed.load_profile(half_width)
        elif isinstance(self.load, MeanPressure):
            half_width = under_mean_pressure(bed, flat / modulus)
            force = 2.0 * half_width * flat
        else:
            half_width, force = under_force(bed, flat / modulus), flat
        refuse_unless_strips(bed, half_width)
        return LineSolution(self, shaped(force, np.shape(given)), shaped(half_width, np.shape(given)))


def _given(load: LineForce | HalfWidth | MeanPressure) -> Quantity:
    match load:
        case HalfWidth(given) | MeanPressure(given) | LineForce(given):
            return given


@value
class LineSolution:
    """The solution of a `LineIndentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : LineIndentation
        The problem that was solved.
    force_per_length : float or ndarray
        P [N/m], compression positive.
    half_width : float or ndarray
        a [m], zero where there is no contact.
    """

    problem: LineIndentation
    force_per_length: Quantity
    half_width: Quantity

    per_load: ClassVar[str] = "half_width"

    @property
    def mean_pressure(self) -> Quantity:
        """P / (2 a) [Pa]; zero without contact."""
        width = 2.0 * np.asarray(self.half_width)
        return shaped(np.asarray(self.force_per_length) / np.where(width > 0.0, width, 1.0))

    @property
    def peak_pressure(self) -> Quantity:
        """The greatest pressure [Pa]; infinite at a sharp tip, kink or rim, zero without contact."""
        pairs = zip(np.ravel(self.force_per_length), np.ravel(self.half_width), strict=True)
        peaks = [peak_pressure(self.problem.bed, float(p), float(a)) for p, a in pairs]
        return shaped(np.array(peaks), np.shape(self.half_width))

    def _single(self, requested: str) -> tuple[float, float]:
        return single(self.force_per_length, requested), float(self.half_width)

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure under one load [Pa], zero outside of the contact.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], on either side of the middle.

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        """
        force, a = self._single("pressure")
        x = np.asarray(x, dtype=float)
        if a == 0.0:
            return np.zeros(x.shape)
        return self.problem.bed.pressure(x, a, rim_load(self.problem.bed, force, a))

    def separation(self, x: ArrayLike) -> Array:
        """Return the distance of the deformed surfaces under one load [m], zero inside of the contact.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], on either side of the middle.

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        OutsideValidity
            If the contact is pinned at a rim, beyond which the body has no surface.
        """
        _, a = self._single("separation")
        bed = self.problem.bed
        if a >= bed.rim:
            raise OutsideValidity("The contact is pinned at the rim, beyond which the body has no surface.")
        if a == 0.0:
            return np.asarray(bed.profile.height(np.abs(np.asarray(x, dtype=float))))
        edges = [a, *(b for b, _ in bed.kinks if b > a)]

        def opening(x: Array) -> Array:
            return np.where(x > a, bed.opening(np.maximum(x, np.nextafter(a, np.inf)), a), 0.0)

        return abel.integral(opening, edges, np.abs(np.asarray(x, dtype=float)))

    def stresses(self, x: ArrayLike, z: ArrayLike, friction: float = 0.0) -> LineFields:
        """Return the stresses below the surface under one load.

        Parameters
        ----------
        x : array_like
            Places along the surface [m].
        z : array_like
            Depths [m]: not negative in the first body, negative in the second.  All in one of them.
        friction : float
            mu [-] of a contact that slides everywhere: the body is dragged along x by mu p, against it if negative.

        Raises
        ------
        InvalidInput
            If the solution has more than one load, or the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or the body is rigid or not isotropic.
        """
        depth = np.asarray(z, dtype=float)
        below = bool(np.all(depth >= 0.0))
        if not below and np.any(depth >= 0.0):
            raise InvalidInput("LineSolution: the depths z lie in both bodies; request one after the other.")
        fields = stresses(self._contact(below, friction), np.asarray(x, dtype=float), np.abs(depth))
        return fields if below else dataclasses.replace(fields, z=-fields.z)

    def greatest_stress(self, friction: float = 0.0, *, below: bool = True) -> Placed:
        """Return the greatest von Mises stress [Pa] under one load, and its place x, z [m] in the axes of the body.

        Parameters
        ----------
        friction : float
            As of `stresses`.
        below : bool
            In the first body; otherwise in the second.

        Raises
        ------
        InvalidInput, OutsideValidity
            As of `stresses`; also where the stress is infinite, below a sharp tip, kink or rim.
        """
        contact = self._contact(below, friction)
        if not np.isfinite(self.peak_pressure):
            raise OutsideValidity(
                "The stress below a sharp tip, kink or rim is infinite; round it off, or request places with stresses."
            )
        return greatest(contact, von_mises)

    def _contact(self, below: bool, friction: float) -> LineContact:
        force, a = self._single("stresses")
        if a == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        return LineContact(
            self.problem.bed, a, rim_load(self.problem.bed, force, a), poisson_of(self.problem.bed, below), friction
        )

    def approach(self, first: float | None = None, second: float | None = None) -> float:
        """Return how far two points on the axis have come together under one load [m], one in each body.

        Parameters
        ----------
        first, second : float
            Depths of the points below the surfaces [m]; that in a rigid body may be left out.

        Raises
        ------
        InvalidInput
            If a reference is not stated: a line contact has no depth of its own; or if there are many loads.
        OutsideValidity
            If the medium is not a `HalfSpace`.
        """
        force, a = self._single("approach")
        return approach(self.problem.bed, a, rim_load(self.problem.bed, force, a), first, second)

    def at(self, index: int | tuple[int, ...]) -> LineSolution:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        try:
            force, a = (float(np.asarray(part)[index]) for part in (self.force_per_length, self.half_width))
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.at: there is no load {index!r} in a solution of shape {np.shape(self.half_width)}."
            ) from None
        given = type(self.problem.load)(float(np.asarray(_given(self.problem.load))[index]))
        return LineSolution(LineIndentation(self.problem.bed, given), force, a)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, size of the body, yield."""
        return line_contact_notes(self.problem.bed, self.force_per_length, self.half_width)
