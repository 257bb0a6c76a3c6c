r"""How stiff springs are that roll: calibrated by Kalker's coefficients, or as they are.

The springs' tangential stiffness G* is that of a traction that is the same all around the contact.  In rolling it is
not, and the line is 33 % to 49 % too soft.  With

.. math:: \kappa_x = \tfrac12 c_{11} G, \qquad \kappa_y = \tfrac12 c_{22} G

in the place of G*, and the coefficients of a circle, the creep force of a ball begins as Kalker's does.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

import numpy as np

from winkler.foundation.bed import Bed
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.rolling.distances import MEASURED_BY, MEASURED_ON_LAYERS, ON_LAYERS, ball_distances
from winkler.problems.rolling.kalker import creep_coefficients, rolling_pair
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

if TYPE_CHECKING:
    from winkler.media.mapped import MappedMedium
    from winkler.problems.rolling.rolled_disc import RolledDisc

KALKER = (
    "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, table E.3, "
    "doi:10.1007/978-94-015-7889-9"
)
HERTZIAN_DEPARTURE = 0.01
"""How far a profile may be from a parabola, in parts of the depth, to be called Hertzian."""


@value
class Kalker:
    """Spring stiffness from Kalker's coefficients of a round contact (default)."""

    def stiffness(self, bed: Bed, radius: float) -> tuple[float, float]:
        """Return c11 G / 2 and c22 G / 2 [Pa]; for layers and graded bodies from a disc without slip.

        Parameters
        ----------
        bed : Bed
        radius : float
            a [m] of the contact.

        Raises
        ------
        OutsideValidity
            If Poisson's ratio is negative, or that of tractions on an anisotropic surface outside Kalker's table.
        """
        if not isinstance(bed.medium, HomogeneousMedium):
            disc = _disc(bed, radius)
            return 0.5 * disc.longitudinal, 0.5 * disc.lateral
        pair = rolling_pair(bed.medium)
        coefficients = creep_coefficients(1.0, pair.poisson)
        return 0.5 * coefficients.longitudinal * pair.shear, 0.5 * coefficients.lateral * pair.shear

    def notes(self, bed: Bed, radius: float) -> tuple[Note, ...]:
        """Return the validity notes of calibrated springs."""
        if not isinstance(bed.medium, HomogeneousMedium):
            statement = (
                "The spring stiffness is that of a disc rolling without slip, computed by boundary elements "
                f"within {100.0 * _disc(bed, radius).error:.1g} per cent. Each strip across the rolling direction "
                "carries at most mu times its normal load. Compared with boundary elements for a ball on layers and "
                "power laws whose moduli differ up to tenfold, the creep force differs by at most "
                f"{ON_LAYERS[0]:.2g} mu F_N under one creepage (longitudinal or lateral), by at most "
                f"{ON_LAYERS[1]:.2g} mu F_N under both."
            )
            if departure(bed.height, radius) > HERTZIAN_DEPARTURE:
                statement += " This body is not a ball; the error is not known."
            return (Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, MEASURED_ON_LAYERS),)
        part = departure(bed.gap, radius)
        one, both = ball_distances(rolling_pair(bed.medium).poisson)
        statement, source = (
            "The spring stiffness is calibrated with Kalker's coefficients, which give the initial slope of the "
            "creep force. Compared with Kalker's exact theory, up to full sliding, this force differs by at "
            f"most {one:.2g} mu F_N under one creepage (longitudinal or lateral), by at most {both:.2g} mu F_N "
            "under both.",
            MEASURED_BY,
        )
        if part > HERTZIAN_DEPARTURE:
            statement, source = (
                "The spring stiffness is scaled with Kalker's coefficients of a round Hertzian contact. This "
                f"profile is not Hertzian: its plane profile deviates from the parabola by {part:.2g} of its "
                "depth. The error is not known.",
                KALKER,
            )
        return (Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, source),)


@value
class Uncalibrated:
    """Springs with the stiffness G* of a contact at rest, for comparison."""

    def stiffness(self, bed: Bed, radius: float) -> tuple[float, float]:
        """Return G* for both directions [Pa].

        Parameters
        ----------
        bed : Bed
            On a homogeneous medium.
        radius : float
            Contact radius a [m]; the result does not depend on it.
        """
        stiffness = float(bed.tangential_stiffness(np.array([1.0]))[0])
        return stiffness, stiffness

    def notes(self, bed: Bed, radius: float) -> tuple[Note, ...]:
        """Return a note that states the error of the stiffness."""
        return (
            Note(
                Assumption.CALIBRATION,
                Standing.OUTSIDE,
                "The springs are not calibrated, and the traction in rolling is not axisymmetric. Compared "
                "with Kalker's coefficients of a circle, for Poisson's ratios from 0 to 0.5, the initial slope of the "
                "creep force is too low by 41 to 49 % (longitudinal) and 33 to 41 % (lateral).",
                KALKER,
            ),
        )


def _disc(bed: Bed, radius: float) -> RolledDisc:
    """Return the disc that rolls on layers or a grading; what solves for it is loaded for these alone."""
    from winkler.problems.rolling.rolled_disc import rolled_disc

    return rolled_disc(cast("MappedMedium", bed.medium), radius)


def departure(profile: Callable[[Array], Array], radius: float) -> float:
    """Return how far a profile leaves the parabola through its end, in parts of its height there."""
    x = radius * np.linspace(0.0, 1.0, 17)[1:]
    gap = profile(x)
    if gap[-1] <= 0.0:
        return 1.0
    return float(np.max(np.abs(gap / gap[-1] - (x / radius) ** 2)))
