r"""What layers of other conductors add to the temperature of a surface that moves past a source of heat.

In every layer a wave of the wave number k along a direction decays with the depth as :math:`\mathrm e^{-sz}`,
:math:`s^2=k^2+\mathrm ikb`, with the component b of V/kappa along the direction.  With the admittance
:math:`Y=\lambda s` of the base and, layer by layer upwards,

.. math:: \Gamma = \frac{\lambda s-Y}{\lambda s+Y}\,\mathrm e^{-2sh}, \qquad
          Y \leftarrow \lambda s\,\frac{1-\Gamma}{1+\Gamma},

the surface of the layered body answers with :math:`\frac1{\lambda s}\bigl(1+\frac{2\Gamma}{1-\Gamma}\bigr)` of the
top layer.  The first part is the thick body of the top layer's conductor; the second is an echo, which decays as
:math:`\mathrm e^{-2kh}`, so that in space it is smooth over the thickness h.  Its Fourier integral is turned into the
complex plane, upwards behind the source and downwards ahead of it, where nothing oscillates and no pole lies within
the quarter turn; in the logarithm of the wave number the trapezoidal rule then converges geometrically.
"""

from __future__ import annotations

import cmath
import functools
import math

import numpy as np

from winkler.numerics.integrals.quadrature import growing
from winkler.numerics.panels.chebyshev import Panels, fit_nodes, panels_from
from winkler.numerics.types import Array, ComplexArray
from winkler.values.value import value

TURN = 0.25 * math.pi
"""By which the path of the wave numbers is turned."""
STEP = 0.14
"""Of the rule, in the logarithm of the wave number."""
LONGEST = 1e-9
"""Least wave number over the least that matters of round sources, whose echo is bounded for long waves."""
LONGEST_OF_BANDS = 1e-20
"""The same of bands, whose echo grows as the inverse root of the wave number at most."""
DECAY = 34.0
"""Logarithm of what is left of the echo at the greatest wave number."""
PANEL_RATIO = 2.0
"""Ratio of the lengths of consecutive panels."""


@value
class Stack:
    """Layers on a thick body, all of which conduct heat.

    Parameters
    ----------
    conductivities : tuple of float
        From the surface down, the base last [W/(m K)].
    diffusivities : tuple of float
        [m^2/s].
    thicknesses : tuple of float
        Of the layers [m].
    """

    conductivities: tuple[float, ...]
    diffusivities: tuple[float, ...]
    thicknesses: tuple[float, ...]

    @property
    def depth(self) -> float:
        """Length [m] of the waves beyond which the layers no longer matter."""
        return max(self.conductivities) / min(self.conductivities) * sum(self.thicknesses)

    def echo(self, k: ComplexArray, rates: Array) -> ComplexArray:
        """Return 2 Gamma/(1 - Gamma)/s of the top layer [m].

        Parameters
        ----------
        k : ndarray
            Wave numbers [1/m].
        rates : ndarray
            Component of the velocity along the direction [m/s], not negative; broadcasts with k.
        """
        admittance: ComplexArray | None = None
        rows = list(zip(self.conductivities, self.diffusivities, (*self.thicknesses, math.inf), strict=True))
        for conductivity, diffusivity, thickness in reversed(rows):
            decay = np.sqrt(k) * np.sqrt(k + 1j * rates / diffusivity)
            own = conductivity * decay
            if admittance is None:
                admittance = own
                continue
            back = (own - admittance) / (own + admittance) * np.exp(-2.0 * decay * thickness)
            admittance = own * (1.0 - back) / (1.0 + back)
        return np.asarray(2.0 * back / (1.0 - back) / decay)


@value
class LayerEcho:
    """The echo of layers in space, along some directions, in units of a length: that of the source.

    Parameters
    ----------
    stack : Stack
    length : float
        Half-width or radius of the source [m].
    rates : ndarray, (directions,)
        Component of the velocity along each direction [m/s].
    reach : float
        Greatest distance from any part of the source, over the length.
    round : bool
        Whether the source is round, its temperature a mean over directions; a band otherwise.
    """

    stack: Stack
    length: float
    rates: Array
    reach: float
    round: bool

    @functools.cached_property
    def marks(self) -> Array:
        """Where panels begin and end, ascending from 0, over the length."""
        first = self.stack.thicknesses[0] / self.length
        return np.array([0.0, *growing(first, self.reach, PANEL_RATIO), self.reach])

    def at(self, places: Array) -> Array:
        """Return lambda T [W/m per W/m] `(directions, places)` at places behind (or, negative, ahead of) a unit source.

        Conductivity is that of the top layer; all places have one sign.
        """
        turn = cmath.exp(1j * (TURN if np.sum(places) >= 0.0 else -TURN))
        size = self.length
        longest = max(self.stack.depth / size, 1.0 + self.reach)
        first = (LONGEST if self.round else LONGEST_OF_BANDS) / longest
        last = DECAY * size / (2.0 * self.stack.thicknesses[0] * math.cos(TURN))
        count = math.ceil(math.log(last / first) / STEP)
        k = np.exp(np.linspace(math.log(first), math.log(last), count)) * turn
        spacing = math.log(last / first) / (count - 1)
        answer = self.stack.echo(k / size, self.rates[:, None]) / size * (k if self.round else 1.0)
        return np.asarray(np.real((answer * k) @ np.exp(1j * np.outer(k, places))) * spacing / math.pi)

    @functools.cached_property
    def rows(self) -> Array:
        """Chebyshev coefficients `(directions, 2, panels, n)` behind and ahead of the source, panel by panel."""
        nodes = fit_nodes(self.marks)
        both = np.stack([self.at(sign * np.ravel(nodes)) for sign in (1.0, -1.0)], axis=1)
        flat = panels_from(self.marks, both.reshape(-1, nodes.shape[1])).coefficients
        return np.asarray(flat.reshape(self.rates.size, 2, *nodes.shape))

    def sides(self, direction: int) -> tuple[Panels, Panels]:
        """Return the echo behind and ahead of the source over the distance, along one direction."""
        behind, ahead = self.rows[direction]
        return Panels(self.marks, behind), Panels(self.marks, ahead)

    def __call__(self, places: Array) -> Array:
        """Return the echo along the first direction, behind the source or (negative) ahead of it."""
        behind, ahead = self.sides(0)
        return np.where(places >= 0.0, behind(np.abs(places)), ahead(np.abs(places)))
