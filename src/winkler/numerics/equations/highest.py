r"""The greatest value of a function of one, two or three coordinates, and its place.

The function is evaluated on a grid.  About each local maximum of the grid a box of 5 places along each coordinate
follows the greatest value and narrows.  Along coordinates in which the values are those of a smooth top, the box is
centred on the top of the polynomial through its places and becomes ten times smaller; where they have a cusp, it is
halved about the best place, until this is its middle.  So the lines of the grid should follow the cusps, and the
coordinates should be regular: a polar grid has no neighbours in its middle.

A top is given up when it cannot become the greatest: about a place :math:`x` where a function is concave,
:math:`f(x+s)\le f(x)+[f(x)-f(x-s)]`, so the top is no higher than the best value plus the drop to its neighbours.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array, Curve

PLACES, FEW_PLACES = 5, 3
"""Places of a box along one coordinate: their polynomial is of the fourth degree; of costly functions of the second."""
MOST_STARTS = 6
"""Local maxima of the grid from which the greatest is sought."""
MOST_ROUNDS = 45
HALVED, CENTRED, WIDENED = 0.5, 0.1, 3.0
"""Size of the next box over that of this one: about its best place; about the top of the polynomial, a cusp in its
middle, or an end; and where the best place lies on a face, behind which values rise."""
SMOOTH = 0.2
"""Terms of the third and fourth degree over the square one, below which a polynomial counts as a smooth top."""
SURE_ROUNDS = 3
"""Rounds after which a top may be given up: the grid itself may be too coarse to show how steep it is."""
SAME_PLACE, SAME_SIZE = 1e-7, 1e-8
"""Change of the place, and size of the box where there is a cusp, over the first box, at which the search ends."""
MOST_STEPS, SAME_STEP = 9, 1e-10
"""Steps of Newton to the top of a polynomial, and the last of them, over the half-width of the box."""
SETTLED_SIZE = 2e-3
"""Size of the box over the first one up to which the place of a polynomial's top is not yet final."""
ROUNDING = 1e-14
NOISE = 1e-8
"""Drop to a line of the grid next to the top, over the greatest value, up to which the line counts as the place.

Lines are asked within 1e-6 of their distance, over which a smooth top drops by about the square of that, 1e-12.  More
is a cusp, which lies on a line by the choice of the grid, or the rounding of the function.  Stresses in layers are
rounded most: a face and a place 1e-12 of the contact radius below it, of other quadratures, differ by 2e-12 to 2e-9
(layers of 180 to 300 GPa on 3 to 210 GPa, 2 to 20 thicknesses; 1e-7 for 450 GPa at 20).  Their searches are good to
1e-7, so that a drop of this size changes no stated digit.
"""
SAMPLES = 65


class Top(NamedTuple):
    """A greatest value, and its place along each coordinate."""

    value: float
    place: tuple[float, ...]


Field = Callable[..., Array]


def highest(
    field: Field,
    lines: Sequence[Array],
    ends: Sequence[tuple[float, float]] | None = None,
    *,
    starts: int = MOST_STARTS,
    rounds: int = MOST_ROUNDS,
    above: float = -math.inf,
) -> Top:
    """Return the greatest value of a function and its place.

    Parameters
    ----------
    field : callable
        Takes as many arrays of coordinates as there are lines, of one shape (n,); returns the values.  Those that are
        not finite do not count.
    lines : sequence of ndarray
        Ascending places of the first grid along each coordinate; a coordinate with a single place is held there.
    ends : sequence of tuple of float, optional
        Between which the search may leave the grid; the grid's own unless given.
    starts : int, optional
        Most local maxima of the grid from which the greatest is sought.
    rounds : int, optional
        Most boxes about each of them, for functions that are costly; with none the best place of the grid is returned.
    above : float, optional
        A value found elsewhere: tops that cannot be greater are given up.
    """
    reach = [(float(line[0]), float(line[-1])) for line in lines] if ends is None else list(ends)
    values = _on(field, lines)
    at = _tops(values)
    at = at[np.argsort(-values.flat[at], kind="stable")]
    best = Top(-math.inf, tuple(float(line[0]) for line in lines))
    for index in np.stack(np.unravel_index(at[:starts], values.shape), axis=1):
        centre = np.array([line[i] for line, i in zip(lines, index, strict=True)])
        half = np.array([_gap(line, i) for line, i in zip(lines, index, strict=True)])
        found = highest_near(field, centre, half, reach, rounds=rounds, above=max(best.value, above))
        best = max(best, Top(float(values[tuple(index)]), tuple(centre.tolist())), found, key=lambda top: top.value)
    return _on_line(field, lines, best)


