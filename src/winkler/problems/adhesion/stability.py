r"""Which equilibria of an adhesive contact are stable: every stretch of radii between two limits, none overlooked.

The margin of stability is an explicit function of the contact radius.  It is resolved by Chebyshev polynomials on
panels that are halved until each polynomial ends, kinks of the profile being edges of panels; above a kink b the
variable is :math:`\sqrt{a^2-b^2}`.  A panel is done when its polynomial keeps its sign or is monotone, so that it holds
one root at most; that root is then sharpened on the margin itself.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, force_of, margin
from winkler.problems.adhesion.expected_radius import expected_radius
from winkler.values.errors import OutsideValidity

DEGREE = 16
RESOLVED_TAIL = 1e-9
"""Size of the last coefficients of a panel, relative to the largest, at which it counts as resolved."""
NOISE_TAIL = 1e-5
STEEPEST_MARGIN = 1e30
"""Stands for an infinite margin, where the profile ends in a vertical wall."""
MOST_HALVINGS = 40
MOST_PANELS = 20_000
NEGLIGIBLE_SHARE = 0.05
"""Below a radius where the profile's share of the margin stays under this, nothing is stable."""
OCTAVES = 6
"""Over so many octaves the share must stay small."""
OCTAVES_SEARCHED, OCTAVES_PER_BLOCK, SAMPLES_PER_OCTAVE = 40, 5, 100
"""Over so many octaves unstable radii are sought, so many at once, with so many samples in each."""


class Branch(NamedTuple):
    """Contact radii from `start` to `stop` [m] whose states are stable."""

    start: float
    stop: float


class _MarginPieces(NamedTuple):
    """Panels in y = sqrt(a^2 - base^2)."""

    base: Array
    low: Array
    high: Array

    def radius(self, share: Array) -> Array:
        """Return radii at parts (panels, n) of the pieces."""
        y = self.low[:, None] + (self.high - self.low)[:, None] * share
        return np.asarray(np.where(self.base[:, None] > 0.0, np.hypot(self.base[:, None], y), y))

    def chosen(self, which: Array) -> _MarginPieces:
        return _MarginPieces(self.base[which], self.low[which], self.high[which])

    def halved(self) -> _MarginPieces:
        middle = 0.5 * (self.low + self.high)
        return _MarginPieces(
            np.tile(self.base, 2), np.concatenate([self.low, middle]), np.concatenate([middle, self.high])
        )


@functools.lru_cache(maxsize=256)
def least_radius(states: EdgeStates) -> float:
    """Return a radius [m] below which no state is stable; zero if contacts of vanishing radius are.

    Raises
    ------
    OutsideValidity
        If stable states go on to ever smaller radii.
    """
    if states.from_nothing():
        return 0.0
    bed = states.bed
    a = 2.0 * expected_radius(states)
    below = 2.0 ** -np.linspace(0.0, OCTAVES, 4 * OCTAVES + 2)
    for _ in range(200):
        share = np.abs(bed.gap_slope(a * below) / states.scale(a * below))
        if np.all(share <= NEGLIGIBLE_SHARE):
            return a
        # a body r^n gives the share the power n - 1/2 of the radius; a paraboloid is the guess, a factor 1e6 the most
        worst = float(np.max(share))
        a *= max(min((0.5 * NEGLIGIBLE_SHARE / worst) ** (2.0 / 3.0), 0.25), 1e-6) if worst < math.inf else 1e-3
        if a < 1e-100:
            break
    raise OutsideValidity(
        "ShortRange: the contact is stable down to vanishing radii, because the body is as sharp as r^(1/2) or sharper "
        "at its apex; adhesion needs a profile that rises more slowly there."
    )


@functools.lru_cache(maxsize=256)
def branches(states: EdgeStates, machine_stiffness: float, high: float) -> tuple[Branch, ...]:
    """Return all stable stretches of radii up to `high`, ascending.

    Parameters
    ----------
    states : EdgeStates
    machine_stiffness : float
        [N/m]; 0 for a dead load, inf for fixed grips.
    high : float
        [m], not beyond the rim or the reach of the profile.

    Raises
    ------
    OutsideValidity
        If the margin of stability has more features than 20,000 panels resolve.
    """
    low, high = least_radius(states), float(high)
    limits, first = _limits(states, machine_stiffness, low, high) if low < high else (np.zeros(0), False)
    edges = [low, *limits.tolist(), high] if low < high else []
    stretches = [Branch(edges[i], edges[i + 1]) for i in range(0 if first else 1, len(edges) - 1, 2)]
    # a rim holds the edge whatever the margin is below it
    if high == states.bed.rim and not (stretches and stretches[-1].stop == high):
        stretches.append(Branch(high, high))
    return tuple(stretches)


def _limits(states: EdgeStates, machine_stiffness: float, low: float, high: float) -> tuple[Array, bool]:
    """Return where the margin changes its sign between two radii, and whether it is positive at first."""
    kinks = np.array([b for b, _ in states.bed.kinks if low < b < high])
    typical = low or typical_radius(states)
    pieces = _first_pieces(low, high, kinks, typical)
    start, stop, left, right = _signs(states, machine_stiffness, pieces, high)
    order = np.argsort(start)
    start, stop, left, right = start[order], stop[order], left[order], right[order]
    limits = list(start[1:][left[1:] != right[:-1]])  # at kinks
    crossed = left != right
    if crossed.any():
        limits += _sharpened(states, machine_stiffness, start[crossed], stop[crossed]).tolist()
    return np.sort(np.array(limits)), bool(left[0])


