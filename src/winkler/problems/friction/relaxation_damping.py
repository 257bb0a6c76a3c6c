r"""Relaxation damping: a contact pressed in fast oscillation is a viscous damper to slow motion along the surface.

Nothing slides.  Springs that part lose what they hold and begin anew when they touch again: dragged along slowly, with
the speed v, each holds on the average :math:`c_T v\tau^2/(\pi\omega)` per length, where :math:`\tau` is half of the
part of the cycle, in radians, for which it touches:

.. math:: \frac{F_x}{v} = \frac{2}{\pi\omega}\int c_T(x)\,\tau^2\,\mathrm dx,\qquad \cos\tau = \frac{g(x)-d_0}{A_z},

over the springs that part.  Of small amplitudes that is :math:`(\mathrm dk_x/\mathrm dd)\,A_z(\pi^2-4)/(\pi\omega)`,
on a homogeneous half-space :math:`3.7367\,G^*A_z/(\omega g'(a))`.  Springs that never part are a spring beside it.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.integrals.bisected_quadrature import along_springs, towards
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.friction.damping_springs import oscillating_contact, stuck_stiffness
from winkler.problems.friction.damping_validity import damping_notes
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.values.checks.number_checks import Finite, Positive
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

TOLERANCE = 1e-12
"""Of the integrals over the springs."""
EDGE_HALVINGS = 30
"""How often the panels halve their distance from an edge."""
POPOV = "M. Popov, V. L. Popov, R. Pohrt, Sci. Rep. 5 (2015) 16189, doi:10.1038/srep16189"
STICKING = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "No slip is assumed, and little tangential motion during one period of the normal oscillation. The assumption "
    "requires a coefficient of friction much greater than v/(omega A_z) times G*/E*.",
    POPOV,
)


@value
class RelaxationDamper:
    """Slow tangential motion without slip of a contact whose depth oscillates fast.

    Parameters
    ----------
    bed : Bed
        The springs.
    depth : float
        Mean depth d_0 [m].
    depth_amplitude : float
        A_z [m], positive; beyond the mean depth the bodies separate in every cycle.
    frequency : float
        Frequency of the depth [Hz].

    Raises
    ------
    InvalidInput
        If one of them is no finite number, or amplitude or frequency are not positive.

    References
    ----------
    M. Popov, V. L. Popov, R. Pohrt, Sci. Rep. 5 (2015) 16189, doi:10.1038/srep16189

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.conical import Cone
    >>> bed = Foundation(Cone(half_angle=math.pi / 4), HalfSpace(Elastic(1.0, 0.0)))
    >>> damper = RelaxationDamper(bed, depth=0.1, depth_amplitude=0.05, frequency=0.5 / math.pi).solve()
    >>> round(damper.damping / (bed.medium.shear_modulus * 0.05 / (math.pi / 2)), 4)
    3.7367
    """

    bed: Bed
    depth: Finite
    depth_amplitude: Positive
    frequency: Positive

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "popov_popov_pohrt_2015")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = ""

    def solve(self) -> RelaxationDamperSolution:
        """Return the constants of the equivalent damper and of the spring in parallel with it.

        Returns
        -------
        RelaxationDamperSolution

        Raises
        ------
        OutsideValidity
            If the bodies never touch, or the profile ends before the maximum depth.
        NotConverged
            If the profile is too rough.
        """
        deepest, lowest = oscillating_contact("RelaxationDamper", self.bed, self.depth, self.depth_amplitude)
        radius = float(deepest.radius)
        kinks = [b for b, _ in self.bed.kinks]
        edges = np.unique(np.concatenate([[lowest], towards(radius, [lowest, *kinks], EDGE_HALVINGS)]))
        edges = np.unique(np.concatenate([edges, lowest + (radius - lowest) * 0.5 ** np.arange(1, EDGE_HALVINGS)]))

        def held(x: Array, _: Array) -> Array:
            touching = np.arccos(np.clip((self.bed.gap(x) - self.depth) / self.depth_amplitude, -1.0, 1.0))
            return np.asarray(self.bed.tangential_stiffness(x) * touching**2)

        tolerance = max(TOLERANCE, 16.0 * np.finfo(float).eps * abs(self.depth) / self.depth_amplitude)
        damping = 0.0
        if lowest < radius:
            whole = float(
                along_springs(held, edges[edges >= lowest], np.array([tolerance]), "damping of the springs")[0]
            )
            damping = whole / (math.pi**2 * self.frequency)
        stiffness = 0.0
        if lowest > 0.0:
            always = towards(lowest, kinks, EDGE_HALVINGS)
            stiffness = stuck_stiffness(self.bed, always, tolerance)
        return RelaxationDamperSolution(self, deepest, damping, stiffness)


@value
class RelaxationDamperSolution:
    """The solution of a `RelaxationDamper`.

    Parameters
    ----------
    problem : RelaxationDamper
        The problem that was solved.
    contact : IndentationSolution
        The contact at its maximum depth.
    damping : float
        Mean shear force over speed [N s/m].
    shear_stiffness : float
        Tangential stiffness of the springs that never separate [N/m].
    """

    problem: RelaxationDamper
    contact: IndentationSolution[float]
    damping: float
    shear_stiffness: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (
            *self.contact.notes_with(SurfaceFriction(math.inf)),  # nothing slips, whatever that takes
            STICKING,
            *damping_notes(self.problem.bed, float(self.contact.radius), math.inf),
        )
