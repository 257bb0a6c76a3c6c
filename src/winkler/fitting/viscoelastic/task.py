r"""The fit of a relaxing contact: what its machine does, and the derivatives of what is predicted.

The motion drives, :math:`D_i-D_0-u\,t_i`, and forces are fitted (`winkler.fitting.viscoelastic.motion`); or the forces
drive, and the positions are fitted (`winkler.fitting.viscoelastic.creep`).  In both the contact bears what is left of
the measured force,

.. math:: F_i = F_\mathrm{contact} + F_0 + t\,(D_i-D_0) + c_v\,\dot D_i + e_i ,

without baseline, tilt, and the drag of a liquid on the cantilever.
"""

from __future__ import annotations

import dataclasses
from typing import Self

import numpy as np

from winkler.fitting.task import STEP, Prediction, Task, moved
from winkler.numerics.types import Array

__all__ = ["Driven"]

COARSE_STEP = 1e-3
"""Step of numbers that change the number of terms of a series, whose error jumps there."""
SHAPES = ("exponent", "relaxation_time")


@dataclasses.dataclass(frozen=True, eq=False)
class Driven(Task):
    """A contact that relaxes, in the order in which it was measured, held points included.

    Parameters
    ----------
    velocity : ndarray, (n,)
        Of the machine [m/s].
    per_force : ndarray, (n,)
        Where positions are fitted: the position [m/N] that counts as much as a misfit of force, at points whose force
        is fitted instead; zero at all others.
    """

    velocity: Array
    per_force: Array

    settled = 1e-9
    must_settle = False
    coarse_count = 250
    starts_improved = 3
    starts_are_trials = True

    @property
    def size(self) -> float:
        """Norm of what was measured about its mean, weighted."""
        measured = self.measured * self.weights
        return float(np.linalg.norm(measured - measured.mean()))

    @property
    def turn(self) -> int:
        """The first point on the way out; n if there is none."""
        out = np.flatnonzero(self.curve.direction < 0.0)
        return int(out[0]) if out.size else self.curve.count

    def place(self, numbers: dict[str, float]) -> Array:
        """Return D from first touch, without drift [m]."""
        since = self.curve.time - self.curve.time[0]
        return np.asarray(self.along(numbers) - numbers.get("drift", 0.0) * since)

    def line(self, numbers: dict[str, float]) -> Array:
        """Return the part of the force that the contact does not bear [N]."""
        return np.asarray(super().line(numbers) + numbers.get("drag", 0.0) * self.velocity)

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate, central where the number of terms may change."""
        parameter = self.parameters[index]
        rough = parameter.name.startswith("bed.medium.") and parameter.name.rpartition(".")[2] in SHAPES
        step = self.step(coordinates, index, COARSE_STEP if rough else STEP)
        ahead = self.prediction(moved(coordinates, index, step)).fitted
        if rough and coordinates[index] - step > parameter.inward(parameter.low):
            behind = self.prediction(moved(coordinates, index, -step)).fitted
            return np.asarray((ahead - behind) / (2.0 * step))
        return np.asarray((ahead - prediction.fitted) / step)

    def some_of(self, stretch: Array) -> Array:
        """Return points evenly spaced, and more of them where the contact has just begun to rest or is deepest."""
        share = max(self.coarse_count // (2 * self._stretches), 10)
        last = stretch.size - 1
        near = np.geomspace(1.0, max(last, 1), min(share, stretch.size)) - 1.0  # what is fast happens at once
        turned = last - near if self.curve.direction[stretch[0]] > 0.0 else near
        even = np.linspace(0, last, min(share, stretch.size))
        return np.asarray(stretch[np.concatenate([even, turned]).astype(int)])

    @property
    def _stretches(self) -> int:
        return 1 + int(np.count_nonzero(np.diff(self.curve.direction)))

    def chosen(self, kept: Array) -> Self:
        """Return the task of some of the points, given as indices."""
        return dataclasses.replace(super().chosen(kept), velocity=self.velocity[kept], per_force=self.per_force[kept])
