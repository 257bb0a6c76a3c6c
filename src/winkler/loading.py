"""Loads: what is prescribed, a force, a depth or a radius; along the surface a shift, shear force, angle or torque.

A load's value may be an array; the answer then has its shape.  Taken apart by ``match``.  How loads change with time is
a `winkler.path.Path`.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Quantity
from winkler.values import value

__all__ = ["Angle", "Depth", "Force", "Lateral", "Load", "Normal", "Radius", "ShearForce", "Shift", "Torque"]


def _check(word: str, unit: str, given: Quantity) -> None:
    try:
        numbers = np.asarray(given)
    except ValueError:  # rows of different lengths
        numbers = np.asarray(given, dtype=object)
    if numbers.dtype.kind not in "fiu":
        raise InvalidInput(f"{word}: {given!r} is not a number; give a number or an array in {unit}.")
    if numbers.size == 0:
        raise InvalidInput(f"{word}: the array is empty; give at least one value in {unit}.")
    bad = np.flatnonzero(~np.isfinite(numbers))
    if bad.size:
        where = "" if numbers.ndim == 0 else f" at index {', '.join(map(str, bad[:5]))}"
        raise InvalidInput(f"{word}: {numbers.flat[bad[0]]}{where} is not finite; give finite values in {unit}.")


@value
class Force:
    """A prescribed normal force.

    Parameters
    ----------
    force : float or ndarray
        [N], compression positive.
    """

    force: Quantity

    def __post_init__(self) -> None:
        _check("force", "N", self.force)


@value
class Depth:
    """A prescribed indentation depth: how far the bodies have approached since first touch.

    Parameters
    ----------
    depth : float or ndarray
        [m], approach positive; below zero the bodies are apart.
    """

    depth: Quantity

    def __post_init__(self) -> None:
        _check("depth", "m", self.depth)


@value
class Radius:
    """A prescribed contact radius.

    Parameters
    ----------
    radius : float or ndarray
        [m], not negative.
    """

    radius: Quantity

    def __post_init__(self) -> None:
        _check("radius", "m", self.radius)
        if np.any(np.asarray(self.radius) < 0.0):
            raise InvalidInput(f"radius: {np.min(self.radius):g} m is negative; a contact radius is zero or positive.")


@value
class Shift:
    """A prescribed sideways displacement of the bodies against each other.

    Parameters
    ----------
    shift : float or ndarray
        u_x [m]; on a path in the plane one row ``(u_x, u_y)`` for every point.
    """

    shift: Quantity

    def __post_init__(self) -> None:
        _check("shift", "m", self.shift)


@value
class ShearForce:
    """A prescribed sideways force.

    Parameters
    ----------
    shear_force : float or ndarray
        F_x [N]; on a path in the plane one row ``(F_x, F_y)`` for every point.
    """

    shear_force: Quantity

    def __post_init__(self) -> None:
        _check("shear_force", "N", self.shear_force)


@value
class Angle:
    """A prescribed twist of the bodies against each other, about the axis of the contact.

    Parameters
    ----------
    angle : float or ndarray
        phi [rad].
    """

    angle: Quantity

    def __post_init__(self) -> None:
        _check("angle", "rad", self.angle)


@value
class Torque:
    """A prescribed torque about the axis of the contact.

    Parameters
    ----------
    torque : float or ndarray
        M_z [N m].
    """

    torque: Quantity

    def __post_init__(self) -> None:
        _check("torque", "N m", self.torque)


Load = Force | Depth | Radius
"""What may be prescribed."""
Normal = Depth | Force
"""What may be prescribed across the surface, along a path."""
Lateral = Shift | ShearForce | Angle | Torque
"""What may be prescribed along the surface."""
