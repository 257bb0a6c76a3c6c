"""The common base of media whose response to a wave of pressure depends on time, each wave by a function of its own."""

from __future__ import annotations

from typing import ClassVar, Protocol

from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.wave_constants import Wave
from winkler.media.relaxing.relaxing_medium import RelaxingLayers, RelaxingMedium
from winkler.numerics.transforms.wave_creep import WaveCreep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import OutsideValidity

__all__ = ["RelaxingByWaves"]


class RelaxingByWaves(RelaxingLayers, Protocol):
    """A stack on which no single function of time stands for all springs: subclasses state the creep of its waves."""

    in_proportion: ClassVar[bool] = False

    reason: ClassVar[str]
    """Why it is no elastic medium times a function of time, a clause."""
    alike: ClassVar[str]
    """Which medium such a function exists for, the end of a sentence that begins with "use"."""

    @property
    def glassy(self) -> CoatedHalfSpace:
        """The elastic stack that responds to a sudden step."""
        raise NotImplementedError

    @property
    def relaxed(self) -> CoatedHalfSpace:
        """The elastic stack that is left after all time."""
        raise NotImplementedError

    def pressed_waves(self, s: ComplexArray, xi: Array) -> ComplexArray:
        """Return what both surfaces answer to pressures at all s ``(S,)`` and wave numbers ``(m,)``, ``(S, m)``."""
        return self.waves(Wave.NORMAL, xi, s[:, None])

    def creep_of_waves(self, width: float, reach: float) -> WaveCreep:
        """Return how waves of line load sink after a step.

        Parameters
        ----------
        width, reach : float
            Of cells that tell the waves apart, and up to which radius they lie [m].

        Raises
        ------
        NotConverged
            If the sum of exponentials is wrong by more than 1e-5.
        """
        raise NotImplementedError

    def timeless(self) -> OutsideValidity:
        """Return the error of a call that requests a single value."""
        return OutsideValidity(
            f"{type(self).__name__}: its stiffness and its equivalent profile change in time, so no single value "
            "exists; use ViscoelasticIndentation(bed, path), CreepTest, RelaxationTest or HarmonicIndentation, or the "
            "elastic stacks `glassy`, right after a step, and `relaxed`, after all time."
        )

    @property
    def elastic(self) -> CoatedHalfSpace:
        """The stack after all time, as what pictures and notes show it."""
        return self.relaxed

    @property
    def bodies(self) -> CoatedHalfSpace:
        """The stack that names the solids."""
        return self.relaxed

    relaxation = creep = property(RelaxingMedium._changing)  # type: ignore[misc]
    gap = gap_slope = kinks = punch_facts = RelaxingMedium._changing  # type: ignore[misc]
    displacement = interior = RelaxingMedium._changing  # type: ignore[misc]
