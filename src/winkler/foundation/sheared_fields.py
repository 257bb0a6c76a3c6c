"""The three-dimensional fields of a sheared contact: on the surface, and inside its bodies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared import ShearedSprings
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import shear_field, tensor
from winkler.media.medium import Displacement, rigid_body
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity
from winkler.values.value import value


@value
class ShearedFields:
    """Traction, slip and shift of the surface of a sheared contact at distances r from the axis.

    Parameters
    ----------
    r : ndarray
        [m].
    pressure : ndarray
        p [Pa], compression positive, zero outside the contact.
    traction : ndarray, (...) or (..., 2)
        tau [Pa] on the first body along x, in planar motion ``(tau_x, tau_y)``.
    tangential_displacement : ndarray, of the shape of the traction
        u_x [m], sum over both surfaces, averaged over the circle with radius r; positive along the traction.
    slip : ndarray, of the shape of the traction
        U - u_x [m], averaged over the circle: the relative tangential displacement of the surfaces.  Where they have
        touched all the time, how far they have slipped.
    """

    r: Array
    pressure: Array
    traction: Array
    tangential_displacement: Array
    slip: Array


@value
class BodyFields:
    """Stresses and displacements inside one body, in its own axes: x, y along the surface, z into the body.

    Parameters
    ----------
    x, y, z : ndarray
        Coordinates [m]; z as requested: positive in the first body, negative in the second.
    xx_stress, yy_stress, zz_stress, xy_stress, xz_stress, yz_stress : ndarray
        [Pa], tension positive.
    x_displacement, y_displacement, z_displacement : ndarray
        Of this body alone [m].
    """

    x: Array
    y: Array
    z: Array
    xx_stress: Array
    yy_stress: Array
    zz_stress: Array
    xy_stress: Array
    xz_stress: Array
    yz_stress: Array
    x_displacement: Array
    y_displacement: Array
    z_displacement: Array

    @property
    def _stress(self) -> tensor.Tensor:
        parts = self.xx_stress, self.yy_stress, self.zz_stress, self.xy_stress, self.xz_stress, self.yz_stress
        return tensor.Tensor(*parts)

    @property
    def von_mises(self) -> Array:
        """Equivalent stress after von Mises [Pa]."""
        return tensor.von_mises(self._stress)

    @property
    def principal(self) -> Array:
        """Principal stresses [Pa], largest first, along a last axis of length 3; nan where they are infinite."""
        return tensor.principal(self._stress)

    @property
    def max_shear(self) -> Array:
        """Maximum shear stress [Pa], half the spread of the principal stresses; nan where they are infinite."""
        return tensor.max_shear(self._stress)


def sheared_surface(sheared: ShearedSprings, r: Array) -> ShearedFields:
    """Return pressure, traction, displacement and slip at distances from the axis [m]."""
    pressed, medium = sheared.pressed, sheared.pressed.bed.medium
    still = np.zeros(r.shape)
    tractions, moved = [], []
    for parts in sheared.components:
        tractions.append(sum((sheared.mindlin_ratio * medium.pressure(part, r) for part in parts), still))
        moved.append(sum((medium.displacement(part, r) for part in parts), still))
    shifts = np.atleast_1d(np.asarray(sheared.shift, dtype=float))
    slips = [shift - part for shift, part in zip(shifts, moved, strict=True)]
    pressure = medium.pressure(pressed, r) if pressed.radius > 0.0 else still

    def together(components: list[Array]) -> Array:
        return np.stack(components, axis=-1) if sheared.in_plane else components[0]

    return ShearedFields(r, pressure, together(tractions), together(moved), together(slips))


def shift_of_surface(sheared: ShearedSprings, x: Array, y: Array) -> Array:
    """Return the displacement along the surface at places [m], of both surfaces together, ``(..., 2)`` [m].

    Raises
    ------
    OutsideValidity
        If the medium is not a `HalfSpace`.
    """
    medium = _half_space(sheared.pressed)
    r, angle = np.hypot(x, y), np.arctan2(y, x)
    total = np.zeros((*r.shape, 2))
    for axis, parts in enumerate(sheared.components):
        in_axes = angle - 0.5 * np.pi * axis
        for part in parts:
            mean = medium.displacement(part, r)
            swerve = np.zeros(r.shape)
            for body in (medium.first, medium.second):
                if isinstance(body, Elastic):
                    swerve = swerve + shear_field.angular_shift(
                        part, r, modulus=medium.shear_modulus, poisson=body.poisson, shear=body.shear
                    )
            along, across = mean + swerve * np.cos(2.0 * in_axes), swerve * np.sin(2.0 * in_axes)
            total[..., axis] += along
            total[..., 1 - axis] += across if axis == 0 else -across
    return total


def body_of_pressed(pressed: PressedSprings, x: Array, y: Array, z: Array) -> BodyFields:
    """Return stresses and displacements under a pressure alone; z > 0 in the first body, z < 0 in the second."""
    return _fields(x, y, z, lambda *place, below: _pressed(pressed, *place, below=below))


def body_under(pressed: PressedSprings, dragged: Callable[..., Array], x: Array, y: Array, z: Array) -> BodyFields:
    """Return stresses and displacements under a pressure and what acts along the surface.

    Parameters
    ----------
    pressed : PressedSprings
    dragged : callable
        Takes x, y and the depth z >= 0 inside a body [m], and ``below``: whether that is the first one.  Returns what
        the traction adds in the order of `BodyFields`, ``(9, n)``.
    x, y, z : ndarray
        [m]; z > 0 in the first body, z < 0 in the second.
    """
    return _fields(x, y, z, lambda *at, below: _pressed(pressed, *at, below=below) + dragged(*at, below=below))


def body_of_sheared(sheared: ShearedSprings, x: Array, y: Array, z: Array) -> BodyFields:
    """Return stresses and displacements under pressure and traction.

    Raises
    ------
    OutsideValidity
        If the medium is not a `HalfSpace`, or the body there is rigid.
    """
    return body_under(sheared.pressed, lambda *at, below: _dragged(sheared, *at, below=below), x, y, z)


def _fields(x: Array, y: Array, z: Array, parts: Callable[..., Array]) -> BodyFields:
    x, y, z = np.broadcast_arrays(x, y, z)
    total = np.zeros((9, *x.shape))
    for below, chosen in ((True, z >= 0.0), (False, z < 0.0)):
        if chosen.any():
            total[:, chosen] = parts(x[chosen], y[chosen], np.abs(z[chosen]), below=below)
    return BodyFields(x, y, z, *total)


def _pressed(pressed: PressedSprings, x: Array, y: Array, z: Array, *, below: bool) -> Array:
    """Return the rows of `BodyFields` under the pressure."""
    if pressed.radius == 0.0:
        return np.zeros((9, x.size))
    r = np.hypot(x, y)
    field = pressed.bed.medium.interior(pressed.blunted, r, z, below=below)
    axis = r == 0.0
    safe = np.where(axis, 1.0, r)
    c, s = np.where(axis, 1.0, x / safe), np.where(axis, 0.0, y / safe)
    with np.errstate(invalid="ignore"):  # stresses are infinite at an edge
        spread = np.where(axis, 0.0, field.radial_stress - field.hoop_stress)
        mean = field.hoop_stress
        rows = [
            mean + c * c * spread,
            mean + s * s * spread,
            field.axial_stress,
            c * s * spread,
            c * field.shear_stress,
            s * field.shear_stress,
            c * field.radial_displacement,
            s * field.radial_displacement,
            field.axial_displacement,
        ]
    return np.array(rows)


def _dragged(sheared: ShearedSprings, x: Array, y: Array, z: Array, *, below: bool) -> Array:
    """Return the rows of `BodyFields` under the traction; on the second body it acts in the opposite direction."""
    medium = _half_space(sheared.pressed)
    body, sign = (medium.first, 1.0) if below else (medium.second, -1.0)
    if not isinstance(body, Elastic):
        raise rigid_body(below)

    def field(part: Displacement, along: Array, across: Array) -> Array:
        with np.errstate(invalid="ignore"):  # stresses are infinite at an edge
            rows = shear_field.field(
                part, along, across, z, modulus=medium.shear_modulus, poisson=body.poisson, shear=body.shear
            )
        return sign * np.array(rows)

    total = np.zeros((9, x.size))
    for axis, parts in enumerate(sheared.components):
        for part in parts:
            if axis == 0:
                total += field(part, x, y)
            else:  # along y: the same field, in axes rotated by a right angle
                xx, yy, zz, xy, xz, yz, u, v, w = field(part, y, -x)
                total += [yy, xx, zz, -xy, -yz, xz, -v, u, w]
    return total


def _half_space(pressed: PressedSprings) -> HalfSpace:
    medium = pressed.bed.medium
    if not isinstance(medium, HalfSpace):
        raise OutsideValidity(
            f"The fields of a traction inside a {type(medium).__name__} are not implemented; request the surface "
            "(restore(solution, r)), or use HalfSpace."
        )
    return medium
