"""The points out of contact at the beginning and at the end of a curve.

Each branch is followed from its far end on: its force is a straight line over the number of the point, so that tilt,
drift and drag change nothing, until means of neighbours leave the line by more than its noise and stay away.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.events.record import Record, deviation, moving_mean
from winkler.numerics.types import Array

FEWEST_FREE = 10
MOST_SPLITS = 100
"""Most trial ends of the line."""
CUBIC = 3
POINTS_PER_MEAN, MOST_AVERAGED = 60, 8
DEPARTURE_TO_NOISE, LEAST_DEPARTURE_SHARE = 5.0, 2e-4
"""Least departure from the line in standard deviations of the means, and relative to the range of forces."""
LEAST_PERSISTENCE = 3
"""Number of independent means in a row that depart."""
KEPT_SHARE = 0.97
MOST_LINE_SHARE = 0.4
"""Greatest change of the force along a free line, relative to the range of forces."""
MOST_SLOPE_SHARE = 0.5
"""Greatest slope of a free line, relative to the mean slope behind it."""
LEAST_CURVED_SHARE, MOST_LEFT_BY_PARABOLA = 0.1, 0.1
"""Free part, relative to the branch, below which it must not be a parabola, and the squares that a parabola leaves."""
ROUNDS = 4


class FreeBranch(NamedTuple):
    """The free line of one branch, counted from its far end.

    Parameters
    ----------
    points : int
        Number of free points; zero if there are too few.
    level, slope : float
        Force at the far end [N], and its change from point to point.
    noise : float
        Standard deviation of the force [N].
    mean_noise : float
        Standard deviation of means of `averaged` neighbours [N].
    averaged : int
    """

    points: int
    level: float = 0.0
    slope: float = 0.0
    noise: float = 0.0
    mean_noise: float = 0.0
    averaged: int = 1

    def line(self, size: int) -> Array:
        """Return the free force of the first `size` points [N]."""
        return np.asarray(self.level + self.slope * np.arange(size))


class FreeParts(NamedTuple):
    """The free branches before and after contact, and their points as indices."""

    before: FreeBranch
    after: FreeBranch
    before_points: Array
    after_points: Array


def free_parts(record: Record) -> FreeParts:
    """Return the points out of contact, before and after."""
    going, coming = record.incoming, record.outgoing
    before = free_branch(record.force[going])
    after = free_branch(record.force[coming][::-1])
    return FreeParts(
        before,
        after,
        np.arange(going.start, going.start + before.points),
        np.arange(coming.stop - after.points, coming.stop),
    )


def free_branch(force: Array) -> FreeBranch:
    """Return the free line of forces that begin far from the sample."""
    size = force.size
    if size < 2 * FEWEST_FREE:
        return FreeBranch(0)
    averaged = int(np.clip(size // POINTS_PER_MEAN, 1, MOST_AVERAGED))
    span = float(np.ptp(force))
    count = max(FEWEST_FREE, int(0.7 * _split(force)))
    seen = {count}
    branch = FreeBranch(0)
    for _ in range(ROUNDS):
        branch = _line(force, count, averaged)
        departure = _departure(force, branch, span)
        if departure < FEWEST_FREE:
            return FreeBranch(0)
        count = size if departure == size else max(int(KEPT_SHARE * (departure - averaged // 2)), 1)
        if count in seen or count < FEWEST_FREE:
            break
        seen.add(count)
    if count < FEWEST_FREE:
        return FreeBranch(0)
    branch = _line(force, count, averaged)
    return FreeBranch(0) if _is_contact(force, branch, span) else branch


def _split(force: Array) -> int:
    """Return the end of a line, before a cubic, with the least squares of both."""
    size = force.size
    splits = np.unique(np.linspace(FEWEST_FREE, size - FEWEST_FREE, MOST_SPLITS).astype(int))
    along, level = 2.0 * np.arange(size) / size - 1.0, force - force.mean()
    powers = along[:, None] ** np.arange(2 * CUBIC + 1)
    sums = np.concatenate([np.zeros((1, powers.shape[1])), np.cumsum(powers, axis=0)])
    products = np.concatenate([np.zeros((1, CUBIC + 1)), np.cumsum(powers[:, : CUBIC + 1] * level[:, None], 0)])
    explained = _explained(sums[splits], products[splits], 1)
    explained += _explained(sums[-1] - sums[splits], products[-1] - products[splits], CUBIC)
    return int(splits[np.argmax(explained)])


def _explained(sums: Array, right: Array, degree: int) -> Array:
    """Return the squares explained by polynomials ``(m,)``, from sums of powers and of their products with levels."""
    order = np.add.outer(np.arange(degree + 1), np.arange(degree + 1))
    numbers = np.einsum("mij,mj->mi", np.linalg.pinv(sums[:, order], hermitian=True), right[:, : degree + 1])
    return np.asarray(np.einsum("mi,mi->m", numbers, right[:, : degree + 1]))


def _line(force: Array, count: int, averaged: int) -> FreeBranch:
    part = force[:count]
    along = np.arange(count) - 0.5 * (count - 1)
    slope = float(along @ part) / float(along @ along)
    level = float(part.mean()) - slope * 0.5 * (count - 1)
    left = part - level - slope * np.arange(count)
    noise = float(np.sqrt(left @ left / max(count - 2, 1)))
    means = moving_mean(left, min(averaged, count))
    mean_noise = max(deviation(means), noise / np.sqrt(averaged))
    return FreeBranch(count, level, slope, noise, mean_noise, averaged)


def _departure(force: Array, branch: FreeBranch, span: float) -> int:
    """Return the first point from which means leave the line; the number of points if there is none."""
    count, width = branch.points, branch.averaged
    means = np.abs(moving_mean(force - branch.line(force.size), width))
    along = np.arange(means.size) - 0.5 * (count - 1)
    memory = branch.mean_noise * np.sqrt(width)  # more than the noise where neighbours are correlated
    line_error = memory * np.sqrt(1.0 / count + along**2 / (count * (count**2 - 1.0) / 12.0))
    limit = DEPARTURE_TO_NOISE * branch.mean_noise + 3.0 * line_error
    departs = means > np.maximum(limit, LEAST_DEPARTURE_SHARE * span)
    departs[: count // 2] = False
    rows = LEAST_PERSISTENCE * width
    counts = np.concatenate([[0], np.cumsum(departs)])
    needed = np.minimum(np.arange(means.size) + rows, means.size) - np.arange(means.size)
    lasting = counts[np.arange(means.size) + needed] - counts[: means.size] == needed
    found = np.flatnonzero(lasting)
    return int(found[0]) if found.size else int(force.size)


def _is_contact(force: Array, branch: FreeBranch, span: float) -> bool:
    """Return whether the line is a good part of the force, or nearly as steep as what follows it."""
    if branch.points < LEAST_CURVED_SHARE * force.size and _bends(force[: branch.points]):
        return True
    change = abs(branch.slope) * branch.points
    behind = force.size - branch.points
    if change > MOST_LINE_SHARE * span:
        return True
    steepest = abs(float(force[-3:].mean() - branch.line(force.size)[branch.points - 1])) / max(behind, 1)
    is_certain = change > DEPARTURE_TO_NOISE * branch.noise
    return behind >= FEWEST_FREE and is_certain and abs(branch.slope) > MOST_SLOPE_SHARE * steepest


def _bends(force: Array) -> bool:
    """Return whether a parabola explains nearly all that a line leaves: the beginning of a contact, without noise."""
    along = np.linspace(-1.0, 1.0, force.size)
    line, parabola = (force - np.polyval(np.polyfit(along, force, degree), along) for degree in (1, 2))
    return float(parabola @ parabola) < MOST_LEFT_BY_PARABOLA * float(line @ line)
