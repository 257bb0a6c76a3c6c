r"""What springs bear under rings, or strips, that slide on layers, and how the surface slips, on a grid.

Normal and shear kernels of layers differ.  Rings that slide bear :math:`\mu p`, and the line load q of the springs
which press like that on a homogeneous body (`winkler.numerics.transforms.layered_grid`) is also that of springs pushed
by b along the surface,

.. math:: \varphi_S(x;x)\,b(x) - \int_x^\infty\rho_S(x;t)\,\varphi_S(t;t)\,b(t)\,\mathrm dt = q(x) .

The surface lags behind a rigid shift by the s of which the transform :math:`h` follows from the springs' lag
:math:`\sigma=(U-b)_+`,

.. math:: h(x) - \int_0^x\rho_S(t;x)\,h(t)\,\mathrm dt = \varphi_S(x;x)\,\sigma(x) , \qquad
          s(r) = \frac2\pi\int_0^r\frac{h(x)\,\mathrm dx}{\sqrt{r^2-x^2}} .

Both equations are triangular on the nodes.  Of strips the second has x/t beside h, and the transform of the surface is
their own.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.transforms.grid_transforms import SurfaceTransform, cuts_of
from winkler.numerics.transforms.layered_grid import LayeredGrid
from winkler.numerics.types import Array


class RubbedRings:
    """The shear springs of layers on one grid.

    Parameters
    ----------
    normal, shear : LayeredGrid
        Of the responses to a pressure and to a shear traction.
    """

    def __init__(self, normal: LayeredGrid, shear: LayeredGrid) -> None:
        self.normal, self.shear = normal, shear
        self._surface = SurfaceTransform(self.shear.plain)
        self._squares = normal.squares

    def bounds(self, stretch: Array) -> Array:
        """Return b [m] at the nodes over mu E*/G*, under springs that are pressed by what is positive of a stretch [m].

        Where nothing is pressed b goes on below zero, as the stretch does.
        """
        from scipy.linalg import solve_triangular

        shear, beyond = self.shear, stretch <= 0.0
        load = self.normal.line_load(stretch, cuts_of(self._squares, stretch))
        outside = self.normal.edge / shear.edge * stretch
        bound = outside
        # what nodes alone miss of the cell in which the contact ends depends on b itself, a little
        for first in (True, False):
            more = 0.0 if first else shear.missed_load(cuts_of(self._squares, bound))
            solved = solve_triangular(shear.own, load + more)
            bound = np.where(beyond, outside, solved)
        return np.asarray(bound)

    def slip(self, lag: Array) -> Array:
        """Return how far the surface lags behind [m] at the nodes, if springs do by what is positive of a lag [m]."""
        from scipy.linalg import solve_triangular

        shear, sticks = self.shear, lag <= 0.0
        lagging = shear.edge * lag
        transform = lagging
        for first in (True, False):
            more = 0.0 if first else shear.missed_hold(cuts_of(self._squares, transform))
            solved = solve_triangular(shear.held_away, np.maximum(lagging, 0.0) + more, lower=True)
            transform = np.where(sticks, lagging, solved)
        return self._surface(transform, cuts_of(self._squares, transform))
