r"""The surface compliance of a body graded in depth, as a function of the wave number.

Up to :math:`\xi_1`, a few hundred over the depth across which the surface changes, the recursion runs through the body
(`winkler.media.layered.depth_recursion`).  Beyond, 1 + M is a power series in :math:`1/\xi`, whose first terms are
taken from M just below :math:`\xi_1`.  There :math:`M\approx A/\xi`: the kernel has a logarithm at zero distance, which
is rounded off over a length :math:`\delta`, M times

.. math:: 1-(1-e^{-2\xi\delta})^3 .

A flat punch of any radius is then stiffer or softer by less than a part :math:`0.434\,|A|\,\delta`; those wider than
:math:`\delta` by much less.
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
from winkler.numerics.caching import cached_by_value
from winkler.numerics.transforms.cosine_transform import on_axis
from winkler.numerics.types import Array, ComplexArray
from winkler.values import value

__all__ = [
    "DepthResponse",
    "NormalDepthResponse",
    "TangentialDepthResponse",
    "TurningDepthResponse",
    "cells_of",
    "solid_at",
]

SERIES_WAVE_NUMBER = 100.0
"""xi_1 times the depth across which the surface changes."""
SERIES_SPAN = 16.0
"""The series is fitted up to this many xi_1."""
SERIES_TERMS = 6
STIFFNESS_ERROR_RATIO = 0.434
"""Largest change of a stiffness, over |A| delta (a quadrature over the punches of a homogeneous half-space)."""


def solid_at(grading: DepthGrading, depth: float = 0.0) -> Elastic:
    """Return the solid at a depth [m]."""
    z = np.array(depth)
    return Elastic(float(grading.young_at(z)), float(grading.poisson_at(z)))


def cells_of(grading: DepthGrading, tolerance: float) -> Mesh:
    """Return the cells of a body for all wave numbers at which the recursion runs."""
    return mesh(grading, tolerance, surface_depth(grading) / (SERIES_WAVE_NUMBER * SERIES_SPAN))


class DepthResponse:
    """What all responses share; M times E* or G* of the pair over that of the graded body alone."""

    grading: DepthGrading
    second: Solid
    tolerance: float

    def _own(self, xi: ComplexArray) -> ComplexArray:
        """Return M of the graded body against a rigid one, where the recursion computes it."""
        raise NotImplementedError

    @property
    def _share(self) -> float:
        """Compliance of the surface of the graded body in that of the pair."""
        raise NotImplementedError

    @functools.cached_property
    def length(self) -> float:
        """Delta [m]: M tends to zero like exp(-2 xi length)."""
        return _rounding(self)

    @functools.cached_property
    def span(self) -> float:
        """Length [m] beyond which the body is what it is far below."""
        depths = np.geomspace(1e-3 * surface_depth(self.grading), self.grading.settled_at(self.tolerance), 200)
        young = self.grading.young_at(depths)
        return float(depths[-1] * np.max(young) / np.min(young))

    @functools.cached_property
    def smooth(self) -> float:
        """The kernel is smooth on this length [m], but for its logarithm."""
        return max(0.5 * surface_depth(self.grading), self.length)

    @property
    def precision(self) -> float:
        """How smooth M is, relative to one."""
        return 1e-3 * self.tolerance

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        xi = np.asarray(xi)
        limit = SERIES_WAVE_NUMBER / surface_depth(self.grading)
        short = np.abs(xi) > limit
        result = np.empty_like(xi)
        result[~short] = self._own(xi[~short])
        if short.any():
            shorter = limit / xi[short]
            result[short] = shorter * np.polyval(_series(self)[::-1], shorter)
        return np.asarray(self._share * result * (1.0 + np.expm1(-2.0 * xi * self.length) ** 3))


@cached_by_value(128)
def _series(response: DepthResponse) -> Array:
    """Return the coefficients of M = sum over j of c_j (xi_1 / xi)^(j+1)."""
    angle = np.pi * (np.arange(4 * SERIES_TERMS) + 0.5) / (4 * SERIES_TERMS)
    shorter = 1.0 / SERIES_SPAN + (1.0 - 1.0 / SERIES_SPAN) * np.cos(0.5 * angle) ** 2
    own = response._own(SERIES_WAVE_NUMBER / surface_depth(response.grading) / shorter)
    return np.asarray(np.linalg.lstsq(np.vander(shorter, SERIES_TERMS, increasing=True), own / shorter, rcond=None)[0])


@cached_by_value(128)
def _rounding(response: DepthResponse) -> float:
    limit = SERIES_WAVE_NUMBER / surface_depth(response.grading)
    fall = abs(float(_series(response)[0])) * limit
    # a grading that starts flat has no logarithm: the next terms of the series are then rounded off
    xi = limit * np.geomspace(1e-2, SERIES_SPAN, 60)
    fall = max(fall, float(np.max(np.abs(response._own(xi)) * xi)) * 1e-3)
    return min(
        0.5 * response.tolerance / (STIFFNESS_ERROR_RATIO * max(fall, 1e-300)), 1e-2 * surface_depth(response.grading)
    )


@value
class NormalDepthResponse(DepthResponse):
    """The response of a graded body and its counterpart to a pressure: 1 + M(xi) = C(xi) E* xi / 2.

    Parameters
    ----------
    grading : DepthGrading
        A value.
    second : Elastic or Rigid
        The other body, a homogeneous half-space.
    tolerance : float
        Relative error of 1 + M, and of what the rounding of the kernel does to a stiffness.
    """

    grading: DepthGrading
    second: Solid = RIGID
    tolerance: float = 1e-6

    @property
    def _share(self) -> float:
        top = solid_at(self.grading)
        return self.modulus * (1.0 - top.poisson**2) / top.young

    @property
    def modulus(self) -> float:
        """E* [Pa] of the surface and the second body."""
        bodies = [solid_at(self.grading), *([self.second] if isinstance(self.second, Elastic) else [])]
        return 1.0 / sum((1.0 - body.poisson**2) / body.young for body in bodies)

    compressed = math.inf
    """The limit of (1 + M) / xi for long waves: the body is a half-space."""

    def whole(self, xi: Array) -> Array:
        """1 + M(xi) [-] at many real wave numbers (m,) [1/m]: the recursion runs at few of them."""
        return 1.0 + on_axis(self, xi)

    def _own(self, xi: ComplexArray) -> ComplexArray:
        top = solid_at(self.grading)
        normal = surface_compliance(cells_of(self.grading, self.tolerance), xi)[2]
        return np.asarray(-normal * top.shear / (1.0 - top.poisson) - 1.0)


@value
class TangentialDepthResponse(DepthResponse):
    """The same for a tangential load, averaged over its angle with the wave: 1 + M(xi) = C_T(xi) G* xi / 2."""

    grading: DepthGrading
    second: Solid = RIGID
    tolerance: float = 1e-6

    @property
    def _share(self) -> float:
        top = solid_at(self.grading)
        return self.modulus * (2.0 - top.poisson) / (4.0 * top.shear)

    @property
    def modulus(self) -> float:
        """G* [Pa] of the surface and the second body."""
        bodies = [solid_at(self.grading), *([self.second] if isinstance(self.second, Elastic) else [])]
        return 1.0 / sum((2.0 - body.poisson) / (4.0 * body.shear) for body in bodies)

    compressed = math.inf
    """The limit of (1 + M) / xi for long waves: the body is a half-space."""

    def _own(self, xi: ComplexArray) -> ComplexArray:
        top = solid_at(self.grading)
        cells = cells_of(self.grading, self.tolerance)
        twisted = 0.25 * (surface_compliance_across(cells, xi) - surface_compliance(cells, xi)[0])
        return np.asarray(twisted * 4.0 * top.shear / (2.0 - top.poisson) - 1.0)


@value
class TurningDepthResponse(TangentialDepthResponse):
    """By how much compliances across the wave exceed those along it: G* xi / 4 times that, less its limit."""

    def _own(self, xi: ComplexArray) -> ComplexArray:
        top = solid_at(self.grading)
        cells = cells_of(self.grading, self.tolerance)
        more = 0.25 * (surface_compliance_across(cells, xi) + surface_compliance(cells, xi)[0])
        return np.asarray((more * 4.0 * top.shear - top.poisson) / (2.0 - top.poisson))
