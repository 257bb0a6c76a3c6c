"""A relaxing half-plane by boundary elements and small steps in time: no strips, no springs, no rule of unloading."""

from __future__ import annotations

import numpy as np


class RelaxingHalfPlane:
    """Strips of constant pressure, symmetric about the middle, on a solid with C(t) = C0 + C1 (1 - exp(-t/lag)).

    `shape` is the height of the rigid body, zero in the middle.
    """

    def __init__(self, shape, end, count, creep):
        edges = np.linspace(0.0, end, count + 1)
        self.x = 0.5 * (edges[1:] + edges[:-1])
        self.width, self.rise = end / count, shape(self.x)
        self.quick, self.slow, self.lag = creep
        sunk = self._sunk(edges[1:]) - self._sunk(edges[:-1]) + self._sunk(-edges[:-1]) - self._sunk(-edges[1:])
        self.kernel = -2.0 / np.pi * sunk
        self.pressure, self.delayed = np.zeros((2, count))

    def _sunk(self, edge):
        """The integral of ln|x - s| up to an edge, for every place and edge."""
        far = edge[None, :] - self.x[:, None]
        return far * np.log(np.abs(far)) - far

    def step(self, force, dt):
        """Go to a force per length, pressures changing steadily: return the pressures."""
        fade = np.exp(-dt / self.lag)
        mean = self.lag / dt * (1.0 - fade)
        # the delayed part at the end: it fades, and is driven by pressures from old to new
        begun = self.delayed * fade + self.slow * self.pressure * (mean - fade)
        own = self.quick + self.slow * (1.0 - mean)
        touching = self.pressure > 0.0 if np.any(self.pressure) else self.x < self.x[max(2, self.x.size // 20)]
        for _ in range(200 if force > 0.0 else 0):
            (inside,) = np.nonzero(touching)
            size = inside.size
            system = np.zeros((size + 1, size + 1))
            system[:size, :size] = own * self.kernel[np.ix_(inside, inside)]
            system[:size, size], system[size, :size] = -1.0, 2.0 * self.width
            right = np.append(-self.rise[inside] - self.kernel[inside] @ begun, force)
            found = np.linalg.solve(system, right)
            pressure = np.zeros(self.x.size)
            pressure[inside] = found[:size]
            gap = self.kernel @ (own * pressure + begun) + self.rise - found[size]
            changed = (touching & (pressure >= 0.0)) | (~touching & (gap < -1e-13))
            if np.array_equal(changed, touching):
                break
            touching = changed if changed.any() else gap == np.min(gap)
        else:
            assert force == 0.0, "the contact does not settle"
            pressure = np.zeros(self.x.size)
        self.pressure, self.delayed = pressure, begun + self.slow * (1.0 - mean) * pressure
        return pressure