def highest_of_curve(curve: Curve, end: float) -> float:
    """Return the greatest of the values from zero to the edge of a contact, infinite if one of both is.

    Parameters
    ----------
    curve : callable
        Values at places x >= 0 [m], finite between zero and the edge.
    end : float
        Where the edge is [m].
    """
    angles = np.linspace(0.0, 0.5 * np.pi, SAMPLES)
    values = np.asarray(curve(end * np.sin(angles)), dtype=float)
    if np.any(np.isposinf(values[[0, -1]])):
        return math.inf
    about_middle = np.concatenate((values[2:0:-1], values[:3]))  # it is even: a smooth top there is the middle itself
    if np.array_equal(_tops(values), [0]) and _is_smooth(about_middle, [np.intp(2)], 0):
        return float(values[0])
    return highest(lambda angle: curve(end * np.sin(angle)), [angles]).value


def _tops(values: Array) -> Array:
    """Return the flat indices of the local maxima of a grid; of equal values side by side, the first."""
    padded = np.pad(values, 1, constant_values=-np.inf)
    high = np.isfinite(values)
    for offset in itertools.product((-1, 0, 1), repeat=values.ndim):
        if any(offset):
            beside = padded[
                tuple(slice(1 + step, 1 + step + size) for step, size in zip(offset, values.shape, strict=True))
            ]
            high &= values > beside if offset < (0,) * values.ndim else values >= beside
    return np.flatnonzero(high)


def _on(field: Field, lines: Sequence[Array]) -> Array:
    """Return the values in all places of a grid; minus infinity where they are not finite."""
    places = np.meshgrid(*lines, indexing="ij")
    values = np.asarray(field(*(part.ravel() for part in places)), dtype=float).reshape(places[0].shape)
    return np.where(np.isfinite(values), values, -np.inf)


def _places(centre: float, half: float, low: float, high: float, places: int) -> Array:
    """Return the places of a box along one coordinate, cut off at the ends; the middle of a whole one is exact."""
    if half == 0.0:
        return np.array([centre])
    if low <= centre - half and centre + half <= high:
        return centre + half * np.linspace(-1.0, 1.0, places)
    return np.linspace(max(centre - half, low), min(centre + half, high), places)


def _gap(line: Array, index: int) -> float:
    """Return the distance to the farther neighbour of a place on a line."""
    return float(np.max(np.abs(line[max(index - 1, 0) : index + 2] - line[index])))


