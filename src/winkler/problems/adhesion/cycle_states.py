"""What an adhesive cycle is made of: moments, jumps and the states at the points of its path."""

from __future__ import annotations

from winkler.values.value import value, words

__all__ = ["AdhesiveJump", "AdhesiveState", "EdgeState"]


@value
class EdgeState:
    """Where machine and edge stand at one moment.

    Parameters
    ----------
    position : float
        D [m], where the far end of the machine stands; the depth itself under fixed grips and dead loads.
    depth : float
        d [m].
    force : float
        F_N [N], compression positive.
    radius : float
        a [m], zero without contact.
    """

    __words__ = words(position=("D", "m", "where the far end of the machine stands"))

    position: float
    depth: float
    force: float
    radius: float


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

    before: EdgeState
    after: EdgeState
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
class AdhesiveState(EdgeState):
    """The contact at one point of the path.

    Parameters
    ----------
    dissipation : float
        Energy lost since the beginning [J]: in jumps and by hysteresis.
    hysteresis : float
        The part of it that opening has cost more than closing gained [J].
    jumps : tuple of AdhesiveJump
        Those since the point before.
    """

    dissipation: float
    hysteresis: float
    jumps: tuple[AdhesiveJump, ...]
