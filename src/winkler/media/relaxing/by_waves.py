"""The common base of media whose response to a wave of pressure depends on time, each wave by a function of its own."""

from __future__ import annotations

from typing import ClassVar, Protocol

import numpy as np

from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.pair_response import Mode
from winkler.media.relaxing.relaxing_medium import RelaxingLayers, RelaxingMedium
from winkler.numerics.springs.rate_fit import RateFit
from winkler.numerics.transforms.wave_creep import WaveCreep
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import OutsideValidity


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
        """The elastic stack at long times."""
        raise NotImplementedError

    def loaded_waves(self, mode: Mode, s: ComplexArray, xi: Array) -> ComplexArray:
        """Return what both surfaces answer to a load at all s ``(S,)`` and wave numbers ``(m,)``, ``(S, m)``."""
        parts = [weight * self.waves(part, xi, s[:, None]) for part, weight in mode.value]
        return np.asarray(sum(parts[1:], parts[0]))

    def creep_of_waves(self, width: float, reach: float, mode: Mode = Mode.NORMAL) -> WaveCreep:
        """Return how waves of line load sink after a step, or move along where they push or twist.

        Parameters
        ----------
        width, reach : float
            Of cells that tell the waves apart, and up to which radius they lie [m].
        mode : Mode, optional
            The load.

        Raises
        ------
        NotConverged
            If the sum of exponentials is wrong by more than 1e-5.
        OutsideValidity
            If the answer to the load is not known.
        """
        raise NotImplementedError

    @property
    def rates(self) -> RateFit | None:
        """At which rates the stack answers as elastic ones do, pushed and pressed; None if no elastic one is alike."""
        return None

    def elastic_at(self, rate: float) -> CoatedHalfSpace:
        """Return the elastic stack that answers alike at one of these rates [1/s]."""
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
