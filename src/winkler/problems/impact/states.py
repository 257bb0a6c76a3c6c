"""What an impact is made of: states at one moment, and the stages of sticking and sliding."""

from __future__ import annotations

from winkler.problems.adhesion.cycle_states import AdhesiveJump
from winkler.values import value, words

__all__ = ["AdhesiveImpactState", "ImpactStage", "ImpactState"]


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
class ImpactState:
    """An impact at one moment.

    Parameters
    ----------
    time : float
        Since first touch [s].
    depth, shift, velocity, sliding_velocity, force, shear_force, radius, stick_radius : float
        As in `winkler.problems.impact.impact.ImpactSolution`.
    energy, stored_energy, dissipation : float
        As there.
    side : int
        Where the body slides at the edge of the contact: 1 forwards, -1 backwards, 0 nowhere.
    stages : tuple of ImpactStage
        Those that have begun since the moment before.
    duration : float
        How long the bodies will have touched [s].
    """

    time: float
    depth: float
    shift: float
    velocity: float
    sliding_velocity: float
    force: float
    shear_force: float
    radius: float
    stick_radius: float
    energy: float
    stored_energy: float
    dissipation: float
    side: int
    stages: tuple[ImpactStage, ...]
    duration: float


@value
class AdhesiveImpactState:
    """An impact of a sticky body at one moment.

    Parameters
    ----------
    time : float
        Since first touch [s].
    depth, velocity, force, radius, energy, dissipation : float
        As in `winkler.problems.impact.adhesive_impact.AdhesiveImpactSolution`.
    jumps : tuple of AdhesiveJump
        Those since the moment before.
    duration : float
        How long the bodies will have touched [s].
    captured : bool
        Whether the body will stay.
    """

    __words__ = words(energy=("U", "J", "energy of bodies and surfaces, less what closing has gained"))

    time: float
    depth: float
    velocity: float
    force: float
    radius: float
    energy: float
    dissipation: float
    jumps: tuple[AdhesiveJump, ...]
    duration: float
    captured: bool
