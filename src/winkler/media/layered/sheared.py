r"""Flat punches that are pushed along the surface, or twisted, on a medium with known surface compliances.

A rigid shift of a disc moves its surface by (U, 0).  With the traction written as
:math:`\tau_x+i\tau_y = \tau_0(r)+\tau_2(r)\,e^{2i\theta}`, a wave of it has the amplitudes :math:`T_0-T_2` along and
:math:`T_0+T_2` across its direction.  That the surface moves by U alone, without a part that turns with
:math:`2\theta`, leaves two equations for the cosine transforms :math:`p_L, p_T` of these amplitudes on the disc,

.. math:: p_L + K_L\,p_L = \text{const} ,\qquad p_T + K_T\,p_T = \text{const} ,\qquad
          \int_0^a p_L\,\mathrm dx = \int_0^a p_T\,\mathrm dx = \frac{F_x}{2\pi} ,

each that of a flat punch pressed into a medium with the compliance :math:`C_L`, or :math:`C_T`: the pair of coupled
dual integral equations falls apart, and the compliances are averaged,

.. math:: \frac1{k_x} = \frac12\Big(\frac1{k_L}+\frac1{k_T}\Big) .

The disc does not press (no normal traction); its surface may rise and sink.  A twist needs the waves across alone:
:math:`k_\varphi = 16\,G_t\int_0^a x\,\theta\,\mathrm dx` (`winkler.numerics.transforms.odd_response`).
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.transforms import fredholm
from winkler.numerics.transforms.cosine_transform import SurfaceResponse
from winkler.numerics.transforms.odd_response import OddResponse
from winkler.numerics.types import Array

__all__ = ["ShearedLayers"]


class ShearedLayers:
    """What a medium with known compliances does under shear and twist; subclasses state the compliances."""

    @property
    def tangential_response(self) -> SurfaceResponse:
        """The response of the pair to a shear load, averaged over its angle with the wave."""
        raise NotImplementedError

    @property
    def along_response(self) -> SurfaceResponse:
        """The response of the pair to shear along its wave."""
        raise NotImplementedError

    @property
    def across_response(self) -> SurfaceResponse:
        """The response of the pair to shear across its wave, and to a twist."""
        raise NotImplementedError

    @property
    def shear_modulus(self) -> float:
        """G* [Pa] of the uppermost layer and the other body: what the narrowest contacts feel."""
        return self.tangential_response.modulus

    @property
    def along_modulus(self) -> float:
        """m_L [Pa] of the uppermost layer and the other body, of shear along a wave, as in plane strain."""
        return self.along_response.modulus

    @property
    def torsional_modulus(self) -> float:
        """G_t [Pa] of the uppermost layer and the other body."""
        return 0.5 * self.across_response.modulus

    def punch_shear_stiffness(self, radius: Array) -> Array:
        """k_x(a) [N/m] of a flat punch that is pushed along the surface and does not press, without tilt."""
        along, across = (_stiffness(each, radius) for each in (self.along_response, self.across_response))
        whole = along + across
        return np.asarray(2.0 * along * across / np.where(whole > 0.0, whole, 1.0))

    def punch_torsional_stiffness(self, radius: Array) -> Array:
        """k_phi(a) [N m] of a flat punch that is twisted about its axis."""
        radius = np.asarray(radius, dtype=float)
        mean = fredholm.area(OddResponse(self.across_response), radius)
        return np.asarray(16.0 / 3.0 * self.torsional_modulus * radius**2 * mean)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) = k_x'(x)/2 [Pa]."""
        along, across = self.along_response, self.across_response
        first, second = (each.modulus * fredholm.mean(each, x) for each in (along, across))
        of_along, of_across = (each.modulus * fredholm.edge(each, x) ** 2 for each in (along, across))
        return np.asarray(2.0 * (second**2 * of_along + first**2 * of_across) / (first + second) ** 2)


def _stiffness(response: SurfaceResponse, radius: Array) -> Array:
    return 2.0 * response.modulus * fredholm.area(response, radius)
