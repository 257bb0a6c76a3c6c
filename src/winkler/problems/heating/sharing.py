"""How two sliding bodies share the heat of friction, load by load and speed by speed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.laws.heat import HeatPartition
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.types import Array, Quantity
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.heat_source import HeatedContact, PointSource, heat_sources
from winkler.problems.heating.moved_body import HeatBody, moved_body

__all__ = ["SharedHeat"]

Motion = tuple[float, float]
"""Speed [m/s], and angle of the velocity to x [rad]."""


class SharedHeat(NamedTuple):
    """Two bodies that slide in a contact, and how they share the heat.

    Parameters
    ----------
    contact
        Of all loads.
    bodies
        What they conduct.
    partition
        How they share the heat.
    speeds
        Of both bodies [m/s], of one shape to which the loads of the contact broadcast.
    directions
        Angles of their velocities to x [rad].
    """

    contact: HeatedContact
    bodies: tuple[HeatBody, HeatBody]
    partition: HeatPartition
    speeds: Sequence[Quantity]
    directions: tuple[float, float]

    def over_all(self, asked: Callable[[PointSource | None, list[Motion]], Sequence[float]], rows: int) -> Array:
        """Return so many rows of numbers, (rows, ...), from source and motions at every load and speed."""
        shape, sources = np.shape(self.speeds[0]), heat_sources(self.contact)
        loads = np.shape(self.contact.depth)
        which = np.broadcast_to(np.arange(math.prod(loads)).reshape(loads), shape)
        table = np.zeros((rows, *shape))
        for place in np.ndindex(shape):
            pace = (float(np.asarray(speed)[place]) for speed in self.speeds)
            table[(slice(None), *place)] = asked(sources[which[place]], list(zip(pace, self.directions, strict=True)))
        return table

    def temperatures(self) -> Array:
        """Return the share of the first body [-], and temperatures of both for 1 W in all [K/W], (5, ...).

        Share; greatest of the first, of the second; mean of the first, of the second.
        """
        return self.over_all(self._shares, 5)

    def _shares(self, source: PointSource | None, motions: list[Motion]) -> Sequence[float]:
        if source is None:
            return idle_share(self.partition, self.bodies), 0.0, 0.0, 0.0, 0.0
        if isinstance(source, LineSource):  # alike to all sides
            motions = [(abs(speed), 0.0) for speed, _ in motions]
        moved = [moved_body(source, body, *motion) for body, motion in zip(self.bodies, motions, strict=True)]
        peaks, means = [each.peak.height for each in moved], [each.mean for each in moved]
        share = first_share(self.partition, peaks, means)
        return share, share * peaks[0], (1.0 - share) * peaks[1], share * means[0], (1.0 - share) * means[1]

    def estimated(self, per_watt: Callable[[PointSource, HeatBody, float, float], float]) -> Array:
        """Return an estimate of the greatest temperature of the contact per watt [K/W], zero without contact.

        Parameters
        ----------
        per_watt : Callable
            Source, body, speed and direction to the greatest temperature of 1 W [K/W].
        """

        def both(source: PointSource | None, motions: list[Motion]) -> Sequence[float]:
            if source is None:
                return [0.0]
            pairs = zip(self.bodies, motions, strict=True)
            alone = [np.asarray(per_watt(source, body, *motion)) for body, motion in pairs]
            return [float(shared(alone[0], alone[1], self.partition))]

        return np.asarray(self.over_all(both, 1)[0])
