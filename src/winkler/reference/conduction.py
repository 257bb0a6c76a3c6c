"""Closed forms of contacts that conduct current or heat.

Resistivities rho [ohm m] for a current; for heat the inverse of the conductivity [m K/W].
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array


def holm_resistance(radius: float, *, first: float, second: float) -> float:
    """Return (rho_1 + rho_2) / (4 a) [ohm] of a clean disc between half-spaces.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1

    Examples
    --------
    >>> holm_resistance(0.5, first=1.0, second=1.0)
    1.0
    """
    return (first + second) / (4.0 * radius)


def elliptic_resistance(major: float, minor: float, *, first: float, second: float) -> float:
    """Return (rho_1 + rho_2) K(e) / (2 pi a) [ohm] of a clean ellipse with the semi-axes a >= b, e^2 = 1 - b^2/a^2.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, section 4, doi:10.1007/978-3-662-06688-1

    Examples
    --------
    >>> elliptic_resistance(2.0, 2.0, first=1.0, second=3.0)
    0.5
    """
    from scipy.special import ellipk

    return (first + second) * float(ellipk(1.0 - (minor / major) ** 2)) / (2.0 * math.pi * major)


def roess_factor(ratio: float) -> float:
    """Return by how much less a disc constricts on the end of a rod, for radii in a small ratio.

    Series of Roess for the flux of a disc of one voltage on a half-space, which is too even for a rod: the first
    coefficient is that of a disc of one voltage in the rod, the third is not; within 5e-4 up to a fifth.

    References
    ----------
    L. C. Roess, Theory of spreading conductance, Beacon Laboratories of Texas Company, Beacon 1950

    Examples
    --------
    >>> round(roess_factor(0.1), 6)
    0.859371
    """
    return 1.0 - 1.40925 * ratio + 0.29591 * ratio**3 + 0.05254 * ratio**5


def greenwood_resistance(x: Array, y: Array, radii: Array, *, first: float, second: float) -> float:
    """Return Greenwood's resistance [ohm] of many spots, with currents in proportion to the radii.

    References
    ----------
    J. A. Greenwood, Brit. J. Appl. Phys. 17 (1966) 1621-1632, doi:10.1088/0508-3443/17/12/310

    Examples
    --------
    >>> far = greenwood_resistance([0.0, 1e9], [0.0, 0.0], [1.0, 1.0], first=1.0, second=1.0)
    >>> round(far, 6)
    0.25
    """
    x, y, radii = (np.asarray(part, dtype=float) for part in (x, y, radii))
    whole, near = float(np.sum(radii)), 0.0
    for i in range(radii.size):
        for j in range(i):
            near += 2.0 * float(radii[i] * radii[j] / math.hypot(x[i] - x[j], y[i] - y[j]))
    return (first + second) * (1.0 / (4.0 * whole) + near / (2.0 * math.pi * whole**2))


def kohlrausch_temperature(voltage: float, *, ambient: float, lorenz_number: float) -> float:
    """Return the greatest temperature [K] in a contact without film, (T_0^2 + V^2 / (4 L))^(1/2).

    References
    ----------
    F. Kohlrausch, Annalen der Physik 306 (1900) 132-158

    Examples
    --------
    >>> round(kohlrausch_temperature(0.37, ambient=293.15, lorenz_number=2.4e-8), 1)  # silver melts at 1235 K
    1229.6
    """
    return math.sqrt(ambient**2 + voltage**2 / (4.0 * lorenz_number))


def small_voltage_rise(voltage: float, *, conductivity: float, resistivity: float) -> float:
    """Return V^2 / (8 lambda rho) [K], by how much a small voltage heats a contact of two like bodies.

    Examples
    --------
    >>> round(small_voltage_rise(0.01, conductivity=429.0, resistivity=15.9e-9), 4)
    1.8325
    """
    return voltage**2 / (8.0 * conductivity * resistivity)


def heated_growth(voltage: float, *, ambient: float, lorenz_number: float) -> float:
    """Return hot over cold resistance, v / atan(v) with v = V / (2 L^(1/2) T_0), if rho goes like T.

    The conductivity is then constant, and the potential of the constriction follows in closed form.

    Examples
    --------
    >>> round(heated_growth(0.1, ambient=293.15, lorenz_number=2.44e-8), 6)
    1.316653
    """
    v = voltage / (2.0 * math.sqrt(lorenz_number) * ambient)
    return v / math.atan(v) if v else 1.0
