r"""Moduli of one kind as sums of exponentials: their logarithms, and how these change with spectrum and shifts.

With :math:`m=\sum_i e^{s_i}K(x e^{h})+e^{s_0}`, parts :math:`w_i=e^{s_i}K_i/m` and :math:`'` for
:math:`\partial/\partial\ln x`,

.. math:: \frac{\partial\ln m}{\partial s_i}=w_i,\quad \frac{\partial\ln m}{\partial h}=g=\frac{m'}{m},\quad
   \frac{\partial^2\ln m}{\partial s_i\partial s_j}=w_i\delta_{ij}-w_iw_j,\quad
   \frac{\partial^2\ln m}{\partial s_i\partial h}=w'_i-w_ig,\quad
   \frac{\partial^2\ln m}{\partial h^2}=\frac{m''}{m}-g^2.
"""

from __future__ import annotations

import enum
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class Response(enum.Enum):
    """Kinds of measured moduli."""

    STORAGE = "storage"
    LOSS = "loss"
    RELAXATION = "relaxation"


class Measurements(NamedTuple):
    """Moduli of one kind: abscissa (omega or t), index of their temperature, and modulus, each ``(n,)``."""

    response: Response
    abscissa: Array
    group: Array
    modulus: Array


class SpectrumLayout(NamedTuple):
    """Where strengths, level, shifts and factors stand, and which of them are free."""

    terms: int
    groups: int
    free: Array

    def parts(self, numbers: Array) -> tuple[Array, float, Array, Array]:
        """Return strengths, level, shifts and factors."""
        k, m = self.terms, self.groups
        return numbers[:k], float(numbers[k]), numbers[k + 1 : k + 1 + m], numbers[k + 1 + m :]


def linearised(
    measured: tuple[Measurements, ...], times: Array, layout: SpectrumLayout, numbers: Array
) -> tuple[list[Array], tuple[Array, ...]]:
    """Return derivatives of the logarithms with respect to the free numbers, and residuals, of each kind."""
    strengths, level, shifts, factors = layout.parts(numbers)
    slopes, residuals = [], []
    k, m = layout.terms, layout.groups
    for one in measured:
        kernel, growth, _ = _kernels(one.response, _places(one, times, shifts))
        parts = kernel * np.exp(strengths)
        constant = 0.0 if one.response is Response.LOSS else math.exp(level)
        model = parts.sum(axis=1) + constant
        rows = np.arange(model.size)
        slope = np.zeros((model.size, layout.free.size))
        slope[:, :k] = parts / model[:, None]
        slope[:, k] = constant / model
        slope[rows, k + 1 + one.group] = growth @ np.exp(strengths) / model
        slope[rows, k + 1 + m + one.group] = 1.0
        slopes.append(slope[:, layout.free])
        residuals.append(np.log(one.modulus) - np.log(model) - factors[one.group])
    return slopes, tuple(residuals)


def bending(
    measured: tuple[Measurements, ...], times: Array, layout: SpectrumLayout, numbers: Array, weights: tuple[Array, ...]
) -> Array:
    """Return the sum of second derivatives of the logarithms, each times its weight: a matrix of the free numbers."""
    strengths, level, shifts, _ = layout.parts(numbers)
    k, size = layout.terms, layout.free.size
    whole = np.zeros((size, size))
    for one, weight in zip(measured, weights, strict=True):
        kernel, growth, turn = _kernels(one.response, _places(one, times, shifts))
        amounts = np.exp(strengths)
        constant = 0.0 if one.response is Response.LOSS else math.exp(level)
        model = kernel @ amounts + constant
        parts = np.column_stack([kernel * amounts / model[:, None], constant / model])
        rise = growth @ amounts / model
        whole[: k + 1, : k + 1] += np.diag(weight @ parts) - (parts * weight[:, None]).T @ parts
        mixed = -parts * rise[:, None]
        mixed[:, :k] += growth * amounts / model[:, None]
        for group in np.unique(one.group):
            here = one.group == group
            row = k + 1 + group
            across = weight[here] @ mixed[here]
            whole[row, : k + 1] += across
            whole[: k + 1, row] += across
            whole[row, row] += float(weight[here] @ (turn[here] @ amounts / model[here] - rise[here] ** 2))
    return np.asarray(whole[np.ix_(layout.free, layout.free)])


def _places(one: Measurements, times: Array, shifts: Array) -> Array:
    """Return x, ``(n, k)``."""
    turn = 1.0 if one.response is not Response.RELAXATION else -1.0
    return np.asarray(np.exp(turn * np.log(one.abscissa) + shifts[one.group])[:, None] * times)


def _kernels(response: Response, x: Array) -> tuple[Array, Array, Array]:
    """Return the response of one exponential, and its first two derivatives with respect to the logarithm of x."""
    if response is Response.RELAXATION:
        kernel = np.exp(-1.0 / x)
        return kernel, kernel / x, kernel * (1.0 / x - 1.0) / x
    square = x * x
    below = 1.0 / (1.0 + square)
    if response is Response.STORAGE:
        return square * below, 2.0 * square * below**2, 4.0 * square * (1.0 - square) * below**3
    return x * below, x * (1.0 - square) * below**2, x * (1.0 - 6.0 * square + square**2) * below**3
