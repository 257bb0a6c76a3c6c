r"""Friction of rough surfaces on an elastomer: a tool for trends.

Every wave q of the roughness shears the elastomer at the angular frequency v q.  While a line of springs touches only
here and there, it loses a part :math:`G''/|G|` of what the slopes require,

.. math:: \mu(v) \approx h'\,\frac{\int q^3 C(q)\,\frac{G''(qv)}{|G(qv)|}\,\mathrm dq}{\int q^3 C(q)\,\mathrm dq} ,

whatever the load.  Springs that slide step by step over random lines confirm it within 30 per cent while less than a
tenth of the line touches; where half of it does, it is right at and beyond the peak, and up to 4 times too high below.
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.numerics.types import Array
from winkler.profiles.rough.spectrum import Spectrum, wave_numbers_for
from winkler.values.checks.number_checks import POSITIVE, Numbers
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

WAVE_NUMBERS = 400
LI = "Q. Li et al., Phys. Rev. Lett. 111 (2013) 034301, doi:10.1103/PhysRevLett.111.034301"
DISPUTE = "I. A. Lyashenko, L. Pastewka, B. N. J. Persson, Phys. Rev. Lett. 111 (2013) 189401"


@value
class ElastomerFriction:
    """Friction of an elastomer on a rigid rough surface.

    Parameters
    ----------
    spectrum : Spectrum
        Spectrum of the rough surface.
    solid : ViscoelasticSolid
        The elastomer.
    velocity : array_like
        v [m/s], positive.

    Raises
    ------
    InvalidInput
        If the solid is not viscoelastic, or a velocity is not positive.

    References
    ----------
    Q. Li, M. Popov, A. Dimaki, A. E. Filippov, S. Kuerschner, V. L. Popov, Phys. Rev. Lett. 111 (2013) 034301,
    doi:10.1103/PhysRevLett.111.034301

    Examples
    --------
    >>> import numpy as np
    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> from winkler.profiles.rough.spectrum import SelfAffine
    >>> asphalt = SelfAffine(hurst=0.8, rms_height=1e-4, longest=1e-2, shortest=1e-5)
    >>> rubber = StandardSolid(1e6, 1e7, 1e-4)
    >>> ElastomerFriction(asphalt, rubber, np.array([1e-3, 0.1, 10.0])).solve().coefficient.round(2)
    array([0.09, 0.23, 0.03])
    """

    __words__ = words(solid=("", None, "the elastomer"), velocity=("v", "m/s", "velocity of sliding"))

    spectrum: Spectrum
    solid: ViscoelasticSolid
    velocity: Annotated[Array, Numbers(POSITIVE, any_shape=True)]

    references: ClassVar[tuple[str, ...]] = ("li_2013", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.ROUGHNESS,))

    def solve(self) -> ElastomerFrictionSolution:
        """Return the coefficient of friction at every velocity."""
        q = wave_numbers_for(self.spectrum, WAVE_NUMBERS)
        logs = np.log(q)
        weight = q**4 * self.spectrum.at(q)
        omega = np.ravel(self.velocity)[:, None] * q
        storage, loss = self.solid.storage(omega), self.solid.loss(omega)
        share = np.trapezoid(weight * loss / np.hypot(storage, loss), logs, axis=1) / np.trapezoid(weight, logs)
        return ElastomerFrictionSolution(self, (self.spectrum.rms_slope * share).reshape(np.shape(self.velocity)))


@value
class ElastomerFrictionSolution:
    """The solution of an `ElastomerFriction`.

    Parameters
    ----------
    problem : ElastomerFriction
        The problem that was solved.
    coefficient : ndarray
        mu [-], in the shape of the velocity.
    """

    __words__ = words(coefficient=(r"\mu", "", "coefficient of friction"), velocity=("v", "m/s", "velocity of sliding"))

    problem: ElastomerFriction
    coefficient: Array

    @property
    def velocity(self) -> Array:
        """The velocities [m/s]."""
        return self.problem.velocity

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: this is an estimate only."""
        return (
            Note(
                Assumption.ROUGHNESS,
                Standing.APPROXIMATE,
                "Only the trend with velocity and temperature is reliable. At light loads the springs agree "
                "within 30 per cent; at heavy loads their friction is up to 4 times lower at low velocities. "
                "Friction of independent springs is disputed. Heating, adhesion and wear are neglected.",
                f"{LI}; {DISPUTE}",
            ),
        )
