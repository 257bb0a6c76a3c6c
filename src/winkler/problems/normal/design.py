r"""Bodies made to order: the shape that follows a prescribed force curve, or presses with a prescribed pressure.

The method inverted.  A force curve gives the stiffness k = dF/dd, the medium gives the contact radius a that has
this stiffness, and the depth there is the equivalent profile, g(a) = d; `winkler.media.body_of` turns g into a
body.  A pressure determines how far the surface sinks (`winkler.media.under_pressure`), and the body is what the
surface lacks of the depth at the axis, f(r) = u(0) - u(r).
"""

from __future__ import annotations

import numpy as np

from winkler.media import body_of
from winkler.media.body_of import Imprint
from winkler.media.medium import Medium
from winkler.media.offers import PressedWaves, offers
from winkler.media.springs_of_curve import springs_of_curve
from winkler.media.under_pressure import pressed_in
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.panels.convex_spline import ConvexCurve, first_concave_part, fit_convex, local_scatter
from winkler.numerics.types import Array, ArrayLike, Curve
from winkler.profiles.designed import Designed
from winkler.values.errors import InvalidInput, OutsideValidity

LEAST_POINTS = 6
TOLERANCE = 1e-10
"""Least error of f' on its panels, relative to the steepest slope."""
LAYERED_TOLERANCE = 2e-9
"""The same on layers, whose transforms lose a digit."""
FLAT_TOLERANCE = 1e-8
"""The same of a body with a flat end, close to which the rounding of places counts."""
TRANSFORM_SHARE = 0.5
"""Part of these errors left to the transform of the body."""
PRESSURE_TOLERANCE = 1e-9
"""Error of f' on its panels, relative to the steepest slope, of a body made for a pressure."""
SPLINE_MISFIT = 1e-6
"""What the spline through a pressure given at points may miss of it."""
EDGE_PRESSURE = 1e-9
"""Pressure at the edge, over the greatest, that counts as zero."""
CONVEXITY_TOLERANCE = 1e-9
"""By how much of the greatest one the slope of a curve may fall for rounding."""
SCATTER_FACTOR = 2.0
HOLLOW_TOLERANCE = 1e-3
"""A curve that is not convex is refused if it lies farther from a convex one than so many times its scatter and such a
part of the greatest force; what it misses of less is stated."""


