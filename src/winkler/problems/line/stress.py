r"""Stresses below a line contact, pressed and rubbed: the potential F of the pressure gives all of them.

With the traction :math:`q = \mu p` along x on the surface, and z into the body,

.. math::

    \sigma_x &= \Im F + z\,\Re F' - \mu\,(2\,\Re F - z\,\Im F') , \\
    \sigma_z &= \Im F - z\,\Re F' - \mu z\,\Im F' , \\
    \tau_{xz} &= -z\,\Im F' + \mu\,(\Im F + z\,\Re F') , \qquad \sigma_y = \nu(\sigma_x+\sigma_z) .

These are Flamant's line loads summed over the strip; for a cylinder F is McEwen's closed form.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value

__all__ = ["InBody", "LineContact", "LineFields", "fields_of", "one_coefficient", "poisson_of", "stresses"]


@value
class LineFields:
    """Stresses inside one body under a line contact, in its own axes: x along the surface, y endless, z into the body.

    Parameters
    ----------
    x, z : ndarray
        Coordinates [m]; z as requested: positive in the first body, negative in the second.
    xx_stress, yy_stress, zz_stress, xz_stress : ndarray
        [Pa], tension positive.
    """

    x: Array
    z: Array
    xx_stress: Array
    yy_stress: Array
    zz_stress: Array
    xz_stress: Array

    @property
    def von_mises(self) -> Array:
        """Equivalent stress after von Mises [Pa]."""
        x, y, z = self.xx_stress, self.yy_stress, self.zz_stress
        normal = 0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2)
        return np.asarray(np.sqrt(normal + 3.0 * self.xz_stress**2))

    @property
    def max_shear(self) -> Array:
        """Maximum shear stress [Pa], half the difference of the extreme principal stresses, including that along y."""
        middle, half = (
            0.5 * (self.xx_stress + self.zz_stress),
            np.hypot(0.5 * (self.xx_stress - self.zz_stress), self.xz_stress),
        )
        return np.asarray(np.maximum(half, 0.5 * (half + np.abs(middle - self.yy_stress))))


class LineContact(NamedTuple):
    """What the stresses below one contact need.

    Parameters
    ----------
    bed
        Profile and bodies.
    half_width
        a [m].
    rim_load
        Load per length over E* that a rim bears beyond w(a) [m].
    poisson
        Of the body.
    friction
        Traction on the body along x over the pressure [-].
    pressed
        Part of the pressure that acts [-]; zero for the traction alone.
    """

    bed: LineBed
    half_width: float
    rim_load: float
    poisson: float
    friction: float
    pressed: float = 1.0


class InBody(NamedTuple):
    """What the stresses in a body need beside the potential: see `LineContact`."""

    poisson: float
    friction: float = 0.0
    pressed: float = 1.0


def one_coefficient(owner: str, friction: Any) -> float:
    """Return a coefficient of friction as given; refuse what is not one finite number."""
    number = np.asarray(friction)
    if number.ndim > 0 or number.dtype.kind not in "iuf" or not np.isfinite(number):
        raise InvalidInput(f"{owner}: friction is {friction!r:.60}; give one finite coefficient.")
    return float(number)


def poisson_of(medium: object, below: bool) -> float:
    """Return Poisson's ratio of the first body (`below`) or the second; refuse one without stresses."""
    body = getattr(medium, "first" if below else "second", None) if isinstance(medium, HalfSpace) else None
    if not isinstance(body, Elastic):
        raise OutsideValidity(
            f"The {'first body (z >= 0)' if below else 'second body (z < 0)'} is rigid or not isotropic; the stresses "
            "below a line contact are known in the isotropic bodies of a HalfSpace: request the other one."
        )
    return body.poisson


def stresses(contact: LineContact, x: Array, z: Array) -> LineFields:
    """Return the stresses at places in the axes of the body, z >= 0, of one shape."""
    x, z = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(z, dtype=float))
    away, deep = np.abs(x).ravel(), z.ravel()
    whole, slope = np.where(np.isfinite(away + deep), 0.0, np.nan) * np.zeros((2, 1), dtype=complex)
    below, surface = np.isfinite(away) & (deep > 0.0) & (deep < np.inf), np.isfinite(away) & (deep == 0.0)
    bed, a, rim_load = contact.bed, contact.half_width, contact.rim_load
    whole[below], slope[below] = bed.potential(away[below], deep[below], a, rim_load)
    whole[surface] = bed.surface_potential(away[surface], a, rim_load)
    side = np.where(x.ravel() < 0.0, -1.0, 1.0)  # F(-conj(zeta)) = -conj(F(zeta))
    whole.real *= side
    slope.imag *= side
    body = InBody(contact.poisson, contact.friction, contact.pressed)
    return fields_of(x, z, whole.reshape(x.shape), slope.reshape(x.shape), body)


def fields_of(x: Array, z: Array, whole: Array, slope: Array, body: InBody) -> LineFields:
    """Return the stresses of a potential F [Pa] with the derivative F' [Pa/m] at places z >= 0, all of one shape."""
    u, v = whole.real, whole.imag
    du, dv = z * slope.real, z * slope.imag
    mu, pressed = body.friction, body.pressed
    # without friction nothing is multiplied by zero: the stress is infinite at a rim
    dragged = mu * np.array([2.0 * u - dv, dv, v + du]) if mu != 0.0 else np.zeros((3, *u.shape))
    along = pressed * (v + du) - dragged[0]
    across = pressed * (v - du) - dragged[1]
    shear = -pressed * dv + dragged[2]
    return LineFields(x, z, along, body.poisson * (along + across), across, shear)
