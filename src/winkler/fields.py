r"""From the springs back to the body: pressure and displacement of the surface, stresses below it.

``restore(solution, r)`` gives the fields on the surface, ``restore(solution, r, z)`` those below it; both work on any
solution that tells how its springs are displaced.
"""

from __future__ import annotations

from typing import Protocol, overload

import numpy as np

from winkler.errors import InvalidInput
from winkler.foundation.bed import Pressed
from winkler.media.peak import greatest
from winkler.media.stress import max_shear, principal, von_mises
from winkler.numerics.types import Array, ArrayLike
from winkler.values import value

__all__ = ["PeakStress", "SubsurfaceFields", "SurfaceFields", "peak_stress", "restore"]


class Restorable(Protocol):
    """A solution whose springs are known."""

    @property
    def pressed(self) -> Pressed:
        """The displacement of the springs."""
        ...


@value
class SurfaceFields:
    """What happens on the surface, at distances r from the axis.

    Parameters
    ----------
    r : ndarray
        [m].
    pressure : ndarray
        p [Pa], compression positive, zero outside the contact; infinite at a sharp edge, kink or apex.
    displacement : ndarray
        u_z [m], of both surfaces together, into the bodies positive.
    gap : ndarray
        Distance of the deformed surfaces [m]: zero in contact; infinite beyond the reach of the profile.
    """

    r: Array
    pressure: Array
    displacement: Array
    gap: Array


@value
class SubsurfaceFields:
    """Stresses and displacements inside one body, in its own axes: r outward, z into the body.

    Parameters
    ----------
    r, z : ndarray
        Where [m]; z as it was asked for: positive in the first body, negative in the second.
    radial_stress, hoop_stress, axial_stress, shear_stress : ndarray
        [Pa], tension positive; shear in the planes that contain the axis.
    radial_displacement, axial_displacement : ndarray
        Of this body alone [m], outward and into the body positive.
    """

    r: Array
    z: Array
    radial_stress: Array
    hoop_stress: Array
    axial_stress: Array
    shear_stress: Array
    radial_displacement: Array
    axial_displacement: Array

    @property
    def von_mises(self) -> Array:
        """Equivalent stress after von Mises [Pa]."""
        return von_mises(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)

    @property
    def principal(self) -> Array:
        """Principal stresses [Pa], greatest first, along a last axis of length 3."""
        return principal(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)

    @property
    def max_shear(self) -> Array:
        """Greatest shear stress [Pa]."""
        return max_shear(self.radial_stress, self.hoop_stress, self.axial_stress, self.shear_stress)


@value
class PeakStress:
    """The greatest equivalent stress below a contact, and its place.

    Parameters
    ----------
    von_mises : float
        [Pa].
    r, z : float
        Where [m].
    """

    von_mises: float
    r: float
    z: float


@overload
def restore(solution: Restorable, r: ArrayLike) -> SurfaceFields: ...
@overload
def restore(solution: Restorable, r: ArrayLike, z: ArrayLike) -> SubsurfaceFields: ...
def restore(solution: Restorable, r: ArrayLike, z: ArrayLike | None = None) -> SurfaceFields | SubsurfaceFields:
    """Return the three-dimensional fields of a contact.

    Parameters
    ----------
    solution
        The answer to a problem, for one load.
    r : array_like
        Distances from the axis [m], not negative.
    z : array_like, optional
        Depths below the surface [m], broadcast against r: positive in the first body, negative in the second, zero
        just below the surface of the first. Without it the fields on the surface are returned.

    Returns
    -------
    SurfaceFields or SubsurfaceFields

    Raises
    ------
    InvalidInput
        If r is negative or not finite, or the solution holds many loads.
    OutsideValidity
        If the field below the surface is not known for this medium, or the body there is rigid.
    """
    radii = _checked("r", r)
    if np.any(radii < 0.0):
        raise InvalidInput(f"restore: r = {np.min(radii):.6g} m is negative; distances from the axis are positive.")
    pressed = solution.pressed
    return _surface(pressed, radii) if z is None else _below(pressed, radii, _checked("z", z))


def peak_stress(solution: Restorable, *, below: bool = True) -> PeakStress:
    """Return the greatest von Mises stress and its place.

    Parameters
    ----------
    solution
        The answer to a problem, for one load.
    below
        In the first body (z > 0) or, if False, in the second.

    Returns
    -------
    PeakStress
        Infinite at a sharp kink, edge or apex.
    """
    pressed = solution.pressed
    if pressed.radius == 0.0:
        return PeakStress(0.0, 0.0, 0.0)
    sharp = [b for b, strength in pressed.kinks if strength != 0.0]
    if sharp:
        return PeakStress(float("inf"), sharp[0], 0.0)
    sign = 1.0 if below else -1.0
    place = greatest(lambda r, z: _below(pressed, r, sign * z, below).von_mises, pressed.radius)
    return PeakStress(place.value, place.r, sign * place.z)


def _checked(word: str, given: ArrayLike) -> Array:
    try:
        numbers = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"restore: {word} is {given!r}; give a number or an array in m.") from None
    if not np.all(np.isfinite(numbers)):
        raise InvalidInput(f"restore: {word} holds values that are not finite; give finite places in m.")
    return numbers


def _surface(pressed: Pressed, r: Array) -> SurfaceFields:
    if pressed.radius == 0.0:
        still = np.zeros(r.shape)
        return SurfaceFields(r, still, still, _height(pressed, r) - min(pressed.depth, 0.0))
    medium = pressed.bed.medium
    pressure = medium.pressure(pressed, r)
    displacement = medium.displacement(pressed, r)
    separation = _height(pressed, r) - pressed.depth + displacement
    return SurfaceFields(r, pressure, displacement, np.where(r <= pressed.touching, 0.0, separation))


def _height(pressed: Pressed, r: Array) -> Array:
    """Return f(r), infinite beyond what is known of the body."""
    known = r <= pressed.bed.reach
    return np.where(known, pressed.bed.height(np.where(known, r, 0.0)), np.inf)


def _below(pressed: Pressed, r: Array, z: Array, surface_is_first: bool = True) -> SubsurfaceFields:
    r, z = np.broadcast_arrays(r, z)
    first = (z >= 0.0) if surface_is_first else (z > 0.0)
    parts = np.zeros((6, *r.shape))
    for below, chosen in ((True, first), (False, ~first)):
        if chosen.any() and pressed.radius > 0.0:
            medium = pressed.bed.medium
            parts[:, chosen] = medium.interior(pressed.blunted, r[chosen], np.abs(z[chosen]), below=below)
    return SubsurfaceFields(r, z, *parts)
