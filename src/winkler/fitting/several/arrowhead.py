r"""Normal equations of many curves with shared numbers s and own numbers :math:`o_i`: an arrowhead matrix.

.. math:: \begin{pmatrix} \sum A_i & B_1 & B_2 & \dots \\ B_1^T & C_1 \\ B_2^T & & C_2 \\ \vdots & & & \ddots
          \end{pmatrix}
          \begin{pmatrix} s \\ o_1 \\ o_2 \\ \vdots \end{pmatrix}
          = \begin{pmatrix} \sum a_i \\ b_1 \\ b_2 \\ \vdots \end{pmatrix}

Own numbers are eliminated curve by curve, so that the effort grows with the number of curves, not with its cube.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class CurveBlock(NamedTuple):
    """Information and gradient of one curve.

    Parameters
    ----------
    information : ndarray, (p, p)
        Inverse covariance of all its numbers.
    gradient : ndarray, (p,)
        Information times the step that the curve alone would take.
    shared : ndarray of int, (q,)
        Where the shared numbers stand among its numbers, in their common order.
    """

    information: Array
    gradient: Array
    shared: Array

    @property
    def own(self) -> Array:
        """Where its own numbers stand."""
        return np.setdiff1d(np.arange(self.gradient.size), self.shared)


class Reduced(NamedTuple):
    """A block without its own numbers.

    Parameters
    ----------
    information, gradient : ndarray, (q, q) and (q,)
        Of the shared numbers.
    follow : ndarray, (r, q)
        Change of the own numbers by the shared ones, with the sign turned.
    rest : ndarray, (r,)
        Step of the own numbers, the shared ones held.
    own_covariance : ndarray, (r, r)
        The same, of their covariance.
    """

    information: Array
    gradient: Array
    follow: Array
    rest: Array
    own_covariance: Array


def reduced(block: CurveBlock) -> Reduced:
    """Return a block without its own numbers."""
    s, o = block.shared, block.own
    cross = block.information[np.ix_(s, o)]
    covariance = np.linalg.inv(block.information[np.ix_(o, o)]) if o.size else np.zeros((0, 0))
    follow, rest = covariance @ cross.T, covariance @ block.gradient[o]
    information = block.information[np.ix_(s, s)] - cross @ follow
    return Reduced(0.5 * (information + information.T), block.gradient[s] - cross @ rest, follow, rest, covariance)


def solved_blocks(blocks: Sequence[CurveBlock]) -> tuple[Array, list[Array], list[Array]]:
    """Return the covariance of the shared numbers, and of each curve its step ``(p,)`` and covariance ``(p, p)``."""
    parts = [reduced(block) for block in blocks]
    shared = np.linalg.inv(sum(part.information for part in parts))
    together = shared @ sum(part.gradient for part in parts)
    steps, covariances = [], []
    for block, part in zip(blocks, parts, strict=True):
        s, o = block.shared, block.own
        step = np.empty(block.gradient.size)
        step[s], step[o] = together, part.rest - part.follow @ together
        covariance = np.empty_like(block.information)
        covariance[np.ix_(s, s)] = shared
        covariance[np.ix_(s, o)] = -shared @ part.follow.T
        covariance[np.ix_(o, s)] = covariance[np.ix_(s, o)].T
        covariance[np.ix_(o, o)] = part.own_covariance + part.follow @ shared @ part.follow.T
        steps.append(step)
        covariances.append(covariance)
    return shared, steps, covariances
