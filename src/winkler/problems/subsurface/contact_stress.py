r"""The greatest stresses inside the bodies of an elastic contact, of each kind, and how deep they lie.

The shear stress in planes along the surface, at :math:`x\ne0`, turns its sign as a contact rolls by: Lundberg and
Palmgren rate the life of bearings by it.  Of Hertz's ellipse that rolls along the semi-axis b, with the other one a,

.. math:: \tau_0 = p_0\,\frac{\sqrt{2t-1}}{2t(t+1)} , \qquad z_0 = \frac{b}{(t+1)\sqrt{2t-1}} , \qquad
          \frac ba = \sqrt{(t^2-1)(2t-1)} ,

:math:`p_0/4` at half the half-width below a line contact.
"""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import tensor
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.greatest_stress import greatest, in_strip
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.stress import LineContact
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.greatest_stress import greatest_stress
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.strong_parts import solid_parts
from winkler.problems.one_load import single
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["ContactStress", "ContactStressSolution"]


class _Greatest(NamedTuple):
    """A stress [Pa], and how deep it is the greatest [m], below zero in the second body."""

    value: float
    depth: float


@value
class ContactStress:
    """The greatest stresses inside the bodies of a contact that is pressed without friction, and how deep they lie.

    Parameters
    ----------
    contact : Indentation, EllipticIndentation or LineIndentation
        How the bodies are pressed, by one load: homogeneous, isotropic ones.

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

    >>> from winkler.loading import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> steel = Elastic(208e9, 0.3)
    >>> groove = EllipticIndentation(CurvedBodies(3.77e-3, 124e-3), HalfSpace.between(steel, steel), Force(500.0))
    >>> found = ContactStress(groove).solve()
    >>> round(found.orthogonal_shear / found.peak_pressure, 4), round(found.orthogonal_shear_depth * 1e6, 1)  # um
    (0.2493, 58.7)
    """

    __words__ = words(contact=("", None, "how the bodies are pressed"))

    contact: Indentation | EllipticIndentation | LineIndentation

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        medium = self.contact.medium if isinstance(self.contact, EllipticIndentation) else self.contact.bed.medium
        if not isinstance(medium, HalfSpace):
            raise InvalidInput(
                f"ContactStress: the medium is a {type(medium).__name__}; the greatest stresses are sought "
                "in homogeneous, isotropic bodies only: give a HalfSpace; for layers see YieldOnset and LineYieldOnset."
            )

    def solve(self) -> ContactStressSolution:
        """Return the greatest stresses of each kind.

        Raises
        ------
        InvalidInput
            If the contact has several loads.
        OutsideValidity
            If the bodies do not touch, or the stress is infinite at a sharp place.
        """
        contact = self.contact.solve()
        kinds = (tensor.von_mises, tensor.max_shear, tensor.orthogonal_shear)
        found = [_greatest(contact, kind) for kind in kinds]
        found.append(_along_longer(contact, found[-1]))
        return ContactStressSolution(self, contact, *(number for each in found for number in each))


@value
class ContactStressSolution:
    """The solution of `ContactStress`; depths are below zero in the second body, if it is the more stressed one.

    Parameters
    ----------
    problem : ContactStress
        The problem that was solved.
    contact : IndentationSolution, EllipticSolution or LineSolution
        The contact.
    von_mises, von_mises_depth : float
        Greatest von Mises stress [Pa], and where [m].
    max_shear, max_shear_depth : float
        Greatest shear stress [Pa], half the difference of the outermost principal stresses, and where [m].
    orthogonal_shear, orthogonal_shear_depth : float
        Greatest shear stress in planes along the surface [Pa], and where [m]: of an ellipse along its shorter axis.
    long_axis_shear, long_axis_shear_depth : float
        The same along the longer semi-axis, as of a contact that rolls that way; of a round contact the same, of a
        line contact zero, and the depth that of long ellipses: the half-width.
    """

    __words__ = words(contact=("", None, "the contact"))

    problem: ContactStress
    contact: IndentationSolution | EllipticSolution | LineSolution
    von_mises: float
    von_mises_depth: float
    max_shear: float
    max_shear_depth: float
    orthogonal_shear: float
    orthogonal_shear_depth: float
    long_axis_shear: float
    long_axis_shear_depth: float

    @property
    def peak_pressure(self) -> float:
        """p_0 [Pa], the greatest pressure."""
        return float(self.contact.peak_pressure)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: that of the contact."""
        return self.contact.validity


def _greatest(contact: IndentationSolution | EllipticSolution | LineSolution, measure: tensor.Measure) -> _Greatest:
    """Return the greatest stress of a kind in both bodies."""
    found = []
    if isinstance(contact, IndentationSolution):
        pressed = contact.pressed
        if pressed.radius == 0.0:
            raise OutsideValidity("ContactStress: the bodies do not touch, so there are no stresses; press harder.")
        for part in solid_parts(pressed.bed.medium):
            place = greatest_stress(pressed, part, measure=measure)
            if place.sharp:
                raise OutsideValidity(f"ContactStress: {place.sharp}; round it off, or restore the fields beside it.")
            found.append(_Greatest(place.value, place.z if part.first else -place.z))
    elif isinstance(contact, EllipticSolution):
        for part in solid_parts(contact.problem.medium):
            spot = contact.greatest_stress(measure=measure.__name__, below=part.first)
            found.append(_Greatest(spot.value, spot.z if part.first else -spot.z))
    else:
        strip = _strip(contact)
        for part in solid_parts(contact.problem.bed.medium):
            deep = greatest(strip._replace(poisson=part.solid.poisson), in_strip(measure))
            found.append(_Greatest(deep.value, deep.z if part.first else -deep.z))
    return max(found, key=lambda one: one.value)


def _strip(contact: LineSolution) -> LineContact:
    """Return the strip of a line contact under one load, that touches and is nowhere sharp."""
    force, bed = single(contact.force_per_length, "stresses"), contact.problem.bed
    assert isinstance(bed, LineFoundation)  # on a HalfSpace
    if force == 0.0:
        raise OutsideValidity("ContactStress: the bodies do not touch, so there are no stresses; press harder.")
    if not np.isfinite(contact.peak_pressure):
        raise OutsideValidity("ContactStress: the stress below a sharp tip, kink or rim is infinite; round it off.")
    half_width = float(contact.half_width)
    return LineContact(bed, half_width, rim_load(bed, force, half_width), 0.0, 0.0)


def _along_longer(contact: IndentationSolution | EllipticSolution | LineSolution, shorter: _Greatest) -> _Greatest:
    """Return the greatest shear stress in planes along the surface along the longer semi-axis."""
    if isinstance(contact, EllipticSolution):
        along = contact.longitudinal_semi_axis >= contact.lateral_semi_axis
        return _greatest(contact, tensor.longitudinal_shear if along else tensor.lateral_shear)
    if isinstance(contact, LineSolution):
        return _Greatest(0.0, float(np.copysign(contact.half_width, shorter.depth)))
    return shorter
