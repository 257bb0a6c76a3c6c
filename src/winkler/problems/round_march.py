"""The numbers of a round contact along a path: of one moment in a state, arrays over its points in a solution.

A solution is its state with arrays: what ``RoundSlip[float]`` is at one point, ``RoundSlip[Array]`` is along the path.
"""

from __future__ import annotations

from winkler.numerics.types import PerLoad, Q
from winkler.values.value import value, words


@value
class RoundNormal(PerLoad[Q]):
    """The normal contact at a moment, or at the points of a path.

    Parameters
    ----------
    time : float or ndarray, (steps,)
        t [s].
    depth, force, radius : float or ndarray, (steps,)
        d [m], F_N [N], just before anything sudden that happens at this time next, and a [m], zero without contact.
    """

    time: Q
    depth: Q
    force: Q
    radius: Q


@value
class RoundPress(RoundNormal[Q]):
    """A contact that is pressed.

    Parameters
    ----------
    work : float or ndarray, (steps,)
        What was spent since the beginning, the integral of F dd [J].
    stored_energy, dissipation : float or ndarray, (steps,)
        Of all springs, also of those that recover freely, and lost since the beginning, summed up over the dashpots of
        all springs [J].
    """

    __words__ = words(
        stored_energy=("U", "J", "energy stored in all springs, also in those set free"),
        work=("W", "J", "what was spent since the beginning, the integral of the force"),
    )

    work: Q
    stored_energy: Q
    dissipation: Q


@value
class RoundSlip(RoundNormal[Q]):
    """A contact that is pressed and moved along the surface.

    Parameters
    ----------
    shift, shear_force : float or ndarray, (steps,), in the plane (2,) or (steps, 2)
        u_x [m] and F_x [N]; what drags the upper body along, positive towards +x.
    work, stored_energy : float or ndarray, (steps,)
        Spent by the lateral motion since the beginning, and in the springs' displacement along the surface [J]; of
        bodies that relax in both directions.
    dissipation : float or ndarray, (steps,)
        Energy lost since the beginning [J]; of bodies that relax to friction and in their dashpots.
    """

    __words__ = words(
        work=("W", "J", "what the lateral motion, of bodies that relax all motion, has spent since the beginning"),
    )

    shift: Q
    shear_force: Q
    work: Q
    stored_energy: Q
    dissipation: Q


@value
class RoundTwist(RoundNormal[Q]):
    """A contact that is pressed and twisted.

    Parameters
    ----------
    angle, torque : float or ndarray, (steps,)
        phi [rad] and M_z [N m].
    torque_limit : float or ndarray, (steps,)
        At which everything would slide [N m].
    stick_radius : float or ndarray, (steps,)
        Of the part that is not at its bound [m].
    work, stored_energy, dissipation : float or ndarray, (steps,)
        Spent by the twist since the beginning, its elastic energy, and energy lost since the beginning [J].
    """

    __words__ = words(work=("W", "J", "what the twist has spent since the beginning"))

    angle: Q
    torque: Q
    torque_limit: Q
    stick_radius: Q
    work: Q
    stored_energy: Q
    dissipation: Q
