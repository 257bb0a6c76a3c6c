r"""Bodies made to order: the shape that follows a prescribed force curve, or presses with a prescribed pressure.

The method read backwards.  A force curve tells the stiffness k = dF/dd, the medium tells at which contact radius a it
has this stiffness, and the depth there is the equivalent profile, g(a) = d; the inverse transform turns g into a body,

.. math:: f(r) = \frac{2\cos(k\pi/2)}\pi\int_0^r \frac{x^k\,g(x)}{(r^2-x^2)^{(1+k)/2}}\,\mathrm dx

(k the exponent of a graded medium, zero in a homogeneous one).  A pressure tells the displacement of the springs by
the inverse of its own transform, and g is what the displacement lacks of the depth.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.media.graded import GradedHalfSpace
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics import graded_abel
from winkler.numerics.chebyshev import Panels, fit_panels
from winkler.numerics.convex import fit_convex, hollow
from winkler.numerics.powered import gauss_jacobi
from winkler.numerics.roots import invert
from winkler.numerics.types import Array, ArrayLike, Curve
from winkler.profiles.designed import Designed
from winkler.values import frozen_array

__all__ = ["design_for_pressure", "design_profile"]

FEWEST = 6
TOLERANCE = 1e-10
"""Least error of f' on its panels, relative to the steepest slope."""
HEIGHT_TOLERANCE = 1e-9
"""Error of f on its panels, relative to the greatest height."""


def design_profile(depth: ArrayLike, force: ArrayLike, medium: Medium) -> Designed:
    """Return the body of revolution whose indentation follows a prescribed force curve.

    Parameters
    ----------
    depth, force : array_like, (n,)
        d [m] and F [N], at least six depths above zero; F(0) = 0 is understood.
    medium : HalfSpace, TransverselyIsotropicHalfSpace or GradedHalfSpace
        What the body will be pressed into.

    Returns
    -------
    Designed
        Known up to the contact radius of the last depth; its notes state how closely the curve is met.

    Raises
    ------
    InvalidInput
        If the curve is not convex: the contact of a body can only grow, and dF/dd with it.
    OutsideValidity
        If the inverse transform of the medium is not known, or the curve asks for a vertical wall.

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> medium = HalfSpace.between(Elastic(young=1e9, poisson=0.3))
    >>> d = np.linspace(1e-6, 1e-4, 50)
    >>> body = design_profile(d, 4.0 / 3.0 * medium.modulus * np.sqrt(5e-3) * d**1.5, medium)  # Hertz, R = 5 mm
    >>> bool(np.isclose(body.height(np.array([4e-4]))[0], (4e-4) ** 2 / (2 * 5e-3), rtol=1e-9))
    True
    """
    k = _exponent("design_profile", medium)
    d, f = _checked("design_profile", "depth", "m", depth, "force", "N", force)
    d, f = d[d > 0.0], f[d > 0.0]
    if d.size < FEWEST:
        raise InvalidInput(f"design_profile: {d.size} depths above zero were given; give at least {FEWEST}.")
    if np.any(f <= 0.0):
        raise InvalidInput(
            f"design_profile: the force {np.min(f):.6g} N at a depth above zero is not compressive; without adhesion a "
            "body is pushed back at every depth: give positive forces."
        )
    where = hollow(d, f, 1e-9)
    if where is not None:
        raise InvalidInput(
            f"design_profile: the force is not convex between the depths {where[0]:.6g} m and {where[1]:.6g} m; dF/dd is "
            "the stiffness of the contact, which never shrinks while it is pressed: give a curve whose slope rises."
        )
    curve = fit_convex(d, f)
    knots = curve.panels.edges
    radii = _radii(medium, curve.stiffness(knots))
    if np.any(np.diff(radii) <= 1e-5 * radii[-1] * np.diff(knots)):
        still = int(np.argmin(np.diff(radii) / np.diff(knots)))
        low, high = curve.depth_at(knots[still : still + 2])
        raise OutsideValidity(
            f"design_profile: dF/dd hardly rises between the depths {low:.6g} m and {high:.6g} m, so the contact would "
            "stand still at a vertical wall; give a curve whose slope rises, or use CappedCylinder."
        )
    flat = float(radii[0]) if radii[0] > 1e-9 * radii[-1] else 0.0
    radii[0] = flat

    def gap_slope(x: Array) -> Array:
        """g'(x) = k'(x) / (dk/dd)."""
        inside = x > flat
        place = np.where(inside, x, radii[-1])
        s = curve.place(medium.punch_stiffness(place))
        rise = curve.rise(s) * curve.beta * s / np.where(s > 0.0, curve.depth_at(s), 1.0)
        slope = 2.0 * medium.normal_stiffness(place) / np.where(rise > 0.0, rise, np.inf)
        return np.where(inside, slope, 0.0)

    edges = radii if flat > 0.0 else radii[1:]
    tolerance = max(curve.misfit / float(f[-1]), 1e-10)
    bounds = np.concatenate([[0.0], edges])
    steepest = float(np.max(gap_slope(np.linspace(0.0, radii[-1], 513)[1:])))
    if curve.beta <= 1.0 or flat == 0.0:  # else g' is infinite where the flat end stops
        gap_slope = fit_panels(gap_slope, bounds, 0.1 * max(TOLERANCE, tolerance) * steepest)
    return _body(gap_slope, [float(x) for x in edges[:-1]], flat, float(radii[-1]), k, tolerance)


