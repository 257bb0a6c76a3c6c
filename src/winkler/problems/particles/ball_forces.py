r"""Forces of one contact of two balls: the formulas, for numbers and arrays alike, and as kernels.

.. math:: F_N = \tfrac43 E^*\sqrt R\,d^{3/2}, \qquad a=\sqrt{Rd}
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.jit import compiled

TWIST_SHARE = 3.0 * math.pi / 16.0
"""Moment of a sliding twist over mu F a."""


def ball_radius(curvature_radius: Any, pressed: Any) -> Any:
    """Return a [m] at depths [m], not negative."""
    return np.sqrt(curvature_radius * pressed)


def ball_force(modulus: Any, curvature_radius: Any, pressed: Any) -> Any:
    """Return F_N [N] at depths [m], not negative."""
    return 4.0 / 3.0 * modulus * np.sqrt(curvature_radius) * (pressed * np.sqrt(pressed))


def twisting_stiffness(torsional_modulus: Any, radius: Any) -> Any:
    """Return the stiffness against a twist [N m]."""
    return 16.0 / 3.0 * torsional_modulus * (radius * radius * radius)


def tilting_stiffness(modulus: Any, radius: Any) -> Any:
    """Return the stiffness against rolling [N m]."""
    return 4.0 / 3.0 * modulus * (radius * radius * radius)


def twisting_bound(coefficient: Any, force: Any, radius: Any) -> Any:
    """Return the moment of a sliding twist [N m]."""
    return TWIST_SHARE * coefficient * force * radius


radius_of_ball = compiled(ball_radius)
force_of_ball = compiled(ball_force)
twisting_of_ball = compiled(twisting_stiffness)
tilting_of_ball = compiled(tilting_stiffness)
bound_of_twist = compiled(twisting_bound)
