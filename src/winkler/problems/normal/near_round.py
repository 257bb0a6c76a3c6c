r"""Bodies that are nearly round: force and contour of the contact, from the springs of every direction.

Along the direction phi the profile f(r, phi) has its own :math:`g_\varphi(x)`.  Betti's theorem with the pressure of a
nearly round flat punch (Fabrikant), and the largest force among all contours (Barber), give

.. math:: F = 2E^*\frac{\langle a I\rangle}{\langle a\rangle} , \qquad I = \int_0^a(d-g_\varphi)\,\mathrm dx , \qquad
          I + a\,(d-g_\varphi(a)) = \frac{F}{2E^*} \text{ in every direction} ,

with means over the directions; for round bodies the last equation is g(a) = d.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.field_checks import Condition
from winkler.errors import InvalidInput
from winkler.loading import Depth, Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.roots import invert
from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.near_round_contour import Directions
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.validity import steepness_note
from winkler.profiles.profile import Profile
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["NearlyRoundIndentation", "NearlyRoundSolution"]

OVAL_RATIO = 1.5
"""Ratio of the largest to the smallest radius beyond which the contour is off by some per cent.

Where it would be more than about 3 the equations have no solution any more.
"""
MEASURED = "exact ellipses, and boundary elements for pyramids and a square"


PRESSED_TOGETHER = Condition(
    lambda load: bool(np.all((load.force if isinstance(load, Force) else load.depth) > 0.0)),
    "give a positive Force or Depth, or an array of them",
)


@value
class NearlyRoundIndentation:
    """A body that is nearly one of revolution, pressed into a half-space.

    Parameters
    ----------
    profiles : tuple of Profile
        The profile along equally spaced directions, around the axis.
    medium : HalfSpace
        Both bodies, homogeneous.
    load : Force or Depth
        What is prescribed, positive; its value may be an array.

    Raises
    ------
    InvalidInput
        If there are fewer than four directions, the medium is not homogeneous, or a load is not positive.

    References
    ----------
    V. L. Popov, Symmetry 14 (2022) 390, doi:10.3390/sym14020390

    Examples
    --------
    An elliptic paraboloid 0.4 x^2 + 0.6 y^2, E* = 1: exactly F = (4/3) 1.0276201^(1/2) d^(3/2).

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> turns = np.arange(32) * 2.0 * np.pi / 32
    >>> bends = 0.4 * np.cos(turns) ** 2 + 0.6 * np.sin(turns) ** 2
    >>> body = tuple(Paraboloid(float(0.5 / bend)) for bend in bends)
    >>> oval = NearlyRoundIndentation(body, HalfSpace(Elastic(1.0, 0.0)), Depth(0.01)).solve()
    >>> round(oval.force / (4.0 / 3.0 * 1.0276201**0.5 * 0.01**1.5) - 1.0, 4)
    0.0
    """

    __words__ = words(profiles=("", None, "the profile along equally spaced directions"))

    profiles: tuple[Profile, ...]
    medium: HomogeneousMedium
    load: Annotated[Force | Depth, PRESSED_TOGETHER]

    references: ClassVar[tuple[str, ...]] = ("popov_2022", "barber_1974", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        if len(self.profiles) < 4:
            raise InvalidInput(
                "NearlyRoundIndentation: profiles must be at least four, one for each of equally spaced directions."
            )

    @property
    def _prescribed(self) -> Array:
        return np.asarray(self.load.force if isinstance(self.load, Force) else self.load.depth, dtype=float)

    def solve(self) -> NearlyRoundSolution:
        """Return force, depth and contour.

        Raises
        ------
        OutsideValidity
            If the body is so far from round, or known so little of, that there is no contour.
        NotConverged
            If the force does not settle.
        """
        prescribed = self._prescribed
        springs = Directions(self.profiles, self.medium)
        if isinstance(self.load, Force):
            forces = prescribed.ravel()
            depths = invert(
                lambda d: springs.pressed(d)[:2], forces, lower=0.0, upper=math.inf, guess=springs.shallow(forces)
            )
            _, stiffness, contours = springs.pressed(depths)
        else:
            depths = prescribed.ravel()
            forces, stiffness, contours = springs.pressed(depths)

        return NearlyRoundSolution(
            self,
            shaped(depths, prescribed.shape),
            shaped(forces, prescribed.shape),
            shaped(stiffness, prescribed.shape),
            contours.reshape((*prescribed.shape, -1)),
        )


@value
class NearlyRoundSolution:
    """The solution of a `NearlyRoundIndentation`; quantities have the shape of the depth.

    Parameters
    ----------
    problem : NearlyRoundIndentation
        The problem that was solved.
    depth : float or ndarray
        d [m].
    force : float or ndarray
        F_N [N].
    stiffness : float or ndarray
        dF/dd [N/m], of a flat punch of this contour.
    contour : ndarray, (..., n)
        Radius of the contact [m] in every direction.
    """

    problem: NearlyRoundIndentation
    depth: Quantity
    force: Quantity
    stiffness: Quantity
    contour: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        ratio = float(np.max(np.max(self.contour, axis=-1) / np.min(self.contour, axis=-1)))
        if ratio <= OVAL_RATIO:
            accuracy = "forces within 0.1 and radii within 1 per cent of ellipses; of bodies with edges within 2 and 7"
        else:
            accuracy = "forces within 4, areas and radii within 15 per cent of ellipses and pyramids like this"
        note = Note(
            Assumption.RESPONSE,
            Standing.APPROXIMATE,
            f"The widest radius of the contact is {ratio:.3g} times the smallest: {accuracy}.",
            MEASURED,
        )
        slope = 0.0
        for profile, radii in zip(self.problem.profiles, np.moveaxis(self.contour, -1, 0), strict=True):
            inside = np.ravel(radii)[:, np.newaxis] * np.linspace(0.0, 1.0, 17)[1:-1]
            slope = max(slope, float(np.max(np.abs(profile.slope(inside)))))
        medium = self.problem.medium
        yielding = unknown_yield(medium, "the stresses under a contact that is not round are not computed")
        return (*medium.notes, steepness_note(slope), note, *yielding)
