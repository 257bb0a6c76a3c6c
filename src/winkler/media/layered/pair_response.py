r"""The response of two bodies to a load on their surfaces, wave by wave: the sum of what both bodies answer.

A shear traction that points along its wave moves the surface by :math:`C_L(\xi)`, together with its depth (P and SV
waves); one across its wave moves it by :math:`C_T(\xi)` (SH waves, which need no Poisson's ratio).  All compliances
are written as :math:`C = \frac2{m\,\xi}\,(1+M(\xi))` with a modulus m, that of the uppermost layer and the other body:
:math:`E^*` of a pressure, and of isotropic bodies

.. math:: \frac1{m_L} = \sum_i\frac{1-\nu_i}{2G_i} , \qquad \frac1{m_T} = \sum_i\frac1{2G_i} = \frac1{2G_t} ,
          \qquad \frac1{G^*} = \frac12\Big(\frac1{m_L}+\frac1{m_T}\Big) .
"""

from __future__ import annotations

import enum
import functools

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.media.layered.stack import Layered, StackBody
from winkler.media.layered.wave_constants import Body, Wave, half_space_compliance
from winkler.numerics.caching import rounded
from winkler.numerics.types import ComplexArray
from winkler.values.value import value, words


class Mode(enum.Enum):
    """A load, and the shares of the waves in what it moves."""

    NORMAL = ((Wave.NORMAL, 1.0),)
    """A pressure."""
    ALONG = ((Wave.ALONG, 1.0),)
    """Shear along its wave."""
    ACROSS = ((Wave.ACROSS, 1.0),)
    """Shear across its wave, a twist, antiplane shear."""
    TANGENTIAL = ((Wave.ALONG, 0.5), (Wave.ACROSS, 0.5))
    """Shear, averaged over its angle with the wave."""
    COUPLING = ((Wave.COUPLING, 1.0),)
    """A pressure, by how much farther than short waves it draws the first surface along, over what these sink."""
    TURNING = ((Wave.ALONG, -0.5), (Wave.ACROSS, 0.5))
    """Half of what waves across their direction move more than those along it, over the mean of the surface."""


MODE_WORDS = words(mode=("", None, "the load: a pressure, or shear along, across or at all angles with its wave"))


class WavePair:
    """What responses of two bodies share; the second is a homogeneous half-space."""

    mode: Mode
    first: Layered
    second: Body

    @functools.cached_property
    def _weights(self) -> tuple[tuple[Wave, float], ...]:
        shares: tuple[tuple[Wave, float], ...] = self.mode.value
        return shares

    @property
    def _unit(self) -> tuple[tuple[Wave, float], ...]:
        """Those of which the modulus is."""
        return Mode.NORMAL.value if self.mode is Mode.COUPLING else self._weights

    @functools.cached_property
    def _short(self) -> float:
        """What the first body answers to short waves, 1 / modulus [1/Pa]."""
        return sum(abs(weight) * self.first.short(part) for part, weight in self._unit)

    @functools.cached_property
    def added(self) -> float:
        """The same of the second body."""
        return sum(abs(weight) * half_space_compliance(self.second, part) for part, weight in self._unit)

    @property
    def _own_second(self) -> Solid:
        """The second body in the unit of the first; only its compliance matters: it is one without Poisson's ratio."""
        if not self.added:
            return RIGID
        like = sum(abs(weight) * half_space_compliance(Elastic(1.0, 0.0), part) for part, weight in self._unit)
        return Elastic(rounded(like / (self.first.unit[0] * self.added)), 0.0)

    @functools.cached_property
    def modulus(self) -> float:
        """E*, G*, m_L or m_T [Pa] of the surface of the first and the second body: C = 2 (1 + M) / (modulus xi)."""
        return 1.0 / (self._short + self.added)

    @functools.cached_property
    def _share(self) -> float:
        """Compliance of the surface of the first body in that of the pair."""
        return self.modulus * self._short if self.added else 1.0

    def _exceeding(self, xi: ComplexArray) -> ComplexArray:
        """Return what the first body answers beyond its short waves, over what it answers to these [-]."""
        found: ComplexArray = np.zeros_like(xi)
        for part, weight in self._weights:
            found = found + weight / self._short * (self.first.waves(part, xi) - self.first.short(part))
        return found


@value
class PairResponse(WavePair):
    """The response of a stack and its counterpart.

    Parameters
    ----------
    mode : Mode
        The load.
    first : StackBody
        Layers, at least one, on what carries them.
    second : Elastic, TransverselyIsotropic or Rigid
        The other body, a homogeneous half-space.
    """

    __words__ = MODE_WORDS

    mode: Mode
    first: StackBody
    second: Body = RIGID

    precision = 3e-14
    """Rounding of M, relative to its largest value."""

    @property
    def own(self) -> tuple[PairResponse, float]:
        """The same in units of thickness and modulus of its uppermost layer; and that thickness [m]."""
        return type(self)(self.mode, self.first.in_own_units(), self._own_second), self.first.unit[1]

    @functools.cached_property
    def length(self) -> float:
        """M tends to zero like exp(-2 xi length) [m]."""
        return min(self.first.decay_length(part) for part, _ in self._weights)

    @property
    def smooth(self) -> float:
        """The same: the kernel has no logarithm [m]."""
        return self.length

    @property
    def span(self) -> float:
        """Length [m] beyond which the stack is only its base."""
        return self.first.span

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        long = sum(weight * self.first.compressed(part) for part, weight in self._weights)
        return self.modulus * long if not self.added else float("inf")

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return np.asarray(self._share * self._exceeding(xi))

    def whole(self, xi: ComplexArray) -> ComplexArray:
        """1 + M(xi) [-], to all digits where it is small, too."""
        parts = [weight * self.first.waves(part, xi) for part, weight in self._weights]
        return np.asarray(self.modulus * (sum(parts[1:], parts[0]) + self.added))
