r"""The greatest stresses inside the bodies of an elastic contact, of each kind, and how deep they lie.

The shear stress in planes along the surface, at :math:`x\ne0`, turns its sign as a contact rolls by: Lundberg and
Palmgren rate the life of bearings by it.  Of Hertz's ellipse that rolls along the semi-axis b, with the other one a,

.. math:: \tau_0 = p_0\,\frac{\sqrt{2t-1}}{2t(t+1)} , \qquad z_0 = \frac{b}{(t+1)\sqrt{2t-1}} , \qquad
          \frac ba = \sqrt{(t^2-1)(2t-1)} ,

:math:`p_0/4` at half the half-width below a line contact.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.interior import tensor
from winkler.media.layered.depth_response import solid_at
from winkler.media.offers import GradedInDepth, LayerStack, PowerOfDepth, offers
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.greatest_stress import in_strip
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line.layered_stress import greatest_in_part
from winkler.problems.line.peak_pressure import is_sharp, rim_load
from winkler.problems.line.stress import Strip
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.onset.ellipse_in_layers import EllipseInLayers, refuse_slender, sum_error
from winkler.problems.normal.onset.part_onset import NAME
from winkler.problems.normal.strong_parts import StrongPart, elastic_parts
from winkler.problems.one_load import single
from winkler.problems.subsurface.below_disc import NO_CONTACT, Deepest, Search, below_disc
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, standing_of
from winkler.values.value import value, words

FINE, COARSE = 0.05, 0.2
"""Error of stresses up to which they count as fine, and as coarse."""


@value
class ContactStress:
    """The maximum stresses inside the bodies of a frictionless contact, and their depths.

    Parameters
    ----------
    contact : Indentation, EllipticIndentation or LineIndentation
        The frictionless contact under one load, of homogeneous bodies or layers, all isotropic. An Indentation also
        supports transversely isotropic bodies and layers, a GradedHalfSpace, and a DepthGradedHalfSpace, whose graded
        body is one part.

    Raises
    ------
    InvalidInput
        If the contact has several loads, or the medium is another one.

    References
    ----------
    G. Lundberg, A. Palmgren, Acta Polytech. Mech. Eng. Ser. 1 (1947) no. 3; K. L. Johnson, Contact Mechanics, Cambridge
    1985, sec. 3.4 and 4.1, doi:10.1017/CBO9781139171731

    Examples
    --------
    A bearing ball in its groove, where it rolls: the shear stress along the surface over the greatest pressure.

    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> steel = Elastic(208e9, 0.3)
    >>> groove = EllipticIndentation(CurvedBodies(3.77e-3, 124e-3), HalfSpace.between(steel, steel), Force(500.0))
    >>> found = ContactStress(groove).solve()
    >>> round(found.orthogonal_shear / found.peak_pressure, 4), round(found.orthogonal_shear_depth * 1e6, 1)  # um
    (0.2493, 58.7)
    """

    __words__ = words(contact=("", None, "how the bodies are pressed"))

    contact: Indentation[float] | EllipticIndentation[float] | LineIndentation[float]

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        medium = self.medium
        known = (GradedInDepth, LayerStack, PowerOfDepth)
        if not (isinstance(medium, HomogeneousMedium) or any(offers(medium, each) for each in known)):
            raise InvalidInput(
                f"ContactStress: the medium is a {type(medium).__name__}; maximum stresses are implemented for "
                "homogeneous bodies, layers and graded bodies only. Give a HalfSpace, a "
                "TransverselyIsotropicHalfSpace, a GradedHalfSpace, a CoatedHalfSpace, a SlidingFilm, a "
                "StackedHalfSpace or a DepthGradedHalfSpace."
            )
        if offers(medium, PowerOfDepth) and medium.exponent < 0.0:
            raise InvalidInput(
                f"ContactStress: the exponent of the GradedHalfSpace is {medium.exponent:g}; below zero the modulus is "
                "infinite at the surface, and with it the stress along the surface. Give an exponent from zero on, or "
                "a DepthGradedHalfSpace."
            )
        isotropic = all(isinstance(part.solid, Elastic) for part in elastic_parts(medium))
        if not (isinstance(self.contact, Indentation) or (isotropic and not offers(medium, GradedInDepth))):
            raise InvalidInput(
                f"ContactStress: the contact is a {type(self.contact).__name__} on a {type(medium).__name__}; in "
                "graded and in transversely isotropic bodies the maximum stresses are sought under round contacts "
                "only. Give an Indentation, or isotropic bodies and layers."
            )

    @property
    def medium(self) -> object:
        """Both bodies."""
        return self.contact.medium if isinstance(self.contact, EllipticIndentation) else self.contact.bed.medium

    def solve(self) -> ContactStressSolution:
        """Return the maximum stresses of each kind.

        Raises
        ------
        InvalidInput
            If the contact has several loads.
        OutsideValidity
            If the bodies do not touch, the stress is infinite at a sharp edge or apex, or an ellipse on layers is too
            slender.
        NotConverged
            If the pressures on layers are not found.
        """
        contact = self.contact.solve()
        find = _search(contact)
        kinds = [*tensor.KINDS]
        if isinstance(contact, EllipticSolution):
            along = contact.longitudinal_semi_axis >= contact.lateral_semi_axis
            kinds.append(tensor.longitudinal_shear if along else tensor.lateral_shear)
        rows, error = [], 0.0
        for number, part in enumerate(_parts(self.medium), 1):
            found = [find(part, kind) for kind in kinds]
            if isinstance(contact, IndentationSolution):
                found.append(found[-1])
            elif isinstance(contact, LineSolution):
                found.append(_along_cylinder(contact, found[-1]))
            error = max(error, *(one.error for one in found))
            rows.append(PartStress(number, part.name, *(number for one in found for number in one[:2])))
        overall: dict[str, float] = {}
        for kind in ("von_mises", "max_shear", "orthogonal_shear", "long_axis_shear"):
            overall[kind], overall[f"{kind}_depth"] = _greatest(rows, kind)
        return ContactStressSolution(self, contact, **overall, parts=tuple(rows), stress_error=error)


@value
class PartStress:
    """The greatest stresses of one body, layer or base; depths are below zero in the second body.

    Parameters
    ----------
    part : int
        Which of the parts that deform it is, from the uppermost layer of the first body down, 1 the first.
    name : str
        Name of the part.
    von_mises, von_mises_depth, max_shear, max_shear_depth, orthogonal_shear, orthogonal_shear_depth : float
        [Pa] and [m], as in `ContactStressSolution`.
    long_axis_shear, long_axis_shear_depth : float
        [Pa] and [m], the same.
    """

    __words__ = words(part=("", "", "number of the part from the surface of the first body down"), name=NAME)

    part: int
    name: str
    von_mises: float
    von_mises_depth: float
    max_shear: float
    max_shear_depth: float
    orthogonal_shear: float
    orthogonal_shear_depth: float
    long_axis_shear: float
    long_axis_shear_depth: float


@value
class ContactStressSolution:
    """The solution of `ContactStress`; depths are negative if the second body has the maximum stress.

    Parameters
    ----------
    problem : ContactStress
        The problem that was solved.
    contact : IndentationSolution, EllipticSolution or LineSolution
        The contact.
    von_mises, von_mises_depth : float
        Maximum von Mises stress [Pa], and its depth [m].
    max_shear, max_shear_depth : float
        Maximum shear stress [Pa], half the difference of the extreme principal stresses, and its depth [m].
    orthogonal_shear, orthogonal_shear_depth : float
        Maximum shear stress on planes parallel to the surface [Pa], and its depth [m]; for an ellipse the component
        along the shorter axis.
    long_axis_shear, long_axis_shear_depth : float
        The same along the longer semi-axis, for a contact that rolls along it. For a round contact the values are
        equal; for a line contact the stress is zero and the depth is the half-width (limit of long ellipses on
        half-spaces).
    parts : tuple of PartStress
        The same values for each deformable body, layer and base, in order from the uppermost layer of the first body
        down.
    stress_error : float
        Relative error of the stresses of an ellipse on layers, due to pixels and sums over waves; zero for other
        contacts.
    """

    __words__ = words(
        contact=("", None, "the contact"),
        parts=("", None, "greatest stresses of each body, layer and base"),
        stress_error=("", "", "relative error of the stresses that pixels and sums over waves leave"),
    )

    problem: ContactStress
    contact: IndentationSolution[float] | EllipticSolution[float] | LineSolution[float]
    von_mises: float
    von_mises_depth: float
    max_shear: float
    max_shear_depth: float
    orthogonal_shear: float
    orthogonal_shear_depth: float
    long_axis_shear: float
    long_axis_shear_depth: float
    parts: tuple[PartStress, ...]
    stress_error: float

    @property
    def peak_pressure(self) -> float:
        """p_0 [Pa], the maximum pressure."""
        return float(self.contact.peak_pressure)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, and the errors due to pixels and sums over waves."""
        if self.stress_error == 0.0:
            return self.contact.validity
        summed = Note(
            Assumption.RESOLUTION,
            standing_of(self.stress_error, FINE, COARSE),
            "Stresses below an ellipse on layers are sums over pixels and waves. The maximum error over all "
            f"kinds and parts is {self.stress_error:.1g}.",
            "comparison of two grids",
        )
        return (*self.contact.validity, summed)


