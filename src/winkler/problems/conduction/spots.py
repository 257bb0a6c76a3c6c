r"""Many spots at once: rough bodies touch in clusters, and the spots of a cluster add to each other's resistance.

If every spot took a current in proportion to its radius, the resistance were Greenwood's

.. math:: R \approx \frac{\rho_1+\rho_2}{4\sum_i a_i}
          + \frac{\rho_1+\rho_2}{2\pi}\,\frac{\sum_{i\ne j} a_i a_j/s_{ij}}{(\sum_i a_i)^2} ,

each on its own and Holm's constriction of the whole cluster; the second part is that of a disc of the *Holm radius*.
Here the currents are found so that all spots have one voltage (`winkler.numerics.fields.disc_charges`).
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.materials.conducting_body import resistivity_of
from winkler.materials.conductor import ElectricalConductor
from winkler.numerics.fields.disc_charges import currents
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, Advice, FiniteRow, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing, standing_left
from winkler.values.value import value, words

EXPANSION_DEGREES = ((40, 6), (120, 4), (400, 2))
"""Up to how many spots their fluxes are expanded to which degree."""
LEFT = 2.0
"""Error that is left over the last change, at most: 1.6 of random clusters whose spots nearly touch."""
GREENWOOD = (
    "J. A. Greenwood, Constriction resistance and the real area of contact, Brit. J. Appl. Phys. 17 (1966) 1621-1632, "
    "doi:10.1088/0508-3443/17/12/310"
)


@value
class SpotCluster:
    """Two thick conductors in contact through round spots of one plane.

    Parameters
    ----------
    x, y : array_like, (n,)
        Centres of the spots [m].
    radii : array_like, (n,)
        [m], positive; the spots must not overlap.
    first, second : ElectricalConductor
        The bodies.

    Raises
    ------
    InvalidInput
        If the arrays do not fit one another, a radius is not positive, spots overlap, or there are more than 400.

    References
    ----------
    J. A. Greenwood, Brit. J. Appl. Phys. 17 (1966) 1621-1632, doi:10.1088/0508-3443/17/12/310

    Examples
    --------
    >>> unit = ElectricalConductor(resistivity=1.0)
    >>> pair = SpotCluster([0.0, 1.0], [0.0, 0.0], [0.334, 0.255], unit, unit).solve()
    >>> round(pair.resistance, 5), round(pair.greenwood, 4)
    (1.00767, 1.0052)
    """

    __words__ = words(
        x=("x_i", "m", "middles of the spots, along x"),
        y=("y_i", "m", "middles of the spots, along y"),
        radii=("a_i", "m", "radii of the spots"),
    )

    x: FiniteRow
    y: FiniteRow
    radii: Annotated[Array, Numbers(POSITIVE), Advice("leave such spots out")]
    first: ElectricalConductor
    second: ElectricalConductor

    references: ClassVar[tuple[str, ...]] = ("greenwood_1966", "holm_1967")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.RESOLUTION,))

    def __post_init__(self) -> None:
        sizes = {word: getattr(self, word).size for word in ("x", "y", "radii")}
        if len(set(sizes.values())) > 1 or self.radii.size == 0:
            raise InvalidInput(
                f"SpotCluster: there are {sizes['x']} x, {sizes['y']} y and {sizes['radii']} radii; give one of each "
                "for every spot."
            )
        if self.radii.size > EXPANSION_DEGREES[-1][0]:
            raise InvalidInput(
                f"SpotCluster: {self.radii.size} spots are too many; give at most {EXPANSION_DEGREES[-1][0]}, or use "
                "groups of them for spots of their Holm radius."
            )
        spacing = self._spacing
        i, j = np.unravel_index(int(np.argmin(spacing - np.add.outer(self.radii, self.radii))), spacing.shape)
        if spacing[i, j] <= self.radii[i] + self.radii[j]:
            raise InvalidInput(
                f"SpotCluster: the spots {min(i, j)} and {max(i, j)} overlap; move them apart, or give one in their "
                "place."
            )

    @property
    def _spacing(self) -> Array:
        """Distances of the spots [m]; infinite from themselves."""
        apart = np.hypot(np.subtract.outer(self.x, self.x), np.subtract.outer(self.y, self.y))
        np.fill_diagonal(apart, np.inf)
        return np.asarray(apart)

    def solve(self) -> SpotClusterSolution:
        """Return the resistance and the fraction of the current through every spot.

        Returns
        -------
        SpotClusterSolution
        """
        degree = next(degree for most, degree in EXPANSION_DEGREES if self.radii.size <= most)
        charges, coarse = currents(self.x, self.y, self.radii, degree)
        rho = resistivity_of(self.first) + resistivity_of(self.second)
        resistance = rho / (2.0 * math.pi * float(np.sum(charges)))
        own = rho / (4.0 * float(np.sum(self.radii)))
        near = self.radii @ (1.0 / self._spacing) @ self.radii
        greenwood = own + rho / (2.0 * math.pi) * float(near) / float(np.sum(self.radii)) ** 2
        return SpotClusterSolution(
            self,
            resistance=resistance,
            greenwood=greenwood,
            alone=own,
            shares=charges / np.sum(charges),
            uncertainty=LEFT * abs(float(np.sum(charges)) / float(np.sum(coarse)) - 1.0),
        )


@value
class SpotClusterSolution:
    """The solution of a `SpotCluster`.

    Parameters
    ----------
    problem : SpotCluster
        The problem that was solved.
    resistance : float
        R [ohm], all spots at one voltage.
    greenwood : float
        Greenwood's estimate of it [ohm].
    alone : float
        (rho_1 + rho_2) / (4 sum of radii) [ohm]: resistance of the same spots far from each other.
    shares : ndarray, (n,)
        Part of the current that goes through every spot [-].
    uncertainty : float
        Estimate of the relative error of the resistance: twice its change in the last refinement.
    """

    problem: SpotCluster
    resistance: float
    greenwood: float
    alone: float
    shares: Array
    uncertainty: float

    @property
    def conductance(self) -> float:
        """1 / R [S]."""
        return 1.0 / self.resistance

    @property
    def holm_radius(self) -> float:
        """Holm radius [m]: radius of the disc with the interaction resistance of the spots; infinite for one spot."""
        rho = resistivity_of(self.problem.first) + resistivity_of(self.problem.second)
        crowding = self.resistance - self.alone
        return rho / (4.0 * crowding) if self.problem.radii.size > 1 else math.inf

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (
            Note(
                Assumption.RESOLUTION,
                standing_left(self.uncertainty),
                "All spots have one voltage. The relative error of the resistance is at most "
                f"{self.uncertainty:.1g}, twice the change in the last refinement.",
                "W. Wolfe's eigenfunctions of the disc, Galerkin's method",
            ),
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                "Greenwood's estimate, with currents proportional to the radii, differs by "
                f"{100.0 * (self.greenwood / self.resistance - 1.0):.2g} %.",
                GREENWOOD,
            ),
        )
