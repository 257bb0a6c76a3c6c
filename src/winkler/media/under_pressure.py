r"""The displacement of the surface of a medium under a prescribed pressure on a disc.

Under :math:`p(r)` on :math:`r\le a` the springs of a homogeneous (k = 0) or graded half-space sink by

.. math:: \varphi(x) = \frac{2\cos(k\pi/2)}{E^*/c_0^k}\int_x^a\frac{r\,p(r)}{(r^2-x^2)^{(1+k)/2}}\,\mathrm dr ,

and the surface by the transform of that.  Layers sink by the transform of

.. math:: (K\varphi)(x) = \tfrac12\int_{-a}^{a} C(x-t)\,\varphi(t)\,\mathrm dt

besides, with C(x) the cosine transform of what their compliance has over that of the uppermost layer alone.  The
pressure is split into a uniform one, known in closed form, and one that vanishes at the edge.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.media.body_of import exponent_of, surface_slope
from winkler.media.layered.coated_load import kernel_steps, settled_sums
from winkler.media.medium import Medium
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.jacobi_quadrature import gauss_jacobi
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms.cosine_transform import WaveResponse, transform
from winkler.numerics.types import Array
from winkler.values.value import value, words

BULGE_TOLERANCE = 1e-8
"""Error of the springs under the part of the pressure that vanishes at the edge, relative to the greatest pressure."""
DEGREE = 48
"""Of the one polynomial that is tried for them first: it has no joints, which the layers would feel."""
SHARE_TOLERANCE = 1e-11
"""Error of K phi, relative to the deepest spring."""
PRESSURE_NODES = 200
"""Nodes of the integral over that pressure, of which only a cubic spline is known."""
SETTLED_TOLERANCE, LAST_TOLERANCE = 1e-12, 1e-9
RESTLESS = "The sinking of the layers under the pressure still moves by {:.1e}; give a smoother pressure."


@value
class PressureIndentation:
    """The homogeneous springs and the surface under a pressure.

    Parameters
    ----------
    radius : float
        a [m], where the pressure ends.
    exponent : float
        k [-] of a graded medium, else zero.
    uniform : float
        How far, over (1 - x^2/a^2)^((1 - k)/2), the springs sink under the pressure at the edge [m].
    bulge : Panels
        The same of the rest, over 1 - x^2/a^2, as a function of x/a [m].
    share : Panels
        K phi [m] as a function of x, zero without layers.
    """

    __words__ = words(
        exponent=("k", "", "exponent of the grading"),
        uniform=("", "m", "spring deflection due to the pressure at the edge"),
        bulge=("", None, "spring deflection due to the rest of the pressure, on panels"),
        share=("", None, "what layers add to the displacement of the springs, on panels"),
    )

    radius: float
    exponent: float
    uniform: float
    bulge: Panels
    share: Panels

    def springs(self, x: Array) -> Array:
        """phi(x) [m]."""
        t = np.minimum(x / self.radius, 1.0)
        flat = self.uniform * ((1.0 - t) * (1.0 + t)) ** (0.5 * (1.0 - self.exponent))
        return np.asarray(flat + self._vanishing(x))

    def _vanishing(self, x: Array) -> Array:
        t = np.minimum(x / self.radius, 1.0)
        return np.asarray((1.0 - t) * (1.0 + t) * self.bulge(t))

    def _vanishing_slope(self, x: Array) -> Array:
        t = np.minimum(x / self.radius, 1.0)
        return np.asarray(((1.0 - t) * (1.0 + t) * self.bulge.derivative(t) - 2.0 * t * self.bulge(t)) / self.radius)

    def rise(self, r: Array) -> Array:
        """The slope of the surface over the distance from the axis [-], r < a."""
        from scipy.special import hyp2f1

        r, k, a = np.asarray(r, dtype=float), self.exponent, self.radius
        steep = 0.5 * (1.0 - k * k) * hyp2f1(0.5 * (1.0 + k), 0.5 * (3.0 + k), 2.0, (r / a) ** 2) * r / a**2
        joints = [a * float(t) for t in self.bulge.edges[1:-1]]
        rest = surface_slope(self._vanishing_slope, joints, k, r, a)
        layers = surface_slope(self.share.derivative, [float(x) for x in self.share.edges[1:-1]], 0.0, r, a)
        return np.asarray(self.uniform * steep - rest - layers)


def pressed_in(medium: Medium, r: Array, pressure: Array) -> PressureIndentation:
    """Return what a pressure does to a medium.

    Parameters
    ----------
    medium : Medium
        Homogeneous, graded (exponent below 1) or layered.
    r : ndarray, (n,)
        From 0 to the edge [m], ascending.
    pressure : ndarray, (n,)
        [Pa]; between the points a cubic spline, with a square root (in graded media the power (1 + k)/2) at the edge.

    Raises
    ------
    OutsideValidity
        If the compliance of the medium is not known.
    """
    k, end = exponent_of(medium), float(r[-1])
    surface_modulus = float(medium.normal_stiffness(np.array([end]))[0]) / end**k
    if offers(medium, PressedWaves):
        surface_modulus = medium.modulus
    factor = 2.0 * math.sin(0.5 * math.pi * (1.0 - k)) * end ** (1.0 - k) / surface_modulus
    bulge = _bulge(r / end, factor * (pressure - pressure[-1]), k)
    uniform = factor * float(pressure[-1]) / (1.0 - k)
    bare = PressureIndentation(end, k, uniform, bulge, Panels(np.array([0.0, end]), np.zeros((1, 1))))
    if not offers(medium, PressedWaves):
        return bare
    return PressureIndentation(end, k, uniform, bulge, _share(medium.response, bare))


def _bulge(t: Array, p: Array, k: float) -> Panels:
    """Return J(x/a): with p = S(theta) cos(theta)^(1+k), r = a sin(theta), the springs sink by (1 - t^2) J.

    Contacts that close smoothly have such a pressure with a smooth S; J is the integral of
    sin(phi)^-k cos(phi)^(2+k) S over phi, where r^2 = x^2 + (a^2 - x^2) sin(phi)^2.
    """
    from scipy.interpolate import CubicSpline

    angle = np.arcsin(t[:-1])
    shape = CubicSpline(angle, p[:-1] / np.cos(angle) ** (1.0 + k), bc_type=((1, 0.0), "not-a-knot"))
    nodes, weights = gauss_jacobi(PRESSURE_NODES, -k)
    phi = 0.5 * math.pi * nodes
    weight = weights * 0.5 * math.pi * (np.sin(phi) / nodes) ** -k * np.cos(phi) ** (2.0 + k)

    def integral(x: Array) -> Array:
        rest = np.sqrt((1.0 - x) * (1.0 + x))[..., None]
        return np.asarray(shape(np.arctan2(np.hypot(x[..., None], rest * np.sin(phi)), rest * np.cos(phi))) @ weight)

    nodes = 0.5 * (1.0 + np.polynomial.chebyshev.chebpts1(DEGREE + 1))
    vander = np.polynomial.chebyshev.chebvander(2.0 * nodes - 1.0, DEGREE)
    series, size = np.linalg.solve(vander, integral(nodes)), float(np.max(np.abs(p)))
    if np.max(np.abs(series[-8:])) <= BULGE_TOLERANCE * size:
        return Panels(np.array([0.0, 1.0]), series[None])
    return fit_panels(integral, np.linspace(0.0, 1.0, 9), BULGE_TOLERANCE * size)


def _share(response: WaveResponse, bare: PressureIndentation) -> Panels:
    """Return K phi on the disc."""
    a = bare.radius
    kernel = transform(response, 2.0 * a)
    steps = kernel_steps(response, 2.0 * a)
    size = float(bare.springs(np.zeros(1))[0])

    def sums(count: int, x: Array) -> Array:
        nodes, weights = gauss_legendre(count)
        result = np.empty((1, x.size))
        for rows in chunks(x.size, count * (2 * steps.size + 2)):
            part = x[rows, None]
            ends = np.full(part.shape, a)
            cuts = np.clip(np.concatenate([-ends, part - steps[::-1], part, part + steps, ends], axis=1), -a, a)
            angle = np.arcsin(cuts / a)  # t = a sin(angle): phi starts with a square root at the edge
            low, high = angle[:, :-1, None], angle[:, 1:, None]
            places = low + (high - low) * nodes
            t = a * np.sin(places)
            load = bare.springs(np.abs(t)) * a * np.cos(places) * (high - low) * weights
            result[0, rows] = 0.5 * np.sum(load * kernel(np.abs(part[..., None] - t)), axis=(1, 2))
        return result

    def settled(x: Array) -> Array:
        found = settled_sums(
            lambda count: sums(count, x.ravel()), np.array([size]), SETTLED_TOLERANCE, LAST_TOLERANCE, RESTLESS
        )
        return found.reshape(x.shape)

    return fit_panels(settled, np.linspace(0.0, a, 5), SHARE_TOLERANCE * size)
