"""Stress in a point: invariants of an axisymmetric stress state.

At a sharp edge, a kink or the tip of a cone the elastic stresses are infinite; the invariants then are too.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array


def _finite(*components: Array) -> tuple[Array, list[Array]]:
    """Return where all components are finite, and the components with zeros elsewhere."""
    finite = np.logical_and.reduce([np.isfinite(part) for part in components])
    return finite, [np.where(finite, part, 0.0) for part in components]


def von_mises(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the equivalent stress after von Mises [Pa], all arguments [Pa] and of one shape."""
    finite, (s_r, s_t, s_z, tau) = _finite(radial, hoop, axial, shear)
    squares = (s_r - s_t) ** 2 + (s_t - s_z) ** 2 + (s_z - s_r) ** 2
    return np.where(finite, np.sqrt(0.5 * squares + 3.0 * tau**2), np.inf)


def principal(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the principal stresses [Pa], greatest first, along a new last axis of length 3."""
    finite, (s_r, s_t, s_z, tau) = _finite(radial, hoop, axial, shear)
    middle = 0.5 * (s_r + s_z)
    spread = np.hypot(0.5 * (s_r - s_z), tau)
    regular = np.stack([middle + spread, middle - spread, s_t], axis=-1)
    # where stresses are infinite there is no shear: the components themselves are principal
    singular = np.stack(np.broadcast_arrays(radial, axial, hoop), axis=-1)
    return -np.sort(-np.where(finite[..., None], regular, singular), axis=-1)


def max_shear(radial: Array, hoop: Array, axial: Array, shear: Array) -> Array:
    """Return the greatest shear stress [Pa], half the difference of the outer principal stresses."""
    finite, components = _finite(radial, hoop, axial, shear)
    ordered = principal(*components)
    return np.where(finite, 0.5 * (ordered[..., 0] - ordered[..., 2]), np.inf)
