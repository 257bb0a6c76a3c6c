"""Tabor's and Maugis' parameters: how far attraction stretches the edge of a contact, over its own range."""

from __future__ import annotations

import math

from winkler.values.checks.number_checks import POSITIVE, checked

MAUGIS_OVER_TABOR = 2.0 / math.cbrt(16.0 * math.pi / 9.0)
"""Maugis' parameter over Tabor's, if the range is work over strength."""
UNITS = {"curvature_radius": "m", "modulus": "Pa", "work": "J/m^2", "distance": "m", "strength": "Pa"}


def _positive(owner: str, **numbers: float) -> None:
    for word, number in numbers.items():
        checked(POSITIVE, owner, word, number, UNITS[word])


def tabor_parameter(*, curvature_radius: float, modulus: float, work: float, distance: float) -> float:
    """Return Tabor's parameter of a ball: how far attraction stretches the surfaces, in terms of its range.

    Parameters
    ----------
    curvature_radius : float
        R [m].
    modulus : float
        E* [Pa].
    work : float
        Work of adhesion [J/m^2].
    distance : float
        z_0 [m], over which the attraction acts: the spacing of the atoms, or work over strength.

    Returns
    -------
    float
        mu = (R w^2 / (E*^2 z_0^3))^(1/3) [-].

    Raises
    ------
    InvalidInput
        If a number is not positive and finite.

    References
    ----------
    D. Tabor, J. Colloid Interface Sci. 58 (1977) 2-13, doi:10.1016/0021-9797(77)90366-6

    Examples
    --------
    >>> round(tabor_parameter(curvature_radius=20e-9, modulus=70e9, work=0.1, distance=0.3e-9), 4)
    0.1148
    """
    _positive("tabor_parameter", curvature_radius=curvature_radius, modulus=modulus, work=work, distance=distance)
    return math.cbrt(curvature_radius * (work / modulus) ** 2) / distance


def maugis_parameter(*, curvature_radius: float, modulus: float, work: float, strength: float) -> float:
    """Return Maugis' parameter of a ball.

    Parameters
    ----------
    curvature_radius : float
        R [m].
    modulus : float
        E* [Pa].
    work : float
        Work of adhesion [J/m^2].
    strength : float
        sigma_0 [Pa].

    Returns
    -------
    float
        lambda = 2 sigma_0 (R / (pi w K^2))^(1/3), K = 4 E* / 3 [-].

    Raises
    ------
    InvalidInput
        If a number is not positive and finite.

    References
    ----------
    D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, doi:10.1016/0021-9797(92)90285-T
    """
    _positive("maugis_parameter", curvature_radius=curvature_radius, modulus=modulus, work=work, strength=strength)
    distance = work / strength
    tabor = tabor_parameter(curvature_radius=curvature_radius, modulus=modulus, work=work, distance=distance)
    return MAUGIS_OVER_TABOR * tabor