def _sharpened(states: EdgeStates, machine_stiffness: float, low: Array, high: Array) -> Array:
    """Return the roots of the margin in brackets; an end where rounding has put a root beyond it."""
    inner = np.nextafter(low, high), np.nextafter(high, low)  # at a kink the margin below it would be taken
    signs = margin(states, machine_stiffness, np.concatenate(inner)).reshape(2, -1)
    sound = np.sign(signs[0]) != np.sign(signs[1])
    result = np.where(np.abs(signs[0]) < np.abs(signs[1]), low, high)
    if sound.any():
        ends = (end[sound] for end in inner)
        result[sound] = between(lambda a, _: margin(states, machine_stiffness, a), *ends)
    return result


def _first_pieces(low: float, high: float, kinks: Array, typical: float) -> _MarginPieces:
    """Return panels that double: from the least radius to the first kink, and above each kink.

    Below a millionth of the typical radius the margin keeps its sign, a power of the radius.
    """
    bases, starts, stops = [], [], []
    ends = [*kinks.tolist(), high]
    for base, end in zip([0.0, *kinks.tolist()], ends, strict=True):
        stop = float(root_difference(np.array(end), np.array(base)))
        first = (low if low > 0.0 else min(end, typical) * 2.0**-20) if base == 0.0 else 0.25 * base
        edges = first * 2.0 ** np.arange(max(0, math.ceil(math.log2(stop / first)))) if stop > first else np.zeros(0)
        if base > 0.0:
            edges = np.concatenate([[0.0], edges])
        edges = np.append(edges[edges < stop], stop)
        bases += [base] * (edges.size - 1)
        starts += edges[:-1].tolist()
        stops += edges[1:].tolist()
    return _MarginPieces(np.array(bases), np.array(starts), np.array(stops))


def _signs(
    states: EdgeStates, machine_stiffness: float, waiting: _MarginPieces, high: float
) -> tuple[Array, Array, Array, Array]:
    """Return panels on which the margin keeps its sign or is monotone: their ends, and whether it is positive there."""
    angle = np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
    nodes = np.cos(0.5 * angle) ** 2
    matrix = np.cos(np.outer(np.arange(DEGREE + 1), angle)) * (2.0 / (DEGREE + 1))
    matrix[0] *= 0.5
    signs = np.where(np.arange(DEGREE + 1) % 2 == 0, 1.0, -1.0)
    inverse_roots = [b for b, strength in states.bed.kinks if strength != 0.0]
    before = np.full(waiting.base.size, np.inf)
    done = []
    used = 0
    for depth in range(MOST_HALVINGS + 1):
        radius = np.minimum(waiting.radius(nodes), high)
        values = np.clip(margin(states, machine_stiffness, radius.ravel()), -STEEPEST_MARGIN, STEEPEST_MARGIN).reshape(
            radius.shape
        )
        sharp = np.isin(waiting.base, inverse_roots)
        if sharp.any():
            # the root of the rounded radius takes the inverse root above the kink away exactly
            base = np.broadcast_to(waiting.base[sharp, None], (int(np.count_nonzero(sharp)), nodes.size))
            values[sharp] *= root_difference(radius[sharp], base) / radius[sharp]
        series = np.einsum("pn,kn->pk", values, matrix)
        size, tail = np.max(np.abs(series), axis=1), np.sum(np.abs(series[:, -3:]), axis=1)
        one_sign = np.abs(series[:, 0]) > np.sum(np.abs(series[:, 1:]), axis=1) + 10.0 * tail
        slope = np.polynomial.chebyshev.chebder(series, axis=1)
        monotone = np.abs(slope[:, 0]) > np.sum(np.abs(slope[:, 1:]), axis=1)
        resolved = (tail <= RESOLVED_TAIL * size) | ((tail > 0.3 * before) & (tail <= NOISE_TAIL * size))
        good = one_sign | (resolved & monotone) | (depth == MOST_HALVINGS)
        own = waiting.chosen(good)
        ends = np.minimum(own.radius(np.array([0.0, 1.0])), high)
        starts = np.where(one_sign, series[:, 0], series @ signs)[good] > 0.0
        stops = np.where(one_sign, series[:, 0], np.sum(series, axis=1))[good] > 0.0
        done.append((ends[:, 0], ends[:, 1], starts, stops))
        used += own.base.size
        if good.all():
            break
        if used + 2 * np.count_nonzero(~good) > MOST_PANELS:
            raise OutsideValidity(
                f"Up to a contact radius of {high:.3g} m the profile has too many waves to determine where the "
                "adhesive contact is stable; give a smaller load, or treat the body as rough."
            )
        waiting, before = waiting.chosen(~good).halved(), np.tile(tail[~good], 2)
    start, stop, left, right = (np.concatenate(part) for part in zip(*done, strict=True))
    return start, stop, left, right


@functools.lru_cache(maxsize=256)
def typical_radius(states: EdgeStates) -> float:
    """Return a radius [m] at which the force is not far from zero."""
    end, a = states.end(), expected_radius(states)
    with np.errstate(all="ignore"):
        while a > 1e-100 and float(force_of(states, np.array([a]))[0]) > 0.0:
            a *= 0.25
        while 4.0 * a < min(end, 1e100) and float(force_of(states, np.array([4.0 * a]))[0]) <= 0.0:
            a *= 4.0
    return a
