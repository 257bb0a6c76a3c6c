"""What an adhesive cycle is made of: moments, jumps and the states at the points of its path."""

from __future__ import annotations

from winkler.numerics.types import PerLoad, Q
from winkler.values.value import value, words


@value
class EdgeState(PerLoad[Q]):
    """Where machine and edge stand at a moment, or at the points of a path.

    Parameters
    ----------
    position : float or ndarray, (steps,)
        D [m], where the far end of the machine stands; the depth itself under fixed grips and dead loads.
    depth : float or ndarray, (steps,)
        d [m].
    force : float or ndarray, (steps,)
        F_N [N], compression positive.
    radius : float or ndarray, (steps,)
        a [m], zero without contact.
    """

    __words__ = words(position=("D", "m", "where the far end of the machine stands"))

    position: Q
    depth: Q
    force: Q
    radius: Q


@value
class AdhesiveJump:
    """An edge that lost its hold and ran on.

    Parameters
    ----------
    before, after : EdgeState
        At the same position of the machine, or under the same dead load.
    loss : float
        By how much the total potential fell [J], what opening costs more than closing gains included.
    """

    __words__ = words(pull_off=("", None, "whether the bodies came apart in a jump"))

    before: EdgeState[float]
    after: EdgeState[float]
    loss: float

    @property
    def snap_in(self) -> bool:
        """Whether the bodies did not attract each other before."""
        return self.before.radius == 0.0 and self.before.force == 0.0

    @property
    def pull_off(self) -> bool:
        """Whether the bodies no longer attract each other."""
        return self.after.radius == 0.0 and self.after.force == 0.0


@value
class AdhesiveState(EdgeState[Q]):
    """The contact at a point of the path, or at all of them.

    Parameters
    ----------
    dissipation : float or ndarray, (steps,)
        Energy lost since the beginning [J]: in jumps and by hysteresis.
    hysteresis : float or ndarray, (steps,)
        The part of it that opening has cost more than closing gained [J].
    jumps : tuple of AdhesiveJump
        Of a point those since the point before, of the path all of them, one after the other.
    """

    dissipation: Q
    hysteresis: Q
    jumps: tuple[AdhesiveJump, ...]
