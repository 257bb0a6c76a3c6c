r"""Boundary elements of a strip on half-planes, and its friction over one step: what sticks, and what slips where to.

Tractions are linear between evenly spaced nodes and zero at both ends.  The surfaces move along each other by

.. math:: u(x) = -\frac2{\pi E^*}\int q(s)\,\ln\frac{|x-s|}d\,\mathrm ds ,

counted from a distance d.  While the shift W is imposed, a node slips by :math:`S = W - u + u_0`, with what it was
displaced before; it sticks with S = 0 while friction allows, and slips in the direction of its traction otherwise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_ITERATIONS = 2000
FEW_CHANGED, MOST_CHANGED = 4, 32
"""Nodes that begin to stick or to slip before a solution is improved, and before the matrix is factorised anew."""
ALL_AT_ONCE = 30
"""Iterations in which all nodes change that are wrong."""


def strip_compliance(count: int, spacing: float, reference: float, exponent: float = 0.0) -> Array:
    """Return the displacement over 1/E* [m] at nodes 0, 1, ... `count` spacings away from a unit hat of traction.

    Parameters
    ----------
    count : int
        How far [-].
    spacing, reference : float
        Between nodes, and d [m].
    exponent : float, optional
        k: with (1 - |x/d|^-k) / k, of bodies graded by a power, in place of the logarithm.
    """
    # second difference of x^2/2 (ln|x/d| - 3/2), whose second derivative is ln|x/d|
    x = spacing * np.arange(-1.0, count + 2.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        lifted = np.log(np.abs(x) / reference)
        if exponent:
            k, rest = exponent, (1.0 - exponent) * (2.0 - exponent)
            lifted = (k * k - 3.0 * k - 2.0 * np.expm1(-k * lifted)) / (k * rest) + 1.5
        twice = np.where(x != 0.0, 0.5 * x * x * (lifted - 1.5), 0.0)
    return np.asarray(-2.0 / np.pi * np.diff(twice, 2) / spacing)


class StripStep(NamedTuple):
    """The strip after a step.

    Parameters
    ----------
    traction : ndarray, (n,)
        Over E* [-].
    slips : ndarray, (n,)
        -1, 0 or 1 where it slips backwards, sticks, slips forwards.
    shift : float
        W [m].
    moved : ndarray, (n,)
        Displacement of the nodes by the tractions [m].
    """

    traction: Array
    slips: Array
    shift: float
    moved: Array


def _runs(mask: Array) -> list[slice]:
    """Return where a mask is true, run by run."""
    turns = (np.flatnonzero(mask[1:] != mask[:-1]) + 1).tolist()
    ends = [0] * bool(mask[0]) + turns + [mask.size] * bool(mask[-1])
    return [slice(*pair) for pair in zip(ends[::2], ends[1::2], strict=True)]


def _displaced(compliance: Array, traction: Array, rows: Array, columns: Array) -> Array:
    """Return displacements by tractions on some nodes, at some nodes, zero elsewhere: they lie in few runs."""
    moved, parts = np.zeros(traction.size), _runs(columns)
    for at in _runs(rows):
        for by in parts:
            moved[at] += compliance[at, by] @ traction[by]
    return moved


class StuckStrip:
    """The nodes of a strip: what sticks on it is solved again and again, while few nodes begin to stick or to slip.

    The matrix of some nodes is factorised, and those that stick are these but for a few: added ones border the system,
    and a force of its own on each that is taken away keeps its traction zero.

    Parameters
    ----------
    compliance : ndarray, (n, n)
        Displacement of nodes by tractions over E* [m].
    weights : ndarray, (n,), optional
        Of the nodes in the sum of tractions, such as their widths; equal without them.
    """

    def __init__(self, compliance: Array, weights: Array | None = None) -> None:
        self.compliance = compliance
        self.weights: Array = np.ones(len(compliance)) if weights is None else weights
        # equations of displacements and of sums stand in one system: in units of their own none outweighs the others
        self._unit, self._width = float(compliance[0, 0]), float(np.max(self.weights))
        self._own, self._shares = compliance / self._unit, self.weights / self._width
        self._held = np.zeros(len(compliance), dtype=bool)
        self._rows, self._place = np.zeros(0, dtype=int), np.zeros(len(compliance), dtype=int)
        self._factors: tuple[Array, Array] = (np.zeros((0, 0)), np.zeros(0))
        self._even, self._columns = np.zeros(0), dict[int, Array]()

    def stuck(self, sticks: Array, wanted: Array, total: float | None) -> tuple[Array, float]:
        """Return tractions that displace what sticks as wanted, and a shift of it at which they have a given sum.

        Parameters
        ----------
        sticks : ndarray of bool, (n,)
            At least one.
        wanted : ndarray, (n,)
            Displacements [m], which count where it sticks.
        total : float, optional
            The weighted sum; without it nothing is shifted.

        Returns
        -------
        ndarray, (n,)
            Zero where nothing sticks.
        float
            The shift [m].
        """
        traction, shift = self._stuck(sticks, wanted / self._unit, None if total is None else total / self._width)
        return traction, shift * self._unit

    def _stuck(self, sticks: Array, wanted: Array, total: float | None) -> tuple[Array, float]:
        """Return the same, with displacements over the unit of compliance and sums over the greatest weight."""
        changed = np.flatnonzero(sticks != self._held)
        if changed.size > MOST_CHANGED:
            self._hold(sticks)
            changed = changed[:0]
        came, gone = changed[sticks[changed]], changed[~sticks[changed]]
        self._solve_for(changed)
        summed, rows = int(total is not None), self._rows
        columns = [self._columns[index] for index in (*came.tolist(), *gone.tolist())]
        border = np.stack([*columns, *[-self._even] * summed], axis=1) if columns or summed else None
        across, weights = self._own[came], self._shares
        sides = np.zeros((changed.size + summed, rows.size))  # equations of what has changed, and of the sum
        sides[: came.size] = across[:, rows]
        sides[np.arange(came.size, changed.size), self._place[gone]] = 1.0
        corner = np.zeros((len(sides), len(sides)))
        corner[: came.size, : came.size] = across[:, came]
        if summed:
            sides[-1], corner[-1, : came.size], corner[: came.size, -1] = weights[rows], weights[came], -1.0
        inverse = None if border is None else np.linalg.inv(corner - sides @ border)

        def solved(wanted: Array, total: float) -> tuple[Array, float]:
            traction, own = np.zeros(len(sticks)), self._solved(np.where(sticks, wanted, 0.0)[rows])
            if border is None or inverse is None:
                traction[rows] = own
                return traction, 0.0
            right = np.concatenate([wanted[came], np.zeros(gone.size), [total] * summed])
            beside = inverse @ (right - sides @ own)
            traction[rows] = own - border @ beside
            traction[came], traction[gone] = beside[: came.size], 0.0
            return traction, float(beside[-1]) if summed else 0.0

        traction, shift = solved(wanted, total or 0.0)
        if changed.size > FEW_CHANGED:  # the border costs digits: once more for what is left
            missing = wanted + shift - _displaced(self._own, traction, sticks, sticks)
            further, more = solved(missing, (total or 0.0) - float(weights @ traction))
            traction, shift = traction + further, shift + more
        return traction, shift

    def _hold(self, sticks: Array) -> None:
        """Factorise the matrix of what sticks."""
        from scipy.linalg import get_lapack_funcs, lu_factor

        self._held, self._rows = sticks.copy(), np.flatnonzero(sticks)
        self._place[self._rows] = np.arange(self._rows.size)
        self._factors = lu_factor(self._own[np.ix_(sticks, sticks)], overwrite_a=True, check_finite=False)
        (self._solve,) = get_lapack_funcs(("getrs",), self._factors[:1])
        self._columns.clear()
        self._even = self._solved(np.ones(self._rows.size))

    def _solve_for(self, changed: Array) -> None:
        """Solve for the columns of nodes that have changed, where that is not done."""
        missing = [index for index in changed.tolist() if index not in self._columns]
        if missing:
            right = np.zeros((self._rows.size, len(missing)))
            for column, index in enumerate(missing):
                if self._held[index]:
                    right[self._place[index], column] = 1.0
                else:
                    right[:, column] = self._own[self._rows, index]
            self._columns.update(zip(missing, self._solved(right).T, strict=True))

    def _solved(self, right: Array) -> Array:
        return np.asarray(self._solve(*self._factors, right)[0]) if self._rows.size else right


def strip_step(
    grid: StuckStrip,
    before: Array,
    bound: Array,
    slips: Array,
    *,
    shift: float = 0.0,
    total: float | None = None,
    rounding: float = 0.0,
) -> StripStep:
    """Return the strip after a step of a given shift, or one that brings its tractions to a given sum.

    Parameters
    ----------
    grid : StuckStrip
    before : ndarray, (n,)
        u_0 [m].
    bound : ndarray, (n,)
        Greatest traction over E* [-]; zero where nothing touches.
    slips : ndarray, (n,)
        Of the step before, from which the search begins.
    shift : float
        W [m], if no sum is given.
    total : float, optional
        Weighted sum of the tractions over E* [-].
    rounding : float, optional
        Part of the bound, and of the displacements, by which a node may miss its condition.

    Raises
    ------
    NotConverged
        If the zones of stick and slip are not found.
    """
    compliance, parts, touches = grid.compliance, grid.weights, bound > 0.0
    every = np.ones(bound.size, dtype=bool)
    for iteration in range(MOST_ITERATIONS):
        sticks = (slips == 0) & touches
        traction = np.where(sticks, 0.0, slips * bound)
        moved = _displaced(compliance, traction, every, traction != 0.0)
        if total is not None and not sticks.any():
            surplus = float(parts @ traction) - total
            sticks[first_to_stick(np.where(touches, slips, 0.0), before - moved, surplus)] = True
            traction = np.where(sticks, 0.0, traction)
            moved = _displaced(compliance, traction, every, traction != 0.0)
        if sticks.any():
            left = None if total is None else total - float(parts @ traction)
            held, found = grid.stuck(sticks, before - moved + (shift if total is None else 0.0), left)
            shift = shift if total is None else found
            # what sticks is displaced as it is wanted to be
            moved = np.where(sticks, shift + before, moved + _displaced(compliance, held, ~sticks, sticks))
            traction = traction + held
        slip = shift + before - moved
        least = rounding * float(np.max(np.abs(moved[touches]), initial=0.0)) if rounding else 0.0
        over = np.where(np.abs(traction) > bound * (1.0 + rounding), np.sign(traction), 0.0)
        better = np.where(sticks, over, np.where(slips * slip < -least, 0.0, slips))
        wrong = np.flatnonzero(touches & (better != np.where(sticks, 0.0, slips)))
        if wrong.size == 0:
            return StripStep(traction, np.where(sticks, 0.0, slips), shift, moved)
        changed = wrong if iteration < ALL_AT_ONCE else wrong[-1:]  # one at a time, the last, does not run in circles
        slips = np.where(sticks, 0.0, slips)
        slips[changed] = better[changed]
    raise NotConverged(
        f"The zones of stick and slip of a strip were not found in {MOST_ITERATIONS} iterations; give another count of "
        "elements or points, or a force farther from the one at which all slides."
    )


def first_to_stick(slips: Array, free: Array, surplus: float) -> int:
    """Return which node of a strip that slips everywhere comes to rest: friction bears more than the sum.

    Parameters
    ----------
    slips, free : ndarray, (n,)
        -1 or 1; slip without a shift [m].
    surplus : float
        By how much the sum of the tractions is too great: the shift is to fall, or to rise.
    """
    side = 1.0 if surplus > 0.0 else -1.0
    return int(np.argmin(np.where(slips == side, side * free, np.inf)))
