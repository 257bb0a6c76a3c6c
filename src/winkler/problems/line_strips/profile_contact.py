r"""Sections that touch half-planes or layers in several strips, which do not repeat: rough, wavy, tilted, side by side.

.. math:: h(x) = f(x) - \theta x - C - \frac2{\pi E^*}\int p(s)\ln|x-s|\,\mathrm ds , \qquad
          p \ge 0, \; h \ge 0, \; p\,h = 0 , \qquad P = \int p\,\mathrm dx , \quad M = \int p\,x\,\mathrm dx .

The constant C follows from the force, the tilt is prescribed, or follows from the line of action of the force.  On
layers what the waves of their response add, :math:`\frac2{\pi E^*}\int\frac Mk\cos k(x-s)\,\mathrm dk`, stands beside
the logarithm.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.loading.loads import LineForce, LineOfAction, Tilt
from winkler.numerics.surfaces.found_strips import FoundStrips
from winkler.numerics.types import Array, ArrayLike, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.pressing_load import pressing
from winkler.problems.line.stress import LineFields, one_coefficient
from winkler.problems.line_strips.profile_notes import profile_notes
from winkler.problems.line_strips.strip_fields import LineMedium, response_below, strip_fields
from winkler.problems.line_strips.strip_search import Pushed, find_strips
from winkler.problems.one_load import one_of, single
from winkler.problems.which_body import in_first_body
from winkler.profiles.sections.measured_section import AnySection
from winkler.values.checks.number_checks import Advice, Whole
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

STRAIGHT = Tilt(0.0)


@value
class LineProfileContact(PerLoad[Q]):
    """A section, stated or measured, pressed on a half-plane or layers, in plane strain: it may touch in many strips.

    Parameters
    ----------
    section : CylinderRow, PunchRow, MirroredSection, FormulaSection or MeasuredSection
        The gap between the undeformed bodies across their length.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, PlaneMedium or GradedHalfSpace
        Both bodies: homogeneous, layered (bonded or sliding) or graded with depth. Examples are a CoatedHalfSpace,
        StackedHalfSpace, SlidingFilm, DepthGradedHalfSpace or GradedHalfSpace.
    load : LineForce
        The force per length. For an array the results have its shape.
    alignment : Tilt or LineOfAction, optional
        The tilt (none by default), or the position of the force on a body that is free to tilt.
    elements : int, optional
        Number of positions of the first grid; evenly spaced measured points are used unchanged.

    Raises
    ------
    InvalidInput
        If the force acts beyond the section.

    References
    ----------
    I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1;
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 2.7, 5.8 and 13.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    Two steel rollers of 10 mm radius side by side, 0.5 mm apart, on one carrier under 200 N/mm.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.sections.section import CylinderRow
    >>> steel = Elastic(210e9, 0.3)
    >>> pair = CylinderRow([10e-3, 10e-3], [-0.25e-3, 0.25e-3], [0.0, 0.0])
    >>> pressed = LineProfileContact(pair, HalfSpace.between(steel, steel), LineForce(200e3)).solve()
    >>> pressed.strip_count, round(pressed.contact_length * 1e6, 2)  # micrometres
    (2.0, 415.72)
    """

    __words__ = words(
        section=("", None, "the gap between the undeformed bodies across their length"),
        alignment=("", None, "the tilt, or where the force acts on a body that is free to tilt"),
        elements=("", "", "places of the first grid"),
    )

    section: AnySection
    medium: Annotated[LineMedium, Advice("strips are not implemented for others")]
    load: LineForce[Q]
    alignment: Tilt | LineOfAction = STRAIGHT
    elements: Annotated[int, Whole(64, 20000, "elements")] = 2048

    references: ClassVar[tuple[str, ...]] = ("polonsky_keer_1999", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        _, place = self._aligned
        first, last = self.section.carrying
        if isinstance(self.alignment, LineOfAction) and not first < place < last:
            raise InvalidInput(
                f"LineProfileContact: the force at {place:.6g} m would tip the section over; give a place between "
                f"{first:.6g} m and {last:.6g} m."
            )

    def solve(self) -> LineProfileSolution[Q]:
        """Return the strips.

        Raises
        ------
        OutsideValidity, NotConverged
            If a load is tensile or exceeds the known range of the section; if the strips are not found.
        """
        flat = pressing("LineProfileContact", self.load)
        found = [self._found(force) for force in flat.tolist()]
        still, action = self._aligned
        columns = {
            "tilt": [one.tilt if one else still for one in found],
            "line_of_action": [one.moment / float(np.sum(one.forces)) if one else action for one in found],
            "strip_count": [float(len(one.edges)) if one else 0.0 for one in found],
            "contact_length": [float(np.sum(np.diff(one.edges))) if one else 0.0 for one in found],
            "peak_pressure": [float(np.max(one.peaks)) if one else 0.0 for one in found],
            "strip_error": [one.error if one else 0.0 for one in found],
        }
        shape = np.shape(self.load.force_per_length)
        results: dict[str, Q] = {name: shaped(np.array(column), shape) for name, column in columns.items()}
        return LineProfileSolution(self, shaped(flat, shape), **results)

    @property
    def _aligned(self) -> tuple[float, float]:
        """The tilt and the line of action [m] that are prescribed, zero where they are not."""
        return (self.alignment.tilt, 0.0) if isinstance(self.alignment, Tilt) else (0.0, self.alignment.place)

    def _found(self, force: float) -> FoundStrips | None:
        """Return the strips under a force per length [N/m]; none without one."""
        if force == 0.0:
            return None
        tilt, action = self._aligned
        action = action if isinstance(self.alignment, LineOfAction) else math.nan
        response = response_below(self.medium)
        return find_strips(self.section, Pushed(self.medium.modulus, force, tilt, action, self.elements, response))


@value
class LineProfileSolution(PerLoad[Q]):
    """The solution of a `LineProfileContact`; quantities have the shape of the load.

    Parameters
    ----------
    problem : LineProfileContact
        The problem that was solved.
    force_per_length : float or ndarray
        P [N/m], compression positive.
    tilt : float or ndarray
        theta, positive if the end at positive x is pressed in; zero without contact for a body that is free to tilt.
    line_of_action : float or ndarray
        Where the resultant of the pressures acts [m]; without contact as prescribed, or zero.
    strip_count : float or ndarray
        Number of strips in contact.
    contact_length : float or ndarray
        Sum of their widths [m].
    peak_pressure : float or ndarray
        The maximum pressure [Pa], that of an element if strips were not refined. It is infinite under a sharp crest or
        at a wall.
    strip_error : float or ndarray
        For refined strips: the largest of tension, overlap and residual of the equations, each over its scale. For
        elements: the relative change of contact length and maximum pressure from half as many, or one element per strip
        over all in contact, whichever is greater.
    """

    __words__ = words(tilt=(r"\theta", "rad", "tilt of the body"), edges=("x", "m", "edges of each strip"))

    problem: LineProfileContact[Q]
    force_per_length: Q
    tilt: Q
    line_of_action: Q
    strip_count: Q
    contact_length: Q
    peak_pressure: Q
    strip_error: Q

    per_load: ClassVar[str] = "force_per_length"
    other_axes: ClassVar[tuple[str, ...]] = ("edges", "strip_forces", "strip_peaks")

    @property
    def mean_pressure(self) -> Q:
        """P over the contact length [Pa]; zero without contact."""
        length = np.asarray(self.contact_length)
        return shaped(np.asarray(self.force_per_length) / np.where(length > 0.0, length, 1.0))

    @property
    def refined(self) -> bool:
        """Whether the strips under the maximum load were refined; otherwise they are elements."""
        found = self.problem._found(float(np.max(self.force_per_length)))
        return found is not None and found.refined

    @property
    def edges(self) -> Array:
        """Left and right edge of each strip under one load [m], (n, 2)."""
        return found.edges if (found := self._one("edges")) else np.zeros((0, 2))

    @property
    def strip_forces(self) -> Array:
        """Force per length of each strip under one load [N/m], (n,)."""
        return found.forces if (found := self._one("strip_forces")) else np.zeros(0)

    @property
    def strip_peaks(self) -> Array:
        """The maximum pressure of each strip under one load [Pa], (n,)."""
        return found.peaks if (found := self._one("strip_peaks")) else np.zeros(0)

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure under one load [Pa], zero outside the strips.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m].

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        """
        found, place = self._one("pressure"), finite_places("LineProfileSolution.pressure", "x", x)
        return found.pressure(place) if found else np.zeros(place.shape)

    def separation(self, x: ArrayLike) -> Array:
        """Return the distance of the deformed surfaces under one load [m], zero on the strips.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m].

        Raises
        ------
        InvalidInput, OutsideValidity
            If the solution has more than one load; if there is no contact, or a place is beyond the section.
        """
        found, place = self._one("separation"), finite_places("LineProfileSolution.separation", "x", x)
        if found is None:
            raise OutsideValidity("The bodies do not touch, so their distance is open; press harder.")
        known = self.problem.section.pads or ((self.problem.section.start, self.problem.section.end),)
        outside = ~np.any([(place >= start) & (place <= end) for start, end in known], axis=0)
        if outside.any():
            raise OutsideValidity(
                f"At {place[outside].flat[0]:.6g} m the section has no surface, or none that is known; request places "
                "on it."
            )
        return found.gap(place)

    def stresses(self, x: ArrayLike, z: ArrayLike, friction: float = 0.0) -> LineFields:
        """Return the stresses below the surface under one load.

        Parameters
        ----------
        x, z : array_like
            Positions along the surface [m], and depths [m] in one body, as in `LineSolution.stresses`.
        friction : float
            mu [-] for full sliding: the traction on the body along x is mu p.

        Raises
        ------
        InvalidInput, OutsideValidity
            If there are many loads, the depths lie in both bodies, or the body has no stresses.
        """
        place, depth = common_places("LineProfileSolution.stresses", x=x, z=z)
        below = in_first_body(depth, "LineProfileSolution")
        friction = one_coefficient("LineProfileSolution", friction)
        found = self._one("stresses")
        if found is None:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        return strip_fields(self.problem.medium, found, place, depth, below, friction)

    def at(self, index: int | tuple[int, ...]) -> LineProfileSolution[float]:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Index of the load; an error is raised if it does not exist.
        """
        names = [field.name for field in dataclasses.fields(self)[1:]]
        results = one_of(index, *(getattr(self, name) for name in names))
        given = self.problem
        one = LineProfileContact(given.section, given.medium, LineForce(results[0]), given.alignment, given.elements)
        return LineProfileSolution(one, *results)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: section, strips, slopes, yield."""
        found = self.problem._found(float(np.max(self.force_per_length)))
        return profile_notes(self.problem.section, self.problem.medium, found, float(np.max(self.strip_error)))

    def _one(self, requested: str) -> FoundStrips | None:
        return self.problem._found(single(self.force_per_length, requested))
