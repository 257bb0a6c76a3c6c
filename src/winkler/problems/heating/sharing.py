"""How two sliding bodies share the heat of friction, load by load and speed by speed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.laws.heat import HeatPartition
from winkler.numerics.types import Array, Quantity
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.moved_body import HeatBody

Motion = tuple[float, float]
"""Speed [m/s], and angle of the velocity to x [rad]."""


class SharedHeat(NamedTuple):
    """Two bodies that slide in a contact, and how they share the heat.

    Parameters
    ----------
    sources
        Where 1 W, or 1 W per length, enters under each load; None where there is no contact.
    loads
        Shape of the loads.
    bodies
        What they conduct.
    partition
        How they share the heat.
    speeds
        Of both bodies [m/s], of one shape to which the loads broadcast.
    directions
        Angles of their velocities to x [rad].
    """

    sources: Sequence[Any]
    loads: tuple[int, ...]
    bodies: tuple[HeatBody, HeatBody]
    partition: HeatPartition
    speeds: Sequence[Quantity]
    directions: tuple[float, float] = (0.0, 0.0)

    def temperatures(self, warmed: Callable[[Any, HeatBody, float, float], tuple[float, float]]) -> Array:
        """Return the share of the first body [-], and temperatures of both for 1 W in all [K/W], (5, ...).

        Share; greatest of the first, of the second; mean of the first, of the second.

        Parameters
        ----------
        warmed : Callable
            Source, body, speed and direction to the greatest and the mean temperature of 1 W [K/W].
        """

        def both(source: Any, motions: list[Motion]) -> Sequence[float]:
            pairs = [warmed(source, body, *motion) for body, motion in zip(self.bodies, motions, strict=True)]
            peaks, means = zip(*pairs, strict=True)
            share = first_share(self.partition, peaks, means)
            return share, share * peaks[0], (1.0 - share) * peaks[1], share * means[0], (1.0 - share) * means[1]

        return self._over_all(both, (idle_share(self.partition, self.bodies), 0.0, 0.0, 0.0, 0.0))

    def estimated(self, per_watt: Callable[[Any, HeatBody, float, float], float]) -> Array:
        """Return an estimate of the greatest temperature of the contact per watt [K/W], zero without contact.

        Parameters
        ----------
        per_watt : Callable
            Source, body, speed and direction to the greatest temperature of 1 W [K/W].
        """

        def both(source: Any, motions: list[Motion]) -> Sequence[float]:
            pairs = zip(self.bodies, motions, strict=True)
            alone = [np.asarray(per_watt(source, body, *motion)) for body, motion in pairs]
            with np.errstate(divide="ignore"):
                return [float(shared(alone[0], alone[1], self.partition))]

        return np.asarray(self._over_all(both, (0.0,))[0])

    def _over_all(self, asked: Callable[[Any, list[Motion]], Sequence[float]], apart: Sequence[float]) -> Array:
        """Return rows of numbers, (rows, ...), from source and motions at every load and speed; `apart` without one."""
        shape = np.shape(self.speeds[0])
        which = np.broadcast_to(np.arange(math.prod(self.loads)).reshape(self.loads), shape)
        table = np.zeros((len(apart), *shape))
        for place in np.ndindex(shape):
            pace = (float(np.asarray(speed)[place]) for speed in self.speeds)
            source, motions = self.sources[int(which[place])], list(zip(pace, self.directions, strict=True))
            table[(slice(None), *place)] = apart if source is None else asked(source, motions)
        return table
