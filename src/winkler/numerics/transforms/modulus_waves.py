r"""The compliance of a wave as a function of one modulus: poles that do not depend on the wave.

The compliance of a body of which one part has the shear modulus G is a Stieltjes function of G: all its poles lie on
the negative axis.  Poles spaced evenly in the logarithm stand for all of them,

.. math:: c(\xi,G) = A(\xi) + \frac{B_0(\xi)}{G} + \sum_m \frac{B_m(\xi)}{G+\gamma_m} ,

so that the waves are computed once for all moduli of the part.  By the elastic-viscoelastic correspondence each pole is
a solid :math:`G(t)+\gamma_m` of its own, whose creep is known in closed form.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.integrals.quadrature import growing
from winkler.numerics.panels.chebyshev import fit_nodes, panels_from
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, FIRST_WAVE_NUMBER
from winkler.numerics.transforms.wave_creep import CHECKED_WAVES, CUTOFF, WaveCreep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import NotConverged

SPACING = 0.3
"""Of the logarithms of the poles."""
MARGIN = 12.0
"""Poles lie between the least modulus over this and the greatest times this."""
SAMPLED_BEYOND = 2.0
SAMPLES_PER_POLE = 4
LARGEST_ERROR = 1e-4
"""A fit that is wrong by more than this part is refused."""


class ModulusWaves(NamedTuple):
    """The coefficients of all waves.

    Parameters
    ----------
    poles : ndarray, (M,)
        Zero, and gamma_m [Pa].
    waves : WaveCreep
        A and B [1/Pa, -], as its coefficients; its times are not used.
    error : float
        Greatest error of c, relative to it.
    """

    poles: Array
    waves: WaveCreep
    error: float


def fit_modulus_waves(
    compliance: Callable[[ComplexArray, Array], ComplexArray],
    moduli: tuple[float, float],
    span: float,
    length: float,
    *,
    alone: bool,
) -> ModulusWaves:
    """Fit the compliance of all waves.

    Parameters
    ----------
    compliance : callable
        c [1/Pa], ``(S, m)``, of complex moduli [Pa] ``(S,)`` and wave numbers [1/m] ``(m,)``.
    moduli : (float, float)
        Between which the modulus lies at all times [Pa].
    span, length : float
        c is a power series in xi below 1 / span, and its limit is approached like exp(-2 xi length) [m].
    alone : bool
        Whether nothing else deforms: then only the pole at zero exists.

    Raises
    ------
    NotConverged
        If the error is larger than 1e-4.
    """
    low, high = (math.log(one) / SPACING for one in (moduli[0] / MARGIN, moduli[1] * MARGIN))
    finite = np.exp(SPACING * np.arange(math.floor(low), math.ceil(high) + 1))
    poles = np.zeros(1) if alone else np.append(0.0, finite)
    unit = math.sqrt(moduli[0] * moduli[1])
    scale = np.append(unit, poles[1:])
    samples = SAMPLES_PER_POLE * (finite.size if not alone else 2)
    grid = np.geomspace(moduli[0] / SAMPLED_BEYOND, SAMPLED_BEYOND * moduli[1], 2 * samples + 1)
    edges = np.array([0.0, *growing(FIRST_WAVE_NUMBER / span, 2.0 * DECAY_SPAN / length, 2.0)])
    nodes = fit_nodes(edges)
    xi = np.append(nodes.ravel(), np.inf)

    def terms(modulus: ComplexArray) -> ComplexArray:
        return np.concatenate([np.ones((modulus.size, 1)), scale / (modulus[:, None] + poles)], axis=1)

    fitted = 1j * grid[::2]
    rows, wanted, weights = terms(fitted), compliance(fitted, xi), np.tile(grid[::2] / unit, 2)[:, None]
    inverse = np.linalg.pinv(weights * np.concatenate([rows.real, rows.imag]), rcond=CUTOFF)
    found = inverse @ (weights * np.concatenate([wanted.real, wanted.imag]))

    part = slice(None, None, CHECKED_WAVES)
    checked = np.concatenate([1j * grid[1::2], grid[1::2]]).astype(complex)
    true = compliance(checked, xi[part])
    error = float(np.max(np.abs((terms(checked) @ found)[:, part] - true) / np.abs(true)))
    if not error <= LARGEST_ERROR:
        raise NotConverged(
            f"The compliance of the layers is no sum of poles of the modulus to better than {error:.1e}, "
            f"{LARGEST_ERROR:.0e} are needed; give bounds or starts of the moduli nearer to each other."
        )
    found[1:] *= scale[:, None]
    varying = (found[:, :-1] - found[:, -1:]).reshape(-1, *nodes.shape)
    series = np.stack([panels_from(edges, each).coefficients for each in varying])
    coefficients = np.ascontiguousarray(series.transpose(2, 1, 0))
    return ModulusWaves(poles, WaveCreep(poles, found[:, -1], edges, coefficients, error), error)


def creep_of_poles(series: RelaxationSeries, poles: Array) -> tuple[Array, Array, Array]:
    r"""Return the creep of the solids G(t) + gamma_m: compliances at once, compliances, and retardation times.

    With :math:`G(s)+\gamma = G_g\,(1 - b^T(s+P)^{-1}b)`, :math:`b_i^2 = G_i/(G_g\tau_i)` and :math:`P` the rates
    :math:`1/\tau_i`, the retardation rates are the eigenvalues of :math:`P - bb^T`.

    Parameters
    ----------
    series : RelaxationSeries
        G(t), with a positive relaxed modulus and no viscosity.
    poles : ndarray, (M,)
        gamma_m [Pa].

    Returns
    -------
    glassy : ndarray, (M,)
        [1/Pa].
    compliances, times : ndarray, (M, n)
        [1/Pa], [s].
    """
    rates, first = 1.0 / series.times, series.glassy + poles
    b = np.sqrt(series.moduli * rates / first[:, None])
    values, vectors = np.linalg.eigh(np.diag(rates) - b[:, :, None] * b[:, None, :])
    residues = np.einsum("mij,mi->mj", vectors, b) ** 2 / first[:, None]
    return 1.0 / first, residues / values, 1.0 / values
