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
from slip_of_layers import SlippingCylinder


class RollingCylinder(SlippingCylinder):
    """A cylinder of the radius 1 under a rigid body, E* = 1 of the uppermost layer; creepage and force over mu."""

    def __init__(self, layers, on, a, c, count=120, *, proportional=False):
        super().__init__(layers, on, a, c, count)
        self.along = self.normal if proportional else self.along
        s, shares, x = self.rule(c, count)
        x = x + a - c
        kernel = (1.0 / (x[:, None] - s - a + c) + self.smooth(self.along, x, s + a - c)) * shares
        found = np.linalg.solve(np.column_stack([kernel, np.full(x.size, 0.5 * np.pi)]), self.dragged(x))
        self.creepage = float(found[-1])
        self.force = self.load - float(shares @ found[:-1])


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
    mismatch = 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson)
    added = (coupling(layers, on, cylinder.k) - mismatch) * cylinder.weights
    borne = cylinder.shares * cylinder.p
    g = np.polynomial.chebyshev.Chebyshev.fit(cylinder.s / a, cylinder.p, 40)
    x = a * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, 1001))
    pressure = np.sqrt(a * a - x * x) * g(x / a) / a
    waves = added * (np.cos(np.outer(cylinder.k, cylinder.s)) @ borne)
    stretch = 2.0 * mismatch * pressure + 2.0 / np.pi * np.cos(np.outer(x, cylinder.k)) @ waves
    middle, share = 0.5 * (stretch[1:] + stretch[:-1]), 0.5 * (pressure[1:] + pressure[:-1]) * np.diff(x)
    order = np.argsort(middle)
    below = np.cumsum(share[order]) - 0.5 * share[order]
    return float(np.interp(0.5 * np.sum(share), below, middle[order]))
