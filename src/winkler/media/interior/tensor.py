"""Stress in a point without any symmetry: invariants of a full stress tensor, and its shear along the surface.

Where stresses are infinite the invariants are too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput


class Tensor(NamedTuple):
    """The components of a stress, tension positive."""

    xx: Array
    yy: Array
    zz: Array
    xy: Array
    xz: Array
    yz: Array


Measure = Callable[[Tensor], Array]
"""What is compared of a stress."""


def von_mises(stress: Tensor) -> Array:
    """Return the equivalent stress after von Mises; infinite where a component is not finite."""
    finite = np.isfinite(sum(stress[1:], stress[0]))
    xx, yy, zz, xy, xz, yz = (np.where(finite, part, 0.0) for part in stress)
    squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.where(finite, np.sqrt(0.5 * squares + 3.0 * (xy**2 + xz**2 + yz**2)), np.inf)


def principal(stress: Tensor) -> Array:
    """Return the principal stresses, greatest first, along a new last axis of length 3; nan where infinite."""
    finite = np.isfinite(sum(stress[1:], stress[0]))
    xx, yy, zz, xy, xz, yz = (np.where(finite, part, 0.0) for part in stress)
    tensor = np.stack(np.broadcast_arrays(xx, xy, xz, xy, yy, yz, xz, yz, zz), axis=-1)
    stresses = np.linalg.eigvalsh(tensor.reshape(*tensor.shape[:-1], 3, 3))[..., ::-1]
    return np.where(finite[..., None], stresses, np.nan)


def max_shear(stress: Tensor) -> Array:
    """Return the greatest shear stress, half the difference of the outermost principal stresses."""
    stresses = principal(stress)
    return np.asarray(0.5 * (stresses[..., 0] - stresses[..., 2]))


def orthogonal_shear(stress: Tensor) -> Array:
    """Return the shear stress in the plane along the surface, whatever its direction."""
    return np.hypot(stress.xz, stress.yz)


def longitudinal_shear(stress: Tensor) -> Array:
    """Return the size of the shear stress along x in the plane along the surface."""
    return np.abs(stress.xz)


def lateral_shear(stress: Tensor) -> Array:
    """Return the size of the shear stress along y in the plane along the surface."""
    return np.abs(stress.yz)


KINDS: tuple[Measure, ...] = (von_mises, max_shear, orthogonal_shear)
"""The stresses that are stated of every contact."""
MEASURES: Mapping[str, Measure] = MappingProxyType(
    {each.__name__: each for each in (von_mises, max_shear, orthogonal_shear, longitudinal_shear, lateral_shear)}
)


def measure_named(name: object, owner: str) -> Measure:
    """Return the measure of a name; refuse another name, in the words of its owner."""
    if not isinstance(name, str) or name not in MEASURES:
        raise InvalidInput(f"{owner}: there is no stress {name!r}; give one of {', '.join(MEASURES)}.")
    return MEASURES[name]
