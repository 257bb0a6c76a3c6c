"""Inversion of rising functions, for many targets at once, one root in a bracket, and where to begin."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, WinklerError

MOST_ITERATIONS = 200
USUAL_ITERATIONS = 10
"""Steps after which every other one halves the bracket; ten are usual."""
STEP_TOLERANCE = 3e-9
"""A step of this part of the distance from the nearer end is the last."""
MOST_OCTAVES_PER_STEP = 20.0
"""Octaves of one step of a search, at most."""
MANY, SAMPLES, BLOCK = 1000, 257, 4096
"""Number of targets from which on some are met first, how many these are, and how many are met at once afterwards."""
LEAST_POWER = 0.25
"""Least power of x that is extrapolated: waves return to where they were."""
MOST_OCTAVES = 100.0
"""Octaves from one: as far as any length is."""
MOST_TRIALS = 50
ROUNDING_RATIO = 1e-9
"""Of the scale of a function: an end of a bracket where it is not larger is the root, whatever its sign is there."""


def invert(
    function: Callable[[Array], tuple[Array, Array]], target: Array, *, lower: float, upper: float, guess: float | Array
) -> Array:
    """Return x with function(x) = target, for a function that rises from 0 at `lower`.

    Newton's method in logarithms, log(function) against log(x - lower), which solves a power law in one step;
    every step is kept inside a bracket that only shrinks.

    Parameters
    ----------
    function
        Takes x ``(m,)`` inside (lower, upper), returns its values and derivatives, both ``(m,)``.
    target : ndarray, (m,)
        Positive values to be met.
    lower, upper
        The interval; `upper` may be infinite, and the function may diverge there.
    guess : float or ndarray, (m,)
        Where to begin, inside the interval.

    Returns
    -------
    ndarray, (m,)

    Raises
    ------
    NotConverged
        If a target is not met to rounding after 200 steps.
    """
    if target.size > MANY and np.ndim(guess) == 0:
        begin = _between_samples(function, target, lower, upper, guess)
        return by_blocks(lambda own: invert(function, own, lower=lower, upper=upper, guess=begin(own)), target)
    low: Array = np.array(lower)
    high: Array = np.array(upper)
    x: Array = np.full(target.shape, guess) if np.ndim(guess) == 0 else np.array(guess)
    for count in range(MOST_ITERATIONS):
        value, slope = function(x)
        distance = x - lower
        step = _newton_step(distance, value, slope, target)
        new, length = x + step, np.abs(step)
        # Newton's method doubles the digits: a step so small, against the distance from where the function may be
        # singular, leaves nothing to do after it
        settled = length <= STEP_TOLERANCE * np.minimum(distance, upper - x)
        if settled.all() and ((new > low) & (new < high)).all():
            return new
        below = value < target
        low = np.where(below, x, low)
        high = np.where(below, high, x)
        settled |= length <= 4e-16 * x
        inside = (new > low) & (new < high)
        if count > USUAL_ITERATIONS and count % 2:  # Newton's method goes to and fro about a bend: halve the bracket
            inside &= settled | np.isinf(high)
        kept = settled & ~inside
        if kept.any():
            new = np.where(kept, x, new)
        if settled.all():
            return new
        wild = ~(inside | settled)
        if wild.any():
            new = np.where(wild, _middle(low, high, lower), new)
            # neighbours in floating point: nothing lies between them
            stuck = (high < np.inf) & (high - low <= 4e-16 * np.abs(low))
            if np.all(settled | stuck):
                return new
        x = new
    worst = float(np.max(np.abs(function(x)[0] / target - 1.0)))
    if worst < 1e-12:
        return x
    raise NotConverged(f"No contact radius carries the load: after {MOST_ITERATIONS} steps the misfit is {worst:.1e}.")


def by_blocks(function: Callable[..., Array], *numbers: Array) -> Array:
    """Return a function, element by element, of arrays ``(m,)``, by blocks that stay in the cache."""
    most = numbers[0].size
    if most <= MANY:
        return function(*numbers)
    blocks = [slice(start, start + BLOCK) for start in range(0, most, BLOCK)]
    return np.concatenate([function(*(each[block] for each in numbers)) for block in blocks])


def _between_samples(
    function: Callable[[Array], tuple[Array, Array]], target: Array, lower: float, upper: float, guess: float | Array
) -> Callable[[Array], Array]:
    """Return what says where to begin: on cubics between the roots of some targets, in logarithms of both."""
    least, most = float(target.min()), float(target.max())
    first, last = np.log([least, most]).tolist()
    if not last > first:
        return lambda own: np.full(own.shape, guess)
    samples, width = np.linspace(first, last, SAMPLES), (last - first) / (SAMPLES - 1)
    try:
        # rounding must not ask for more than is met
        roots = invert(function, np.clip(np.exp(samples), least, most), lower=lower, upper=upper, guess=guess)
    except NotConverged:  # each target is searched for by itself, as a few are
        return lambda own: np.full(own.shape, guess)
    value, slope = function(roots)
    distance = roots - lower
    if not np.all((slope > 0.0) & np.isfinite(slope) & (distance > 0.0)):
        return lambda own: np.interp(np.log(own), samples, roots)
    near, rise = np.log(distance), width * value / (slope * distance)
    change = np.diff(near)
    third = rise[:-1] + rise[1:] - 2.0 * change
    columns = third, change - rise[:-1] - third, rise[:-1], near[:-1]

    def begin(own: Array) -> Array:
        place = (np.log(own) - first) / width
        cell = np.clip(place.astype(int), 0, SAMPLES - 2)
        place -= cell
        found = np.zeros(own.shape)
        for column in columns:
            found *= place
            found += column[cell]
        return np.clip(lower + np.exp(found), roots[cell], roots[cell + 1])

    return begin


def _newton_step(distance: Array, value: Array, slope: Array, target: Array) -> Array:
    """Return the step of Newton's method in logarithms, infinite where it is not defined."""
    usable = (value > 0.0) & (slope > 0.0) & np.isfinite(slope)
    if not usable.all():
        value, slope = np.where(usable, value, target), np.where(usable, slope, 1.0)
    # at most ten decades down in one step, where the difference would round to -1
    growth = np.maximum((target - value) / value, 1e-10 - 1.0)
    power = np.log1p(growth) * value / (slope * distance)
    step = distance * np.expm1(np.minimum(power, 50.0))
    return step if usable.all() else np.where(usable, step, math.inf)


