"""A height map that is pressed and sheared, at one point of its path."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.values.value import value, words


@value
class MapSlip(PerLoad[Q]):
    """A height map that is pressed and sheared, at a moment, or at the points of its path.

    Parameters
    ----------
    time : float or ndarray, (points,)
        t [s].
    depth, force : float or ndarray, (points,)
        d [m] since the highest pixel touched, F_N [N]; for a periodic map on one period.
    shift, shear_force : ndarray, (2,) or (points, 2)
        (u_x, u_y) [m] and (F_x, F_y) [N]: what drags the second body along.
    angle, torque : float or ndarray, (points,)
        phi [rad] and M_z [N m] about the middle of the map, anticlockwise positive.
    peak_pressure : float or ndarray, (points,)
        Greatest pressure [Pa].
    area, area_error : float or ndarray, (points,)
        Of the contact, and its error [m^2]; as of `SurfaceState`.
    stick_share : float or ndarray, (points,)
        Part of the contact that does not slip in the last step [-].
    stored_energy, dissipation : float or ndarray, (points,)
        Of the tractions along the surface, and lost since the beginning [J]: by friction, and inside of bodies that
        relax.
    bulk_loss : float or ndarray, (points,)
        What of it the tractions along the surface lose inside of bodies that relax [J], pressing not counted; zero of
        elastic ones.
    misfit : float or ndarray, (points,)
        Sum of mu p abs(s) - tau s with the slip s of the last step, over that of mu p abs(s) and of twice the stored
        energy.
    penetration : float or ndarray, (points,)
        Greatest overlap that the solver left, over the depth.
    """

    __words__ = words(
        shift=("u_i", "m", "sideways displacement of the bodies against each other, along x and y"),
        shear_force=("F_i", "N", "sideways force, along x and y"),
        bulk_loss=("W_b", "J", "lost inside of bodies that relax, by the tractions along the surface"),
        friction_loss=("W_f", "J", "lost by friction since the beginning"),
        stored_energy=("U_t", "J", "elastic energy of the tractions along the surface"),
        misfit=("", "", "what the solver left of the law of friction, over the energy"),
        peak_pressure=(r"p_{max}", "Pa", "greatest pressure"),
        stick_share=("A_s/A", "", "part of the contact that does not slip in the last step"),
    )

    time: Q
    depth: Q
    force: Q
    shift: Array
    shear_force: Array
    angle: Q
    torque: Q
    peak_pressure: Q
    area: Q
    area_error: Q
    stick_share: Q
    stored_energy: Q
    dissipation: Q
    bulk_loss: Q
    misfit: Q
    penetration: Q

    @property
    def friction_loss(self) -> Q:
        """Lost by friction since the beginning [J]."""
        return shaped(np.subtract(self.dissipation, self.bulk_loss))


@value
class SurfaceShearState(MapSlip[float]):
    """A height map that is pressed and sheared, at one point of its path; its numbers are those of `MapSlip`.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        p [Pa] in every pixel.
    traction : ndarray, (2, nx, ny)
        (tau_x, tau_y) [Pa], with which the second body drags the first.
    slip : ndarray, (2, nx, ny)
        How far the second body has slipped over the first since the beginning [m], where it touched.
    slip_path : ndarray, (nx, ny)
        Length of the path along which the surfaces have slipped since the beginning [m].
    slipping : ndarray of bool, (nx, ny)
        Which pixels slip in the last step.
    friction_work : ndarray, (nx, ny)
        Lost since the beginning, per area [J/m^2]; over a steady friction coefficient it is pressure times slip.
    """

    __words__ = words(
        slip_path=("s", "m", "length of the path of slip since the beginning"),
        slipping=("", None, "which pixels slip"),
        friction_work=("w", "J/m^2", "lost by friction since the beginning, per area"),
    )

    pressure: Array
    traction: Array
    slip: Array
    slip_path: Array
    slipping: Array
    friction_work: Array
