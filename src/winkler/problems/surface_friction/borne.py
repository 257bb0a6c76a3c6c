"""What friction bears of given shear forces and torques: more would let the bodies slide or turn away."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

SLIDING_RATIO = 1.0 - 1e-7
"""Part of the friction beyond which given forces let the bodies slide: tractions that slip are not all parallel."""


def refuse_beyond(push: float, torque: float, bound: Array, arms: Array) -> None:
    """Refuse forces that friction does not bear.

    Parameters
    ----------
    push, torque : float
        Given shear force [N] and torque [N m]; zero where none is given.
    bound : ndarray
        mu p of every pixel, times its area [N].
    arms : ndarray
        Distance of every pixel from the axis of the torque [m].

    Raises
    ------
    OutsideValidity
        If one of them is as much as friction bears; the sentence names no problem.
    """
    most = float(np.sum(bound))
    if push > most * SLIDING_RATIO and push > 0.0:
        raise OutsideValidity(
            f"a shear force of {push:.6g} N is prescribed, but the friction limit is {most:.6g} N, and the bodies "
            "would slide away; give a smaller one"
        )
    borne = float(np.sum(bound * arms))
    if abs(torque) > borne * SLIDING_RATIO and torque != 0.0:
        raise OutsideValidity(
            f"a torque of {torque:.6g} N m is prescribed, but the friction limit is {borne:.6g} N m, and the "
            "bodies would turn away; give a smaller one"
        )
