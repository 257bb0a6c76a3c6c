r"""Springs behind computed contacts: from depths, forces and stiffnesses to a bed, and how well it bears the forces.

Forces of smooth bodies are met far better than stiffnesses, which jump as pixels come into contact: there ln F is a
spline of ln d, and k its slope.  Under a few pixels, and on rough surfaces, those jumps are what the map is: there the
stiffnesses are those of the flat punches, with one between that brings the next force.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.foundation.measured import MeasuredBed
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.numerics.equations.roots import invert
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth
from winkler.values.errors import OutsideValidity

FEWEST_PIXELS = 16
"""A contact of fewer determines its stiffness too poorly for a smooth curve."""
FEWEST_POINTS = 4
POINTS_BETWEEN = 4
"""Points of the smooth bed for one computed contact."""
FORCE_RATIO = 1.5
LEAST_RISE = 1e-4
"""By how much a stiffness is to rise to count as another one."""
RISE_SHARE = 0.05
"""By how much, of the rise between two contacts, the stiffness between them differs from both."""
MOST_ROUNDS, MISFIT_SHARE = 6, 0.1
"""How often points are bent, at most, and the part of the allowed misfit at which that is enough."""
LARGEST_FORCE_SHARE = 0.95
"""Most that the first force may be of stiffness times depth, which it is under a flat end."""
INSIDE_RATIO = 1.0 - 1e-12


class ContactPoints(NamedTuple):
    """Contacts of rising depth.

    Parameters
    ----------
    depth, force, stiffness
        d [m], F [N], k [N/m].
    pixels
        How many touch.
    """

    depth: Array
    force: Array
    stiffness: Array
    pixels: Array


class MeasuredSprings(NamedTuple):
    """Springs, and the greatest difference [N] of their forces from those of all contacts."""

    bed: MeasuredBed
    misfit: float


def springs_of(points: ContactPoints, medium: MappedMedium, allowed: float) -> MeasuredSprings:
    """Return the springs behind contacts: smooth ones, if they miss the forces by no more than `allowed` [N].

    Raises
    ------
    OutsideValidity
        If the contact does not grow.
    """
    smooth = _smooth(points)
    if smooth is not None:
        fitted = _fitted(smooth, medium, points)
        if fitted.misfit <= allowed:
            return fitted
    # the splines of the bed are not as straight as what is meant: bend the points until the forces come out
    rising = _rising(points)
    more = np.zeros(points.depth.size - 1)
    for _ in range(MOST_ROUNDS):
        fitted = _fitted(_punched(rising, more), medium, points)
        if fitted.misfit <= MISFIT_SHARE * allowed:
            break
        more -= np.diff(_missed(fitted.bed, points))
    return fitted


def _missed(bed: MeasuredBed, points: ContactPoints) -> Array:
    """Return how much more [N] springs bear than contacts at the same depths."""
    depth, radius = at_depth(bed, np.minimum(points.depth, bed.depths[-1] * INSIDE_RATIO))
    return np.asarray(bed.stiffness(radius) * depth - bed.gap_load(radius) - points.force)


def force_uncertainty(points: ContactPoints) -> Array:
    """Return how far [N] convex curves through the same contacts may be apart between one and the next.

    The stiffness rises with the depth: forces lie below the chord and above both tangents.
    """
    step, low, high = np.diff(points.depth), points.stiffness[:-1], points.stiffness[1:]
    chord = np.clip(np.diff(points.force) / step, low, np.maximum(high, low))
    rise = np.where(high > low, high - low, 1.0)
    return np.asarray((chord - low) * (high - chord) / rise * step)


def _smooth(points: ContactPoints) -> ContactPoints | None:
    """Return points of a smooth curve through those that cover enough pixels; none if its slope does not rise."""
    from scipy.interpolate import CubicSpline

    resolved = points.pixels >= FEWEST_PIXELS
    if np.count_nonzero(resolved) < FEWEST_POINTS:
        return None
    log_depth = np.log(points.depth[resolved])
    powers = (points.stiffness * points.depth / points.force)[resolved]
    spline = CubicSpline(log_depth, np.log(points.force[resolved]), bc_type=((1, powers[0]), (1, powers[-1])))
    places = np.interp(
        np.arange((log_depth.size - 1) * POINTS_BETWEEN + 1) / POINTS_BETWEEN, np.arange(log_depth.size), log_depth
    )
    depth, force = np.exp(places), np.exp(spline(places))
    depth[::POINTS_BETWEEN] = points.depth[resolved]  # to rounding
    stiffness = force / depth * spline(places, 1)
    if np.any(np.diff(stiffness) <= 0.0):
        return None
    return ContactPoints(depth, force, stiffness, np.interp(depth, points.depth, points.pixels))


def _rising(points: ContactPoints) -> ContactPoints:
    """Return the points with stiffnesses that rise a little at least, where no pixel more comes into contact."""
    stiffness = points.stiffness.copy()
    if np.count_nonzero(np.diff(stiffness) > LEAST_RISE * stiffness[1:]) < FEWEST_POINTS - 1:
        raise OutsideValidity(
            "reduce: the contact hardly grows with the depth and is as stiff as a flat punch, "
            f"{stiffness[-1]:.6g} N/m; use a FlatPunch of the radius k/(2 E*)."
        )
    for i in range(1, stiffness.size):
        stiffness[i] = max(stiffness[i], stiffness[i - 1] * (1.0 + LEAST_RISE))
    return points._replace(stiffness=stiffness)


def _punched(points: ContactPoints, more: Array) -> ContactPoints:
    """Return these points, and one between each; between them the force shall rise by some more."""
    d, f, k, _ = points
    rise, mean = np.diff(k), (np.diff(f) + more) / np.diff(d)
    # k is straight from one contact to a point between, and on to the next, so that the mean slope of F comes out
    between = np.clip(2.0 * mean - 0.5 * (k[:-1] + k[1:]), k[:-1] + RISE_SHARE * rise, k[1:] - RISE_SHARE * rise)
    share = np.clip((between + k[1:] - 2.0 * mean) / rise, RISE_SHARE, 1.0 - RISE_SHARE)
    steps = share * np.diff(d)
    columns = (d[:-1] + steps, f[:-1] + 0.5 * (k[:-1] + between) * steps, between)
    depth, force, stiffness = (
        np.append(np.stack((old[:-1], new), axis=1).ravel(), old[-1])
        for old, new in zip((d, f, k), columns, strict=True)
    )
    return ContactPoints(depth, force, stiffness, np.interp(depth, points.depth, points.pixels))


def _fitted(given_points: ContactPoints, medium: MappedMedium, points: ContactPoints) -> MeasuredSprings:
    """Return the springs behind points, with what they need below the first of them."""
    depth, force, stiffness, _ = given_points
    # below the first point a power of the radius, the one that brings the first force
    share = min(force[0] / (stiffness[0] * depth[0]), LARGEST_FORCE_SHARE)
    below, power = FORCE_RATIO ** -np.arange(4.0, 0.0, -1.0), share / (1.0 - share)
    stiffness, depth = np.append(stiffness[0] * below, stiffness), np.append(depth[0] * below**power, depth)
    radii, ratio = radii_of(stiffness, medium), medium.shear_modulus / medium.modulus
    misses = _missed(MeasuredBed(radii, stiffness, depth, mindlin_ratio=ratio), points)
    scatter = float(np.sqrt(np.mean(misses**2)))
    bed = MeasuredBed(radii, stiffness, depth, scatter=scatter, mindlin_ratio=ratio)
    return MeasuredSprings(bed, float(np.max(np.abs(misses))))


def radii_of(stiffness: Array, medium: MappedMedium) -> Array:
    """Return the radii [m] of flat punches as stiff on the same bodies."""
    guess = stiffness / (2.0 * medium.modulus)
    if isinstance(medium, HomogeneousMedium):
        return guess

    def punched(radius: Array) -> tuple[Array, Array]:
        return medium.punch_stiffness(radius), 2.0 * medium.normal_stiffness(radius)

    return invert(punched, stiffness, lower=0.0, upper=np.inf, guess=guess)
