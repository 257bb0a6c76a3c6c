"""Elastic solids that harden once they yield."""

from __future__ import annotations

import dataclasses
from typing import Annotated

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import Number, PositiveNotTiny
from winkler.values.value import value, words


@value
class LinearHardening(Elastic):
    r"""An elastic solid with a flow stress that increases linearly with the plastic strain.

    .. math:: \sigma = Y + H\varepsilon_p

    Parameters
    ----------
    young, poisson, strength : float
        As in `Elastic`; the strength Y [Pa] is where yielding begins.
    plastic_modulus : float
        H [Pa], positive.

    Examples
    --------
    >>> steel = LinearHardening(210e9, 0.3, 300e6, plastic_modulus=2e9)
    >>> steel.flow_stress(np.array([0.0, 0.1])).tolist()
    [300000000.0, 500000000.0]
    """

    __words__ = words(plastic_modulus=("H", "Pa", "rise of the flow stress by the plastic strain"))

    plastic_modulus: PositiveNotTiny = dataclasses.field(kw_only=True)

    def flow_stress(self, strain: Array) -> Array:
        """Return the flow stress [Pa] after plastic strains [-]."""
        return self.strength + self.plastic_modulus * strain


@value
class PowerHardening(Elastic):
    r"""An elastic solid with a flow stress that rises as a power of the strain, as of annealed metals.

    .. math:: \sigma = Y\left(1 + \frac{E\varepsilon_p}{Y}\right)^n

    Parameters
    ----------
    young, poisson, strength : float
        As in `Elastic`; the strength Y [Pa] is where yielding begins.
    exponent : float
        n [-], from 0 (which does not harden) to 0.5.

    Examples
    --------
    >>> copper = PowerHardening(120e9, 0.34, 60e6, exponent=0.3)
    >>> copper.flow_stress(np.array([0.0, 0.08])).round(-6).tolist()
    [60000000.0, 276000000.0]
    """

    __words__ = words(exponent=("n", "", "power of the strain with which the flow stress rises"))

    exponent: Annotated[float, Number("give a number from 0 to 0.5", 0.0, 0.5)] = dataclasses.field(kw_only=True)

    def flow_stress(self, strain: Array) -> Array:
        """Return the flow stress [Pa] after plastic strains [-]."""
        return np.asarray(self.strength * (1.0 + self.young * strain / self.strength) ** self.exponent)


Hardening = LinearHardening | PowerHardening