def _middle(low: Array, high: Array, lower: float) -> Array:
    """Return a point inside the bracket: geometric in the distance from `lower`, doubling while it is open."""
    near, far = low - lower, high - lower
    doubled = np.where(near > 0.0, 4.0 * near, 1.0)
    far = np.where(np.isinf(far), 16.0 * doubled, far)
    geometric = np.sqrt(np.maximum(near, 1e-30 * far) * far)
    arithmetic = 0.5 * (near + far)
    middle = lower + np.where(far > 4.0 * near, geometric, arithmetic)
    # beside `lower` the geometric middle may round to it
    return np.where((middle > low) & (middle < high), middle, lower + arithmetic)


def between(
    function: Callable[[float], float], low: float, high: float, *, relative: float = 8.9e-16, absolute: float = 1e-300
) -> float:
    """Return a root between two places where a function has different signs.

    What is known to change its sign may not do so in floating-point numbers if the root is an end, or if nothing but
    rounding lies between the ends; then the end nearer to zero is the root.

    Parameters
    ----------
    function
        Takes a place, returns a value.
    low, high
        Ends of the bracket.
    relative, absolute
        Largest errors of the root.

    Raises
    ------
    NotConverged
        If the signs are the same, and not by rounding; or if the root is not found.
    """
    from scipy.optimize import brentq

    try:
        return float(brentq(function, low, high, xtol=absolute, rtol=relative, maxiter=1000))
    except WinklerError:
        raise
    except (RuntimeError, ValueError) as error:
        left, right = function(low), function(high)
        least, most = sorted((abs(left), abs(right)))
        if least <= ROUNDING_RATIO * most or high - low <= ROUNDING_RATIO * max(abs(low), abs(high)):
            return low if abs(left) == least else high
        raise NotConverged(f"No root lies between {low:.9g} and {high:.9g} ({error}).") from error


def rough_root(value: Callable[[Array], Array], target: float) -> float:
    """Return where a power of x reaches a value, whatever the unit of x; only of that order where it is no power.

    Parameters
    ----------
    value
        Takes places ``(m,)``, rises from zero.
    target
        Positive.
    """
    octaves = 0.0
    for _ in range(MOST_TRIALS):
        place = math.exp2(octaves)
        with np.errstate(all="ignore"):
            near, far = value(np.array([place, 2.0 * place])).tolist()
        if near == far == 0.0:
            step = MOST_OCTAVES_PER_STEP
        elif 0.0 < near < far < math.inf:
            step = (math.log2(target) - math.log2(near)) / max(math.log2(far) - math.log2(near), LEAST_POWER)
        else:
            step = -0.5 * MOST_OCTAVES_PER_STEP  # towards zero, where it rises
        octaves += min(max(step, -MOST_OCTAVES_PER_STEP), MOST_OCTAVES_PER_STEP)
        if abs(step) <= 1.0 or abs(octaves) >= MOST_OCTAVES:
            break
    return math.exp2(min(max(octaves, -MOST_OCTAVES), MOST_OCTAVES))