def _parts(medium: object) -> tuple[StrongPart, ...]:
    """Return the parts in which stresses are sought; a graded body is one, of the solid at its surface."""
    graded = (StrongPart("graded body", solid_at(medium.grading), True),) if offers(medium, GradedInDepth) else ()
    return (*graded, *elastic_parts(medium))


def _greatest(rows: list[PartStress], kind: str) -> tuple[float, float]:
    """Return the greatest stress of a kind of all parts [Pa], and its depth [m]."""
    worst = max(rows, key=lambda row: float(getattr(row, kind)))
    return getattr(worst, kind), getattr(worst, f"{kind}_depth")


def _search(contact: IndentationSolution | EllipticSolution | LineSolution) -> Search:
    """Return what finds the greatest stress of a kind in a part below one contact."""
    if isinstance(contact, IndentationSolution):
        return below_disc(contact)
    if isinstance(contact, LineSolution):
        return _below_strip(contact)
    return _below_ellipse(contact)


def _below_ellipse(contact: EllipticSolution) -> Search:
    problem = contact.problem
    if isinstance(problem.medium, HalfSpace):

        def find(part: StrongPart, measure: tensor.Measure) -> Deepest:
            spot = contact.greatest_stress(measure=measure.__name__, below=part.first)
            return Deepest(spot.value, spot.z if part.first else -spot.z)

        return find
    force = float(single(contact.force, "stresses"))
    if force == 0.0:
        raise OutsideValidity(NO_CONTACT)
    bodies = problem.bodies.together
    axes = bodies.semi_axes(1.0, 1.0)
    refuse_slender("ContactStress", "take a LineIndentation of its middle", (float(axes[0]), float(axes[1])))
    inside = EllipseInLayers(bodies, problem.medium, (0.0, 0.0))

    def find_in_layers(part: StrongPart, measure: tensor.Measure) -> Deepest:
        fine, coarse = (inside.greatest(force, part, measure, coarse=coarse) for coarse in (False, True))
        return Deepest(fine.value, fine.z, sum_error(coarse.value, fine.value))

    return find_in_layers


def _below_strip(contact: LineSolution) -> Search:
    """Return the search below the strip of a line contact under one load, that touches and is nowhere sharp."""
    force, bed = float(single(contact.force_per_length, "stresses")), contact.problem.bed
    if force == 0.0:
        raise OutsideValidity(NO_CONTACT)
    half_width = float(contact.half_width)
    edge_load = rim_load(bed, force, half_width)
    if is_sharp(bed, half_width, edge_load):
        raise OutsideValidity("ContactStress: the stress below a sharp tip, kink or rim is infinite; round it off.")

    def find(part: StrongPart, measure: tensor.Measure) -> Deepest:
        deep = greatest_in_part(bed, Strip(half_width, edge_load), part, 0.0, measure=in_strip(measure))
        return Deepest(deep.value, deep.z)

    return find


def _along_cylinder(contact: LineSolution, across: Deepest) -> Deepest:
    """Return the shear stress along a cylinder, none, at the depth where that of long ellipses is the greatest."""
    return Deepest(0.0, float(np.copysign(contact.half_width, across.depth)))
