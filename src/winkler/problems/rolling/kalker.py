r"""Kalker's creep coefficients: how steeply the creep force of a Hertzian contact rises from no creepage.

.. math:: F_x = G a b\,c_{11}\,\xi, \qquad F_y = G a b\,c_{22}\,\eta + G (ab)^{3/2} c_{23}\,\varphi

of an ellipse with the semi-axis a along and b across the direction of rolling.  The table is printed with three digits;
between its entries 1/c is interpolated, linearly over the ratio of the semi-axes, by a parabola over Poisson's ratio.
"""

from __future__ import annotations

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

DIGITS = 15
"""Of Poisson's ratio after the point: 0.5 stays within the table."""
SLENDERNESS = np.arange(1, 11) / 10.0
"""Ratio of the smaller to the larger semi-axis, the rows of the table."""
POISSON = np.array([0.0, 0.25, 0.5])
"""Poisson's ratios, the columns of each coefficient."""
ACROSS: Array = np.array([
    [2.51, 3.31, 4.85, 2.51, 2.52, 2.53, 0.334, 0.473, 0.731],
    [2.59, 3.37, 4.81, 2.59, 2.63, 2.66, 0.483, 0.603, 0.809],
    [2.68, 3.44, 4.80, 2.68, 2.75, 2.81, 0.607, 0.715, 0.889],
    [2.78, 3.53, 4.82, 2.78, 2.88, 2.98, 0.720, 0.823, 0.977],
    [2.88, 3.62, 4.83, 2.88, 3.01, 3.14, 0.827, 0.929, 1.07],
    [2.98, 3.72, 4.91, 2.98, 3.14, 3.31, 0.930, 1.03, 1.18],
    [3.09, 3.81, 4.97, 3.09, 3.28, 3.48, 1.03, 1.14, 1.29],
    [3.19, 3.91, 5.05, 3.19, 3.41, 3.65, 1.13, 1.25, 1.40],
    [3.29, 4.01, 5.12, 3.29, 3.54, 3.82, 1.23, 1.36, 1.51],
    [3.40, 4.12, 5.20, 3.40, 3.67, 3.98, 1.33, 1.47, 1.63],
])  # fmt: skip
"""a <= b: rows over a/b; c11, c22 and c23 at three Poisson's ratios each."""
ALONG: Array = np.array([
    [10.7, 11.7, 12.9, 10.7, 12.8, 16.0, 12.2, 14.6, 18.0],
    [6.96, 7.78, 8.82, 6.96, 8.14, 9.79, 5.72, 6.63, 7.89],
    [5.57, 6.34, 7.34, 5.57, 6.40, 7.51, 3.79, 4.32, 5.01],
    [4.84, 5.57, 6.57, 4.84, 5.48, 6.31, 2.88, 3.24, 3.70],
    [4.37, 5.10, 6.11, 4.37, 4.90, 5.56, 2.35, 2.62, 2.96],
    [4.06, 4.78, 5.80, 4.06, 4.50, 5.04, 2.01, 2.23, 2.50],
    [3.82, 4.54, 5.58, 3.82, 4.21, 4.67, 1.76, 1.95, 2.18],
    [3.65, 4.36, 5.42, 3.65, 3.99, 4.39, 1.58, 1.75, 1.94],
    [3.51, 4.22, 5.30, 3.51, 3.81, 4.16, 1.44, 1.59, 1.77],
    [3.40, 4.12, 5.20, 3.40, 3.67, 3.98, 1.33, 1.47, 1.63],
])  # fmt: skip
"""a >= b: rows over b/a."""


@value
class CreepCoefficients:
    """The creep coefficients of one ellipse and one Poisson's ratio.

    Parameters
    ----------
    longitudinal, lateral, spin : float
        c11, c22 and c23 [-].
    """

    __words__ = words(
        longitudinal=("c_{11}", "", "Kalker's coefficient of longitudinal creepage"),
        lateral=("c_{22}", "", "Kalker's coefficient of lateral creepage"),
        spin=("c_{23}", "", "Kalker's coefficient of spin"),
    )

    longitudinal: float
    lateral: float
    spin: float


@value
class RollingPair:
    """The modulus and Poisson's ratio with which a pair of bodies stands in Kalker's table.

    Parameters
    ----------
    shear : float
        G [Pa], of isotropic bodies 2/G = sum of 1/G of both; twice its own modulus of one body on a rigid one.
    poisson : float
        nu [-], of isotropic bodies 2 nu/G = sum of nu/G.
    """

    shear: float
    poisson: float


def rolling_pair(medium: HomogeneousMedium) -> RollingPair:
    """Return the combined modulus and Poisson's ratio of a pair of half-spaces.

    Tractions move their surfaces by two moduli, across waves and along them: G = 2 G_t, and nu = 2 - 2 G / G*.  Those
    of transversely isotropic bodies are an isotropic pair's, as far as tractions go.

    Parameters
    ----------
    medium : HomogeneousMedium

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> steel = Elastic(young=208e9, poisson=0.25)
    >>> rolling_pair(HalfSpace.between(steel, steel))
    RollingPair(shear=83200000000.0, poisson=0.25)
    """
    shear = 2.0 * medium.torsional_modulus
    return RollingPair(shear, round(2.0 - 2.0 * shear / medium.shear_modulus, DIGITS))


def creep_coefficients(ratio: float, poisson: float) -> CreepCoefficients:
    """Return Kalker's coefficients of an elliptic contact.

    Parameters
    ----------
    ratio : float
        a/b [-], the semi-axis along the direction of rolling over that across it, from 0.1 to 10.
    poisson : float
        nu [-], from 0 to 0.5.

    Returns
    -------
    CreepCoefficients

    Raises
    ------
    OutsideValidity
        If the ratio or Poisson's ratio lies outside the table.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, table E.3,
    doi:10.1007/978-94-015-7889-9

    Examples
    --------
    >>> creep_coefficients(1.0, 0.25).longitudinal
    4.12
    """
    if not 0.1 <= ratio <= 10.0:
        raise OutsideValidity(
            f"Kalker's table: the ratio of the semi-axes, along over across the direction of rolling, is {ratio:.6g}; "
            "the table goes from 0.1 to 10."
        )
    if not 0.0 <= poisson <= 0.5:
        raise OutsideValidity(f"Kalker's table: Poisson's ratio is {poisson:.6g}; the table goes from 0 to 0.5.")
    table, slenderness = (ACROSS, ratio) if ratio <= 1.0 else (ALONG, 1.0 / ratio)
    row = min(int(np.searchsorted(SLENDERNESS, slenderness, side="right")), SLENDERNESS.size - 1)
    share = (slenderness - SLENDERNESS[row - 1]) / (SLENDERNESS[row] - SLENDERNESS[row - 1])
    softness = ((1.0 - share) / table[row - 1] + share / table[row]).reshape(3, POISSON.size)
    return CreepCoefficients(*(1.0 / (softness @ _parabola(poisson))).tolist())


def _parabola(poisson: float) -> Array:
    """Return the weights of the three columns: the parabola through them."""
    t = poisson / POISSON[1]
    return np.array([0.5 * (t - 1.0) * (t - 2.0), t * (2.0 - t), 0.5 * t * (t - 1.0)])
