r"""The bed of a strip beside which a constant stress pulls: its flat punches go on beyond the strip.

Of the stress :math:`-\sigma_0` between a and c the potential below the surface is

.. math:: F(\zeta) = -\frac{2\sigma_0}\pi\ln\frac{l+\sqrt{\zeta^2-a^2}}{\sqrt{\zeta^2-c^2}} ,
          \qquad l = \sqrt{c^2-a^2} .
"""

from __future__ import annotations

import math

import numpy as np

from winkler.checks.number_checks import NonNegative, Positive
from winkler.foundation.line import LineFoundation
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["ZonedBed"]

NODES = 64


@value
class ZonedBed(LineFoundation):
    """A line contact and the attraction beside one strip of it.

    Parameters
    ----------
    strength : float
        The stress sigma_0 [Pa].
    contact, outer : float
        a and c [m].
    """

    __words__ = words(
        strength=(r"\sigma_0", "Pa", "stress with which the surfaces attract each other"),
        contact=("a", "m", "half-width of the contact"),
        outer=("c", "m", "where the attraction ends"),
    )

    strength: Positive
    contact: NonNegative
    outer: Positive

    @property
    def hertz_radius(self) -> float:
        """Infinite: the attraction alters the pressure."""
        return math.inf

    @property
    def span(self) -> float:
        """l = sqrt(c^2 - a^2) [m]."""
        return math.sqrt((self.outer - self.contact) * (self.outer + self.contact))

    def beside(self, half_width: float) -> tuple[Array, Array]:
        """Return half-widths [m] of the flat punches beside the strip, and their loads over E* [m]."""
        y, weights = gauss_legendre(NODES)
        widths = np.sqrt(self.outer**2 - (self.span * y) ** 2)
        return widths, -2.0 * self.strength / self.medium.modulus * self.span * weights

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa], negative where the surfaces attract each other."""
        away = np.abs(x)
        inside = np.sqrt(np.maximum((half_width - away) * (half_width + away), 0.0))
        pull = np.where(away < self.outer, 2.0 * self.strength / math.pi * np.arctan2(self.span, inside), 0.0)
        return np.asarray(LineFoundation.pressure(self, x, half_width, rim_load) - pull)

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F [Pa] on the surface."""
        with np.errstate(divide="ignore"):
            zone, _ = self._zone(np.asarray(x) + 0j)
        along = LineFoundation.surface_potential(self, x, half_width, rim_load).real + zone.real
        return np.asarray(along - 1j * self.pressure(x, half_width, rim_load))

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return F [Pa] and F' [Pa/m] below the surface."""
        whole, slope = LineFoundation.potential(self, x, z, half_width, rim_load)
        zone, grown = self._zone(x + 1j * z)
        return whole + zone, slope + grown

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, lifted by the attraction."""
        lifted = self.pulled_apart(np.ravel(np.maximum(x, half_width))).reshape(x.shape)
        return LineFoundation.separation(self, x, half_width, rim_load) + np.where(x > half_width, lifted, 0.0)

    def _zone(self, zeta: Array) -> tuple[Array, Array]:
        a, c = self.contact, self.outer
        inner = np.sqrt(zeta - a) * np.sqrt(zeta + a)
        outer = np.sqrt(zeta - c) * np.sqrt(zeta + c)
        factor = -2.0 * self.strength / math.pi
        with np.errstate(divide="ignore", invalid="ignore"):
            whole = factor * np.log((self.span + inner) / outer)
            slope = factor * zeta * (1.0 / (inner * (self.span + inner)) - 1.0 / outer**2)
        return whole, slope

    def pulled_apart(self, x: Array) -> Array:
        """Return by how much the attraction lifts the surfaces at places x >= a [m]: they end at less than without."""
        t, weights = gauss_legendre(NODES)
        first = np.sqrt(np.maximum((self.outer - x) * (self.outer + x), 0.0)) / self.span
        y = first[:, None] + (1.0 - first[:, None]) * t**2
        widths = np.sqrt(np.maximum(self.outer**2 - (self.span * y) ** 2, self.contact**2))
        ratio = np.maximum(x[:, None] / np.maximum(widths, 1e-300), 1.0)
        lifted = np.sum(np.arccosh(ratio) * 2.0 * t * weights, axis=1) * (1.0 - first)
        return np.asarray(4.0 * self.strength / (math.pi * self.medium.modulus) * self.span * lifted)
