"""The surface compliances of a body graded in depth for tractions along and across a wave."""

from __future__ import annotations

import numpy as np

from winkler.materials.depth_grading import DepthGrading
from winkler.materials.elastic import RIGID, Solid
from winkler.media.layered.depth_recursion import surface_compliance, surface_compliance_across
from winkler.media.layered.depth_response import DepthResponse, cells_of, solid_at
from winkler.media.layered.shear_responses import across_modulus, along_modulus
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["AcrossDepthResponse", "AlongDepthResponse"]


@value
class AlongDepthResponse(DepthResponse):
    """The response to a shear traction along its wave, as that of `AlongResponse`."""

    grading: DepthGrading
    second: Solid = RIGID
    tolerance: float = 1e-6

    @property
    def modulus(self) -> float:
        """m_L [Pa] of the surface and the second body."""
        return along_modulus(solid_at(self.grading), self.second)

    @property
    def _share(self) -> float:
        return self.modulus / along_modulus(solid_at(self.grading))

    def _own(self, xi: ComplexArray) -> ComplexArray:
        top = solid_at(self.grading)
        along = -surface_compliance(cells_of(self.grading, self.tolerance), xi)[0]
        return np.asarray(along * top.shear / (1.0 - top.poisson) - 1.0)


@value
class AcrossDepthResponse(DepthResponse):
    """The response to a shear traction across its wave, as that of `AcrossResponse`."""

    grading: DepthGrading
    second: Solid = RIGID
    tolerance: float = 1e-6

    @property
    def modulus(self) -> float:
        """m_T = 2 G_t [Pa] of the surface and the second body."""
        return across_modulus(solid_at(self.grading), self.second)

    @property
    def _share(self) -> float:
        return self.modulus / across_modulus(solid_at(self.grading))

    def _own(self, xi: ComplexArray) -> ComplexArray:
        across = surface_compliance_across(cells_of(self.grading, self.tolerance), xi)
        return np.asarray(across * solid_at(self.grading).shear - 1.0)
