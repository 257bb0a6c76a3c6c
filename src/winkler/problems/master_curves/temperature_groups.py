"""Rows of sweeps that belong to one temperature, and the relaxation times that sweeps reach."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array

DECADES_BEYOND = 1.0
"""Decades of relaxation times beyond the measured ones."""
MOST_TERMS = 240


def grouped(temperature: Array, step: float) -> tuple[Array, Array]:
    """Return the mean of each temperature [K] ``(m,)``, rising, and its index for each row ``(n,)``."""
    order = np.argsort(temperature, kind="stable")
    group = np.empty(temperature.size, dtype=int)
    group[order] = np.concatenate([[0], np.cumsum(np.diff(temperature[order]) >= step)])
    return np.bincount(group, temperature) / np.bincount(group), group


def reached_times(one: Measurements, shifts: Array) -> Array:
    """Return logarithms of 1 / (omega a) or t / a of each row ``(n,)``."""
    turn = 1.0 if one.response is Response.RELAXATION else -1.0
    return np.asarray(turn * np.log(one.abscissa) - shifts[one.group])


def in_own_units(measured: tuple[Measurements, ...]) -> tuple[tuple[Measurements, ...], float, float]:
    """Return measurements of about one, and their units of abscissa and modulus: powers of two, which round nothing."""
    abscissa, modulus = (
        2.0 ** math.frexp(max(float(numbers.max()) for numbers in of_each))[1]
        for of_each in ([one.abscissa for one in measured], [one.modulus for one in measured])
    )
    scaled = (one._replace(abscissa=one.abscissa / abscissa, modulus=one.modulus / modulus) for one in measured)
    return tuple(scaled), abscissa, modulus


def spread_times(measured: tuple[Measurements, ...], shifts: Array, per_decade: int) -> Array:
    """Return relaxation times from before the measurements to after them [s]."""
    places = np.concatenate([reached_times(one, shifts) for one in measured])
    low, high = float(places.min()), float(places.max())
    decades = (high - low) / math.log(10.0) + 2.0 * DECADES_BEYOND
    count = min(math.ceil(decades * per_decade) + 1, MOST_TERMS)
    beyond = DECADES_BEYOND * math.log(10.0)
    return np.exp(np.linspace(low - beyond, high + beyond, count))


def longest_run(times: Array, known: Array) -> tuple[float, float]:
    """Return the first and last of the longest row of neighbouring times that are known; zeros if there is none."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(int)))
    if not edges.size:
        return 0.0, 0.0
    starts, ends = edges[::2], edges[1::2]
    best = int(np.argmax(ends - starts))
    return float(times[starts[best]]), float(times[ends[best] - 1])