def highest_near(
    field: Field,
    centre: Array,
    first: Array,
    ends: Sequence[tuple[float, float]],
    *,
    rounds: int = MOST_ROUNDS,
    above: float = -math.inf,
    places: int = PLACES,
) -> Top:
    """Return the top about a place; less than it if it is below another one.

    Parameters
    ----------
    field : callable
        As of `highest`.
    centre, first : ndarray, (n,)
        Middle and half-widths of the first box.
    ends : sequence of tuple of float
        Between which the box may walk.
    rounds : int, optional
        Most boxes.
    above : float, optional
        A value found elsewhere.
    places : int, optional
        Of a box along one coordinate.  Of `FEW_PLACES` the last box is the top of the polynomial alone.
    """
    low, high = np.array(ends).T
    half, shrunk, best, before = first, np.zeros(first.size, dtype=bool), Top(-math.inf, ()), centre
    turn = walked = 0
    while turn < rounds and walked < MOST_ROUNDS:
        wide = half * (turn < rounds - 1 or places > FEW_PLACES)
        lines = [_places(*each, places) for each in zip(centre, wide, low, high, strict=True)]
        lower, middle, upper = (np.array([line[part * (line.size - 1) // 2] for line in lines]) for part in range(3))
        values = _on(field, lines)
        at = np.unravel_index(int(np.argmax(values)), values.shape)
        value, place = float(values[at]), np.array([line[i] for line, i in zip(lines, at, strict=True)])
        best = max(best, Top(value, tuple(place.tolist())), key=lambda top: top.value)
        on_face = (half > 0.0) & (((place == lower) & (lower > low)) | ((place == upper) & (upper < high)))
        about = values[tuple(slice(max(i - 1, 0), i + 2) for i in at)]
        beaten = turn >= SURE_ROUNDS and not np.any(on_face) and 2.0 * value - float(np.min(about)) <= above
        if beaten or float(np.ptp(values)) <= ROUNDING * abs(value):
            break
        top = _fitted_top(values, at)
        free = np.isfinite(top)
        centre = np.where(free, middle + 0.5 * (upper - lower) * np.nan_to_num(top), place)
        small = half <= np.where(free, SETTLED_SIZE, SAME_SIZE) * first
        if np.all(small & (np.abs(centre - before) <= SAME_PLACE * first)):
            return Top(best.value, tuple(centre.tolist()))
        held = ~free & ~on_face & ((place == middle) | (place == low) | (place == high))
        walked, turn = (walked + 1, turn) if np.any(on_face & ~shrunk) else (walked, turn + 1)
        size = np.where(on_face, WIDENED, HALVED)
        shrunk, before = free | held, centre
        half = np.where(shrunk, CENTRED, size) * half
    return best


def _fitted_top(values: Array, at: Sequence[np.intp]) -> Array:
    """Return where the polynomial through the values has its top, in half-widths of the box about its middle.

    Not a number along coordinates in which there is none, or which are held.
    """
    top = np.full(values.ndim, math.nan)
    free = [axis for axis in range(values.ndim) if _is_smooth(values, at, axis)]
    if not free:
        return top
    part = values[tuple(slice(None) if axis in free else i for axis, i in enumerate(at))]
    if not np.all(np.isfinite(part)):
        return top
    terms = (part - np.max(part)) / np.ptp(part)
    terms = _along_each(terms, [_fit(len(terms))] * len(free))
    place = np.linspace(-1.0, 1.0, len(terms))[[at[axis] for axis in free]]
    for _ in range(MOST_STEPS):
        rise, bend = _derivatives(terms, place)
        if not np.all(np.linalg.eigvalsh(bend) < 0.0):
            return top
        step = np.linalg.solve(bend, rise)
        place = place - step
        if np.max(np.abs(place)) > 1.0:
            return top
        if np.max(np.abs(step)) < SAME_STEP:
            break
    top[free] = place
    return top


def _is_smooth(values: Array, at: Sequence[np.intp], axis: int) -> bool:
    """Return whether the values along one coordinate through the best place are those of a smooth top."""
    row = values[tuple(slice(None) if other == axis else i for other, i in enumerate(at))]
    if row.size < FEW_PLACES or not np.all(np.isfinite(row)):
        return False
    _, rise, bend, *higher = _fit(row.size) @ (row - np.max(row))
    return bool(bend < 0.0 and abs(rise) <= -2.0 * bend and sum(map(abs, higher)) <= -SMOOTH * bend)


def _derivatives(terms: Array, place: Array) -> tuple[Array, Array]:
    """Return the first and the second derivatives of a polynomial of several coordinates at a place."""
    powers = np.arange(len(terms))
    factors = np.array([np.ones(powers.size), powers, powers * (powers - 1)])
    lower = np.maximum(powers - np.arange(3)[:, None], 0)
    found = _along_each(terms, [factors * x**lower for x in place])
    unit = np.eye(place.size, dtype=int)
    rise = np.array([found[tuple(one)] for one in unit])
    return rise, np.array([[found[tuple(one + other)] for other in unit] for one in unit])


def _along_each(values: Array, matrices: Sequence[Array]) -> Array:
    """Return the product of values on a grid with one matrix for each of its coordinates."""
    for matrix in matrices:
        values = (values.reshape(len(values), -1).T @ matrix.T).reshape(*values.shape[1:], -1)
    return values


@functools.cache
def _fit(places: int) -> Array:
    """Return the matrix that makes the terms of a polynomial of its values at the places of a box."""
    return np.linalg.inv(np.vander(np.linspace(-1.0, 1.0, places), increasing=True))


def _on_line(field: Field, lines: Sequence[Array], best: Top) -> Top:
    """Return a top whose place differs from lines of the grid by rounding as one on these lines."""
    for axis, line in enumerate(lines):
        index = int(np.argmin(np.abs(line - best.place[axis])))
        if 0.0 < abs(line[index] - best.place[axis]) <= math.sqrt(ROUNDING) * 10.0 * max(_gap(line, index), 1e-300):
            place = tuple(float(line[index]) if k == axis else each for k, each in enumerate(best.place))
            value = float(_on(field, [np.array([each]) for each in place]).ravel()[0])
            if value >= best.value - NOISE * abs(best.value):
                best = Top(value, place)
    return best
