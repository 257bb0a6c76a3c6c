r"""The surface compliance of a body graded in depth, as a function of the wave number.

The uppermost cell is homogeneous, and so thin that across it E changes by less than half of the tolerance: a stiffness is
a least energy, and moves by no more.  So M dies out like :math:`e^{-2\xi\delta}` with the thickness :math:`\delta` of that
cell.  Above the length over which the surface changes it falls like :math:`A/\xi`, and the kernel has a logarithm that
is rounded off over :math:`\delta`.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.materials.depth_grading import DepthGrading
from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.media.layered.depth_recursion import (
    Mesh,
    mesh,
    surface_compliance,
    surface_compliance_across,
    surface_depth,
)
from winkler.media.layered.pair_response import MODE_WORDS, Mode, WavePair
from winkler.media.layered.wave_constants import Wave, half_space_compliance, in_plane_share
from winkler.numerics.caching import cached_by_value
from winkler.numerics.transforms.cosine_transform import on_axis
from winkler.numerics.types import Array, ComplexArray
from winkler.validity import Standing
from winkler.values import value

__all__ = [
    "DepthResponse",
    "GradedBody",
    "cells_of",
    "solid_at",
]

THINNEST_TOP, THICKEST_TOP = 1e-9, 1e-2
"""Of the uppermost cell, over the depth across which the surface changes."""
TOP_SAMPLES = 71
FAR = 1e3
"""Where a grading is what it is far below, over the depth at which it has settled."""

def solid_at(grading: DepthGrading, depth: float = 0.0) -> Elastic:
    """Return the solid at a depth [m]."""
    z = np.array(depth)
    return Elastic(float(grading.young_at(z)), float(grading.poisson_at(z)))


@cached_by_value(128)
def top_cell(grading: DepthGrading, tolerance: float) -> float:
    """Return the greatest depth [m] down to which the moduli are those of the surface to half of the tolerance."""
    depths = surface_depth(grading) * np.geomspace(THICKEST_TOP, THINNEST_TOP, TOP_SAMPLES)
    at = np.append(0.0, depths)
    young, poisson = np.log(grading.young_at(at)), grading.poisson_at(at)
    change = np.abs(young[1:] - young[0]) + 4.0 * np.abs(poisson[1:] - poisson[0])
    return float(depths[min(int(np.sum(change > 0.5 * tolerance)), depths.size - 1)])


def cells_of(grading: DepthGrading, tolerance: float) -> Mesh:
    """Return the cells of a body for all wave numbers."""
    thinnest = top_cell(grading, tolerance)
    return mesh(grading, tolerance, thinnest, top=thinnest)


@value
class GradedBody:
    """A body graded in depth, cut into cells.

    Parameters
    ----------
    grading : DepthGrading
        A value.
    tolerance : float
        Relative error of its compliances.
    """

    grading: DepthGrading
    tolerance: float = 1e-6

    def waves(self, part: Wave, xi: ComplexArray) -> ComplexArray:
        """Compliance times xi / 2 [1/Pa] at real or complex wave numbers (m,) [1/m]."""
        cells = cells_of(self.grading, self.tolerance)
        if part is Wave.ACROSS:
            return np.asarray(0.5 * surface_compliance_across(cells, xi))
        along, mixed, normal = surface_compliance(cells, xi)
        return in_plane_share(part, (along, mixed, mixed, normal))

    def short(self, part: Wave) -> float:
        """The limit of `waves` for short waves [1/Pa]."""
        return half_space_compliance(self.top, part)

    @property
    def top(self) -> Elastic:
        """The solid at the surface."""
        return solid_at(self.grading)

    @property
    def on(self) -> Elastic:
        """The solid far below."""
        return solid_at(self.grading, FAR * self.grading.settled_at(self.tolerance))

    @property
    def in_plane(self) -> tuple[Standing, str]:
        """What is assumed of it in plane strain."""
        return (
            Standing.ASYMPTOTIC,
            "A linear elastic, isotropic body graded with depth, in plane strain under normal load: the Fourier "
            f"response of cells so thin that it is known to {self.tolerance:.0e}",
        )

    @property
    def unit(self) -> tuple[float, float]:
        """Modulus at the surface [Pa], and the depth over which it changes there [m]."""
        return self.top.young, surface_depth(self.grading)


@value
class DepthResponse(WavePair):
    """The response of a graded body and its counterpart.

    Parameters
    ----------
    mode : Mode
        The load.
    first : GradedBody
        The graded one.
    second : Elastic or Rigid
        The other body, a homogeneous half-space.
    """

    __words__ = MODE_WORDS

    mode: Mode
    first: GradedBody
    second: Solid = RIGID

    compressed = math.inf
    """The limit of (1 + M) / xi for long waves: the body is a half-space."""

    @functools.cached_property
    def length(self) -> float:
        """Delta [m]: M tends to zero like exp(-2 xi length)."""
        return top_cell(self.first.grading, self.first.tolerance)

    @functools.cached_property
    def span(self) -> float:
        """Length [m] beyond which the body is what it is far below."""
        depths = np.geomspace(
            1e-3 * surface_depth(self.first.grading), self.first.grading.settled_at(self.first.tolerance), 200
        )
        young = self.first.grading.young_at(depths)
        return float(depths[-1] * np.max(young) / np.min(young))

    @functools.cached_property
    def smooth(self) -> float:
        """The kernel is smooth on this length [m], but for its logarithm."""
        return max(0.5 * surface_depth(self.first.grading), self.length)

    @property
    def precision(self) -> float:
        """How smooth M is, relative to one."""
        return 1e-3 * self.first.tolerance

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return np.asarray(self._share * self._exceeding(xi))

    def whole(self, xi: Array) -> Array:
        """1 + M(xi) [-] at many real wave numbers (m,) [1/m]: the recursion runs at few of them."""
        return 1.0 + on_axis(self, xi)

