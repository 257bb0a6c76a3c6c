r"""A disc that rolls without slip on any medium, by boundary elements: Kalker's linear theory beyond half-spaces.

On the pixels of a disc the tractions are found under which material that comes in at the leading edge is moved by the
creepage alone.  Forces err in proportion to the size of a pixel, on a half-space as on layers.  So each is divided by
that of a half-space of nearly the same surface on the same pixels, multiplied by the coefficient of
`winkler.problems.rolling.linear_theory`, and extrapolated from half of the pixels (Richardson).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.media.mapped import MappedMedium
from winkler.numerics.caching import cached_by_value
from winkler.numerics.surfaces.rolled_surface import roll
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rolling.linear_theory import linear_creep_coefficients
from winkler.problems.rough.compliance import compliance_of

PIXELS = 64
"""Across the disc."""
STICKING_BOUND = 1e9
"""Bound on tractions over E* and creepage, under which all sticks."""
TOLERANCE = 1e-6


class RolledDisc(NamedTuple):
    """A disc under little creepage.

    Parameters
    ----------
    longitudinal, lateral
        Force over creepage and square of the radius [Pa]: c11 G and c22 G of half-spaces.
    error
        What the last halving of the pixels changed, over the forces [-].
    """

    longitudinal: float
    lateral: float
    error: float


@cached_by_value(64)
def rolled_disc(medium: MappedMedium, radius: float) -> RolledDisc:
    """Return how stiff a disc is that rolls without slip.

    Parameters
    ----------
    medium : MappedMedium
        The bodies; the coupling of tractions with pressures is left out.
    radius : float
        a [m].

    Raises
    ------
    OutsideValidity
        If a layer slides, or the modulus is proportional to the depth.
    NotConverged
        If moduli differ by more than boundary elements carry.
    """
    compliance = compliance_of(medium)
    poisson = min(compliance.along / (compliance.even + compliance.along), 0.5)
    even = Compliance(compliance.even, compliance.even * poisson / (1.0 - poisson))
    known = linear_creep_coefficients(1.0, poisson)
    exact = np.array([known.longitudinal, known.lateral]) * (medium.modulus * (1.0 - poisson) / even.even)
    coarse, fine = (
        exact * _forces(compliance, radius, count) / _forces(even, radius, count) for count in (PIXELS // 2, PIXELS)
    )
    found = 2.0 * fine - coarse
    return RolledDisc(float(found[0]), float(found[1]), float(np.max(np.abs(found / fine - 1.0))))


def _forces(compliance: Compliance, radius: float, count: int) -> Array:
    """Return the forces along and across over E*, creepage and square of the radius, with so many pixels across."""
    middles = np.arange(count + 2) - 0.5 * (count + 1)
    disc = (np.hypot(middles[:, None], middles) < 0.5 * count).astype(float)
    scaled = compliance.in_units_of(2.0 * radius / count)
    grid = TractionGrid.of(disc.shape, (1.0, 1.0), scaled, periodic=False)
    nothing, forces = np.zeros((2, *disc.shape)), []
    for axis in range(2):
        rigid = nothing.copy()
        rigid[axis] = disc
        rolled = roll(grid, STICKING_BOUND * disc, rigid, nothing, tolerance=TOLERANCE)
        forces.append(4.0 / count**2 * float(np.sum(rolled.traction[axis])))
    return np.array(forces)
