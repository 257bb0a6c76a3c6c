r"""Half-spaces whose stiffness changes with depth by any law, to a stated tolerance.

A stiffness k(a) is a least energy, so it rises wherever the compliance falls: if two bodies differ in
:math:`C(\xi)` by less than a part :math:`\varepsilon` at every wave number, every k(a) differs by less than
:math:`\varepsilon`.  The body is cut into cells until C moves by less than the tolerance
(`winkler.media.layered.depth_recursion`); they get thinner towards the surface, in proportion to the depth, because
narrow contacts feel the very top alone.
"""

from __future__ import annotations

from typing import Annotated

from winkler.materials.depth_grading import DepthGrading
from winkler.materials.elastic import RIGID, Solid
from winkler.media.layered import depth_interior
from winkler.media.layered.coated import LayeredMedium
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.depth_response import DepthResponse, GradedBody
from winkler.media.layered.pair_response import Mode
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import between
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

LEAST_TOLERANCE, LARGEST_TOLERANCE = 1e-7, 1e-2


@value
class DepthGradedHalfSpace(LayeredMedium):
    """A half-space graded in depth, against a homogeneous body.

    Parameters
    ----------
    grading : ExponentialGrading, SigmoidalGrading, TabulatedGrading or another DepthGrading
        E(z) and nu(z), constant far below.
    second : Elastic or Rigid, optional
        The other body; rigid by default.
    tolerance : float, optional
        Relative error of every k(a), between 1e-7 and 1e-2.

    Raises
    ------
    InvalidInput
        If something is not of these kinds.
    NotConverged
        When a result is computed: if 3000 cells more than breaks would be needed.

    Examples
    --------
    >>> import numpy as np
    >>> from winkler.materials.depth_grading import ExponentialGrading
    >>> medium = DepthGradedHalfSpace(ExponentialGrading(1e9, 3e9, depth_scale=1e-3, poisson=0.3))
    >>> round(float(medium.punch_stiffness(np.array(1e-3)) / (2.0 * medium.modulus * 1e-3)), 5)
    2.06285
    """

    __words__ = words(tolerance=(r"\epsilon", "", "relative error that is allowed in every stiffness"))

    grading: DepthGrading
    second: Solid = RIGID
    tolerance: Annotated[float, between(LEAST_TOLERANCE, LARGEST_TOLERANCE)] = 1e-6

    def responding(self, mode: Mode) -> DepthResponse:
        """The response of the pair to a load."""
        return DepthResponse(mode, GradedBody(self.grading, self.tolerance), self.second)

    @property
    def thickness(self) -> float:
        """Depth below which the grading is constant within the tolerance [m]."""
        return self.grading.settled_at(self.tolerance)

    def inside(self, load: CarriedLoad, r: Array, z: Array) -> BodyField:
        """Stresses and displacements in the graded body; arrays of one shape."""
        return depth_interior.field(load, self.grading, self.tolerance, self.modulus, r, z)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is assumed."""
        return (
            Note(
                Assumption.RESPONSE,
                Standing.ASYMPTOTIC,
                "The graded body is divided into thin cells in depth; the relative error of every contact "
                f"stiffness k(a) is at most {self.tolerance:.0e}. The contact is assumed frictionless, and "
                "the body isotropic and linear elastic.",
                "refinement of the cells until the surface compliance moves by less",
            ),
        )
