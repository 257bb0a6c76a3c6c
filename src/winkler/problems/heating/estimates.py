r"""Estimates of flash temperatures to compare with: slow and fast sliding, and the fit of Tian and Kennedy.

Each gives the greatest temperature of a body for 1 W; the bodies share the heat by Blok's rule, or as given.
Tian and Kennedy fitted the greatest temperature under a parabolic flux (that of Hertz' pressure) with the mean q by

.. math:: T = \frac{1.31\,q\,a}{\lambda\sqrt{1.2344+\mathrm{Pe}}} .
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.laws.heat import EqualMean, FixedShare, HeatPartition
from winkler.materials.conducting_body import layers_of
from winkler.materials.conductor import ThermalConductor
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.types import Array
from winkler.problems.heating.heat_source import PointSource
from winkler.problems.heating.moved_body import HeatBody, moved_body, top


def stationary(source: PointSource, body: HeatBody, speed: float, direction: float) -> float:
    """Return the greatest temperature of 1 W [K/W] as if the body were at rest."""
    return moved_body(source, body, 0.0, 0.0).peak.height


def fast(source: PointSource, body: HeatBody, speed: float, direction: float) -> float:
    """Return the greatest temperature of 1 W [K/W] as if a body that moves did so fast; one at rest counts as such.

    At high speed a plated body answers as its plating.
    """
    if speed == 0.0:
        return stationary(source, body, speed, direction)
    surface = top(body)
    return source.fast(direction) / math.sqrt(abs(speed) / surface.diffusivity) / surface.conductivity


def tian_kennedy(source: PointSource, body: HeatBody, speed: float, direction: float) -> float:
    """Return the greatest temperature of 1 W [K/W] under a parabolic flux on the same disc, by the fit.

    Platings are left out: the fit is that of the body below them.
    """
    assert isinstance(source, LineSource)  # others are refused
    _, base = layers_of(body)
    assert isinstance(base, ThermalConductor)
    peclet = 0.5 * abs(speed) * source.radius / base.diffusivity
    return 1.31 / (math.pi * source.radius * math.sqrt(1.2344 + peclet)) / base.conductivity


def first_share(partition: HeatPartition, greatest: Sequence[Any], means: Sequence[Any]) -> Any:
    """Return the part of the heat that goes into the first body, from temperatures of both as if all went into each."""
    match partition:
        case FixedShare(fixed):
            return fixed
        case EqualMean():
            return means[1] / (means[0] + means[1])
        case _:
            return greatest[1] / (greatest[0] + greatest[1])


def idle_share(partition: HeatPartition, bodies: Sequence[HeatBody]) -> float:
    """Return the first body's part of the heat of bodies that do not touch: a fixed one, or that of bodies at rest."""
    first, second = (top(body).conductivity for body in bodies)
    return partition.first_share if isinstance(partition, FixedShare) else first / (first + second)


def shared(first: Array, second: Array, partition: HeatPartition) -> Array:
    """Return the greatest temperature per watt of both bodies together, from those each would have alone [K/W]."""
    if isinstance(partition, FixedShare):
        share = partition.first_share
        with np.errstate(invalid="ignore"):
            parts = [np.where(part > 0.0, part * own, 0.0) for part, own in ((share, first), (1.0 - share, second))]
        return np.maximum(*parts)
    return np.asarray(1.0 / (1.0 / first + 1.0 / second))
