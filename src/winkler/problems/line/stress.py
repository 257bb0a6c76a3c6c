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
from winkler.media.offers import PowerOfDepth, offers
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value


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


class Strip(NamedTuple):
    """A contact from -a to a.

    Parameters
    ----------
    half_width
        a [m].
    edge_load
        Load per length over E* that the edge bears beyond w(a) [m]; negative where it pulls.
    """

    half_width: float
    edge_load: float


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
    """

    bed: LineBed
    half_width: float
    rim_load: float
    poisson: float
    friction: float


def one_coefficient(owner: str, friction: Any) -> float:
    """Return a coefficient of friction as given; refuse what is not one finite number."""
    number = np.asarray(friction)
    if number.ndim > 0 or number.dtype.kind not in "iuf" or not np.isfinite(number):
        raise InvalidInput(f"{owner}: friction is {friction!r:.60}; give one finite coefficient.")
    return float(number)


def poisson_of(medium: object, below: bool) -> float:
    """Return Poisson's ratio of the first body (`below`) or the second; refuse one without stresses."""
    if offers(medium, PowerOfDepth):
        raise OutsideValidity(
            "The stresses inside a GradedHalfSpace are not implemented; request the surface, or sample the "
            "grading by the layers of a CoatedHalfSpace."
        )
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
    pressed, mu = potential_of(contact.bed, Strip(contact.half_width, contact.rim_load), x, z), contact.friction
    return fields_of(x, z, pressed, contact.poisson, mu * pressed if mu != 0.0 else None)


def potential_of(bed: LineBed, strip: Strip, x: Array, z: Array) -> ComplexArray:
    """Return F and z F' [Pa] of the pressure of a strip at places z >= 0, ``(2, ...)``."""
    away, deep = np.abs(x).ravel(), z.ravel()
    found = np.where(np.isfinite(away + deep), 0.0, np.nan) * np.zeros((2, 1), dtype=complex)
    below, surface = np.isfinite(away) & (deep > 0.0) & (deep < np.inf), np.isfinite(away) & (deep == 0.0)
    found[0, below], slope = bed.potential(away[below], deep[below], *strip)
    found[1, below] = deep[below] * slope
    if surface.any():
        found[0, surface] = bed.surface_potential(away[surface], *strip)
    side = np.where(x.ravel() < 0.0, -1.0, 1.0)  # F(-conj(zeta)) = -conj(F(zeta))
    found[0].real *= side
    found[1].imag *= side
    return found.reshape(2, *x.shape)


def fields_of(
    x: Array, z: Array, pressed: ComplexArray, poisson: float, dragged: ComplexArray | None = None, bulk: float = 0.0
) -> LineFields:
    """Return the stresses in a body under a pressure and a traction, all at places of one shape.

    Parameters
    ----------
    x, z : ndarray
        [m].
    pressed : ndarray, (2, ...)
        F and z F' of the pressure [Pa].
    poisson : float
    dragged : ndarray, (2, ...), optional
        The same of the traction on the body along x; none where there is no traction, as zero times an infinite
        pressure at a rim.
    bulk : float
        Stress along x far from the contact [Pa].
    """
    p, dp = pressed
    along, across, shear = p.imag + dp.real + bulk, p.imag - dp.real, -dp.imag
    if dragged is not None:
        q, dq = dragged
        along, across, shear = along - (2.0 * q.real - dq.imag), across - dq.imag, shear + q.imag + dq.real
    return LineFields(x, z, along, poisson * (along + across), across, shear)
