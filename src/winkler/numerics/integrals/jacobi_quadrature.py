r"""Integrals of a smooth function times a power, :math:`\int_0^1 t^\alpha h(t)\,\mathrm dt` with :math:`\alpha>-1`.

Gauss-Jacobi rules, which hold the power in their weights, come first: they converge geometrically where h is analytic.
What has not settled is integrated over :math:`s = t^{1+\alpha}` by the rules of `numerics.settling`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np

from winkler.numerics.integrals.adaptive_quadrature import TOLERANCE, settled
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

RULE_NODES = (10, 20, 40, 80)
LARGEST_INVERSE_POWER = 40.0
"""The largest 1 / (1 + power) with which s still resolves where the integrand changes."""


@functools.lru_cache(maxsize=256)
def gauss_jacobi(count: int, power: float) -> tuple[Array, Array]:
    """Return nodes and weights on [0, 1] for the weight t^power, read-only and cached.

    Examples
    --------
    >>> nodes, weights = gauss_jacobi(4, -0.5)
    >>> round(float(weights @ nodes**3), 14)  # 1 / 3.5
    0.28571428571429
    """
    from scipy.special import roots_jacobi

    nodes, weights = roots_jacobi(count, 0.0, power)
    nodes, weights = 0.5 * (1.0 + nodes), weights * 0.5 ** (1.0 + power)
    if power < 0.0:
        # scipy's weights all share one error near power = -1, but for the first, which carries nearly all: what is
        # right are their ratios, and two moments are known
        rest = weights[1:]
        first = (1.0 / (2.0 + power) - nodes[0] / (1.0 + power)) / (rest @ (nodes[1:] - nodes[0]))
        weights[1:] = first * rest
        weights[0] = 1.0 / (1.0 + power) - np.sum(weights[1:])
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


def settled_power(
    integrand: Callable[[Array, Array], Array], count: int, power: float, what: str, noise: Array | None = None
) -> Array:
    """Integrate t^power integrand(t) over the unit interval until the result settles.

    Parameters
    ----------
    integrand
        Called with nodes ``(n,)`` in (0, 1) and an index ``(m,)``; returns the function without the power, ``(m, n)``.
    count
        How many integrals there are.
    power
        Above -1.
    what, noise
        As in `winkler.numerics.integrals.adaptive_quadrature.settled`.

    Returns
    -------
    ndarray, (count,)

    Raises
    ------
    NotConverged
        If a result does not settle.
    """
    if power == 0.0:
        return settled(integrand, count, what, noise)
    result = np.zeros(count)
    last = np.full(count, np.nan)
    waiting = np.arange(count)
    for points in RULE_NODES:
        if not waiting.size:
            return result
        nodes, weights = gauss_jacobi(points, power)
        values = integrand(nodes, waiting)
        current, size = values @ weights, np.abs(values) @ weights
        floor = TOLERANCE if noise is None else np.maximum(TOLERANCE, 4.0 * noise[waiting])
        good = np.abs(current - last[waiting]) <= floor * size
        result[waiting], last[waiting] = current, current
        waiting = waiting[~good]
    if waiting.size:
        left = waiting
        share = 1.0 / (1.0 + power)
        if share > LARGEST_INVERSE_POWER:
            raise NotConverged(
                f"The integral for the {what} does not settle with a power of {power:.6g}; give an exponent of the "
                "grading that is not so near to 1 or -1."
            )
        result[left] = settled(
            lambda node, index: integrand(node**share, left[index]) * share,
            left.size,
            what,
            None if noise is None else noise[left],
        )
    return result
