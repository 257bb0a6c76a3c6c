r"""Laws of the first part of a loading: a power of the depth, or the area function of a known tip.

Without the tip, :math:`F = K x^n` with the depth :math:`x` since first touch.  With it, the depth is that of the
contact and its elastic rim,

.. math:: x = h_c + \kappa\sqrt{A(h_c)}, \qquad F = K\,A(h_c)\,h_c^{\,q},

so that a blunt tip changes the exponent as it does: :math:`\kappa = \epsilon\sqrt\pi H/(2E_r)`, and q is the change of
the hardness with depth, negative for a size effect and positive where the first contact is elastic.

Calibrated coefficients of both signs may give an area that falls or is negative close to the apex.  Below the depth
from which on :math:`A\sim h^m` with m from 1 (a ball) to 2 (a cone), that power takes its place.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["TouchByArea", "TouchByPower", "TouchLaw"]

NODES = 400
BALL, CONE = 1.0, 2.0
"""Exponents of their sections over the depth."""
SMALLEST = 1e-9
"""Least depth since touch, in parts of the fitted range: derivatives stay finite."""


class TouchByPower(NamedTuple):
    """f = x^n; 1 for plastic contact of a ball, 3/2 for an elastic one, 2 for a pyramid."""

    means: tuple[float, ...] = (1.6,)
    spreads: tuple[float, ...] = (0.25,)
    limits: tuple[tuple[float, float], ...] = ((1.0, 2.6),)
    starts: tuple[tuple[float, ...], ...] = ((1.0,), (1.35,), (1.7,), (2.05,), (2.4,))

    def course(self, gap: Array, numbers: Array) -> tuple[Array, Array, Array]:
        """Return f, df/dx and the derivative by the exponent."""
        gap = np.maximum(gap, SMALLEST)
        power = gap ** numbers[0]
        return power, numbers[0] * power / gap, (power * np.log(gap))[None, :]


POWER_SPREAD = 0.25
"""Standard deviation of q."""
RIM_SPREAD = 0.3
"""Standard deviation of kappa in parts of it: the hardness at first touch is not that at the peaks."""


class TouchByArea(NamedTuple):
    """f = A(h_c) h_c^q with x = h_c + kappa sqrt(A), by the coefficients of A for depths in parts of the range.

    Parameters
    ----------
    coefficients : ndarray, (m,)
    apex : tuple of float
        Depth below which A is a power, and its exponent; zero depth where A grows from the apex on.
    means, spreads, limits, starts
        Of q and kappa, as of a `TouchByPower`.
    """

    coefficients: Array
    apex: tuple[float, float]
    means: tuple[float, ...]
    spreads: tuple[float, ...]
    limits: tuple[tuple[float, float], ...]
    starts: tuple[tuple[float, ...], ...]

    @staticmethod
    def of(coefficients: Array, rim: float) -> TouchByArea:
        """Return the law of a tip on a sample whose kappa is known from its unloadings."""
        limits, starts = ((-0.6, 0.8), (0.0, 4.0 * rim)), ((0.0, rim), (-0.4, rim))
        apex, spreads = apex_of(coefficients), (POWER_SPREAD, RIM_SPREAD * rim)
        return TouchByArea(coefficients, apex, (0.0, rim), spreads, limits, starts)

    def course(self, gap: Array, numbers: Array) -> tuple[Array, Array, Array]:
        """Return f, df/dx and the derivatives by q and kappa."""
        power, rim = float(numbers[0]), float(numbers[1])
        nodes = np.linspace(0.0, math.sqrt(max(float(gap.max()), SMALLEST)), NODES) ** 2
        reached = nodes + rim * np.sqrt(self._area(nodes)[0])
        height = np.maximum(np.interp(gap, reached, nodes), SMALLEST)
        for _ in range(2):  # the nodes are close enough for two steps of Newton
            size, slope = self._area(height)
            excess = height + rim * np.sqrt(size) - np.maximum(gap, SMALLEST)
            height = np.maximum(height - excess / (1.0 + 0.5 * rim * slope / np.sqrt(size)), 0.1 * height)
        size, slope = self._area(height)
        law = size * height**power
        by_height = law * (slope / size + power / height)
        by_gap = by_height / (1.0 + 0.5 * rim * slope / np.sqrt(size))
        return law, by_gap, np.stack([law * np.log(height), -by_gap * np.sqrt(size)])

    def _area(self, height: Array) -> tuple[Array, Array]:
        """Return A and dA/dh at depths."""
        end, exponent = self.apex
        deep = np.maximum(height, max(end, SMALLEST))
        size, slope = _polynomial(self.coefficients, deep)
        below, share = height < end, height / deep
        power = size * share**exponent
        return np.where(below, power, size), np.where(below, exponent * size * share ** (exponent - 1.0) / deep, slope)


def apex_of(coefficients: Array) -> tuple[float, float]:
    """Return the depth, in parts of the range, below which an area is a power of the depth, and its exponent.

    The depth is zero where the area is positive and grows from the apex on, and one where it grows nowhere.

    Examples
    --------
    >>> apex_of(np.array([24.5, 1.0]))
    (0.0, 1.0)
    """
    depths = np.geomspace(SMALLEST, 1.0, NODES)
    size, slope = _polynomial(coefficients, depths)
    wrong = (size <= 0.0) | (slope <= 0.0)
    if not np.any(wrong):
        return 0.0, BALL
    exponent = np.where(wrong, 0.0, depths * slope / np.where(wrong, 1.0, size))
    inside = (exponent >= BALL) & (exponent <= CONE)
    inside[: int(np.flatnonzero(wrong)[-1])] = False
    place = int(np.argmax(inside)) if np.any(inside) else NODES - 1
    return float(depths[place]), float(np.clip(exponent[place], BALL, CONE))


def _polynomial(coefficients: Array, height: Array) -> tuple[Array, Array]:
    exponents = 2.0 ** (1.0 - np.arange(coefficients.size))
    parts = coefficients[:, None] * height[None, :] ** exponents[:, None]
    return np.asarray(parts.sum(axis=0)), np.asarray((exponents[:, None] * parts).sum(axis=0) / height)


TouchLaw = TouchByPower | TouchByArea
"""A law F = K f(x) with further numbers, all in parts of the fitted range and its greatest force."""
