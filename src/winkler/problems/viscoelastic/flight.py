"""A body that flies against a row of relaxing springs, slowed by their exact impulse, until they let go."""

from __future__ import annotations

import numpy as np

from winkler.problems.viscoelastic.march import SpringMemory, SpringRow, refuse_rings

__all__ = ["Flight"]


class Flight:
    """A body of a mass [kg] that flies against a row of springs, and what it has met so far."""

    def __init__(self, row: SpringRow, mass: float, velocity: float) -> None:
        self.row, self.mass = row, mass
        self.time, self.velocity, self.lost = 0.0, velocity, 0.0
        self.lines = [(0.0, 0.0, velocity, 0.0, 0.0, 0.0, 0.0)]

    def greatest_depth(self) -> float:
        """Return the greatest depth so far [m]."""
        return max(line[1] for line in self.lines)

    def goes_on(self, dt: float) -> bool:
        """Fly for a time, or until the last spring lets go; return whether one is still pressed."""
        mean, held = self.row.struck(self.velocity, self.mass, dt)
        if self.velocity < 0.0 and held == 0:
            mean, dt = self._parting(dt)
            done = self.row.march(np.array([mean * dt]), np.array([dt]))
            self._arrive(mean, dt, done._replace(force=np.zeros(1), radius=np.zeros(1)))
            return False
        done = self.row.march(np.array([mean * dt]), np.array([dt]))
        self._arrive(mean, dt, done)
        refuse_rings("ViscoelasticImpact", np.array([self.time]), done.ring)
        return True

    def _arrive(self, mean: float, dt: float, done: SpringMemory) -> None:
        self.velocity, self.time = 2.0 * mean - self.velocity, self.time + dt
        depth = self.lines[-1][1] + mean * dt
        self.lost += float(done.lost[0])
        ends = float(done.force[0]), float(done.radius[0]), float(done.stored[0]), self.lost
        self.lines.append((self.time, depth, self.velocity, *ends))

    def _parting(self, dt: float) -> tuple[float, float]:
        """Return the mean velocity in the step that ends when the last spring lets go, and its length."""
        low, high = 0.0, dt
        for _ in range(40):
            middle = 0.5 * (low + high)
            _, held = self.row.struck(self.velocity, self.mass, middle)
            low, high = (middle, high) if held else (low, middle)
        return self.row.struck(self.velocity, self.mass, high)[0], high
