"""A height map that rolls: steadily under one creepage, or after some distance from rest."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.values.value import value, words

__all__ = ["SurfaceRollingStartState", "SurfaceRollingState"]


@value
class SurfaceRollingState:
    """A height map that rolls steadily towards +x, under one creepage.

    Parameters
    ----------
    depth, force : float
        d [m] and F_N [N].
    longitudinal_creepage, lateral_creepage, spin_creepage : float
        xi, eta [-] and phi [1/m], given or found.
    longitudinal_force, lateral_force : float
        F_x and F_y [N], with which the second body drags the first.
    moment : float
        M_z [N m], with which it turns it about the middle of the map.
    rolling_resistance : float
        F_r [N]: what friction loses per distance beside the work of creepages, because the pressures of dissimilar
        bodies draw the surfaces along; they then stand ahead of the middle.  Zero of similar bodies.
    stick_share : float
        Part of the contact that does not slip [-].
    misfit : float
        What the solver left of the law of friction: the sum of mu p abs(s) - tau s over that of mu p abs(w); or, if
        they are more, the distance from a given force over what friction bears, and of friction that falls the sum of
        |g - mu p| over that of mu p, with the bound g that was used.
    pressure : ndarray, (nx, ny)
        p [Pa] in every pixel.
    traction : ndarray, (2, nx, ny)
        (tau_x, tau_y) [Pa], with which the second body drags the first.
    creep : ndarray, (2, nx, ny)
        Slip of the second body over the first per distance rolled [-], where they touch.
    slipping : ndarray of bool, (nx, ny)
        Which pixels slip.
    """

    __words__ = words(
        stick_share=("A_s/A", "", "part of the contact that does not slip"),
        misfit=("", "", "what the solver left of the law of friction, over what friction would lose all slipping"),
        moment=("M_z", "N m", "moment about the normal, through the middle of the map"),
        rolling_resistance=("F_r", "N", "loss per distance beside the work of creepages, of dissimilar bodies"),
        creep=("s'", "", "slip of the second body over the first, per distance rolled"),
        slipping=("", None, "which pixels slip"),
    )

    depth: float
    force: float
    longitudinal_creepage: float
    lateral_creepage: float
    spin_creepage: float
    longitudinal_force: float
    lateral_force: float
    moment: float
    rolling_resistance: float
    stick_share: float
    misfit: float
    pressure: Array
    traction: Array
    creep: Array
    slipping: Array


@value
class SurfaceRollingStartState:
    """A height map that has begun to roll towards +x, after some distance.

    Parameters
    ----------
    distance : float
        X [m] since rest.
    longitudinal_creepage, lateral_creepage, spin_creepage : float
        xi, eta [-] and phi [1/m] of the last pixel; zero at rest.
    longitudinal_force, lateral_force, moment : float
        F_x and F_y [N], M_z [N m], as of `SurfaceRollingState`.
    stick_share : float
        Part of the contact that does not slip on the last pixel [-].
    misfit : float
        Sum of mu p abs(s) - tau s of the last pixel, over that of mu p abs(s) and of twice the stored energy.
    pressure, traction, slipping : ndarray
        As of `SurfaceRollingState`.
    """

    __words__ = words(
        stick_share=("A_s/A", "", "part of the contact that does not slip"),
        misfit=("", "", "what the solver left of the law of friction, over the energy"),
        moment=("M_z", "N m", "moment about the normal, through the middle of the map"),
        slipping=("", None, "which pixels slip"),
    )

    distance: float
    longitudinal_creepage: float
    lateral_creepage: float
    spin_creepage: float
    longitudinal_force: float
    lateral_force: float
    moment: float
    stick_share: float
    misfit: float
    pressure: Array
    traction: Array
    slipping: Array
