r"""The transforms of line contacts on a grid of distances from the middle.

With a slope :math:`\beta` of f, or of what the load lacks, over :math:`y = x^2` in the cell from s to t

.. math:: w(a) \mathrel{+}= \beta\,\Big[a^2\arcsin\frac xa - x\sqrt{a^2-x^2}\Big]_s^t , \qquad
          2\int_x^a p\,\mathrm dx \mathrel{+}=
          -\frac{2\beta}\pi\,\Big[c^2\arccos\frac xc - x\sqrt{c^2-x^2}\Big]_{c=s}^t ,

brackets counting where their roots are real.  The distance that a narrower contact leaves open beside it is, of what
its load lacks against the load profile, :math:`v = w - \gamma`,

.. math:: h(x) = \frac{2x}\pi\int_0^x\frac{v_+(c)}{c\,\sqrt{x^2-c^2}}\,\mathrm dc .

On bodies graded by a power k of the depth the roots become powers q = (1 + k)/2 and 1 - q of their squares,

.. math:: w(a) \mathrel{+}= \beta\,C\,a^{2+k}\,\Big[\mathrm B_{x^2/a^2}(\tfrac32,q)\Big]_s^t , \qquad
          2\int_x^a p\,\mathrm dx \mathrel{+}= -\beta\,\Big[\big(c^2+kx^2\big)\,
          \mathrm I_{1-x^2/c^2}(q,\tfrac12) - \frac{2xc\,(1-x^2/c^2)^q}{\mathrm B(q,\frac12)}\Big]_{c=s}^t ,

.. math:: h(x) = -D\int_0^x v_+(c)\,\frac{\partial S}{\partial c}\,\mathrm dc , \qquad
          S = \int_c^x\frac{\mathrm dt}{(t^2-c^2)^q} = \tfrac12c^{-k}\,\mathrm B_{1-c^2/x^2}(1-q,\tfrac k2) ,

with incomplete beta functions, and the factors C and D of the medium, 1 and :math:`2/\pi` of a half-plane.  For a
parabolic cylinder all of these are exact.  Pressures are means over strips about the nodes, each as wide as the
integral of the function that is 1 at its node and zero at all others.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.transforms.grid_transforms import CutCell, GridTransforms
from winkler.numerics.types import Array

FIRST_PLACE = 1e-30
"""Place in y, over that of the first node beside the middle, that stands for the middle itself."""


class StripTransforms(GridTransforms):
    """Matrices of the transforms on one grid of distances from the middle.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Distances [m], rising from zero.
    exponent : float, optional
        k of the grading, above -1 and below 1; zero of half-planes.
    raised, lifted : float, optional
        C [m^-k] and D [m^k].
    """

    in_the_middle = 0.0

    def __init__(self, nodes: Array, exponent: float = 0.0, raised: float = 1.0, lifted: float = 2.0 / math.pi) -> None:
        super().__init__(nodes)
        self.k, self.q, self.lifted = exponent, 0.5 * (1.0 + exponent), lifted
        x, y = nodes[:, None], self.squares
        inside = np.minimum(nodes[None, :], x)
        if exponent == 0.0:
            root = np.sqrt((x - inside) * (x + inside))
            upto = y[:, None] * np.arctan2(inside, root) - inside * root
        else:
            from scipy.special import beta, betainc

            part = inside / np.where(x > 0.0, x, 1.0)
            upto = raised * x ** (2.0 + self.k) * beta(1.5, self.q) * betainc(1.5, self.q, part * part)
        self.gap = self.by_values(upto[:, 1:] - upto[:, :-1])
        steps = np.diff(nodes)
        # the part of a cell for which its lower node stands: the integral of what falls from 1 to 0, straight in y
        lower = steps * (2.0 * nodes[1:] + nodes[:-1]) / (3.0 * (nodes[1:] + nodes[:-1]))
        self.borders = np.concatenate(([0.0], nodes[:-1] + lower))
        self.areas = 2.0 * np.diff(np.append(self.borders, nodes[-1]))
        self.force = np.eye(1, nodes.size)[0]
        self.set_loads()

    def load_of_slope(self, upto: Any, border: Array) -> Array:
        """As `GridTransforms.load_of_slope`, on both sides."""
        if self.k != 0.0:
            from scipy.special import beta, betainc

            part = np.maximum(1.0 - border * border / np.where(upto > 0.0, upto, 1.0), 0.0) * (upto > 0.0)
            beyond = (upto + self.k * border * border) * betainc(self.q, 0.5, part)
            return np.asarray(beyond - 2.0 * border * np.sqrt(upto) * part**self.q / beta(self.q, 0.5))
        root = np.sqrt(np.maximum(upto - border * border, 0.0))
        return np.asarray(2.0 / math.pi * np.where(root > 0.0, upto * np.arctan2(root, border) - border * root, 0.0))

    def load_of_rim(self) -> Array:
        """As `GridTransforms.load_of_rim`, on both sides."""
        if self.k != 0.0:
            from scipy.special import betainc

            return np.asarray(betainc(self.q, 0.5, np.maximum(1.0 - (self.borders / self.nodes[-1]) ** 2, 0.0)))
        return np.asarray(2.0 / math.pi * np.arccos(np.minimum(self.borders / self.nodes[-1], 1.0)))

    def integral(self, values: Array, cuts: list[CutCell]) -> float:
        """Return the load over E* [m]: what the spring in the middle bears."""
        return max(float(values[0]), 0.0)

    def surface_parts(self, upto: Any, nodes: Array) -> tuple[Array, Array]:
        """As `GridTransforms.surface_parts`; the first from any one place on."""
        x, y = nodes, nodes * nodes
        inside = np.clip(upto, FIRST_PLACE * self.squares[1], np.maximum(y, FIRST_PLACE * self.squares[1]))
        root = np.sqrt(np.maximum(y - inside, 0.0))
        if self.k != 0.0:
            opened, k = self._opened(root, inside), self.k
            rest = 2.0 * x * root ** (1.0 - k) / (1.0 - k)
            return -self.lifted * opened, -self.lifted * (rest - k * inside * opened) / (2.0 - k)
        return -2.0 / math.pi * np.arcsinh(root / np.sqrt(inside)), -2.0 / math.pi * x * root

    def _opened(self, root: Array, inside: Array) -> Array:
        """Return S [m^-k] from places whose squares are `inside` to such a root [m] of what is left."""
        from scipy.special import beta, betainc

        a, b = 1.0 - self.q, 0.5 * self.k
        left = root * root / (root * root + inside)
        if b > 0.0:
            whole = beta(a, b) * betainc(a, b, left)
        else:  # by the one with b + 1
            rest = inside / (root * root + inside)
            whole = ((a + b) * beta(a, b + 1.0) * betainc(a, b + 1.0, left) - left**a * rest**b) / b
        return np.asarray(0.5 * inside**-b * whole)

    def means(self, squares: Array, values: Array) -> Array:
        """As `GridTransforms.means`: nothing of a cross-section is lost."""
        places, borders = np.sqrt(squares), np.append(self.borders, self.nodes[-1])
        slope = np.diff(values) / np.diff(squares)
        start = values[:-1] - slope * squares[:-1]
        cells = np.diff(places) * start + slope * np.diff(places**3) / 3.0
        below = np.concatenate(([0.0], np.cumsum(cells)))
        cell = np.clip(np.searchsorted(places, borders, side="right") - 1, 0, places.size - 2)
        end = np.minimum(borders, places[-1])
        part = (end - places[cell]) * start[cell] + slope[cell] * (end**3 - places[cell] ** 3) / 3.0
        return np.asarray(np.diff(below[cell] + part) / np.diff(borders))
