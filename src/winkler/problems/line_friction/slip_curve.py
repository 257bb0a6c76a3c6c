r"""What the springs of a sheared line contact add up to: the loss, and the shift that slip allows.

A line contact is numbered by the load per length :math:`\gamma = w(a)` at which it touches up to a half-width a.  What
lies within a bears :math:`Q - t(\gamma)`; it is as if springs of the stiffness :math:`\mathrm dK` were displaced by t
while the bodies shift by Q, with

.. math:: K = \frac{2E^*}\pi\ln a , \qquad D = \int t\,\mathrm ds\,\mathrm dK , \qquad s = Q - t ,

the forces counted over E*; on bodies graded by a power K is -E*^2 over the stiffness of a flat punch.  K has no bound
at a sharp middle, where nothing slips: its reference does not matter.  The moments of dK follow from

.. math:: G_1 = \int\gamma\,\mathrm dK , \quad G_2 = \int\gamma^2\,\mathrm dK , \quad
          F = \gamma K - G_1 , \quad W = \tfrac12\gamma^2K - \gamma G_1 + \tfrac12G_2 ,

which are laid on panels over :math:`\ln\gamma`.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels, fit_nodes, panels_from
from winkler.numerics.types import Array, Curve
from winkler.problems.line.half_width import under_force
from winkler.values.errors import NotConverged

FOLDS = 24
"""Loads are resolved down to exp(-FOLDS) of the greatest; below that the half-width follows a power."""
TOLERANCES = (1e-14, 1e-12, 1e-10)
"""Errors of d ln(a)/d ln(gamma) that are tried at the greatest load; at smaller ones more is allowed in proportion."""
MOST_PANELS = 512
NARROWEST = 1e-9
NODES = 10


class SlipCurve(NamedTuple):
    """K [Pa] and its integrals F, W over the load per length over E* [m].

    Parameters
    ----------
    edges : list of float
        Ends of the panels, in ln(gamma).
    rows : list of ndarray, (degree + 2, 3)
        Chebyshev coefficients of K, G1 and G2 on every panel.
    orders : ndarray
        0, 1, 2 ...
    power : float
        dK / d ln(gamma) below the first panel [Pa].
    """

    edges: list[float]
    rows: list[Array]
    orders: Array
    power: float

    def at(self, load: float) -> tuple[float, float, float]:
        """Return K [Pa], F [N/m] and W [N] at a load [m]."""
        place = math.log(load)
        edges = self.edges
        if place < edges[0]:
            stiffness, first, second = self._at(edges[0])
            stiffness += self.power * (place - edges[0])
            first, second = self.power * load, 0.5 * self.power * load**2
        else:
            stiffness, first, second = self._at(place)
        return stiffness, load * stiffness - first, 0.5 * load**2 * stiffness - load * first + 0.5 * second

    def _at(self, place: float) -> tuple[float, float, float]:
        edges = self.edges
        panel = min(max(bisect_right(edges, place), 1), len(edges) - 1) - 1
        low, high = edges[panel], edges[panel + 1]
        t = (2.0 * place - low - high) / (high - low)
        angle = math.acos(min(max(t, -1.0), 1.0))
        stiffness, first, second = (np.cos(angle * self.orders) @ self.rows[panel]).tolist()
        return stiffness, first, second

    def between(self, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        """Return the integrals over a narrow ring of loads of depth - gamma [N/m] and of its square [N] by dK."""
        if depth <= gap:
            return 0.0, 0.0
        nodes, weights = gauss_legendre(NODES)
        places = gap + (depth - gap) * nodes
        excess = np.array([self.at(place)[0] for place in places.tolist()]) - stiffness
        share = (depth - gap) * weights * excess
        return float(np.sum(share)), float(2.0 * share @ (depth - places))


def slip_curve(bed: LineBed, load: float) -> SlipCurve:
    """Return the curve up to a load per length over E* [m].

    Raises
    ------
    NotConverged
        If the profile is too rough.
    """
    top, widest = math.log(load), float(under_force(bed, np.array([load]))[0])
    kinks = np.array([b for b in (*(b for b, _ in bed.kinks), bed.rim) if b <= widest])
    breaks = bed.load_profile(kinks) if kinks.size else kinks
    breaks = np.log(breaks[(breaks > math.exp(-FOLDS) * load) & (breaks < load)])
    edges = np.union1d(np.linspace(top - FOLDS, top, FOLDS + 1), breaks)

    def lengthening(place: Array) -> Array:
        """d ln(a) / d ln(gamma), times by how much a wider punch is stiffer."""
        load = np.exp(place)
        a = under_force(bed, load.ravel()).reshape(place.shape)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = bed.punch_softening(a) * load / (a * bed.load_profile_slope(a))
        return np.where(np.isfinite(share) & (a < bed.rim), share, 0.0)

    scale = bed.medium.modulus
    share = _resolved(lengthening, edges)
    nodes = fit_nodes(share.edges)
    values = scale * share(nodes)
    power, low = float(scale * share(share.edges[:1])[0]), math.exp(share.edges[0])
    parts = []
    for number, start in ((0, 0.0), (1, power * low), (2, 0.5 * power * low**2)):
        part = panels_from(share.edges, values * np.exp(number * nodes)).integral
        parts.append(part.coefficients + np.eye(1, part.coefficients.shape[1]) * start)
    parts[0][:, 0] -= parts[0][-1].sum()
    rows = [np.stack(list(row), axis=1) for row in zip(*parts, strict=True)]
    return SlipCurve(share.edges.tolist(), rows, np.arange(rows[0].shape[0], dtype=float), power)


def _resolved(curve: Curve, edges: Array) -> Panels:
    """Return a curve over the logarithm of the load on panels, the finer the greater the load."""
    for tolerance in TOLERANCES:
        cuts = edges
        while cuts.size <= MOST_PANELS:
            panels = panels_from(cuts, curve(fit_nodes(cuts)))
            tail = np.abs(panels.coefficients[:, -3:]).sum(axis=1)
            rough = (tail > tolerance * np.exp(cuts[-1] - cuts[1:])) & (np.diff(cuts) > NARROWEST)
            if not rough.any():
                return panels
            cuts = np.union1d(cuts, 0.5 * (cuts[1:] + cuts[:-1])[rough])
    raise NotConverged(
        f"LineTangential: the half-width over the load needs more than {MOST_PANELS} panels to be resolved to "
        f"{TOLERANCES[-1]:.0e}; the profile is too rough: smooth it, or give fewer points."
    )
