"""Springs pushed sideways to and fro under a steady depth: their force, loss and reach, whether they stick or slip."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Force
from winkler.numerics.equations.bracketing import between
from winkler.numerics.integrals.bisected_quadrature import along_springs, towards
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

TOLERANCE = 1e-13
"""Of each integral over the springs."""
EDGE_HALVINGS = 30
"""How often the panels halve their distance from the edge of the contact, where sliding begins."""
SAMPLES = 257
"""Places along springs of different kinds at which their bounds are compared."""


@value
class SlippingSprings:
    """The springs of one pressed contact, pushed to and fro."""

    coefficient: float
    contact: IndentationSolution

    @property
    def bed(self) -> Bed:
        """Profile and medium."""
        return self.contact.problem.bed

    @property
    def depth(self) -> float:
        """d [m]."""
        return float(self.contact.depth)

    @property
    def radius(self) -> float:
        """a [m]."""
        return float(self.contact.radius)

    @property
    def _edges(self) -> Array:
        return towards(self.radius, [b for b, _ in self.bed.kinks], EDGE_HALVINGS)

    def _springs(self, x: Array) -> tuple[Array, Array]:
        """Return c_T [Pa] and the bounds b [m] of springs in contact."""
        stiffness = self.bed.tangential_stiffness(x)
        pressed = np.maximum(self.depth - self.bed.gap(x), 0.0)
        return stiffness, self.coefficient * self.bed.normal_stiffness(x) / stiffness * pressed

    @property
    def stiffness(self) -> float:
        """Stiffness without slip [N/m]."""
        return stuck_stiffness(self.bed, self._edges, TOLERANCE)

    @property
    def reach(self) -> float:
        """The shift from which every spring slides [m]."""
        least, greatest = stiffness_ratios(self.bed, self.radius)
        if alike((least, greatest)):
            return self.coefficient * self.depth / least
        x = self.radius * np.linspace(0.0, 1.0, SAMPLES)[1:]
        return float(np.max(self._springs(x)[1]))

    def _tolerance(self, moved: Array) -> Array:
        # only springs with b < U count: their d - g, and their places, are small differences when U is small
        lost = 16.0 * np.finfo(float).eps * self.reach / np.where(moved > 0.0, moved, self.reach)
        return np.maximum(TOLERANCE, lost)

    def loss(self, moved: Array) -> Array:
        """Return the loss per cycle [J] at amplitudes of the shift [m], both ``(m,)``."""

        def density(x: Array, index: Array) -> Array:
            stiffness, bound = self._springs(x)
            return np.asarray(8.0 * stiffness * bound * np.maximum(moved[index] - bound, 0.0))

        return along_springs(density, self._edges, self._tolerance(moved), "loss of the springs")

    def force(self, moved: Array) -> Array:
        """Return the amplitude of the shear force [N] at amplitudes of the shift [m], both ``(m,)``."""

        def density(x: Array, index: Array) -> Array:
            stiffness, bound = self._springs(x)
            return np.asarray(2.0 * stiffness * np.minimum(bound, moved[index]))

        return along_springs(density, self._edges, np.full(moved.shape, TOLERANCE), "shear force of the springs")

    def shift(self, targets: Array) -> Array:
        """Return amplitudes of the shift [m] at amplitudes of the shear force [N], both ``(m,)``.

        The least one, where the force is that of sliding throughout.
        """
        least, greatest = stiffness_ratios(self.bed, self.radius)
        if alike((least, greatest)):
            # Ciavarella, Jaeger: the shear force is mu times what the normal force falls by as far as the stick edge
            core = np.maximum(float(self.contact.force) - targets / self.coefficient, 0.0)
            stick = np.asarray(Indentation(self.bed, Force(core)).solve().depth)
            return np.asarray(self.coefficient * (self.depth - stick) / least)
        reach = np.full(targets.shape, self.reach)
        short = self.force(reach) <= targets
        root = between(lambda moved, index: self.force(moved) - targets[index], np.zeros(targets.shape), reach)
        return np.where(short, reach, root)


def stuck_stiffness(bed: Bed, edges: Array, tolerance: float) -> float:
    """Return the tangential stiffness of springs that all stick [N/m], by panels with these edges [m]."""
    total = along_springs(
        lambda x, _: bed.tangential_stiffness(x), edges, np.array([tolerance]), "tangential stiffness of the contact"
    )
    return 2.0 * float(total[0])


def oscillating_contact(
    owner: str, bed: Bed, depth: float, amplitude: float
) -> tuple[IndentationSolution[float], float]:
    """Return the contact at its greatest depth, and its radius at the least one [m]; refuse bodies that never touch."""
    deepest = Indentation(bed, Depth(depth + amplitude)).solve()
    if float(deepest.radius) == 0.0:
        raise OutsideValidity(
            f"{owner}: a depth of {depth:.6g} m with an amplitude of {amplitude:.6g} m never brings the bodies into "
            "touch; press them together."
        )
    return deepest, float(Indentation(bed, Depth(depth - amplitude)).solve().radius)
