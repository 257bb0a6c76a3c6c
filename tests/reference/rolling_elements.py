"""A ball that rolls with a little creepage and without slip, by boundary elements: Kalker's coefficients of a circle.

Square patches of even traction; their displacements are corner sums of Cerruti's point forces.  From one patch to the
next against rolling the surfaces of two like bodies, G = 1, move apart by the creepage: the leading patches are set by
what the surface does ahead of them.
"""

from __future__ import annotations

import numpy as np

SIZES = (14, 20, 28, 40)


def displacements(dx: np.ndarray, dy: np.ndarray, side: float, nu: float) -> np.ndarray:
    """u_x of traction along x, u_y of traction along y, and either of the other, both bodies together."""
    found = np.zeros((3, *dx.shape))
    for sx in (1.0, -1.0):
        for sy in (1.0, -1.0):
            x, y = dx + sx * side / 2.0, dy + sy * side / 2.0
            along, across = y * np.arcsinh(x / np.abs(y)), x * np.arcsinh(y / np.abs(x))
            both = (1.0 - nu) * (along + across)
            found += sx * sy * np.array([both + nu * along, both + nu * across, -nu * np.hypot(x, y)])
    return found / np.pi


def coefficients(count: int, nu: float) -> np.ndarray:
    """c11, c22 and c23 of `count` patches across, for a disc of the patches' area."""
    side = 2.0 / count
    place = (np.arange(count) + 0.5) * side - 1.0
    x, y = np.meshgrid(place, place, indexing="ij")
    inside = x**2 + y**2 < 1.0
    x, y = x[inside], y[inside]
    size = np.sqrt(np.pi / (x.size * side**2))

    def moved(ahead: float) -> np.ndarray:
        k = displacements(x[:, None] + ahead - x, y[:, None] - y, side, nu)
        return np.block([[k[0], k[2]], [k[2], k[1]]])

    none, ones = np.zeros(x.size), np.ones(x.size)
    requested = np.column_stack([np.r_[ones, none], np.r_[none, ones], np.r_[-y, x]])
    forces = np.linalg.solve((moved(0.0) - moved(side)) / side, requested) * side**2
    return np.abs(
        [
            forces[: x.size, 0].sum() * size**2,
            forces[x.size :, 1].sum() * size**2,
            forces[x.size :, 2].sum() * size**3,
        ]
    )


def extrapolated(nu: float) -> np.ndarray:
    """c11, c22 and c23 of patches that are infinitely small: the parabola through SIZES."""
    found = np.array([coefficients(count, nu) for count in SIZES])
    return np.array([np.polyfit(1.0 / np.array(SIZES), column, 2)[-1] for column in found.T])
