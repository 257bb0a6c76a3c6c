"""Stress in a point: invariants of an axisymmetric stress state."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["max_shear", "principal", "von_mises"]


def von_mises(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the equivalent stress after von Mises [Pa], all arguments [Pa] and of one shape."""
    squares = (radial - hoop) ** 2 + (hoop - axial) ** 2 + (axial - radial) ** 2
    equivalent: Array = np.sqrt(0.5 * squares + 3.0 * shear**2)
    return equivalent


def principal(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the principal stresses [Pa], greatest first, along a new last axis of length 3."""
    middle = 0.5 * (radial + axial)
    spread = np.hypot(0.5 * (radial - axial), shear)
    return -np.sort(-np.stack([middle + spread, middle - spread, hoop], axis=-1), axis=-1)


def max_shear(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the greatest shear stress [Pa], half the difference of the outer principal stresses."""
    ordered = principal(radial, hoop, axial, shear)
    return 0.5 * (ordered[..., 0] - ordered[..., 2])
