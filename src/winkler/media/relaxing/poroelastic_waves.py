r"""Surface compliance and creep of a poroelastic film that drains through its surface.

Biot's equations with incompressible constituents: shear modulus G, uniaxial modulus of the drained network
:math:`M=2G\frac{1-\nu}{1-2\nu}`, diffusivity D, on a rigid and impermeable base, without pore pressure p at the
surface.  With the dilatation :math:`\varepsilon` of one wave, and :math:`m^2=\xi^2+s/D`,

.. math:: \varepsilon''=m^2\varepsilon ,\qquad \varphi=M\varepsilon-p ,\quad \varphi''=\xi^2\varphi ,\qquad
          W''-\xi^2W=\varepsilon'-\varphi'/G .

Solutions that meet the conditions at the base are built from entire functions of :math:`\xi^2` and :math:`m^2` and from
their differences over :math:`s/D`, so that neither slow nor fast waves, nor thin films, cancel.  Lengths are over the
thickness h, moduli over G, times over :math:`h^2/D`.

Retardation times reach down to zero: a wave that is long against the film sinks like :math:`\sqrt t` at first.  Rates
:math:`s/(1+s\tau)` in place of s lengthen each of them by :math:`\tau` and leave their first moment as it is, which
changes what has crept after a time t by about :math:`\tau/(4t)` of it; what then comes at once beyond the undrained
compliance is given the shortest time.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.media.layered.across import less_than_one
from winkler.numerics.caching import cached_by_value
from winkler.numerics.panels.chebyshev import fit_nodes, panels_from
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER
from winkler.numerics.transforms.wave_creep import WaveCreep, fit_wave_creep
from winkler.numerics.types import Array, ComplexArray

LONGEST_TIME = 0.5
"""Above the longest retardation time, 4 / pi^2 of a wave without end."""
SHORTEST_DEPTH = 0.01
"""Of a width of cells, in which liquid diffuses within the shortest time."""
SHORTEST_TIME = 1e-5
"""The shortest time is not longer."""
SHORTEST_WAVE = 64.0
"""Over the width of cells: shorter waves move cells by less than 1e-5 of their own displacement."""
DEEP = 20.0
"""From this xi h on the base is not felt."""
SLOW = 0.3
"""Below it, rates over the larger of one and xi h are too slow for differences of functions."""
FIRST_SHALLOW, SHALLOW = 1.0, 2.0
"""Up to these xi h two forms of the displacement, and of a series, are used."""
SERIES_TERMS = 15


def drained_waves(rate: ComplexArray, x: Array, poisson: float) -> ComplexArray:
    """Return c = xi C / 2 of a film with a drained surface.

    Parameters
    ----------
    rate : ndarray
        s h^2 / D, with a real part that is not negative; zero for the drained network.
    x : ndarray
        xi h, positive, broadcast with the rates; infinite for a half-space.
    poisson : float
        Of the drained network, below 0.5.

    Returns
    -------
    ndarray
        Times G.
    """
    uniaxial = 2.0 * (1.0 - poisson) / (1.0 - 2.0 * poisson)
    rate, x = np.broadcast_arrays(rate, x)
    near = x < DEEP
    found = np.empty(x.shape, dtype=complex)
    found[near] = _shallow(rate[near], x[near], uniaxial)
    with np.errstate(invalid="ignore"):
        # over x: sqrt(1 + s / (D xi^2)) tends to one for the shortest waves
        both = 0.5 * uniaxial * (np.sqrt(1.0 + rate[~near] / x[~near] ** 2) + 1.0)
    found[~near] = 0.25 * both / (both - 1.0)
    return found


def undrained_waves(x: Array) -> Array:
    """Return c G of the film before any liquid has moved, ``(m,)``: incompressible, whatever its drained network."""
    found, near = np.full(x.shape, 0.25), x < DEEP
    square, missing = x[near] ** 2, less_than_one(x[near])
    part = 1.0 - missing  # tanh(x) / x
    found[near] = 0.25 * x[near] * (square * part**2 - missing) / (1.0 + square * (1.0 - square * part**2))
    return found


def _shallow(rate: ComplexArray, x: Array, uniaxial: float) -> ComplexArray:
    """Return c G at rates and wave numbers that reach the base, both ``(m,)``.

    With the dilatation and phi cosh(x) of the surface, and phi' at the base, as unknowns: phi vanishes with the pore
    pressure, the shear stress gives the last one over the first, and the pressure the first one.
    """
    root = np.sqrt(x**2 + rate)
    missing, square = less_than_one(x), x**2
    part, own = 1.0 - missing, _over(root)
    sech_x, sech_m = (2.0 * np.exp(-k) / (1.0 + np.exp(-2.0 * k)) for k in (x, root))
    ratio = np.exp(x - root) * (1.0 + np.exp(-2.0 * x)) / (1.0 + np.exp(-2.0 * root))  # cosh x / cosh m
    with np.errstate(divide="ignore", invalid="ignore"):
        parts = np.array(
            [
                (1.0 - ratio) / rate,
                (root**2 * own - square * part * ratio) / rate,
                (sech_m * sech_x - 1.0 + square * own * part) / rate,
                (own - part) / rate,
            ]
        )
    slow = np.abs(rate) <= SLOW * np.maximum(1.0, x)
    some = (each[slow] for each in (rate, x, root, own, sech_m, ratio))
    parts[:, slow] = _slow(*some)
    slope, risen, base, turned = parts
    # phi' of the base, times cosh x and over x^2, per dilatation of the surface
    last = -(uniaxial - 2.0 * risen) / (1.0 - 2.0 * square * base / uniaxial)
    inner = 2.0 * square * turned / uniaxial + square * part**2 - 1.0 - part
    dilated = -1.0 / (uniaxial * (1.0 - square * part) + 2.0 * square * slope + square * last * inner)
    shallow = risen - 0.5 * uniaxial * missing + square * last * (base / uniaxial - 0.5 * part**2)
    deep = 0.5 * (uniaxial * part + last * sech_x**2)
    return np.asarray(-0.5 * x * dilated * np.where(x < FIRST_SHALLOW, shallow, deep))


def _slow(
    rate: ComplexArray, x: Array, root: ComplexArray, own: ComplexArray, sech_m: ComplexArray, ratio: ComplexArray
) -> ComplexArray:
    """Return the four differences over the rate where m is near x, ``(4, n)``."""
    mean, half = 0.5 * (root + x), 0.25 * rate / (0.5 * (root + x))
    slope = 0.5 * sech_m * _sinhc(mean) * _sinhc(half)
    # (sinh m / m - sinh x / x) over the rate
    rise = (x * np.cosh(mean) * _sinhc(half) - np.sinh(x)) / (2.0 * mean * root * x)
    low = x < SHALLOW
    m2, x2 = root[low] ** 2, x[low] ** 2
    total, sums, power, factorial = np.zeros_like(m2), np.ones_like(m2), np.ones_like(x2), 1.0
    for n in range(1, SERIES_TERMS + 1):
        factorial *= 2 * n * (2 * n + 1)
        total += sums / factorial
        power = power * x2
        sums = sums * m2 + power
    rise[low] = total
    rise = rise * sech_m
    risen = own + x**2 * rise
    return np.stack([slope, risen, (slope - own * risen) / ratio, (rise - own * slope) / ratio])


def _sinhc(z: ComplexArray) -> ComplexArray:
    small = np.abs(z) < 1e-3
    return np.asarray(np.where(small, 1.0 + z**2 / 6.0 * (1.0 + z**2 / 20.0), np.sinh(z) / np.where(small, 1.0, z)))


def _over(z: ComplexArray) -> ComplexArray:
    """Return tanh(z) / z."""
    small = np.abs(z) < 1e-2
    fade, square = np.exp(-2.0 * z), z**2
    series = 1.0 - square / 3.0 * (1.0 - 0.4 * square * (1.0 - 17.0 / 42.0 * square))
    return np.asarray(np.where(small, series, (1.0 - fade) / (1.0 + fade) / np.where(small, 1.0, z)))


@cached_by_value(32)
def film_creep(poisson: float, octave: int, wide: bool) -> WaveCreep:
    """Return the creep of all waves that cells of a width of 2^octave thicknesses, or wider ones, tell apart.

    Lengths, moduli and times are those of `drained_waves`.  Under a wide contact what creeps within the shortest time
    comes at once, and the undrained compliance does not appear.

    Raises
    ------
    NotConverged
        If the sum of exponentials is wrong by more than 1e-5.
    """
    width = 2.0**octave
    shortest = min((SHORTEST_DEPTH * width) ** 2, SHORTEST_TIME)

    def slowed(s: ComplexArray) -> ComplexArray:
        infinite = np.isinf(np.abs(s))
        plain = np.where(infinite, 0.0, s)
        return np.where(infinite, 1.0 / shortest, plain / (1.0 + plain * shortest))

    def compliance(s: ComplexArray, x: Array) -> ComplexArray:
        return drained_waves(slowed(s)[:, None], x, poisson)

    def share(s: ComplexArray) -> Array:
        return np.asarray(np.abs(_over(np.sqrt(slowed(s)))))  # of waves without end

    ends = FIRST_WAVE_NUMBER, max(SHORTEST_WAVE / width, DECAY_SPAN)
    found = fit_wave_creep(compliance, share, (shortest, LONGEST_TIME + shortest), ends)
    if wide:
        return found
    nodes = fit_nodes(found.edges)
    x = np.append(nodes.ravel(), np.inf)
    undrained = undrained_waves(x)
    sudden = np.real(compliance(np.array([1j * math.inf]), x)[0]) - undrained
    local, series = found.local.copy(), found.series.copy()
    local[0] = undrained[-1]
    series[:, :, 0] = _panels(found.edges, undrained)
    local[1] += sudden[-1]
    series[:, :, 1] += _panels(found.edges, sudden)
    return found._replace(local=local, series=series)


def _panels(edges: Array, values: Array) -> Array:
    """Return the coefficients of what is added to the last one of values at the nodes, ``(degree + 1, panels)``."""
    varying = (values[:-1] - values[-1]).reshape(edges.size - 1, -1)
    return panels_from(edges, varying).coefficients.T
