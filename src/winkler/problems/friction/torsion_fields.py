"""The three-dimensional fields of a contact that is pressed and twisted: a sum, since neither acts on the other."""

from __future__ import annotations

import numpy as np

from winkler.foundation.sheared_fields import BodyFields, body_of_pressed
from winkler.numerics.types import Array
from winkler.problems.friction.torsion_states import TorsionState
from winkler.values.value import value


@value
class TwistedFields:
    """Tractions and displacements on the surface of a twisted contact, at distances r from the axis.

    Parameters
    ----------
    r : ndarray
        [m].
    pressure : ndarray
        p [Pa], compression positive, zero outside the contact.
    traction : ndarray
        tau_theta [Pa] around the axis, positive in the direction of a positive torque.
    hoop_displacement : ndarray
        u_theta [m], of both surfaces together.
    slip : ndarray
        phi r - u_theta [m]: the relative tangential displacement of the surfaces.  Where they have touched all the
        time, how far they have slipped.
    """

    r: Array
    pressure: Array
    traction: Array
    hoop_displacement: Array
    slip: Array


def twisted_surface(state: TorsionState, r: Array) -> TwistedFields:
    """Return pressure, traction, displacement and slip at distances from the axis [m]."""
    pressed = state._pressed
    pressure = pressed.bed.medium.pressure(pressed, r) if pressed.radius > 0.0 else np.zeros(r.shape)
    displacement = state.turning(r)
    return TwistedFields(r, pressure, state.traction(r), displacement, state.angle * r - displacement)


def body_of_twisted(state: TorsionState, x: Array, y: Array, z: Array) -> BodyFields:
    """Return stresses and displacements under pressure and twist.

    Raises
    ------
    InvalidInput
        If a place lies on the surface itself.
    OutsideValidity
        If the body there is rigid, or the field of the pressure is not known.
    """
    x, y, z = np.broadcast_arrays(x, y, z)
    normal = body_of_pressed(state._pressed, x, y, z)
    if state.radius == 0.0:
        return normal
    r = np.hypot(x, y)
    twist = state.below(r, z)
    safe = np.where(r > 0.0, r, 1.0)
    c, s = np.where(r > 0.0, x / safe, 1.0), np.where(r > 0.0, y / safe, 0.0)
    across = 2.0 * c * s * twist.radial_twist_stress
    return BodyFields(
        x,
        y,
        z,
        normal.xx_stress - across,
        normal.yy_stress + across,
        normal.zz_stress,
        normal.xy_stress + (c * c - s * s) * twist.radial_twist_stress,
        normal.xz_stress - s * twist.axial_twist_stress,
        normal.yz_stress + c * twist.axial_twist_stress,
        normal.x_displacement - s * twist.hoop_displacement,
        normal.y_displacement + c * twist.hoop_displacement,
        normal.z_displacement,
    )
