r"""Energy of the surfaces over their gap: laws of attraction, in units of the work of adhesion and the range.

Each law has the potential :math:`\varphi(g)`, its slope, which is the stress that pulls, and its curvature.  Gaps are
counted in ranges, energies in works of adhesion: the well is one deep.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class Exponential(NamedTuple):
    """-exp(-g) behind a wall at zero.

    Parameters
    ----------
    least
        The smallest gap, where the wall stands.
    touch
        The gap up to which surfaces touch.
    peak
        The greatest pull.
    """

    least: float = 0.0
    touch: float = 0.0
    peak: float = 1.0

    def terms(self, gap: Array) -> tuple[Array, Array, Array]:
        """Return potential, pull and stiffness."""
        pull = np.exp(-gap)
        return -pull, pull, -pull


class EightTwo(NamedTuple):
    """-4/3 (g^-2 - g^-8/4), between two half-spaces of molecules with a Lennard-Jones potential, at rest at g = 1.

    Parameters
    ----------
    least, touch, peak
        As of `Exponential`; the wall stands where surfaces press a hundred thousand times more than they ever pull.
    """

    least: float = 0.3
    touch: float = 1.0
    peak: float = 16.0 / (9.0 * math.sqrt(3.0))

    def terms(self, gap: Array) -> tuple[Array, Array, Array]:
        """Return potential, pull and stiffness."""
        square = 1.0 / (gap * gap)
        sixth = square * square * square
        potential = square * (sixth - 4.0) / 3.0
        pull = 8.0 / 3.0 * square / gap * (1.0 - sixth)
        return potential, pull, 8.0 * square * square * (3.0 * sixth - 1.0)


class RoundedStep(NamedTuple):
    """Dugdale's constant pull, which ends over a part of the range around it instead of at once.

    Parameters
    ----------
    half_width
        Of the part over which it ends, as a sine.
    least, touch, peak
        As of `Exponential`.
    """

    half_width: float
    least: float = 0.0
    touch: float = 0.0
    peak: float = 1.0

    def terms(self, gap: Array) -> tuple[Array, Array, Array]:
        """Return potential, pull and stiffness."""
        s = self.half_width
        beyond = np.clip((gap - 1.0) / s, -1.0, 1.0)
        angle = 0.5 * math.pi * beyond
        ending = 0.5 * s * (beyond - 1.0) + s / math.pi * np.cos(angle)
        stiffness = np.where(np.abs(beyond) < 1.0, -0.25 * math.pi / s * np.cos(angle), 0.0)
        return ending + np.minimum(gap - (1.0 - s), 0.0), 0.5 - 0.5 * np.sin(angle), stiffness


Attraction = Exponential | EightTwo | RoundedStep
"""A law in units of its work and range."""
