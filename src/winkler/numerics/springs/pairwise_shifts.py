"""Rough shifts of curves along a logarithmic abscissa, by which each one overlaps with its neighbour."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array

TRIALS = 201
BEYOND = 0.5
"""Decades by which a curve is continued straight beyond its ends."""
APART = 0.01
"""Mean square misfit of logarithms of curves that do not overlap at all."""


def pairwise_shifts(measured: tuple[Measurements, ...], groups: int, reference: int) -> Array:
    """Return logarithms of shifts ``(groups,)``, zero at the reference; groups are in the order of temperature.

    Neighbours are shifted by the amount at which their moduli, interpolated linearly, differ least in the mean square.
    """
    shifts = np.zeros(groups)
    for index in range(1, groups):
        shifts[index] = shifts[index - 1] + _between(measured, index - 1, index)
    return np.asarray(shifts - shifts[reference])


def _between(measured: tuple[Measurements, ...], first: int, second: int) -> float:
    """Return the shift of the second curve relative to the first."""
    pairs = []
    for one in measured:
        turn = 1.0 if one.response is not Response.RELAXATION else -1.0
        curves = []
        for group in (first, second):
            own = one.group == group
            x = turn * np.log(one.abscissa[own])
            order = np.argsort(x)
            curves.append((x[order], np.log(one.modulus[own])[order]))
        pairs.append(tuple(curves))
    longest = max(float(np.ptp(x)) for pair in pairs for x, _ in pair)
    reach = 2.0 * longest + math.log(10.0)
    trials = np.linspace(-reach, reach, TRIALS)
    misfits = [_misfit(pairs, shift) for shift in trials.tolist()]
    return float(trials[int(np.argmin(misfits))])


def _misfit(pairs: list[tuple[tuple[Array, Array], ...]], shift: float) -> float:
    total, count = 0.0, 0
    for (x, y), (u, v) in pairs:
        for (a, b), (c, d) in (((x, y), (u + shift, v)), ((u + shift, v), (x, y))):
            expected, far = _continued(a, b, c)
            total += float(np.sum(np.where(far, APART, (d - expected) ** 2)))
            count += c.size
    return total / count


def _continued(x: Array, y: Array, at: Array) -> tuple[Array, Array]:
    """Return a curve interpolated and continued straight, and where that is too far from it."""
    if x.size == 1:
        return np.full(at.shape, y[0]), np.abs(at - x[0]) > BEYOND * math.log(10.0)
    low = y[0] + (at - x[0]) * (y[1] - y[0]) / (x[1] - x[0])
    high = y[-1] + (at - x[-1]) * (y[-1] - y[-2]) / (x[-1] - x[-2])
    beyond = BEYOND * math.log(10.0)
    far = (at < x[0] - beyond) | (at > x[-1] + beyond)
    return np.where(at < x[0], low, np.where(at > x[-1], high, np.interp(at, x, y))), far
