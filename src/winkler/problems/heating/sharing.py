"""How two sliding bodies share the heat of friction, load by load and speed by speed."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from winkler.laws.heat import HeatPartition
from winkler.numerics.types import Array, Quantity
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.heat_source import HeatSource, heat_sources, loads_over
from winkler.problems.heating.moved_body import HeatBody, moved_body
from winkler.problems.normal.indentation import IndentationSolution

__all__ = ["estimated", "shared_temperatures"]

Bodies = tuple[HeatBody, HeatBody]


def shared_temperatures(
    contact: IndentationSolution, bodies: Bodies, partition: HeatPartition, speeds: Sequence[Array]
) -> Array:
    """Return the share of the first body [-], and greatest and mean temperatures of both for 1 W [K/W].

    Parameters
    ----------
    contact : IndentationSolution
    bodies : tuple of ThermalConductor or Plated
    partition : EqualMaximum, EqualMean or FixedShare
    speeds : sequence of ndarray
        Those of both bodies [m/s], of one shape to which the loads of the contact broadcast.

    Returns
    -------
    ndarray, (5, ...)
        Share; greatest of the first, of the second; mean of the first, of the second.
    """
    shape = speeds[0].shape
    which, sources = loads_over(contact, shape), heat_sources(contact)
    table = np.zeros((5, *shape))
    for place in np.ndindex(shape):
        pair = [float(speed[place]) for speed in speeds]
        table[(slice(None), *place)] = _shares(sources[which[place]], bodies, partition, pair)
    return table


def _shares(
    heat: HeatSource | None, bodies: Bodies, partition: HeatPartition, speeds: Sequence[float]
) -> tuple[float, ...]:
    """Return the share of the first body, and greatest and mean temperatures of both for 1 W in all [K/W]."""
    if heat is None:
        return idle_share(partition, bodies), 0.0, 0.0, 0.0, 0.0
    moved = [moved_body(heat.source, body, abs(speed)) for speed, body in zip(speeds, bodies, strict=True)]
    peaks, means = [each.peak.height for each in moved], [each.mean for each in moved]
    share = first_share(partition, peaks, means)
    return share, share * peaks[0], (1.0 - share) * peaks[1], share * means[0], (1.0 - share) * means[1]


def estimated(
    per_watt: Callable[[HeatSource, HeatBody, Array], Array],
    contact: IndentationSolution,
    bodies: Bodies,
    partition: HeatPartition,
    speeds: tuple[Quantity, Quantity],
) -> Array:
    """Return an estimate of the greatest temperature of the contact per watt [K/W], zero without contact.

    Parameters
    ----------
    per_watt : Callable
        Source, body and speed to the greatest temperature of 1 W [K/W].
    contact : IndentationSolution
    bodies : tuple of ThermalConductor or Plated
    partition : EqualMaximum, EqualMean or FixedShare
    speeds : tuple of float or ndarray
        Those of both bodies [m/s], of one shape.
    """
    shape = np.shape(speeds[0])
    which, temperature = loads_over(contact, shape), np.zeros(shape)
    for j, source in enumerate(heat_sources(contact)):
        mine = which == j
        if source is not None:
            first, second = (
                per_watt(source, body, np.asarray(speed)[mine]) for speed, body in zip(speeds, bodies, strict=True)
            )
            temperature[mine] = shared(first, second, partition)
    return temperature
