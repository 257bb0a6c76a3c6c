r"""Persson's theory: how much of a rough surface touches, and how far apart the surfaces are in the mean.

.. math:: \frac{A}{A_0} = \mathrm{erf}\left(\frac{\sqrt2\,p}{E^* h'}\right) , \qquad
          \bar u = \sqrt\pi\int\mathrm dq\,q^2C(q)\,w(q)\int_p^\infty\frac{\mathrm dp'}{p'}
          \left[\gamma+3(1-\gamma)P^2(q,p')\right]e^{-(w(q)p'/E^*)^2} ,

with the root mean square slope h', :math:`w(q)=(\pi\int_{q_0}^q q'^3C\,\mathrm dq')^{-1/2}`,
:math:`P=\mathrm{erf}(w p'/E^*)` and gamma = 0.45.  In terms of t = 1/w, which grows from 0 to :math:`h'/\sqrt2`,

.. math:: \bar u = \frac{2}{\sqrt\pi}\int_0^{h'/\sqrt2} J\!\left(\frac{p}{E^*t}\right)\frac{\mathrm dt}{q(t)} , \qquad
          J(s) = \int_s^\infty\left[\gamma+3(1-\gamma)\,\mathrm{erf}^2s'\right]e^{-s'^2}\frac{\mathrm ds'}{s'} ,

which has no singularity any more.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.profiles.rough.spectrum import Spectrum, wave_numbers_for
from winkler.values.errors import InvalidInput

ENERGY_SHARE = 0.45
"""Share of the elastic energy that is stored in the asperities, after Yang and Persson (2008)."""
WAVE_NUMBERS = 2001
"""Wave numbers, crowded towards the smallest."""
NODES = 24
FARTHEST_S = 6.0
"""Where exp(-s^2) has faded."""


def area_fraction(pressure: Array, modulus: float, rms_slope: float) -> Array:
    """Return the true area of contact over the apparent one [-].

    Parameters
    ----------
    pressure : ndarray
        Force over apparent area [Pa].
    modulus : float
        E* [Pa].
    rms_slope : float
        Root mean square gradient [-].

    Raises
    ------
    InvalidInput
        If a number is out of range.

    References
    ----------
    B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840-3861, doi:10.1063/1.1388626

    Examples
    --------
    >>> round(float(area_fraction(np.array(0.01), 1.0, 1.0)), 6)  # sqrt(8 / pi) p at small pressures
    0.015957
    """
    from scipy.special import erf

    prescribed = _checked(pressure, "area_fraction", modulus=modulus, rms_slope=rms_slope)
    return np.asarray(erf(np.sqrt(2.0) * prescribed / (modulus * rms_slope)))


def mean_separation(pressure: Array, modulus: float, spectrum: Spectrum) -> Array:
    """Return the mean distance of the surfaces [m] under a pressure.

    Parameters
    ----------
    pressure : ndarray
        Force over apparent area [Pa], positive.
    modulus : float
        E* [Pa].
    spectrum : Spectrum
        Combined spectrum of both surfaces.

    Raises
    ------
    InvalidInput
        If a number is out of range.

    References
    ----------
    C. Yang, B. N. J. Persson, J. Phys.: Condens. Matter 20 (2008) 215214, doi:10.1088/0953-8984/20/21/215214
    """
    prescribed = _checked(pressure, "mean_separation", modulus=modulus)
    if np.any(prescribed == 0.0):
        raise InvalidInput(
            "mean_separation: a pressure is zero; without any the surfaces are as far apart as you like."
        )
    return separation_under(prescribed, lambda q: np.full(q.shape, modulus), spectrum)


def separation_under(prescribed: Array, moduli: Callable[[Array], Array], spectrum: Spectrum) -> Array:
    """Return the mean distance [m] under positive pressures where waves meet moduli [Pa] of their own, as on layers.

    Parameters
    ----------
    prescribed : ndarray
        Pressures [Pa].
    moduli : callable
        Takes wave numbers [rad/m].
    spectrum : Spectrum
    """
    q = wave_numbers_for(spectrum, WAVE_NUMBERS, crowded=2.0)
    own = moduli(q)
    power = math.pi * q**4 * spectrum.at(q) * own**2  # t is in Pa here
    t = np.sqrt(np.concatenate(([0.0], np.cumsum(0.5 * (power[1:] + power[:-1]) * np.diff(np.log(q))))))
    separation = np.zeros(prescribed.size)
    risen = t > 0.0  # a measured spectrum may begin with waves of no power
    for i, p in enumerate(prescribed.ravel().tolist()):
        inner = np.zeros(t.size)  # exp(-s^2) at t = 0
        inner[risen] = _work(p / t[risen])
        separation[i] = 2.0 / math.sqrt(math.pi) * np.trapezoid(inner / (q * own), t)
    return separation.reshape(prescribed.shape)


def _checked(pressure: Array, owner: str, **numbers: float) -> Array:
    """Return the pressures, none of which may pull."""
    prescribed = np.asarray(pressure, dtype=float)
    if not np.all(np.isfinite(prescribed) & (prescribed >= 0.0)):
        raise InvalidInput(f"{owner}: pressure must not be negative, and finite; surfaces are pressed together.")
    for word, number in numbers.items():
        if not 0.0 < number < math.inf:
            raise InvalidInput(f"{owner}: {word} is {number!r}; it must be positive and finite.")
    return prescribed


def _work(start: Array) -> Array:
    """Return J(s)."""
    from scipy.special import erf, exp1

    nodes, weights = gauss_legendre(NODES)
    rest = np.maximum(FARTHEST_S - start, 0.0)[:, None]
    s = start[:, None] + rest * nodes
    with_touching = np.sum(rest * weights * erf(s) ** 2 * np.exp(-(s**2)) / s, axis=1)
    return np.asarray(
        0.5 * ENERGY_SHARE * exp1(np.minimum(start**2, 700.0)) + 3.0 * (1.0 - ENERGY_SHARE) * with_touching
    )
