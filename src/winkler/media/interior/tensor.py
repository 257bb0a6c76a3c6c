"""Stress in a point without any symmetry: invariants of a full stress tensor.

Where stresses are infinite the invariants are too.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["principal_of_tensor", "von_mises_of_tensor"]


def von_mises_of_tensor(xx: Array, yy: Array, zz: Array, xy: Array, xz: Array, yz: Array) -> Array:
    """Return the equivalent stress after von Mises [Pa], all arguments [Pa] and of one shape."""
    finite = np.isfinite(xx + yy + zz + xy + xz + yz)
    xx, yy, zz, xy, xz, yz = (np.where(finite, part, 0.0) for part in (xx, yy, zz, xy, xz, yz))
    squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.where(finite, np.sqrt(0.5 * squares + 3.0 * (xy**2 + xz**2 + yz**2)), np.inf)


def principal_of_tensor(xx: Array, yy: Array, zz: Array, xy: Array, xz: Array, yz: Array) -> Array:
    """Return the principal stresses [Pa], greatest first, along a new last axis of length 3; nan where infinite."""
    finite = np.isfinite(xx + yy + zz + xy + xz + yz)
    parts = [np.where(finite, part, 0.0) for part in (xx, xy, xz, xy, yy, yz, xz, yz, zz)]
    tensor = np.stack(np.broadcast_arrays(*parts), axis=-1)
    stresses = np.linalg.eigvalsh(tensor.reshape(*tensor.shape[:-1], 3, 3))[..., ::-1]
    return np.where(finite[..., None], stresses, np.nan)
