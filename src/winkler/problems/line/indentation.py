r"""Line contact without friction: a two-dimensional body pressed on a half-plane by a force per length.

.. math:: P = E^* w(a) , \qquad p(x) = \frac{E^*}\pi\int_{|x|}^a\frac{w'(c)}{\sqrt{c^2-x^2}}\,\mathrm dc , \qquad
          p_m = \frac P{2a} .

The surface of a half-plane sinks without bound under a force per length: there is a depth only against a stated
reference.
"""

from __future__ import annotations

from typing import Any, ClassVar, cast

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.loading.loads import HalfWidth, LineForce, MeanPressure
from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.greatest_stress import Placed, greatest, von_mises
from winkler.problems.line.half_width import refuse_unless_strips, under_force, under_mean_pressure, widest_allowed
from winkler.problems.line.layered_stress import greatest_in_part
from winkler.problems.line.layered_strip import OnLayers
from winkler.problems.line.peak_pressure import peak_pressure, rim_load
from winkler.problems.line.pressing_load import OfWidth, given_by, pressing
from winkler.problems.line.references import Reference
from winkler.problems.line.stress import LineContact, Strip, one_coefficient, poisson_of
from winkler.problems.line.strip import OfStrip
from winkler.problems.line.yield_statement import line_contact_notes
from winkler.problems.normal.strong_parts import StrongPart
from winkler.problems.one_load import one_of, single
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class LineIndentation(PerLoad[Q]):
    """A cylinder, a wedge or another two-dimensional body pressed on a half-plane, in plane strain.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies: homogeneous, layered, graded.
    load : LineForce, HalfWidth or MeanPressure
        The prescribed quantity. For an array the results have its shape.

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

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    load: LineForce[Q] | HalfWidth[Q] | MeanPressure[Q]

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "jaeger_1995")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def solve(self) -> LineSolution[Q]:
        """Return force per length and half-width.

        Raises
        ------
        OutsideValidity
            If the load is tensile or leads beyond the reach of the profile, or the bodies touch in several strips.
        InvalidInput
            If a mean pressure does not determine the contact.
        """
        bed, modulus = self.bed, self.bed.medium.modulus
        flat, shape = pressing("LineIndentation", self.load), np.shape(given_by(self.load))
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
        kinds = {LayeredLineFoundation: LayeredLineSolution, PowerLawLineFoundation: PowerLawLineSolution}
        return kinds.get(type(bed), LineSolution)(self, shaped(force, shape), shaped(half_width, shape))


@value
class LineSolution(OfStrip, OfWidth[Q]):
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

    problem: LineIndentation[Q]
    force_per_length: Q
    half_width: Q

    per_load: ClassVar[str] = "half_width"

    @property
    def peak_pressure(self) -> Q:
        """The maximum pressure [Pa]; infinite at a sharp tip, kink or rim, zero without contact."""
        pairs = zip(np.ravel(self.force_per_length), np.ravel(self.half_width), strict=True)
        bed = self.problem.bed
        peaks = [peak_pressure(bed, Strip(float(a), rim_load(bed, float(p), float(a)))) for p, a in pairs]
        return shaped(np.array(peaks), np.shape(self.half_width))

    def _strip(self, requested: str) -> Strip:
        force, a = single(self.force_per_length, requested), float(self.half_width)
        return Strip(a, rim_load(self.problem.bed, force, a))

    def greatest_stress(self, friction: float = 0.0, *, below: bool = True) -> Placed:
        """Return the maximum von Mises stress [Pa] under one load, and its place x, z [m] in the axes of the body.

        Parameters
        ----------
        friction : float
            As in `stresses`.
        below : bool
            Whether to search in the first body; otherwise the second is searched.

        Raises
        ------
        InvalidInput, OutsideValidity
            As in `stresses`; also where the stress is infinite, below a sharp tip, kink or rim.
        """
        coefficient, strip = one_coefficient(type(self).__name__, friction), self._touching("greatest_stress")
        contact = LineContact(self._bed, *strip, poisson_of(self._bed.medium, below), coefficient)
        if not np.isfinite(self.peak_pressure):
            raise OutsideValidity(
                "The stress below a sharp tip, kink or rim is infinite; round it off, or request places with stresses."
            )
        return greatest(contact, von_mises)

    def at(self, index: int | tuple[int, ...]) -> LineSolution[float]:
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
        force, a = one_of(index, self.force_per_length, self.half_width)
        load: type[Any] = type(self.problem.load)
        given = load(float(np.asarray(given_by(self.problem.load))[index]))
        kind: type[LineSolution[Any]] = type(self)
        return kind(LineIndentation(self.problem.bed, given), force, a)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, size of the body, yield."""
        return self.dragged_notes(0.0)

    def dragged_notes(self, friction: float) -> tuple[Note, ...]:
        """Return the same where the contact slides everywhere.

        Parameters
        ----------
        friction : float
            Traction over pressure [-].
        """
        return line_contact_notes(self._bed, self.force_per_length, self.half_width, friction)

    def part_stress(self, part: StrongPart, friction: float) -> Placed:
        """Return the maximum von Mises stress [Pa] of a part under one load, and its place; z < 0 in the second body.

        Parameters
        ----------
        part : StrongPart
        friction : float
            As in `stresses`.
        """
        return greatest_in_part(self._bed, self._strip("part_stress"), part, friction)


@value
class LayeredLineSolution(OnLayers[Q], LineSolution[Q]):
    """The solution of a `LineIndentation` on layers; every quantity has the shape of the load.

    On a rigid base it has a `depth`; `layer_stresses` compares the layers.
    """


@value
class PowerLawLineSolution(LineSolution[Q]):
    """The solution of a `LineIndentation` on bodies graded by a power; every quantity has the shape of the load.

    Where the modulus grows with the depth it has a `depth`.
    """

    @property
    def depth(self) -> Q:
        """How far the bodies approach, counted from places far away [m], where the modulus grows with the depth."""
        bed = cast(PowerLawLineFoundation, self.problem.bed)
        force, a = np.ravel(self.force_per_length), np.ravel(self.half_width)
        loads = np.array([rim_load(bed, float(p), float(width)) for p, width in zip(force, a, strict=True)])
        return shaped(bed.depth(a, loads), np.shape(self.half_width))

    def approach(self, first: float | Reference | None = None, second: float | Reference | None = None) -> float:
        """Return the approach of places far away under one load [m], as `depth`.

        Parameters
        ----------
        first, second : None
            Places at a finite depth are not supported.

        Raises
        ------
        OutsideValidity
            If a place is given, or the modulus does not grow with the depth.
        """
        if first is not None or second is not None:
            raise OutsideValidity(
                "Displacements inside a GradedHalfSpace are not implemented; leave both out: the approach is "
                "counted from places far away."
            )
        bed = cast(PowerLawLineFoundation, self.problem.bed)
        a, edge_load = self._strip("approach")
        return float(bed.depth(np.array(a), np.array(edge_load)))
