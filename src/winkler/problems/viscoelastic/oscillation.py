r"""A small oscillation of a viscoelastic contact: stiffness and damping.

An oscillation so small that the contact stays as wide as it is meets :math:`2aE^*(\mathrm i\omega)`, on layers that
relax each by a law of its own the stiffness of a flat punch with their complex moduli.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Force
from winkler.loading.path import OnePositiveNormal
from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.assumptions.times import times_notes
from winkler.problems.normal.indentation import Indentation
from winkler.problems.viscoelastic.layered_path import complex_stiffness, is_layered
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.problems.viscoelastic.validity import relaxing_notes
from winkler.values.checks.number_checks import POSITIVE_QUANTITY
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class HarmonicIndentation(PerLoad[Q]):
    """A small normal oscillation about a relaxed indentation.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) with a ViscoelasticHalfSpace or a ViscoelasticCoatedHalfSpace.
    normal : Depth or Force
        The steady load about which it oscillates, one number; a Force requires a solid that is not a liquid at long
        times.
    angular_frequency : float or ndarray
        omega [rad/s], positive; the results have its shape.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic, a steady force acts on a liquid, or a number is out of range.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import KelvinVoigt
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(KelvinVoigt(shear=0.25, viscosity=0.5)))
    >>> shaken = HarmonicIndentation(bed, Depth(0.25), 3.0).solve()
    >>> shaken.storage_stiffness, shaken.loss_stiffness  # 2 a E*, 2 a omega eta*
    (1.0, 6.0)
    """

    bed: Bed
    normal: OnePositiveNormal
    angular_frequency: Annotated[Q, POSITIVE_QUANTITY]

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "lee_radok_1960")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if is_layered("HarmonicIndentation", self.bed):
            return
        series = relaxation_of("HarmonicIndentation", self.bed)
        if isinstance(self.normal, Force) and series.relaxed == 0.0:
            raise InvalidInput(
                "HarmonicIndentation: the body creeps without limit and never rests under a force; give a Depth."
            )

    def solve(self) -> HarmonicSolution[Q]:
        """Return storage and loss stiffness.

        Returns
        -------
        HarmonicSolution

        Raises
        ------
        OutsideValidity
            If the load is beyond the known range of the profile.
        """
        frequency = np.asarray(self.angular_frequency, dtype=float)
        if is_layered("HarmonicIndentation", self.bed):
            rest = Indentation(elastic_like(self.bed), self.normal).solve()
            rested = float(rest.depth), float(rest.force), float(rest.radius)
            found = complex_stiffness(self.bed, rested[2], frequency)
            return HarmonicSolution(self, *rested, shaped(np.real(found)), shaped(np.imag(found)))
        series, elastic = relaxation_of("", self.bed), elastic_like(self.bed)
        load = self.normal if isinstance(self.normal, Depth) else Force(float(self.normal.force) / series.relaxed)
        contact = Indentation(elastic, load).solve()
        stiffness = float(contact.stiffness) * series.dynamic(frequency)
        steady = float(contact.depth), series.relaxed * float(contact.force), float(contact.radius)
        return HarmonicSolution(self, *steady, shaped(np.real(stiffness)), shaped(np.imag(stiffness)))


@value
class HarmonicSolution(PerLoad[Q]):
    """The solution of a `HarmonicIndentation`.

    Parameters
    ----------
    problem : HarmonicIndentation
        The problem that was solved.
    depth, radius : float
        d and a [m] of the steady contact.
    force : float
        F_N [N] of the steady contact, relaxed.
    storage_stiffness, loss_stiffness : float or ndarray
        Amplitudes of the force in phase with the motion and a quarter of a turn ahead, over that of the motion [N/m].
    """

    __words__ = words(loss_stiffness=("k''", "N/m", "force a quarter turn ahead of a motion, over the motion"))

    problem: HarmonicIndentation[Q]
    depth: float
    force: float
    radius: float
    storage_stiffness: Q
    loss_stiffness: Q

    @property
    def angular_frequency(self) -> Q:
        """Omega [rad/s], as prescribed."""
        return self.problem.angular_frequency

    @property
    def loss_tangent(self) -> Q:
        """tan delta [-], loss over storage stiffness."""
        return shaped(np.asarray(self.loss_stiffness) / self.storage_stiffness)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed, frequency = self.problem.bed, np.asarray(self.problem.angular_frequency)
        small = Note(
            Assumption.RESPONSE,
            Standing.ASYMPTOTIC,
            "The amplitude is assumed small compared with the depth. The contact radius then stays constant, and "
            "no spring separates.",
            "linearisation about the relaxed contact",
        )
        times = times_notes(bed.medium, float(1.0 / np.max(frequency)), float(1.0 / np.min(frequency)))
        # of layers that relax each by a law of its own, the notes are those of the relaxed stack, on which it rests
        return relaxing_notes(bed, np.array([self.depth]), np.array([self.radius]), (*times, small))
