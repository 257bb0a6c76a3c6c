"""A height map that rolls steadily, under one creepage."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["SurfaceRollingState"]


@value
class SurfaceRollingState:
    """A height map that rolls steadily towards +x, under one creepage.

    Parameters
    ----------
    depth, force : float
        d [m] and F_N [N].
    longitudinal_force, lateral_force : float
        F_x and F_y [N], with which the second body drags the first.
    moment : float
        M_z [N m], with which it turns it about the middle of the map.
    stick_share : float
        Part of the contact that does not slip [-].
    misfit : float
        What the solver left of the law of friction: the sum of mu p |s| - tau s over that of mu p |w|.
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
        creep=("s'", "", "slip of the second body over the first, per distance rolled"),
        slipping=("", None, "which pixels slip"),
    )

    depth: float
    force: float
    longitudinal_force: float
    lateral_force: float
    moment: float
    stick_share: float
    misfit: float
    pressure: Array
    traction: Array
    creep: Array
    slipping: Array