def design_profile(depth: ArrayLike, force: ArrayLike, medium: Medium) -> Designed:
    """Return the body of revolution with a prescribed force-depth curve.

    For a measured curve a convex curve is fitted to the points. The `tolerance` of the body states the misfit (root
    mean square, relative to the maximum force).

    Parameters
    ----------
    depth, force : array_like, (n,)
        d [m], rising, and F [N], at least six depths above zero; F(0) = 0 is assumed.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, GradedHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        The medium into which the body will be pressed.

    Returns
    -------
    Designed
        The body, defined up to the contact radius of the last depth. Its notes state the deviation from the curve.

    Raises
    ------
    InvalidInput
        If the curve is not convex within its scatter. The contact of a body of revolution, and therefore dF/dd, can
        only grow.
    OutsideValidity
        If the inverse transform is not implemented for the medium, the curve requires a vertical wall, or the contact
        is much wider than the layers are thick.

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
    k, layered = body_of.exponent_of(medium), offers(medium, PressedWaves)
    curve, accuracy = _convex(depth, force)
    tolerance = max(accuracy, LAYERED_TOLERANCE if layered else TOLERANCE)
    springs, exact = springs_of_curve(curve, medium, 0.1 * tolerance)
    if exact.flat > 0.0:
        tolerance = max(tolerance, FLAT_TOLERANCE)
    end = exact.reach
    glued = body_of.transformed_slope(medium, Imprint(springs, end))
    joints = [b for b, _ in exact.kinks]

    def transformed(x: Array) -> Array:
        return np.where(x > exact.flat, glued(x), 0.0)

    rise: Curve = transformed
    if not exact.singular:
        bounds = np.array([0.0, *joints, end])
        rise = panels = fit_panels(transformed, bounds, TRANSFORM_SHARE * tolerance * _greatest(transformed, end))
        joints = [float(x) for x in panels.edges[1:-1]]

    def slope(r: Array) -> Array:
        return body_of.surface_slope(rise, joints, k, r, end)

    start = np.array([0.0, *(b for b, _ in exact.kinks if b > 1e-3 * end), end])
    series = fit_panels(slope, start, tolerance * _greatest(slope, end))
    return Designed(series.edges, series.coefficients, tolerance)


def design_for_pressure(r: ArrayLike, pressure: ArrayLike, medium: Medium) -> Designed:
    """Return the body of revolution whose contact has a prescribed pressure.

    Parameters
    ----------
    r : array_like, (n,)
        Distances from the axis [m], rising from 0 to the contact radius, at least six.
    pressure : array_like, (n,)
        p [Pa] there, nowhere negative. At the edge it may be positive, as for a uniform pressure, except on layers.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, GradedHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        The medium into which the body will be pressed.

    Returns
    -------
    Designed
        The body, defined up to the last radius. If its contact has this radius, it has the prescribed pressure.

    Raises
    ------
    InvalidInput
        If the pressure is negative somewhere or the radii do not rise from 0.
    OutsideValidity
        If the inverse transform is not implemented for the medium, or the pressure on layers is not zero at the edge.
        If a contact with this pressure cannot grow from a point (the springs would be deepest away from the axis).
    """
    if body_of.exponent_of(medium) == 1.0:
        raise OutsideValidity(
            "design_for_pressure: in Gibson's solid the displacement of every point depends on its own pressure "
            "only, f(r) = (3/2)(c0/E0)(p(0) - p(r)); no transform is needed."
        )
    radii, p = _checked("design_for_pressure", "r", "m", r, "pressure", "Pa", pressure)
    if radii[0] != 0.0 or radii.size < LEAST_POINTS:
        raise InvalidInput(
            f"design_for_pressure: r starts at {radii[0]:.6g} m with {radii.size} points; give at least {LEAST_POINTS} "
            "from r = 0 to the contact radius."
        )
    if np.any(p < 0.0):
        bad = int(np.flatnonzero(p < 0.0)[0])
        raise InvalidInput(
            f"design_for_pressure: the pressure is {p[bad]:.6g} Pa at r = {radii[bad]:.6g} m; without adhesion no body "
            "can pull: give pressures of zero or more."
        )
    if not np.any(p > 0.0):
        raise InvalidInput("design_for_pressure: the pressure is zero everywhere; give one that presses.")
    if offers(medium, PressedWaves) and p[-1] > EDGE_PRESSURE * np.max(p):
        raise OutsideValidity(
            f"design_for_pressure: at the edge, r = {radii[-1]:.6g} m, the pressure is {p[-1]:.6g} Pa; the body would "
            "be infinitely steep there, which the springs of layers cannot resolve: give a pressure that ends at zero."
        )
    end, sunk = float(radii[-1]), pressed_in(medium, radii, p)
    places = end * np.linspace(0.0, 1.0, 2001)
    if not offers(medium, PressedWaves):
        springs = sunk.springs(places)
        _refuse_ring(places, np.diff(springs) > 1e-6 * np.max(springs))
    steepest = _greatest(sunk.rise, end)
    series = fit_panels(sunk.rise, end * np.linspace(0.0, 1.0, 5), PRESSURE_TOLERANCE * steepest)
    body = Designed(series.edges, series.coefficients, SPLINE_MISFIT)
    if offers(medium, PressedWaves):  # its springs are those of the body that was found
        slope = medium.gap_slope(body, places[1:-1])
        _refuse_ring(places[1:-1], slope < -1e-6 * np.max(np.abs(slope)))
    return body


def _convex(depth: ArrayLike, force: ArrayLike) -> tuple[ConvexCurve, float]:
    """Return the curve, and how far it is from the points over the greatest force."""
    d, f = _checked("design_profile", "depth", "m", depth, "force", "N", force)
    d, f = d[d > 0.0], f[d > 0.0]
    if d.size < LEAST_POINTS:
        raise InvalidInput(f"design_profile: {d.size} depths above zero were given; give at least {LEAST_POINTS}.")
    where = first_concave_part(d, f, CONVEXITY_TOLERANCE)
    scatter = local_scatter(d, f) if where is not None else 0.0
    pulled = np.flatnonzero(f <= -SCATTER_FACTOR * scatter)
    if pulled.size or f[-1] <= 0.0:
        bad = int(pulled[0]) if pulled.size else d.size - 1
        raise InvalidInput(
            f"design_profile: the force {f[bad]:.6g} N at the depth {d[bad]:.6g} m is not compressive; without "
            "adhesion a body is pushed back at every depth: give positive forces."
        )
    curve = fit_convex(d, f)
    if where is not None and curve.misfit > SCATTER_FACTOR * scatter + HOLLOW_TOLERANCE * float(np.max(f)):
        raise InvalidInput(
            f"design_profile: the force is not convex between the depths {where[0]:.6g} m and {where[1]:.6g} m; dF/dd "
            "is the stiffness of the contact, which never shrinks while it is pressed: give a curve whose slope rises."
        )
    return curve, curve.misfit / float(np.max(f))


def _greatest(function: Curve, end: float) -> float:
    return float(np.max(np.abs(function(end * np.linspace(0.0, 1.0, 65)[1:-1]))))


def _refuse_ring(places: Array, deeper: Array) -> None:
    """Refuse a pressure under which the springs are deeper somewhere than farther inside."""
    if np.any(deeper):
        raise OutsideValidity(
            f"design_for_pressure: near x = {places[np.argmax(deeper)]:.6g} m the springs would be deeper outside than "
            "inside, so the contact could not have grown from the axis as a disc; give a pressure that rises less "
            "towards the edge."
        )


def _checked(
    owner: str, first: str, unit: str, abscissae: ArrayLike, second: str, other: str, values: ArrayLike
) -> tuple[Array, Array]:
    try:
        x, y = np.array(abscissae, dtype=float), np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(
            f"{owner}: {first} or {second} are not numbers; give arrays in {unit} and {other}."
        ) from None
    if x.ndim != 1 or x.shape != y.shape or x.size == 0:
        raise InvalidInput(
            f"{owner}: {first} has the shape {x.shape} and {second} {y.shape}; give two one-dimensional arrays of "
            "equal length."
        )
    for word, which, numbers in ((first, unit, x), (second, other, y)):
        bad = np.flatnonzero(~np.isfinite(numbers))
        if bad.size:
            raise InvalidInput(f"{owner}: {word}[{bad[0]}] is {numbers[bad[0]]}; give finite values in {which}.")
    fall = np.flatnonzero(np.diff(x) <= 0.0)
    if x[0] < 0.0 or fall.size:
        where = f"{first}[{fall[0] + 1}] is not above the one before" if fall.size else f"{first}[0] is {x[0]:.6g}"
        raise InvalidInput(f"{owner}: {where}; {first} must rise from zero or more: sort it.")
    return x, y
