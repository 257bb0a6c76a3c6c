"""How far the simplified theories of rolling are from the exact one: distances measured with `SurfaceRolling`.

Over longitudinal, lateral and spin creepages from a tenth of sliding to beyond it, and several together, the greatest
difference of the force over mu F_N and of the moment over mu F_N sqrt(ab), rounded up to hundredths
with 0.005 for pixels and creepages between.
`benchmarks/rolling_distances.py` made the tables; between their entries the greatest neighbour is stated.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

MEASURED_BY = (
    "compared with boundary elements (SurfaceRolling) on ellipses with a/b from 0.2 to 5 and Poisson's ratios from 0 "
    "to 0.5, and on a circle with CONTACT's curves"
)
RATIOS = (0.2, 0.5, 1.0, 2.0, 5.0)
"""a/b, the rows of the table."""
POISSON = (0.0, 0.25, 0.5)
"""Poisson's ratios, its columns."""
OF_ELLIPSES: Array = np.array([
    [[0.06, 0.06, 0.15, 0.02, 0.17], [0.06, 0.13, 0.20, 0.05, 0.14], [0.06, 0.29, 0.30, 0.10, 0.18]],
    [[0.05, 0.05, 0.16, 0.03, 0.09], [0.05, 0.10, 0.19, 0.05, 0.08], [0.06, 0.21, 0.24, 0.07, 0.08]],
    [[0.05, 0.05, 0.18, 0.03, 0.11], [0.05, 0.07, 0.19, 0.05, 0.09], [0.05, 0.14, 0.19, 0.06, 0.09]],
    [[0.04, 0.04, 0.19, 0.04, 0.13], [0.04, 0.04, 0.17, 0.05, 0.12], [0.04, 0.06, 0.15, 0.05, 0.10]],
    [[0.04, 0.04, 0.16, 0.05, 0.17], [0.04, 0.04, 0.14, 0.05, 0.14], [0.04, 0.06, 0.13, 0.05, 0.13]],
])  # fmt: skip
"""Entries in the order of `EllipseDistances`."""
OF_BALLS: Array = np.array([[0.03, 0.03], [0.04, 0.07], [0.04, 0.14]])
"""Under one creepage and under both."""

ON_LAYERS = (0.08, 0.2)
"""Of a ball on layers, gradings and power laws: under one creepage and under both."""
MEASURED_ON_LAYERS = (
    "compared with boundary elements (SurfaceRolling) on layers ten times stiffer and softer than what carries them, "
    "of a thirtieth to three times the contact radius, Poisson's ratios from 0 to 0.5, and on power laws"
)


class EllipseDistances(NamedTuple):
    """Distances of `SimplifiedRolling` from the exact theory.

    Parameters
    ----------
    one, both, spun
        Of the force over mu F_N: under a longitudinal or a lateral creepage, under both, and with spin.
    moment, spun_moment
        Of the moment over mu F_N sqrt(ab), without and with spin.
    """

    one: float
    both: float
    spun: float
    moment: float
    spun_moment: float


def ellipse_distances(ratio: float, poisson: float) -> EllipseDistances | None:
    """Return the distances on an ellipse of a ratio a/b and a Poisson's ratio; none where they were not measured."""
    if not RATIOS[0] <= ratio <= RATIOS[-1]:
        return None
    rows, columns = _beside(RATIOS, ratio), _beside(POISSON, poisson)
    return EllipseDistances(*np.max(OF_ELLIPSES[rows, columns], axis=(0, 1)).tolist())


def ball_distances(poisson: float) -> tuple[float, float]:
    """Return the distances of `Rolling` under one creepage and under both, on a ball."""
    one, both = np.max(OF_BALLS[_beside(POISSON, poisson)], axis=0).tolist()
    return one, both


def _beside(places: tuple[float, ...], place: float) -> slice:
    """Return the entries on both sides of a place."""
    first = int(np.searchsorted(places, place, side="right")) - 1
    return slice(max(first, 0), int(np.searchsorted(places, place, side="left")) + 1)
