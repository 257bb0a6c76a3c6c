"""A height map that rolls: steadily under one creepage or under many, or from rest on."""

from __future__ import annotations

from winkler.numerics.types import Array, PerLoad, Q
from winkler.values.value import value, words


@value
class MapRolling(PerLoad[Q]):
    """A height map that rolls steadily towards +x, under a creepage or force, or under many.

    Parameters
    ----------
    longitudinal_creepage, lateral_creepage, spin_creepage : float or ndarray
        xi, eta [-] and phi [1/m], given or found.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N], with which the second body drags the first.
    depth, force : float or ndarray
        d [m] and F_N [N].
    moment : float or ndarray
        M_z [N m], with which it turns it about the middle of the map.
    rolling_resistance : float or ndarray
        F_r [N]: what friction loses per distance beside the work of creepages, because the pressures of dissimilar
        bodies draw the surfaces along; they then stand ahead of the middle.  Zero of similar bodies.
    stick_share : float or ndarray
        Part of the contact that does not slip [-].
    misfit : float or ndarray
        What the solver left of the law of friction: the sum of mu p abs(s) - tau s over that of mu p abs(w); or, if
        they are more, the distance from a given force over what friction bears, and of friction that falls the sum of
        abs(g - mu p) over that of mu p, with the bound g that was used.
    """

    __words__ = words(
        stick_share=("A_s/A", "", "part of the contact that does not slip"),
        misfit=("", "", "what the solver left of the law of friction, over what friction would lose all slipping"),
        moment=("M_z", "N m", "moment about the normal, through the middle of the map"),
        rolling_resistance=("F_r", "N", "loss per distance beside the work of creepages, of dissimilar bodies"),
    )

    longitudinal_creepage: Q
    lateral_creepage: Q
    spin_creepage: Q
    longitudinal_force: Q
    lateral_force: Q
    depth: Q
    force: Q
    moment: Q
    rolling_resistance: Q
    stick_share: Q
    misfit: Q


@value
class SurfaceRollingState(MapRolling[float]):
    """A height map that rolls steadily under one creepage or force; its numbers are those of `MapRolling`.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        p [Pa] in every pixel.
    traction : ndarray, (2, nx, ny)
        (tau_x, tau_y) [Pa], with which the second body drags the first.
    creep : ndarray, (2, nx, ny)
        Slip of the second body over the first per distance rolled [-], where they touch.
    slipping : ndarray of bool, (nx, ny)
        Whether the pixel slips.
    """

    __words__ = words(
        creep=("s'", "", "slip of the second body over the first, per distance rolled"),
        slipping=("", None, "which pixels slip"),
    )

    pressure: Array
    traction: Array
    creep: Array
    slipping: Array


@value
class MapRollingStart(PerLoad[Q]):
    """A height map that has begun to roll towards +x, after some distance, or all along it.

    Parameters
    ----------
    distance : float or ndarray, (points,)
        X [m] since rest.
    longitudinal_creepage, lateral_creepage, spin_creepage : float or ndarray, (points,)
        xi, eta [-] and phi [1/m] of the last pixel; zero at rest.
    longitudinal_force, lateral_force, moment : float or ndarray, (points,)
        F_x and F_y [N], M_z [N m], as of `MapRolling`.
    stick_share : float or ndarray, (points,)
        Part of the contact that does not slip on the last pixel [-].
    misfit : float or ndarray, (points,)
        Sum of mu p abs(s) - tau s of the last pixel, over that of mu p abs(s) and of twice the stored energy.
    """

    __words__ = words(
        stick_share=("A_s/A", "", "part of the contact that does not slip"),
        misfit=("", "", "what the solver left of the law of friction, over the energy"),
        moment=("M_z", "N m", "moment about the normal, through the middle of the map"),
    )

    distance: Q
    longitudinal_creepage: Q
    lateral_creepage: Q
    spin_creepage: Q
    longitudinal_force: Q
    lateral_force: Q
    moment: Q
    stick_share: Q
    misfit: Q


@value
class SurfaceRollingStartState(MapRollingStart[float]):
    """A height map that has begun to roll, after some distance; its numbers are those of `MapRollingStart`.

    Parameters
    ----------
    pressure, traction, slipping : ndarray
        As of `SurfaceRollingState`.
    """

    __words__ = words(slipping=("", None, "which pixels slip"))

    pressure: Array
    traction: Array
    slipping: Array
