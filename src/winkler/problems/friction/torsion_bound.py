r"""How much the springs of a twisted contact bear before they slide.

A ring that slides carries :math:`\mu p(r)`, so the springs of a sliding outer part of the contact carry
:math:`q(x) = 4\mu x\int_x^a p(r)\,(r^2-x^2)^{-1/2}\,\mathrm dr`: each depends on the pressure of all
rings farther out.  With :math:`q = x\,h(x)` and the pressure as a sum of flat punches' pressures

.. math:: b(x) = \frac{4\mu E^*}\pi\Big[\int_x^a K\big(1-\tfrac{x^2}{t^2}\big)\frac{g'(t)}t\,\mathrm dt
          + (d-g(a))\,\frac{K(1-x^2/a^2)}{a}\Big], \qquad |h|\le b ,

K the complete elliptic integral of the first kind (of the parameter m).  b falls with x where g rises, grows without
limit towards the axis, and is a concave function of the depth, and of the force.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.panels.kink_panels import Stretches, stretches
from winkler.numerics.types import Array

__all__ = ["PressedState", "TwistBound", "twist_bound"]


class PressedState(NamedTuple):
    """How a contact is pressed: what is prescribed (depth [m] or force [N]), its radius [m], and d - g(a) [m]."""

    level: float
    radius: float
    excess: float


class TwistBound:
    """The bound b of springs at fixed places, for every contact up to a widest one.

    Parameters
    ----------
    bed : Bed
        On a homogeneous half-space.
    coefficient : float
        mu [-].
    widest : float
        [m].
    forced : bool
        Whether the level of a contact is its force, not its depth.
    """

    def __init__(self, bed: Bed, coefficient: float, widest: float, forced: bool) -> None:
        self.bed, self.coefficient, self.forced = bed, coefficient, forced
        self.widest = widest
        self.endless = math.isinf(coefficient)
        """Whether nothing ever slides."""
        self.panels: Stretches = stretches(bed.gap_slope, [b for b, _ in bed.kinks], widest)
        self.x: Array = self.panels.nodes
        modulus = float(bed.normal_stiffness(np.array([widest]))[0])
        self._factor = (0.0 if self.endless else coefficient) * 4.0 * modulus / math.pi
        self.clock: Array = self.level(self.x.ravel()).reshape(self.x.shape)
        """At which level each spring comes into contact, at the nodes."""
        self._gather()

    def level(self, radius: Array) -> Array:
        """Return the level at which the contact has this radius: g, or the force."""
        if not self.forced:
            return self.bed.gap(radius)
        return self.bed.stiffness(radius) * self.bed.gap(radius) - self.bed.gap_load(radius)

    def _gather(self) -> None:
        from scipy.special import ellipkm1

        panels, t = self.panels, self.x.ravel()
        weight = self.bed.gap_slope(t) * panels.stretch.ravel() / t
        self._table: Array = ellipkm1((t[:, None] / t) ** 2) * weight
        table = self._table.reshape(t.size, *self.x.shape)
        number, own = np.arange(self.x.shape[0]), np.arange(t.size) // self.x.shape[1]
        whole = np.einsum("ipk,pk->ip", table, panels.part(panels.edges[1:], number))
        whole[number < own[:, None]] = 0.0
        before = panels.part(t, own) * table[np.arange(t.size), own]
        self._sums: Array = np.cumsum(whole, axis=1) - whole - np.sum(before, axis=1)[:, None]

    @functools.lru_cache(maxsize=64)  # noqa: B019 - bounds are few and cached by `twist_bound`
    def at(self, press: PressedState) -> Array:
        """Return b at the nodes [Pa], and what it would go on to be just beyond the edge, in the edge's panel."""
        result = np.zeros(self.x.size)
        if press.radius > 0.0:
            panels, count = self.panels, self.x.shape[1]
            place = np.array([press.radius])
            k = panels.panel(place)
            used = int(k[0] + 1) * count
            edge = self._table[:used, used - count : used] @ panels.part(place, k)[0]
            result[:used] = self._sums[:used, int(k[0])] + edge
            if press.excess > 0.0:
                from scipy.special import ellipkm1

                result[:used] += press.excess * ellipkm1((self.x.ravel()[:used] / press.radius) ** 2) / press.radius
        return self._factor * result.reshape(self.x.shape)

    def onset(self, kink: float, strength: float) -> float:
        """Return how -b' diverges above a kink at which g' holds strength / sqrt(x^2 - kink^2) [Pa]."""
        return self._factor * 0.5 * math.pi * strength / kink

    def most(self, press: PressedState) -> float:
        """Return the torque at which everything slides [N m]."""
        if self.endless:
            return math.inf if press.radius > 0.0 else 0.0
        return 2.0 * float(self.panels.integral(self.at(press) * self.x**2, np.array([press.radius]))[0])


@functools.lru_cache(maxsize=8)
def twist_bound(bed: Bed, coefficient: float, widest: float, forced: bool) -> TwistBound:
    """Return the bound, cached by value."""
    return TwistBound(bed, coefficient, widest, forced)