def design_for_pressure(r: ArrayLike, pressure: ArrayLike, medium: Medium) -> Designed:
    """Return the body of revolution that presses with a prescribed pressure.

    Parameters
    ----------
    r : array_like, (n,)
        Distances from the axis [m], rising from 0 to the contact radius, at least six.
    pressure : array_like, (n,)
        p [Pa] there, nowhere negative. It may end above zero, as a uniform pressure does.
    medium : HalfSpace, TransverselyIsotropicHalfSpace or GradedHalfSpace
        What the body will be pressed into.

    Returns
    -------
    Designed
        Known up to the last radius. Pressed until its contact has that radius, it yields the pressure.

    Raises
    ------
    InvalidInput
        If the pressure is negative somewhere or the radii do not rise from 0.
    OutsideValidity
        If the inverse transform of the medium is not known, or a contact with this pressure could not have grown from
        a point (the springs would be deepest away from the axis).
    """
    k = _exponent("design_for_pressure", medium)
    if k == 1.0:
        raise OutsideValidity(
            "design_for_pressure: in Gibson's solid every point sinks for itself, f(r) = (3/2)(c0/E0)(p(0) - p(r)); no "
            "transform is needed."
        )
    radii, p = _checked("design_for_pressure", "r", "m", r, "pressure", "Pa", pressure)
    if radii[0] != 0.0 or radii.size < FEWEST:
        raise InvalidInput(
            f"design_for_pressure: r starts at {radii[0]:.6g} m with {radii.size} points; give at least {FEWEST} from "
            "r = 0 to the contact radius."
        )
    if np.any(p < 0.0):
        bad = int(np.argmin(p))
        raise InvalidInput(
            f"design_for_pressure: the pressure is {p[bad]:.6g} Pa at r = {radii[bad]:.6g} m; without adhesion no body "
            "can pull: give pressures of zero or more."
        )
    if not np.any(p > 0.0):
        raise InvalidInput("design_for_pressure: the pressure is zero everywhere; give one that presses.")
    end = float(radii[-1])
    surface_modulus = (
        medium.modulus / medium.depth_scale**k if isinstance(medium, GradedHalfSpace) else _modulus(medium)
    )
    factor = 2.0 * math.sin(0.5 * math.pi * (1.0 - k)) / surface_modulus
    uniform = float(p[-1]) * end ** (1.0 - k) / (1.0 - k)
    bulge = _bulge(radii / end, p - p[-1], k)

    def sinking(x: Array) -> Array:
        """u(x) over the factor, of what the pressure is above that at the edge [Pa m^(1-k)]."""
        t = np.minimum(x / end, 1.0)
        return np.asarray(end ** (1.0 - k) * (1.0 - t) * (1.0 + t) * bulge(t))

    t = np.linspace(0.0, 1.0, 2001)
    springs = sinking(end * t) + uniform * ((1.0 - t) * (1.0 + t)) ** (0.5 * (1.0 - k))
    rise = np.diff(springs)
    if np.max(rise) > 1e-6 * np.max(springs):
        raise OutsideValidity(
            f"design_for_pressure: near x = {end * t[int(np.argmax(rise))]:.6g} m the springs would be deeper outside "
            "than inside, so the contact could not have grown from the axis as a disc; give a pressure that rises less "
            "towards the edge."
        )
    deepest = float(sinking(np.zeros(1))[0])

    def height(r: Array) -> Array:
        from scipy.special import hyp2f1

        m = (np.asarray(r, dtype=float) / end) ** 2
        flat = uniform * (1.0 - hyp2f1(0.5 * (k - 1.0), 0.5 * (1.0 + k), 1.0, m))
        return np.asarray(factor * (flat + deepest - graded_abel.surface(sinking, [], k, np.asarray(r, dtype=float))))

    scale = float(height(np.array([end]))[0])
    panels = fit_panels(height, end * np.linspace(0.0, 1.0, 5), HEIGHT_TOLERANCE * scale).derivative
    return Designed(panels.edges, panels.coefficients, 1e3 * HEIGHT_TOLERANCE)


