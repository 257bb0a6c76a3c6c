r"""An attracted surface followed from displacement to displacement, with its jumps and the balance of its energies.

Between jumps the machine's work is stored, :math:`\mathrm dE = F\,\mathrm dd`.  Over a step, the trapezoid of the force
less the change of the energy tells whether there was a jump: then the step is halved until the jump lies between two
displacements close to each other, and what is lacking is what was lost.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.attracted.attracted_surface import AttractedSurface, Rest

JUMP_RATIO = 0.02
"""Energy that is lacking, over force times step, above which a step is halved."""
SMALLEST_RATIO = 1e-4
"""Losses below this part of the greatest energy are no jumps, but the grid."""
MOST_HALVINGS = 3
"""How often a step is halved to find a jump in it."""


class RestStage(NamedTuple):
    """A displacement in ranges, the surface at rest there, and the sum of its tractions."""

    depth: float
    rest: Rest
    force: float


class Leapt(NamedTuple):
    """A jump: the stages around it, and what was lost."""

    before: RestStage
    after: RestStage
    loss: float


class AdhesionMarch:
    """A march through displacements.

    Parameters
    ----------
    attracted : AttractedSurface
    tolerance : float
        Of the balance of tractions.
    depth : float
        First displacement, in ranges; bodies are brought there from apart.

    Raises
    ------
    NotConverged
        If no state of rest is found.
    """

    def __init__(self, attracted: AttractedSurface, tolerance: float, depth: float):
        self.attracted, self.tolerance = attracted, tolerance
        self.stage = self._stage(depth, attracted.at_rest(depth, attracted.apart(depth), tolerance))
        self.most = abs(self.stage.rest.energy)
        self.work, self.lost, self.lacking = self.stage.rest.energy, 0.0, 0.0
        self.stages = [(self.stage.depth, self.stage.force)]

    def _stage(self, depth: float, rest: Rest) -> RestStage:
        return RestStage(depth, rest, float(np.sum(rest.traction)))

    def go(self, depth: float) -> tuple[Leapt, ...]:
        """Go on to a displacement, and return the jumps on the way.

        Raises
        ------
        NotConverged
            If no state of rest is found.
        """
        leaps: list[Leapt] = []
        self._go(depth, MOST_HALVINGS, leaps)
        return tuple(leaps)

    def _go(self, depth: float, halvings: int, leaps: list[Leapt]) -> None:
        old = self.stage
        deeper = depth - old.depth
        if deeper == 0.0:
            return
        start = self.attracted.moved(old.rest, deeper, depth)
        new = self._stage(depth, self.attracted.at_rest(depth, start, self.tolerance))
        work = 0.5 * (old.force + new.force) * deeper
        loss = work - (new.rest.energy - old.rest.energy)
        most = max(self.most, abs(new.rest.energy))
        strange = abs(loss) > max(JUMP_RATIO * max(abs(old.force), abs(new.force)) * abs(deeper), SMALLEST_RATIO * most)
        if strange and halvings:
            self._go(old.depth + 0.5 * deeper, halvings - 1, leaps)
            self._go(depth, halvings - 1, leaps)
            return
        self.stage, self.most, self.work = new, most, self.work + work
        self.stages.append((depth, new.force))
        if strange and loss > 0.0:
            leaps.append(Leapt(old, new, loss))
            self.lost += loss
        else:
            self.lacking += loss
