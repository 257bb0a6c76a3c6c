"""How two bodies in elliptic contact share the heat of friction, and what they would do at rest or in fast motion."""

from __future__ import annotations

import math

import numpy as np

from winkler.laws.heat import HeatPartition
from winkler.materials.conductor import ThermalConductor
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.types import Array
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.heated_ellipse import half_length
from winkler.problems.heating.pressed_source import PressedSource

__all__ = ["estimated_ellipse", "estimated_pressed", "shared_ellipse_temperatures"]

FAST_HEIGHT = 1.2346198309610955
"""Greatest integral of sqrt(1 - s^2)/sqrt(pi (t - s)) from -1 to t, at t = 0.652: Hertz' flux in fast motion."""
Bodies = tuple[ThermalConductor, ThermalConductor]
Pair = tuple[float, float]


def shared_ellipse_temperatures(
    source: EllipticSource | PressedSource | None,
    bodies: Bodies,
    partition: HeatPartition,
    speeds: Pair,
    directions: Pair,
) -> tuple[float, ...]:
    """Return the share of the first body, and greatest and mean temperatures of both for 1 W in all [K/W].

    Parameters
    ----------
    source : EllipticSource or PressedSource
        Where the heat enters; none without contact.
    bodies : tuple of ThermalConductor
    partition : EqualMaximum, EqualMean or FixedShare
    speeds, directions : tuple of float
        Those of both bodies [m/s], and their angles to x [rad].

    Returns
    -------
    tuple of float
        Share; greatest of the first, of the second; mean of the first, of the second.
    """
    if source is None:
        return idle_share(partition, bodies), 0.0, 0.0, 0.0, 0.0
    peaks, means = [], []
    for speed, direction, body in zip(speeds, directions, bodies, strict=True):
        wave = speed / body.diffusivity
        peaks.append(source.peak(wave, direction).height / body.conductivity)
        means.append(source.mean(wave, direction) / body.conductivity)
    share = first_share(partition, peaks, means)
    return share, share * peaks[0], (1.0 - share) * peaks[1], share * means[0], (1.0 - share) * means[1]


def estimated_ellipse(
    axes: tuple[Array, Array],
    bodies: Bodies,
    partition: HeatPartition,
    peclets: tuple[Array, Array],
    directions: Pair,
) -> Array:
    """Return the flash temperature per watt of bodies that move fast, or rest where their Peclet number is zero [K/W].

    Parameters
    ----------
    axes : tuple of ndarray
        Semi-axes along x and y [m], positive, all of one ratio.
    bodies, partition, directions
        As of `shared_ellipse_temperatures`.
    peclets : tuple of ndarray
        V l / (2 kappa) of both bodies [-].
    """
    a, b = axes
    like = EllipticSource(1.0, float(np.ravel(b)[0] / np.ravel(a)[0]))
    at_rest, alone = like.peak(0.0, 0.0).height / a, []
    for peclet, direction, body in zip(peclets, directions, bodies, strict=True):
        moves, length = peclet > 0.0, half_length(a, b, direction)
        fast = FAST_HEIGHT * 1.5 / (math.pi * a * b) * length / np.sqrt(2.0 * np.where(moves, peclet, 1.0))
        alone.append(np.where(moves, fast, at_rest) / body.conductivity)
    return shared(alone[0], alone[1], partition)


def estimated_pressed(
    source: PressedSource, bodies: Bodies, partition: HeatPartition, speeds: Pair, directions: Pair
) -> float:
    """Return the same of one contact by pixels, at these speeds, zero of a body at rest [m/s]."""
    at_rest, alone = source.peak(0.0, 0.0).height, []
    for speed, direction, body in zip(speeds, directions, bodies, strict=True):
        height = source.fast(direction) / math.sqrt(speed / body.diffusivity) if speed else at_rest
        alone.append(np.asarray(height / body.conductivity))
    return float(shared(alone[0], alone[1], partition))