def _modulus(medium: Medium) -> float:
    assert isinstance(medium, HomogeneousMedium)
    return medium.modulus


def _bulge(t: Array, p: Array, k: float) -> Panels:
    """Return J(x/a): with p = S(theta) cos(theta)^(1+k), r = a sin(theta), the springs sink by a^(1-k) (1 - t^2) J.

    Contacts that close smoothly have such a pressure with a smooth S; J is the integral of
    sin(phi)^-k cos(phi)^(2+k) S over phi, where r^2 = x^2 + (a^2 - x^2) sin(phi)^2.
    """
    from scipy.interpolate import CubicSpline

    angle = np.arcsin(t[:-1])
    shape = CubicSpline(angle, p[:-1] / np.cos(angle) ** (1.0 + k), bc_type=((1, 0.0), "not-a-knot"))
    nodes, weights = gauss_jacobi(200, -k)
    phi = 0.5 * math.pi * nodes
    weight = weights * 0.5 * math.pi * (np.sin(phi) / nodes) ** -k * np.cos(phi) ** (2.0 + k)

    def integral(x: Array) -> Array:
        rest = np.sqrt((1.0 - x) * (1.0 + x))[..., None]
        return np.asarray(shape(np.arctan2(np.hypot(x[..., None], rest * np.sin(phi)), rest * np.cos(phi))) @ weight)

    return fit_panels(integral, np.linspace(0.0, 1.0, 9), 1e-9 * max(float(np.max(np.abs(p))), 1e-300))


def _exponent(owner: str, medium: Medium) -> float:
    """Return the exponent of the grading; refuse media whose inverse transform is not known."""
    if isinstance(medium, GradedHalfSpace):
        return medium.exponent
    if isinstance(medium, HomogeneousMedium):
        return 0.0
    raise OutsideValidity(
        f"{owner}: the medium is a {type(medium).__name__}, whose inverse transform is not known in closed form; give a "
        "HalfSpace, TransverselyIsotropicHalfSpace or GradedHalfSpace."
    )


def _checked(
    owner: str, first: str, unit: str, given: ArrayLike, second: str, other: str, values: ArrayLike
) -> tuple[Array, Array]:
    x, y = frozen_array(given).astype(float), frozen_array(values).astype(float)
    if x.ndim != 1 or x.shape != y.shape or x.size == 0:
        raise InvalidInput(
            f"{owner}: {first} has the shape {x.shape} and {second} {y.shape}; give two one-dimensional arrays of equal "
            "length."
        )
    for word, which, numbers in ((first, unit, x), (second, other, y)):
        bad = np.flatnonzero(~np.isfinite(numbers))
        if bad.size:
            raise InvalidInput(f"{owner}: {word}[{bad[0]}] is {numbers[bad[0]]}; give finite values in {which}.")
    if x[0] < 0.0 or np.any(np.diff(x) <= 0.0):
        raise InvalidInput(f"{owner}: {first} must rise from zero or more, each value above the one before; sort it.")
    return x, y


def _radii(medium: Medium, stiffness: Array) -> Array:
    """Return the contact radii with these stiffnesses."""
    result = np.zeros(stiffness.shape)
    wanted = stiffness > 1e-12 * stiffness[-1]
    result[wanted] = invert(
        lambda a: (medium.punch_stiffness(a), 2.0 * medium.normal_stiffness(a)),
        stiffness[wanted],
        lower=0.0,
        upper=math.inf,
        guess=1e-3,
    )
    return result


def _body(gap_slope: Curve, edges: list[float], flat: float, end: float, k: float, tolerance: float) -> Designed:
    """Return the body whose equivalent profile has the slope g', by the inverse transform of x g'."""

    def slope(r: Array) -> Array:
        flatr = np.asarray(r, dtype=float).ravel()
        places = np.maximum(flatr, 1e-12 * end)
        moment = graded_abel.surface(lambda x: x * gap_slope(x), edges, k, places)
        return np.asarray((moment / places).reshape(np.shape(r)))

    start = np.array(sorted({0.0, *edges, end}))
    steepest = float(np.max(np.abs(slope(end * np.linspace(0.05, 0.95, 19)))))
    panels = fit_panels(slope, start, max(TOLERANCE, tolerance) * steepest)
    return Designed(panels.edges, panels.coefficients, tolerance)
