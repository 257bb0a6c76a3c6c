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
from winkler.media.layered.pair_response import MODE_WORDS, Mode, WavePair
from winkler.media.layered.wave_constants import Wave, half_space_compliance, in_plane_share
from winkler.numerics.caching import cached_by_value
from winkler.numerics.transforms.cosine_transform import on_axis
from winkler.numerics.types import Array, ComplexArray
from winkler.values.validity import Standing
from winkler.values.value import value

SERIES_WAVE_NUMBER = 100.0
"""xi_1 times the depth across which the surface changes."""
SERIES_SPAN = 16.0
"""The series is fitted up to this many xi_1."""
SERIES_TERMS = 6
SAME_UNIT = 1e-12
"""By how much rounding may move a unit from one."""
FAR = 1e3
"""Where a grading is what it is far below, over the depth at which it has settled."""
STIFFNESS_ERROR_RATIO = 0.434
"""Largest change of a stiffness, over |A| delta (a quadrature over the punches of a homogeneous half-space)."""


def solid_at(grading: DepthGrading, depth: float = 0.0) -> Elastic:
    """Return the solid at a depth [m]."""
    z = np.array(depth)
    return Elastic(float(grading.young_at(z)), float(grading.poisson_at(z)))


def cells_of(grading: DepthGrading, tolerance: float) -> Mesh:
    """Return the cells of a body for all wave numbers at which the recursion runs."""
    return mesh(grading, tolerance, surface_depth(grading) / (SERIES_WAVE_NUMBER * SERIES_SPAN))


@value
class GradedBody:
    """A body graded in depth, cut into cells.

    Parameters
    ----------
    grading : DepthGrading
        A value.
    tolerance : float
        Relative error of its compliances, and of what the rounding of a kernel does to a stiffness.
    """

    grading: DepthGrading
    tolerance: float = 1e-6

    def waves(self, part: Wave, xi: ComplexArray) -> ComplexArray:
        """Compliance times xi / 2 [1/Pa] at real or complex wave numbers (m,) [1/m] that the recursion resolves."""
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
            "The body is assumed linear elastic, isotropic and graded with depth, in plane strain under normal load. "
            "The Fourier response of this body is computed with thin cells in depth, with a relative error of at most "
            f"{self.tolerance:.0e}",
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

    @property
    def own(self) -> tuple[DepthResponse, float]:
        """The same in units of the surface of the graded body, and its unit of length [m], where it has them."""
        modulus, length = self.first.unit
        in_units = getattr(self.first.grading, "in_units", None)
        if in_units is None or max(abs(modulus - 1.0), abs(length - 1.0)) < SAME_UNIT:
            return self, 1.0
        first = GradedBody(in_units(modulus, length), self.first.tolerance)
        return DepthResponse(self.mode, first, self._own_second), length

    @functools.cached_property
    def length(self) -> float:
        """Delta [m]: M tends to zero like exp(-2 xi length)."""
        return _rounding(self)

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
        xi = np.asarray(xi)
        limit = SERIES_WAVE_NUMBER / surface_depth(self.first.grading)
        short = np.abs(xi) > limit
        result = np.empty_like(xi)
        result[~short] = self._exceeding(xi[~short])
        if short.any():
            shorter = limit / xi[short]
            result[short] = shorter * np.polyval(_series(self)[::-1], shorter)
        return np.asarray(self._share * result * (1.0 + np.expm1(-2.0 * xi * self.length) ** 3))

    def whole(self, xi: Array) -> Array:
        """1 + M(xi) [-] at many real wave numbers (m,) [1/m]: the recursion runs at few of them."""
        return 1.0 + on_axis(self, xi)


@cached_by_value(128)
def _series(response: DepthResponse) -> Array:
    """Return the coefficients of M = sum over j of c_j (xi_1 / xi)^(j+1)."""
    angle = np.pi * (np.arange(4 * SERIES_TERMS) + 0.5) / (4 * SERIES_TERMS)
    shorter = 1.0 / SERIES_SPAN + (1.0 - 1.0 / SERIES_SPAN) * np.cos(0.5 * angle) ** 2
    own = response._exceeding(SERIES_WAVE_NUMBER / surface_depth(response.first.grading) / shorter)
    return np.asarray(np.linalg.lstsq(np.vander(shorter, SERIES_TERMS, increasing=True), own / shorter, rcond=None)[0])


@cached_by_value(128)
def _rounding(response: DepthResponse) -> float:
    depth = surface_depth(response.first.grading)
    limit = SERIES_WAVE_NUMBER / depth
    fall = abs(float(_series(response)[0])) * limit
    # a grading that starts flat has no logarithm: the next terms of the series are then rounded off
    xi = limit * np.geomspace(1e-2, SERIES_SPAN, 60)
    fall = max(fall, float(np.max(np.abs(response._exceeding(xi)) * xi)) * 1e-3)
    return min(
        0.5 * response.first.tolerance / (STIFFNESS_ERROR_RATIO * max(fall, 1e-300)),
        1e-2 * surface_depth(response.first.grading),
    )
