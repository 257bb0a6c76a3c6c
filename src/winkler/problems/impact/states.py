"""What an impact is made of: states at one moment, and the stages of sticking and sliding."""

from __future__ import annotations

from winkler.numerics.types import PerLoad, Q
from winkler.problems.adhesion.cycle_states import AdhesiveJump
from winkler.values.value import value, words


@value
class ImpactStage:
    """A stretch of time over which the edge of the contact slides to one side, or nothing slides.

    Parameters
    ----------
    start, end : float
        [s].
    side : int
        Where the body slides at the edge of the contact: 1 forwards, -1 backwards, 0 nowhere.
    """

    __words__ = words(start=("t_1", "s", "when it begins"), end=("t_2", "s", "when it ends"))

    start: float
    end: float
    side: int


@value
class ImpactHistory(PerLoad[Q]):
    """An impact at a moment, or moment by moment.

    Parameters
    ----------
    time : float or ndarray, (steps,)
        Since first touch [s]; the last one is the end of contact.
    depth, shift : float or ndarray, (steps,)
        d and u_x [m]: how far the bodies have approached, and moved along the surface, since first touch.
    velocity, sliding_velocity : float or ndarray, (steps,)
        Of approach, and of the touching points along the surface [m/s].
    force, shear_force : float or ndarray, (steps,)
        F_N and F_x [N], which press the body back and hold it up.
    radius, stick_radius : float or ndarray, (steps,)
        Of the contact, and of the part of it that sticks [m].
    energy, stored_energy : float or ndarray, (steps,)
        Elastic energy of the normal and of the tangential displacement [J].
    dissipation : float or ndarray, (steps,)
        Energy lost since first touch [J].
    """

    time: Q
    depth: Q
    shift: Q
    velocity: Q
    sliding_velocity: Q
    force: Q
    shear_force: Q
    radius: Q
    stick_radius: Q
    energy: Q
    stored_energy: Q
    dissipation: Q


@value
class ImpactState(ImpactHistory[float]):
    """An impact at one moment; its numbers are those of `ImpactHistory`.

    Parameters
    ----------
    side : int
        Where the body slides at the edge of the contact: 1 forwards, -1 backwards, 0 nowhere.
    stages : tuple of ImpactStage
        Those that have begun since the moment before.
    duration : float
        How long the bodies will have touched [s].
    """

    side: int
    stages: tuple[ImpactStage, ...]
    duration: float


@value
class AdhesiveImpactHistory(PerLoad[Q]):
    """An impact of a sticky body at a moment, or moment by moment.

    Parameters
    ----------
    time : float or ndarray, (steps,)
        Since first touch [s]; the last one is when the bodies part, or stand still during the rebound.
    depth : float or ndarray, (steps,)
        d [m].
    velocity : float or ndarray, (steps,)
        Of approach [m/s].
    force : float or ndarray, (steps,)
        F_N [N], compression positive.
    radius : float or ndarray, (steps,)
        a [m].
    energy : float or ndarray, (steps,)
        Of bodies and surfaces, less what closing has gained [J]; zero apart.
    dissipation : float or ndarray, (steps,)
        Energy lost since first touch [J], in jumps and by hysteresis.
    """

    __words__ = words(energy=("U", "J", "energy of bodies and surfaces, less what closing has gained"))

    time: Q
    depth: Q
    velocity: Q
    force: Q
    radius: Q
    energy: Q
    dissipation: Q


@value
class AdhesiveImpactState(AdhesiveImpactHistory[float]):
    """An impact of a sticky body at one moment; its numbers are those of `AdhesiveImpactHistory`.

    Parameters
    ----------
    jumps : tuple of AdhesiveJump
        Those since the moment before.
    duration : float
        How long the bodies will have touched [s].
    captured : bool
        Whether the body will stay.
    """

    jumps: tuple[AdhesiveJump, ...]
    duration: float
    captured: bool
