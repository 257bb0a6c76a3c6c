r"""The surface compliances of a stack of layers for tractions along and across a wave.

A shear traction that points along its wave moves the surface by :math:`C_L(\xi)`, together with its depth (P and SV
waves); one across its wave moves it by :math:`C_T(\xi)` (SH waves, which need no Poisson's ratio).  Both are written as
:math:`C = \frac2{m\,\xi}\,(1+M(\xi))`, with the moduli

.. math:: \frac1{m_L} = \sum_i\frac{1-\nu_i}{2G_i} , \qquad \frac1{m_T} = \sum_i\frac1{2G_i} = \frac1{2G_t}

of the uppermost layer and the other body.
"""

from __future__ import annotations

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.materials.layered import Layer
from winkler.media.layered.across import climbed_across
from winkler.media.layered.climb import climbed
from winkler.media.layered.layers import LayeredResponse, rounded
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["AcrossResponse", "AlongResponse", "across_modulus", "along_modulus"]


def along_modulus(*bodies: Solid) -> float:
    """Return m_L [Pa] of bodies, of which a rigid one counts nothing."""
    return 1.0 / sum((1.0 - body.poisson) / (2.0 * body.shear) for body in bodies if isinstance(body, Elastic))


def across_modulus(*bodies: Solid) -> float:
    """Return m_T [Pa] of bodies, of which a rigid one counts nothing."""
    return 2.0 / sum(1.0 / body.shear for body in bodies if isinstance(body, Elastic))


def _without_poisson(second: Solid, compliance: float, unit: float) -> Solid:
    """Return a body that adds as much: only its compliance (1 - nu) / G or 1 / G matters."""
    return Elastic(rounded(2.0 / (compliance * unit)), 0.0) if isinstance(second, Elastic) else second


@value
class AlongResponse(LayeredResponse):
    """The response to a shear traction along its wave."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    @property
    def own(self) -> tuple[AlongResponse, float]:
        """The same in units of its uppermost layer, as that of `NormalResponse`."""
        second = self.second
        added = (1.0 - second.poisson) / second.shear if isinstance(second, Elastic) else 1.0
        return self._with_layer_of_one(_without_poisson(second, added, self.layers[0].solid.young)), self.length

    @property
    def modulus(self) -> float:
        """m_L [Pa] of the uppermost layer and the second body."""
        return along_modulus(self.layers[0].solid, self.second)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        top = self.layers[0].solid
        along = -climbed(self.layers, self.on, xi)[0][1][0]
        return np.asarray(0.5 * self.modulus * (along - (1.0 - top.poisson) / top.shear))


@value
class AcrossResponse(LayeredResponse):
    """The response to a shear traction across its wave: that of a twist, and of antiplane shear."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    @property
    def own(self) -> tuple[AcrossResponse, float]:
        """The same in units of its uppermost layer, as that of `NormalResponse`."""
        second = self.second
        added = 1.0 / second.shear if isinstance(second, Elastic) else 1.0
        return self._with_layer_of_one(_without_poisson(second, added, self.layers[0].solid.young)), self.length

    @property
    def modulus(self) -> float:
        """m_T = 2 G_t [Pa] of the uppermost layer and the second body."""
        return across_modulus(self.layers[0].solid, self.second)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        across = climbed_across(self.layers, self.on, xi)[0]
        return np.asarray(0.5 * self.modulus * (across - 1.0 / self.layers[0].solid.shear))
