r"""Steady rolling on layers by another route than the package's: singular integral equations of one zone of stick.

With the kernels of `slip_of_layers`, waves crossed by matrix exponentials, a cylinder of the radius 1 that sticks from
the leading edge a back to a - 2 c has the traction :math:`q=\mu p-q^*`, where in the zone of stick

.. math:: \int_{a-2c}^a K_L(x-s)\,q^*\,\mathrm ds + \frac{\pi E^*}2\,\xi = \mu\int_{-a}^aK_L(x-s)\,p\,\mathrm ds .

That :math:`q^*` is bounded at both ends determines the creepage.  Without friction to speak of, each place of a free
cylinder slips to the side on which its coupling stretches the first surface more, or less, than the creepage does.
"""

from __future__ import annotations

import layer_waves
import numpy as np
from scipy.interpolate import CubicSpline
from slip_of_gradings import SlippingOnGrading, compliance
from slip_of_layers import SlippingCylinder


class Rolling:
    """What a cylinder that presses and slips, of the radius 1, does while it rolls: creepage and force over mu."""

    def roll(self, count):
        s, shares, x = self.rule(self.c, count)
        kernel = (1.0 / (x[:, None] - s) + self.smooth(self.along, x, s)) * shares
        system = np.column_stack([kernel, np.full(x.size, 0.5 * np.pi)])
        found = np.linalg.solve(system, self.dragged(x + self.a - self.c))
        self.creepage = float(found[-1])
        self.force = self.load - float(shares @ found[:-1])


class RollingCylinder(Rolling, SlippingCylinder):
    """A cylinder of the radius 1 under a rigid body, E* = 1 of the uppermost layer; creepage and force over mu."""

    def __init__(self, layers, on, a, c, count=120, *, proportional=False):
        super().__init__(layers, on, a, c, count)
        self.along = self.normal if proportional else self.along
        self.roll(count)


class RollingOnGrading(Rolling, SlippingOnGrading):
    """The same on a grading."""

    def __init__(self, young, poisson, settled, a, c, count=120):
        super().__init__(young, poisson, settled, a, c, count)
        self.roll(count)


def coupling(layers, on, xi):
    """Return the compliance along a wave under pressures over that under short pressures, at wave numbers."""
    fields = np.broadcast_to(layer_waves.base(on), (xi.size, 4, 2))
    for shear, poisson, thickness in reversed(layers):
        scale = np.array([1.0, 1.0, shear, shear])[:, None]
        fields = scale * (layer_waves.crossed(poisson, xi * thickness) @ (fields / scale))
        fields = fields / np.max(np.abs(fields), axis=(1, 2), keepdims=True)
    compliance = -(fields[:, :2] @ np.linalg.inv(fields[:, 2:]))
    shear, poisson, _ = layers[0]
    return np.abs(compliance[:, 0, 1]) * np.sign(compliance[:, 0, 1] * compliance[-1, 0, 1]) * shear / (1.0 - poisson)


def free_creepage(layers, on, a):
    """Return the creepage of a free cylinder without friction to speak of: half of the load lies on either side."""
    cylinder = SlippingCylinder(layers, on, a, 0.5 * a)
    poisson = layers[0][1]
    return halved_creepage(cylinder, poisson, cylinder.k, cylinder.weights, coupling(layers, on, cylinder.k))


def free_creepage_on_grading(young, poisson, settled, a, count=120):
    """Return the same on a grading, with waves up to 100 over the depth scale: M p falls like k^-2.5."""
    places = np.concatenate([[1e-6], np.geomspace(1e-3, 100.0, 100)])
    drawn = [compliance(young, poisson, settled, k)[0, 1] * float(young(0.0)) for k in places]
    edges = np.concatenate([[0.0], np.geomspace(1e-3, 1.0 / a, 12), np.arange(1.0, 100.0 * a, 2.0)[1:] / a])
    node, weight = np.polynomial.legendre.leggauss(8)
    k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (node + 1.0)).ravel()
    weights = (0.5 * np.diff(edges)[:, None] * weight).ravel()
    share = CubicSpline(np.log1p(1e2 * places), np.array(drawn) / (2.0 * (1.0 - poisson**2)))(np.log1p(1e2 * k))
    cylinder = SlippingOnGrading(young, poisson, settled, a, 0.5 * a, count)
    return halved_creepage(cylinder, poisson, k, weights, share)


def halved_creepage(cylinder, poisson, k, weights, share):
    """Return the creepage that half of the load stretches less, from the coupling over short pressures by waves."""
    a, mismatch = cylinder.a, 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson)
    borne = cylinder.shares * cylinder.p
    g = np.polynomial.chebyshev.Chebyshev.fit(cylinder.s / a, cylinder.p, 40)
    x = a * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, 1001))
    pressure = np.sqrt(a * a - x * x) * g(x / a) / a
    waves = (share - mismatch) * weights * (np.cos(np.outer(k, cylinder.s)) @ borne)
    stretch = 2.0 * mismatch * pressure + 2.0 / np.pi * np.cos(np.outer(x, k)) @ waves
    middle, borne = 0.5 * (stretch[1:] + stretch[:-1]), 0.5 * (pressure[1:] + pressure[:-1]) * np.diff(x)
    order = np.argsort(middle)
    below = np.cumsum(borne[order]) - 0.5 * borne[order]
    return float(np.interp(0.5 * np.sum(borne), below, middle[order]))
