r"""Heat on a disc of radius a on a half-space: stationary, fast, and just switched on.

With the heat Q [W] and the conductivity :math:`\lambda`: under the flux of Hertz' pressure and at rest

.. math:: T = \frac{3Q}{16\lambda a}\Bigl(2-\frac{r^2}{a^2}\Bigr),\quad r\le a ,

under a uniform flux :math:`T=\frac{2Q}{\pi^2\lambda a}E(r^2/a^2)`, with the elliptic integral of the parameter.
A point source in a body that moves along x at the speed V heats by :math:`Q/(2\pi\lambda R)\,e^{-V(R-x)/2\kappa}`.

References
----------
.. [1] H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, Oxford 1959, chapter 10.
.. [2] J. C. Jaeger, Moving sources of heat and the temperature at sliding contacts, Proc. R. Soc. New South Wales 76
   (1942) 203-224.
.. [3] X. Tian, F. E. Kennedy, Maximum and average flash temperatures in sliding contacts, J. Tribol. 116 (1994)
   167-174, doi:10.1115/1.2927035.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def hertz_heat_temperature(heat: float, radius: float, conductivity: float, r: ArrayLike) -> Array:
    """Return T [K] at distances r [m] under the flux of Hertz' pressure at rest; heat [W], conductivity [W/(m K)]."""
    part = np.asarray(r, dtype=float) / radius
    outer = np.maximum(part, 1.0)
    beyond = ((2.0 - outer**2) * np.arcsin(1.0 / outer) + np.sqrt(outer**2 - 1.0)) * 2.0 / math.pi
    return np.asarray(3.0 * heat / (16.0 * conductivity * radius) * np.where(part <= 1.0, 2.0 - part**2, beyond))


def uniform_heat_temperature(heat: float, radius: float, conductivity: float, r: ArrayLike) -> Array:
    """Return T [K] at distances r <= a [m] under a uniform flux at rest; heat [W], conductivity [W/(m K)]."""
    from scipy.special import ellipe

    part = np.asarray(r, dtype=float) / radius
    return np.asarray(2.0 * heat / (math.pi**2 * conductivity * radius) * ellipe(part**2))


def uniform_heat_mean(heat: float, radius: float, conductivity: float) -> float:
    """Return the mean of T over the disc [K] under a uniform flux at rest, 8 q a / (3 pi lambda)."""
    return 8.0 * heat / (3.0 * math.pi**2 * conductivity * radius)


def moving_point_temperature(
    heat: float, conductivity: float, diffusivity: float, speed: float, x: ArrayLike, y: ArrayLike
) -> Array:
    """Return T [K] at x, y [m] around a point source on a body whose surface moves along x at a speed [m/s]."""
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    away = np.hypot(x, y)
    return np.asarray(heat / (2.0 * math.pi * conductivity * away) * np.exp(-0.5 * speed / diffusivity * (away - x)))


def fast_uniform_maximum(heat: float, radius: float, conductivity: float, peclet: ArrayLike) -> Array:
    """Return the greatest T [K] under a uniform flux on a body that moves fast: 2 q a / (lambda sqrt(pi Pe))."""
    flux = heat / (math.pi * radius**2)
    return np.asarray(2.0 * flux * radius / (conductivity * np.sqrt(math.pi * np.asarray(peclet, dtype=float))))


def tian_kennedy_uniform(heat: float, radius: float, conductivity: float, peclet: ArrayLike) -> Array:
    """Return the fitted greatest T [K] under a uniform flux, within 2.3 %."""
    flux = heat / (math.pi * radius**2)
    return np.asarray(2.0 * flux * radius / (conductivity * np.sqrt(math.pi * (1.273 + np.asarray(peclet)))))


def tian_kennedy_parabolic(heat: float, radius: float, conductivity: float, peclet: ArrayLike) -> Array:
    """Return the fitted greatest T [K] under the flux of Hertz' pressure, within 1.1 %."""
    flux = heat / (math.pi * radius**2)
    return np.asarray(1.31 * flux * radius / (conductivity * np.sqrt(1.2344 + np.asarray(peclet))))


def disc_centre_rise(fourier: ArrayLike) -> Array:
    """Return T/T_ss at the centre of a uniform flux at rest at the times kappa t / a^2 since it was switched on."""
    from scipy.special import erfc

    tau = np.asarray(fourier, dtype=float)
    part = 0.5 / np.sqrt(tau)
    left = np.exp(-(part**2)) / math.sqrt(math.pi) - part * erfc(part)
    return np.asarray(2.0 * np.sqrt(tau) * (1.0 / math.sqrt(math.pi) - left))
