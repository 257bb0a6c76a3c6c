r"""The transforms of round contacts on a grid of radii.

Every integral of `winkler.numerics.transforms.graded_abel` is known in closed form, cell by cell: with
:math:`q = (1+k)/2` and a slope :math:`\beta` of f or u over :math:`y = r^2` in the cell from s to t

.. math:: g(x) \mathrel{+}= \frac{x^{1-k}\beta}{q}\,\big[(x^2-s^2)^q-(x^2-t^2)^q\big] , \qquad
          \int_r^a 2\pi r\,p\,\mathrm dr \mathrel{+}=
          -\frac{\beta}{q(q+1)}\,\big[(t^2-r^2)^{q+1}-(s^2-r^2)^{q+1}\big] ,

brackets counting where they are positive.  Pressures are means over rings about the nodes; the displacement of the
surface is made of incomplete beta functions.  For a paraboloid this is exact.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.transforms.grid_transforms import CutCell, GridTransforms
from winkler.numerics.types import Array


class RingTransforms(GridTransforms):
    """Matrices of the transforms on one grid of radii.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Radii [m], rising from zero.
    exponent : float
        k of the grading, above -1 and at most 1; zero for a homogeneous half-space.
    """

    in_the_middle = 1.0

    def __init__(self, nodes: Array, exponent: float) -> None:
        super().__init__(nodes)
        self.k, self.q = exponent, 0.5 * (1.0 + exponent)
        y = self.squares
        # (y_j - y_i)^q where positive: for the gap rows are x, for the pressure rows are r
        reach = np.maximum(y[:, None] - y[None, :], 0.0) ** self.q
        with np.errstate(divide="ignore"):
            scale = np.where(nodes > 0.0, nodes ** (1.0 - exponent), 0.0 if exponent < 1.0 else 1.0)
        self.gap = self.by_values(scale[:, None] / self.q * (reach[:, :-1] - reach[:, 1:]))
        self.force = self._force_weights()
        # rings between the middles (in y) of the cells: what they bear is known exactly, and they part the whole area
        self.borders = np.concatenate(([0.0], 0.5 * (y[1:] + y[:-1])))
        self.areas = math.pi * np.diff(np.append(self.borders, y[-1]))
        self.set_loads()

    def load_of_slope(self, upto: Any, border: Array) -> Array:
        """As `GridTransforms.load_of_slope`, over E* / c_0^k."""
        reach = np.maximum(upto - border, 0.0)
        power = reach * np.sqrt(reach) if self.k == 0.0 else reach ** (self.q + 1.0)
        return np.asarray(power / (self.q * (self.q + 1.0)))

    def load_of_rim(self) -> Array:
        """As `GridTransforms.load_of_rim`, over E* / c_0^k."""
        return np.asarray((self.squares[-1] - self.borders) ** self.q / self.q)

    def surface_parts(self, upto: Any, nodes: Array) -> tuple[Array, Array]:
        """As `GridTransforms.surface_parts`."""
        y = nodes * nodes
        part = np.minimum(upto / np.where(y > 0.0, y, 1.0), 1.0)
        part = np.where(y > 0.0, part, 0.0)
        if self.k == 0.0:
            angle = np.arcsin(np.sqrt(part))
            return 2.0 / math.pi * angle, y / math.pi * (angle - np.sqrt(part * (1.0 - part)))
        from scipy.special import betainc

        rest = 0.5 * (1.0 - self.k)
        return betainc(self.q, rest, part), self.q * y * betainc(self.q + 1.0, rest, part)

    def means(self, squares: Array, values: Array) -> Array:
        """As `GridTransforms.means`: nothing of a volume is lost."""
        borders = np.append(self.borders, self.squares[-1])
        below = np.concatenate(([0.0], np.cumsum(0.5 * np.diff(squares) * (values[1:] + values[:-1]))))
        cell = np.clip(np.searchsorted(squares, borders, side="right") - 1, 0, squares.size - 2)
        part = np.minimum(borders, squares[-1]) - squares[cell]
        slope = (values[cell + 1] - values[cell]) / (squares[cell + 1] - squares[cell])
        upto = below[cell] + part * (values[cell] + 0.5 * slope * part)
        return np.asarray(np.diff(upto) / np.diff(borders))

    def moments(self, places: Any) -> tuple[Any, Any]:
        """As `GridTransforms.moments`, of x^k and x^(k+2)."""
        powers = places**self.q
        return powers / (1.0 + self.k), powers * places / (3.0 + self.k)

    def _force_weights(self) -> Array:
        low, high = self.squares[:-1], self.squares[1:]
        zeroth, second = np.diff(self.moments(self.squares))
        weights = np.zeros(self.nodes.size)
        weights[1:] += (second - low * zeroth) / self.widths
        weights[:-1] += (high * zeroth - second) / self.widths
        return weights

    def integral(self, values: Array, cuts: list[CutCell]) -> float:
        """Return the integral of x^k values(x)+ from 0 to the last node."""
        return float(self.force @ np.maximum(values, 0.0)) + sum(self.missed(cuts))

    def springs_within(self, squares: Any) -> Any:
        """Return the integral of x^k from 0 to places in y: what springs displaced by one metre bear there."""
        return self.moments(squares)[0]
