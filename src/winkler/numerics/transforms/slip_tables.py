r"""What rings that slide bear, seen by the springs of a medium whose normal and shear kernels differ.

A traction on a disc is a sum of those of rigid discs of all radii x, which are twisted, or pushed, by the local angle
or shift :math:`h(x)` (times a modulus): where nothing slides h is the rigid motion itself.  So springs with the
displacement h and the weight :math:`e(x)^2`, e the edge value of the rigid motion, are exact.  Rings outside of c that
slide bear :math:`\mu p`; the line load q of these, T4 backwards, fixes h outside of c alone, since the operators are
triangular,

.. math:: h(x)\,e(x) = q(x) + \int_x^a \Gamma(x,s)\,q(s)\,\mathrm ds , \qquad
          \Gamma(x,s) = K(x,s) - \int_0^x \rho(y;x)\,K(y,s)\,\mathrm dy .

The pressure is a sum of flat punches with the line load :math:`E^*\varphi(x;t)`.  `slip_table` holds h under each of
these: with :math:`q = E^*\varphi` for a push, and for a twist, where :math:`q(x) = 4x\int_x^t p\,(r^2-x^2)^{-1/2}
\mathrm dr` and K is the complete elliptic integral,

.. math:: q(x) = \frac{4xE^*}\pi\Big[\varphi(t;t)\,\frac{K(1-x^2/t^2)}t
          - \int_x^t \varphi'(u;t)\,\frac{K(1-x^2/u^2)}u\,\mathrm du\Big] .

All equations are solved on the nodes of given panels, of which the last one is cut at t: functions are the polynomials
through their values at the nodes, also beyond t.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.panels.kink_panels import (
    DERIVATIVE,
    LOCAL_NODES,
    NODES_PER_PANEL,
    TO_COEFFICIENTS,
    WEIGHTS,
    Stretches,
)
from winkler.numerics.transforms.cosine_transform import WaveResponse, transform
from winkler.numerics.transforms.odd_response import parity
from winkler.numerics.transforms.rounded_slip_tables import rounded_loads, rounded_slips
from winkler.numerics.types import Array


class SlipTable(NamedTuple):
    """What springs bear, at the nodes of panels.

    `bound` is h at node i if the rings slide under a flat punch whose radius is node j, over mu E*, ``(n, n)``; it is
    zero in panels beyond that of j.  `lever` is e, ``(n,)``: theta(x; x) of a twist, phi(x; x) of a push.
    """

    bound: Array
    lever: Array


class _Cut(NamedTuple):
    """The equations on the panels below one panel and on this, cut at any place: own nodes after the lower ones."""

    lower: int
    inverse: Array
    reflected: Array
    """K_OL w Y of the lower panels, ``(own, lower)``."""
    carried: Array
    """Y K_LO."""
    schur: Array
    """K_OO less what the lower panels reflect: times the weights of the cut it is added to the unit matrix."""


def slip_table(panels: Stretches, normal: WaveResponse, shear: WaveResponse) -> SlipTable:
    """Return what springs bear under sliding rings.

    Parameters
    ----------
    panels : Stretches
        Narrow against the lengths over which both kernels change.
    normal : WaveResponse
        To a pressure.
    shear : WaveResponse
        To a shear traction, or an `OddResponse` for a twist.
    """
    x = panels.nodes.ravel()
    twist = parity(shear)[1] < 0.0
    shape = x if twist else np.ones(x.size)
    elliptic = _elliptic(x) if twist else np.zeros((0, 0))
    if any(each.smooth > each.length for each in (normal, shear)):  # a logarithm that is rounded off
        pressed = rounded_loads(panels, normal)
        loads = ((own, _ringed(panels, elliptic, phi, own) if twist else phi) for own, phi in pressed)
        found, lever = rounded_slips(panels, shear, shape, loads)
        return SlipTable(found / lever[:, None], lever)
    gamma, lever = _triangle(panels, shear, shape)
    bound = np.zeros((x.size, x.size))
    for columns, load in _loads(panels, normal, twist, elliptic):
        rows = columns.stop
        total = load + _above(panels, gamma, load, columns)
        bound[:rows, columns] = total / lever[:rows, None]
    return SlipTable(bound, lever)


def _kernel(response: WaveResponse, x: Array) -> Array:
    response, sign = parity(response)
    values = transform(response, 2.0 * float(x[-1]))
    return 0.5 * (values(np.abs(x[:, None] - x)) + sign * values(x[:, None] + x))


def _cuts(panels: Stretches, kernel: Array) -> Iterator[_Cut]:
    """Yield the equations of all panels from the axis on; the inverse of the lower ones grows by one panel each."""
    weights, n = panels.weights.ravel(), NODES_PER_PANEL
    inverse = np.zeros((0, 0))
    for low in range(0, weights.size, n):
        own = slice(low, low + n)
        reflected = (kernel[own, :low] * weights[:low]) @ inverse
        carried = inverse @ kernel[:low, own]
        schur = kernel[own, own] - reflected @ kernel[:low, own]
        yield _Cut(low, inverse, reflected, carried, schur)
        corner = np.linalg.inv(np.eye(n) + schur * weights[own])
        right = -(carried * weights[own]) @ corner
        inverse = np.block([[inverse - right @ reflected, right], [-corner @ reflected, corner]])


def _partial(panels: Stretches, panel: int) -> tuple[Array, Array]:
    """Return the weights of integrals over y and over x from the lower end of a panel up to each of its nodes."""
    parts = panels.part(panels.nodes[panel], np.full(NODES_PER_PANEL, panel))
    return parts, parts * panels.stretch[panel]


def _triangle(panels: Stretches, response: WaveResponse, shape: Array) -> tuple[Array, Array]:
    """Return Gamma at all pairs of nodes, and the edge value of the solution with this right-hand side."""
    kernel = _kernel(response, panels.nodes.ravel())
    gamma, lever = np.empty_like(kernel), np.empty(len(kernel))
    for panel, cut in enumerate(_cuts(panels, kernel)):
        low, own = cut.lower, slice(cut.lower, cut.lower + NODES_PER_PANEL)
        weights = _partial(panels, panel)[1]
        right = np.column_stack([kernel[own] - cut.reflected @ kernel[:low], shape[own] - cut.reflected @ shape[:low]])
        cut_at = np.linalg.inv(np.eye(NODES_PER_PANEL) + cut.schur * weights[:, None, :])
        rows = np.einsum("iik->ik", cut_at) @ right
        gamma[own], lever[own] = rows[:, :-1], rows[:, -1]
    return gamma, lever


def _loads(panels: Stretches, response: WaveResponse, twist: bool, elliptic: Array) -> Iterator[tuple[slice, Array]]:
    """Yield, panel by panel of the radii of flat punches, the line loads q over E* of the rings that slide."""
    x = panels.nodes.ravel()
    kernel, n = _kernel(response, x), NODES_PER_PANEL
    for panel, cut in enumerate(_cuts(panels, kernel)):
        low, own = cut.lower, slice(cut.lower, cut.lower + n)
        weights = _partial(panels, panel)[1]
        ones = np.ones(low)
        cut_at = np.linalg.inv(np.eye(n) + cut.schur * weights[:, None, :])
        inside = (cut_at @ (1.0 - cut.reflected @ ones)).T  # own nodes, radii
        phi = np.vstack([(cut.inverse @ ones)[:, None] - cut.carried @ (weights.T * inside), inside])
        yield own, _ringed(panels, elliptic, phi, own) if twist else phi


def _ringed(panels: Stretches, elliptic: Array, phi: Array, own: slice) -> Array:
    """Return the line loads q over E* of rings that slide under flat punches, for the radii in one panel."""
    x, rows = panels.nodes.ravel(), slice(0, own.stop)
    edge = np.diagonal(phi[own])
    steep = np.einsum("ij,pjt->pit", _SLOPE, phi.reshape(-1, NODES_PER_PANEL, phi.shape[1]))
    steep = (steep / panels.half[: own.stop // NODES_PER_PANEL, None, None]).reshape(phi.shape)
    beyond = _above(panels, elliptic, steep, own, over_y=True)
    return np.asarray(4.0 / np.pi * x[rows, None] * (elliptic[rows, own] * edge - beyond))


def _elliptic(x: Array) -> Array:
    from scipy.special import ellipkm1

    return np.asarray(ellipkm1((x[:, None] / x) ** 2) / x)


def _above(panels: Stretches, kernel: Array, values: Array, columns: slice, over_y: bool = False) -> Array:
    """Return the integrals of kernel(x, s) values(s; t) over s from x to t, at nodes x, for the radii t of a panel."""
    n, low, rows = NODES_PER_PANEL, columns.start, columns.stop
    whole = (2.0 * panels.half[:, None] * WEIGHTS if over_y else panels.weights).ravel()[:rows]
    last = _partial(panels, low // n)[0 if over_y else 1]
    result = np.empty((rows, n))
    for panel in range(low // n):
        own = slice(panel * n, (panel + 1) * n)
        before = _partial(panels, panel)[0 if over_y else 1]
        weighed = kernel[own, own] * (whole[own] - before)
        beyond = slice(own.stop, low)
        result[own] = weighed @ values[own] + (kernel[own, beyond] * whole[beyond]) @ values[beyond]
    result[:low] += kernel[:low, columns] @ (last.T * values[columns])
    cut = last[None] - last[:, None]  # from each node to each radius
    result[low:] = np.einsum("is,its,st->it", kernel[columns, columns], cut, values[columns])
    return result


_SLOPE = np.polynomial.legendre.legvander(LOCAL_NODES, NODES_PER_PANEL - 1) @ DERIVATIVE.T @ TO_COEFFICIENTS
"""From values at the nodes to derivatives, in units of half a panel."""
