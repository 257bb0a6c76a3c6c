"""A row of relaxing springs under prescribed forces: steps in time, halved until the depth settles."""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import NotConverged
from winkler.problems.viscoelastic.march import SpringRow

__all__ = ["RESTING_FORCE", "SHORTEST_STEP", "ForceDriven"]

RESTING_FORCE = 1e-11
"""A body under no force rests on the surface with this part of the greatest one."""
SHORTEST_STEP = 1e-12
"""Part of a stretch of the path below which no step falls."""


class ForceDriven:
    """A row under forces; `little` is the error of depth that a step may have [m], `scale` the greatest force [N]."""

    def __init__(self, row: SpringRow, little: float, scale: float) -> None:
        self.row, self.little, self.scale = row, little, scale
        # where the force of a step is given by its mean, and where by its end
        self.parts = (0.25, 0.75, 0.5) if row.series.viscosity > 0.0 else (0.5, 1.0, 1.0)
        self.work, self.lost, self.stored, self.radius, self.ring = 0.0, 0.0, 0.0, 0.0, False
        self.rate, self.pace = 0.0, math.inf

    def _target(self, force: float) -> float:
        return max(force, RESTING_FORCE * self.scale)

    def jump(self, force: float) -> None:
        """Put a force on, or take it off, at once."""
        self._go(self.row.towards(self._target(force), 0.0, 0.0, self.scale), 0.0)

    def _go(self, change: float, dt: float) -> None:
        done = self.row.march(np.array([change]), np.array([dt]))
        self.work += float(done.work[0])
        self.lost += float(done.lost[0])
        self.stored, self.radius, self.ring = float(done.stored[0]), float(done.radius[0]), bool(done.ring[0])

    def ramp(self, start: float, end: float, duration: float) -> None:
        """Let the force change steadily."""
        done, pace = 0.0, min(self.pace, 0.125 * duration)
        while done < duration:
            dt = min(pace, duration - done)
            if duration - done - dt < 1e-9 * duration:
                dt = duration - done
            early, late, both = (self._target(start + (end - start) * (done + p * dt) / duration) for p in self.parts)
            first = self.row.towards(early, 0.5 * dt, 0.5 * self.rate * dt, self.scale)
            half = self.row.copy()
            half.march(np.array([first]), np.array([0.5 * dt]))
            second = half.towards(late, 0.5 * dt, first, self.scale)
            whole = self.row.towards(both, dt, first + second, self.scale)
            error = first + second - whole
            if abs(error) > self.little:
                if dt < SHORTEST_STEP * duration:
                    raise NotConverged(
                        "ViscoelasticIndentation: the depth under this force needs ever shorter steps; allow a greater "
                        "tolerance."
                    )
                pace = dt * max(0.2, 0.9 * (self.little / abs(error)) ** (1.0 / 3.0))
                continue
            self._go(first, 0.5 * dt)
            self._go(second, 0.5 * dt)
            self.rate = (first + second) / dt
            done = duration if dt == duration - done else done + dt
            grow = 0.9 * (self.little / max(abs(error), 1e-6 * self.little)) ** (1.0 / 3.0)
            pace = dt * min(4.0, max(0.3, grow))
        self.pace = pace
